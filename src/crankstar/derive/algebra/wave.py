"""Real signals of one order, `Re(z exp(i k theta))`, z a linear form with exact numbers.

The symbols are lengths along the crankshaft (bore pitch a, bank offset b, ...) and harmonics A_k of
unequal pistons. A signal is zero for every value of its symbols if and only if all its numbers are
exact zeros.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from fractions import Fraction
from functools import reduce
from math import prod
from typing import NamedTuple

from flint import arb

from crankstar.derive.algebra import cyclotomic, radicals
from crankstar.derive.algebra.cyclotomic import DIGITS, Number
from crankstar.derive.algebra.enclosure import Amount
from crankstar.derive.algebra.evaluation import value as evaluated
from crankstar.derive.algebra.formula import (
    NOUGHT,
    THETA,
    Applied,
    Decimal,
    Degrees,
    Formula,
    Polar,
    Sum,
    Symbol,
    coefficient,
    collected,
    cosine,
    negative,
    number,
    product,
    summed,
)
from crankstar.derive.algebra.formula import angle as part_of_turn

HALF = Fraction(1, 2)
Key = tuple[Symbol, ...]
"""The symbols that stand before a number; none for a plain one."""
Form = Mapping[Key, Fraction]
"""A real linear form with rational coefficients."""
Wave = Mapping[Key, Amount]
"""The complex amplitude of a signal, or a vector, as a linear form."""


def joined(waves: Iterable[Wave]) -> Wave:
    """The sum of signals; numbers that are exactly zero are left out."""
    groups: dict[Key, list[Amount]] = {}
    for wave in waves:
        for key, amount in wave.items():
            groups.setdefault(key, []).append(amount)
    sums = {key: amount_sum(amounts) for key, amounts in groups.items()}
    return {key: sums[key] for key in sorted(sums, key=_names) if not sums[key].zero}


def _names(key: Key) -> list[str]:
    return [symbol.name for symbol in key]


def amount_sum(amounts: Sequence[Amount]) -> Amount:
    """The sum of numbers: exact where all of them are."""
    if not all(isinstance(amount, Number) for amount in amounts):
        return reduce(lambda whole, amount: whole + amount, amounts)
    return cyclotomic.total(amount for amount in amounts if isinstance(amount, Number))


def scaled(wave: Wave, form: Form) -> Wave:
    """A signal times a real linear form."""
    pieces = [
        {_together(key, other): amount.times(factor)}
        for key, amount in wave.items()
        for other, factor in form.items()
    ]
    return joined(pieces)


def _together(first: Key, second: Key) -> Key:
    return tuple(sorted((*first, *second), key=lambda symbol: symbol.name))


def multiplied(wave: Wave, amount: Amount) -> Wave:
    """A signal times a number."""
    return joined([{key: value * amount for key, value in wave.items()}])


def same_length(first: Amount, second: Amount) -> bool:
    """Whether two numbers have one magnitude."""
    return (first * first.conjugate + -(second * second.conjugate)).zero


def conjugated(wave: Wave) -> Wave:
    """The complex conjugate, symbols being real."""
    return {key: amount.conjugate for key, amount in wave.items()}


def vectors(up: Wave, right: Wave, *, sense: int) -> tuple[Wave, Wave]:
    """The vectors f, b that turn with the crank and against it.

    `up + i right = f exp(i s k theta) + b exp(-i s k theta)`.
    """
    quarter = cyclotomic.root(Fraction(1, 4)).times(HALF)
    first, second = (
        joined([scaled(vertical, {(): HALF}), multiplied(aside, quarter)])
        for vertical, aside in ((up, right), (conjugated(up), conjugated(right)))
    )
    return (first, second) if sense > 0 else (second, first)


def length(amount: Amount) -> Formula:
    """The magnitude of a number."""
    if isinstance(amount, Number):
        return radicals.length(amount)
    with cyclotomic.precision(DIGITS):
        return Decimal(abs(amount.value))


def bearing(amount: Amount) -> Formula:
    """The argument of a number other than zero."""
    if isinstance(amount, Number):
        return radicals.bearing(amount)
    turn = turn_of(amount)
    if turn is not None:
        return part_of_turn(turn)
    with cyclotomic.precision(DIGITS):
        return Degrees(Decimal(amount.value.arg() * 180 / arb.pi()))


def turn_of(amount: Amount) -> Fraction | None:
    """The argument in turns: proved for an exact number; for a ball, the quarter turn it holds."""
    if isinstance(amount, Number):
        return radicals.bearing_turn(amount)
    if amount.value.imag.contains(0):
        return Fraction(0) if amount.value.real > 0 else HALF
    if amount.value.real.contains(0):
        return Fraction(1, 4) if amount.value.imag > 0 else Fraction(-1, 4)
    return None


class Piece(NamedTuple):
    """One cosine of a closed form.

    `size cos(k theta + phase)`, the size a formula with its symbols.
    """

    size: Formula
    phase: Fraction | None
    angle: Formula


def pieces(wave: Wave) -> list[Piece]:
    """A signal as few cosines: what has the same phase, or the opposite one, in one piece."""
    out: list[Piece] = []
    for key, amount in wave.items():
        size, turn, angle = product(length(amount), *key), turn_of(amount), bearing(amount)
        place = next((i for i, piece in enumerate(out) if _parallel(piece, turn, angle)), None)
        if place is not None:
            piece = out[place]
            signed = size if turn == piece.phase else negative(size)
            out[place] = piece._replace(size=collected(piece.size, signed))
        elif turn == HALF:
            out.append(Piece(negative(size), Fraction(0), NOUGHT))
        else:
            out.append(Piece(size, turn, angle))
    return out


def _parallel(piece: Piece, turn: Fraction | None, angle: Formula) -> bool:
    if turn is None or piece.phase is None:
        return turn is piece.phase and piece.angle == angle and not isinstance(angle, Degrees)
    return (turn - piece.phase) % HALF == 0


def signal(wave: Wave, order: Fraction) -> Formula:
    """A signal in closed form: `4 sqrt(2) cos 2 theta`."""
    return summed(*(written(piece, product(order, THETA)) for piece in pieces(wave)))


def written(piece: Piece, inside: Formula) -> Formula:
    """One cosine of `inside + phase`; a quarter of a turn on or back it is a sine."""
    if piece.phase is not None and abs(piece.phase) == Fraction(1, 4):
        return product(-1 if piece.phase > 0 else 1, piece.size, Applied("sin", inside))
    return product(piece.size, cosine(summed(inside, piece.angle)))


def phased(order: Fraction, angle: Formula) -> Formula:
    """K theta + angle."""
    return summed(product(order, THETA), angle)


def vector(wave: Wave, values: Mapping[str, float] | None = None) -> Formula:
    """A vector in closed form: its length and bearing, symbol by symbol.

    Lengths are positive at these values of the symbols.
    """
    parts = []
    for piece in pieces(wave):
        size, angle = piece.size, piece.angle
        below = coefficient(size)[0] < 0 if values is None else evaluated(size, values) < 0
        if below:
            size, angle = negative(size), _opposite(piece)
        parts.append(Polar(size, angle))
    return summed(*parts)


def _opposite(piece: Piece) -> Formula:
    """The angle half a turn from that of a piece."""
    if piece.phase is None:
        return summed(piece.angle, part_of_turn(HALF))
    return part_of_turn(HALF - -piece.phase % 1)


def counted(vector: Formula, *units: Formula) -> Formula:
    """A vector times units, which stand before its lengths."""
    if isinstance(vector, Polar):
        return Polar(product(*units, vector.length), vector.angle)
    if isinstance(vector, Sum):
        return Sum(tuple(counted(term, *units) for term in vector.terms))
    return product(*units, vector)


def form(weights: Form) -> Formula:
    """A linear form as a formula: 1.5 a + b/2."""
    ordered = sorted(weights.items(), key=lambda item: _names(item[0]))
    terms = [product(factor, *key) for key, factor in ordered if factor]
    return summed(*terms) if terms else number(0)


def form_sum(forms: Iterable[tuple[Fraction, Form]]) -> Form:
    """A sum of rational multiples of linear forms."""
    out: dict[Key, Fraction] = {}
    for factor, weights in forms:
        for key, value in weights.items():
            out[key] = out.get(key, Fraction(0)) + factor * value
    return {key: value for key, value in out.items() if value}


def at(wave: Wave, values: Mapping[Symbol, Fraction]) -> Amount | None:
    """The number a wave comes to at exact values of all its symbols, None where one has none."""
    if not all(symbol in values for key in wave for symbol in key):
        return None
    parts = [
        amount.times(prod((values[symbol] for symbol in key), start=Fraction(1)))
        for key, amount in wave.items()
    ]
    return amount_sum(parts)
