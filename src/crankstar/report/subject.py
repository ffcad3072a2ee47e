"""The subject of a report: the engine, its speed and orders, another engine to compare with."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property, partial
from typing import Any, Literal

from crankstar import spectra
from crankstar.analyses.verdict.facts import Fact, verdict
from crankstar.analyses.verdict.ranges import ranged_facts
from crankstar.analysis.document import Document, Remarks, Table
from crankstar.engine.engine import Engine
from crankstar.files.box import Spread
from crankstar.language.alike import alike
from crankstar.mechanics import remains
from crankstar.options.sources import Loaded
from crankstar.page.records import Scene
from crankstar.page.scene import scene
from crankstar.studies.answer_parts import joined
from crankstar.studies.answers import rests_on, summary
from crankstar.studies.load_answers import first_load
from crankstar.tables.analysis import Analysis, analysis
from crankstar.tables.assumptions import assumption_lines
from crankstar.tables.laid import merged

Quantity = Literal["force", "couple"]
MOST = 4
"""Greatest number of drawn orders of a quantity, unless orders are named."""


@dataclass(frozen=True)
class Subject:
    """The subject of a report.

    `tree` is the engine file as it was read, with changed values; `speed` in rad/s, by default that
    of the engine; `orders` are named ones; `command` writes the report again. A report that is not
    `full` leaves out long derivations, tables by cylinder, single sources and the engine file.
    `spreads` are the ranges of the engine and of the one `beside` it.
    """

    engine: Engine
    tree: Mapping[str, Any]
    command: str
    speed: float | None = None
    orders: tuple[float, ...] | None = None
    beside: Engine | None = None
    full: bool = False
    spreads: tuple[Spread | None, Spread | None] = (None, None)

    @cached_property
    def file(self) -> Loaded:
        """What was loaded, for the analyses that are of the file."""
        return Loaded(self.engine.name, dict(self.tree), self.engine)

    def with_orders(self, orders: tuple[float, ...] | None) -> Subject:
        """The subject with these named orders."""
        return replace(self, orders=tuple(sorted(orders)) if orders else None)

    def analysis_of(self, engine: Engine) -> Analysis:
        """The Balance of an engine at the speed and of the orders of the report."""
        whole = analysis(engine, speed=self.speed)
        return whole._replace(orders=self.orders, turning=self.orders) if self.orders else whole

    @cached_property
    def rests_on(self) -> list[str]:
        """Sentences on what is missing, assumed or unverified, what matters most first."""
        told = [summary(self.engine, speed=self.speed), first_load(self.engine, speed=self.at)]
        return assumption_lines(rests_on(self.engine, joined(told)))

    @cached_property
    def shown(self) -> Analysis:
        """The Balance of the engine, and the orders in the report."""
        return self.analysis_of(self.engine)

    @cached_property
    def scene(self) -> Scene:
        """The drawn engine."""
        return scene(self.engine)

    @cached_property
    def ends(self) -> tuple[Subject, ...]:
        """The same report of the engines in the middle and at the corners of the ranges."""
        spread = self.spreads[0]
        engines = () if spread is None else (spread.middle, *spread.corners)
        return tuple(replace(self, engine=each, spreads=(None, None)) for each in engines)

    def parts(
        self, build: Callable[[Subject], Iterable[Table | Remarks]]
    ) -> Sequence[Table | Remarks]:
        """Tables and remarks, with ranges where they rest on estimates."""
        if not self.ends:
            return tuple(build(self))

        def document(each: Subject) -> Document:
            return Document("", tuple(build(each)))

        return merged(alike(document, (self, *self.ends))).parts

    def lines(self, build: Callable[[Subject], Sequence[str]]) -> tuple[str, ...]:
        """Sentences, with ranges where they rest on estimates."""
        parts = self.parts(lambda each: [Remarks(tuple(build(each)))])
        return tuple(line for part in parts if isinstance(part, Remarks) for line in part.lines)

    @cached_property
    def facts(self) -> tuple[Fact, ...]:
        """The verdict on the engine, with ranges where it rests on estimates."""
        return ranged_facts(partial(verdict, speed=self.speed), self.spreads[0], self.engine)

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
