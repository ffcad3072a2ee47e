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
        Meaning(Symbol("omega"), "angular speed of the crankshaft, rad/s"),
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
        name, arm = (None if part is None else renamed(part, letters) for part in (one.name, one.arm))
        return replace(one, name=name, arm=arm, chain=chain)

    steps = tuple(replace(step, lines=tuple(map(line, step.lines))) for step in chapter.steps)
    return replace(chapter, steps=steps)


def legend(chapter: Chapter, notation: Notation) -> list[Meaning]:
    """The letters of a notation that a chapter uses."""
    used: set[str] = set()
    for step in notated(chapter, notation).steps:
        for one in step.lines:
            for formula in (*one.chain, *(part for part in (one.name, one.arm) if part is not None)):
                used |= letters_of(formula)
    said = [meaning for meaning in notation.legend if letters_of(meaning.letter) & used]
    own = {_named(notation, name): words for name, words in chapter.meanings.items()}
    told = [meaning._replace(words=own.pop(name)) if (name := _name(meaning.letter)) in own else meaning for meaning in said]
    harmonics = sorted(name for name in used if name.startswith("A"))
    if harmonics:
        told.append(Meaning(Symbol("A", "k"), "k-th harmonic of a piston's acceleration, in units of r ω²"))
    return told + [
        Meaning(letter, words) for letter, words in _others(notation, chapter) if letter.name in used and letter.name in own
    ]


def _name(letter: Formula) -> str:
    return letter.name if isinstance(letter, Symbol) else ""


def _named(notation: Notation, name: str) -> str:
    """What a letter of ours is called in a notation."""
    return _name(notation.letters[name]) if name in notation.letters else name


def _others(notation: Notation, chapter: Chapter) -> list[tuple[Symbol, str]]:
    """Letters of the engine that no legend foresees: b_1, b_2, ..., z_0."""
    known = {_name(meaning.letter) for meaning in notation.legend}
    letters = [(Symbol(*name.split("_", 1)) if "_" in name else Symbol(name), words) for name, words in chapter.meanings.items()]
    return [(letter, words) for letter, words in letters if letter.name not in known]


def chosen(name: str) -> Notation:
    """A notation by its name. Raises DerivationError with the names there are."""
    if name not in NOTATIONS:
        raise DerivationError(f"there is no notation {name!r}; there are: {', '.join(NOTATIONS)}")
    return NOTATIONS[name]
