"""One rule of operating point and speed: a command at a point is one at its speed and load."""

from __future__ import annotations

import json
from math import pi
from pathlib import Path
from typing import Any

import pytest
from tests.commands import Run

import crankstar
from crankstar import spectra
from crankstar.engine.engine import Engine
from crankstar.mechanics.gas import cycle
from crankstar.mechanics.gas_loads import gas_over_speeds
from crankstar.mechanics.gas_torque import gas_torque
from crankstar.mechanics.operating_points import GasError, operating_state
from crankstar.studies.fault_kinds import Fault
from crankstar.studies.single_faults import shaken

RPM = pi / 30
CASES = Path(__file__).parents[1] / "cases"
POINTS = """
[[gas.point]]
name = "idle"
speed = "700 rpm"
imep = "2 bar"
intake_pressure = "0.4 bar"
friction_pressure = "1 bar"
[[gas.point]]
name = "full"
speed = "1500 rpm"
imep = "9 bar"
intake_pressure = "1.6 bar"
friction_pressure = "2 bar"
[torsion]
inertia = "0.05 kg*m^2"
stiffness = "2 MN*m/rad"
disc = [{ name = "flywheel", inertia = "1 kg*m^2", to = "rear", stiffness = "4 MN*m/rad" }]
"""


@pytest.fixture
def files(tmp_path: Path) -> tuple[str, str, str]:
    """A file with two points; with the load of the first alone; with one between them alone.

    900 rpm is a quarter of the way from 700 to 1500 rpm, and so is its load.
    """
    text = (CASES / "genset-four.toml").read_text(encoding="utf-8").replace('imep = "9 bar"\n', "")
    assert "[drive]" in text
    own = POINTS[POINTS.index("[torsion]") :]
    ignition = 'ignition = "compression"\n'

    def alone(rpm: int, imep: float, intake: float, friction: float) -> str:
        load = f'imep = "{imep} bar"\nintake_pressure = "{intake} bar"\n'
        load += f'friction_pressure = "{friction} bar"\n'
        turning = text.replace('speed = "1500 rpm"', f'speed = "{rpm} rpm"', 1)
        return turning.replace(ignition, ignition + load) + own

    texts = (text + POINTS, alone(700, 2.0, 0.4, 1.0), alone(900, 3.75, 0.7, 1.25))
    for number, each in enumerate(texts):
        (tmp_path / f"{number}.toml").write_text(each, encoding="utf-8")
    first, second, third = (str(tmp_path / f"{number}.toml") for number in range(3))
    return first, second, third


def numbers(found: Any) -> Any:
    """All of a document but the names of its engine and points."""
    if isinstance(found, dict):
        skipped = ("point", "points", "operating_point", "operating_points", "gas_over_speeds")
        names = (*skipped, *RANGE, "engine", "file")
        if {"speeds", "response", "criticals"} & {*found}:  # rests on what its range has, too
            names = (*names, "rests_on")
        return {key: numbers(value) for key, value in found.items() if key not in names}
    if isinstance(found, float):
        return float(f"{found:.8g}")
    if isinstance(found, str):  # of the file with one load, that load has no name
        return found.replace("gas.point.idle", "gas")
    return [numbers(each) for each in found] if isinstance(found, list) else found


def near(one: Any, other: Any, path: str = "") -> None:
    """Asserts that two documents have the same numbers, but for rounding of sums of waves."""
    if isinstance(one, dict):
        assert one.keys() == other.keys(), path
        for key, value in one.items():
            near(value, other[key], f"{path}/{key}")
    elif isinstance(one, list):
        assert len(one) == len(other), path
        for place, value in enumerate(one):
            near(value, other[place], f"{path}/{place}")
    elif isinstance(one, float):
        assert one == pytest.approx(other, rel=1e-6, abs=1e-5), path
    else:
        assert one == other, path


def answer(run: Run, *words: str) -> Any:
    ran = run(*words, "--json")
    assert ran.code == 0, ran.err
    return numbers(json.loads(ran.out))


VERBS = {
    "torque": (),
    "genset": (),
    "bearings": ("--gas",),
    "fault": ("--cut", "3"),
    "diagnose": ("readings.csv",),
    "mounts": (),
    "torsion": (),
    "marine": (),
    "guide": (),
}
READINGS = """order,up,right,z,direction,amplitude,phase
2,100 mm,50 mm,0 mm,up,3.1 mm/s,20
2,100 mm,50 mm,0 mm,right,2.2 mm/s,80
0.5,100 mm,50 mm,0 mm,right,4.5 mm/s,-70
1,0 mm,-50 mm,200 mm,up,1.5 mm/s,140
"""


RANGE = ("speeds", "response", "criticals", "barred", "greatest")
"""What stands in a document over a range of speeds, over which a named point is the same."""


def command(verb: str, file: str) -> tuple[str, ...]:
    """A command line of a file."""
    Path("readings.csv").write_text(READINGS, encoding="utf-8")
    return (verb, file, *VERBS[verb])


@pytest.mark.release
@pytest.mark.parametrize("verb", VERBS)
def test_a_command_at_a_point_is_the_one_at_its_speed_and_load(
    run: Run, files: tuple[str, str, str], verb: str
) -> None:
    points, alone, _between = files
    fixed = ("--speed", "700 rpm") if verb in ("mounts", "torsion") else ()
    named = answer(run, *command(verb, points), "--point", "idle", *fixed)
    asked = ("--speed", "700 rpm")
    both = answer(run, *command(verb, points), "--point", "idle", *asked)
    near(named, both)
    near(named, answer(run, *command(verb, points), *asked))
    near(named, answer(run, *command(verb, alone), *fixed))


@pytest.mark.release
@pytest.mark.parametrize("verb", VERBS)
def test_a_command_between_two_points_is_the_one_at_the_load_between_them(
    run: Run, files: tuple[str, str, str], verb: str
) -> None:
    points, _alone, between = files
    asked = ("--speed", "900 rpm")
    there = run(*command(verb, points), *asked, "--json")
    assert there.code == 0, there.err
    found = json.loads(there.out)
    shares = [{"name": "idle", "share": 0.75}, {"name": "full", "share": 0.25}]
    told = found["points"][0] if verb == "diagnose" else found["points"]
    assert [(each["name"], round(each["share"], 9)) for each in told] == [
        (each["name"], each["share"]) for each in shares
    ]
    speed = found["speeds_rpm"][0] if verb == "diagnose" else found["speed_rpm"]
    assert speed == pytest.approx(900)
    near(numbers(found), answer(run, *command(verb, between), *asked))
    text = run(*command(verb, points), *asked).out
    assert "idle 75 %, full 25 %" in " ".join(text.split())


@pytest.mark.many(first=1)
@pytest.mark.parametrize("figure", ["torque", "pressure", "side-thrust"])
def test_a_figure_of_gas_names_the_points_between_which_it_is(
    run: Run, files: tuple[str, str, str], figure: str
) -> None:
    assert run("plot", files[0], figure, "--speed", "900 rpm", "-o", "figure.svg").code == 0
    drawn = Path("figure.svg").read_text(encoding="utf-8")
    assert "idle 75 %, full 25 %, at 900 rpm, imep 3.75 bar" in drawn


@pytest.mark.parametrize(
    ("asked", "meant"),
    [
        ({}, ("full", 1500.0)),
        ({"point": "full"}, ("full", 1500.0)),
        ({"point": "full", "speed": 900 * RPM}, ("full", 900.0)),
        ({"speed": 1500 * RPM}, ("full", 1500.0)),
        ({"speed": 600 * RPM}, ("idle", 600.0)),
        ({"speed": 1600 * RPM}, ("full", 1600.0)),
    ],
)
def test_point_and_speed_follow_one_rule(
    files: tuple[str, str, str], asked: dict[str, Any], meant: tuple[str, float]
) -> None:
    engine = crankstar.load(files[0])
    state = operating_state(engine, **asked)
    assert (state.point, (state.speed or 0.0) / RPM) == (meant[0], pytest.approx(meant[1]))
    found = cycle(engine, **asked)
    assert (found.name, found.speed) == (state.point, state.speed)


def test_between_two_points_all_of_a_cycle_is_between_theirs(files: tuple[str, str, str]) -> None:
    engine, alone = crankstar.load(files[0]), crankstar.load(files[2])
    found = cycle(engine, speed=900 * RPM, off=[3])
    one, other = (cycle(engine, point=point, off=[3]) for point in ("idle", "full"))
    assert found.pressure == pytest.approx(0.75 * one.pressure + 0.25 * other.pressure, rel=1e-12)
    same = cycle(alone, off=[3])
    assert found.pressure == pytest.approx(same.pressure, rel=1e-9)
    assert found.air_fuel_ratio == pytest.approx(same.air_fuel_ratio, rel=1e-9)
    assert (found.imep, found.friction, found.peak) == (
        pytest.approx(same.imep, rel=1e-9),
        pytest.approx(1.25e5),
        pytest.approx(same.peak, rel=1e-9),
    )


def test_a_load_that_is_asked_for_is_that_between_two_points(files: tuple[str, str, str]) -> None:
    engine = crankstar.load(files[0], changes={"gas.point[2].combustion_start": "-2 deg"})
    assert cycle(engine, speed=900 * RPM, imep=5e5).imep == pytest.approx(5e5, rel=1e-9)
    assert cycle(engine, speed=900 * RPM, bmep=3e5).bmep == pytest.approx(3e5, rel=1e-9)
    assert cycle(engine, speed=900 * RPM, peak_pressure=60e5).peak == pytest.approx(60e5, rel=1e-8)


@pytest.mark.many(first=1)
@pytest.mark.parametrize(
    "changes",
    [
        {},
        {
            "gas.point": [
                {"name": "idle", "speed": "700 rpm", "bmep": "1.5 bar"},
                {"name": "full", "speed": "1500 rpm", "bmep": "9 bar", "intake_pressure": "2 bar"},
            ],
            "gas.friction": "diesel",
        },
        {"gas.wall_temperature": "430 K"},
    ],
)
def test_a_range_of_speeds_has_at_each_what_the_command_has_there(
    files: tuple[str, str, str], changes: dict[str, Any]
) -> None:
    engine = crankstar.load(files[0], changes=changes)
    speeds = [rpm * RPM for rpm in (300, 420, 610, 700, 1010, 1500, 1990)]
    for point in ("", "idle"):
        found = spectra.amplitude(gas_over_speeds(engine, speeds, point=point))
        for row, speed in zip(found, speeds, strict=True):
            one = spectra.amplitude(gas_torque(cycle(engine, point=point, speed=speed)).total)
            assert row == pytest.approx(one, rel=1e-4, abs=2e-5 * abs(one).max())


def test_a_fault_without_point_and_speed_joins_no_two_states(files: tuple[str, str, str]) -> None:
    engine: Engine = crankstar.load(files[0])
    found = shaken(engine, [Fault("combustion", 3)])
    assert (found.state.point, found.speed) == ("full", pytest.approx(1500 * RPM))
    with pytest.raises(GasError):
        shaken(engine, point="none")


@pytest.mark.release
def test_a_fault_prints_its_speed_and_point(run: Run, files: tuple[str, str, str]) -> None:
    lines = {
        ("--point", "idle"): "At 700 rpm, operating point idle.",
        (): "At 1500 rpm, operating point full.",
        ("--speed", "1500 rpm"): "At 1500 rpm, operating point full.",
        ("--speed", "900 rpm"): "At 900 rpm, with a load between the points idle 75 %, full 25 %.",
        ("--speed", "1600 rpm"): "At 1600 rpm, with the load of the point full.",
    }
    for words, line in lines.items():
        assert line in run("fault", files[0], "--cut", "3", *words).out


def test_the_point_that_is_taken_without_a_name_is_that_of_the_speed(
    run: Run, files: tuple[str, str, str]
) -> None:
    """The second point has the speed of the file; the help of the option has the rule."""
    whole, _first, _between = files
    assert operating_state(crankstar.load(whole)).point == "full"
    for verb in ("fault", "torque", "mounts"):
        described = " ".join(run(verb, "--help").out.replace("│", " ").split())
        assert "speed" in described.partition("--point ")[2].partition(" --")[0]
