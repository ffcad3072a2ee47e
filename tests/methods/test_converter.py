"""Figures drawn in a process beside this one: the same drawings, whatever becomes of it."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from crankstar import charts
from crankstar.charts import converter
from crankstar.charts.drawing import svg_later
from crankstar.files.catalog import load


@pytest.fixture
def beside(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    monkeypatch.setattr(converter.os, "cpu_count", lambda: 2)
    converter.begin()
    yield
    converter.end()


@pytest.mark.release
@pytest.mark.usefixtures("beside")
def test_what_is_drawn_beside_is_what_is_drawn_here() -> None:
    figures = [charts.polygon(load(name), order=1) for name in ("v8-cross-plane", "i4")]
    later = [svg_later(figure, "x") for figure in figures]
    found = [drawing() for drawing in later]
    converter.end()
    assert found == [charts.svg(figure, "x") for figure in figures]


@pytest.mark.release
@pytest.mark.usefixtures("beside")
def test_figures_are_drawn_here_once_the_process_has_gone() -> None:
    figure = charts.hodograph(load("i4"))
    first = charts.svg(figure, "x")
    converter._begun[-1].process.kill()
    assert charts.svg(figure, "x") == first


@pytest.mark.usefixtures("beside")
def test_a_figure_that_cannot_be_drawn_is_refused_as_without_it() -> None:
    with pytest.raises(ValueError, match="conversion failed"):
        converter.drawn({"mark": 7}).result()


def test_a_lone_processor_begins_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(converter.os, "cpu_count", lambda: 1)
    converter.begin()
    assert not converter._begun
