"""Notations: the same derivation in the letters of different schools.

A derivation is written in the letters of this project: m, r, l, lambda = r/l, omega, bore pitch a, unit C_k = m r omega^2 A_k.
A notation says what takes their place, and how the series of A_k is written.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from typing import NamedTuple

from crankstar.derive import resultant
from crankstar.derive.formula import Formula, Ratio, Symbol, letters_of, number, renamed
from crankstar.derive.records import Chapter, DerivationError, Line, unit_symbol

ROMAN = {1: "I", 2: "II", 4: "IV", 6: "VI", 8: "VIII"}


class Meaning(NamedTuple):
    """A letter and what it stands for."""

    letter: Formula
    words: str


@dataclass(frozen=True)
class Notation:
    """Formulas in the place of letters, the unit of each order, the series of A_k, and a legend."""

    name: str
    letters: Mapping[str, Formula]
    unit: Callable[[int | None], Formula]
    series: Callable[[int, int], Formula]
    legend: tuple[Meaning, ...]


def _roman_unit(harmonic: int | None) -> Formula:
    return Symbol("C", "" if harmonic is None else ROMAN.get(harmonic, str(harmonic)))


_LENGTHS: tuple[Meaning, ...] = (
    Meaning(Symbol("a"), "bore pitch"),
    Meaning(Symbol("b"), "how far one bank stands in front of the other"),
    Meaning(Symbol("theta"), "crank angle, from top dead centre of cylinder 1, in the direction of rotation"),
)
_STROKE = Ratio(Symbol("S"), number(2))

CRANKSTAR = Notation(
    name="crankstar",
    letters={},
    unit=unit_symbol,
    series=lambda harmonic, power: resultant.series(harmonic, power, Symbol("lambda")),
    legend=(
        Meaning(Symbol("m"), "reciprocating mass of a cylinder"),
        Meaning(Symbol("r"), "crank radius"),
        Meaning(Symbol("lambda"), "r/l, l the length of the connecting rod"),
        Meaning(Symbol("omega"), "angular speed of the crankshaft, rad/s"),
        *_LENGTHS,
    ),
)
STROKE = Notation(
    name="stroke",
    letters={"m": Symbol("M"), "r": _STROKE},
    unit=unit_symbol,
    series=lambda harmonic, power: resultant.series(harmonic, power, Symbol("L"), inverted=True),
    legend=(
        Meaning(Symbol("M"), "reciprocating mass of a cylinder"),
        Meaning(Symbol("S"), "stroke, twice the crank radius"),
        Meaning(Symbol("L"), "l/S, l the length of the connecting rod"),
        Meaning(Symbol("omega"), "angular speed of the crankshaft, π n/30 with n in rpm"),
        *_LENGTHS,
    ),
)
SINITSYN = Notation(
    name="sinitsyn",
    letters={"a": Symbol("l", "0")},
    unit=_roman_unit,
    series=lambda harmonic, power: resultant.series(harmonic, power, Symbol("lambda")),
    legend=(
        Meaning(
            Symbol("C", "I"), "greatest inertia force of the first order of one cylinder, m r ω²; C_II, C_IV, ... of the others"
        ),
        Meaning(Symbol("P", "R"), "centrifugal force of the rotating masses of one crank"),
        Meaning(Symbol("l", "0"), "distance of neighbouring cylinders"),
        Meaning(Symbol("m"), "reciprocating mass of a cylinder"),
        Meaning(Symbol("r"), "crank radius"),
        Meaning(Symbol("lambda"), "r/l, l the length of the connecting rod"),
        *_LENGTHS[1:],
    ),
)
NOTATIONS = {notation.name: notation for notation in (CRANKSTAR, STROKE, SINITSYN)}


def notated(chapter: Chapter, notation: Notation) -> Chapter:
    """The chapter in another notation; its formulas then evaluate with the letters of that one."""
    letters = dict(notation.letters)
    letters[unit_symbol(chapter.harmonic).name] = notation.unit(chapter.harmonic)

    def line(one: Line) -> Line:
        chain = (notation.series(*one.series),) if one.series else tuple(renamed(formula, letters) for formula in one.chain)
        return replace(one, name=None if one.name is None else renamed(one.name, letters), chain=chain)

    steps = tuple(replace(step, lines=tuple(map(line, step.lines))) for step in chapter.steps)
    return replace(chapter, steps=steps)


def legend(chapter: Chapter, notation: Notation) -> list[Meaning]:
    """The letters of a notation that a chapter uses."""
    used: set[str] = set()
    for step in notated(chapter, notation).steps:
        for one in step.lines:
            for formula in one.chain if one.name is None else (one.name, *one.chain):
                used |= letters_of(formula)
    return [meaning for meaning in notation.legend if letters_of(meaning.letter) & used]


def chosen(name: str) -> Notation:
    """A notation by its name. Raises DerivationError with the names there are."""
    if name not in NOTATIONS:
        raise DerivationError(f"there is no notation {name!r}; there are: {', '.join(NOTATIONS)}")
    return NOTATIONS[name]
