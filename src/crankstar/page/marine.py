"""A large two-stroke engine in its ship, as the page has it: moments at its speed, and a figure."""

from __future__ import annotations

from collections.abc import Iterator

from crankstar.analyses.marine.large_engines import ship_engine, ship_parts
from crankstar.analysis.document import Document
from crankstar.engine.engine import Engine
from crankstar.files.box import Spread
from crankstar.language.alike import alike
from crankstar.language.messages import _
from crankstar.page.printed import printed
from crankstar.page.records import ChartKey
from crankstar.page.unit_records import Table
from crankstar.tables.laid import merged

FIGURE = "guide-moments"


def marine_tables(engine: Engine, over: Spread | None) -> tuple[Table, ...]:
    """External and guide-force moments as `crankstar marine` prints them; empty of other engines.

    >>> from crankstar.files.catalog import load
    >>> marine_tables(load("audi-25-tfsi"), None)
    ()
    """
    if ship_engine(engine) is None:
        return ()

    def sheet(each: Engine) -> Document:
        found = ship_engine(each)
        return Document("", () if found is None else tuple(ship_parts(found)))

    return printed((sheet(engine) if over is None else merged(alike(sheet, over.engines))).parts)


def marine_charts(engine: Engine) -> Iterator[ChartKey]:
    """The key of the figure of such an engine."""
    if ship_engine(engine) is not None:
        yield ChartKey(key=FIGURE, figure=FIGURE, label=_("Guide-force moments"))
