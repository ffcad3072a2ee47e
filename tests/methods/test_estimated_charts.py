"""Figures of engines with estimated masses: ranges are drawn, and texts do not contradict them."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from tests.charted import rows_drawn
from tests.methods.test_charts import Row, drawn, kind

from crankstar import charts
from crankstar.cli.options import read_engine
from crankstar.engine.engine import Engine
from crankstar.files.box import Spread

TWIN = """
format = 1
name = "twin"
cycle = "four-stroke"
speed = "9000 rpm"

[cylinder]
bore = "86 mm"
stroke = "77 mm"
rod_length = "130 mm"
reciprocating_mass = "600 g"
rotating_mass = "700 g"

[layout]
type = "inline"
throws = ["0 deg", "90 deg"]
bore_pitch = "93.04 mm"

[provenance."cylinder.reciprocating_mass"]
status = "estimated"
source = "typical"
range = [0.6667, 1.5]

[provenance."crankshaft.weight.unbalance"]
status = "estimated"
source = "sized for estimated masses"

[provenance."balance_shaft.weight.unbalance"]
status = "estimated"
source = "sized for estimated masses"

[[crankshaft]]
weight = [
    { unbalance = "0.0385 kg*m", z = "46.52 mm", throw = 1 },
    { unbalance = "0.0385 kg*m", z = "-46.52 mm", throw = 2 },
]

[[balance_shaft]]
name = "balancer -1"
up = "1.5146 mm"
right = "98.2345 mm"
weight = [
    { unbalance = "0.01155 kg*m", angle = "180 deg", z = "46.52 mm" },
    { unbalance = "0.01155 kg*m", angle = "90 deg", z = "-46.52 mm" },
]
"""
"""Weights and a balance shaft that leave no first order of the typical masses."""


PISTON, PIN = "cylinder.reciprocating_mass", "cylinder.rotating_mass"


def twin(folder: Path, unknown: str = PISTON) -> tuple[Engine, Spread]:
    """The twin whose mass of this key is estimated."""
    path = folder / "twin.toml"
    path.write_text(TWIN.replace(PISTON, unknown), encoding="utf-8")
    twin = read_engine(str(path))
    assert twin.spread is not None
    return twin.engine, twin.spread


def rows_of(panel: list[tuple[dict[str, Any], list[Row]]], mark: str) -> list[Row]:
    return [row for layer, rows in panel if kind(layer) == mark for row in rows]


def test_the_number_of_a_bar_stands_at_its_end_and_not_at_that_of_its_whisker(
    tmp_path: Path,
) -> None:
    engine, spread = twin(tmp_path)
    with charts.over_ranges([spread]):
        chart = charts.spectrum(engine, speed=900.0)
    ranged = 0
    for panel, spec in zip(drawn(chart), rows_drawn(chart.to_dict()), strict=True):
        px = spec["height"] / spec["layer"][0]["encoding"]["y"]["scale"]["domain"][1]
        ends = {row.order: row.to for row in sorted(rows_of(panel, "bar"), key=lambda row: row.to)}
        whiskers = {row.order: row for row in rows_of(panel, "rule")}
        for layer, rows in panel:
            for row in rows if kind(layer) == "text" else []:
                assert 0 < (row.to - ends.get(row.order, 0.0)) * px < 12, row
                if row.order in whiskers:
                    assert abs(layer["mark"]["dx"]) > 4.5  # half of its end
                    ranged += 1
    assert ranged >= 4
    assert "0" in {row.text for row in rows_of(drawn(chart)[0], "text")}


@pytest.mark.parametrize("quantity", ["force", "couple"])
@pytest.mark.parametrize("unknown", [PISTON, PIN])
def test_no_curve_is_said_to_be_nothing_where_its_range_is_drawn(
    unknown: str, quantity: Any, tmp_path: Path
) -> None:
    engine, spread = twin(tmp_path, unknown)
    with charts.over_ranges([spread]):
        _up, right = drawn(charts.over_turn(engine, quantity=quantity))
    notes = [layer["encoding"]["text"]["value"] for layer, _rows in right if kind(layer) == "text"]
    if unknown == PIN:
        assert rows_of(right, "area")
        assert notes == []
    else:  # pistons in a row push up and down alone, whatever their mass
        assert not rows_of(right, "area")
        assert notes == [{"force": "no horizontal force", "couple": "no yaw"}[quantity]]


def test_the_ends_of_a_balance_shaft_are_told_apart_and_its_numbers_are_no_finer_than_known(
    tmp_path: Path,
) -> None:
    engine, spread = twin(tmp_path)
    with charts.over_ranges([spread]):
        chart = charts.balance_shaft_chart(engine)
    front, side = drawn(chart)
    tips = {row.text: row for row in rows_of(front, "text")}
    assert {"front", "rear", "balancer -1"} == set(tips)
    for end, angle in (("front", 180.0), ("rear", 90.0)):  # bearings in the file, by the planes
        tip = complex(tips[end].anchorUp, tips[end].anchorRight)
        assert np.angle(tip, deg=True) % 360 == pytest.approx(angle)
    words = " ".join(chart.to_dict()["vconcat"][1]["title"]["text"])
    assert "1.51 mm up, 98.2 mm right" in words
    assert "front: unbalance 11.5 kg mm (estimated) at 180° when θ = 0" in words
    assert "rear: unbalance 11.5 kg mm (estimated) at 90° when θ = 0" in words
    assert {row.text for row in rows_of(side, "text")} == {"46.5", "−46.5"}
    subtitle = " ".join(chart.to_dict()["title"]["subtitle"])
    assert "places and arms may rest on them too" in subtitle
