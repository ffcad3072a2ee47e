"""Formulas as small trees: what a derivation writes down, and what it comes to.

A formula is written as it is built (nothing is expanded or put in order), and can be evaluated, in
floating point or in balls that hold the true value. So what is printed is what was checked.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, fields
from fractions import Fraction
from functools import cache
from typing import Any, get_args

from flint import arb, fmpz


@dataclass(frozen=True, slots=True)
class Rational:
    """A rational number."""

    value: Fraction

    def __hash__(self) -> int:
        """The same for equal numbers; that of a Fraction takes ten times as long."""
        return hash(self.value.as_integer_ratio())


@dataclass(frozen=True, slots=True, eq=False)
class Decimal:
    """A number known by an enclosing ball, written with `digits` certain figures."""

    ball: arb
    digits: int = 7

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Decimal) and self._key == other._key

    def __hash__(self) -> int:
        return hash(self._key)

    @property
    def _key(self) -> tuple[object, ...]:
        return (self.ball.mid().man_exp(), self.ball.rad().man_exp(), self.digits)


@dataclass(frozen=True, slots=True)
class Symbol:
    """A letter, Greek ones by name, with what stands below it."""

    letter: str
    below: str = ""

    @property
    def name(self) -> str:
        """By which its value is looked up: `A_2`."""
        return f"{self.letter}_{self.below}" if self.below else self.letter


@dataclass(frozen=True, slots=True)
class Pi:
    """The number pi."""


@dataclass(frozen=True, slots=True)
class Root:
    """A square root."""

    radicand: Formula


@dataclass(frozen=True, slots=True)
class Power:
    """A whole power."""

    base: Formula
    exponent: int


@dataclass(frozen=True, slots=True)
class Sum:
    """Terms added as they are listed."""

    terms: tuple[Formula, ...]


@dataclass(frozen=True, slots=True)
class Product:
    """Factors, a rational one first if there is one."""

    factors: tuple[Formula, ...]


@dataclass(frozen=True, slots=True)
class Ratio:
    """A fraction of formulas."""

    above: Formula
    below: Formula


@dataclass(frozen=True, slots=True)
class Degrees:
    """An angle in degrees, exact or as a decimal."""

    value: Rational | Decimal


@dataclass(frozen=True, slots=True)
class Applied:
    """cos, sin or atan of something."""

    function: str
    argument: Formula


@dataclass(frozen=True, slots=True)
class Polar:
    """A vector of the clock plane: its length and its bearing, `length * exp(i angle)`."""

    length: Formula
    angle: Formula


@dataclass(frozen=True, slots=True)
class Integral:
    """A definite integral over a letter."""

    integrand: Formula
    variable: Symbol
    lower: Formula
    upper: Formula


Formula = (
    Rational
    | Decimal
    | Symbol
    | Pi
    | Root
    | Power
    | Sum
    | Product
    | Ratio
    | Degrees
    | Applied
    | Polar
    | Integral
)

KINDS = frozenset(get_args(Formula))
"""The same, to ask for in one step whether something is a formula."""
LEAVES = (Rational, Decimal, Symbol, Pi)
"""The formulas that have no others in them."""
NOUGHT = Rational(Fraction(0))
UNIT = Rational(Fraction(1))
THETA = Symbol("theta")
GREATEST_FACTORED = 10**15
"""Whole numbers up to this are factored; the form of a greater one would be long anyway."""
LONG = 1000
"""Denominator from which a fraction is written as a decimal."""


def number(value: Fraction | int) -> Rational:
    """A rational number."""
    return Rational(Fraction(value))


def product(*factors: Formula | Fraction | int) -> Formula:
    """A product with its rational factors multiplied in front; zero and one are not written."""
    flat: list[Formula] = []
    for factor in factors:
        tree = number(factor) if isinstance(factor, (int, Fraction)) else factor
        flat += tree.factors if isinstance(tree, Product) else (tree,)
    rational = Fraction(1)
    others: list[Formula] = []
    for f in flat:
        if isinstance(f, Rational):
            rational = f.value if rational == 1 else rational * f.value
        elif isinstance(f, Decimal) and f.ball < 0:
            rational = -rational
            others.append(Decimal(-f.ball, f.digits))
        else:
            others.append(f)
    roots = [
        f.radicand.value for f in others if isinstance(f, Root) and isinstance(f.radicand, Rational)
    ]
    if len(roots) > 1:  # sqrt(2) sqrt(10) is 2 sqrt(5)
        rest = (f for f in others if not (isinstance(f, Root) and isinstance(f.radicand, Rational)))
        return product(rational, square_root(math.prod(roots, start=Fraction(1))), *rest)
    if rational == 0 or not others:
        return Rational(rational)
    if rational == 1:
        return others[0] if len(others) == 1 else Product(tuple(others))
    return Product((Rational(rational), *others))


def square_root(value: Fraction) -> Formula:
    """The square root of a fraction, squares taken out: 2 sqrt(3), sqrt(10)/2.

    ValueError below zero.
    """
    if value < 0:
        raise ValueError("the square root of a negative number is not real")
    if value == 0:
        return number(0)
    outside, inside = squares(value.numerator * value.denominator)
    front = Fraction(outside, value.denominator)
    return number(front) if inside == 1 else product(front, Root(Rational(Fraction(inside))))


def squares(whole: int) -> tuple[int, int]:
    """A positive whole number as n^2 m, m square-free; of a very long one only an exact root."""
    if whole > GREATEST_FACTORED:
        outside = math.isqrt(whole)
        return (outside, 1) if outside * outside == whole else (1, whole)
    outside = 1
    for prime, exponent in fmpz(whole).factor() if whole > 1 else ():
        outside *= int(prime) ** (int(exponent) // 2)
    return outside, whole // outside**2


def terms_of(formula: Formula) -> tuple[Formula, ...]:
    """The terms of a sum; of any other formula itself."""
    return formula.terms if isinstance(formula, Sum) else (formula,)


def summed(*terms: Formula) -> Formula:
    """A sum without its zeros."""
    kept = tuple(inner for term in terms for inner in terms_of(term) if inner != NOUGHT)
    return NOUGHT if not kept else kept[0] if len(kept) == 1 else Sum(kept)


def collected(*terms: Formula) -> Formula:
    """A sum in which terms that differ only in a rational factor are one."""
    factors: dict[Formula, Fraction] = {}
    for term in terms_of(summed(*terms)):
        size, rest = coefficient(term)
        factors[rest] = factors.get(rest, Fraction(0)) + size
    return summed(*(product(size, rest) for rest, size in factors.items()))


def negative(formula: Formula) -> Formula:
    """Minus a formula; of a sum, minus each of its terms."""
    if isinstance(formula, Sum):
        return Sum(tuple(negative(term) for term in formula.terms))
    return product(-1, formula)


def angle(turn: Fraction) -> Formula:
    """A part of a full turn as a multiple of pi where that is short, else in degrees."""
    if turn.denominator <= 48:
        return product(2 * turn, Pi())
    return Degrees(number(360 * turn))


def cosine(argument: Formula) -> Formula:
    """The cosine of a formula."""
    return Applied("cos", argument)


def coefficient(formula: Formula) -> tuple[Fraction, Formula]:
    """The rational factor in front of a formula, and the rest."""
    if isinstance(formula, Rational):
        return formula.value, UNIT
    if isinstance(formula, Product) and isinstance(formula.factors[0], Rational):
        return formula.factors[0].value, product(*formula.factors[1:])
    return Fraction(1), formula


def parts(formula: Formula) -> Iterator[Formula]:
    """A formula and all formulas in it."""
    yield formula
    for name in _names(type(formula)):
        inner = getattr(formula, name)
        for part in inner if isinstance(inner, tuple) else (inner,):
            if type(part) in KINDS:
                yield from parts(part)


@cache
def _names(kind: type[Formula]) -> tuple[str, ...]:
    """The names of the fields in which a formula may have others."""
    return tuple(field.name for field in fields(kind)) if kind not in LEAVES else ()


def letters_of(formula: Formula) -> set[str]:
    """The names of all symbols in a formula."""
    return {part.name for part in parts(formula) if isinstance(part, Symbol)}


def has_long(formula: Formula) -> bool:
    """Whether a formula holds a fraction too long to be written as one."""
    return any(
        part.value.denominator > LONG or abs(part.value.numerator) > LONG**2
        for part in parts(formula)
        if isinstance(part, Rational)
    )


def has_decimal(formula: Formula) -> bool:
    """Whether a formula holds a decimal."""
    return any(isinstance(part, Decimal) for part in parts(formula))


def renamed(formula: Formula, names: Mapping[str, Formula]) -> Formula:
    """A formula with formulas in the place of some of its symbols."""

    def of(part: Any) -> Any:
        if isinstance(part, tuple):
            return tuple(map(of, part))
        return renamed(part, names) if type(part) in KINDS else part

    if isinstance(formula, Symbol):
        return names.get(formula.name, formula)
    if isinstance(formula, LEAVES):
        return formula
    if isinstance(formula, Product):
        return product(*map(of, formula.factors))
    kind = type(formula)
    return kind(*(of(getattr(formula, name)) for name in _names(kind)))
