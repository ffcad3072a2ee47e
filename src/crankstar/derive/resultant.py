"""The resultant of one order: two counter-rotating vectors, and the path they draw."""

from __future__ import annotations

from collections.abc import Sequence
from math import degrees

import numpy as np

from crankstar.derive.algebra import cyclotomic, wave
from crankstar.derive.algebra.cyclotomic import Number
from crankstar.derive.algebra.evaluation import enclosed
from crankstar.derive.algebra.formula import (
    Decimal,
    Formula,
    Power,
    Symbol,
    collected,
    has_decimal,
    product,
    summed,
)
from crankstar.derive.algebra.radicals import fractions_of, over_one_denominator
from crankstar.derive.algebra.typeset import text
from crankstar.derive.algebra.wave import Amount, Wave, at
from crankstar.derive.records import Kind, Line, Step
from crankstar.derive.task import Task, arm_of, degrees_text, rows, sides
from crankstar.engine.motion import first_harmonic
from crankstar.language.messages import N_, _, passage
from crankstar.language.numbers import NEGLIGIBLE

KINDS: tuple[Kind, Kind] = ("forward", "backward")
LINES = {
    "force": (
        N_("The force acts along a straight line."),
        N_("The line is vertical."),
        N_("The line is horizontal."),
        N_("The line is at bearing {angle}."),
    ),
    "couple": (
        N_("The couple acts in one plane through the crankshaft."),
        N_("The plane is vertical."),
        N_("The plane is horizontal."),
        N_("The plane is at bearing {angle}."),
    ),
}
ELLIPSE = (
    N_("Its major axis is vertical."),
    N_("Its major axis is horizontal."),
    N_("Its major axis is at bearing {angle}."),
)


def resultant(task: Task, symbols: dict[str, float]) -> Step:
    """The closed forms of the whole engine, its two vectors, and their path."""
    lines = sides(task, "", task.moving)
    words, axes = shape(task)
    if any(task.push):
        words += (_vectors(task),)
        labels = (_("turning with the crank"), _("turning against it"))
        for sign, kind, label, own in zip("+−", KINDS, labels, task.vectors, strict=True):
            vector = (wave.vector(own, symbols),)
            name, every = Symbol(task.letter, sign), rows(task.moving)
            lines.append(Line(name, vector, kind, every, label=label))
    words = (*words, *_algebraic([amount for side in task.push for amount in side.values()]))
    return Step(_("The resultant"), words, tuple(lines + axes))


def _vectors(task: Task) -> str:
    """How the two vectors are written, and how they turn."""
    written = _("Vectors: length ∠ bearing at θ = 0, clockwise from up, seen from the front.")
    if task.order == 1:
        speed = _("Both turn at crank speed.")
    else:
        speed = _("Both turn at {order} times crank speed.", order=f"{float(task.order):g}")
    if task.engine.sense > 0:
        senses = _("The first vector turns with the crank, clockwise, the second against it.")
    else:
        senses = _(
            "The first vector turns with the crank, counter-clockwise, the second against it."
        )
    whole = _("Their sum is the force.")
    if task.quantity == "couple":
        whole = _("Their sum is the couple.")
    harmonic = first_harmonic(task.engine, float(task.order))
    if harmonic.real < 0 and abs(harmonic.imag) <= NEGLIGIBLE * abs(harmonic):
        whole += " " + _(
            "A_{order} is negative, so that the actual vectors point the opposite way.",
            order=f"{float(task.order):g}",
        )
    return f"{written} {senses} {speed} {whole}"


def shape(task: Task) -> tuple[tuple[str, ...], list[Line]]:
    """What path the vector runs through in a turn, decided exactly where numbers are exact.

    The axes of an ellipse.
    """
    forward, backward = task.vectors
    if not forward and not backward:
        return (_nothing(task),), []
    first, second = at(forward, task.arms.values), at(backward, task.arms.values)
    if first is not None and second is not None and first.zero and second.zero:
        words = _(
            "With these lengths along the crankshaft the sum is exactly zero: no couple of "
            "this order remains."
        )
        return (words,), []
    for vector, at_places, with_crank in ((backward, second, True), (forward, first, False)):
        if not vector or (at_places is not None and at_places.zero):
            return (_circle(task, with_crank=with_crank),), []
    common = _common_line(forward, backward)
    if common is None and first is not None and second is not None:
        common = (first, second) if wave.same_length(first, second) else None
    if common is not None:
        line, *bearings = LINES[task.quantity]
        why = _("Its two vectors are equally long and turn in opposite directions.")
        return (passage((_(line), _bearing(*common, bearings), why)),), []
    if first is None or second is None:
        words = _(
            "The sum has parts with different harmonics; its path depends on the lengths of "
            "the rods."
        )
        return (words,), []
    larger_first = abs(first.enclosed()) > abs(second.enclosed())
    path = _("The path is an ellipse, traversed in the direction of rotation of the crank.")
    if not larger_first:
        path = _("The path is an ellipse, traversed against the rotation of the crank.")
    words = passage((path, _bearing(first, second, ELLIPSE)))
    if len(forward) > 1 or len(backward) > 1 or set(forward) != set(backward):
        return (words,), []
    return (words,), _axes(task.letter, forward, backward, larger_first=larger_first)


def _circle(task: Task, *, with_crank: bool) -> str:
    """A circle, which a counterweight can take away where it turns as the crank does."""
    path, cure = _CIRCLES[task.quantity, with_crank]
    return passage((_(path), _(cure))) if task.order == 1 else _(path)


_NO_CURE = N_("No counterweight on the crankshaft can reduce it.")
_CIRCLES = {
    ("couple", True): (
        N_("The path is a circle: a couple of constant size whose plane turns with the crank."),
        N_("Two counterweights in different planes of the crankshaft can balance it."),
    ),
    ("force", True): (
        N_("The path is a circle: a force of constant size that turns with the crank."),
        N_("A counterweight on the crankshaft can balance it."),
    ),
    ("couple", False): (
        N_("The path is a circle: a couple of constant size whose plane turns against the crank."),
        _NO_CURE,
    ),
    ("force", False): (
        N_("The path is a circle: a force of constant size that turns against the crank."),
        _NO_CURE,
    ),
}


def _nothing(task: Task) -> str:
    """Why there is nothing of an order."""
    force = task.quantity == "force"
    if task.bodies.why:
        none = (
            N_("No couple of this order can be distinguished from zero."),
            N_("No force of this order can be distinguished from zero."),
        )
        return _(none[force])
    if force:
        if not task.moving:
            return _("There is no force of this order: no part of the engine exerts one.")
        return _("There is no force of this order: every sum is exactly zero.")
    if not task.moving:
        return _("There is no couple of this order: no force of this order acts.")
    letters = sorted(
        {symbol.name for body in task.moving for key in arm_of(task.arms, body) for symbol in key}
    )
    if not letters:
        return _("There is no couple of this order: every sum is exactly zero.")
    return _(
        "There is no couple of this order: every sum is exactly zero, whatever the length of "
        "{letters}.",
        letters=", ".join(letters),
    )


def _common_line(forward: Wave, backward: Wave) -> tuple[Amount, Amount] | None:
    """Vectors of each symbol that all make lines of one bearing, whatever the symbols come to.

    None where they do not.
    """
    if set(forward) != set(backward):
        return None
    pairs = [(forward[key], backward[key]) for key in forward]
    if not all(wave.same_length(first, second) for first, second in pairs):
        return None
    turns = {wave.turn_of(first * second) for first, second in pairs}
    return pairs[0] if len(pairs) == 1 or (len(turns) == 1 and None not in turns) else None


def _axes(letter: str, forward: Wave, backward: Wave, *, larger_first: bool) -> list[Line]:
    """The semi-axes |f| + |b| and ||f| - |b||."""
    (key,) = forward
    greater, smaller = wave.length(forward[key]), wave.length(backward[key])
    if not larger_first:
        greater, smaller = smaller, greater
    long, short = (_combined(greater, smaller, sign) for sign in (1, -1))
    return [
        Line(Symbol(letter, "long"), (product(long, *key),), label=_("semi-major axis")),
        Line(Symbol(letter, "short"), (product(short, *key),), label=_("semi-minor axis")),
    ]


def _combined(first: Formula, second: Formula, sign: int) -> Formula:
    """First plus or minus second in closed form, or, of decimals, as a decimal."""
    seconds = (product(sign, term) for term in fractions_of(second))
    whole = over_one_denominator(collected(*fractions_of(first), *seconds))
    return Decimal(enclosed(whole, {})) if has_decimal(whole) else whole


def _bearing(first: Amount, second: Amount, sentences: Sequence[str]) -> str:
    """The bearing of a line, or of the long axis: halfway between the two vectors."""
    turn = wave.turn_of(first * second)
    angle = (
        degrees(np.angle(complex(first)) + np.angle(complex(second))) / 2 % 180
        if turn is None
        else float(360 * ((turn / 2) % wave.HALF))
    )
    angle = angle - 180 if angle > 90 + 1e-9 else angle
    vertical, horizontal, between = sentences
    if turn is not None and angle == 0:
        return _(vertical)
    if turn is not None and angle == 90:
        return _(horizontal)
    return _(between, angle=degrees_text(angle))


def _algebraic(amounts: list[Amount]) -> list[str]:
    """For magnitudes without a short closed form: the minimal polynomials of their squares."""
    out: dict[str, None] = {}
    for amount in amounts:
        size = wave.length(amount)
        if not isinstance(size, Decimal) or not isinstance(amount, Number) or amount.order > 720:
            continue
        coefficients = cyclotomic.minimal_polynomial(amount * amount.conjugate)
        if len(coefficients) > 8 or max(map(abs, coefficients)) > 10**12:
            continue
        sentence = _(
            "{number} has no short closed form; its square x is exactly a root of "
            "{polynomial} = 0.",
            number=text(Decimal(size.ball, 20)),
            polynomial=_polynomial(coefficients),
        )
        out[sentence] = None
    return list(out)


def _polynomial(coefficients: tuple[int, ...]) -> str:
    x = Symbol("x")
    terms = [
        product(value, *([x] if power == 1 else [Power(x, power)] if power else []))
        for power, value in reversed(list(enumerate(coefficients)))
        if value
    ]
    return text(summed(*terms))
