"""What formulas come to, in balls that hold the true value."""

from __future__ import annotations

from collections.abc import Mapping
from functools import reduce
from operator import add, mul
from typing import Any

from flint import acb, arb, fmpq

from crankstar.derive.algebra import cyclotomic
from crankstar.derive.algebra.formula import (
    Applied,
    Decimal,
    Degrees,
    Formula,
    Integral,
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


def value(formula: Formula, symbols: Mapping[str, float] | None = None) -> Any:
    """What a formula comes to in floating point: real, or complex (up + i right) for a vector.

    KeyError without a symbol.

    >>> from crankstar.derive.algebra.formula import THETA, cosine, number, product
    >>> value(product(4, Root(number(2)), cosine(THETA)), {"theta": 0.0})
    5.656854249492381
    """
    with cyclotomic.precision(20):
        ball = enclosed(formula, {name: arb(size) for name, size in (symbols or {}).items()})
    if isinstance(ball, acb):
        return complex(float(ball.real.mid()), float(ball.imag.mid()))
    return float(ball.mid())


def enclosed(formula: Formula, symbols: Mapping[str, arb] | Mapping[str, arb | acb]) -> Any:
    """A ball that holds what a formula comes to, at the precision in force."""

    def of(part: Formula) -> Any:
        return enclosed(part, symbols)

    match formula:
        case Rational(fraction):
            return arb(fmpq(fraction.numerator, fraction.denominator))
        case Decimal(ball):
            return ball
        case Symbol():
            return symbols[formula.name]
        case Pi():
            return arb.pi()
        case Root(radicand):
            return of(radicand).sqrt()
        case Power(base, exponent):
            return of(base) ** exponent
        case Sum(terms):
            return reduce(add, map(of, terms))
        case Product(factors):
            return reduce(mul, map(of, factors))
        case Ratio(above, below):
            return of(above) / of(below)
        case Degrees(angle):
            return of(angle) * arb.pi() / 180
        case Applied(function, argument):
            return getattr(of(argument), function)()
        case Polar(length, angle):
            turned = of(angle)
            return of(length) * acb(turned.cos(), turned.sin())
        case Integral(integrand, variable, lower, upper):

            def at(point: acb, _analytic: bool) -> acb:
                return acb(enclosed(integrand, {**symbols, variable.name: point}))

            return acb.integral(at, of(lower), of(upper)).real
