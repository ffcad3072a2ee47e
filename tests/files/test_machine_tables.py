"""What the terminal shows as a table stands in JSON, CSV and spreadsheets, command by command.

A table is there under its key, or every number of it is: new tables of a command are found missing
without a line here. What follows from other numbers of the same answer is listed with the reason.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from tests.commands import Run

from crankstar.analysis.document import Document, Table
from crankstar.tables import machine, spreadsheet, terminal

FOUR = """
format = 1
name = "four with everything"
cycle = "four-stroke"
firing_order = [1, 3, 4, 2]
speed = "3000 rpm"
[cylinder]
bore = "87.5 mm"
stroke = "82.5 mm"
rod_length = "146 mm"
reciprocating_mass = "650 g +- 2 g"
rotating_mass = "700 g"
[layout]
type = "inline"
throws = ["0 deg", "180 deg", "180 deg", "0 deg"]
bore_pitch = "91 mm"
[gas]
imep = "9 bar"
[drive]
inertia = "0.2 kg*m^2"
[torsion]
inertia = "0.02 kg*m^2"
stiffness = "0.6 MN*m/rad"
diameter = "50 mm"
disc = [{ name = "flywheel", inertia = "0.2 kg*m^2", to = "rear", stiffness = "1 MN*m/rad" }]
[block]
mass = "120 kg"
[[mounts]]
name = "left"
z = "200 mm"
right = "-200 mm"
stiffness = ["200 N/mm", "80 N/mm", "80 N/mm"]
[[mounts]]
name = "right"
z = "200 mm"
right = "200 mm"
stiffness = ["200 N/mm", "80 N/mm", "80 N/mm"]
[[mounts]]
name = "rear"
z = "-300 mm"
stiffness = ["200 N/mm", "80 N/mm", "80 N/mm"]
"""
VEE = """
format = 1
name = "V twin"
cycle = "four-stroke"
firing_order = [1, 2]
speed = "4000 rpm"
[cylinder]
bore = "90 mm"
stroke = "80 mm"
rod_length = "140 mm"
reciprocating_mass = "500 g +- 3 g"
rotating_mass = "400 g"
[layout]
type = "vee"
throws = ["0 deg"]
bank_offset = "20 mm"
banks = [
  { bearing = "45 deg", cylinders = [1] },
  { bearing = "-45 deg", cylinders = [2] },
]
[gas]
imep = "8 bar"
[drive]
inertia = "0.3 kg*m^2"
[torsion]
inertia = "0.02 kg*m^2"
disc = [
  { name = "flywheel", inertia = "0.2 kg*m^2", to = "rear", stiffness = "1 MN*m/rad" },
  { name = "dynamo", inertia = "0.01 kg*m^2", to = "flywheel", stiffness = "0.1 MN*m/rad" },
]
"""
ENGINES = {"four.toml": FOUR, "twin.toml": VEE}
COMMANDS = (
    "analyze FILE",
    "analyze FILE --speeds 1000..3000/3",
    "bearings FILE",
    "bearings FILE --gas",
    "bobweight FILE",
    "compare FILE i4",
    "compare FILE FILE --set 2:speed=2000",
    "fault FILE --cut 1",
    "genset FILE",
    "guide FILE",
    "marine FILE",
    "mounts FILE --speed 1500",
    "orders FILE",
    "strokes FILE",
    "sweep FILE --over cylinder.rod_length=140..160/3",
    "tolerance FILE",
    "torque FILE --irregularity 0.02",
    "torsion FILE --speed 2000 --holzer 1",
    "vees 6",
)
OF_FOUR = ("guide", "mounts")
"""What answers of one row of cylinders, and of an engine on mounts, alone."""
UNITS = {"1000..3000/3": "1000..3000 rpm/3", "1500": "1500 rpm", "2000": "2000 rpm"}
UNITS.update({"2:speed=2000": "2:speed=2000 rpm"})
UNITS.update({"cylinder.rod_length=140..160/3": "cylinder.rod_length=140..160 mm/3"})
DERIVED = {
    "Force by the vector stars": "force over m r w^2 A_k, of which `harmonic` is in JSON",
    "Couple by the vector stars": "the same of the couple",
}


def _numbers(value: Any) -> Iterator[float]:
    """The sizes of all numbers in a value, of a wave those of its parts too."""
    if isinstance(value, dict):
        value = tuple(value.values())
    if isinstance(value, list | tuple):
        for each in value:
            yield from _numbers(each)
    elif isinstance(value, complex):
        yield from (abs(value), abs(value.real), abs(value.imag))
    elif isinstance(value, int | float) and not isinstance(value, bool):
        yield abs(float(value))


def _sizes(table: Table) -> list[float]:
    """The sizes of the numbers that a reader is shown, without zeros and labels."""
    labels = [place for place, column in enumerate(table.readable.columns) if column.label]
    return [
        abs(value)
        for row in table.readable.rows
        for place, value in enumerate(row)
        if place not in labels and isinstance(value, float | complex) and value
    ]


def _keys(table: Table) -> set[str]:
    """The tables in CSV."""
    if table.columns[0].key == "table":
        return {str(row[0]) for row in table.rows}
    return {table.key}


def _lacking(shown: Document, keys: set[str], numbers: list[float]) -> list[str]:
    """The titles of tables that neither stand under their key nor have their numbers there."""
    known = np.sort(np.array(numbers))
    out: list[str] = []
    for table in shown.tables:
        if not table.rows or table.key in keys or table.title in DERIVED:
            continue
        sizes = np.array(_sizes(table))
        # a share is in per cent for readers
        near = [np.abs(known[:, None] * by / sizes - 1).min(axis=0) < 1e-6 for by in (1, 100)]
        if not known.size or not np.any(near, axis=0).all():
            out.append(table.title)
    return out


def _noting(into: list[Any], render: Any) -> Any:
    """A renderer that keeps what it renders."""

    def noted(shown: Any, *more: Any, **options: Any) -> Any:
        into.append(shown)
        return render(shown, *more, **options)

    return noted


@pytest.fixture
def written(monkeypatch: pytest.MonkeyPatch) -> dict[str, list[Any]]:
    """What comes to each renderer: Documents, and of CSV its table."""
    found: dict[str, list[Any]] = {}
    for form, place, name in (
        ("text", terminal, "rendered"),
        ("json", machine, "tree"),
        ("csv", machine, "csv_text"),
        ("xlsx", spreadsheet, "spreadsheet_bytes"),
    ):
        found[form] = []
        monkeypatch.setattr(place, name, _noting(found[form], getattr(place, name)))
    return found


@pytest.mark.release
@pytest.mark.parametrize("engine", ENGINES)
@pytest.mark.parametrize("command", COMMANDS)
def test_every_table_of_the_terminal_is_in_json_csv_and_spreadsheets(
    command: str, engine: str, run: Run, written: dict[str, list[Any]], tmp_path: Path
) -> None:
    (tmp_path / engine).write_text(ENGINES[engine], encoding="utf-8")
    words = [UNITS.get(word, word).replace("FILE", engine) for word in command.split()]
    if words[0] in OF_FOUR and engine != "four.toml":
        assert run(*words).code == 2
        return
    assert run(*words).code == 0
    [shown] = written["text"]
    assert any(table.rows for table in shown.tables)
    lacking: dict[str, list[str]] = {}
    assert run(*words, "--json").code == 0
    [tree] = written["json"]
    numbers = [*_numbers(tree.facts), *(n for t in tree.tables for n in _numbers(t.rows))]
    lacking["json"] = _lacking(shown, {table.key for table in tree.tables if table.key}, numbers)
    assert run(*words, "--csv").code == 0
    [table] = written["csv"]
    lacking["csv"] = _lacking(shown, _keys(table), [*_numbers(table.rows)])
    heads, rows = machine.columns(table)
    assert len(set(heads)) == len(heads)
    cells = [cell for row in rows for cell in row if isinstance(cell, str)]
    assert not [cell for cell in cells if "None" in cell or "nan" in cell.split()]
    assert run(*words, "-o", "tables.xlsx").code == 0
    [book] = written["xlsx"]
    keys = {table.key for table in book.tables if table.key}
    numbers = [number for table in book.tables for number in _numbers(table.rows)]
    lacking["xlsx"] = _lacking(shown, keys, numbers)
    assert lacking == {form: [] for form in lacking}
