"""Exact complex numbers: sums of q exp(2 pi i t), q and t rational.

They form the cyclotomic fields Q(zeta_N), zeta_N = exp(2 pi i/N). A number of Q(zeta_N) is kept as
a polynomial in zeta_N reduced by the cyclotomic polynomial Phi_N, which is unique: it is zero if
and only if all its coefficients are. No tolerance is used anywhere.

Source: L. C. Washington, Introduction to Cyclotomic Fields, chapter 2 (the degree of Q(zeta_N) is
phi(N), Phi_N is irreducible, the conjugates are zeta -> zeta^t with t prime to N).
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from contextlib import contextmanager
from fractions import Fraction
from functools import lru_cache, wraps
from math import gcd, lcm
from typing import TypeVar

import flint
import numpy as np
from flint import acb, acb_poly, arb, fmpq, fmpq_poly, fmpz_poly

T = TypeVar("T")
REMEMBERED = 4096
"""Answers of a function that are kept."""
DIGITS = 50
"""Decimal digits to which numbers are enclosed unless more are asked for."""


@contextmanager
def precision(digits: int):
    """Ball arithmetic with so many decimal digits, and a reserve."""
    before = flint.ctx.prec
    flint.ctx.prec = int(digits * 3.33) + 40
    try:
        yield
    finally:
        flint.ctx.prec = before


@lru_cache(maxsize=256)
def _modulus(order: int) -> fmpq_poly:
    return fmpq_poly(fmpz_poly.cyclotomic(order))


class Number:
    """An exact number of Q(zeta_N); immutable, compared by value."""

    __slots__ = ("_key", "order", "poly")

    def __init__(self, order: int, poly: fmpq_poly) -> None:
        self.order = order
        self.poly = poly % _modulus(order)
        self._key: tuple[int, str] | None = None

    def __add__(self, other: Number) -> Number:
        if not isinstance(other, Number):
            return NotImplemented
        first, second = _together(self, other)
        return Number(first.order, first.poly + second.poly)

    def __sub__(self, other: Number) -> Number:
        return self + -other

    def __neg__(self) -> Number:
        return Number(self.order, -self.poly)

    def __mul__(self, other: Number) -> Number:
        if not isinstance(other, Number):
            return NotImplemented
        first, second = _together(self, other)
        return Number(first.order, first.poly * second.poly)

    def __truediv__(self, other: Number) -> Number:
        """The quotient; ZeroDivisionError by an exact zero."""
        if other.zero:
            raise ZeroDivisionError("division by an exact zero")
        _, inverse, _ = other.poly.xgcd(_modulus(other.order))
        return self * Number(other.order, inverse)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Number) and (self - other).zero

    # equal numbers may be written in different fields
    __hash__ = None  # pyright: ignore[reportAssignmentType]

    def __repr__(self) -> str:
        return f"Number({self.order}, {self.poly})"

    @property
    def key(self) -> tuple[int, str]:
        """What tells this number from all others that are written in the same field."""
        if self._key is None:
            self._key = (self.order, str(self.poly.coeffs()))
        return self._key

    @property
    def height(self) -> int:
        """The greatest whole number in the coefficients, above or below the line."""
        return max(
            (max(abs(int(value.p)), int(value.q)) for value in self.poly.coeffs()), default=0
        )

    @property
    def content(self) -> Fraction:
        """The rational factor without which the coefficients are whole and have no common one."""
        values = [value for value in self.poly.coeffs() if value != 0]
        if not values:
            return Fraction(1)
        below = lcm(*(int(value.q) for value in values))
        return Fraction(gcd(*(int(value.p) * (below // int(value.q)) for value in values)), below)

    @property
    def zero(self) -> bool:
        """Whether the number is zero: decided, not estimated."""
        return self.poly.is_zero()

    @property
    def conjugate(self) -> Number:
        """The complex conjugate."""
        return self.moved(-1)

    @property
    def rational(self) -> Fraction | None:
        """The number as a fraction, None if it is not rational."""
        return _fraction(self.poly[0]) if self.poly.degree() <= 0 else None

    def times(self, factor: Fraction | int) -> Number:
        """The number times a rational one."""
        factor = Fraction(factor)
        return Number(self.order, self.poly * fmpq(factor.numerator, factor.denominator))

    def turned(self, turn: Fraction) -> Number:
        """The number turned by a part of a full turn."""
        return self * root(turn)

    def moved(self, power: int) -> Number:
        """The conjugate that zeta -> zeta^power makes; power must be prime to N."""
        coefficients = [fmpq(0)] * self.order
        for exponent, value in enumerate(self.poly.coeffs()):
            coefficients[exponent * power % self.order] = value
        return Number(self.order, fmpq_poly(coefficients))

    def enclosed(self) -> acb:
        """A ball that holds the number, at the precision in force."""
        real, imaginary = arb(0), arb(0)
        for exponent, value in enumerate(self.poly.coeffs()):
            if value:
                angle = fmpq(2 * exponent, self.order)
                real += arb(value) * arb.cos_pi_fmpq(angle)
                imaginary += arb(value) * arb.sin_pi_fmpq(angle)
        return acb(real, imaginary)

    def __complex__(self) -> complex:
        with precision(30):
            ball = self.enclosed()
            return complex(float(ball.real.mid()), float(ball.imag.mid()))


def rational(value: Fraction | int) -> Number:
    """A rational number."""
    value = Fraction(value)
    return Number(1, fmpq_poly([fmpq(value.numerator, value.denominator)]))


ZERO = rational(0)


@lru_cache(maxsize=4096)
def root(turn: Fraction) -> Number:
    """exp(2 pi i turn).

    >>> third, eighth = Fraction(1, 3), Fraction(1, 8)
    >>> (root(eighth) * root(-eighth)).rational, (root(third) + root(-third)).rational
    (Fraction(1, 1), Fraction(-1, 1))
    """
    turn = Fraction(turn) % 1
    return Number(turn.denominator, fmpq_poly([0] * turn.numerator + [1]))


@lru_cache(maxsize=4096)
def cosine(turn: Fraction) -> Number:
    """cos(2 pi turn)."""
    return (root(turn) + root(-turn)).times(Fraction(1, 2))


@lru_cache(maxsize=4096)
def sine(turn: Fraction) -> Number:
    """sin(2 pi turn)."""
    return cosine(turn - Fraction(1, 4))


def total(numbers: Iterable[Number]) -> Number:
    """The sum of numbers, taken in their common field at once."""
    numbers = list(numbers)
    order = lcm(*(number.order for number in numbers)) if numbers else 1
    return Number(order, sum((_lifted(number, order).poly for number in numbers), fmpq_poly([0])))


def real(number: Number) -> Number:
    """The real part."""
    return (number + number.conjugate).times(Fraction(1, 2))


def imaginary(number: Number) -> Number:
    """The imaginary part, a real number."""
    return ((number - number.conjugate) * root(Fraction(-1, 4))).times(Fraction(1, 2))


def conjugates(number: Number, *, most: int | None = None) -> list[tuple[Number, int]]:
    """All numbers with the same minimal polynomial, itself first, each with its power of zeta.

    zeta -> zeta^power makes it. Where there are more than `most`, only `most` + 1 are given.
    """
    distinct: dict[tuple[int, str], tuple[Number, int]] = {}
    for power in range(1, max(number.order, 2)):
        if most is not None and len(distinct) > most:
            break
        if gcd(power, number.order) == 1:
            moved = number.moved(power)
            distinct.setdefault(moved.key, (moved, power))
    return list(distinct.values())


def remembered(function: Callable[[Number], T]) -> Callable[[Number], T]:
    """The function with a memory of its last answers, by how the number is written."""
    answers: dict[tuple[int, str], T] = {}

    @wraps(function)
    def asked(number: Number) -> T:
        if number.key not in answers:
            if len(answers) >= REMEMBERED:
                answers.pop(next(iter(answers)))
            answers[number.key] = function(number)
        return answers[number.key]

    return asked


def minimal_polynomial(number: Number) -> tuple[int, ...]:
    """The polynomial of least degree with this root.

    Its whole coefficients, constant first and without a common factor.

    >>> minimal_polynomial(cosine(Fraction(1, 7)))
    (-1, -4, 4, 8)
    """
    scale = int(number.poly.denom())
    whole = number.times(scale)
    others = [other for other, _ in conjugates(whole)]
    size = 1 + sum(abs(int(value)) for value in whole.poly.coeffs())
    # Elementary symmetric functions of algebraic integers are whole numbers: a ball with one whole
    # number in it proves it.
    with precision(int(len(others) * np.log10(2.0 * size)) + 20):
        terms = acb_poly.from_roots([other.enclosed() for other in others]).coeffs()
        coefficients = [_whole(term.real) * scale**power for power, term in enumerate(terms)]
    common = gcd(*coefficients)
    return tuple(value // common for value in coefficients)


def _whole(ball: arb) -> int:
    """The one whole number in a ball."""
    whole = ball.unique_fmpz()
    if whole is None:
        raise ArithmeticError("a ball is too wide to hold one whole number only")
    return int(whole)


@lru_cache(maxsize=64)
def reduction(order: int) -> np.ndarray:
    """The whole numbers [order, phi(order)] that reduce a sum of roots of unity.

    Row t is zeta^t in powers 0 ... phi - 1.

    A sum `coefficients @ reduction(order)` of rational multiples of zeta^0 ... zeta^(order - 1) is
    zero if and only if the product is: this decides whole batches of sums at once, exactly, in
    whole numbers.

    >>> bool(np.any(np.array([1, 0, 1, 0, 1, 0]) @ reduction(6)))  # three vectors 120 deg apart
    False
    """
    modulus = _modulus(order)
    rows = np.zeros((order, modulus.degree()), dtype=np.int64)
    for power in range(order):
        for index, value in enumerate((fmpq_poly([0] * power + [1]) % modulus).coeffs()):
            rows[power, index] = int(value.p)
    return rows


def vanishing(coefficients: np.ndarray) -> np.ndarray:
    """Which sums over t of coefficients[..., t] exp(2 pi i t/N) are exactly zero [...].

    The coefficients are whole numbers, N of them in each sum.
    """
    values = np.asarray(coefficients)
    if values.dtype.kind not in "iuO":
        raise TypeError("exact zeros are decided for whole coefficients only; scale them first")
    if values.dtype.kind == "u":
        values = values.astype(object)
    table = reduction(values.shape[-1])
    if values.dtype.kind != "O" and values.size:
        bound = int(np.abs(values).max()) * int(np.abs(table).sum(axis=0).max())
        if bound >= 2**62:
            values = values.astype(object)
    return ~np.any(values @ (table.astype(object) if values.dtype.kind == "O" else table), axis=-1)


def _lifted(number: Number, order: int) -> Number:
    if number.order == order:
        return number
    step = order // number.order
    coefficients = [fmpq(0)] * order
    for exponent, value in enumerate(number.poly.coeffs()):
        coefficients[exponent * step] = value
    return Number(order, fmpq_poly(coefficients))


def _together(first: Number, second: Number) -> Sequence[Number]:
    order = lcm(first.order, second.order)
    return _lifted(first, order), _lifted(second, order)


def _fraction(value: fmpq) -> Fraction:
    return Fraction(int(value.p), int(value.q))
