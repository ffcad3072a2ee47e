"""Cosines of one direction added as by hand.

Equal phases together, opposite ones against each other; the rest is a closed polygon or a
resultant. Everything is exact; nothing is compared with a tolerance.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from fractions import Fraction
from typing import NamedTuple, TypeVar

from crankstar.derive.algebra import cyclotomic, wave
from crankstar.derive.algebra.formula import (
    Applied,
    Formula,
    angle,
    cosine,
    negative,
    product,
    summed,
)
from crankstar.derive.algebra.wave import Form, Wave, form_sum, joined
from crankstar.language.faults import listed
from crankstar.language.messages import _, _n

HALF = Fraction(1, 2)
P = TypeVar("P")


class Term(NamedTuple):
    """A cosine `weight cos(k theta + phase)` of one cylinder; the phase in turns."""

    cylinder: int
    weight: Form
    phase: Fraction


class Group(NamedTuple):
    """Terms of equal (+1) or opposite (-1) phase, and what they add up to."""

    phase: Fraction
    members: list[tuple[int, Term]]
    weight: Form

    @property
    def cylinders(self) -> list[int]:
        """The numbers of the cylinders."""
        return [term.cylinder for _sign, term in self.members]


class Addition(NamedTuple):
    """A sum as a chain of equal formulas, with notes on its steps, and its amplitude."""

    chain: tuple[Formula, ...]
    notes: tuple[str, ...]
    wave: Wave


def addition(
    terms: list[Term], order: Fraction, *, moments: bool, function: str = "cos"
) -> Addition:
    """The sum of cosines (or sines), of forces or of moments, step by step to its closed form."""
    notes: list[str] = []
    idle = [term.cylinder for term in terms if not term.weight]
    if idle:
        notes.append(
            _n(
                "Cylinder {numbers} stands in the reference plane.",
                "Cylinders {numbers} stand in the reference plane.",
                len(idle),
                numbers=listed(idle),
            )
        )
    terms = [term for term in terms if term.weight]
    raw = summed_up([(wave.form(term.weight), term.phase) for term in terms], order, function)
    groups = _groups(terms)
    notes += [_cancelled(group.members, moments=moments) for group in groups if not group.weight]
    left = [group for group in groups if group.weight]
    notes += _together([group for group in left if len(group.members) > 1], moments=moments)
    chain = [raw]
    sizes = [(wave.form(group.weight), group.phase) for group in left]
    if len(left) < len(terms) and left:
        chain.append(summed_up(sizes, order, function))
    whole = joined(wave.scaled({(): cyclotomic.root(group.phase)}, group.weight) for group in left)
    if not whole and left:
        notes.append(_closed_polygon(left))
    elif len(left) == 2:
        chain += _as_product(sizes, order, function)
    elif len(left) > 2:
        notes.append(_("The other terms are added as vectors, each with its length and phase."))
    if function == "sin":
        whole = wave.multiplied(whole, cyclotomic.root(Fraction(-1, 4)))
    return Addition(distinct([*chain, wave.signal(whole, order)]), tuple(notes), whole)


def summed_up(
    parts: list[tuple[Formula, Fraction]], order: Fraction, function: str = "cos"
) -> Formula:
    """A sum of cosines or sines with formulas before them."""
    return summed(
        *(
            product(size, Applied(function, wave.phased(order, angle(lag(phase)))))
            for size, phase in parts
        )
    )


def lag(phase: Fraction) -> Fraction:
    """The same phase from -1/2 up to 1/2: half a turn is written as a lag, -pi."""
    return (phase + HALF) % 1 - HALF


def _groups(terms: list[Term]) -> list[Group]:
    """Terms whose phases are equal or opposite, by the phase of the first of them."""
    members: dict[Fraction, list[tuple[int, Term]]] = {}
    first: dict[Fraction, Fraction] = {}
    for term in terms:
        phase = term.phase % 1
        key = first.setdefault(phase % HALF, phase)
        members.setdefault(key, []).append((1 if phase == key else -1, term))
    return [
        Group(phase, own, form_sum((Fraction(sign), term.weight) for sign, term in own))
        for phase, own in members.items()
    ]


def _together(groups: list[Group], *, moments: bool) -> list[str]:
    """Which cylinders are in phase, and which in phase or opposite."""
    in_phase = [
        group for group in groups if not moments and len({sign for sign, _ in group.members}) == 1
    ]
    opposed = [group for group in groups if group not in in_phase]
    notes: list[str] = []
    if in_phase:
        notes.append(
            _n(
                "Cylinders {groups} are in phase and push together.",
                "The cylinders of each group are in phase and push together: {groups}.",
                len(in_phase),
                groups=_listed(in_phase),
            )
        )
    if opposed:
        notes.append(
            _n(
                "Cylinders {groups} are in phase or opposite, so their terms combine into one.",
                "The cylinders of each group are in phase or opposite, so their terms combine into "
                "one: {groups}.",
                len(opposed),
                groups=_listed(opposed),
            )
        )
    return notes


def _listed(groups: Iterable[Group]) -> str:
    return "; ".join(", ".join(map(str, group.cylinders)) for group in groups)


def _cancelled(members: list[tuple[int, Term]], *, moments: bool) -> str:
    """That cylinders cancel, in pairs where they do."""
    pairs = opposite_pairs(
        [(str(term.cylinder), form_sum([(Fraction(sign), term.weight)])) for sign, term in members],
        lambda first, second: not form_sum([(Fraction(1), first), (Fraction(1), second)]),
    )
    if 2 * len(pairs) < len(members):
        numbers = listed([term.cylinder for _, term in members])
        return _("Cylinders {numbers} cancel each other.", numbers=numbers)
    if moments:
        return _n(
            "Cylinders {pairs} cancel: their moments are equal and opposite at every crank angle.",
            "Cylinders cancel in pairs, their moments equal and opposite at every crank angle: "
            "{pairs}.",
            len(pairs),
            pairs="; ".join(pairs),
        )
    return _n(
        "Cylinders {pairs} cancel: their forces are equal and opposite at every crank angle.",
        "Cylinders cancel in pairs, their forces equal and opposite at every crank angle: {pairs}.",
        len(pairs),
        pairs="; ".join(pairs),
    )


def opposite_pairs(parts: Iterable[tuple[str, P]], cancel: Callable[[P, P], bool]) -> list[str]:
    """The names of parts that cancel in pairs."""
    rest, pairs = list(parts), []
    while rest:
        name, own = rest.pop(0)
        place = next((i for i, (_far, far) in enumerate(rest) if cancel(own, far)), None)
        if place is not None:
            pairs.append(f"{name}, {rest.pop(place)[0]}")
    return pairs


def _closed_polygon(left: list[Group]) -> str:
    count = len(left)
    numbers = listed(sorted(number for group in left for number in group.cylinders))
    signs = [1 if next(iter(group.weight.values())) > 0 else -1 for group in left]
    pairs = list(zip(signs, left, strict=True))
    weights = [form_sum([(Fraction(sign), group.weight)]) for sign, group in pairs]
    phases = [group.phase + (HALF if sign < 0 else 0) for sign, group in pairs]
    apart = sorted((phase - phases[0]) % 1 for phase in phases)
    if all(weight == weights[0] for weight in weights) and apart == [
        Fraction(i, count) for i in range(count)
    ]:
        return _(
            "The vectors of cylinders {numbers} are equally long and {angle} apart: they close a "
            "polygon, and their sum is exactly 0.",
            numbers=numbers,
            angle=f"{360 / count:.6g}°",
        )
    return _(
        "The vectors of cylinders {numbers} close a polygon: their sum is exactly 0.",
        numbers=numbers,
    )


def _as_product(
    parts: list[tuple[Formula, Fraction]], order: Fraction, function: str
) -> list[Formula]:
    """Cos x + cos y = 2 cos((x - y)/2) cos((x + y)/2), for two of the same size; sines alike."""
    (first, p), (second, q) = parts
    if first == negative(second):
        second, q = first, q + HALF
    return [sum_as_product(first, p, q, order, function)] if first == second else []


def sum_as_product(
    size: Formula, p: Fraction, q: Fraction, order: Fraction, function: str = "cos"
) -> Formula:
    """Size cos(k theta + p) + size cos(k theta + q) as a product, or the same of sines."""
    p, q = lag(p), lag(q)
    middle = Applied(function, wave.phased(order, angle((p + q) / 2)))
    return product(2, size, cosine(angle(abs(p - q) / 2)), middle)


def distinct(chain: Iterable[Formula]) -> tuple[Formula, ...]:
    """A chain of equal formulas in which none stands right after itself."""
    out: list[Formula] = []
    for formula in chain:
        if not out or formula != out[-1]:
            out.append(formula)
    return tuple(out)
