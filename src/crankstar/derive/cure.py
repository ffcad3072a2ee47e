"""Weights on a shaft in closed form, and the proof that they leave nothing.

A shaft of speed ratio n carries unbalances u_j in planes p_j (in bore pitches from the reference
plane). They push with n^2 u_j on the vector of order |n| that turns as the shaft does. With F and M
the exact force and couple of that vector,

    u_j = -(alpha + beta p_j)/n^2,    sum (alpha + beta p_j) = F,    sum p_j (alpha + beta p_j) = M,

is the least of all sets of weights with n^2 sum u_j = -F and n^2 sum p_j u_j = -M; its coefficients
are rational where the places are. What is left, F + n^2 sum u_j and M + n^2 sum p_j u_j, is added
up again from these u_j and reduced in the field: it is zero or it is not.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from math import isfinite

from crankstar.derive import positions
from crankstar.derive.algebra import cyclotomic, wave
from crankstar.derive.algebra.formula import NOUGHT, Formula, Symbol, product
from crankstar.derive.algebra.wave import Amount
from crankstar.derive.chapters import Chapter, Derivation
from crankstar.derive.records import DerivationError, Line, Step, unit_symbol
from crankstar.derive.steps import derivation
from crankstar.engine.copies import with_values, with_weights
from crankstar.engine.engine import Engine
from crankstar.language.messages import _
from crankstar.mechanics.balance import default_reference
from crankstar.remedy import changes, needs


@dataclass(frozen=True)
class Cure:
    """The exact unbalances in the planes, in m r of the first cylinder.

    They are times A_k, k = `harmonic`, unless that is None or 1. `force` and `couple` are the
    remaining vector; it is `proved` that both are exact zeros.
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
    """The exact weights on a shaft of speed `ratio` (1: the crankshaft itself), and the proof.

    They stand in `planes` (z as in the engine); `engine` is without them. Raises DerivationError,
    also where force and couple cannot be balanced in these planes.

    >>> from crankstar.files.catalog import load
    >>> from crankstar.derive.algebra.typeset import text
    >>> ends = cure(load("v8-cross-plane"), ratio=1, planes=[1.75, -1.75])
    >>> ends.proved, text(wave.length(ends.unbalance[0]))
    (True, '2√10/7')
    """
    try:
        ratio = Fraction(ratio)
    except (ValueError, OverflowError, ZeroDivisionError, TypeError):
        raise DerivationError(
            _(
                "The speed ratio is {ratio}; give a whole number or a fraction, negative for a "
                "shaft that turns against the crank.",
                ratio=repr(ratio),
            )
        ) from None
    if not all(isfinite(plane) for plane in planes):
        raise DerivationError(
            _("The position of a plane is not finite; give its position along the shaft.")
        )
    derived = [derivation(engine, abs(ratio), quantity) for quantity in ("force", "couple")]
    with cyclotomic.precision(cyclotomic.DIGITS):
        placed = positions.arms(engine)
        values = placed.values
        middle = default_reference(engine).z
        places = tuple(positions.in_pitches((plane - middle) / engine.pitch) for plane in planes)
        vectors = [wave.at(own.forward if ratio > 0 else own.backward, values) for own in derived]
        force, couple = vectors
        if force is None or couple is None:
            raise DerivationError(
                _("The weights have no closed form: the pistons have different harmonics.")
            )
        if force.zero and couple.zero:
            raise DerivationError(
                _(
                    "No force or couple of order {order} turns with a shaft of speed ratio "
                    "{ratio}.",
                    order=abs(ratio),
                    ratio=ratio,
                )
            )
        weights = _least(force, couple, places, ratio)
        pushed = [
            (weight.times(ratio**2), place) for weight, place in zip(weights, places, strict=True)
        ]
        left_force = wave.amount_sum([force, *(push for push, _ in pushed)])
        left_couple = wave.amount_sum([couple, *(push.times(place) for push, place in pushed)])
        exact = not any(own.why for own in derived)
        proved = exact and left_force.zero and left_couple.zero
        harmonic, scale = derived[0].harmonic, derived[0].scale
        steps = _steps(derived, ratio, places, (force, couple), weights, proved=proved)
    if ratio > 0:
        title = _("Weights for the vector of order {order} that turns with the crank", order=ratio)
    else:
        title = _(
            "Weights for the vector of order {order} that turns against the crank", order=-ratio
        )
    meanings = {key: words for own in derived for key, words in own.meanings.items()}
    chapter = Chapter(engine.name, title, harmonic, derived[1].symbols, steps, meanings)
    return Cure(
        ratio, places, tuple(weights), harmonic, scale, left_force, left_couple, proved, chapter
    )


def _least(
    force: Amount, couple: Amount, places: Sequence[Fraction], ratio: Fraction
) -> list[Amount]:
    """The least unbalances of the two conditions, by their rational normal equations."""
    count, first = Fraction(len(places)), sum(places, Fraction(0))
    second = sum((place**2 for place in places), Fraction(0))
    determinant = count * second - first * first
    if determinant == 0:
        if not places or not wave.amount_sum([couple, force.times(-places[0])]).zero:
            raise DerivationError(
                _(
                    "One plane balances only a force that acts in it; give two planes or more, all "
                    "different."
                )
            )
        return [force.times(Fraction(-1, len(places)) / ratio**2) for _ in places]
    alpha = wave.amount_sum([force.times(second / determinant), couple.times(-first / determinant)])
    beta = wave.amount_sum([force.times(-first / determinant), couple.times(count / determinant)])
    return [
        wave.amount_sum([alpha, beta.times(place)]).times(Fraction(-1) / ratio**2)
        for place in places
    ]


def _steps(
    derived: Sequence[Derivation],
    ratio: Fraction,
    places: Sequence[Fraction],
    vectors: tuple[Amount, Amount],
    weights: Sequence[Amount],
    *,
    proved: bool,
) -> tuple[Step, ...]:
    sign = "+" if ratio > 0 else "−"
    harmonic = derived[0].harmonic
    counted, unbalance = unit_symbol(harmonic), product(Symbol("m"), Symbol("r"))
    if harmonic not in (None, 1):
        unbalance = product(unbalance, Symbol("A", str(harmonic)))
    couple = _vector(vectors[1], counted, Symbol("a"))
    there = (
        Line(Symbol("F", sign), (_vector(vectors[0], counted),), label=_("force")),
        Line(Symbol("M", sign), (couple,), label=_("couple about the middle of the cylinders")),
    )
    first = _(
        "The vectors are those of the derivation of this order; lengths along the crankshaft have "
        "the values of the engine file."
    )
    lines = tuple(
        Line(
            Symbol("u", str(number)),
            (_vector(weight, unbalance),),
            label=_("in the plane {place}", place=_place(place)),
        )
        for number, (weight, place) in enumerate(zip(weights, places, strict=True), 1)
    )
    residual = (
        Line(None, (Symbol("F", f"{sign}, left"), NOUGHT), label=_("force")),
        Line(None, (Symbol("M", f"{sign}, left"), NOUGHT), label=_("couple")),
    )
    return (
        Step(_("The rotating vectors"), (first,), there),
        Step(_("The weights"), _about_weights(ratio), lines),
        Step(
            _("The remaining unbalance"),
            (_verdict(derived, proved=proved),),
            residual if proved else (),
        ),
    )


def _about_weights(ratio: Fraction) -> tuple[str, ...]:
    """How the weights push, and what they must do."""
    push = "u ω²" if abs(ratio) == 1 else f"{ratio**2} u ω²"
    if ratio == 1:
        shaft = _("Weights on the crankshaft exert the force {push}.", push=push)
    elif ratio > 0:
        shaft = _(
            "Weights on a shaft that turns with the crank, at {speed} times crank speed, exert "
            "the force {push}.",
            speed=ratio,
            push=push,
        )
    elif ratio == -1:
        shaft = _(
            "Weights on a shaft that turns against the crank, at crank speed, exert the force "
            "{push}.",
            push=push,
        )
    else:
        shaft = _(
            "Weights on a shaft that turns against the crank, at {speed} times crank speed, "
            "exert the force {push}.",
            speed=-ratio,
            push=push,
        )
    least = _(
        "Their sum must be −F and the sum of their moments −M; of all weights that fulfil this, "
        "these are the smallest."
    )
    return shaft, least, _("Vectors: unbalance ∠ bearing at θ = 0.")


def _verdict(derived: Sequence[Derivation], *, proved: bool) -> str:
    """What the weights leave."""
    if proved:
        return _(
            "The force and the couple computed again from these closed forms are exactly zero: "
            "the residual is proved to vanish."
        )
    reason = next((own.why for own in derived if own.why), "") or _("Some numbers are decimals.")
    return _(
        "The force and the couple computed again cannot be distinguished from zero to {digits} "
        "digits. {reason}",
        digits=cyclotomic.DIGITS - 5,
        reason=reason,
    )


def _place(place: Fraction) -> str:
    return f"z = {float(place):.6g} a".replace("-", "−")


def _vector(amount: Amount, *units: Formula) -> Formula:
    return NOUGHT if amount.zero else wave.counted(wave.vector({(): amount}), *units)


def proofs(before: Engine, after: Engine) -> list[Chapter]:
    """The exact new weights in the planes of the crankshaft and of each balance shaft of `after`.

    They are the least that balance all of their vector, as those of half the reciprocating mass do,
    and are proved to leave nothing; weights of the crankshafts that leave some of it are left out.
    Weights of the file that were kept count as they are. Raises DerivationError.
    """
    crank, count = after.shafts[0], len(before.shafts)
    became = changes(before, after)
    added = became[crank.name].added
    bare = with_weights(
        with_values(after, shafts=after.shafts[:count]),
        {shaft.name: became[shaft.name].kept for shaft in before.shafts},
    )
    chapters: list[Chapter] = []
    if added and _turning_with_crank(bare) and not _turning_with_crank(after):
        planes = sorted({weight.z for weight in added}, reverse=True)
        chapters.append(cure(bare, ratio=1, planes=planes).chapter)
    for number, shaft in enumerate(after.shafts[count:], count):
        # Only what turns as this shaft does adds to its vector; weights that do not would only
        # bring their decimals.
        alike = tuple(
            other for other in after.shafts[count:number] if other.speed_ratio == shaft.speed_ratio
        )
        base = after if shaft.speed_ratio == 1 else bare
        without = with_values(base, shafts=(*base.shafts[:count], *alike))
        planes = [weight.z for weight in shaft.weights]
        chapters.append(cure(without, ratio=shaft.speed_ratio, planes=planes).chapter)
    return chapters


def _turning_with_crank(engine: Engine) -> bool:
    """Whether a primary force or couple turns with the crankshaft."""
    return any(need.ratio == 1 for need in needs(engine, highest=1))
