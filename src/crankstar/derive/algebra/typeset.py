"""Formulas in print: plain text for a terminal, LaTeX, and MathML for a browser.

The three say the same thing: one set of rules decides on signs and brackets, and a style writes
what they come to. A part of a formula is printed as its body, how tightly the body binds, and a
minus sign before it; what stands around it decides where the sign goes and whether the body needs
brackets, so that no part can be printed without those it needs.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from enum import IntEnum
from fractions import Fraction
from functools import lru_cache
from math import floor, log10
from typing import NamedTuple

from flint import arb, fmpq

from crankstar.derive.algebra.digits import figures, finite
from crankstar.derive.algebra.formula import (
    LONG,
    UNIT,
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
    coefficient,
    letters_of,
    product,
    terms_of,
)
from crankstar.derive.algebra.styles import LATEX, MATHML, TEXT, Style

TINY = 1e-6
"""Decimals below this are written with a power of ten."""


class Binding(IntEnum):
    """How tightly what is printed holds together, loosest first.

    A product written side by side (`2a`) binds tighter than one with a dot or a slash.
    """

    SUM = 0
    VECTOR = 1
    QUOTIENT = 2
    PRODUCT = 3
    FUNCTION = 4
    FACTOR = 5


class Printed(NamedTuple):
    """A formula in print: its body, how tightly that binds, and a minus sign before it."""

    body: str
    binding: Binding = Binding.FACTOR
    negative: bool = False


def text(formula: Formula) -> str:
    """A formula in one line of text.

    >>> text(product(Fraction(3, 2), Symbol("a"), Root(Rational(Fraction(2)))))
    '(3√2/2) a'
    >>> text(product(-2, Sum((Symbol("a"), product(-1, Symbol("b"))))))
    '−2 (a − b)'
    """
    return _whole(formula, TEXT)


def latex(formula: Formula) -> str:
    """A formula in LaTeX, for use between dollar signs."""
    return _whole(formula, LATEX)


def mathml(formula: Formula) -> str:
    """A formula as presentation MathML, without the enclosing `math` element."""
    return _whole(formula, MATHML)


def negative(formula: Formula) -> bool:
    """Whether a formula, or the first term of a sum, is printed with a minus sign."""
    if isinstance(formula, Sum):
        return negative(formula.terms[0])
    return _printed(formula, TEXT).negative


@lru_cache(maxsize=1 << 14)
def _printed(formula: Formula, style: Style) -> Printed:
    return _WRITERS[type(formula)](formula, style)


def _whole(formula: Formula, style: Style) -> str:
    """A formula where nothing stands around it."""
    printed = _printed(formula, style)
    return (style.sign if printed.negative else "") + printed.body


def _held(printed: Printed, least: Binding, style: Style) -> str:
    """The body of what is printed, in brackets if it does not bind tightly enough."""
    return printed.body if printed.binding >= least else style.bracket.format(printed.body)


def _signed(printed: Printed, style: Style, *, negative: bool) -> Printed:
    """What is printed, with or without a minus sign before it; a sum behind one has brackets."""
    if negative and printed.binding == Binding.SUM:
        return Printed(style.bracket.format(printed.body), negative=True)
    return printed._replace(negative=negative)


def _rational(formula: Rational, style: Style) -> Printed:
    return _number(abs(formula.value), style)._replace(negative=formula.value < 0)


def _number(size: Fraction, style: Style) -> Printed:
    """A positive rational number.

    Whole, as a fraction, or as a decimal where the fraction is long.
    """
    if size.denominator == 1:
        return Printed(style.figures.format(size.numerator))
    if size.denominator > LONG:
        return _decimal(_ball(size), style)
    above, below = (style.figures.format(n) for n in (size.numerator, size.denominator))
    return Printed(style.ratio.format(above, below), _of_ratio(style))


def _ball(size: Fraction) -> Decimal:
    return Decimal(arb(fmpq(size.numerator, size.denominator)))


def _of_ratio(style: Style) -> Binding:
    return Binding.FACTOR if style.stacked else Binding.QUOTIENT


def _decimal(formula: Decimal, style: Style) -> Printed:
    ball = formula.ball
    if ball.contains(0):
        return Printed(style.figures.format("0"))
    power = floor(log10(float(abs(ball).mid()))) if abs(ball) < TINY else 0
    shown = _scaled(formula, power)
    if shown is None or shown.lstrip("-").startswith("0"):  # of these no digit is certain
        power = 0
        while (shown := _scaled(formula, power)) is None:
            power += 1
    body = style.figures.format(shown.removeprefix("-")) + style.dots
    negative = shown.startswith("-")
    if power == 0:
        return Printed(body, negative=negative)
    tens = _raised(style.figures.format(10), power, style)
    return Printed(body + style.dot + tens, Binding.QUOTIENT, negative)


def _scaled(formula: Decimal, power: int) -> str | None:
    """The certain digits of a decimal over 10**power."""
    return figures(Decimal(formula.ball * arb(10) ** -power, formula.digits))


def _degrees(formula: Degrees, style: Style) -> Printed:
    """Degrees as a decimal, cut where it has no end."""
    inner = formula.value
    number = _printed(inner, style)
    if isinstance(inner, Rational) and inner.value.denominator > 1:
        size = abs(inner.value)
        whole = finite(size)
        shown = Printed(style.figures.format(whole)) if whole else _decimal(_ball(size), style)
        number = shown._replace(negative=number.negative)
    body = style.degrees.format(_held(number, Binding.FACTOR, style))
    return Printed(body, Binding.PRODUCT, number.negative)


def _sum(formula: Sum, style: Style) -> Printed:
    """Terms with their signs between them; a sum in brackets only where it is taken away."""
    terms = [inner for term in formula.terms for inner in terms_of(term)]
    if any(isinstance(term, Sum) for term in terms):
        return _sum(Sum(tuple(terms)), style)
    printed = [_printed(term, style) for term in terms]
    if len(printed) == 1:
        return printed[0]
    out = ""
    for index, term in enumerate(printed):
        sign = style.minus if term.negative else style.plus
        if index == 0:
            sign = style.sign if term.negative else ""
        out += sign + _held(term, Binding.VECTOR, style)
    return Printed(out, Binding.SUM)


def _product(formula: Product, style: Style) -> Printed:
    """Numbers, then letters: 4√2 a cos 2θ, 0.5 · 0.8516… a."""
    plain = product(*_flat(formula))
    if not isinstance(plain, Product):
        return _printed(plain, style)
    size, _ = coefficient(plain)
    simple: list[Formula] = []
    longer: list[Formula] = []
    letters: list[Formula] = []
    for factor in plain.factors:
        if isinstance(factor, (Root, Pi)):
            simple.append(factor)
        elif isinstance(factor, (Decimal, Ratio)) and not letters_of(factor):
            longer.append(factor)
        elif not isinstance(factor, Rational):
            letters.append(factor)
    front = _front(abs(size), simple, style, alone=not letters and not longer)
    numbers = [*([front] if front.body else []), *(_printed(factor, style) for factor in longer)]
    rest = _side_by_side(letters, style)
    down = (size < 0) ^ (sum(part.negative for part in (*numbers, *rest)) % 2 == 1)
    if len(numbers) + len(rest) == 1:
        return _signed((*numbers, *rest)[0], style, negative=down)
    body = style.dot.join(_held(part, Binding.QUOTIENT, style) for part in numbers)
    dotted = len(numbers) > 1
    if numbers and rest:
        loose = numbers[-1].binding < Binding.PRODUCT
        close = not longer and _close(front.body, letters[0], style)
        body += style.dot if loose else "" if close else style.space
        dotted |= loose
    body += style.space.join(_held(part, Binding.FUNCTION, style) for part in rest)
    return Printed(body, Binding.QUOTIENT if dotted else Binding.PRODUCT, down)


def _flat(formula: Formula) -> list[Formula]:
    """The factors of a product and of the products in it."""
    if isinstance(formula, Sum) and len(formula.terms) == 1:
        return _flat(formula.terms[0])
    if isinstance(formula, Product):
        return [inner for factor in formula.factors for inner in _flat(factor)]
    return [formula]


def _side_by_side(factors: Sequence[Formula], style: Style) -> list[Printed]:
    """Factors one after the other; a function that others than functions follow has brackets."""
    out: list[Printed] = []
    for index, factor in enumerate(factors):
        function, followers = _function(factor), factors[index + 1 : index + 2]
        if function is None:
            out.append(_printed(factor, style))
        else:
            simple = all(_function(other) is not None for other in followers)
            out.append(_applied(*function, style, simple=simple))
    return out


def _function(formula: Formula) -> tuple[Applied, int] | None:
    """A function and the positive power to which it is taken: cos 2θ, cos² α."""
    base, exponent = (
        (formula.base, formula.exponent) if isinstance(formula, Power) else (formula, 1)
    )
    return (base, exponent) if isinstance(base, Applied) and exponent > 0 else None


def _close(front: str, letter: Formula, style: Style) -> bool:
    """Whether a number stands right before a letter, as in 2θ."""
    plain = letter.base if isinstance(letter, Power) else letter
    return (front.isdigit() and isinstance(plain, Symbol)) or (
        style is MATHML and front.startswith("<mn>")
    )


def _front(size: Fraction, constants: Sequence[Formula], style: Style, *, alone: bool) -> Printed:
    """The numbers in front of a product: 4√2, 3√2/2, 3π/4, 1.5; nothing for 1."""
    if not constants:
        if size == 1:
            return Printed("")
        short = None if style.stacked or size.denominator > 20 else finite(size)
        whole = _number(size, style) if short is None else Printed(short)
    else:
        shown = "".join(_printed(factor, style).body for factor in constants)
        above = shown if size.numerator == 1 else style.figures.format(size.numerator) + shown
        if size.denominator == 1:
            return Printed(above, Binding.PRODUCT)
        below = style.figures.format(size.denominator)
        whole = Printed(style.ratio.format(above, below), _of_ratio(style))
    return whole if alone else Printed(_held(whole, Binding.PRODUCT, style))


def _power(formula: Power, style: Style) -> Printed:
    """A power; of a cosine with the exponent at its name, cos² α."""
    function = _function(formula)
    if function is not None:
        return _applied(*function, style)
    base = formula.base
    inner = _whole(base, style)
    if not isinstance(base, Symbol) or "′" in base.letter:
        inner = style.bracket.format(inner)
    return Printed(_raised(inner, formula.exponent, style))


def _raised(base: str, exponent: int, style: Style) -> str:
    return style.power.format(base, str(exponent).translate(style.raised))


def _root(formula: Root, style: Style) -> Printed:
    inner = formula.radicand
    single = isinstance(inner, Symbol) and not inner.below
    single |= isinstance(inner, Rational) and inner.value >= 0 and inner.value.denominator == 1
    sign = (single and style.single) or style.root
    return Printed(sign.format(_whole(inner, style)))


def _ratio(formula: Ratio, style: Style) -> Printed:
    above, below = _printed(formula.above, style), _printed(formula.below, style)
    down = above.negative ^ below.negative
    if style.stacked:
        return Printed(style.ratio.format(above.body, below.body), negative=down)
    simple = above.binding == Binding.FACTOR or (
        above.binding == Binding.PRODUCT and " " not in above.body
    )
    upper = above.body if simple else style.bracket.format(above.body)
    ratio = style.ratio.format(upper, _held(below, Binding.FACTOR, style))
    return Printed(ratio, Binding.QUOTIENT, down)


def _applied(formula: Applied, exponent: int, style: Style, *, simple: bool = True) -> Printed:
    """A function, its argument without brackets where it is a letter, or a multiple of one."""
    argument = formula.argument
    multiple, inner = coefficient(argument)
    letter = isinstance(inner, Symbol) and formula.function != "atan"
    simple &= (letter or inner == UNIT) and multiple > 0 and multiple.denominator == 1
    latex_arctangent = style is LATEX and formula.function == "atan"
    name = style.name.format("arctan" if latex_arctangent else formula.function)
    named = name if exponent == 1 else _raised(name, exponent, style)
    body = (style.simple if simple else style.function).format(named, _whole(argument, style))
    return Printed(body, Binding.FUNCTION if simple else Binding.FACTOR)


def _polar(formula: Polar, style: Style) -> Printed:
    length, angle = _printed(formula.length, style), _printed(formula.angle, style)
    bearing = (style.sign if angle.negative else "") + _held(angle, Binding.QUOTIENT, style)
    body = style.polar.format(_held(length, Binding.QUOTIENT, style), bearing)
    return Printed(body, Binding.VECTOR, length.negative)


def _integral(formula: Integral, style: Style) -> Printed:
    lower, upper = _whole(formula.lower, style), _whole(formula.upper, style)
    inner = _held(_printed(formula.integrand, style), Binding.QUOTIENT, style)
    variable = _whole(formula.variable, style)
    return Printed(style.integral.format(lower, upper, inner, variable), Binding.FUNCTION)


_WRITERS: dict[type, Callable[..., Printed]] = {
    Rational: _rational,
    Decimal: _decimal,
    Symbol: lambda formula, style: Printed(style.symbol(formula.letter, formula.below)),
    Pi: lambda _, style: Printed(style.symbol("pi", "")),
    Root: _root,
    Power: _power,
    Sum: _sum,
    Product: _product,
    Ratio: _ratio,
    Degrees: _degrees,
    Applied: lambda formula, style: _applied(formula, 1, style),
    Polar: _polar,
    Integral: _integral,
}
