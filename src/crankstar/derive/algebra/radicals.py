"""Exact numbers in their shortest form: real ones in radicals, complex ones as length and bearing.

A real number whose degree over the rationals is a power of two is a tower of square roots: with a
conjugation s of order two, x = u + w with u = (x + s x)/2 and w = (x - s x)/2, where u and w^2 are
unmoved by s and so of half the degree. Where another prime divides the degree (throws at sevenths,
ninths or elevenths of a turn) real radicals do not exist, and the number is given by a decimal that
encloses it, and by its minimal polynomial.

The bearing of a vector z is a rational part of a turn if and only if z/conj(z) is a root of unity;
else it is the arctangent of an exact number, beside a multiple of 45 degrees where that makes it
shorter.
"""

from __future__ import annotations

from cmath import phase
from fractions import Fraction
from math import gcd, isqrt, lcm, pi

from flint import arb

from crankstar.derive.algebra import cyclotomic
from crankstar.derive.algebra.cyclotomic import DIGITS, Number, remembered
from crankstar.derive.algebra.evaluation import value as evaluated
from crankstar.derive.algebra.formula import (
    Applied,
    Decimal,
    Degrees,
    Formula,
    Ratio,
    Rational,
    Root,
    Sum,
    angle,
    coefficient,
    has_long,
    negative,
    number,
    product,
    square_root,
    squares,
    summed,
    terms_of,
)
from crankstar.derive.algebra.typeset import negative as written_negative
from crankstar.derive.algebra.typeset import text

LONGEST = 26
"""Characters of a closed form that still tells a reader more than its decimal."""
GREATEST_TOWER = 8
"""Degree of a number above which no tower of roots is sought."""
GREATEST_HEIGHT = 10**15
"""Whole numbers in the coefficients of a number above which its form would be long."""
GREATEST_DEGREE = 200
"""Degree of the field above which no closed form is sought: there is none that is short."""


@remembered
def closed(value: Number) -> Formula:
    """A real number in radicals, else as an enclosed decimal.

    >>> from crankstar.derive.algebra.cyclotomic import cosine
    >>> text(closed(cosine(Fraction(1, 24)))), text(closed(cosine(Fraction(1, 7))))
    ('(√6 + √2)/4', '0.6234898…')
    """
    content = value.content
    for factor in dict.fromkeys((Fraction(1), content)):
        radical = _radical(value.times(1 / factor))
        form = None if radical is None else over_one_denominator(product(factor, radical))
        if form is not None and _short(form):
            return form
    with cyclotomic.precision(DIGITS):
        return Decimal(value.enclosed().real)


def _shown(formula: Formula) -> int:
    """The number of characters that a formula takes."""
    return len(text(formula))


def _short(formula: Formula) -> bool:
    """Whether a closed form tells a reader more than its decimal: a plain rational always does."""
    return isinstance(formula, Rational) or (not has_long(formula) and _shown(formula) <= LONGEST)


@remembered
def length(value: Number) -> Formula:
    """The magnitude of a complex number.

    What is common to its coefficients stands before the root, where the rest is short.

    >>> from crankstar.derive.algebra.cyclotomic import root
    >>> five = (root(Fraction(1, 5)) + root(Fraction(1, 4))).times(Fraction(97, 104))
    >>> text(length(five))
    '97√(2 + √(5/2 + √5/2))/104'
    """
    square, turn = value * value.conjugate, bearing_turn(value)
    forms: list[Formula] = []
    for factor in dict.fromkeys((Fraction(1), value.content)):
        candidates = [_root_of(square.times(1 / factor**2))]
        if turn is not None:
            candidates.append(_radical(value.times(1 / factor).turned(-turn)))
        whole = [product(factor, form) for form in candidates if form is not None]
        forms += [form for form in map(over_one_denominator, whole) if _short(form)]
    if forms:
        return min(forms, key=_shown)
    with cyclotomic.precision(DIGITS):
        return Decimal(square.enclosed().real.sqrt())


@remembered
def bearing_turn(value: Number) -> Fraction | None:
    """The argument of a nonzero number in turns, (-1/2, 1/2]; None if it is irrational."""
    estimate = _argument(value)
    # z = conj(z) zeta^k, and the roots of unity of Q(zeta_N) have orders that divide N or 2N.
    order = value.order if value.order % 2 == 0 else 2 * value.order
    k = round(2 * estimate * order)
    if not (value - value.conjugate.turned(Fraction(k, order))).zero:
        return None
    half = Fraction(k, 2 * order)
    nearest = min(
        (half + step for step in (Fraction(-1, 2), Fraction(0), Fraction(1, 2))),
        key=lambda turn: abs(float(turn) - estimate),
    )
    return Fraction(1, 2) - (Fraction(1, 2) - nearest) % 1


@remembered
def bearing(value: Number) -> Formula:
    """The argument of a complex number other than zero, in (-180, 180] degrees.

    >>> from crankstar.derive.algebra.cyclotomic import rational, root
    >>> text(bearing(root(Fraction(1, 4)).times(3) + rational(1)))
    'atan 3'
    """
    turn = bearing_turn(value)
    if turn is not None:
        return angle(turn)
    candidates = [
        form
        for eighth in (0, 1, -1, 2, -2, 3, -3, 4, -4)
        if (form := _arctangent(value, Fraction(eighth, 8))) is not None
    ]
    if candidates:
        return min(candidates, key=_shown)
    with cyclotomic.precision(DIGITS):
        return Degrees(Decimal(value.enclosed().arg() * 180 / arb.pi()))


def _argument(value: Number) -> float:
    """The argument in turns, roughly; of a negative number a half."""
    point = complex(value)
    angle = phase(point) / (2 * pi)
    return abs(angle) if point.imag == 0 else angle


def _arctangent(value: Number, base: Fraction) -> Formula | None:
    """`base` plus the arctangent of something short, where the number lies near `base`.

    Near is within about an eighth of a turn.
    """
    turned = value.turned(-base)
    if value.order > GREATEST_DEGREE or value.height > GREATEST_HEIGHT:
        return None
    down = cyclotomic.real(turned)
    if down.zero or complex(down).real < 0:
        return None
    tangent = _radical(cyclotomic.imaginary(turned) / down)
    if tangent is None or has_long(tangent) or _shown(tangent) > 8:
        return None
    below = written_negative(tangent)
    part = negative(Applied("atan", negative(tangent))) if below else Applied("atan", tangent)
    whole = summed(angle(base), part)
    beyond_half_a_turn = abs(evaluated(whole) / (2 * pi) - _argument(value)) > 1e-9
    return None if beyond_half_a_turn else whole


def _root_of(value: Number) -> Formula | None:
    """The square root of a positive real number, or sqrt(p + q sqrt(d)) = sqrt(u) + sqrt(v)."""
    fraction = value.rational
    if fraction is not None:
        return square_root(fraction)
    others = _conjugates(value)
    if others is None:
        return None
    if len(others) == 2:
        other = others[1][0]
        p, product_of_both = (value + other).rational, (value * other).rational
        if p is not None and product_of_both is not None:
            s = _exact_root(product_of_both)
            if s is not None:
                sign = 1 if complex(value).real > float(p / 2) else -1
                halves = (p / 4 + s / 2, p / 4 - s / 2)
                return summed(square_root(halves[0]), product(sign, square_root(halves[1])))
    inner = _radical(value)
    return None if inner is None else Root(inner)


@remembered
def _radical(value: Number) -> Formula | None:
    """A real number as a tower of square roots, None where there is none or none that is short."""
    fraction = value.rational
    if fraction is not None:
        return number(fraction)
    others = _conjugates(value)
    if others is None or len(others) & (len(others) - 1):
        return None
    towers: list[Formula] = []
    for other, power in others:
        if other == value or other.moved(power) != value:
            continue
        even = (value + other).times(Fraction(1, 2))
        odd = (value - other).times(Fraction(1, 2))
        first, second = _radical(even), _root_of(odd * odd)
        if first is None or second is None or has_long(first) or has_long(second):
            continue
        second = second if complex(odd).real > 0 else negative(second)
        terms = (first, second)
        towers.append(summed(*sorted(terms, key=written_negative)))
    return min(towers, key=_shown, default=None)


def _conjugates(value: Number) -> list[tuple[Number, int]] | None:
    if (
        value.poly.length() > GREATEST_DEGREE
        or value.order > 12 * GREATEST_DEGREE
        or value.height > GREATEST_HEIGHT
    ):
        return None
    others = cyclotomic.conjugates(value, most=GREATEST_TOWER)
    return others if len(others) <= GREATEST_TOWER else None


def over_one_denominator(formula: Formula) -> Formula:
    """A sum of fractions over one denominator, (1 + sqrt(5))/4; squares are taken out of roots."""
    size, rest = coefficient(formula)
    if isinstance(rest, Root) and size != 1:
        return product(size, over_one_denominator(rest))
    if isinstance(formula, Root):
        inner, below = _numerator(formula.radicand)
        common = gcd(*(coefficient(term)[0].numerator for term in terms_of(inner)))
        taken, left = squares(common)
        outside, missing = squares(below)
        above = Root(_over_all(inner, Fraction(left * missing, common)))
        return product(Fraction(taken, outside * missing), above)
    above, below = _numerator(formula)
    return formula if below == 1 or not isinstance(formula, Sum) else Ratio(above, number(below))


def fractions_of(formula: Formula) -> tuple[Formula, ...]:
    """The terms of a sum, each over its denominator: (1 + sqrt(5))/4 is 1/4 and sqrt(5)/4."""
    if isinstance(formula, Ratio) and isinstance(formula.below, Rational):
        return tuple(product(1 / formula.below.value, term) for term in terms_of(formula.above))
    return terms_of(formula)


def _numerator(formula: Formula) -> tuple[Formula, int]:
    """A formula times the least common denominator of its terms, and that denominator."""
    below = lcm(*(coefficient(term)[0].denominator for term in terms_of(formula)))
    return _over_all(formula, Fraction(below)), below


def _over_all(formula: Formula, factor: Fraction) -> Formula:
    return summed(*(product(factor, term) for term in terms_of(formula)))


def _exact_root(value: Fraction) -> Fraction | None:
    if value < 0:
        return None
    root = Fraction(isqrt(value.numerator), isqrt(value.denominator))
    return root if root**2 == value else None
