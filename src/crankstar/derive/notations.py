"""Notations: the same derivation in the letters of different schools.

A derivation is written in the letters of this project: m, r, l, lambda = r/l, omega, bore pitch a,
unit C_k = m r omega^2 A_k. A notation says what takes their place, and how the series of A_k is
written.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from typing import NamedTuple, TypeVar

from crankstar.derive.algebra.formula import Formula, Ratio, Symbol, letters_of, number, renamed
from crankstar.derive.real import series
from crankstar.derive.records import DerivationError, Line, Readable, Series, unit_symbol
from crankstar.language.messages import N_, _

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
    series: Callable[[Series], Formula]
    legend: tuple[Meaning, ...]


def _roman_unit(harmonic: int | None) -> Formula:
    return Symbol("C", "" if harmonic is None else ROMAN.get(harmonic, str(harmonic)))


_LENGTHS: tuple[Meaning, ...] = (
    Meaning(Symbol("a"), N_("bore pitch")),
    Meaning(Symbol("b"), N_("bank offset")),
    Meaning(
        Symbol("theta"),
        N_("crank angle, from top dead centre of cylinder 1, in the direction of rotation"),
    ),
)
_MOTION = (
    Meaning(Symbol("m"), N_("reciprocating mass of a cylinder")),
    Meaning(Symbol("r"), N_("crank radius")),
    Meaning(Symbol("lambda"), N_("r/l, l the length of the connecting rod")),
    Meaning(Symbol("omega"), N_("angular speed of the crankshaft, rad/s")),
)
_STROKE = Ratio(Symbol("S"), number(2))

CRANKSTAR = Notation(
    name="crankstar",
    letters={},
    unit=unit_symbol,
    series=lambda powers: series(powers, Symbol("lambda")),
    legend=(*_MOTION, *_LENGTHS),
)
STROKE = Notation(
    name="stroke",
    letters={"m": Symbol("M"), "r": _STROKE},
    unit=unit_symbol,
    series=lambda powers: series(powers, Symbol("L"), inverted=True),
    legend=(
        Meaning(Symbol("M"), N_("reciprocating mass of a cylinder")),
        Meaning(Symbol("S"), N_("stroke, twice the crank radius")),
        Meaning(Symbol("L"), N_("l/S, l the length of the connecting rod")),
        Meaning(Symbol("lambda"), N_("r/l, which is 1/(2L)")),
        Meaning(Symbol("omega"), N_("angular speed of the crankshaft, π n/30 with n in rpm")),
        *_LENGTHS,
    ),
)
SINITSYN = Notation(
    name="sinitsyn",
    letters={"a": Symbol("l", "0")},
    unit=_roman_unit,
    series=lambda powers: series(powers, Symbol("lambda")),
    legend=(
        Meaning(
            Symbol("C", "I"),
            N_(
                "greatest primary inertia force of one cylinder, m r ω²; C_II, C_IV, ... those of "
                "the other orders"
            ),
        ),
        Meaning(Symbol("P", "R"), N_("centrifugal force of the rotating masses of one crank")),
        Meaning(Symbol("l", "0"), N_("bore pitch")),
        *_MOTION,
        *_LENGTHS[1:],
    ),
)
NOTATIONS = {notation.name: notation for notation in (CRANKSTAR, STROKE, SINITSYN)}


C = TypeVar("C", bound=Readable)


def notated(chapter: C, notation: Notation) -> C:
    """The chapter in another notation; its formulas then evaluate with the letters of that one."""
    letters, unit = dict(notation.letters), unit_symbol(chapter.harmonic)
    if notation.unit(chapter.harmonic) != unit:
        letters[unit.name] = notation.unit(chapter.harmonic)

    def written(line: Line) -> Line:
        if not letters and not line.series:
            return line
        chain = (
            (notation.series(line.series),)
            if line.series
            else tuple(renamed(formula, letters) for formula in line.chain)
        )
        name, arm = (
            None if part is None else renamed(part, letters) for part in (line.name, line.arm)
        )
        return replace(line, name=name, arm=arm, chain=chain)

    steps = tuple(replace(step, lines=tuple(map(written, step.lines))) for step in chapter.steps)
    return replace(chapter, steps=steps)


def legend(chapter: Readable, notation: Notation) -> list[Meaning]:
    """The letters of a notation that a chapter in it uses."""
    used: set[str] = set()
    for step in chapter.steps:
        for line in step.lines:
            names = [part for part in (line.name, line.arm) if part is not None]
            for formula in (*line.chain, *names):
                used |= letters_of(formula)
    own = {_named(notation, name): words for name, words in chapter.meanings.items()}
    out: list[Meaning] = []
    for meaning in notation.legend:
        if letters_of(meaning.letter) & used:
            name = _name(meaning.letter)
            words = own.pop(name) if name in own else _(meaning.words)
            out.append(Meaning(meaning.letter, words))
    harmonics = (
        ("A", N_("harmonic k of the acceleration of a piston, in units of r ω²")),
        ("B", N_("harmonic k of the inertia torque of a piston, in units of m r² ω²")),
    )
    out += [
        Meaning(Symbol(letter, "k"), _(words))
        for letter, words in harmonics
        if any(name.startswith(letter) for name in used)
    ]
    return out + [
        Meaning(letter, words)
        for letter, words in _others(notation, chapter)
        if letter.name in used and letter.name in own
    ]


def _name(letter: Formula) -> str:
    return letter.name if isinstance(letter, Symbol) else ""


def _named(notation: Notation, name: str) -> str:
    """The name of a letter of ours in a notation."""
    return _name(notation.letters[name]) if name in notation.letters else name


def _others(notation: Notation, chapter: Readable) -> list[tuple[Symbol, str]]:
    """Letters of the engine that no legend foresees: b_1, b_2, ..., z_0."""
    known = {_name(meaning.letter) for meaning in notation.legend}
    letters = [
        (Symbol(*name.split("_", 1)) if "_" in name else Symbol(name), words)
        for name, words in chapter.meanings.items()
    ]
    return [(letter, words) for letter, words in letters if letter.name not in known]


def chosen(name: str) -> Notation:
    """A notation by its name. Raises DerivationError with the names there are."""
    if name not in NOTATIONS:
        raise DerivationError(
            _(
                "There is no notation {name}; choose from {names}.",
                name=repr(name),
                names=", ".join(NOTATIONS),
            )
        )
    return NOTATIONS[name]
