"""The quantities that several analyses are asked for: their options, and how they are read."""

from __future__ import annotations

import re
from functools import partial
from typing import Any, Literal

from crankstar.analysis.reader import Option, Reader
from crankstar.engine.quantities import PRESSURE, Quantity
from crankstar.options import numbers, points, values
from crankstar.options.gas import (
    degree_of_irregularity,
    gas_orders,
    inertia,
    mean_pressures,
    weaker_cylinders,
)
from crankstar.options.ranges import speeds_of
from crankstar.options.refusals import refusal

SHARES = {"vertical": 0.0, "equal": 0.5, "horizontal": 1.0}
"""Horizontal shares of a first-order moment by name."""


def _orders(text: str) -> list[float] | None:
    """Orders as text; all is None."""
    return None if not text or text.strip() == "all" else gas_orders(text)


def count(option: str, most: int, more: str = "") -> Reader:
    """A whole number from 1 to `most`."""
    return Reader(option, partial(values.within, option, most=most), more)


def flag(option: str, more: str = "", *, own: str = "") -> Reader:
    """Whether an option without a value is given; `own` is what it means, where no other has it."""
    return Reader(option, bool, more, own=Option("nothing", own) if own else None)


def pressure(option: str) -> Reader:
    """A pressure above zero, Pa."""
    name = option.lstrip("-").replace("-", "_")
    return Reader(
        option,
        partial(values.positive, option, quantity=PRESSURE),
        number=partial(numbers.pressure, name),
    )


def size(option: str, quantity: Quantity, more: str = "") -> Reader:
    """A value above zero that text has with its unit, in SI units."""
    name = option.lstrip("-").replace("-", "_")
    number = partial(numbers.positive, name, quantity=quantity, example=quantity.example)
    return Reader(option, partial(values.size, option, quantity=quantity), more, number=number)


def _orders_or_all(text: str) -> list[float] | Literal["all"] | None:
    return "all" if text.strip() == "all" else gas_orders(text)


def _at(text: str, engine: Any) -> tuple[float, float, float] | None:
    return points.block_point(text, engine)


def horizontal_share(text: str) -> float:
    """The share of the first-order moment that is to be horizontal. Raises RequestError.

    >>> horizontal_share("equal"), horizontal_share("30%")
    (0.5, 0.3)
    """
    words = text.strip().lower()
    if words in SHARES:
        return SHARES[words]
    number = re.fullmatch(r"(\d{1,3}(?:\.\d{1,9})?|\.\d{1,9})\s*(%?)", words)
    share = float(number[1]) / (100 if number[2] else 1) if number else -1.0
    if not 0 <= share <= 1:
        raise refusal(
            "--first-order",
            text,
            "give vertical, equal, horizontal, or the horizontal share, such as 0.5",
        )
    return share


USUAL_TOP = 20
"""Rows of a list that readers see where none are asked for."""


def _top(number: int) -> int:
    if number < 1:
        raise refusal("--top", number, "give a number from 1 up")
    return number


TOP = Reader("--top", _top, "Default: 20.")
"""How many rows of a list readers see; None is USUAL_TOP."""
POINT = Reader("--point", str)
"""An operating point by its name."""
SPEED = Reader("--speed", values.speed, number=numbers.speed)
"""A speed, rad/s."""
SPEEDS = Reader("--speeds", speeds_of, number=numbers.speeds)
"""Speeds, rad/s."""
ORDERS = Reader("--orders", _orders, number=numbers.orders)
"""Orders of a crankshaft with gas; None is all."""
ORDERS_OR_ALL = Reader("--orders", _orders_or_all, number=numbers.orders)
"""The same, where all are other ones than those without any."""
TANGENTIAL = Reader("--tangential", mean_pressures)
"""Mean effective pressures, Pa."""
AT = Reader("--at", _at, of_source=True, number=numbers.point)
"""A point of the block: up, right, along; m."""
FLYWHEEL = Reader("--flywheel", inertia, number=partial(numbers.inertia, "flywheel"))
"""An inertia, kg m^2."""
IRREGULARITY = Reader("--irregularity", degree_of_irregularity)
"""A degree of irregularity."""
OFF = Reader("--off", values.cylinders_off)
"""Numbers of cylinders that do not fire."""
WEAKER = Reader("--weaker", weaker_cylinders)
"""Cylinders, and the share of their combustion that they lack."""
FIRST_ORDER = Reader("--first-order", horizontal_share)
"""The share of a first-order moment that is horizontal."""
