"""Every engine of the catalog has its report and exhibit, as it is and fitted, without error."""

from __future__ import annotations

import json

import pytest
from tests.report.test_report import subject

import crankstar
from crankstar.page.exhibits import exhibition
from crankstar.report import gallery, report

DRAWN = 5
"""One engine in so many has its figures turned into pictures; of the others they are made only."""
NAMES = crankstar.names()


@pytest.mark.release
@pytest.mark.parametrize("name", NAMES)
def test_every_engine_has_a_report(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    whole = NAMES.index(name) % DRAWN == 0
    if not whole:
        monkeypatch.setattr(
            gallery,
            "svg_later",
            lambda chart, title: lambda: f"<svg>{len(chart.to_dict())}{len(title)}</svg>",
        )
    page = report(subject(name))
    assert "<!--figure" not in page
    assert page.count("<svg") >= 8
    assert ("Fitted with" in page) == (
        exhibition([crankstar.load(name)], relatives=False).fitted[0] is not None
    )


@pytest.mark.release
@pytest.mark.parametrize("name", NAMES)
def test_every_engine_has_an_exhibit(name: str) -> None:
    shown = exhibition([crankstar.load(name)], relatives=False)
    json.dumps(shown.model_dump(mode="json"), allow_nan=False)
    fitted = shown.fitted[0]
    start = ("Fitted with ", "Without its counterweights.", "The engine already has, outside")
    assert fitted is None or fitted.remedies[0].notes[0].startswith(start)
