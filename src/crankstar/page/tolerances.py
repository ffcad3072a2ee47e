"""Engines built to their tolerances, as the page has them: tables, sentences, and the figure.

Nothing of it is loaded for an engine whose file has no tolerances.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any

from crankstar.analyses.tolerance.as_built import as_built
from crankstar.engine.engine import Engine
from crankstar.language.messages import _
from crankstar.page.printed import printed
from crankstar.page.records import ChartKey
from crankstar.page.unit_records import Table

if TYPE_CHECKING:
    from crankstar.charts.grammar import Chart

SCATTER = "scatter"
"""The key of the figure."""


def tolerance_tables(engine: Engine, tree: Mapping[str, Any]) -> tuple[Table, ...]:
    """The tables and sentences of `crankstar tolerance`; empty without tolerances.

    `tree` is that of the engine file.
    """
    found = as_built(engine, tree)
    if found is None:
        return ()
    from crankstar.analyses.tolerance.document import scatter_document

    _heading, *parts = scatter_document(found).parts
    return printed(parts)


def tolerance_charts(engine: Engine, tree: Mapping[str, Any]) -> Iterator[ChartKey]:
    """The key of the figure of an engine whose file has tolerances."""
    if as_built(engine, tree) is not None:
        yield ChartKey(key=SCATTER, figure=SCATTER, label=_("Engines built to their tolerances"))


def drawn_scatter(engine: Engine, tree: Mapping[str, Any]) -> Chart | None:
    """That figure; None without tolerances. Raises ChartError where no order scatters."""
    found = as_built(engine, tree)
    if found is None:
        return None
    from crankstar.analyses.tolerance.charts import scatter_chart

    return scatter_chart(found)
