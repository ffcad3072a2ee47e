"""The resultant of one order: two counter-rotating vectors, the path they draw, and the force of the real engine."""

from __future__ import annotations

from fractions import Fraction
from math import degrees, pi

import numpy as np

from crankstar import phasor
from crankstar.balance import balance, total
from crankstar.derive import cyclotomic, enclosure, wave
from crankstar.derive.cyclotomic import Number
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
from crankstar.derive.records import Line, Step, nth, unit_symbol
from crankstar.derive.task import Task, arm_of
from crankstar.derive.typeset import text
from crankstar.derive.wave import Amount, Wave, at
from crankstar.motion import series_coefficient


def resultant(task: Task, rows: tuple[int, ...], symbols: dict[str, float]) -> Step:
    """The closed forms of the whole engine, the vectors that turn with and against the crank, and their path."""
    forward, backward = task.vectors
    lines = [
        Line(Symbol(task.letter, "up"), (wave.signal(task.up, task.order),), "signal", rows, 0.0, "up"),
        Line(Symbol(task.letter, "right"), (wave.signal(task.right, task.order),), "signal", rows, 90.0, "right"),
    ]
    words, axes = shape(task)
    if task.up or task.right:
        times = f"{float(task.order):g} times as fast as the crank" if task.order != 1 else "as fast as the crank"
        turning = "clockwise" if task.engine.sense > 0 else "counter-clockwise"
        written = "A vector is written as its length ∠ its bearing at θ = 0, clockwise from up, seen from the front."
        ways = f"The first turns with the crank ({turning}), the second against it, both {times}; their sum is the {task.quantity}."
        words += (f"{written} {ways}",)
        lines += [
            Line(Symbol(task.letter, "+"), (wave.vector(forward, symbols),), "forward", rows, label="turning with the crank"),
            Line(Symbol(task.letter, "−"), (wave.vector(backward, symbols),), "backward", rows, label="turning against it"),
        ]
    return Step("The resultant", (*words, *_algebraic([*task.up.values(), *task.right.values()])), tuple(lines + axes))


def shape(task: Task) -> tuple[tuple[str, ...], list[Line]]:
    """What path the vector runs through in a turn, decided exactly where numbers are exact; the axes of an ellipse."""
    forward, backward = task.vectors
    told, couple = nth(task.order, task.quantity), task.quantity == "couple"
    if not forward and not backward:
        return (_nothing(task, told),), []
    first, second = at(forward, task.arms.values), at(backward, task.arms.values)
    if first is not None and second is not None and first.zero and second.zero:
        return (f"There is no {told} with these lengths along the crankshaft: the sum is exactly zero.",), []
    what = "a couple of constant size whose plane turns" if couple else "a force of constant size that turns"
    if not backward or (second is not None and second.zero):
        cure = "Two counterweights at different places on" if couple else "A counterweight on"
        removable = f" {cure} the crankshaft can remove it." if task.order == 1 else ""
        return (f"The {told} is a circle: {what} with the crank.{removable}",), []
    if not forward or (first is not None and first.zero):
        removable = " No counterweight on the crankshaft can touch it." if task.order == 1 else ""
        return (f"The {told} is a circle: {what} against the crank.{removable}",), []
    common = _common_line(forward, backward)
    if common is not None or (first is not None and second is not None and wave.same_length(first, second)):
        towards = _between(*(common or (first, second)))  # pyright: ignore[reportArgumentType]
        in_plane = f"acts in one plane through the crankshaft, {towards}" if couple else f"is a straight line, {towards}"
        return (f"The {told} {in_plane}: two vectors of one length turn against each other.",), []
    if first is None or second is None:
        return (f"The {told} is a sum of parts with different harmonics; its path depends on the lengths of the rods.",), []
    words = f"The {told} is an ellipse, its long axis {_between(first, second)}, run through {_sense(first, second)} the crank."
    if len(forward) > 1 or len(backward) > 1 or set(forward) != set(backward):
        return (words,), []
    return (words,), _axes(task.letter, forward, backward, larger_first=_sense(first, second) == "with")


def _nothing(task: Task, told: str) -> str:
    """Why there is nothing of an order."""
    if task.found.why:
        return f"No {told} that can be told from zero, to {cyclotomic.DIGITS - 5} digits."
    if not task.moving:
        return f"There is no {told}: no part of the engine pushes in this order."
    letters = sorted({symbol.name for body in task.moving for key in arm_of(task.arms, body) for symbol in key})
    lengths = f", whatever {' and '.join(letters)}" if task.quantity == "couple" and letters else ""
    return f"There is no {told}: every sum is exactly zero{lengths}."


def _common_line(forward: Wave, backward: Wave) -> tuple[Amount, Amount] | None:
    """Vectors of each symbol that all make lines of one bearing, whatever the symbols come to; None where they do not."""
    if set(forward) != set(backward):
        return None
    pairs = [(forward[key], backward[key]) for key in forward]
    if not all(wave.same_length(first, second) for first, second in pairs):
        return None
    turns = {wave.turn_of(wave.multiplied_amount(first, second)) for first, second in pairs}
    return pairs[0] if len(pairs) == 1 or (len(turns) == 1 and None not in turns) else None


def _sense(first: Amount, second: Amount) -> str:
    return "with" if abs(first.enclosed()) > abs(second.enclosed()) else "against"


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
    one = wave.turn_of(wave.multiplied_amount(first, second))
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
            out[f"{digits} has no short closed form; its square x is exactly a root of {_polynomial(coefficients)} = 0."] = None
    return list(out)


def _polynomial(coefficients: tuple[int, ...]) -> str:
    x = Symbol("x")
    terms: list[Formula] = []
    for power, value in reversed(list(enumerate(coefficients))):
        if value:
            terms.append(product(value) if power == 0 else product(value, x if power == 1 else Power(x, power)))
    return text(summed(*terms))


def real(task: Task) -> Step:
    """The force or couple of the real engine: the harmonic as a series and exactly, and numbers where they are known."""
    if not task.up and not task.right:
        return Step("The real engine", ("Nothing is left of this order, at any speed.",), ())
    lines: list[Line] = []
    counted = unit_symbol(task.found.harmonic)
    for own, side in ((task.up, "up"), (task.right, "right")):
        if own:
            lines.append(Line(Symbol(task.letter, side), (product(counted, wave.signal(own, task.order)),), "plain", label=side))
    there = {symbol for own in (task.up, task.right) for key in own for symbol in key}
    harmonics = {symbol: one for symbol, one in task.found.values.items() if symbol in there}
    if task.found.harmonic not in (None, 1) and task.found.rod_ratio is not None:
        harmonics[Symbol("A", str(task.found.harmonic))] = (task.found.harmonic, task.found.rod_ratio)
    words = _numbers(task)
    for symbol, (j, ratio) in harmonics.items():
        if j == 1:
            continue
        formula = series(j, task.power, Symbol("lambda"))
        if formula == NOUGHT:
            words.append(f"The series of A_{j} begins with λ to the power {j - 1}: beyond the power {task.power} asked for.")
        else:
            lines.append(Line(symbol, (formula,), "series", label="as a series", series=(j, task.power)))
        ball = enclosure.coefficient(ratio, j)
        told = f"exactly, at λ = r/l = {_ratio_text(1 / ratio)}{_assumed(task)}"
        lines.append(Line(symbol, (Decimal(ball, 12),), "plain", label=told))
    return Step("The real engine", tuple(words), tuple(lines))


def _assumed(task: Task) -> str:
    """Whether the rods' length is only a placeholder in the file."""
    said = task.engine.provenance
    keys = ("cylinder.rod_ratio", "cylinder.rod_length")
    return " (assumed)" if any(key in said and said[key].status == "placeholder" for key in keys) else ""


def _ratio_text(value: Fraction) -> str:
    return str(value) if value.denominator < 1000 else f"{float(value):.6g}"


def series(order: int, power: int, ratio: Symbol, *, inverted: bool = False) -> Formula:
    """A_k as a sum of powers of lambda = r/l, or (inverted) of 1/L, L = l/S, S the stroke; nought where it begins later."""
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


def _numbers(task: Task) -> list[str]:
    """The greatest value over a turn, in newtons where masses, sizes and a speed are known."""
    engine, speed = task.engine, task.speed
    needed = [("mass", "reciprocating mass"), ("radius", "stroke")]
    if task.quantity == "couple":
        needed.append(("pitch", "bore pitch"))
    missing = [word for key, word in needed if key in engine.relative] + ([] if speed is not None else ["speed"])
    unit = "newtons" if task.quantity == "force" else "newton metres"
    if missing or speed is None:
        return [f"For {unit} the engine file would have to give: {', '.join(missing)}."]
    one = phasor.selected(
        getattr(total(balance(engine, speed=speed, reference=task.reference)), task.quantity), [float(task.order)]
    )
    size = abs(complex(one.forward[0])) + abs(complex(one.backward[0]))
    shown = "N" if task.quantity == "force" else "N m"
    return [f"At {speed * 30 / pi:.6g} rpm its greatest value over a turn is {size:.6g} {shown}."]
