"""Polar diagrams and bending moments as they are drawn, against the tables and by other roads."""

from __future__ import annotations

import math
import re
from typing import Any

import numpy as np
import pytest
from tests.charted import rows_drawn

import crankstar
from crankstar import charts
from crankstar.analyses.bearings.charts.bending import course_of
from crankstar.analyses.bearings.charts.polar_diagrams import GAP
from crankstar.analyses.bearings.document import bending, peaks, pins
from crankstar.charts.drawing import BLUE, GREY, brief
from crankstar.dynamics.bearings import Model, bearing_loads, bending_moment
from crankstar.engine.engine import Engine
from crankstar.mechanics.balance import balance
from crankstar.mechanics.remains import summed
from crankstar.remedy import with_counterweights, with_web_weights
from crankstar.spectra import peaks as peaks_of
from crankstar.spectra import selected, value

ENGINES = [
    *("i4", "v8-cross-plane", "i2-270", "radial-9", "brough-golden-dream"),
    pytest.param("napier-deltic", marks=pytest.mark.release),
]
QUANTITIES = ("main-bearing", "main-journal", "crank-pin", "crank-pin-journal")
NUMBER = r"-?[\d.]+(?:e-?\d+)?"


def panels(chart: charts.Chart) -> list[dict[str, Any]]:
    """The panels of a figure, row by row."""
    rows = [row.get("hconcat", [row]) for row in rows_drawn(chart.to_dict())]
    return [panel for row in rows for panel in row]


def scale_of(panel: dict[str, Any]) -> float:
    """Px per unit of a panel."""
    left, right = panel["layer"][0]["encoding"]["x"]["scale"]["domain"]
    return float(panel["width"] / (right - left))


def blue_paths(chart: charts.Chart) -> list[np.ndarray]:
    """The thick lines of an SVG [point, (x, y)], px, in the order in which they are drawn."""
    drawing = charts.svg(chart, "x")
    out = []
    for tag in re.findall(r"<path[^>]*>", drawing):
        if f'stroke="{BLUE}"' in tag and "1.8" in tag:
            text = re.search(r' d="([^"]*)"', tag)
            assert text is not None
            points = re.findall(rf"[ML]({NUMBER}),({NUMBER})", text[1])
            out.append(np.array(points, float))
    return out


@pytest.mark.release
@pytest.mark.parametrize("quantity", QUANTITIES)
@pytest.mark.parametrize("name", ENGINES)
def test_farthest_point_of_a_polar_diagram_is_the_peak_in_the_table(
    name: str, quantity: Any
) -> None:
    engine = crankstar.load(name)
    chart = charts.polar_loads(engine, quantity=quantity)
    loads = bearing_loads(engine)
    main = quantity.startswith("main")
    table = peaks(engine, loads) if main else pins(loads)
    column = [column.key for column in table.columns].index("peak/value")
    greatest = [float(row[column]) for row in table.rows]  # type: ignore[arg-type]
    shown = panels(chart)
    drawn = [
        panel for panel, peak in zip(shown, greatest, strict=True) if peak > 1e-9 * max(greatest)
    ]
    paths = blue_paths(chart)
    assert len(paths) == len(drawn) > 0
    for panel, path, peak in zip(
        drawn, paths, [p for p in greatest if p > 1e-9 * max(greatest)], strict=True
    ):
        domains = [panel["layer"][0]["encoding"][axis]["scale"]["domain"] for axis in "xy"]
        scale = scale_of(panel)
        origin = np.array([-domains[0][0] * scale, domains[1][1] * scale])
        farthest = np.hypot(*(path - origin).T).max() / scale
        assert farthest == pytest.approx(peak, abs=0.02 / scale + 2e-4 * peak)


@pytest.mark.many(first=4)
@pytest.mark.parametrize("quantity", ["main-bearing", "main-journal"])
@pytest.mark.parametrize("name", ENGINES)
def test_circles_of_a_polar_diagram_are_whole_and_each_has_its_value_on_it(
    name: str, quantity: Any
) -> None:
    engine = crankstar.load(name)
    chart = charts.polar_loads(engine, quantity=quantity)
    sizes = peaks_of(bearing_loads(engine).load)
    greatest = float(sizes.max())
    loaded = [panel for panel in panels(chart) if "no load" not in str(panel)]
    assert len(loaded) == np.count_nonzero(sizes > 1e-9 * greatest) > 0
    for panel in loaded:
        half = panel["layer"][0]["encoding"]["x"]["scale"]["domain"][1]
        rows = [row for layer in panel["layer"] for row in layer.get("data", {}).get("values", [])]
        lines: dict[int, list[complex]] = {}
        for row in rows:
            if row.get("width") == 0.5:
                lines.setdefault(row["line"], []).append(complex(row["y2"], row["x2"]))
        radii = [float(np.mean(np.abs(points))) for points in lines.values()]
        assert 2 <= len(radii) <= 4
        assert greatest <= max(radii) < half
        for points, radius in zip(lines.values(), radii, strict=True):
            assert points[0] == pytest.approx(points[-1])
            assert np.abs(points) == pytest.approx(radius)
        grey = [row for row in rows if "text" in row and row["colour"] == GREY]
        places = {row["text"]: math.hypot(row["placeUp"], row["placeRight"]) for row in grey}
        assert len(grey) == len(radii)
        for radius in radii:
            assert places[brief(radius)] == pytest.approx(radius)


@pytest.mark.parametrize("name", ["i4", "v8-cross-plane"])
def test_every_mark_of_a_polar_diagram_is_explained_and_none_hides_another(name: str) -> None:
    chart = charts.polar_loads(crankstar.load(name))
    words = " ".join(chart.to_dict()["title"]["subtitle"])
    assert "ring: the greatest load; line: the load at θ; dots: θ = 0°, 90°, 180°, 270°" in words
    for panel in panels(chart):
        points = [layer for layer in panel["layer"] if layer["mark"]["type"] == "point"]
        dots, ring, now = points
        assert [each["mark"]["filled"] for each in points] == [True, False, True]
        assert ring["mark"]["size"] > now["mark"]["size"] > dots["data"]["values"][0]["size"]
        texts = panel["layer"][-1]["data"]["values"]
        angles = [row for row in texts if row["text"].endswith("°")]
        assert angles
        assert {row["colour"] for row in angles} == {BLUE}
        for row in angles:  # a label away from its dot has a line to it
            assert row["led"] or row["gap"] == GAP


def test_of_many_loads_the_greatest_are_drawn_when_few_are_asked_for() -> None:
    engine = crankstar.load("napier-deltic")
    loads = peaks_of(bearing_loads(engine).load)
    chart = charts.polar_loads(engine, most=3)
    shown = [" ".join(panel["title"]["text"]) for panel in panels(chart)]
    assert len(shown) == 3
    assert brief(float(loads.max())) in " ".join(shown)
    assert f"the 3 greatest of {len(loads)}" in " ".join(chart.to_dict()["title"]["subtitle"])


@pytest.mark.release
@pytest.mark.parametrize("name", ENGINES)
def test_a_journal_sees_the_load_of_its_bearing_turned_back_with_the_shaft(name: str) -> None:
    engine = crankstar.load(name)
    still, turning = (
        panels(charts.polar_loads(engine, quantity=quantity))
        for quantity in ("main-bearing", "main-journal")
    )
    bearings = bearing_loads(engine).bearings
    for bearing, one, other in zip(bearings, still, turning, strict=True):
        ratio = float(engine.shaft(bearing.shaft).speed_ratio) * engine.sense
        if "datum" not in str(one["layer"][-1]) or len(one["layer"]) < 4:
            continue  # no load
        for theta in (0.0, 37.0, 211.0):
            turned = vector_at(one, theta) * np.exp(-1j * ratio * np.radians(theta))
            assert vector_at(other, theta) == pytest.approx(turned, abs=2e-3)


def vector_at(panel: dict[str, Any], theta: float) -> complex:
    """The drawn load at a crank angle, degrees, from the expressions that the picture evaluates."""
    rule = next(layer for layer in panel["layer"] if layer["mark"]["type"] == "rule"
                and "transform" in layer)  # fmt: skip
    formulas = {step["as"]: step["calculate"] for step in rule["transform"]}
    known = {"theta": theta, "PI": np.pi, "cos": np.cos, "sin": np.sin}
    return complex(eval(formulas["y2"], known), eval(formulas["x2"], known))  # noqa: S307


@pytest.mark.many(first=1)
@pytest.mark.parametrize("model", [None, "determinate", "continuous"])
@pytest.mark.parametrize("name", ["i4", "v8-cross-plane", "i2-270", "radial-9"])
def test_peak_of_the_bending_picture_is_that_of_the_table(name: str, model: Model | None) -> None:
    engine = with_web_weights(crankstar.load(name), factor=0.5)
    chart = charts.bending_chart(engine, model=model)
    for held in ("determinate", "continuous"):
        if model not in (None, held):
            continue
        table = bending(engine, speed=None, model=held)
        inside, in_bearings = (float(row[2]) for row in table.rows)  # type: ignore[arg-type]
        titles = {" ".join(panel["title"]["text"]): panel for panel in panels(chart)}
        words = "one beam" if held == "continuous" else "hinged"
        for title, panel in titles.items():
            wanted = inside if title.startswith("in the end bearings") else in_bearings
            if title.startswith((words, "in the end bearings")):
                assert drawn_peak(panel, "with its weights") == pytest.approx(wanted, rel=1e-9)


def drawn_peak(panel: dict[str, Any], label: str) -> float:
    """The greatest value of the solid line of a label."""
    rows = next(
        layer["data"]["values"]
        for layer in panel["layer"]
        if layer["mark"].get("strokeDash") == [1, 0]
    )
    return max(row["value"] for row in rows if row["label"] == label)


def test_dashed_line_is_the_moment_of_all_forces_ahead_at_its_angle() -> None:
    engine = crankstar.load("v8-cross-plane")
    for model in (None, "determinate", "continuous"):
        moment = bending_moment(engine, model=model)
        course = course_of(moment)
        at = value(moment.moment, course.theta)
        assert np.all(np.abs(course.momentary) <= np.abs(at) + 1e-12)
        assert np.all(np.abs(at) <= course.envelope * (1 + 1e-9) + 1e-12)
        assert np.abs(course.momentary).max() == pytest.approx(course.greatest, rel=1e-9)


def test_weights_take_the_bending_from_a_v8_whose_forces_are_balanced() -> None:
    flat, cross = (crankstar.load(name) for name in ("v8-flat-plane", "v8-cross-plane"))

    def free(engine: Engine) -> float:
        return float(peaks_of(selected(bending_moment(engine).moment, 1)).max())

    for engine in (flat, cross):
        first = selected(summed(balance(engine)).force, 1)
        assert abs(first.forward).max() + abs(first.backward).max() < 1e-12
        assert free(with_counterweights(engine, factor=0.5)) < 0.75 * free(engine)


def test_a_bearing_without_load_says_so_and_stands_in_its_place() -> None:
    engine = crankstar.load("boxer-2")
    chart = charts.polar_loads(engine)
    assert len(panels(chart)) == len(bearing_loads(engine).bearings)
