"""The subject of a report: the engine, its speed and orders, another engine to compare with."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any, Literal

from crankstar import spectra
from crankstar.engine.engine import Engine
from crankstar.mechanics import remains
from crankstar.page.records import Scene
from crankstar.page.scene import scene
from crankstar.tables.analysis import Analysis, analysis

Quantity = Literal["force", "couple"]
MOST = 4
"""Greatest number of drawn orders of a quantity, unless orders are named."""


@dataclass(frozen=True)
class Subject:
    """The subject of a report.

    `tree` is the engine file as it was read, with changed values; `speed` in rad/s, by default that
    of the engine; `orders` are named ones; `command` writes the report again. A report that is not
    `full` leaves out long derivations, tables by cylinder, single sources and the engine file.
    """

    engine: Engine
    tree: Mapping[str, Any]
    command: str
    speed: float | None = None
    orders: tuple[float, ...] | None = None
    beside: Engine | None = None
    full: bool = False

    def with_orders(self, orders: tuple[float, ...] | None) -> Subject:
        """The subject with these named orders."""
        return replace(self, orders=tuple(sorted(orders)) if orders else None)

    def analysis_of(self, engine: Engine) -> Analysis:
        """The Balance of an engine at the speed and of the orders of the report."""
        whole = analysis(engine, speed=self.speed)
        return whole._replace(orders=self.orders, turning=self.orders) if self.orders else whole

    @cached_property
    def shown(self) -> Analysis:
        """The Balance of the engine, and the orders in the report."""
        return self.analysis_of(self.engine)

    @cached_property
    def scene(self) -> Scene:
        """The drawn engine."""
        return scene(self.engine)

    @property
    def at(self) -> float | None:
        """The speed of forces in newtons, None where they are in units of m r w^2."""
        return self.shown.real.speed if self.shown.real is not None else None

    @cached_property
    def sums(self) -> remains.Sums:
        """The sums of the engine in units of m r w^2."""
        return remains.summed(self.shown.normalised)

    def drawn(self, quantity: Quantity) -> tuple[float, ...]:
        """The orders of force or couple that are drawn: the named ones, else the largest."""
        result, orders = self.shown.normalised, self.shown.orders
        if self.orders:
            return remains.orders_drawn(result, self.sums, quantity, orders, minor=-1.0)
        return remains.orders_drawn(result, self.sums, quantity, orders)[:MOST]

    def remaining(self, quantity: Quantity) -> tuple[float, ...]:
        """The drawn orders of which the sum is not zero."""
        orders = self.drawn(quantity)
        sizes = remains.sizes(spectra.selected(getattr(self.sums, quantity), orders))
        return tuple(order for order, size in zip(orders, sizes, strict=True) if size > 0)
