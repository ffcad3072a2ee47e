"""One rule of operating point and speed: a command at a point is one at its speed and load."""

from __future__ import annotations

import json
from math import pi
from pathlib import Path
from typing import Any

import pytest
from tests.commands import Run

import crankstar
from crankstar.engine.engine import Engine
from crankstar.mechanics.gas import cycle
from crankstar.mechanics.operating_points import GasError, operating_state
from crankstar.studies.single_faults import Fault, shaken

RPM = pi / 30
CASES = Path(__file__).parents[1] / "cases"
POINTS = """
[[gas.point]]
name = "idle"
speed = "700 rpm"
imep = "2 bar"
intake_pressure = "0.4 bar"
[[gas.point]]
name = "full"
speed = "1500 rpm"
imep = "9 bar"
[torsion]
inertia = "0.05 kg*m^2"
stiffness = "2 MN*m/rad"
disc = [{ name = "flywheel", inertia = "1 kg*m^2", to = "rear", stiffness = "4 MN*m/rad" }]
"""


@pytest.fixture
def files(tmp_path: Path) -> tuple[str, str]:
    """A file with two points, and one with nothing but speed and load of the first."""
    text = (CASES / "genset-four.toml").read_text(encoding="utf-8").replace('imep = "9 bar"\n', "")
    assert "[drive]" in text
    with_points = tmp_path / "points.toml"
    with_points.write_text(text + POINTS, encoding="utf-8")
    own = POINTS[POINTS.index("[torsion]") :]
    text = text.replace('speed = "1500 rpm"', 'speed = "700 rpm"', 1)
    ignition = 'ignition = "compression"\n'
    load = ignition + 'imep = "2 bar"\nintake_pressure = "0.4 bar"\n'
    alone = tmp_path / "alone.toml"
    alone.write_text(text.replace(ignition, load) + own, encoding="utf-8")
    return str(with_points), str(alone)


def numbers(found: Any) -> Any:
    """All of a document but the names of its engine and points."""
    if isinstance(found, dict):
        skipped = ("point", "operating_point", "operating_points", "engine", "file")
        return {key: numbers(value) for key, value in found.items() if key not in skipped}
    return [numbers(each) for each in found] if isinstance(found, list) else found


def answer(run: Run, *words: str) -> Any:
    ran = run(*words, "--json")
    assert ran.code == 0, ran.err
    return numbers(json.loads(ran.out))


@pytest.mark.release
@pytest.mark.parametrize(
    ("verb", "more"),
    [
        ("torque", ()),
        ("genset", ()),
        ("bearings", ("--gas",)),
        ("fault", ("--cut", "3")),
        ("mounts", ("--speeds", "600..700 rpm by 100")),
        ("torsion", ("--speeds", "600..800 rpm by 100")),
        ("marine", ()),
        ("guide", ()),
    ],
)
def test_a_command_at_a_point_is_the_one_at_its_speed_and_load(
    run: Run, files: tuple[str, str], verb: str, more: tuple[str, ...]
) -> None:
    points, alone = files
    fixed = ("--speed", "700 rpm") if verb in ("mounts", "torsion") else ()
    named = answer(run, verb, points, *more, "--point", "idle", *fixed)
    assert named == answer(run, verb, points, *more, "--point", "idle", "--speed", "700 rpm")
    assert named == answer(run, verb, points, *more, "--speed", "700 rpm")
    assert named == answer(run, verb, alone, *more, *fixed)


@pytest.mark.parametrize(
    ("asked", "meant"),
    [
        ({}, ("idle", 700.0)),
        ({"point": "full"}, ("full", 1500.0)),
        ({"point": "full", "speed": 900 * RPM}, ("full", 900.0)),
        ({"speed": 1500 * RPM}, ("full", 1500.0)),
        ({"speed": 900 * RPM}, ("idle", 900.0)),
    ],
)
def test_point_and_speed_follow_one_rule(
    files: tuple[str, str], asked: dict[str, Any], meant: tuple[str, float]
) -> None:
    engine = crankstar.load(files[0])
    state = operating_state(engine, **asked)
    assert (state.point, (state.speed or 0.0) / RPM) == (meant[0], pytest.approx(meant[1]))
    found = cycle(engine, **asked)
    assert (found.name, found.speed) == state


def test_a_fault_without_point_and_speed_joins_no_two_states(files: tuple[str, str]) -> None:
    engine: Engine = crankstar.load(files[0])
    found = shaken(engine, [Fault("combustion", 3)])
    assert (found.point, found.speed) == ("idle", pytest.approx(700 * RPM))
    with pytest.raises(GasError):
        shaken(engine, point="none")


def test_a_fault_prints_its_speed_and_point(run: Run, files: tuple[str, str]) -> None:
    lines = {
        ("--point", "idle"): "At 700 rpm, operating point idle.",
        (): "At 700 rpm, operating point idle.",
        ("--speed", "1500 rpm"): "At 1500 rpm, operating point full.",
        ("--speed", "900 rpm"): "At 900 rpm, with a load between the points idle, full.",
    }
    for words, line in lines.items():
        assert line in run("fault", files[0], "--cut", "3", *words).out
