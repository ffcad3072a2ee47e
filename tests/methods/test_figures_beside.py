"""Figures of two engines on the page: one scale for both, each at its own speed."""

from __future__ import annotations

import json
import re
from math import pi
from typing import Any

import pytest

from crankstar.charts.registry import side_by_side
from crankstar.engine.copies import with_values
from crankstar.engine.engine import Engine
from crankstar.files.catalog import load
from crankstar.mechanics.operating_points import common_speed
from crankstar.page.figures import chart

CROSS, FLAT = "v8-cross-plane", "v8-flat-plane"
FIGURES = [
    "over-turn:quantity=force",
    "over-turn:quantity=couple",
    "over-turn:quantity=roll",
    "hodograph:quantity=force",
    "hodograph:order=2:quantity=force",
    "vector-star:order=1:quantity=couple",
    "polygon:order=1:quantity=couple",
    "spectrum",
]


def scales(figure: dict[str, Any]) -> list[tuple[float, float]]:
    """The domains of the axes of a figure, without that of the crank angle."""
    found = re.findall(r'"domain": \[(-?[\d.e-]+), (-?[\d.e-]+)\]', json.dumps(figure))
    return sorted({(float(low), float(high)) for low, high in found} - {(0.0, 360.0)})


@pytest.mark.release
def test_a_figure_that_stands_beside_another_has_its_scale() -> None:
    one, other = load(CROSS), load(FLAT)
    for key in FIGURES:
        pair = [scales(chart(one, key, beside=other)), scales(chart(other, key, beside=one))]
        alone = [scales(chart(each, key)) for each in (one, other)]
        assert pair[0], key
        assert pair[0] == pair[1], key
        reach = [max(high for _low, high in each) for each in (*pair, *alone)]
        assert reach[0] == pytest.approx(max(reach[2:]), rel=1e-9), key


@pytest.mark.release
def test_each_engine_beside_another_is_drawn_at_its_own_speed() -> None:
    slow = load("audi-25-tfsi")
    assert slow.speed
    fast = with_values(slow, name="fast", speed=2 * slow.speed)

    def reach(engine: Engine, beside: Engine | None = None) -> float:
        figure = chart(engine, "over-turn:quantity=couple", beside=beside)
        return max(high for _low, high in scales(figure))

    assert reach(fast) == pytest.approx(4 * reach(slow), rel=1e-9)
    assert reach(slow, fast) == pytest.approx(reach(fast), rel=1e-9)
    assert reach(fast, slow) == pytest.approx(reach(fast), rel=1e-9)


def test_engines_counted_in_different_units_keep_their_own_scales() -> None:
    known, relative = load("audi-25-tfsi"), load("i4")
    key = "over-turn:quantity=couple"
    assert chart(known, key, beside=relative) == chart(known, key)
    assert chart(relative, key, beside=known) == chart(relative, key)


def bars(made: dict[str, Any]) -> list[float]:
    """The greatest force of each engine in a spectrum of several, N, first order."""
    found: list[float] = []

    def walk(part: Any) -> None:
        if isinstance(part, list):
            for each in part:
                walk(each)
        elif isinstance(part, dict):
            rows = part.get("data", {}).get("values", [])
            title = part.get("encoding", {}).get("y", {}).get("title")
            if part.get("mark", {}) and rows and title == ["force", "(N)"] and "from" in rows[0]:
                found.append(max(row["to"] for row in rows if row["order"] == "1"))
            for each in part.values():
                walk(each)

    walk(made)
    return found


def test_engines_of_known_masses_are_compared_at_one_speed_unasked() -> None:
    sizes = {"cylinder.stroke": "100 mm", "layout.bore_pitch": "100 mm"}
    small, great = (
        load("single", changes={**sizes, "cylinder.reciprocating_mass": mass})
        for mass in ("0.4 kg", "1.2 kg")
    )
    made = side_by_side([small, great], "spectrum").to_dict()
    w = 1000 * pi / 30  # neither file has a speed
    assert bars(made) == pytest.approx([0.4 * 0.05 * w**2, 1.2 * 0.05 * w**2])
    fast = great.model_copy(update={"speed": 3 * w})
    assert common_speed([small, fast]) == pytest.approx(3 * w)
    assert common_speed([small.model_copy(update={"speed": 2 * w}), fast]) == pytest.approx(2 * w)


def test_engines_without_masses_are_marked_as_each_in_its_own_unit() -> None:
    title = side_by_side([load("i4"), load("i6")], "spectrum").to_dict()["title"]
    assert "each in its own m, r and a" in " ".join(title["text"])
    assert "cannot be compared by the lengths drawn" in " ".join(title["subtitle"])
