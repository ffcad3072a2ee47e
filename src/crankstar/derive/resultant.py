"""The resultant of one order: two counter-rotating vectors, the ellipse they draw, and the force of the real engine."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from math import degrees, pi

import numpy as np

from crankstar import phasor
from crankstar.balance import balance, total
from crankstar.derive import cyclotomic, enclosure, wave
from crankstar.derive.bodies import Bodies
from crankstar.derive.cyclotomic import Number
from crankstar.derive.enclosure import Ball
from crankstar.derive.formula import (
    NOUGHT,
    Decimal,
    Formula,
    Power,
    Ratio,
    Symbol,
    collected,
    enclosed,
    has_decimal,
    negative,
    product,
    summed,
)
from crankstar.derive.radical import gathered
from crankstar.derive.records import Line, Quantity, Step, nth, unit_symbol
from crankstar.derive.typeset import text
from crankstar.derive.wave import Amount, Wave, at
from crankstar.engine import Engine
from crankstar.motion import series_coefficient


def steps(
    letter: str,
    order: Fraction,
    up: Wave,
    right: Wave,
    forward: Wave,
    backward: Wave,
    values: Mapping[Symbol, Fraction],
    *,
    rows: tuple[int, ...],
    why: str,
) -> list[Step]:
    """The closed forms of the whole engine, and their shape."""
    lines = [
        Line(Symbol(letter, "up"), (wave.signal(up, order),), "signal", rows, 0.0, "up"),
        Line(Symbol(letter, "right"), (wave.signal(right, order),), "signal", rows, 90.0, "right"),
    ]
    if up or right:
        lines += [
            Line(Symbol(letter, "+"), (wave.vector(forward),), "forward", rows, label="turning with the crank"),
            Line(Symbol(letter, "−"), (wave.vector(backward),), "backward", rows, label="turning against it"),
        ]
    words, axes = shape(letter, order, forward, backward, values, why=why)
    lines += axes
    notes = _algebraic([*up.values(), *right.values()])
    return [Step("The resultant", (*words, *notes), tuple(lines))]


def shape(
    letter: str, order: Fraction, forward: Wave, backward: Wave, values: Mapping[Symbol, Fraction], *, why: str
) -> tuple[tuple[str, ...], list[Line]]:
    """What path the vector runs through in a turn, decided exactly where numbers are exact; the axes of an ellipse."""
    name = "force" if letter == "F" else "couple"
    told = nth(order, name)
    if not forward and not backward:
        if why:
            return (f"No {told} that can be told from zero, to {cyclotomic.DIGITS - 5} digits.",), []
        lengths = ", whatever the lengths along the crankshaft" if name == "couple" else ""
        return (f"There is no {told}: every sum is exactly zero{lengths}.",), []
    first, second = at(forward, values), at(backward, values)
    if first is None or second is None:
        return (f"The {told} is a sum of parts with different harmonics; its path depends on the lengths of the rods.",), []
    if first.zero and second.zero:
        return (f"There is no {told} with these lengths along the crankshaft: the sum is exactly zero.",), []
    if second.zero:
        removable = " A counterweight on the crankshaft can remove it." if order == 1 else ""
        return (f"The {told} is a circle: a vector of constant length that turns with the crank.{removable}",), []
    if first.zero:
        removable = " No counterweight on the crankshaft can touch it." if order == 1 else ""
        return (f"The {told} is a circle: a vector of constant length that turns against the crank.{removable}",), []
    towards = _between(first, second)
    if wave.same_length(first, second):
        return (f"The {told} is a straight line, {towards}: two vectors of one length turn against each other.",), []
    words = f"The {told} is an ellipse, its long axis {towards}, run through {_sense(first, second)} the crank."
    if len(forward) > 1 or len(backward) > 1 or (any(key for key in (*forward, *backward)) and set(forward) != set(backward)):
        return (words,), []
    return (words,), _axes(letter, forward, backward, larger_first=_sense(first, second) == "with")


def _sense(first: Amount, second: Amount) -> str:
    return "with" if abs(complex(first)) > abs(complex(second)) else "against"


def _axes(letter: str, forward: Wave, backward: Wave, *, larger_first: bool) -> list[Line]:
    """The semi-axes |f| + |b| and ||f| - |b||."""
    (key,) = forward
    one, other = wave.length(forward[key]).formula, wave.length(backward[key]).formula
    if not larger_first:
        one, other = other, one
    long, short = _combined(one, other), _combined(one, negative(other))
    return [
        Line(Symbol(letter, "long"), (product(long, *key),), "plain", label="long semi-axis"),
        Line(Symbol(letter, "short"), (product(short, *key),), "plain", label="short semi-axis"),
    ]


def _combined(one: Formula, other: Formula) -> Formula:
    """A sum in closed form, or, of decimals, as a decimal."""
    found = gathered(collected(one, other))
    return Decimal(enclosed(found)) if has_decimal(found) else found


def _between(first: Amount, second: Amount) -> str:
    """The bearing of the long axis: halfway between the two vectors."""
    both = (
        first * second if isinstance(first, Number) and isinstance(second, Number) else Ball(first.enclosed() * second.enclosed())
    )
    one = wave.turn_of(both)
    turn = None if one is None else (one / 2) % Fraction(1, 2)
    angle = degrees(np.angle(complex(first)) + np.angle(complex(second))) / 2 % 180 if turn is None else float(360 * turn)
    angle = angle - 180 if angle > 90 + 1e-9 else angle
    exact = {0.0: "vertical", 90.0: "horizontal"} if turn is not None else {}
    return exact.get(angle, f"at bearing {angle:.6g}°".replace("-", "−"))


def _algebraic(amounts: list[Amount]) -> list[str]:
    """For magnitudes without a short closed form: their squares' minimal polynomials and more of their digits."""
    out: dict[str, None] = {}
    for amount in amounts:
        found = wave.length(amount)
        if found.exact or not isinstance(amount, Number) or amount.order > 720:
            continue
        square = amount * amount.conjugate
        coefficients = cyclotomic.minimal_polynomial(square)
        if len(coefficients) > 8 or max(map(abs, coefficients)) > 10**12:
            continue
        if isinstance(found.formula, Decimal):
            digits = text(Decimal(found.formula.ball, 20))
            out[
                f"{digits} has no short form in real radicals; its square x is exactly a root of {_polynomial(coefficients)} = 0."
            ] = None
    return list(out)


def _polynomial(coefficients: tuple[int, ...]) -> str:
    x = Symbol("x")
    terms: list[Formula] = []
    for power, value in reversed(list(enumerate(coefficients))):
        if value:
            terms.append(product(value) if power == 0 else product(value, x if power == 1 else Power(x, power)))
    return text(summed(*terms))


def real(engine: Engine, order: Fraction, quantity: Quantity, found: Bodies, up: Wave, right: Wave, *, power: int) -> Step:
    """The force or couple of the real engine: the harmonic as a series and exactly, and numbers where they are known."""
    letter = "F" if quantity == "force" else "M"
    if not up and not right:
        return Step("The real engine", ("Nothing is left of this order, whatever the masses and the speed.",), ())
    lines: list[Line] = []
    counted = unit_symbol(found.harmonic)
    for own, side in ((up, "up"), (right, "right")):
        closed = wave.signal(own, order)
        if own:
            lines.append(Line(Symbol(letter, side), (product(counted, closed),), "plain", label=side))
    harmonics = {} if found.harmonic in (None, 1) else {Symbol("A", str(found.harmonic)): (found.harmonic, found.rod_ratio)}
    for symbol, (j, ratio) in (harmonics | found.values).items():
        if ratio is None or j is None:
            continue
        lines.append(_series(symbol, j, power))
        with cyclotomic.precision(cyclotomic.DIGITS):
            ball = enclosure.coefficient(ratio, j)
        lines.append(Line(symbol, (Decimal(ball, 12),), "plain", label=f"exactly, at λ = r/l = {_ratio_text(1 / ratio)}"))
    return Step("The real engine", tuple(_numbers(engine, order, quantity)), tuple(lines))


def _ratio_text(value: Fraction) -> str:
    return str(value) if value.denominator < 1000 else f"{float(value):.6g}"


def _series(symbol: Symbol, j: int, power: int) -> Line:
    return Line(symbol, (series(j, power, Symbol("lambda")),), "series", label="as a series", series=(j, power))


def series(order: int, power: int, ratio: Symbol, *, inverted: bool = False) -> Formula:
    """A_k as a sum of powers of lambda = r/l, or (inverted) of 1/L, L = l/S, S the stroke."""
    terms: list[Formula] = []
    for exponent in range(power + 1):
        value = series_coefficient(order, exponent)
        if value == 0:
            continue
        letter: Formula = ratio if exponent == 1 else Power(ratio, exponent)
        sign = 1 if value > 0 else -1
        if inverted:
            value = abs(value) / 2**exponent
            terms.append(product(sign, Ratio(product(value.numerator), product(value.denominator, letter))))
        elif value.denominator == 1:
            terms.append(product(value, letter))
        else:
            terms.append(product(sign, Ratio(product(abs(value.numerator), letter), product(value.denominator))))
    return summed(*terms, Symbol("…")) if terms else NOUGHT


def _numbers(engine: Engine, order: Fraction, quantity: Quantity) -> list[str]:
    """The greatest value over a turn, in newtons where masses, sizes and a speed are known."""
    known = {"mass", "radius"}.isdisjoint(engine.relative)
    if engine.speed is None or not known:
        missing = [word for key, word in (("mass", "reciprocating mass"), ("radius", "stroke")) if key in engine.relative]
        if engine.speed is None:
            missing.append("speed")
        return [f"For newtons the engine file would have to give: {', '.join(missing)}."]
    result = balance(engine, speed=engine.speed)
    one = phasor.selected(getattr(total(result), quantity), [float(order)])
    size = abs(complex(one.forward[0])) + abs(complex(one.backward[0]))
    unit = getattr(result.units, quantity).replace("*", " ")
    return [f"At {engine.speed * 30 / pi:.6g} rpm its greatest value over a turn is {size:.6g} {unit}."]
