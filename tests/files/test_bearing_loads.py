"""`crankstar bearings`: what it prints, read back."""

from __future__ import annotations

import json
import math
from collections.abc import Callable

import pytest
from tests.commands import Run, csv_rows

from crankstar import bearing_loads, cycle, load, spectra

SPEED = 6000 * 3.141592653589793 / 30


def rows_of_places(out: str) -> list[list[str]]:
    """The rows of the table whose bearings stand at assumed places."""
    return [
        row
        for row in map(str.split, out.splitlines())
        if row[:1] + row[3:4] == ["crank", "assumed"]
    ]


@pytest.mark.release
@pytest.mark.parametrize("model", ["determinate", "continuous"])
def test_the_printed_peaks_are_those_of_the_loads(run: Run, model: str) -> None:
    engine = load("audi-25-tfsi", changes={"cylinder.reciprocating_mass": "500 g"})
    loads = bearing_loads(engine, speed=SPEED, model=model)  # pyright: ignore[reportArgumentType]
    words = ["bearings", "audi-25-tfsi", "--set", "cylinder.reciprocating_mass=500 g"]
    out = run(*words, "--speed", "6000 rpm", "--model", model).out
    lines = rows_of_places(out)
    unit = {"N": 1.0, "kN": 1000.0}[out.split("[m", 1)[1].split("[", 1)[1].split("]")[0]]
    assert [unit * float(line[4]) for line in lines] == pytest.approx(
        spectra.peaks(loads.load).tolist(), rel=1e-4
    )


@pytest.mark.release
def test_the_printed_loads_with_gas_are_those_of_the_operating_point(run: Run) -> None:
    engine = load("audi-25-tfsi")
    loads = bearing_loads(engine, cycle=cycle(engine, point="idle"))
    out = run("bearings", "audi-25-tfsi", "--point", "idle").out
    assert "operating point idle, 750 rpm" in out
    lines = rows_of_places(out)
    unit = {"N": 1.0, "kN": 1000.0}[out.split("[mm]", 1)[1].split("[", 1)[1].split("]")[0]]
    assert [unit * float(line[4]) for line in lines] == pytest.approx(
        spectra.peaks(loads.load).tolist(), rel=1e-4
    )
    tree = json.loads(run("bearings", "audi-25-tfsi", "--gas", "--json").out)
    assert (tree["point"], len(tree["wear"])) == ("full", 11)
    peaks = [row["peak"]["value"] for row in tree["bearings"]]
    expected = spectra.peaks(bearing_loads(engine, cycle=cycle(engine)).load)
    assert peaks == pytest.approx(expected.tolist())


@pytest.mark.release
def test_the_printed_wear_is_on_the_inner_side_of_a_pin_that_a_rod_pulls_outward(run: Run) -> None:
    tree = json.loads(run("bearings", "audi-25-tfsi", "--json").out)
    engine = load("audi-25-tfsi")
    rows = {row["journal"]: row for row in tree["wear"]}
    for number, throw in enumerate(engine.shafts[0].throws, 1):
        out = math.degrees(throw.angle)
        inner = (rows[f"pin {number}"]["most_deg"] - out) % 360
        hole = (rows[f"pin {number}"]["least_deg"] - out) % 360
        assert inner == pytest.approx(180, abs=1)
        assert min(hole, 360 - hole) == pytest.approx(0, abs=1)


def test_gas_without_masses_is_refused_with_what_it_needs(refused: Callable[..., str]) -> None:
    told = refused("bearings", "bmw-s65", "--gas")
    assert told.strip().endswith("give cylinder.reciprocating_mass")  # its speed is in the file


@pytest.mark.release
def test_json_and_csv_have_every_bearing_and_order(run: Run) -> None:
    loads = bearing_loads(load("v8-cross-plane"))
    tree = json.loads(run("bearings", "v8-cross-plane", "--json").out)
    assert (tree["model"], tree["unit"], len(tree["bearings"])) == ("determinate", "m*r*w^2", 5)
    text = run("bearings", "v8-cross-plane", "--csv").out
    for table in ("orders", "bearings", "pins", "guides", "wear", "bending"):
        assert len(csv_rows(text, table)) == len(tree[table])
    for row in tree["orders"]:
        one = spectra.selected(loads.load[row["bearing"] - 1], row["order"])
        for side in ("forward", "backward"):
            assert complex(*row[side]) == pytest.approx(complex(getattr(one, side)[0]), abs=1e-12)


def test_steady_loads_of_an_offset_crank_are_order_nought(run: Run) -> None:
    out = run("bearings", "single", "--set", "cylinder.offset=0.2", "--orders", "all").out
    assert any(
        line.split()[:3] == ["crank", "1", "0"] and "steady" in line for line in out.splitlines()
    )


def test_an_unknown_model_is_refused(run: Run) -> None:
    refused = run("bearings", "i4", "--model", "elastic")
    assert refused.code == 2
    assert "determinate, continuous" in refused.err


SETTINGS = (
    "oil.viscosity=8 mPa*s",
    "oil.main.diameter=58 mm",
    "oil.main.length=20 mm",
    "oil.main.clearance=25 um",
    "oil.pin.diameter=47.8 mm",
    "oil.pin.length=20 mm",
)


@pytest.mark.release
def test_the_printed_pressures_are_loads_over_diameter_times_length(run: Run) -> None:
    settings = [word for each in SETTINGS for word in ("--set", each)]
    tree = json.loads(run("bearings", "audi-25-tfsi", "--gas", *settings, "--json").out)
    engine = load("audi-25-tfsi")
    loads = bearing_loads(engine, cycle=cycle(engine))
    rows = {row["journal"]: row for row in tree["films"]}
    peaks = spectra.peaks(loads.load).tolist()
    assert rows["main 2"]["pressure"] == pytest.approx(peaks[1] / (0.058 * 0.020), rel=1e-4)
    pin = float(spectra.peaks(loads.pin)[0]) / (0.0478 * 0.020)
    assert rows["pin 1"]["pressure"] == pytest.approx(pin, rel=1e-4)
    assert rows["pin 1"]["film"] is None  # without a clearance
    assert 1 < rows["main 2"]["film"] < 25
    text = run("bearings", "audi-25-tfsi", "--gas", *settings).out
    assert "least film" in text
    assert "give clearance and oil.viscosity" in text


def test_a_unit_of_another_kind_is_one_sentence(refused: Callable[..., str]) -> None:
    told = refused("bearings", "audi-25-tfsi", "--set", "oil.viscosity=8 mm")
    assert 'viscosity is needed, such as "8 mPa*s"' in told


def test_bearings_out_of_all_proportion_are_refused_together(refused: Callable[..., str]) -> None:
    slips = ("oil.main.diameter=58 mm", "oil.main.length=200 mm", "oil.main.clearance=40 mm")
    told = refused("bearings", "audi-25-tfsi", *(w for each in slips for w in ("--set", each)))
    assert "oil.main.clearance is 40000 um" in told
    assert "oil.main.length is 200 mm" in told


@pytest.mark.release
@pytest.mark.parametrize("verb", ["bearings", "torque"])
def test_cylinders_that_are_off_are_named(run: Run, verb: str) -> None:
    words = [verb, "audi-25-tfsi", "--point", "idle", "--off", "2"]
    out = run(*words).out
    assert "ithout combustion" in out
    assert json.loads(run(*words, "--json").out)["off"] == [2]
