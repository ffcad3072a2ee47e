"""The verb mounts: its tables and what it says, JSON, CSV, Excel; questions that cannot be."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

import numpy as np
import openpyxl
import pytest
from tests.commands import Run, csv_rows
from tests.files.test_mounts import BLOCK, GROUND, THREE
from tests.texts import SHORT, spoilt

import crankstar
from crankstar.dynamics.mount_response import peak, rms
from crankstar.dynamics.mounted_block import MountError, mounted_block
from crankstar.engine.rigid_block import moved
from crankstar.files import engine_of, toml

GAS = {"imep": "4 bar", "compression_ratio": 10, "speed": "900 rpm"}
SPEEDS = "600..6000 rpm/10"


def written(folder: Path, **tables: Any) -> str:
    """An engine file with mounts."""
    path = folder / "mounted.toml"
    own = {"block": BLOCK, "mounts": THREE, "gas": GAS, **tables}
    path.write_text(toml(engine_of(spoilt(SHORT, **own))))
    return str(path)


@pytest.mark.release
def test_machines_get_what_python_computes(run: Run, tmp_path: Path) -> None:
    place = written(tmp_path)
    at = ("--at", "400 mm, 150 mm, -20 mm")
    out = json.loads(run("mounts", place, "--speeds", SPEEDS, *at, "--json").out)
    point = (0.15, -0.02, 0.4)
    found = crankstar.mounts(
        crankstar.load(place), speeds=np.linspace(20, 200, 10) * np.pi, at=point
    )
    assert out["format"] == 1
    assert out["point"] == pytest.approx(point)
    for row, mode in zip(out["modes"], found.modes, strict=True):
        assert row["frequency_hz"] == pytest.approx(mode.frequency)
        assert row["shape"] == pytest.approx(mode.shape)
        assert row["energy"] == pytest.approx(mode.energy)
        assert sum(row["energy"]) == pytest.approx(1)
    over = found.over
    assert over is not None
    displacement = over.displacement(point)
    assert [row["displacement_rms"] for row in out["speeds"]] == pytest.approx(
        1e6 * rms(displacement)
    )
    velocity = 1e3 * peak(over.velocity(point), orders=over.orders)
    assert [row["velocity_peak"] for row in out["speeds"]] == pytest.approx(velocity)
    assert [row["speed_rpm"] for row in out["speeds"]] == pytest.approx(over.speeds * 30 / np.pi)
    assert found.asked * 30 / np.pi == pytest.approx(np.linspace(600, 6000, 10))
    assert out["speeds"][0]["transmissibility"] == pytest.approx(over.transmissibility[0])
    assert [row["name"] for row in out["axes"]] == ["torque_roll", "elastic"]


@pytest.mark.release
def test_each_mount_stands_under_the_headings_of_its_place(run: Run, tmp_path: Path) -> None:
    places = [(20, -300, 100), (-10, 310, 90), (5, 40, -350)]
    named = [
        {"up": f"{up} mm", "right": f"{right} mm", "z": f"{z} mm", "stiffness": "150 N/mm"}
        for up, right, z in places
    ]
    mounts = [{"name": f"mount {number}", **each} for number, each in enumerate(named, 1)]
    out = run("mounts", written(tmp_path, mounts=mounts)).out
    [heads] = re.findall(r"\n +(up +right +along) +its axes .*\n.*\[mm\]", out)
    assert heads.split() == ["up", "right", "along"]
    rows = re.findall(r"(?m)^mount \d +([-−\d]+) +([-−\d]+) +([-−\d]+) +150, 150, 150 ", out)
    assert [tuple(int(cell.replace("−", "-")) for cell in row) for row in rows] == places


@pytest.mark.release
def test_the_sign_of_the_advance_is_told_and_holds(run: Run, tmp_path: Path) -> None:
    """A point on the elastic axis goes to the front with it while the block rolls clockwise."""
    leaning = [{**each, "bearing": "20 deg", "lean": "15 deg"} for each in THREE[:1]]
    place = written(tmp_path, mounts=[*leaning, *THREE[1:]])
    [_roll, elastic] = json.loads(run("mounts", place, "--json").out)["axes"]
    block = mounted_block(crankstar.load(place))
    motion = np.linalg.solve(block.stiffness, [0, 0, 0, 0, 0, 1.0])
    assert motion[5] > 0
    at = np.array([elastic["up"], elastic["right"], elastic["z"]]) / 1e3 - block.centres[0]
    shift = moved(at) @ motion
    turned = np.linalg.norm(motion[3:])
    assert elastic["direction"][2] > 0
    assert shift @ elastic["direction"] / turned * 1e3 == pytest.approx(elastic["advance"])
    assert abs(elastic["advance"]) > 1
    out = " ".join(run("mounts", place).out.split())
    assert "along the axis, positive to the front" in out
    assert "clockwise, seen from the front" in out


@pytest.mark.release
def test_at_one_speed_the_orders_make_the_whole(run: Run, tmp_path: Path) -> None:
    out = json.loads(run("mounts", written(tmp_path), "--speed", "900 rpm", "--json").out)
    sizes = [
        row[name]["amplitude"] ** 2 / 2 for row in out["orders"] for name in ("up", "right", "z")
    ]
    found = crankstar.mounts(crankstar.load(written(tmp_path)), speed=30 * np.pi).at
    assert found is not None
    whole = 1e6 * rms(found.displacement(found.block.body.centre))[0]
    assert np.sqrt(sum(sizes)) == pytest.approx(whole, rel=1e-3)
    assert [row["name"] for row in out["mounts_at_speed"]] == ["left", "right", "rear"]


@pytest.mark.release
def test_the_csv_has_a_row_for_each_speed_and_for_each_peak(run: Run, tmp_path: Path) -> None:
    place = written(tmp_path)
    out = run("mounts", place, "--speeds", SPEEDS, "--csv").out
    rows = csv_rows(out, "speeds")
    speeds = np.array([float(row["speed_rpm [rpm]"]) for row in rows])
    assert np.abs(np.subtract.outer(np.linspace(600, 6000, 10), speeds)).min(axis=1).max() < 1e-6
    fine = crankstar.mounts(crankstar.load(place), speeds=np.linspace(20, 200, 1801) * np.pi)
    assert fine.over is not None
    velocity = 1e3 * rms(fine.over.velocity(fine.point))
    assert max(float(row["velocity_rms [mm/s]"]) for row in rows) == pytest.approx(
        velocity.max(), rel=1e-6
    )


def cells(text: str, title: str) -> list[list[str]]:
    """The rows of a table that is printed, without its headings."""
    lines = text.partition(f"\n{title}\n")[2].partition("\n\n")[0].splitlines()
    rule = next(place for place, line in enumerate(lines) if line.startswith("──"))
    return [line.split() for line in lines[rule + 1 :]]


@pytest.mark.release
def test_the_worst_mounts_are_named_by_force_and_by_transmissibility(
    run: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("COLUMNS", "170")
    hard = [{**each, "stiffness": "2 kN/mm"} for each in THREE[:1]] + THREE[1:]
    place = written(tmp_path, mounts=hard)
    whole = crankstar.mounts(crankstar.load(place), speeds=np.linspace(20, 200, 10) * np.pi)
    found = whole.over
    assert found is not None
    names = [each.name for each in found.block.mounts]
    force = np.column_stack([rms(found.mount_force[:, :, at]) for at in range(3)])
    rows = cells(run("mounts", place, "--speeds", SPEEDS).out, "Vibration over the speeds")
    differ = 0
    for at, row in zip(np.searchsorted(found.speeds, whole.asked), rows[:10], strict=True):
        through = found.transmissibility[at]
        assert [row[-3], row[-1]] == [names[force[at].argmax()], names[through.argmax()]]
        assert float(row[-2]) == pytest.approx(through.max(), rel=1e-2)
        differ += row[-3] != row[-1]
    assert differ


@pytest.mark.release
def test_each_mount_has_columns_of_its_name_in_csv(run: Run, tmp_path: Path) -> None:
    place = written(tmp_path)
    out = run("mounts", place, "--speeds", SPEEDS, "--csv").out
    rows = csv_rows(out, "speeds")
    found = crankstar.mounts(crankstar.load(place), speeds=np.linspace(20, 200, 10) * np.pi).over
    assert found is not None
    for at, name in enumerate(("left", "right", "rear")):
        force = [float(row[f"mount_force_rms_{name} [N]"]) for row in rows]
        assert force == pytest.approx(rms(found.mount_force[:, :, at]))
        through = [float(row[f"transmissibility_{name}"]) for row in rows]
        assert through == pytest.approx(found.transmissibility[:, at])


@pytest.mark.release
def test_orders_that_are_asked_for_are_all_shown(run: Run, tmp_path: Path) -> None:
    asked = ("--speed", "900 rpm", "--orders", "1,10.5,12")
    out = run("mounts", written(tmp_path), *asked).out
    assert [row[0] for row in cells(out, "By order at 900 rpm")] == ["1", "10.5", "12"]


@pytest.mark.release
def test_the_shares_of_every_mode_with_those_of_the_foundation_make_100(
    run: Run, tmp_path: Path
) -> None:
    out = run("mounts", written(tmp_path, foundation=GROUND)).out
    rows = cells(out, "Natural modes")[:12]
    assert [row[0] for row in rows] == [str(mode) for mode in range(1, 13)]
    for row in rows:
        assert len(row[4:]) == 7
        assert sum(map(float, row[4:])) == pytest.approx(100, abs=0.4)


@pytest.mark.release
def test_a_workbook_has_a_sheet_for_each_table(run: Run, tmp_path: Path) -> None:
    book = tmp_path / "mounts.xlsx"
    run("mounts", written(tmp_path), "--speeds", "600..6000 rpm/90", "-o", str(book))
    sheets = openpyxl.load_workbook(book)
    assert {"modes", "axes", "mounts", "speeds"} <= {*sheets.sheetnames}
    assert sheets["speeds"].max_row > 90


@pytest.mark.release
def test_readers_are_told_what_is_assumed_and_left_out(run: Run, tmp_path: Path) -> None:
    out = " ".join(run("mounts", written(tmp_path)).out.split())
    assert "mounts.loss_factor" in out
    assert "torque-roll axis" in out
    assert "Without gas" not in out
    cold = spoilt(SHORT, mounts=THREE, speed="3000 rpm")
    path = tmp_path / "cold.toml"
    path.write_text(toml(engine_of(cold)))
    out = " ".join(run("mounts", str(path)).out.split())
    assert "Without gas: the engine file has no table [gas]." in out
    assert "block.mass" in out


@pytest.mark.release
def test_a_foundation_shows_its_mounts_and_twelve_modes(run: Run, tmp_path: Path) -> None:
    place = written(tmp_path, foundation=GROUND)
    out = json.loads(run("mounts", place, "--speeds", SPEEDS, "--json").out)
    assert len(out["modes"]) == 12
    assert len(out["mounts"]) == 7
    assert len(out["speeds"][0]["mount_force_rms"]) == 3


def test_without_mounts_or_point_there_is_a_sentence(run: Run, tmp_path: Path) -> None:
    refused = run("mounts", "audi-25-tfsi")
    assert "has no mounts; give [[mounts]]" in " ".join(refused.err.split())
    with pytest.raises(MountError, match="has no mounts"):
        crankstar.mounts(crankstar.load("audi-25-tfsi"))
    place = written(tmp_path)
    assert "give z, or z, up and right" in " ".join(
        run("mounts", place, "--at", "1 mm, 2 mm").err.split()
    )
    assert "idle" in run("mounts", place, "--point", "idle").err


RAIL = {**GROUND, "points": [{"name": "rail", "up": "-400 mm"}]}
SUMP = {**BLOCK, "points": [{"name": "sump", "up": "-150 mm"}, {"name": "cover", "up": "400 mm"}]}


@pytest.mark.parametrize(
    ("tables", "at", "said"),
    [
        ({"block": SUMP}, "sumpp", 'no point of the block has this name; there are: "sump", "cove'),
        ({"block": SUMP, "foundation": RAIL}, "rail", "--at rail: this is a point of the found"),
        ({"foundation": RAIL}, "foundation: rail", "this is a point of the foundation, whose vib"),
        ({}, "sump", "--at sump: the engine file names no point in [[block.points]]; give z, or"),
    ],
)
def test_a_point_that_cannot_be_told_is_refused_with_those_that_can(
    run: Run, tmp_path: Path, tables: dict[str, Any], at: str, said: str
) -> None:
    ran = run("mounts", written(tmp_path, **tables), "--at", at)
    assert ran.code != 0
    assert said in " ".join(ran.err.split())


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("mounts", "--orders", "0.3"), "order 0.3 does not occur in"),
        (("mounts", "--orders", "1,0.5,0.75", "--speed", "900 rpm"), "are 0.5, 1, 1.5, 2 and so"),
        (("plot", "mount-response", "--orders", "0.3", "-o", "x.svg"), "order 0.3 does not occur"),
        (("plot", "mount-response", "--orders", "30", "-o", "x.svg"), "give orders up to 24"),
        (("torque", "--orders", "0.3"), "order 0.3 does not occur in"),
    ],
)
def test_an_order_that_cannot_be_is_refused(
    run: Run, tmp_path: Path, words: tuple[str, ...], said: str
) -> None:
    ran = run(words[0], written(tmp_path), *words[1:])
    assert ran.code == 2
    assert said in " ".join(ran.err.split())
    assert not list(tmp_path.glob("*.svg"))


def test_one_speed_for_many_points_to_the_option_for_it(run: Run, tmp_path: Path) -> None:
    ran = run("mounts", written(tmp_path), "--speeds", "750 rpm")
    assert ran.code != 0
    assert "--speeds 750 rpm: this is one value, which --speed takes;" in " ".join(ran.err.split())
    ran = run("isolate", written(tmp_path), "--speeds", "750 rpm")
    assert "give two or more" not in ran.out
    assert "--speed takes" not in ran.err


def test_show_tells_products_of_inertia_and_the_middle_is_nought(run: Run, tmp_path: Path) -> None:
    own = {**BLOCK, "product_up_z": "0.45 kg*m^2", "product_right_z": "-0.2 kg*m^2"}
    five = tmp_path / "five.toml"
    layout = {"type": "inline", "throws": [f"{72 * n} deg" for n in (0, 2, 3, 1, 4)]}
    tree = {**spoilt(SHORT, block=own), "firing_order": [1, 2, 4, 5, 3]}
    tree["layout"] = {**layout, "bore_pitch": "49.3 mm"}
    tree.pop("cylinders", None)
    engine = engine_of(tree)
    exact = toml(engine)
    five.write_text(exact.replace("throw = 3\n", 'throw = 3\nz = "-6.9389e-15 mm"\n'))
    text = run("show", str(five)).out
    said = " ".join(text.split())
    assert (
        "Products of inertia: 0 kg m² of up and right, 0.45 kg m² of up and along, -0.2 kg m² of "
        "right and along." in said
    )
    assert "e-1" not in text.partition("Piston of")[0]


@pytest.mark.release
def test_chosen_units_are_those_of_every_number_and_sentence(
    run: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("COLUMNS", "170")
    place = written(tmp_path, block=SUMP, foundation=RAIL)
    asked = ("--speed", "900 rpm", "--speeds", SPEEDS, "--units", "us")
    out = run("mounts", place, *asked).out
    assert "[lbf/in]" in out
    assert "[in/s]" in out
    found = crankstar.mounts(crankstar.load(place))
    sag = " ".join(out.split()).partition("sits down by ")[2].split()
    assert float(sag[0]) == pytest.approx(-found.sag[0] / 0.0254, rel=1e-3)
    assert sag[1] == "in"
    left = re.findall(r"\b(?:N|mm|um|N/mm|mm/s|mm/rad)\b", out)
    assert not left
    rows = cells(out, "Mounts, and those of the foundation")
    assert float(rows[0][4].rstrip(",")) == pytest.approx(
        200e3 * 0.0254 / 4.4482216152605, rel=1e-4
    )
    plain = json.loads(run("mounts", place, *asked, "--json").out)
    assert plain["mounts"][0]["stiffness"][0] == pytest.approx(200)


@pytest.mark.release
def test_the_point_is_told_with_its_name_and_what_each_length_is(run: Run, tmp_path: Path) -> None:
    out = " ".join(run("mounts", written(tmp_path, block=SUMP)).out.split())
    assert "the point sump (up -150 mm, right 0 mm, along 0 mm); see --at." in out
    at = ("--at", "300 mm, 200 mm, 10 mm")
    out = " ".join(run("mounts", written(tmp_path), *at).out.split())
    assert "the point up 200 mm, right 10 mm, along 300 mm; see --at." in out


def test_all_that_is_wrong_is_told_at_once(run: Run, tmp_path: Path) -> None:
    wrong = {"-o": "x.foo", "--speed": "2 m", "--speeds": "9 rpm", "--orders": "x", "--at": "no"}
    words = [word for pair in wrong.items() for word in pair]
    told = run("mounts", written(tmp_path), *words).err
    assert [option for option in wrong if option not in told] == []
