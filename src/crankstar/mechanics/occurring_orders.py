"""Which orders an engine can have at all, whatever its masses and its gas.

Moving parts push at the whole multiples of the speed ratio of their shaft; the gas at those of its
cycles in a turn, half orders of a four-stroke engine. Nothing is between.
"""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from math import inf

from crankstar.engine.engine import Engine
from crankstar.language.messages import MessageError, _n
from crankstar.language.numbers import order_text

SAME = 1e-9
"""Orders that are nearer to each other are the same, as sums by order have it."""
NAMED = 4
"""How many of the orders that occur are named where others are asked for."""


class OrderError(MessageError):
    """An order that an engine cannot have."""


def fundamental_orders(engine: Engine, *, gas: bool) -> tuple[Fraction, ...]:
    """The orders of which all others are whole multiples; `gas`: those of gas too.

    >>> from crankstar.files.catalog import load
    >>> [str(order) for order in fundamental_orders(load("i4"), gas=True)]
    ['1/2']
    >>> [str(order) for order in fundamental_orders(load("man-s90mc-c"), gas=True)]
    ['1']
    """
    turns = round(engine.cycle_angle / 360)
    burning = {cylinder.shaft for cylinder in engine.cylinders} if gas else set()
    own = {
        abs(shaft.speed_ratio) / (turns if shaft.name in burning else 1) for shaft in engine.shafts
    }
    return tuple(
        sorted(
            order
            for order in own
            if not any(order != other and (order / other).denominator == 1 for other in own)
        )
    )


def foreign_orders(engine: Engine, orders: Iterable[float], *, gas: bool) -> list[float]:
    """Those of these orders that the engine cannot have.

    >>> from crankstar.files.catalog import load
    >>> foreign_orders(load("i4"), [0.3, 0.5, 2, -1], gas=True)
    [0.3, -1]
    """
    steps = [float(order) for order in fundamental_orders(engine, gas=gas)]
    return [
        order
        for order in orders
        if not SAME <= order < inf
        or all(abs(order - round(order / step) * step) > SAME for step in steps)
    ]


def check_orders(engine: Engine, orders: Iterable[float], *, gas: bool) -> None:
    """Raises OrderError, which names the first that occur, if the engine cannot have one of these.

    `gas`: whether the orders of gas are among those that are shown.
    """
    foreign = foreign_orders(engine, orders, gas=gas)
    if not foreign:
        return
    steps = fundamental_orders(engine, gas=gas)
    first = sorted({step * n for step in steps for n in range(1, NAMED + 1)})[:NAMED]
    raise OrderError(
        _n(
            "order {orders} does not occur in {engine}; those that do are {first} and so on",
            "orders {orders} do not occur in {engine}; those that do are {first} and so on",
            len(foreign),
            orders=", ".join(map(order_text, foreign)),
            engine=engine.name,
            first=", ".join(_text(order) for order in first),
        )
    )


def _text(order: Fraction) -> str:
    """An order as --orders takes it: decimal where that is short, else a fraction."""
    return order_text(float(order)) if order.denominator in (1, 2, 4, 5) else str(order)
