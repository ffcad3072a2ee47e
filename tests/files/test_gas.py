"""The tables `[gas]` and `[drive]`, the verb torque, and every mistake in them."""

from __future__ import annotations

import json
import re
from collections.abc import Sequence
from math import cos, degrees, radians
from pathlib import Path
from typing import Any

import numpy as np
import openpyxl
import pytest
from tests.commands import Run
from tests.texts import SHORT, spoilt

from crankstar.dynamics.uneven import UnevenError, driven
from crankstar.files import EngineFileError, engine_of, toml, tree_of
from crankstar.mechanics.gas import cycle
from crankstar.mechanics.operating_points import GasError

GAS = {
    "compression_ratio": 10.5,
    "imep": "11 bar",
    "combustion_start": "-15 deg",
    "point": [
        {"name": "idle", "speed": "800 rpm", "imep": "1.8 bar", "intake_pressure": "0.4 bar"}
    ],
}
FOUR = """
name = "In-line four"
firing_order = [1, 3, 4, 2]
speed = "6000 rpm"
[cylinder]
bore = "82 mm"
stroke = "90 mm"
rod_length = "145 mm"
reciprocating_mass = "480 g"
[layout]
type = "inline"
bore_pitch = "91 mm"
"""
ANGLES = range(-360, 360, 2)


def trace(scale: float = 1.0, angles: Any = ANGLES) -> dict[str, Any]:
    """A pressure that falls from 50 bar to both sides of firing."""
    pressures = [scale * (1 + 49 * max(cos(radians(angle / 4)), 0.0) ** 40) for angle in angles]
    return {
        "angle": [f"{angle} deg" for angle in angles],
        "pressure": [[f"{pressure} bar" for pressure in pressures]],
    }


def mistakes(**tables: Any) -> list[str]:
    """The codes of the faults of a file with these tables."""
    with pytest.raises(EngineFileError) as refusal:
        engine_of(spoilt(SHORT, **tables))
    return [fault.code for fault in refusal.value.faults]


def test_a_cycle_and_a_drive_are_the_same_written_and_read_back() -> None:
    drive = {"inertia": "0.2 kg*m^2", "load_exponent": 2}
    engine = engine_of(spoilt(SHORT, gas=GAS, drive=drive))
    again = engine_of(tree_of(toml(engine)))
    assert again.gas is not None
    assert again.gas == engine.gas
    assert again.drive == engine.drive
    assert degrees(again.gas.combustion_start or 0) == pytest.approx(-15)
    assert again.gas.points[0].name == "idle"


def test_a_trace_is_the_same_written_and_read_back() -> None:
    engine = engine_of(spoilt(SHORT, gas={"trace": trace()}))
    again = engine_of(tree_of(toml(engine)))
    assert again.gas is not None
    assert again.gas.trace is not None
    assert engine.gas is not None
    assert engine.gas.trace is not None
    assert np.array(again.gas.trace.pressure) == pytest.approx(np.array(engine.gas.trace.pressure))


@pytest.mark.parametrize(
    ("gas", "code"),
    [
        ({"imep": "9 bar", "bmep": "8 bar"}, "gas.two-loads"),
        ({"imep": "90 bar"}, "gas.too-high"),
        ({"process": "diesel", "peak_pressure": "90 bar"}, "gas.diesel-peak"),
        ({"combustion_start": "345 deg"}, "gas.start"),
        ({"combustion_duration": "0 deg"}, "gas.duration"),
        ({"point": [{"name": "a"}, {"name": "a"}]}, "gas.same-name"),
        ({"trace": trace(), "process": "otto"}, "gas.trace-and-process"),
        ({"trace": trace(), "imep": "9 bar"}, "gas.trace-and-load"),
        ({"trace": trace(0.01)}, "trace.unit"),
        ({"trace": trace(20)}, "trace.unit"),
        ({"trace": trace(angles=range(-360, 300, 2))}, "trace.gap"),
        ({"trace": trace(angles=range(-360, 0, 2))}, "trace.gap"),
        ({"trace": trace(angles=range(-360, 366, 2))}, "trace.more-than-a-cycle"),
        ({"trace": trace(angles=range(360, -360, -2))}, "trace.not-ascending"),
        ({"trace": trace(angles=range(-360, 360, 40))}, "trace.too-few"),
        ({"trace": trace(angles=range(0, 700, 2))}, "trace.jump"),
        ({"trace": trace() | {"pressure": trace()["pressure"] * 3}}, "trace.lists"),
        ({"trace": trace() | {"pressure": [["1 bar"] * 40]}}, "trace.lengths"),
        ({"trace": trace() | {"chambers": [1, 99]}}, "trace.chambers"),
    ],
)
def test_each_mistake_of_a_cycle_has_its_sentence(gas: dict[str, Any], code: str) -> None:
    assert code in mistakes(gas=gas)


@pytest.mark.parametrize(
    ("drive", "code"),
    [
        ({"load_angle": ["0 deg"], "load_torque": []}, "drive.lengths"),
        ({"load_angle": ["0 deg", "9 deg"], "load_torque": [1, -1]}, "drive.no-load"),
        ({"load_angle": ["9 deg", "0 deg"], "load_torque": [1, 1]}, "drive.angles"),
        ({"output": "rear"}, "drive.no-such-crankshaft"),
        ({"output": "crank", "gearing": "output"}, "drive.output-and-gears"),
        ({"inertia_shares": [0.5, 0.5]}, "drive.shares"),
        ({"gearing": "chain"}, "choice"),
        ({"inertia_shares": [1.1]}, "at-most"),
    ],
)
def test_each_mistake_of_a_drive_has_its_sentence(drive: dict[str, Any], code: str) -> None:
    assert mistakes(drive=drive) == [code]


def test_pressures_without_unit_are_refused_and_named() -> None:
    with pytest.raises(EngineFileError) as refusal:
        engine_of(spoilt(SHORT, gas={"imep": 9, "intake_pressure": "1"}))
    assert {fault.path for fault in refusal.value.faults} == {
        ("gas", "imep"),
        ("gas", "intake_pressure"),
    }


VALUES = [
    "",
    "x",
    -1,
    0,
    1e300,
    "1 bar",
    "-3 bar",
    "9 furlongs",
    [],
    {},
    True,
    None,
    "1e9 bar",
    2.5,
]


@pytest.mark.release
@pytest.mark.parametrize("seed", [0, pytest.param(1, marks=pytest.mark.release)])
def test_any_spoilt_cycle_is_an_engine_or_a_sentence(seed: int) -> None:
    """Thousands of tables with wrong values: an engine whose torque is a number, or a refusal."""
    chance = np.random.default_rng(seed)

    def pick(options: Sequence[Any]) -> Any:
        return options[int(chance.integers(len(options)))]

    engines = 0
    for _ in range(300 if seed == 0 else 10_000):
        gas: dict[str, Any] = json.loads(json.dumps(GAS))
        for _ in range(pick([1, 1, 2, 3])):
            key = pick([*gas, "process", "gamma", "wiebe_m", "peak_pressure", "trace"])
            gas[key] = pick(VALUES)
        if chance.random() < 0.2:
            gas["process"] = pick(["otto", "diesel", "limited-pressure"])
        gas = {key: value for key, value in gas.items() if value is not None}
        try:
            found = cycle(engine_of(spoilt(SHORT, gas=gas)))
        except (EngineFileError, GasError):
            continue
        engines += 1
        assert np.isfinite(found.pressure).all()
        assert found.pressure.min() > 0
    assert engines > 5


@pytest.fixture
def four(tmp_path: Path) -> str:
    """A four-stroke in-line four, turning clockwise."""
    (tmp_path / "four.toml").write_text(FOUR, encoding="utf-8")
    return str(tmp_path / "four.toml")


def torque(run: Run, *arguments: str) -> dict[str, Any]:
    return json.loads(run("torque", *arguments, "--json").out)


def test_the_answer_of_torque_is_the_promised_one(run: Run, four: str) -> None:
    told = torque(run, four, "--imep", "10 bar", "--speed", "6000 rpm")
    assert told["format"] == 1
    assert told["imep"] == pytest.approx(1e6)
    assert told["power"] == pytest.approx(told["mean_torque"] * 6000 * np.pi / 30)
    orders = {row["order"]: row for row in told["orders"]}
    for order in (0.5, 1.0, 1.5, 2.5, 3.0):
        assert orders[order]["gas"] == [0.0, 0.0]
        assert orders[order]["total"] == [0.0, 0.0]
    second = orders[2.0]
    assert np.array(second["total"]) == pytest.approx(
        np.array(second["gas"]) + np.array(second["inertia"])
    )
    # after firing gas drives, and the pistons take up energy
    assert second["gas"][1] < 0 < second["inertia"][1]
    assert np.array(second["roll"]) == pytest.approx(-np.array(second["total"]), rel=1e-6)


@pytest.mark.release
def test_a_cylinder_that_is_off_brings_up_half_orders(run: Run) -> None:
    told = torque(run, "honda-b18c", "--imep", "10 bar", "--off", "2")
    whole = torque(run, "honda-b18c", "--imep", "10 bar")
    sizes = {row["order"]: float(np.hypot(*row["gas"])) for row in told["orders"]}
    assert sizes[0.5] > sizes[1.0] > sizes[1.5] > 5
    assert told["off"] == [2]
    assert told["mean_torque"] < 0.77 * whole["mean_torque"]


def test_a_motored_engine_gives_nothing_and_has_no_half_orders(run: Run) -> None:
    told = torque(run, "honda-b18c", "--motored")
    assert told["mean_torque"] < 0
    assert abs(told["mean_torque"]) < 2


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("--off", "9"), "no cylinder has the number 9"),
        (("--off", "two"), "numbers of cylinders"),
        (("--imep", "10"), "without a unit"),
        (("--imep", "10 bar", "--bmep", "9 bar"), "both say"),
        (("--imep", "-3 bar"), "greater than 0"),
        (("--imep", "0.1 bar", "--set", "gas.intake_pressure=1.5 bar"), "without any combustion"),
        (("--point", "idle"), "no operating point idle: its file has no [[gas.point]]"),
        (("--flywheel", "1 m"), "moment of inertia"),
        (("--flywheel", "0.1 kg*m^2"), "reciprocating_mass"),
        (("--orders", "24.5"), "orders up to 24"),
        (("--orders", "1,900"), "orders up to 24"),
        (("--set", "gas.process=limited-pressure", "--set", "gas.peak_pressure=9 bar"), "alone"),
    ],
)
def test_a_wrong_request_of_torque_is_told_in_a_sentence(
    arguments: tuple[str, ...], words: str, run: Run
) -> None:
    result = run("torque", "honda-b18c", *arguments)
    assert words in " ".join(result.err.split())
    assert "Traceback" not in result.err


def test_an_engine_that_would_stop_within_its_cycle_is_told_of(run: Run, four: str) -> None:
    result = run("torque", four, "--flywheel", "0.001 kg*m^2", "--speed", "60 rpm")
    assert result.code == 2
    assert "would stop" in result.err


@pytest.mark.parametrize("exponent", [-1.0, 0.0, 2.0])
def test_an_engine_too_light_for_any_speed_of_that_mean_would_stop(exponent: float) -> None:
    """With so little inertia it is too fast on the whole even where it all but stops."""
    light = engine_of(
        {
            "format": 1,
            "name": "light",
            "firing_order": [1],
            "speed": "10 rpm",
            "cylinder": {
                "bore": "500 mm",
                "stroke": "250 mm",
                "rod_length": "250 mm",
                "reciprocating_mass": "1 kg",
            },
            "layout": {"type": "inline", "throws": ["0 deg"]},
            "drive": {"inertia": "0.1 kg*m^2", "load_exponent": exponent},
        }
    )
    with pytest.raises(UnevenError, match="would stop"):
        driven(light, cycle(light))


@pytest.mark.release
@pytest.mark.parametrize(
    "values",
    [
        ("variable_gamma=true", "intake_pressure=0.02 bar"),
        ("variable_gamma=true", "combustion_start=90 deg", "combustion_duration=180 deg"),
        ("wall_temperature=450 K", "speed=1 rpm"),
    ],
)
def test_a_charge_that_cannot_be_is_refused_or_computed(
    values: tuple[str, ...], run: Run, four: str
) -> None:
    settings = [word for value in values for word in ("--set", f"gas.{value}")]
    result = run("torque", four, *settings)
    assert result.code in (0, 2)
    assert "Traceback" not in result.err


def test_a_drive_without_inertia_cannot_run(run: Run, four: str) -> None:
    result = run("torque", four, "--set", "drive.inertia=0 kg*m^2")
    assert result.code == 2
    assert "would stop" in result.err


def test_a_measured_pressure_takes_no_other_load(run: Run, tmp_path: Path) -> None:
    rows = zip(trace()["angle"], trace()["pressure"][0], strict=True)
    text = "\n".join(f"{a.split()[0]}\t{p.split()[0]}".replace(".", ",") for a, p in rows)
    place = written(tmp_path, text)
    assert torque(run, place)["peak_pressure"] == pytest.approx(50e5)
    assert "load of its own" in run("torque", place, "--imep", "5 bar").err


def test_an_engine_without_bore_says_what_it_needs(run: Run) -> None:
    assert "cylinder.bore" in run("torque", "i4").err


@pytest.mark.release
def test_what_is_assumed_is_told_and_what_is_given_is_not(run: Run) -> None:
    shown = " ".join(run("torque", "honda-b18c").out.split())
    assert re.search(r"gas\.compression_ratio(: 10 assumed| \(10\))", shown)
    assert "gas.imep: 9 bar assumed" in shown
    given = run("torque", "honda-b18c", "--set", "gas.compression_ratio=11", "--imep", "8 bar").out
    assert "gas.compression_ratio" not in given
    assert "gas.imep" not in given


@pytest.mark.release
def test_an_uneven_run_has_the_irregularity_of_its_speeds(run: Run, four: str) -> None:
    arguments = (four, "--imep", "2 bar", "--speed", "800 rpm", "--flywheel", "0.15 kg*m^2")
    told = torque(run, *arguments)["irregularity"]
    text = run("torque", *arguments).out
    rows = {line.rsplit("  ", 2)[0].strip(): line.split() for line in text.splitlines()}
    low, high = (
        float(next(cells for name, cells in rows.items() if name.startswith(start))[-2])
        for start in ("least speed", "greatest speed")
    )
    assert (high - low) / 800 == pytest.approx(told, rel=2e-3)


@pytest.mark.release
def test_a_spreadsheet_holds_the_cycle_the_orders_and_the_speed(
    run: Run, four: str, tmp_path: Path
) -> None:
    arguments = (four, "--imep", "2 bar", "--flywheel", "0.15 kg*m^2")
    told = torque(run, *arguments)
    assert run("torque", *arguments, "-o", str(tmp_path / "t.xlsx")).code == 0
    sheets = [*openpyxl.load_workbook(tmp_path / "t.xlsx").worksheets]
    rows = [row for sheet in sheets for row in sheet.iter_rows(values_only=True)]
    cells = {row[0]: row[1] for row in reversed(rows) if len(row) > 1}
    assert cells["mean_torque"] == pytest.approx(told["mean_torque"])
    assert cells["irregularity"] == pytest.approx(told["irregularity"])
    second = next(row for row in told["orders"] if row["order"] == 2.0)
    by_order = next(sheet for sheet in sheets if "order" in sheet.title)
    cosine_and_sine = next(r[1:3] for r in by_order.iter_rows(values_only=True) if r[0] == 2)
    assert [*cosine_and_sine] == pytest.approx(second["gas"])


RACER = ("kr250-racer", "--imep", "9 bar")


@pytest.mark.release
def test_the_gears_of_two_crankshafts_are_told_with_the_flywheel_here_and_there(run: Run) -> None:
    alike, with_load = torque(run, *RACER)["meshes"]
    assert (alike["crankshaft"], alike["onto"], alike["idler"]) == ("rear", "front", False)
    assert (alike["inertia_share"], with_load["inertia_share"]) == (0.5, 0.0)
    assert alike["force"] == pytest.approx(alike["greatest"] / 0.045)
    assert alike["reversals"] == len(alike["reversals_deg"]) == 2
    assert alike["mean"] == pytest.approx(torque(run, *RACER)["mean_torque"] / 2)
    shown = run("torque", *RACER).out
    assert "Gears between crankshafts" in shown
    assert "drive.inertia_shares gives it" in " ".join(shown.split())
    assert "meshes" not in torque(run, "parallel-twin-180", "--imep", "9 bar")


@pytest.mark.release
def test_a_drive_says_where_the_load_is_and_how_the_inertia_is_shared(run: Run) -> None:
    shares = ("--set", "drive.inertia_shares=[0.2, 0.3]")
    (mesh,) = torque(run, *RACER, *shares)["meshes"]
    assert mesh["inertia_share"] == 0.3
    (mesh,) = torque(run, *RACER, *shares, "--set", "drive.output=rear")["meshes"]
    assert (mesh["crankshaft"], mesh["inertia_share"]) == ("front", 0.2)
    output = ("--set", "drive.gearing=output", "--set", "drive.pitch_radius=30 mm")
    front, rear = torque(run, *RACER, *shares, *output)["meshes"]
    assert (front["onto"], rear["onto"], front["pitch_radius"]) == (None, None, 30.0)
    shown = " ".join(run("torque", *RACER, *shares, *output).out.split())
    assert "the output" in shown
    assert "is assumed" not in shown.split("Gears")[1].split("Pressure")[0]
    assert "too great" not in run("check", "kr250-racer").err
    refused = run("torque", *RACER, "--set", "drive.inertia_shares=[0.6, 0.6]").err
    assert "adds up to 1.2" in " ".join(refused.split())


@pytest.mark.release
def test_the_gears_follow_the_varying_speed_where_the_flywheel_is_known(run: Run) -> None:
    words = (*RACER, "--speed", "3000 rpm", "--set", "cylinder.reciprocating_mass=400 g")
    linear, exact = (
        torque(run, *words, *flywheel)["meshes"][0]
        for flywheel in ((), ("--flywheel", "0.03 kg*m^2"))
    )
    assert exact["mean"] == pytest.approx(linear["mean"])
    assert exact["greatest"] == pytest.approx(linear["greatest"], rel=0.05)
    assert exact["greatest"] != pytest.approx(linear["greatest"], rel=1e-4)


@pytest.mark.release
def test_the_gears_are_in_the_spreadsheet(run: Run, tmp_path: Path) -> None:
    assert run("torque", *RACER, "-o", str(tmp_path / "t.xlsx")).code == 0
    sheets = [*openpyxl.load_workbook(tmp_path / "t.xlsx").worksheets]
    rows = [row for sheet in sheets for row in sheet.iter_rows(values_only=True)]
    alike = next(row for row in rows if row[0] == "rear")
    work = torque(run, *RACER)["meshes"][0]["work"]
    assert any(isinstance(cell, float) and cell == pytest.approx(work) for cell in alike)


def test_a_drive_with_gears_is_the_same_written_and_read_back() -> None:
    drive = {"output": "crank", "inertia_shares": [0.5], "pitch_radius": "45 mm"}
    engine = engine_of(spoilt(SHORT, drive=drive))
    assert engine_of(tree_of(toml(engine))).drive == engine.drive


def written(tmp_path: Path, text: str) -> str:
    (tmp_path / "p.csv").write_text(text, encoding="utf-8")
    place = tmp_path / "mine.toml"
    place.write_text(SHORT + '\n[gas]\ntrace = "p.csv"\n', encoding="utf-8")
    return str(place)


@pytest.mark.many(first=3)
@pytest.mark.parametrize("separator", [",", ";", "\t"])
@pytest.mark.parametrize(("unit", "factor"), [("bar", 1.0), ("kPa", 100.0), ("MPa", 0.1)])
def test_a_trace_is_read_from_a_file_in_any_form(
    separator: str, unit: str, factor: float, run: Run, tmp_path: Path
) -> None:
    rows = [
        (angle, factor * (1 + 49 * max(cos(radians(angle / 4)), 0.0) ** 40))
        for angle in range(-360, 361)
    ]
    lines = [f"{angle}{separator}{pressure:.6f}" for angle, pressure in rows]
    if separator == ";":
        lines = [line.replace(".", ",") for line in lines]
    text = "\n".join([f"angle{separator}p [{unit}]", *lines])
    told = torque(run, written(tmp_path, text))
    assert told["peak_pressure"] == pytest.approx(50e5, rel=1e-6)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("angle,p\n0,1\n1,x\n", "line 3 is 1, x"),
        ("angle,p\n0,1\n1\n", "line 3 is 1"),
        ("", "no two columns"),
        ("0\n1\n2\n", "no two columns"),
    ],
)
def test_a_file_that_is_no_trace_is_told_with_its_line(
    text: str, words: str, run: Run, tmp_path: Path
) -> None:
    err = run("torque", written(tmp_path, text)).err
    assert words in " ".join(err.split())


def test_a_trace_that_is_not_there_is_told(run: Run, tmp_path: Path) -> None:
    place = tmp_path / "mine.toml"
    place.write_text(SHORT + '\n[gas]\ntrace = "nowhere.csv"\n', encoding="utf-8")
    assert "nowhere.csv, but there is no file" in run("check", str(place)).err


@pytest.mark.release
def test_the_same_torque_is_told_in_every_language(run: Run) -> None:
    assert "ガストルク" in run("torque", "honda-b18c", "--language", "ja").out
    assert "момент газовых сил" in run("torque", "honda-b18c", "--language", "ru").out
