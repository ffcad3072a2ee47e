"""What formulas come to: in floating point, or in balls that hold the true value."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import reduce
from operator import add, mul
from typing import Any

from flint import acb, arb, fmpq

from crankstar.derive.algebra.formula import (
    Applied,
    Decimal,
    Degrees,
    Formula,
    Pi,
    Polar,
    Power,
    Product,
    Ratio,
    Rational,
    Root,
    Sum,
    Symbol,
)


@dataclass(frozen=True)
class _Arithmetic:
    """The arithmetic in which a formula is evaluated."""

    number: Callable[[Fraction], Any]
    ball: Callable[[arb], Any]
    pi: Callable[[], Any]
    functions: Mapping[str, Callable[[Any], Any]]
    rotation: Callable[[Any], Any]


_FLOATS = _Arithmetic(
    number=float,
    ball=lambda ball: float(ball.mid()),
    pi=lambda: math.pi,
    functions={"cos": math.cos, "sin": math.sin, "atan": math.atan, "sqrt": math.sqrt},
    rotation=lambda angle: complex(math.cos(angle), math.sin(angle)),
)
_BALLS = _Arithmetic(
    number=lambda value: arb(fmpq(value.numerator, value.denominator)),
    ball=lambda ball: ball,
    pi=arb.pi,
    functions={"cos": arb.cos, "sin": arb.sin, "atan": arb.atan, "sqrt": arb.sqrt},
    rotation=lambda angle: acb(angle.cos(), angle.sin()),
)


def value(formula: Formula, symbols: Mapping[str, float] | None = None) -> Any:
    """What a formula comes to in floating point: real, or complex (up + i right) for a vector.

    KeyError without a symbol.

    >>> from crankstar.derive.algebra.formula import THETA, cosine, number, product
    >>> value(product(4, Root(number(2)), cosine(THETA)), {"theta": 0.0})
    5.656854249492381
    """
    return _valued(formula, symbols or {}, _FLOATS)


def enclosed(formula: Formula, symbols: Mapping[str, arb] | None = None) -> Any:
    """A ball that holds what a formula comes to, at the precision in force."""
    return _valued(formula, symbols or {}, _BALLS)


def _valued(formula: Formula, symbols: Mapping[str, Any], arithmetic: _Arithmetic) -> Any:
    def of(part: Formula) -> Any:
        return _valued(part, symbols, arithmetic)

    match formula:
        case Rational(fraction):
            return arithmetic.number(fraction)
        case Decimal(ball=ball):
            return arithmetic.ball(ball)
        case Symbol():
            return symbols[formula.name]
        case Pi():
            return arithmetic.pi()
        case Root(radicand):
            return arithmetic.functions["sqrt"](of(radicand))
        case Power(base, exponent):
            return of(base) ** exponent
        case Sum(terms):
            return reduce(add, map(of, terms))
        case Product(factors):
            return reduce(mul, map(of, factors))
        case Ratio(above, below):
            return of(above) / of(below)
        case Degrees(angle):
            return of(angle) * arithmetic.pi() / arithmetic.number(Fraction(180))
        case Applied(function, argument):
            return arithmetic.functions[function](of(argument))
        case Polar(length, angle):
            return of(length) * arithmetic.rotation(of(angle))
