"""What commands say of an engine that is driven, whose file has a load with a course."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from tests.commands import Run

PUMP = str(Path(__file__).parents[1] / "cases" / "four-pump.toml")
DRIVEN = "--set", "gas.imep=0.5 bar", "--set", "gas.friction_pressure=1 bar"
NO_WORK = "gas and friction leave no work that the load could take"


@pytest.mark.many(first=1)
@pytest.mark.parametrize("command", ["genset", "torque"])
def test_a_driven_engine_has_its_course_left_out_once_and_in_the_record(
    run: Run, command: str
) -> None:
    said = " ".join(run(command, PUMP, *DRIVEN).out.split())
    assert said.count(NO_WORK) == 1
    told = json.loads(run(command, PUMP, *DRIVEN, "--json").out)["rests_on"]
    paths = [(each["path"], each["status"]) for each in told if each["path"].startswith("drive")]
    assert paths == [("drive.load_torque", "left out")]
    assert NO_WORK not in run(command, PUMP).out


def test_a_set_that_is_driven_rolls_without_a_course(run: Run) -> None:
    said = " ".join(run("genset", PUMP, *DRIVEN).out.split())
    assert "a course of the load included" not in said
    assert "What drives the engine is fixed to its frame" in said
    assert "a course of the load included" in " ".join(run("genset", PUMP).out.split())
