"""The analyses that have a panel of their own on the page: tables, sentences and figures.

Hosts name none of them: what a panel is called and what stands in it is in the record of the
analysis, those of other packages too.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any

from crankstar.analysis.document import Document
from crankstar.analysis.record import Analysis
from crankstar.analysis.registry import added, analyses
from crankstar.engine.engine import Engine
from crankstar.files.box import Spread
from crankstar.language.alike import alike
from crankstar.language.messages import _
from crankstar.options.sources import Loaded
from crankstar.page.keys import chart_key
from crankstar.page.printed import printed
from crankstar.page.records import ChartKey, PanelShown
from crankstar.page.unit_records import Table
from crankstar.tables.laid import merged

if TYPE_CHECKING:
    from crankstar.charts.grammar import Chart


def panels() -> tuple[PanelShown, ...]:
    """The panels in the order of their tabs."""
    return tuple(
        PanelShown(
            key=record.name,
            label=_(panel.label),
            needs=_(panel.needs),
            figures=figure_names(record),
        )
        for record in analyses()
        if (panel := record.panel) is not None
    )


def figure_names(record: Analysis) -> tuple[str, ...]:
    """The names of the figures in the panel of an analysis: its charts, or what -o draws."""
    pictured = record.picture is not None and record.picture.caption
    return (*(each.chart for each in record.figures), *([record.name] if pictured else []))


def told_tables(
    engine: Engine, tree: Mapping[str, Any], over: Spread | None
) -> dict[str, tuple[Table, ...]]:
    """What each of these analyses prints of an engine, by its name; `tree` is that of its file.

    >>> from crankstar.files.catalog import load
    >>> told_tables(load("audi-25-tfsi"), {}, None)
    {}
    """
    out: dict[str, tuple[Table, ...]] = {}
    for record in _with_panel():
        with added().among_others(record.name):
            if record.tells(engine, file=_file(engine, tree)):
                out[record.name] = _tables(record, engine, tree, over)
    return out


def told_charts(engine: Engine, tree: Mapping[str, Any]) -> Iterator[ChartKey]:
    """The keys of their figures."""
    for record in _with_panel():
        with added().among_others(record.name):
            if record.tells(engine, file=_file(engine, tree)):
                yield from _charts(record)


def _charts(record: Analysis) -> Iterator[ChartKey]:
    for each in record.figures:
        yield ChartKey(
            key=chart_key(each.chart, quantity=each.quantity),
            figure=each.chart,
            label=_(each.caption),
            quantity=each.quantity,
        )
    if record.picture is not None and record.picture.caption:
        label = _(record.picture.caption)
        yield ChartKey(key=record.name, figure=record.name, label=label)


def pictured(engine: Engine, key: str, tree: Mapping[str, Any]) -> Chart | None:
    """The picture of what an analysis has found, by the key of its figure; None where none is.

    Raises ChartError where there is nothing to draw.
    """
    file = _file(engine, tree)
    for record in _with_panel():
        if key == record.name and key in figure_names(record) and record.tells(engine, file=file):
            question = record.question.value(**record.views)
            found = record.compute.value(file if record.of_file else engine, question)
            return record.picture and record.picture.draw.value(found, question)
    return None


def _with_panel() -> Iterator[Analysis]:
    return (record for record in analyses() if record.panel is not None)


def _file(engine: Engine, tree: Mapping[str, Any]) -> Loaded:
    return Loaded(engine.name, dict(tree), engine)


def _tables(
    record: Analysis, engine: Engine, tree: Mapping[str, Any], over: Spread | None
) -> tuple[Table, ...]:
    def sheet(each: Engine) -> Document:
        return Document("", tuple(record.viewed(each, None, file=_file(each, tree))))

    if over is None or not record.ranged:
        return printed(sheet(engine).parts)
    return printed(merged(alike(sheet, over.engines)).parts)
