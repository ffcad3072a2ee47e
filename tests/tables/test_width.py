"""Every table fits a terminal of 80 columns, and no number in it is cut."""

from __future__ import annotations

import re
from collections.abc import Iterator
from io import StringIO

import pytest
from rich.cells import cell_len
from rich.console import Console

from crankstar import load
from crankstar.analyses.errata.document import errata_document
from crankstar.analyses.orders.document import document as order_document
from crankstar.analyses.orders.listing import Listing
from crankstar.analyses.orders.question import Question
from crankstar.analyses.strokes import RECORD as STROKES
from crankstar.analyses.vees import RECORD as VEES
from crankstar.analyses.verdict.document import verdict_document
from crankstar.analyses.verdict.facts import verdict
from crankstar.analysis.document import Column, Document, Table
from crankstar.derive.errata import errata
from crankstar.files import catalog
from crankstar.firing import orders
from crankstar.firing.timetable import OrderError
from crankstar.language.faults import EngineError
from crankstar.remedy import fitting
from crankstar.studies.best_value import best
from crankstar.studies.sweep import swept, watched
from crankstar.tables import analysis, engines, remedies, sweeps
from crankstar.tables.cells import cell
from crankstar.tables.comparison import comparison
from crankstar.tables.conversion import in_units
from crankstar.tables.terminal import rendered

WIDTH = 80


def printed(document: Document, width: int = WIDTH) -> list[str]:
    console = Console(width=width, file=StringIO(), markup=False, highlight=False)
    with console.capture() as captured:
        console.print(rendered(document, width=width), crop=False)
    return captured.get().splitlines()


def assert_fits(document: Document) -> None:
    lines = printed(document)
    assert max(map(cell_len, lines)) <= WIDTH
    words = set(" ".join(lines).split())
    for table in document.for_readers.tables:
        shown = in_units(table.readable)
        for row in shown.rows:
            for column, value in zip(shown.columns, row, strict=True):
                if isinstance(value, float | int | complex) and not column.optional:
                    assert set(cell(column, value).split()) <= words, (table.title, column.heading)


def documents(name: str) -> Iterator[Document]:
    """The documents of all commands that print an engine."""
    engine = load(name)
    yield engines.description(engine)
    shown = analysis.analysis(engine, speed=500.0)
    yield analysis.document(shown, angles=(0.0, 1.0), by="cylinder")
    yield analysis.document(shown, by="kind")
    yield verdict_document(engine, verdict(engine, relatives=False))
    yield comparison([shown, analysis.analysis(load("i4"), speed=500.0)])
    if (found := fitting.recommended(engine)) is not None:
        yield remedies.balancing_sheet(remedies.Job(engine, found.after, found.factor, speed=500.0))
    try:
        yield STROKES.told(engine, STROKES.question.value())
        listing = Listing(engine, orders.most_even_orders(engine))
        yield order_document(engine, listing, Question())
    except (EngineError, OrderError):
        return


@pytest.mark.many(first=1)
@pytest.mark.parametrize(
    "name",
    [
        name
        if name in ("i4", "vw-vr6", "napier-deltic")
        else pytest.param(name, marks=pytest.mark.release)
        for name in catalog.names()
    ],
)
def test_tables_of_an_engine_fit_80_columns(name: str) -> None:
    for document in documents(name):
        assert_fits(document)


@pytest.mark.release
def test_tables_without_an_engine_fit_80_columns() -> None:
    assert_fits(engines.catalog(catalog.summaries()))
    assert_fits(errata_document(errata(None)))
    assert_fits(VEES.told(None, VEES.question.value(cylinders=6)))
    sweep = swept("v2-90", over="balance_factor", values=[0, 0.5, 1])
    curves = [watched(sweep, what) for what in ("force", "couple", "roll", "axis_moment", "torque")]
    bests = [best(sweep, curve) for curve in curves]
    assert_fits(sweeps.sweep_document(sweep, curves, bests))


def test_a_table_that_is_too_wide_is_split_and_every_piece_has_its_labels() -> None:
    columns = (Column("row", label=True), *(Column(f"value {n}", "N*m") for n in range(20)))
    rows = tuple((float(row), *(1e5 * row + n for n in range(20))) for row in range(1, 4))
    lines = printed(Document("", (Table("", columns, rows),)))
    heads = [line for line in lines if re.match(r"row\b", line)]
    assert len(heads) > 1
    assert sum(len(re.findall(r"\[kN m\]", line)) for line in lines) == 20


def test_optional_columns_are_left_out_before_a_table_is_split() -> None:
    columns = (
        Column("order", label=True),
        Column("spare" * 6, optional=1),
        *(Column("value" * 3) for _ in range(4)),
    )
    lines = printed(Document("", (Table("", columns, ((1.0, 2.0, 3.0, 4.0, 5.0, 6.0),)),)))
    (note,) = (line for line in lines if "spare" in line)
    assert note == f"Columns that do not fit in this width: {'spare' * 6}."
    assert len([line for line in lines if "order" in line]) == 1


@pytest.mark.release
def test_the_harmonic_that_turns_a_phase_about_is_shown_in_every_width() -> None:
    """A_4 of a centred crank is negative, and phases of order 4 are counted from it."""
    shown = analysis.analysis(load("v8-flat-plane"), speed=None)
    for width in (80, 100, 140):
        lines = printed(analysis.document(shown), width)
        assert any(re.match(r"\s+4\s+-0\.0040981 ", line) for line in lines), width
