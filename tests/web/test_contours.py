"""Contours: lines against the law, and the values of their labels read from the picture."""

from __future__ import annotations

import re
from collections.abc import Callable
from functools import partial
from math import hypot
from pathlib import Path

import numpy as np
import pytest
from playwright.sync_api import Page
from tests.commands import Run
from tests.files.conftest import refused, run
from tests.measured import FAMILIES, Measured, Text, contrast, measured

import crankstar
from crankstar import charts, spectra
from crankstar.charts.contour_lines import labelled_contours, level_lines, levels
from crankstar.charts.drawing import VERMILION
from crankstar.charts.themes import THEMES
from crankstar.mechanics.balance import balance, total
from crankstar.studies.best_pair import best_pair, front
from crankstar.studies.best_value import best
from crankstar.studies.sweep import sweep, watched

__all__ = ["refused", "run"]

OVER = ["balance_factor=0..1/41", "layout.banks[1].bearing=-80..20 deg/41"]


def test_the_contours_of_a_cone_are_circles_and_closed() -> None:
    x = np.linspace(-1, 1, 81)
    cone = np.hypot(*np.meshgrid(x, x, indexing="ij"))
    for level in (0.3, 0.7):
        (line,) = level_lines(x, x, cone, level)
        assert line[0] == pytest.approx(line[-1])
        assert [hypot(*point) for point in line] == pytest.approx([level] * len(line), abs=2e-3)
    corners = level_lines(x, x, cone, 1.2)
    assert len(corners) == 4
    assert all(line[0] != line[-1] for line in corners)


def test_a_saddle_is_drawn_as_two_lines_on_either_side() -> None:
    x = np.linspace(-1, 1, 8)  # the middle lies in a cell
    saddle = np.outer(x, x)
    for level in (-0.05, -1e-3, 1e-3, 0.05):
        lines = level_lines(x, x, saddle, level)
        assert len(lines) == 2
        for line in lines:
            assert {np.sign(a) for a, _b in line} == {np.sign(line[0][0])}


@pytest.mark.parametrize(("low", "high"), [(0, 1), (3.1, 3.17), (-5, 8e5), (1e-9, 3e-9)])
def test_levels_are_round_and_some_seven(low: float, high: float) -> None:
    found = levels(low=low, high=high)
    assert 3 <= len(found) <= 11
    assert low < found[0]
    assert found[-1] < high
    assert np.ptp(np.diff(found)) < 1e-6 * (high - low)


def test_a_flat_result_has_no_lines() -> None:
    x = np.arange(4.0)
    assert labelled_contours(x, x, np.ones((4, 4)), size=(300, 200)) == []


def number_of(text: Text) -> float | None:
    plain = text.text.replace("−", "-")
    return float(plain) if re.fullmatch(r"-?[\d.]+(e-?\d+)?", plain) else None


def middle(text: Text) -> tuple[float, float]:
    return (text.left + text.right) / 2, (text.top + text.bottom) / 2


def labels_of(picture: Measured) -> list[tuple[float, float, float]]:
    """The value of each contour's label, and the values of both axes where it stands."""
    numbers = [(value, text) for text in picture.texts if (value := number_of(text)) is not None]
    foot = max(middle(text)[1] for _v, text in numbers)
    side = min(text.left for _v, text in numbers)
    across = [(v, middle(t)[0]) for v, t in numbers if abs(middle(t)[1] - foot) < 3][1:-1]
    edge = min(t.right for _v, t in numbers if t.left < side + 30)
    upright = [(v, middle(t)[1]) for v, t in numbers if t.right < edge + 12]
    inside = [
        (v, middle(t)) for v, t in numbers if abs(middle(t)[1] - foot) > 3 and t.right > edge + 12
    ]
    top = min(place for _v, place in upright)
    x, y = (
        np.polyfit([p for _v, p in axis], [v for v, _p in axis], 1) for axis in (across, upright)
    )
    return [
        (v, float(np.polyval(x, a)), float(np.polyval(y, b))) for v, (a, b) in inside if b > top
    ]


@pytest.mark.release
@pytest.mark.parametrize(
    "theme", ["light", *(pytest.param(one, marks=pytest.mark.release) for one in ("dark", "print"))]
)
def test_values_read_from_the_picture_are_those_of_single_engines(
    theme: charts.Theme, page: Page
) -> None:
    made = sweep("v2-90", OVER)
    curve = watched(made, "force", order=1)
    draw = partial(charts.contours, made, [curve], best=[best_pair(made, curve)])
    drawn = charts.printed(draw, charts.Paper(theme, font_size=8.0), title="x")
    (picture,) = measured(page, [drawn.scaled("mm")])
    assert picture.collisions() == []
    assert picture.cut() == []
    labels = labels_of(picture)
    assert len(labels) >= 4
    for value, factor, bearing in labels:
        changes = {
            "balance_factor": min(max(factor, 0.0), 1.0),
            "layout.banks[1].bearing": f"{bearing} deg",
        }
        engine = crankstar.load("v2-90", changes=changes)
        force = spectra.selected(total(balance(engine)).force, [1.0])
        assert spectra.peak(force).value == pytest.approx(value, abs=0.02)
    names = {text.text for text in picture.texts}
    assert {"balance factor", "direction of bank 1 [deg]"} <= names
    assert "force of order 1 [m r ω²]" in names
    fills = [bytes.fromhex(fill[1:]) for fill in THEMES[theme].fills.values()]
    for text in picture.texts:
        assert text.size * 72 / 96 >= 7.99
        for fill in fills:
            assert contrast(text.colour, (fill[0], fill[1], fill[2])) >= 4.5


RING = """ring => {
  const home = document.querySelector('svg').getBoundingClientRect()
  const box = document.querySelector(`path[stroke="${ring}"]`).getBoundingClientRect()
  return [box.left - home.left, box.top - home.top, box.right - home.left, box.bottom - home.top]
}"""
"""The box of a mark within its picture."""


def gaps(picture: Measured, ring: tuple[float, float, float, float]) -> list[float]:
    """How far each text is from a box, px; negative where it stands on it."""
    left, top, right, bottom = ring
    return [
        max(each.left - right, left - each.right, each.top - bottom, top - each.bottom)
        for each in picture.texts
    ]


@pytest.mark.release
@pytest.mark.parametrize("family", FAMILIES)
@pytest.mark.parametrize(
    "over", [["balance_factor=0.5..1", "speed=1000..6000 rpm"], ["balance_factor=0.5..1"]]
)
def test_the_mark_at_the_edge_of_the_axes_leaves_their_numbers_free(
    over: list[str], family: str, page: Page
) -> None:
    if len(over) == 2:
        pairs = sweep("v2-90", over)
        curve = watched(pairs, "force", order=1)
        chart = charts.contours(pairs, [curve], best=[best_pair(pairs, curve)])
    else:
        single = sweep("v2-90", over)
        curve = watched(single, "force", order=1)
        chart = charts.swept(single, [curve], best=[best(single, curve)])
    (picture,) = measured(page, [charts.svg(chart, "x")], family)
    found = gaps(picture, page.evaluate(RING, VERMILION))
    assert len(found) > 8
    assert min(found) > 3  # half of the line of the mark is 1.1


@pytest.mark.release
def test_two_results_have_their_contours_and_their_front_without_collision(page: Page) -> None:
    made = sweep("harley-45", OVER)
    curves = [watched(made, what) for what in ("force", "roll")]
    bests = [best_pair(made, curve) for curve in curves]
    draw = partial(charts.contours, made, curves, best=bests, front=front(made, *curves))
    papers = [charts.Paper("print"), charts.Paper("light", width=0.09, font_size=8.0)]
    drawings = [charts.printed(draw, paper, title="x").scaled("mm") for paper in papers]
    for picture in measured(page, drawings):
        assert picture.collisions() == []
        assert picture.cut() == []
        names = " ".join(text.text for text in picture.texts)
        assert "force [m r ω²]" in names
        assert "rolling moment [m r² ω²]" in names


@pytest.mark.release
def test_a_chart_of_two_is_written_in_every_form(run: Run, tmp_path: Path) -> None:
    words = ["sweep", "v2-90", *(word for over in OVER for word in ("--over", over))]
    for kind in ("svg", "png", "pdf", "html"):
        run(*words, "--quantity", "force,couple", "--theme", "print", "-o", f"x.{kind}")
        assert (tmp_path / f"x.{kind}").stat().st_size > 5000


@pytest.mark.parametrize(
    ("arguments", "told"),
    [
        (["--over", OVER[0]] * 2, "is varied twice"),
        (
            ["--over", OVER[0], "--over", OVER[1], "--over", "speed=1..2 Hz"],
            "3 values are to be varied",
        ),
        (["--over", OVER[0], "--over", "bore=1..2 mm"], "cylinder.bore"),
        (["--over", OVER[0], "--over", "layout.banks[1].bearing=0..9 mm"], "an angle is needed"),
        (["--over", OVER[0], "--over", "speed=900..600 rpm by 50"], "write by -50"),
        (["--over", "balance_factor=0..1/500", "--over", OVER[1][:-3] + "/500"], "are 250000 eng"),
        (["--over", "speed=600..900 rpm", "--speed", "700 rpm"], "given and varied"),
        (["--over", OVER[0], "--theme", "pink"], "choose"),
        (["--over", OVER[0], "--font-size", "4"], "from 8 to 72"),
    ],
)
def test_pairs_that_cannot_be_are_refused_and_nothing_is_written(
    refused: Callable[..., str], tmp_path: Path, arguments: list[str], told: str
) -> None:
    assert told in refused("sweep", "v2-90", *arguments, "-o", "out.svg")
    assert list(tmp_path.iterdir()) == []
