"""The section of a report on engines built to the tolerances of their file."""

from __future__ import annotations

from typing import Any

import pytest
from tests.report.reading import Reader
from tests.texts import SHORT, spoilt
from tests.tolerant import TOLERANT

from crankstar.analyses.tolerance.as_built import as_built
from crankstar.files import engine_of
from crankstar.options.sources import loaded
from crankstar.report import Subject, report


def sections(tree: dict[str, Any]) -> tuple[str, list[str], dict[str, list[list[str]]]]:
    text = report(Subject(engine_of(tree), tree, "crankstar report engine.toml"))
    read = Reader(text)
    return text, [tag.attributes.get("id", "") for tag in read.tags], read.tables


@pytest.mark.release
def test_the_report_of_an_engine_with_tolerances_says_how_engines_scatter() -> None:
    text, names, tables = sections(TOLERANT)
    assert "tolerance" in names
    found = as_built(loaded(TOLERANT))
    assert found is not None
    row = found.of("force", 1.0)
    (shown,) = [
        cells
        for title, body in tables.items()
        if "Scatter of each order" in title
        for cells in body
        if cells[:2] == ["force", "1"]
    ]
    assert float(shown[3]) * (1e3 if shown[-1] == "kN" else 1) == pytest.approx(row.rms, rel=6e-4)
    assert "The greatest part of that scatter" in text
    assert text.count("of each tolerance in the variance") == 2, "of the figure, of the table"


@pytest.mark.release
def test_a_report_without_tolerances_has_no_such_section() -> None:
    plain = spoilt(SHORT, speed="6000 rpm")
    assert as_built(loaded(plain)) is None
    _text, names, _tables = sections(plain)
    assert "tolerance" not in names
