"""Cosines of one direction added up as one does it by hand: like phases together, opposite ones against each other.

What is left is a closed polygon or a resultant. Everything is exact; nothing is compared with a tolerance.
"""

from __future__ import annotations

from fractions import Fraction
from typing import NamedTuple

from crankstar.derive import cyclotomic, wave
from crankstar.derive.formula import Formula, angle, cosine, negative, product, summed
from crankstar.derive.wave import Form, Wave, form_sum, joined
from crankstar.fault import cylinders

HALF = Fraction(1, 2)


class Term(NamedTuple):
    """A cosine `weight cos(k theta + phase)` of one cylinder; the phase in turns."""

    cylinder: int
    weight: Form
    phase: Fraction


class Gathered(NamedTuple):
    """A sum as a chain of equal formulas, what was seen on the way, and its amplitude."""

    chain: tuple[Formula, ...]
    notes: tuple[str, ...]
    wave: Wave


def gathered(terms: list[Term], order: Fraction, *, moments: bool) -> Gathered:
    """The sum of cosines, of forces or of moments, step by step to its closed form."""
    idle = [term.cylinder for term in terms if not term.weight]
    notes = [f"{_named(idle)} stand{'' if len(idle) > 1 else 's'} in the reference plane."] if idle else []
    terms = [term for term in terms if term.weight]
    raw = summed_up([(wave.form(term.weight), term.phase) for term in terms], order)
    groups = _groups(terms)
    left: list[tuple[Fraction, Form, list[int]]] = []
    made: list[list[tuple[int, Term]]] = []
    for phase, members in groups.items():
        weight = form_sum((Fraction(sign), term.weight) for sign, term in members)
        numbers = [term.cylinder for _, term in members]
        if weight:
            left.append((phase, weight, numbers))
            if len(members) > 1:
                made.append(members)
        else:
            notes.append(f"{_pairs(members, moments=moments)}.")
    notes += _together(made, moments=moments)
    chain = [raw]
    if len(left) < len(terms) and left:
        chain.append(summed_up([(wave.form(weight), phase) for phase, weight, _ in left], order))
    whole = joined(wave.scaled({(): cyclotomic.root(phase)}, weight) for phase, weight, _ in left)
    if not whole and left:
        notes.append(_closed_polygon(left))
    elif len(left) == 2:
        chain += _as_product([(wave.form(weight), phase) for phase, weight, _ in left], order)
    elif len(left) > 2:
        notes.append("The rest is added as vectors, each of its length and at its phase.")
    return Gathered(_distinct([*chain, wave.signal(whole, order)]), tuple(notes), whole)


def summed_up(parts: list[tuple[Formula, Fraction]], order: Fraction) -> Formula:
    """A sum of cosines with formulas before them."""
    return summed(*(wave.written(_piece(size, phase), order) for size, phase in parts))


def lag(phase: Fraction) -> Fraction:
    """The same phase from -1/2 up to 1/2: half a turn is written as a lag, -pi."""
    return (phase + HALF) % 1 - HALF


def _piece(size: Formula, phase: Fraction) -> wave.Piece:
    return wave.Piece(size, None, angle(lag(phase)))


def _groups(terms: list[Term]) -> dict[Fraction, list[tuple[int, Term]]]:
    """Terms whose phases are equal (+1) or opposite (-1), by the phase of the first of them."""
    groups: dict[Fraction, list[tuple[int, Term]]] = {}
    first: dict[Fraction, Fraction] = {}
    for term in terms:
        phase = term.phase % 1
        key = first.setdefault(phase % HALF, phase)
        groups.setdefault(key, []).append((1 if phase == key else -1, term))
    return groups


def _together(made: list[list[tuple[int, Term]]], *, moments: bool) -> list[str]:
    """Which cylinders are in phase, and which in phase or opposite."""
    notes: list[str] = []
    same = [] if moments else [members for members in made if len({sign for sign, _ in members}) == 1]
    opposed = [members for members in made if members not in same]
    for groups, told in ((same, "in phase: they push together"), (opposed, "in phase or opposite, so that their cosines make one")):
        if groups:
            names = "; ".join(_listed(members) for members in groups)
            notes.append(f"Cylinders {names}{': each group is' if len(groups) > 1 else ' are'} {told}.")
    return notes


def _listed(members: list[tuple[int, Term]]) -> str:
    return ", ".join(str(term.cylinder) for _, term in members)


def _pairs(members: list[tuple[int, Term]], *, moments: bool) -> str:
    """The pairs that cancel, by name."""
    why = "their moments are equal and opposite" if moments else "they push against each other"
    rest = list(members)
    pairs: list[str] = []
    while rest:
        sign, term = rest.pop(0)
        other = next(
            (i for i, (s, t) in enumerate(rest) if not form_sum([(Fraction(sign), term.weight), (Fraction(s), t.weight)])), None
        )
        if other is None:
            return f"{_named([term.cylinder for _, term in members])} cancel each other"
        pairs.append(f"{term.cylinder} and {rest.pop(other)[1].cylinder}")
    if len(pairs) == 1:
        return f"Cylinders {pairs[0]} cancel: {why} at every crank angle"
    return f"In pairs cylinders {'; '.join(pairs)} cancel: {why} at every crank angle"


def _closed_polygon(left: list[tuple[Fraction, Form, list[int]]]) -> str:
    numbers = sorted(number for _, _, group in left for number in group)
    count = len(left)
    weights = [
        weight if next(iter(weight.values())) > 0 else {key: -value for key, value in weight.items()} for _, weight, _ in left
    ]
    phases = [phase if next(iter(weight.values())) > 0 else phase + HALF for phase, weight, _ in left]
    apart = sorted((phase - phases[0]) % 1 for phase in phases)
    if all(weight == weights[0] for weight in weights) and apart == [Fraction(i, count) for i in range(count)]:
        apart_deg = f"{360 / count:.6g}° apart"
        return f"{_named(numbers)}: their vectors, equally long and {apart_deg}, close a polygon: their sum is exactly 0."
    return f"{_named(numbers)}: their vectors close a polygon: their sum is exactly 0."


def _named(numbers: list[int]) -> str:
    text = cylinders(numbers)
    return text[0].upper() + text[1:]


def _as_product(parts: list[tuple[Formula, Fraction]], order: Fraction) -> list[Formula]:
    """Cos x + cos y = 2 cos((x - y)/2) cos((x + y)/2), for two cosines of the same size."""
    (first, p), (second, q) = parts
    if first == negative(second):
        second, q = first, q + HALF
    if first != second:
        return []
    return [sum_as_product(first, p, q, order)]


def sum_as_product(size: Formula, p: Fraction, q: Fraction, order: Fraction) -> Formula:
    """Size cos(k theta + p) + size cos(k theta + q) as a product."""
    p, q = lag(p), lag(q)
    return product(2, size, cosine(angle(abs(p - q) / 2)), cosine(wave.phased(order, angle((p + q) / 2))))


def _distinct(chain: list[Formula]) -> tuple[Formula, ...]:
    out: list[Formula] = []
    for formula in chain:
        if not out or formula != out[-1]:
            out.append(formula)
    return tuple(out)


def told_once(chain: list[Formula]) -> tuple[Formula, ...]:
    """A chain without repetitions of a formula right after itself."""
    return _distinct(chain)
