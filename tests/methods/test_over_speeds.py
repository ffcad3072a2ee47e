"""Amplitudes over the speed: what is printed and drawn against a balance at each speed."""

from __future__ import annotations

import csv
import io
import json
import re
from collections.abc import Callable
from math import pi
from pathlib import Path
from typing import Any

import numpy as np
import openpyxl
import pyarrow.parquet
import pytest
from tests.charted import rows_drawn
from tests.commands import Run
from tests.files.conftest import refused, run

import crankstar
from crankstar import charts, spectra
from crankstar.mechanics.balance import balance, total
from crankstar.mechanics.excitation import rolling_moment

__all__ = ["refused", "run"]

TWIN = """name = "my twin"
cycle = "four-stroke"
[layout]
type = "inline"
throws = ["0 deg", "170 deg"]
bore_pitch = "90 mm"
[cylinder]
stroke = "60 mm"
rod_length = "115 mm"
reciprocating_mass = "320 g"
offset = "4 mm"
"""
SPEEDS = "1000..9000 rpm by 2000"


@pytest.fixture
def twin(tmp_path: Path) -> str:
    path = tmp_path / "twin.toml"
    path.write_text(TWIN, encoding="utf-8")
    return str(path)


def parts(sums: Any) -> dict[str, Any]:
    """The components of force and couple and the roll, as real signals."""
    force, couple = sums.force, sums.couple
    return {
        "Vertical force": spectra.real_signal(force.orders, spectra.vertical(force)),
        "Horizontal force": spectra.real_signal(force.orders, spectra.horizontal(force)),
        "Pitch M_V": spectra.real_signal(couple.orders, spectra.vertical(couple)),
        "Yaw M_H": spectra.real_signal(couple.orders, spectra.horizontal(couple)),
        "Rolling moment": rolling_moment(sums),
    }


def printed_tables(text: str) -> dict[str, tuple[list[str], list[str], list[list[float]]]]:
    """Title, orders, units and rows of each table as a reader sees them."""
    found = re.findall(
        r"^([A-Z][\w ]+)\n(speed .*)\n(\[rpm\].*)\n─+\n((?: *\d.*\n)+)", text, re.MULTILINE
    )
    return {
        title: (
            re.split(r" {2,}", head)[1:],
            re.findall(r"\[(.*?)\]", units)[1:],
            [[float(cell) for cell in row.split()] for row in rows.splitlines()],
        )
        for title, head, units, rows in found
    }


@pytest.mark.release
def test_printed_amplitudes_are_those_of_a_balance_at_each_speed(run: Run, twin: str) -> None:
    out = run("analyze", twin, "--speeds", SPEEDS).out
    tables = printed_tables(out)
    assert set(tables) == {"Vertical force", "Pitch M_V", "Rolling moment"}
    assert "No horizontal force. No yaw." in out
    assert "Inertia forces grow with the square of the speed" in out
    for title, (heads, units, rows) in tables.items():
        assert [row[0] for row in rows] == [1000, 3000, 5000, 7000, 9000]
        for rpm, *cells in rows:
            sums = total(balance(crankstar.load(twin), speed=rpm * pi / 30))
            signal = parts(sums)[title]
            scale = {"kN": 1000.0, "N": 1.0, "N m": 1.0}[units[0]]
            for head, cell in zip(heads, cells, strict=True):
                if head == "peak":
                    expected = spectra.peak(signal).value
                else:
                    order = float(head.removeprefix("order "))
                    wave = spectra.amplitude(spectra.selected(signal, order))
                    expected = float(np.abs(wave)[0])
                assert cell * scale == pytest.approx(expected, rel=2e-4, abs=1e-4), (title, head)


def test_an_engine_without_masses_gives_what_it_can_and_names_what_is_missing(run: Run) -> None:
    out = run("analyze", "v8-cross-plane", "--speeds", "600, 6000 rpm").out
    words = " ".join(out.split())
    keys = "cylinder.stroke, cylinder.reciprocating_mass, layout.bore_pitch"
    assert f"For newtons, add to the file: {keys}." in words
    assert "ω0 is the highest speed, 6000 rpm." in words
    pitch = printed_tables(out)["Pitch M_V"]
    assert pitch[1][0] == "m r ω0² a"
    assert [row[1] for row in pitch[2]] == [pytest.approx(0.031623), pytest.approx(3.1623)]


@pytest.mark.release
def test_csv_parquet_json_and_sheets_hold_the_same_amplitudes(
    run: Run, twin: str, tmp_path: Path
) -> None:
    words = ("analyze", twin, "--speeds", SPEEDS, "--orders", "1,2")
    rows = list(csv.DictReader(io.StringIO(run(*words, "--csv").out)))
    single = run("analyze", twin, "--speed", "5000 rpm", "--orders", "1,2", "--csv").out
    alone = list(csv.DictReader(io.StringIO(single)))
    assert list(rows[0]) == list(alone[0])
    there = [row for row in rows if float(row["speed_rpm"]) == 5000]
    own = [row for row in there if row["order"]]
    keys = ("part", "order", "quantity", "direction", "unit")
    expected = {tuple(row[k] for k in keys): float(row["amplitude"]) for row in alone}
    assert {tuple(row[k] for k in keys): float(row["amplitude"]) for row in own} == {
        key: pytest.approx(value, rel=1e-12, abs=1e-12) for key, value in expected.items()
    }
    whole = json.loads(run("analyze", twin, "--speed", "5000 rpm", "--json").out)["peaks"]
    peaks = [float(row["amplitude"]) for row in there if not row["order"]]
    assert peaks == pytest.approx([row["peak"] for row in whole], rel=1e-6, abs=1e-9)
    tree = json.loads(run(*words, "--json").out)
    assert len(tree["orders"]) == 10
    at = json.loads(run("analyze", twin, "--speed", "9000 rpm", "--orders", "2", "--json").out)
    last = tree["orders"][-1]
    assert (last["speed_rpm"], last["order"]) == (9000, 2)
    assert last["force"]["greatest"] == pytest.approx(at["orders"][0]["force"]["greatest"])
    run(*words, "-o", str(tmp_path / "s.parquet"))
    table = pyarrow.parquet.read_table(tmp_path / "s.parquet").to_pydict()
    assert table["amplitude"] == [float(row["amplitude"]) for row in rows]
    run(*words, "-o", str(tmp_path / "s.xlsx"))
    book = openpyxl.load_workbook(tmp_path / "s.xlsx", read_only=True)
    assert "Vertical force" in book.sheetnames
    sheet = list(book["Vertical force"].iter_rows(values_only=True))
    assert [row[0] for row in sheet[1:6]] == [1000, 3000, 5000, 7000, 9000]
    back = crankstar.load(str(tmp_path / "s.xlsx"))  # the workbook is an engine file as well
    assert len(back.cylinders) == 2


@pytest.mark.release
def test_sweeps_as_spreadsheet_and_parquet_hold_every_pair(
    run: Run, twin: str, tmp_path: Path
) -> None:
    over = ("--over", "speed=1000..3000 rpm by 1000", "--over", "layout.throws[2]=0..360 deg by 90")
    words = ("sweep", twin, *over, "--quantity", "force,couple.pitch", "--orders", "1")
    tree = json.loads(run(*words, "--json").out)
    assert [axis["closed"] for axis in tree["axes"]] == [False, True]
    assert len(tree["values"]) == 15
    rows = list(csv.DictReader(io.StringIO(run(*words, "--csv").out)))
    assert len(rows) == 30
    for row in rows:
        changes = {"layout.throws[2]": f"{float(row['layout.throws[2] [deg]']) % 360} deg"}
        engine = crankstar.load(twin, changes=changes)
        turning = float(row["speed [rpm]"]) * pi / 30
        middle = balance(crankstar.load(twin)).reference
        sums = total(balance(engine, speed=turning, reference=middle))
        whole = {"force": sums.force, "pitch": parts(sums)["Pitch M_V"]}[row["quantity"]]
        first = spectra.selected(whole, [1.0])
        assert float(row["amplitude"]) == pytest.approx(spectra.peak(first).value, abs=1e-8)
        assert row["unit"] == {"force": "N", "pitch": "N*m"}[row["quantity"]]
    run(*words, "-o", str(tmp_path / "s.parquet"))
    table = pyarrow.parquet.read_table(tmp_path / "s.parquet").to_pydict()
    assert table["amplitude"] == [float(row["amplitude"]) for row in rows]
    run(*words, "-o", str(tmp_path / "s.xlsx"))
    book = openpyxl.load_workbook(tmp_path / "s.xlsx", read_only=True)
    values = list(book["values"].iter_rows(values_only=True))
    assert values[0] == (
        "speed [rpm]",
        "layout.throws[2] [deg]",
        "force of order 1 [N]",
        "couple.pitch of order 1 [N*m]",
    )
    assert len(values) == 16
    assert {"best", "front"} <= set(book.sheetnames)
    back = crankstar.load(str(tmp_path / "s.xlsx"))
    assert len(back.cylinders) == 2


@pytest.mark.release
def test_the_chart_holds_the_amplitudes_and_its_command_is_named(
    run: Run, twin: str, tmp_path: Path
) -> None:
    out = run("analyze", twin, "--speeds", SPEEDS).out
    assert "As a chart: crankstar plot" in out
    run("plot", twin, "amplitudes", "--speeds", SPEEDS, "-o", str(tmp_path / "a.json"))
    spec = json.loads((tmp_path / "a.json").read_text(encoding="utf-8"))
    panels = rows_drawn(spec)
    assert len(panels) == 3  # no horizontal force, no yaw
    first = panels[0]["layer"][0]["data"]["values"]
    assert {row["x"] for row in first} == {1000, 3000, 5000, 7000, 9000}
    peak = {row["x"]: row["y"] for row in first if row["what"] == "all orders"}
    sums = total(balance(crankstar.load(twin), speed=9000 * pi / 30))
    scale = 1000 if "kN" in "".join(panels[0]["layer"][0]["encoding"]["y"]["title"]) else 1
    top = spectra.peak(parts(sums)["Vertical force"]).value
    assert peak[9000] * scale == pytest.approx(top, rel=1e-5)
    assert peak[3000] * 9 == pytest.approx(peak[9000], rel=1e-5)


def test_an_engine_of_which_nothing_is_left_has_a_chart_that_says_so() -> None:
    chart = charts.amplitudes(crankstar.load("sinitsyn-7-first"), orders=[3])
    assert "No force and no moment" in json.dumps(chart.to_dict())


@pytest.mark.parametrize(
    ("arguments", "told"),
    [
        (["--speeds", "600..6000"], "--speeds 600..6000: speed has no unit"),
        (["--speeds", "-6..6 rpm"], "--speeds -6..6 rpm: the speed is -6 rpm"),
        (["--speeds", "600..6000 mm"], "a rotational speed is needed"),
        (["--speeds", "6000 rpm"], "this is one value"),
        (["--speeds", "6000..600 rpm by 200"], "write by -200"),
        (["--speeds", "600..600 rpm"], "the range is empty"),
        (["--speeds", "600..6000 rpm by 1e-6"], "at most 20000"),
        (["--speeds", "0..6000 rpm by 200"], "must be greater than 0"),
        (["--speeds", ""], "give speeds"),
        (["--speeds", "fast"], '"fast" is not a number'),
        (["--speeds", SPEEDS, "--speed", "900 rpm"], "--speed"),
        (["--speeds", SPEEDS, "--by", "cylinder"], "--by"),
        (["--speeds", SPEEDS, "--theta", "0 deg"], "--theta"),
        (["--speeds", SPEEDS, "--orders", "0"], "numbers above 0"),
    ],
)
def test_speeds_that_cannot_be_are_refused(
    refused: Callable[..., str],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    arguments: list[str],
    told: str,
) -> None:
    monkeypatch.chdir(tmp_path)
    message = refused("analyze", "i4", *arguments, "-o", "out.csv")
    assert told in message
    assert len(message) < 400
    assert list(tmp_path.iterdir()) == []


def test_speeds_are_for_the_chart_of_amplitudes_only(refused: Callable[..., str]) -> None:
    assert "--speeds" in refused("plot", "i4", "spectrum", "--speeds", SPEEDS)


@pytest.mark.release
def test_the_ranges_of_an_estimated_engine_are_those_of_a_single_speed(
    run: Run, tmp_path: Path
) -> None:
    words = ("bmw-s65", "--estimate", "--speeds", "2000, 8000 rpm")
    tree = json.loads(run("analyze", *words, "--orders", "4", "--json").out)
    alone = ("analyze", "bmw-s65", "--estimate", "--speed", "8000 rpm", "--orders", "4", "--json")
    single = json.loads(run(*alone).out)["orders"][0]["force"]
    over = tree["orders"][-1]["force"]
    for key in ("greatest", "greatest_low", "greatest_high"):
        assert over[key] == pytest.approx(single[key], rel=1e-9)
    out = run("analyze", *words).out
    assert "Estimated as of type petrol: layout.bore_pitch" in " ".join(out.split())
    row = re.search(r"^ 8000 .*?([\d.]+) \(([\d.]+) to ([\d.]+)\)$", out, re.MULTILINE)
    assert row is not None
    run("plot", words[0], "amplitudes", *words[1:], "-o", str(tmp_path / "a.json"))
    spec = json.loads((tmp_path / "a.json").read_text(encoding="utf-8"))
    band = spec["vconcat"][0]["layer"][0]["data"]["values"][-1]
    printed = [float(text) for text in row.groups()[1:]]
    assert [band["low"], band["high"]] == pytest.approx(printed, rel=2e-3)
    assert band["x"] == 8000
