"""What every step of a derivation knows, and the lines they have in common."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from fractions import Fraction
from math import radians
from typing import NamedTuple

from crankstar.derive import cyclotomic, enclosure, positions, wave
from crankstar.derive.bodies import Bodies, Body
from crankstar.derive.formula import Decimal, Formula, Symbol, number, product
from crankstar.derive.gather import sum_as_product
from crankstar.derive.radical import closed
from crankstar.derive.records import Line, Quantity
from crankstar.derive.typeset import text
from crankstar.derive.wave import Form, Wave
from crankstar.engine import Engine


class Task(NamedTuple):
    """What all steps know: the engine, the order, the letter of the quantity, the parts and their arms."""

    engine: Engine
    order: Fraction
    quantity: Quantity
    letter: str
    found: Bodies
    moving: tuple[Body, ...]
    arms: positions.Arms


def arm_of(arms: positions.Arms, body: Body) -> Form:
    """How far in front of the reference plane a part stands."""
    number = body.crank_end_of if body.cylinder is None else body.cylinder
    if number is not None:
        return arms.cylinder[number]
    return (arms.weight if body.name.startswith("weight") else arms.throw)[body.shaft, body.place]


def rows(moving: Sequence[Body]) -> tuple[int, ...]:
    """The rows of a Balance that the parts account for; none where a row is shared with a part that is not among them."""
    found = Counter((row, body.sharing) for body in moving for row in body.rows)
    if any(count < sharing for (_, sharing), count in found.items()):
        return ()
    return tuple(row for row, _ in found)


def degrees_text(value: float) -> str:
    """An angle in degrees as a reader sees it."""
    return f"{value:.6g}°".replace("-", "−")


def arm_text(form: Form) -> str:
    """An arm as a linear form in a and b."""
    return text(wave.form(form))


def sides(task: Task, name: str, up: Wave, right: Wave, rows: tuple[int, ...], label: str) -> list[Line]:
    """A push as its parts up and to the right."""
    sides = ((up, "up", 0.0), (right, "right", 90.0))
    return [
        Line(Symbol(task.letter, f"{name}, {side}"), (wave.signal(own, task.order),), "signal", rows, bearing, f"{label}, {side}")
        for own, side, bearing in sides
    ]


def share(body: Body, *, up: bool) -> Formula:
    """What part of a push along a cylinder goes up, or to the right: the cosine or the sine of its bearing."""
    if body.bearing is None:
        return _decimal_share(body.bearing_deg, up=up)
    return closed((cyclotomic.cosine if up else cyclotomic.sine)(body.bearing)).formula


def _decimal_share(bearing_deg: float, *, up: bool) -> Formula:
    with cyclotomic.precision(cyclotomic.DIGITS):
        axis = enclosure.angle_of(radians(bearing_deg))
        return Decimal(axis.real if up else axis.imag)


def paired(parts: Sequence[tuple[Formula, Wave]], order: Fraction) -> list[Formula]:
    """Two signals of one size as a product of cosines, where that shows more than the sum."""
    pieces = [(factor, piece) for factor, own in parts for piece in wave.pieces(own) if factor != number(0)]
    if len(pieces) != 2:
        return []
    sizes = [product(factor, piece.size) for factor, piece in pieces]
    phases = [piece.phase for _, piece in pieces]
    if phases[0] is None or phases[1] is None:
        return []
    first, second = sizes
    p, q = phases[0], phases[1]
    if first == product(-1, second):
        second, q = first, q + Fraction(1, 2)
    return [sum_as_product(first, p, q, order)] if first == second and (p - q) % 1 != 0 else []
