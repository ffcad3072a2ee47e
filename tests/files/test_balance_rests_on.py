"""What `balance` prints counts for what it rests on: rows with gas, the load on a main bearing."""

from __future__ import annotations

import json
import re
from math import pi
from pathlib import Path
from typing import Any

import pytest
from tests.commands import Run

from crankstar.files import engine_of
from crankstar.remedy.counterweights import with_counterweights
from crankstar.studies.answers import rests_on
from crankstar.studies.load_answers import balanced

MOWER: dict[str, Any] = {
    "name": "lawn-mower single",
    "firing_order": [1],
    "speed": "3060 rpm",
    "cylinder": {
        "bore": "68.3 mm",
        "stroke": "51.8 mm",
        "rod_length": "95 mm",
        "reciprocating_mass": "265 g",
        "rotating_mass": "200 g",
        "throw_mass": "150 g",
    },
    "layout": {"type": "inline"},
    "gas": {"compression_ratio": 8, "imep": "7 bar"},
}
FOUR: dict[str, Any] = {
    "name": "in-line four",
    "firing_order": [1, 3, 4, 2],
    "speed": "4000 rpm",
    "cylinder": {
        "stroke": "95.5 mm",
        "rod_length": "144 mm",
        "reciprocating_mass": "790 g",
        "rotating_mass": "640 g",
    },
    "layout": {"type": "inline", "bore_pitch": "88 mm"},
}
ROW = r"1 rolling moment with gas N m ([\d.]+)"


def _balanced(run: Run, folder: Path, **gas: str) -> str:
    path = folder / "mower.json"
    path.write_text(json.dumps({**MOWER, "gas": MOWER["gas"] | gas}))
    return " ".join(run("balance", str(path)).out.split())


@pytest.mark.release
def test_rows_with_gas_name_the_gas_that_they_assume(run: Run, tmp_path: Path) -> None:
    """At both ends of the intake pressure the row is that of a file with this pressure."""
    said = _balanced(run, tmp_path)
    assert "the gas torque is not in" not in said
    assert "Gas is in the rows of the rolling moment with gas alone" in said
    told = re.search(
        r"gas.intake_pressure: 1 bar assumed.*? From ([\d.]+ bar) to ([\d.]+ bar) the rolling "
        r"moment with gas of order 1 is ([\d.]+) to ([\d.]+) N m",
        said,
    )
    assert told is not None
    for end, size in zip(told.groups()[:2], told.groups()[2:], strict=True):
        row = re.search(ROW, _balanced(run, tmp_path, intake_pressure=end))
        assert row is not None
        assert float(row[1]) == pytest.approx(float(size), rel=5e-3)
    assert "crankshaft.bearings: main bearings assumed beside the throws" in said


def test_the_load_of_a_bearing_rests_on_crankpins_places_and_model() -> None:
    """Two throws that point one way: r w^2 (m_pin + half of a piston) on the bearing between."""
    engine = engine_of(FOUR)
    after = with_counterweights(engine, factor=0.5)
    answer = balanced(after, fitted=True, gas_orders=())
    found = {each.path: each for each in rests_on(after, answer)}
    own = found["cylinder.throw_mass"]
    assert own.moved is not None
    assert (own.moved.quantity, own.moved.order) == ("main bearing", 1.0)
    unit = 0.04775 * (4000 * pi / 30) ** 2
    ends = [unit * (0.395 + pin) for pin in (0.0, own.low or 0.0, own.high or 0.0)]
    assert (own.moved.now, own.moved.low, own.moved.high) == pytest.approx(ends, rel=1e-6)
    assert {"--model", "crankshaft.bearings"} & {*found} == {"--model"}  # the middle one stays
    continuous = balanced(after, fitted=True, gas_orders=(), model="continuous")
    other = continuous.figures(after)["main bearing", 1.0]
    model = found["--model"].moved
    assert model is not None
    assert model.high == pytest.approx(other)
    assert other > 1.5 * model.now
