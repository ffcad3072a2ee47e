"""A speed that is asked for stands for the estimated one, in every command."""

from __future__ import annotations

import json
from math import pi
from pathlib import Path
from typing import Any

import pytest
from tests.commands import Run

import crankstar
from crankstar.mechanics.gas_torque import friction_torque

GENSET = """name = "genset eight"
firing_order = [1, 4, 7, 6, 8, 5, 2, 3]
[cylinder]
bore = "320 mm"
stroke = "400 mm"
rod_length = "800 mm"
reciprocating_mass = "150 kg"
[layout]
type = "inline"
bore_pitch = "490 mm"
[gas]
ignition = "compression"
bmep = "22 bar"
intake_pressure = "2.4 bar"
"""
AT = ("--speed", "750 rpm", "--estimate")
ASKED = (
    ("analyze", *AT, "--json"),
    ("analyze", "--speeds", "500..750 rpm/2", "--estimate", "--json"),
    ("torque", *AT, "--json"),
    pytest.param(("genset", *AT, "--flywheel", "600 kg*m^2", "--json"), marks=pytest.mark.release),
    pytest.param(("bearings", *AT, "--json"), marks=pytest.mark.release),
    ("sweep", "--over", "cylinder.stroke=380..400 mm/2", *AT, "--json"),
    ("sweep", "--over", "speed=500..750 rpm/2", "--estimate", "--json"),
    ("verdict", *AT),
)


@pytest.fixture
def genset(tmp_path: Path) -> str:
    """Eight cylinders without a speed in their file."""
    place = tmp_path / "gen.toml"
    place.write_text(GENSET)
    return str(place)


@pytest.mark.many(first=2)
@pytest.mark.parametrize("words", ASKED)
def test_a_speed_that_is_asked_for_is_not_said_to_be_estimated(
    words: tuple[str, ...], run: Run, genset: str
) -> None:
    """What a given speed replaces is in no list; what it does not replace is."""
    verb, *options = words
    printed = run(verb, genset, *options)
    assert printed.code == 0, printed.err
    if "--json" not in options:
        listed = next(line for line in printed.out.splitlines() if line.startswith("Estimated as"))
        assert "speed" not in listed
        return
    told: dict[str, Any] = json.loads(printed.out)
    paths = [row["path"] for row in told.get("estimated", [])]
    paths += [row["path"] for row in told.get("rests_on", []) if row["status"] == "estimated"]
    assert "speed" not in paths
    if verb != "sweep":
        assert "cylinder.throw_mass" in paths


@pytest.mark.release
def test_what_is_asked_at_a_speed_is_that_of_a_file_with_that_speed(genset: str) -> None:
    """And its brake torque is p_me V_H / 4 pi; without one the speed is estimated."""
    asked = crankstar.torque(genset, speed=750 * pi / 30, estimate=True)
    filled = crankstar.torque(genset, changes={"speed": "750 rpm"}, estimate=True)
    assert asked.cycle.speed == filled.cycle.speed == pytest.approx(25 * pi)
    volume = 8 * pi / 4 * 0.32**2 * 0.4
    alone = crankstar.torque(genset, estimate=True)
    assert isinstance(asked.source, crankstar.Engine)
    assert isinstance(alone.source, crankstar.Engine)
    assert "speed" not in asked.source.provenance
    assert alone.source.provenance["speed"].status == "estimated"
    mean = float(crankstar.gas_torque(asked.cycle).mean.sum())
    lost = friction_torque(asked.cycle)
    assert lost is not None
    assert mean - lost == pytest.approx(22e5 * volume / (4 * pi), rel=1e-6)


def test_a_whole_file_at_a_speed_has_nothing_to_estimate(run: Run, tmp_path: Path) -> None:
    """Where the speed alone is lacking, --estimate with --speed says that it changes nothing."""
    place = tmp_path / "whole.toml"
    place.write_text(GENSET.replace('mass = "150 kg"', 'mass = "150 kg"\nrotating_mass = "90 kg"'))
    printed = run("torque", str(place), *AT)
    assert "--estimate changes nothing here" in printed.err
    assert "stimated" not in printed.out
