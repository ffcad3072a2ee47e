"""`crankstar compare`: absolute and relative values, names that differ, forms for machines."""

from __future__ import annotations

import csv
import io
import json
import math
import tomllib
from collections.abc import Callable
from pathlib import Path

import openpyxl
import pytest
from tests.commands import Run
from tests.texts import SHORT

import crankstar
from crankstar.tables.comparison import told_apart


@pytest.fixture
def file(tmp_path: Path) -> str:
    """An engine with masses and sizes."""
    (tmp_path / "mine.toml").write_text(SHORT, encoding="utf-8")
    return "mine.toml"


def amplitudes(run: Run, *words: str) -> list[dict[str, str]]:
    rows = csv.DictReader(io.StringIO(run("compare", *words, "--csv").out))
    return [row for row in rows if row["table"] == "amplitudes"]


def test_the_table_of_engines_is_in_the_csv_too(run: Run) -> None:
    rows = csv.DictReader(io.StringIO(run("compare", "i4", "audi-25-tfsi", "--csv").out))
    engines = [row for row in rows if row["table"] == "engines"]
    assert [row["firing"] for row in engines] == [
        "1-3-4-2 every 180 deg",
        "1-2-4-5-3 every 144 deg",
    ]
    shown = json.loads(run("compare", "i4", "audi-25-tfsi", "--json").out)["engines"]
    assert [int(row["unverified"]) for row in engines] == [each["unverified"] for each in shown]


def test_a_compared_amplitude_is_the_one_that_analyze_finds(run: Run) -> None:
    rows = amplitudes(run, "triple-120", "i6", "--orders", "1,2", "--reference", "0.5")
    for name in ("triple-120", "i6"):
        answer = json.loads(
            run("analyze", name, "--orders", "1,2", "--reference", "0.5", "--json").out
        )
        for order in answer["orders"]:
            for quantity in ("force", "couple"):
                (row,) = (
                    row
                    for row in rows
                    if (row["quantity"], row["engine"]) == (quantity, answer["engine"])
                    and row["order"] == str(order["order"])
                )
                expected = order[quantity]["greatest"]
                assert math.isclose(float(row["greatest"]), expected, abs_tol=1e-9)


def test_a_share_is_the_amplitude_over_that_of_the_first(run: Run) -> None:
    rows = amplitudes(run, "single", "v2-90", "i4")
    first = {
        (row["quantity"], row["order"]): float(row["greatest"])
        for row in rows
        if row["engine"] == rows[0]["engine"]
    }
    assert len(rows) == 3 * len(first)
    for row in rows:
        base = first[row["quantity"], row["order"]]
        assert bool(row["share"]) == bool(base)
        if base:
            assert math.isclose(float(row["share"]), float(row["greatest"]) / base)


def test_newtons_of_a_comparison_grow_with_the_square_of_the_speed(run: Run, file: str) -> None:
    low = amplitudes(run, file, file, "--speed", "3000 rpm")
    high = amplitudes(run, file, file, "--speed", "100 Hz")
    assert {row["unit"] for row in low} == {"N", "N*m"}
    assert {row["speed_rpm"] for row in high} == {"6000.0"}
    for slow, fast in zip(low, high, strict=True):
        assert math.isclose(float(fast["greatest"]), 4 * float(slow["greatest"]), rel_tol=1e-9)
        assert fast["share"] == slow["share"] or math.isclose(
            float(fast["share"]), float(slow["share"])
        )


def test_a_change_of_the_second_engine_only_is_in_its_name_and_its_numbers(run: Run) -> None:
    change = "balance_factor=0.5"
    rows = amplitudes(run, "single", "single", "--set", f"2:{change}", "--orders", "1")
    own, changed = dict.fromkeys(row["engine"] for row in rows)
    assert own.endswith("(as in the file)")
    assert changed.endswith(f"({change})")
    forces = [float(row["greatest"]) for row in rows if row["quantity"] == "force" and row["order"]]
    assert forces == pytest.approx([1.0, 0.5])
    both = amplitudes(run, "single", "single", "--set", change, "--orders", "1")
    assert {row["greatest"] for row in both if row["quantity"] == "force" and row["order"]} == {
        "0.5"
    }


def test_the_printed_table_has_amplitudes_and_shares(run: Run) -> None:
    out = run("compare", "single", "v2-90", "--orders", "1,2").out
    heading = next(line for line in out.splitlines() if "order" in line)
    assert "[%]" in out
    assert "share" in heading or "share" in out
    row = next(line for line in out.splitlines() if line.split()[:1] == ["2"])
    own, other, share = map(float, row.split()[1:])
    assert math.isclose(share, 100 * other / own, rel_tol=1e-3)


def test_names_that_are_the_same_get_the_first_mark_that_tells_them_apart() -> None:
    assert told_apart(["a", "a"], ["x", "x"], ["", "k=1"]) == ["a (as in the file)", "a (k=1)"]
    assert told_apart(["a", "b", "a"]) == ["a (1)", "b", "a (2)"]


@pytest.mark.parametrize(
    ("words", "why"),
    [
        (["i4", "i6", "--set", "3:name=x"], "there are 2 engines"),
        (["i4", "i6", "--set", "0:name=x"], "there are 2 engines"),
        (["i4", "i6", "--set", "2:layout.nope=1"], "layout.nope is not a key"),
        (["i4", "i6", "--json", "--csv"], "exclude each other"),
        (["i4", "i6", "--speed", "5 kg"], "a mass; a rotational speed is needed"),
    ],
)
def test_a_comparison_that_cannot_be_is_refused(
    refused: Callable[..., str], words: list[str], why: str
) -> None:
    assert why in refused("compare", *words)


@pytest.mark.many(first=2)
@pytest.mark.parametrize(
    ("words", "name"),
    [
        (["balance", "i6", "--factor", "0.3"], "Six in line, balance factor 0.3"),
        (["balance", "triple-120", "--shafts", "-1"], "Three in line, 120 deg, balance shafts: -1"),
        (
            ["balance", "triple-120", "--minimise", "couple"],
            "Three in line, 120 deg, weights for least couple",
        ),
        (["balance", "v2-90", "--recommended"], "V-twin, 90 deg, one crank pin, balanced as"),
        (["orders", "i4", "--row", "2"], "Four in line, flat crank, fires 1-3-4-2"),
    ],
)
def test_a_written_engine_is_named_after_what_was_changed(
    run: Run, tmp_path: Path, words: list[str], name: str
) -> None:
    run(*words, "-o", "new.toml")
    tree = tomllib.loads((tmp_path / "new.toml").read_text(encoding="utf-8"))
    assert tree["name"].startswith(name)
    assert list(tree)[1] == "name"


@pytest.mark.parametrize("order", ["1-6-3-4-5-2-7", "1-7-2-5-4-3-6"])
def test_the_firing_order_asked_for_is_row_1_and_not_its_mirror_image(run: Run, order: str) -> None:
    out = run("search", "7", "--cycle", "two-stroke", "--all-with", order).out
    (first,) = (line.split() for line in out.splitlines() if line.split()[:1] == ["1"])
    assert first[1] == order


@pytest.mark.parametrize(
    ("setting", "path"), [("bore=90mm", "cylinder.bore"), ("bore_pitch=90mm", "layout.bore_pitch")]
)
def test_a_key_without_its_table_is_refused_with_its_path(
    refused: Callable[..., str], setting: str, path: str
) -> None:
    message = refused("analyze", "i4", "--set", setting)
    assert path in message
    assert "source" not in message


def test_a_spreadsheet_has_orders_and_shares_as_numbers(run: Run) -> None:
    assert run("compare", "i4", "i6", "-o", "both.xlsx").code == 0
    rows = [*openpyxl.load_workbook("both.xlsx")["force"].iter_rows(values_only=True)]
    assert rows[0][3] == "Six in line, of the first [%]"
    numbers = {row[0]: row[1:] for row in rows[1:]}
    assert {2, 4, 6, "peak"} <= numbers.keys()
    for order in (2, 6, "peak"):
        first, other, share = (float(str(value)) for value in numbers[order])
        assert math.isclose(share, 100 * other / first, abs_tol=1e-12)


def test_nothing_is_a_share_of_next_to_nothing(run: Run) -> None:
    """A five's force of order 10 is a millionth of a four's of order 2: no 100 million per cent."""
    peaks = [
        row
        for row in json.loads(run("compare", "audi-25-tfsi", "honda-b18c", "--json").out)[
            "amplitudes"
        ]
        if row["quantity"] == "force" and row["order"] is None
    ]
    assert [row["share"] for row in peaks] == [1.0, None]
    assert 0 < peaks[0]["greatest"] < 1e-5 < 1 < peaks[1]["greatest"]


SIZED = """
name = "{name}"
firing_order = [1, 3, 4, 2]
cylinder = {{ stroke = "{stroke} mm", rod_ratio = 3.5, reciprocating_mass = "{mass} kg" }}
layout = {{ type = "inline", bore_pitch = "200 mm" }}
"""


def sized(folder: Path) -> tuple[str, str]:
    """Files of a large and a small four, alike but for size, without a speed."""
    pairs = (("large", 180, 6.0), ("small", 80, 0.4))
    for name, stroke, mass in pairs:
        text = SIZED.format(name=name, stroke=stroke, mass=mass)
        (folder / f"{name}.toml").write_text(text, encoding="utf-8")
    return "large.toml", "small.toml"


def test_engines_with_sizes_and_no_speed_are_compared_at_one(run: Run, tmp_path: Path) -> None:
    """Forces are as m r, moments as m r^2: 33.75 and 75.94 times."""
    out = json.loads(run("compare", *sized(tmp_path), "--orders", "2", "--json").out)
    rows = {
        (row["quantity"], row["engine"]): row for row in out["amplitudes"] if row["order"] == 2.0
    }
    assert {row["unit"] for row in rows.values()} == {"N", "N*m"}
    assert {row["speed_rpm"] for row in rows.values()} == {1000.0}
    ratio = 6.0 * 180 / (0.4 * 80)
    assert rows["force", "small"]["share"] == pytest.approx(1 / ratio, rel=1e-9)
    assert rows["roll", "small"]["share"] == pytest.approx(80 / 180 / ratio, rel=1e-9)
    force = rows["force", "large"]["greatest"]
    assert force == pytest.approx(4 * 6.0 * 0.09 * (1000 * math.pi / 30) ** 2 / 3.5, rel=0.03)
    paths = {(row["engine"], row["path"]) for row in out["rests_on"] if row["status"] == "assumed"}
    assert {("large", "speed"), ("small", "speed")} <= paths


def test_one_file_with_a_speed_gives_it_to_the_other(run: Run, tmp_path: Path) -> None:
    files = sized(tmp_path)
    asked = ("compare", *files, "--orders", "2", "--json", "--set", '2:speed="3000 rpm"')
    out = json.loads(run(*asked).out)
    assert {row["speed_rpm"] for row in out["amplitudes"]} == {3000.0}
    paths = {(row["engine"], row["path"]) for row in out["rests_on"] if row["status"] == "assumed"}
    assert ("large", "speed") in paths
    assert ("small", "speed") not in paths


def test_python_compares_at_the_same_speed(tmp_path: Path) -> None:
    engines = [crankstar.load(tmp_path / each) for each in sized(tmp_path)]
    (force, *_others) = crankstar.compare(*engines, orders=[2]).tables
    assert force.columns[1].unit == "N"
