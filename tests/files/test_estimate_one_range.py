"""One quantity has one range, wherever it is written, and every mass keeps within it."""

from __future__ import annotations

import csv
import json
import re
import tomllib
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from tests.commands import Run
from tests.files.test_estimate_results import spans_of, variants

from crankstar.analyses.bearings import RECORD
from crankstar.analyses.bearings.question import Question
from crankstar.analysis.document import Document, Ranged, Table
from crankstar.engine.engine import Engine
from crankstar.files.box import spread
from crankstar.files.estimate import estimated
from crankstar.language.alike import alike, as_given, in_turn, of_any
from crankstar.mechanics.balance import balance
from crankstar.studies.sweep import swept
from crankstar.tables import amplitudes, balance_orders, over_speeds
from crankstar.tables.analysis import analysis, document
from crankstar.tables.comparison import answer
from crankstar.tables.ranges import ranged

TWIN = """
format = 1
name = "270 twin"
cycle = "four-stroke"
speed = "8000 rpm"
[cylinder]
bore = "92 mm"
stroke = "75 mm"
[layout]
type = "inline"
throws = ["0 deg", "270 deg"]
"""
"""Its secondary couple is a vertical line; its primary couple an ellipse."""


@pytest.fixture
def twin(monkeypatch: pytest.MonkeyPatch) -> str:
    """A file of the twin where a command runs, on a terminal wide enough for its tables."""
    monkeypatch.setenv("COLUMNS", "200")
    Path("twin.toml").write_text(TWIN)
    return "twin.toml"


def tree() -> dict[str, Any]:
    """The twin with its estimated values."""
    return dict(estimated(tomllib.loads(TWIN)).tree)


def rows_of(text: str, title: str, order: str) -> list[list[float]]:
    """The ranges in the row of an order, in the table under a title."""
    lines = text[text.index(title) :].splitlines()
    row = next(line for line in lines if line.split()[:1] == [order])
    return spans_of(row)


@pytest.mark.release
def test_pitch_and_greatest_of_a_vertical_line_have_one_range(run: Run, twin: str) -> None:
    wide = ["--estimate", "--units", "N, N m"]
    out = run("analyze", twin, *wide).out
    pitch, greatest = rows_of(out, "Couple on the block", "2")
    assert pitch == greatest
    stars = rows_of(out, "Couple by the vector stars", "2")
    assert len(stars) == 1, "that of Aₖ, by the length of the rod; the star is exact"
    moments = rows_of(out, "Moments about the crank axis", "1")
    inertia_torque = moments[1]
    sweep = run("analyze", twin, *wide, "--speeds", "7000..8000 rpm by 500").out
    assert rows_of(sweep, "Pitch M_V", "8000")[1] == pitch
    balance_sheet = run("balance", twin, *wide, "--factor", "0.5").out
    told = re.search(r"2  couple +N m +(.*)", balance_sheet)
    assert told is not None
    before, now, ahead, behind = spans_of(told[1])
    assert before == now == pitch
    assert ahead == behind == pytest.approx([each / 2 for each in pitch], rel=0.006)
    compared = run("compare", twin, twin, *wide).out
    assert rows_of(compared, "Couple", "2")[0] == pitch
    assert rows_of(compared, "Inertia torque", "1")[0] == inertia_torque


@pytest.mark.release
def test_files_have_the_range_of_the_table(run: Run, twin: str) -> None:
    out = run("analyze", twin, "--estimate", "--units", "N, N m").out
    (_typical, low, high), _greatest = rows_of(out, "Couple on the block", "2")
    run("analyze", twin, "--estimate", "-o", "twin.json")
    (order,) = (
        row for row in json.loads(Path("twin.json").read_text())["orders"] if row["order"] == 2
    )
    for place in (order["couple"], order):
        keys = ("greatest", "vertical") if place is order["couple"] else ("pitch",)
        for key in keys:
            assert place[f"{key}_low"] == pytest.approx(low, rel=0.005)
            assert place[f"{key}_high"] == pytest.approx(high, rel=0.005)
    run("analyze", twin, "--estimate", "-o", "twin.csv")
    lines = csv.DictReader(Path("twin.csv").read_text().splitlines())
    (pitch,) = (row for row in lines if (row["quantity"], float(row["order"])) == ("pitch", 2.0))
    ends = [float(value) for head, value in pitch.items() if re.search("_(low|high)", head)]
    assert ends == pytest.approx([low, high], rel=0.005)


@pytest.mark.release
def test_a_sweep_at_the_value_of_the_file_has_the_range_of_the_table(run: Run, twin: str) -> None:
    out = run("analyze", twin, "--estimate", "--units", "N, N m").out
    pitch, _greatest = rows_of(out, "Couple on the block", "2")
    over = ["--over", "speed=8000..9000 rpm/2", "--quantity", "couple.pitch", "--orders", "2"]
    run("sweep", twin, "--estimate", *over, "-o", "sweep.json")
    first = json.loads(Path("sweep.json").read_text())["values"][0]
    ends = [value for key, value in first.items() if key.endswith(("_low", "_high"))]
    assert ends == pytest.approx(pitch[1:], rel=0.005)


def by_labels(table: Table) -> dict[Any, tuple[Any, ...]]:
    """The rows by their labels; where several have the same, by how many came before."""
    labels = [place for place, column in enumerate(table.columns) if column.label] or [0]
    out: dict[Any, tuple[Any, ...]] = {}
    for row in table.rows:
        name = tuple(row[place] for place in labels)
        out[name, sum(key[0] == name for key in out)] = row
    return out


def within(shown: Document, other: Document) -> int:
    """Assert that the numbers of an engine lie in the ranges shown; how many have one."""
    count = 0
    for table, like in zip(shown.tables, other.tables, strict=True):
        own = by_labels(like)
        for name, row in by_labels(table).items():
            values = own.get(name, (0.0,) * len(row))
            for column, cell, value in zip(table.columns, row, values, strict=True):
                if not isinstance(cell, Ranged) or column.unit == "deg":
                    continue
                slack = 1e-9 * (abs(cell.low) + abs(cell.high))
                size = abs(value) if isinstance(cell.value, complex) else value
                assert cell.low - slack <= size.real <= cell.high + slack, (column, cell, value)
                count += 1
    return count


def readers(engine: Engine) -> Document:
    """The tables of `analyze`."""
    return document(analysis(engine, speed=None), angles=[0.3, 2.0], by="cylinder", vectors=True)


def machines(engine: Engine) -> Document:
    """Its JSON."""
    return balance_orders.answer(engine, balance(engine, speed=engine.speed))


def rows(engine: Engine) -> Document:
    """Its CSV."""
    return amplitudes.amplitudes(engine, balance(engine, speed=engine.speed), by="cylinder")


def compared(engine: Engine) -> Document:
    """The engine beside itself, for machines."""
    return answer([analysis(engine, speed=None)] * 2, ["a", "b"])


def speeds(engine: Engine, form: Callable[..., Document] = over_speeds.document) -> Document:
    """Amplitudes over the speed."""
    over = {"over": "speed", "values": [7000.0, 8000.0], "unit": "rpm"}
    return form(engine, swept(engine, **over, speed="file"))


def speed_rows(engine: Engine) -> Document:
    """The same for machines."""
    return speeds(engine, over_speeds.tidy)


def bearings(engine: Engine) -> Document:
    """Loads with hinges at the bearings."""
    return RECORD.told(engine, Question()).for_machines


def beam(engine: Engine) -> Document:
    """Loads of one beam."""
    return RECORD.told(engine, Question(model="continuous")).for_machines


@pytest.mark.release
@pytest.mark.parametrize(
    ("sheet", "least"),
    [
        (readers, 60),
        (speeds, 30),
        (bearings, 40),
        *(
            pytest.param(sheet, least, marks=pytest.mark.release)
            for sheet, least in (
                (machines, 30),
                (rows, 100),
                (compared, 20),
                (speed_rows, 50),
                (beam, 40),
            )
        ),
    ],
)
def test_masses_drawn_at_random_keep_within_the_ranges(
    sheet: Callable[[Engine], Document], least: int
) -> None:
    own = tree()
    ends = spread(own)
    assert ends is not None
    shown = ranged(sheet, ends, ends.engine)
    for engine in variants(own, count=6):
        assert within(shown, sheet(engine)) >= least


@pytest.mark.release
def test_what_is_balanced_for_estimated_masses_says_what_others_leave(run: Run, twin: str) -> None:
    run("balance", twin, "--estimate", "--factor", "0.5", "--shafts", "all", "-o", "quiet.toml")
    for verb in ("analyze", "verdict"):
        out = run(verb, "quiet.toml", "--units", "N, N m").out
        words = re.sub(r"\s+", " ", out)
        assert "No primary" not in words
        (force,) = spans_of(words[words.index("Primary force") :].partition("N.")[0])
        assert force[0] == force[1] == 0
        assert force[2] > 1e4
        assert "With the estimated masses no primary or secondary force or couple remains" in words
    shown = run("analyze", "quiet.toml", "--units", "N, N m").out
    assert rows_of(shown, "Force on the block", "1")[-1] == force
    none = re.search(r"None of orders (.*)\.", shown)
    assert none is not None
    assert none[1] == "2, 3, 5, 6"
    stars = shown[shown.index("Force by the vector stars") :].splitlines()
    assert next(line.split()[1] for line in stars if line.split()[:1] == ["1"]) == "1"


@pytest.mark.release
def test_a_row_that_some_masses_make_negligible_keeps_its_low_end() -> None:
    """A load of order 3 has the range of all masses, though not all of them would print it."""
    ends = spread(tree())
    assert ends is not None
    shown = ranged(lambda engine: RECORD.told(engine, Question()), ends, ends.engine)
    table = next(table for table in shown.tables if table.key == "orders")
    loads = [row for row in table.rows if row[2] == 3.0]
    assert len(loads) == 3
    for row in loads:
        greatest = row[-1]
        assert isinstance(greatest, Ranged)
        assert 0.2 * abs(greatest.value) < greatest.low < abs(greatest.value)


@pytest.mark.release
@pytest.mark.parametrize("sheet", [readers, compared])
def test_analyses_that_say_the_same_are_made_once(sheet: Callable[[Engine], Document]) -> None:
    made: list[Engine] = []

    def build(engine: Engine) -> Document:
        made.append(engine)
        return sheet(engine)

    ends = spread(tree())
    assert ends is not None
    ranged(build, ends, ends.engine)
    assert len(made) == len(ends.engines)


def test_analyses_ask_what_is_in_any_and_what_the_first_decides() -> None:
    found = {"a": [1], "b": [1, 2], "c": []}
    passes: list[str] = []

    def build(name: str) -> tuple[str, list[int], str]:
        passes.append(name)
        unit = in_turn("unit", f"unit of {name}")
        return as_given("largest", name), sorted(of_any("orders", found[name])), unit

    assert alike(build, "abc") == [("a", [1, 2], "unit of a")] * 3
    assert passes == [*"abcabc"]
    assert (as_given("largest", "x"), of_any("orders", [7]), in_turn("unit", "y")) == (
        "x",
        (7,),
        "y",
    )


@pytest.mark.release
def test_weights_that_are_fixed_are_not_said_to_be_sized(run: Run, twin: str) -> None:
    run("balance", twin, "--estimate", "--factor", "0.5", "-o", "fixed.toml")
    note = "sized for their own masses"
    assert note in re.sub(r"\s+", " ", run("balance", twin, "--estimate", "--factor", "0.5").out)
    assert note not in re.sub(r"\s+", " ", run("balance", "fixed.toml").out)
