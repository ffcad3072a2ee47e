"""A spectrum of an engine that hardly shakes: its bars are small, and the figure says so."""

from math import pi
from typing import Any

import pytest

from crankstar.charts.spectra import spectrum
from crankstar.files.catalog import load

HEAVIER = {"cylinders": [{"number": 1, "reciprocating_mass": "492.001 g"}]}
"""One piston of five is a milligram heavier: some hundredths of a newton of ten thousand."""


def panels(spec: Any) -> dict[str, tuple[float, float]]:
    """By the first word of its axis, the longest bar of a panel and the end of its axis."""
    found: dict[str, tuple[float, float]] = {}
    for panel in _layered(spec):
        axes = [layer["encoding"]["y"] for layer in panel["layer"]]
        bars = [row["to"] for row in panel["layer"][0]["data"]["values"] if "from" in row]
        found[axes[0]["title"][0]] = (max(bars, default=0.0), axes[0]["scale"]["domain"][1])
    return found


def _layered(part: Any) -> list[Any]:
    if isinstance(part, list):
        return [own for each in part for own in _layered(each)]
    if not isinstance(part, dict):
        return []
    if "layer" in part:
        return [part] if part["layer"][0]["encoding"].get("y2") else []
    return [own for each in part.values() for own in _layered(each)]


@pytest.mark.parametrize("rpm", [None, 6500.0])
def test_a_force_of_nothing_is_no_full_bar(rpm: float | None) -> None:
    engine = load("audi-25-tfsi", changes=HEAVIER)
    speed = None if rpm is None else rpm * pi / 30
    chart = spectrum(engine, speed=speed)
    one = 1.0 if speed is None else 0.492001 * 0.0464 * speed**2
    force, axis = panels(chart.spec)["force"]
    assert 0 < force < 1e-5 * one  # the piston's milligram over its mass, and the fourth order
    assert axis == pytest.approx(1.25 * 0.01 * one, rel=1e-6)
    couple, axis = panels(chart.spec)["couple"]
    assert axis == pytest.approx(1.25 * couple, rel=1e-6)
    assert "at least 1 % of m r ω²" in str(chart.spec["title"])


def test_axes_of_an_engine_that_shakes_end_at_its_bars() -> None:
    chart = spectrum(load("i4"))  # no couple: its panel says so
    force, axis = panels(chart.spec)["force"]
    assert axis == pytest.approx(1.25 * force, rel=1e-6)
    assert "at least 1 %" not in str(chart.spec["title"])
