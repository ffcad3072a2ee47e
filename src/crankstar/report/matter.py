"""What a report is about: the engine, at which speed, which orders, and beside which other engine."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any, Literal

import numpy as np

from crankstar import phasor
from crankstar.balance import total
from crankstar.engine import Engine
from crankstar.exhibit.records import Scene
from crankstar.exhibit.scene import scene
from crankstar.tables import Analysis, analysis
from crankstar.wording import NEGLIGIBLE

Quantity = Literal["force", "couple"]
MINOR = 0.02
"""An order is drawn if it is at least this share of the greatest, or of the first two."""
MOST = 4
"""Orders of one quantity that are drawn, unless orders are named."""


@dataclass(frozen=True)
class Matter:
    """What a report is about.

    `tree` is the engine file as it was read, with what was changed in it; `speed` in rad/s, else that of the engine; `orders`
    where some are named; `command` writes the report again.
    """

    engine: Engine
    tree: Mapping[str, Any]
    command: str
    speed: float | None = None
    orders: tuple[float, ...] | None = None
    beside: Engine | None = None

    def about(self, *, orders: tuple[float, ...] | None) -> Matter:
        """The same of these orders."""
        return replace(self, orders=tuple(sorted(orders)) if orders else None)

    @cached_property
    def shown(self) -> Analysis:
        """The engine with its Balance, and the orders that are shown."""
        found = analysis(self.engine, speed=self.speed)
        return found._replace(orders=self.orders, turning=self.orders) if self.orders else found

    @cached_property
    def scene(self) -> Scene:
        """The engine as things that can be drawn."""
        return scene(self.engine)

    @property
    def at(self) -> float | None:
        """The speed at which forces are quoted in newtons, where they can be."""
        return self.shown.real.speed if self.shown.real is not None else None

    def pushing(self, quantity: Quantity) -> tuple[float, ...]:
        """The orders of force or couple that are worth a drawing: the first two, and what remains of the others."""
        parts = getattr(self.shown.normalised, quantity)
        orders = self.shown.orders
        each = phasor.selected(parts, orders)
        pushed = (np.abs(each.forward) + np.abs(each.backward)).sum(axis=0)
        whole = phasor.selected(getattr(total(self.shown.normalised), quantity), orders)
        left = np.abs(whole.forward) + np.abs(whole.backward)
        # What is nothing beside the forces at a bore pitch is nothing, where no part has an arm.
        floor = NEGLIGIBLE * max(float(pushed.max(initial=0.0)), 1.0 if quantity == "couple" else 0.0)
        there = [place for place in range(len(orders)) if pushed[place] > floor]
        if self.orders:
            return tuple(orders[place] for place in there)
        greatest = float(left.max(initial=0.0))
        drawn = [place for place in there if orders[place] in (1.0, 2.0) or left[place] > max(MINOR * greatest, floor)]
        return tuple(orders[place] for place in drawn[:MOST])

    def left(self, quantity: Quantity) -> tuple[float, ...]:
        """Those of `pushing` of which something remains in the sum."""
        orders: Sequence[float] = self.pushing(quantity)
        parts = getattr(self.shown.normalised, quantity)
        whole = phasor.selected(getattr(total(self.shown.normalised), quantity), orders)
        each = phasor.selected(parts, orders)
        pushed = (np.abs(each.forward) + np.abs(each.backward)).sum(axis=0)
        size = np.abs(whole.forward) + np.abs(whole.backward)
        return tuple(order for order, one, all_ in zip(orders, size, pushed, strict=True) if one > NEGLIGIBLE * all_)
