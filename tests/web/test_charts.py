"""Figures in a browser: the crank-angle slider redraws them; the file uses no network."""

from __future__ import annotations

from pathlib import Path

import pytest
from playwright.sync_api import Page

import crankstar
from crankstar import charts
from crankstar.charts import CHARTS, saved
from crankstar.charts.grammar import Chart

TURNING = [name for name, figure in CHARTS.items() if "theta" in figure.options]
PICTURE = "() => document.querySelector('svg.marks').outerHTML"
TURN = """degrees => {
    const slider = document.querySelector('input[type=range]')
    slider.value = degrees
    slider.dispatchEvent(new Event('input'))
}"""


def opened(page: Page, chart: Chart, folder: Path) -> None:
    path = folder / "chart.html"
    path.write_bytes(saved(chart, "html", title="a figure"))
    page.goto(path.as_uri())
    page.wait_for_selector("svg.marks")


@pytest.mark.many(first=1)
@pytest.mark.parametrize(
    "name",
    [
        pytest.param(name, marks=[pytest.mark.release] * (place % 2))
        for place, name in enumerate(TURNING)
    ],
)
@pytest.mark.parametrize(
    "engine", ["kr250-racer", pytest.param("triple-120", marks=pytest.mark.release)]
)
def test_the_slider_of_the_crank_angle_moves_a_figure(
    name: str, engine: str, page: Page, tmp_path: Path
) -> None:
    asked = engine == "triple-120" and "couple" in CHARTS[name].quantities
    quantity = {"quantity": "couple"} if asked else {}
    opened(page, CHARTS[name].draw(crankstar.load(engine), theta=0.0, **quantity), tmp_path)
    assert page.title() == "a figure"
    assert page.locator("input[type=range]").count() == 1
    before = page.evaluate(PICTURE)
    page.evaluate(TURN, 70)
    page.wait_for_function(
        "before => document.querySelector('svg.marks').outerHTML !== before", arg=before
    )
    page.evaluate(TURN, 0)
    page.wait_for_function(
        "before => document.querySelector('svg.marks').outerHTML === before", arg=before
    )


@pytest.mark.release
@pytest.mark.parametrize("name", ["spectrum", "forces"])
def test_a_figure_without_a_crank_angle_has_no_slider(
    name: str, page: Page, tmp_path: Path
) -> None:
    opened(page, CHARTS[name].draw(crankstar.load("kr250-racer")), tmp_path)
    assert page.locator("input").count() == 0


@pytest.mark.release
def test_one_slider_moves_all_engines_side_by_side(page: Page, tmp_path: Path) -> None:
    engines = [crankstar.load("v8-flat-plane"), crankstar.load("i4")]
    opened(page, charts.side_by_side(engines, "hodograph", order=2), tmp_path)
    assert page.locator("input[type=range]").count() == 1
    dots = (
        "() => [...document.querySelectorAll('path[fill=\"#d55e00\"]')].map(dot => "
        "dot.getAttribute('transform'))"
    )
    before = page.evaluate(dots)
    page.evaluate(TURN, 30)
    page.wait_for_function(f"before => JSON.stringify(({dots})()) !== before", arg=None)
    after = page.evaluate(dots)
    assert len(before) == len(after) == 2
    assert all(one != other for one, other in zip(before, after, strict=True))
