"""The verb genset: its tables and what it says, JSON, CSV; questions that cannot be."""

from __future__ import annotations

import csv
import io
import json
from math import degrees
from pathlib import Path
from typing import Any

import pytest
from tests.commands import Run
from tests.marine import SEVEN, marine_engine
from tests.terminal_tables import blocks

from crankstar.analyses.genset.generating_set import generating_set
from crankstar.files import toml


def written(folder: Path) -> str:
    path = folder / "seven.toml"
    path.write_text(toml(marine_engine(drive={"inertia": "90000 kg*m^2"})))
    return str(path)


@pytest.mark.release
def test_machines_get_what_python_computes(run: Run, tmp_path: Path) -> None:
    asked = ("--pole-pairs", "20", "--engines", "4")
    out = json.loads(run("genset", written(tmp_path), *asked, "--json").out)
    engine = marine_engine(drive={"inertia": "90000 kg*m^2"})
    found = generating_set(engine, pole_pairs=20, engines=4)
    assert out["format"] == 1
    assert found.running is not None
    assert found.angle is not None
    assert out["irregularity"] == pytest.approx(found.running.irregularity)
    assert out["electrical_deg"] == pytest.approx(20 * degrees(found.angle.greatest))
    assert out["frequency_hz"] == pytest.approx(20 * 104 / 60)
    for row, one in zip(out["sums"], found.sums, strict=True):
        assert (row["quantity"], row["order"]) == (one.quantity, one.order)
        assert (row["worst"], row["typical"]) == pytest.approx((one.worst, one.typical))
        assert row["exceeded_5"] == pytest.approx(one.exceeded[0])


@pytest.mark.release
def test_one_engine_has_no_columns_of_several_for_readers(run: Run, tmp_path: Path) -> None:
    place = written(tmp_path)
    for engines, titles in ((1, 0), (3, 4)):
        out = run("genset", place, "--engines", str(engines))
        title = next(name for name in blocks(out.out) if "on" in name.lower() and "rpm" in name)
        [table] = blocks(out.out)[title]
        found = json.loads(run("genset", place, "--engines", str(engines), "--json").out)["sums"]
        columns = {each.heading: each.cells for each in table}
        assert len(columns) == 4 + titles
        assert [float(cell) * 1e3 for cell in columns["one engine"]] == pytest.approx(
            [row["one"] for row in found], rel=6e-5
        )
        if engines == 3:
            assert [float(cell) * 1e3 for cell in columns["rms over all phases"]] == pytest.approx(
                [3**0.5 * row["one"] for row in found], rel=6e-5
            )
        assert set(columns["unit"]) == {"kN m"}


@pytest.mark.release
def test_readers_are_told_what_is_counted_and_missing(run: Run, tmp_path: Path) -> None:
    asked = ("--pole-pairs", "20", "--engines", "4", "--irregularity", "1/100")
    out = " ".join(run("genset", written(tmp_path), *asked).out.split())
    for said in (
        "degree of irregularity",
        "greatest electrical angle",
        "inertia of crankshaft, flywheel and rotor for what is wanted",
        "4 engines on one foundation",
        "No limits for uneven running are quoted",
        "count as at one place",
    ):
        assert said in out
    out = " ".join(run("genset", "i4").out.split())
    assert "Without uneven running: the engine file has no table [gas]." in out
    assert (
        "Without forces on the foundation: not known: masses (cylinder.reciprocating_mass), the "
        "stroke (cylinder.stroke), the distance of the cylinders (layout.bore_pitch), a speed (see "
        "--speed)." in out
    )
    out = " ".join(run("genset", "audi-25-tfsi").out.split())
    assert "see --flywheel" in out


def test_the_csv_has_a_row_for_each_order_of_each_quantity(run: Run, tmp_path: Path) -> None:
    out = run("genset", written(tmp_path), "--engines", "2", "--csv").out
    rows = list(csv.DictReader(io.StringIO(out)))
    sums = [row for row in rows if row["table"] == "sums"]
    orders = [(row["quantity"], float(row["order"])) for row in sums]
    assert orders[:3] == [("pitch", 1), ("pitch", 2), ("pitch", 4)]


@pytest.mark.release
def test_the_csv_has_uneven_running_too(run: Run, tmp_path: Path) -> None:
    asked = (written(tmp_path), "--pole-pairs", "20", "--irregularity", "1/100")
    facts = json.loads(run("genset", *asked, "--json").out)
    rows = csv.DictReader(io.StringIO(run("genset", *asked, "--csv").out))
    running = {row["quantity"]: float(row["value"]) for row in rows if row["table"] == "running"}
    assert running["electrical"] == pytest.approx(facts["electrical_deg"])
    assert running["frequency"] == pytest.approx(facts["frequency_hz"])
    assert running["wanted_inertia"] == pytest.approx(facts["wanted_inertia"])
    assert running["behind"] == pytest.approx(-facts["behind_deg"])
    assert running["irregularity"] == facts["irregularity"]
    assert running["one_part_in"] * running["irregularity"] == pytest.approx(1)


@pytest.mark.many(first=3)
@pytest.mark.parametrize(
    ("options", "said"),
    [
        (("--engines", "0"), "give a whole number from 1 to 64"),
        (("--pole-pairs", "1000"), "give a whole number from 1 to 200"),
        (("--flywheel", "-2 kg*m^2"), "greater than 0"),
        (("--flywheel", "2 m"), "moment of inertia"),
        (("--point", "idle"), "idle"),
    ],
)
def test_what_cannot_be_is_one_sentence(
    run: Run, tmp_path: Path, options: tuple[str, ...], said: str
) -> None:
    refused = run("genset", written(tmp_path), *options)
    assert refused.code == 2
    assert said in " ".join(refused.err.split())


@pytest.mark.release
def test_the_sums_are_at_the_speed_that_they_name(run: Run, tmp_path: Path) -> None:
    """Of an operating point slower than the engine, and without what even running needs."""
    point = [{"name": "idle", "speed": "52 rpm", "bmep": "4 bar"}]
    path = tmp_path / "idle.toml"
    path.write_text(toml(marine_engine(gas={"ignition": "compression", "point": point})))
    out = json.loads(run("genset", str(path), "--point", "idle", "--json").out)
    assert out["speed_rpm"] == pytest.approx(52)
    fast = json.loads(run("genset", written(tmp_path), "--json").out)
    slow, full = (  # gas does not grow with the speed: forces and couples of inertia do
        [row["one"] for row in each["sums"] if row["quantity"] != "roll"] for each in (out, fast)
    )
    assert [one * 4 for one in slow] == pytest.approx(full)
    idle = ("genset", str(path), "--point", "idle")
    assert "On the foundation at 52 rpm" in run(*idle).out
    assert "3 engines on one foundation at 52 rpm" in run(*idle, "--engines", "3").out


@pytest.mark.parametrize(
    ("changes", "missing"),
    [
        ({}, "inertia of crankshaft, flywheel and rotor (see --flywheel)"),
        ({"drive": {"inertia": "90000 kg*m^2"}, "speed": None}, "a speed (see --speed)"),
    ],
)
def test_what_uneven_running_lacks_is_named(
    run: Run, tmp_path: Path, changes: dict[str, Any], missing: str
) -> None:
    path = tmp_path / "seven.toml"
    kept = {key: value for key, value in SEVEN["gas"].items() if key != "bmep"}
    gas = kept | {"imep": "15 bar", "friction": "none"}
    path.write_text(toml(marine_engine(gas=gas, **changes)))
    out = " ".join(run("genset", str(path)).out.split())
    assert f"Without uneven running: not known: {missing}." in out
    bare = " ".join(run("genset", "man-s90mc-c", "--flywheel", "1 t*m^2").err.split())
    assert (
        "--flywheel has no effect. Without uneven running: not known: masses "
        "(cylinder.reciprocating_mass)." in bare
    )


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (
            ("i4", "--pole-pairs", "2"),
            "--pole-pairs has no effect. Without uneven running: the eng",
        ),
        (
            ("i4", "--irregularity", "1/100", "--flywheel", "1 kg*m^2"),
            "--flywheel, --irregularity have no effect. Without uneven running: the engine file",
        ),
        (("audi-25-tfsi", "--pole-pairs", "2"), "see --flywheel"),
        (("man-s90mc-c", "--engines", "3"), "--engines has no effect. Without forces on the found"),
    ],
)
def test_an_option_without_effect_is_refused_and_why(
    run: Run, words: tuple[str, ...], said: str
) -> None:
    ran = run("genset", *words)
    assert (ran.code, ran.out) == (2, "")
    assert said in " ".join(ran.err.split())


def test_all_that_is_wrong_is_told_at_once(run: Run, tmp_path: Path) -> None:
    wrong = {"-o": "x.foo", "--engines": "0", "--flywheel": "2 m", "--irregularity": "7"}
    words = [word for pair in wrong.items() for word in pair]
    told = run("genset", written(tmp_path), *words).err
    assert [option for option in wrong if option not in told] == []


@pytest.mark.release
def test_a_small_number_beside_great_ones_of_other_units_has_its_range(run: Run) -> None:
    asked = ("--flywheel", "10 kg*m^2", "--estimate", "--json")
    rows = json.loads(run("genset", "napier-deltic", *asked).out)["running"]
    ends = {row["quantity"]: (row.get("value_low"), row.get("value_high")) for row in rows}
    parts = [1 / each for each in ends["one_part_in"]]
    assert ends["irregularity"][0] <= min(parts) < max(parts)
    assert ends["irregularity"][1] == pytest.approx(max(parts))
    assert ends["ahead"][0] < ends["ahead"][1]
    assert ends["speed"] == (None, None)
