"""What weights on a shaft take away, exactly: their closed forms, and the proof that nothing is left.

A shaft of speed ratio n carries unbalances u_j in planes p_j (in bore pitches from the reference plane). They push with
n^2 u_j on the vector of order |n| that turns as the shaft does. With F and M the exact force and couple of that vector,

    u_j = -(alpha + beta p_j)/n^2,    sum (alpha + beta p_j) = F,    sum p_j (alpha + beta p_j) = M,

is the least of all sets of weights with n^2 sum u_j = -F and n^2 sum p_j u_j = -M; its coefficients are rational where the
places are. What is left, F + n^2 sum u_j and M + n^2 sum p_j u_j, is added up again from these u_j and reduced in the
field: it is zero or it is not.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from math import isfinite

from crankstar.balance import default_reference
from crankstar.derive import cyclotomic, meant, positions, wave
from crankstar.derive.formula import NOUGHT, Formula, Polar, Symbol, product
from crankstar.derive.records import Chapter, Derivation, DerivationError, Line, Step, nth, unit_symbol
from crankstar.derive.steps import derivation
from crankstar.derive.wave import Amount, joined
from crankstar.engine import Engine


@dataclass(frozen=True)
class Cure:
    """The exact unbalances in the planes, in m r of the first cylinder (times A_k, k = `harmonic`, unless that is None or 1).

    `force` and `couple` are what is left of the vector: `proved` tells that both are exact zeros.
    """

    ratio: Fraction
    planes: tuple[Fraction, ...]
    unbalance: tuple[Amount, ...]
    harmonic: int | None
    scale: float
    force: Amount
    couple: Amount
    proved: bool
    chapter: Chapter


def cure(engine: Engine, *, ratio: Fraction | int, planes: Sequence[float]) -> Cure:
    """The exact weights on a shaft of speed `ratio` (1: the crankshaft itself) in `planes` (z as in the engine), and the proof.

    `engine` is without them. Raises DerivationError, also where the force and couple cannot be taken away in these planes.

    >>> from crankstar.catalog import load
    >>> from crankstar.derive.typeset import text
    >>> ends = cure(load("v8-cross-plane"), ratio=1, planes=[1.75, -1.75])
    >>> ends.proved, text(wave.length(ends.unbalance[0]).formula)
    (True, '2√10/7')
    """
    try:
        ratio = Fraction(ratio)
    except (ValueError, OverflowError, ZeroDivisionError, TypeError):
        raise DerivationError(f"{ratio} is no speed ratio; give a whole number or a fraction, negative against the crank") from None
    if not all(isfinite(plane) for plane in planes):
        raise DerivationError("a plane has no place along the shaft; give each as a finite number")
    found = [derivation(engine, abs(ratio), quantity) for quantity in ("force", "couple")]
    with cyclotomic.precision(cyclotomic.DIGITS):
        placed = positions.arms(engine)
        values = placed.values
        middle = default_reference(engine).z
        places = tuple(_short((plane - middle) / engine.pitch) for plane in planes)
        vectors = [wave.at(one.forward if ratio > 0 else one.backward, values) for one in found]
        force, couple = vectors
        if force is None or couple is None:
            raise DerivationError("the weights have no closed form: the pistons have different harmonics")
        if force.zero and couple.zero:
            raise DerivationError(f"there is nothing of order {abs(ratio)} for a shaft of speed ratio {ratio} to take away")
        weights = _least(force, couple, places, ratio)
        pushed = [(weight.times(ratio**2), place) for weight, place in zip(weights, places, strict=True)]
        left_force = _sum([force, *(push for push, _ in pushed)])
        left_couple = _sum([couple, *(push.times(place) for push, place in pushed)])
        exact = not any(one.why for one in found)
        proved = exact and left_force.zero and left_couple.zero
        harmonic, scale = found[0].harmonic, found[0].scale
        steps = _steps(found, ratio, places, (force, couple), weights, proved=proved)
    title = f"What takes away the {nth(abs(ratio), 'vector')} that turns {'with' if ratio > 0 else 'against'} the crank"
    chapter = Chapter(
        engine.name, title, harmonic, found[1].symbols, steps, {key: text for one in found for key, text in one.meanings.items()}
    )
    return Cure(ratio, places, tuple(weights), harmonic, scale, left_force, left_couple, proved, chapter)


def _short(pitches: float) -> Fraction:
    """A place as the multiple of the bore pitch that it was meant to be."""
    near = Fraction(pitches).limit_denominator(positions.GREATEST_STEP)
    return near if abs(float(near) - pitches) < positions.SAME_PLACE / 100 else meant.ratio(pitches)


def _least(force: Amount, couple: Amount, places: Sequence[Fraction], ratio: Fraction) -> list[Amount]:
    """The least unbalances of the two conditions, by their rational normal equations."""
    count, first, second = Fraction(len(places)), sum(places, Fraction(0)), sum((p * p for p in places), Fraction(0))
    determinant = count * second - first * first
    if determinant == 0:
        if not places or not _sum([couple, force.times(-places[0])]).zero:
            raise DerivationError("one plane takes away only a force that acts in it; give two planes or more, all different")
        return [force.times(Fraction(-1, len(places)) / ratio**2) for _ in places]
    alpha = _sum([force.times(second / determinant), couple.times(-first / determinant)])
    beta = _sum([force.times(-first / determinant), couple.times(count / determinant)])
    return [_sum([alpha, beta.times(place)]).times(Fraction(-1) / ratio**2) for place in places]


def _sum(amounts: Sequence[Amount]) -> Amount:
    """The sum of numbers, an exact zero where it is one."""
    return next(iter(joined({(): amount} for amount in amounts).values()), cyclotomic.ZERO)


def _steps(
    found: Sequence[Derivation],
    ratio: Fraction,
    places: Sequence[Fraction],
    vectors: tuple[Amount, Amount],
    weights: Sequence[Amount],
    *,
    proved: bool,
) -> tuple[Step, ...]:
    sign = "+" if ratio > 0 else "−"
    counted = unit_symbol(found[0].harmonic)
    pitch = Symbol("a")
    there = [
        Line(Symbol("F", sign), (_vector(vectors[0], counted),), label="force"),
        Line(Symbol("M", sign), (_vector(vectors[1], counted, pitch),), label="couple about the middle of the cylinders"),
    ]
    what = "The vectors are those of the derivation of this order; lengths along the crankshaft have the values of the engine file."
    unbalance = product(Symbol("m"), Symbol("r"), *([Symbol("A", str(k))] if (k := found[0].harmonic) not in (None, 1) else []))
    lines = [
        Line(Symbol("u", str(number)), (_vector(weight, unbalance),), label=f"in the plane {_place(place)}")
        for number, (weight, place) in enumerate(zip(weights, places, strict=True), 1)
    ]
    speed = "as fast as the crankshaft" if abs(ratio) == 1 else f"{abs(ratio)} times as fast as the crankshaft"
    push = "u ω²" if abs(ratio) == 1 else f"{ratio**2} u ω²"
    shaft = "the crankshaft itself" if ratio == 1 else f"a shaft that turns {'with' if ratio > 0 else 'against'} it, {speed}"
    words = f"Weights on {shaft} push with {push}. Their sum must be −F, the sum of their moments −M; of all that do it, these "
    words += "are the least. A vector is an unbalance ∠ its bearing at θ = 0."
    verdict = "Added up again from these closed forms, force and couple are exactly zero: the residual is proved to vanish."
    if not proved:
        why = next((one.why for one in found if one.why), "") or "some numbers are decimals"
        verdict = f"Added up again, force and couple cannot be told from zero to {cyclotomic.DIGITS - 5} digits: {why}."
    residual = (
        Line(None, (Symbol("F", f"{sign}, left"), NOUGHT), label="force"),
        Line(None, (Symbol("M", f"{sign}, left"), NOUGHT), label="couple"),
    )
    return (
        Step("What turns", (what,), tuple(there)),
        Step("The weights", (words,), tuple(lines)),
        Step("What is left", (verdict,), residual if proved else ()),
    )


def _place(place: Fraction) -> str:
    return f"z = {float(place):.6g} a".replace("-", "−")


def _vector(amount: Amount, *units: Formula) -> Formula:
    if amount.zero:
        return NOUGHT
    found = wave.vector({(): amount})
    return Polar(product(*units, found.length), found.angle) if isinstance(found, Polar) else product(*units, found)
