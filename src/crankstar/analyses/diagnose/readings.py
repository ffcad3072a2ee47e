"""Readings of vibration from a list: amplitude and phase by order, place and direction."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal, NamedTuple

import numpy as np

from crankstar.engine.engine import Engine
from crankstar.engine.quantities import ANGLE, LENGTH, SPEED
from crankstar.files.columns import Columns
from crankstar.files.lists import Listed, Row
from crankstar.files.vibrations import vibration_of
from crankstar.language.messages import _
from crankstar.mechanics.occurring_orders import OrderError, check_orders

Axis = Literal["up", "right", "z"]
AXES: tuple[Axis, ...] = ("up", "right", "z")
GREATEST_ORDER = 1000.0
HEADS = {
    "order": "order",
    "up": "up",
    "right": "right",
    "z": "z",
    "along": "z",
    "direction": "direction",
    "axis": "direction",
    "amplitude": "amplitude",
    "phase": "phase",
    "speed": "speed",
    "error": "error",
}


class Reading(NamedTuple):
    """A line of a measurement: crank order, place (up, right, z), axis, velocity (m/s, complex).

    `error` is the standard error of the velocity, m/s, 0 where the list gives none.
    """

    order: float
    place: tuple[float, float, float]
    axis: int
    velocity: complex
    speed: float
    line: int
    error: float = 0.0


def readings_of(listed: Listed, engine: Engine, *, speed: float | None) -> tuple[Reading, ...]:
    """The readings of a list about an engine, at a speed (rad/s) unless it has its own.

    Raises ListError with every mistake.
    """
    columns = Columns(listed, HEADS, needed=("order", "direction", "amplitude", "phase"))
    if "speed" not in columns and speed is None:
        columns.refuse_list(
            _("there is no column speed; add it, or give --speed, or speed in the engine file")
        )
    found = [_reading(columns, row, engine, speed) for row in columns.rows]
    _refuse_twice(columns, found)
    columns.check()
    return tuple(found)


def _refuse_twice(columns: Columns, found: Sequence[Reading]) -> None:
    """Note a reading that a line above it has too, value and all: it is one, not two.

    Two of them would halve the variance of what they are of; two measurements differ.
    """
    lines: dict[tuple[object, ...], int] = {}
    for row, each in zip(columns.rows, found, strict=True):
        sizes = (each.order, *each.place, each.speed, each.velocity.real, each.velocity.imag)
        key = (each.axis, *(f"{size:.9e}" for size in sizes))
        if lines.setdefault(key, row.line) != row.line and not np.isnan(sizes).any():
            columns.refuse(
                row,
                "order",
                _(
                    "this reading stands twice, value and all, first in line {line}; leave it out",
                    line=lines[key],
                ),
            )


def _reading(columns: Columns, row: Row, engine: Engine, speed: float | None) -> Reading:
    """A line; what is mistaken in it is noted, and nan."""
    order = _order(columns, row, engine)
    up, right, z = (
        columns.value(row, name, LENGTH, usual="mm") if name in columns else 0.0 for name in AXES
    )
    own = columns.value(row, "speed", SPEED) if "speed" in columns else speed or np.nan
    if own <= 0:
        columns.refuse(row, "speed", _("the speed must be greater than 0"))
        own = np.nan
    word = columns.text(row, "direction").lower()
    word = {"vertical": "up", "horizontal": "right", "axial": "z", "along": "z"}.get(word, word)
    sign = -1.0 if word in ("down", "left") else 1.0
    word = {"down": "up", "left": "right"}.get(word, word)
    axis = AXES.index(word) if word in AXES else -1
    if axis < 0 and "direction" in columns:
        columns.refuse(row, "direction", _("give up, down, right, left or z"))
    size, rate = vibration_of(columns, row, "amplitude")
    phase = columns.value(row, "phase", ANGLE, usual="deg")
    velocity = sign * size * (1j * order * own) ** (1 - rate) * np.exp(1j * phase)
    error = _error(columns, row, order * own) if "error" in columns else 0.0
    return Reading(order, (up, right, z), axis, complex(velocity), own, row.line, error)


def _error(columns: Columns, row: Row, frequency: float) -> float:
    """The standard error of a reading at an angular frequency, m/s; nan where it is mistaken."""
    size, rate = vibration_of(columns, row, "error")
    if size == 0:
        columns.refuse(row, "error", _("the error must be greater than 0"))
        return np.nan
    return float(size * frequency ** (1 - rate))


def _order(columns: Columns, row: Row, engine: Engine) -> float:
    """The order of a line; one that the engine cannot have is noted, its file having gas or not."""
    order = columns.number(row, "order")
    if np.isnan(order):
        return order
    if not 0 < order <= GREATEST_ORDER:
        columns.refuse(row, "order", _("give an order above 0, as in 0.5 or 2"))
        return np.nan
    try:
        check_orders(engine, [order], gas=True)
    except OrderError as error:
        columns.refuse(row, "order", str(error))
    return order
