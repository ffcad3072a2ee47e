"""The figure of guide-force moments: its bars are those of the analysis."""

from __future__ import annotations

import numpy as np
import pytest
from tests.files.test_gas_views import rows_of
from tests.marine import marine_engine

import crankstar
from crankstar import charts
from crankstar.analyses.marine.document import document
from crankstar.analyses.marine.marine_analysis import marine
from crankstar.analyses.marine.question import Question
from crankstar.mechanics.gas import cycle
from crankstar.mechanics.guide_moments import guide_moments


@pytest.mark.release
def test_the_bars_are_the_moments_of_the_analysis() -> None:
    engine = marine_engine()
    found = guide_moments(engine, cycle(engine))
    rows = [row for row in rows_of(charts.guide_moment_chart(engine).to_dict()) if "what" in row]
    for name, values in (("H", found.h), ("X", found.x)):
        own = {float(row["order"]): row["to"] for row in rows if row["what"].startswith(name)}
        assert own
        for order, size in own.items():
            [wanted] = np.abs(values)[found.orders == order] / 1e3
            assert size == pytest.approx(wanted, rel=1e-5)
    assert {float(row["order"]) for row in rows if row["what"].startswith("H")} == {7, 14, 21}


@pytest.mark.release
def test_without_pitch_there_are_bars_of_h_alone() -> None:
    drawn = charts.guide_moment_chart(crankstar.load("man-s90mc-c"))
    rows = [row for row in rows_of(drawn.to_dict()) if "what" in row]
    assert {row["what"][0] for row in rows} == {"H"}
    assert "layout.bore_pitch" in str(drawn)
    assert "Of gas alone." in str(drawn)


@pytest.mark.parametrize("name", ["i4", "jumo-205", "harley-45"])
def test_an_engine_without_them_has_a_figure_that_says_why(name: str) -> None:
    drawn = charts.guide_moment_chart(crankstar.load(name))
    assert any(words in str(drawn) for words in ("need", "has several"))


@pytest.mark.many(first=2)
@pytest.mark.parametrize("name", ["two-stroke seven", "man-s90mc-c", "audi-25-tfsi"])
def test_the_bars_are_of_the_orders_of_the_table(name: str) -> None:
    engine = marine_engine() if name == "two-stroke seven" else crankstar.load(name)
    drawn = charts.guide_moment_chart(engine).to_dict()
    bars = {float(row["order"]) for row in rows_of(drawn) if "what" in row}
    tables = document(engine, marine(engine), Question()).for_readers.tables
    [table] = [one for one in tables if one.key == "guide"]
    assert bars == {row[0] for row in table.rows}
