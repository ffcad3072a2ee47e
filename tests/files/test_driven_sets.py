"""What commands say of an engine that is driven, whose file has a load with a course."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from tests.commands import Run

CASES = Path(__file__).parents[1] / "cases"
PUMP = str(CASES / "four-pump.toml")
DRIVEN = "--set", "gas.imep=0.5 bar", "--set", "gas.friction_pressure=1 bar"
NO_WORK = "gas and friction leave no work that the load could take"


@pytest.mark.release
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


@pytest.mark.release
def test_a_set_that_is_driven_rolls_without_a_course(run: Run) -> None:
    said = " ".join(run("genset", PUMP, *DRIVEN).out.split())
    assert "a course of the load included" not in said
    assert "What drives the engine is fixed to its frame" in said
    assert "a course of the load included" in " ".join(run("genset", PUMP).out.split())


@pytest.mark.release
def test_a_course_of_the_load_twists_no_shaft_and_torsion_says_so(run: Run, tmp_path: Path) -> None:
    plain = (CASES / "torsion-six.toml").read_text(encoding="utf-8")
    course = '\n[drive]\nload_torque = [2, 0]\nload_angle = ["0 deg", "360 deg"]\n'
    found = []
    for place, text in ((tmp_path / "a.toml", plain), (tmp_path / "b.toml", plain + course)):
        place.write_text(text, encoding="utf-8")
        words = "torsion", str(place), "--speed", "1500 rpm"
        said = " ".join(run(*words).out.split())
        assert ("gas and inertia alone twist the shafts" in said) == (text != plain)
        found.append(json.loads(run(*words, "--json").out))
    without, with_course = found
    assert without["orders"] == with_course["orders"]
    assert [each["path"] for each in with_course["rests_on"]].count("drive.load_torque") == 1
