"""Readers and machines are each shown their form of a table, once."""

from __future__ import annotations

import csv
import io
import json
from collections import Counter
from itertools import pairwise
from pathlib import Path

import openpyxl
import pytest
from tests.commands import Run

COMMANDS = {
    "torque": ("torque", "audi-25-tfsi"),
    "marine": ("marine", "man-s90mc-c"),
    "tolerance": ("tolerance", "audi-25-tfsi", "--typical", "--builds", "1000"),
    "bearings": ("bearings", "audi-25-tfsi", "--gas"),
    "torsion": ("torsion", "cadillac-ld8", "--speeds", "1000..2000 rpm/2"),
}
WHOLE = {
    "torsion": "Response",
    "torque": "crank angle",
    "bearings": "forward",
    "marine": "bimoment",
    "tolerance": "rms_of_builds",
}
"""What is only for machines: a table of its own, or a heading."""


@pytest.mark.release
@pytest.mark.parametrize("command", COMMANDS)
def test_a_table_of_two_forms_is_shown_once_to_each(run: Run, tmp_path: Path, command: str) -> None:
    words = COMMANDS[command]
    lists = {
        key: rows
        for key, rows in json.loads(run(*words, "--json").out).items()
        if isinstance(rows, list) and rows and isinstance(rows[0], dict)
    }
    found = csv.DictReader(io.StringIO(run(*words, "--csv").out))
    rows = Counter(row["table"] for row in found)
    assert rows == {key: len(lists[key]) for key in rows}
    lines = run(*words).out.splitlines()
    heads = [above for above, line in pairwise(lines) if line.startswith("──")]
    assert heads
    assert not [head for head in heads if WHOLE[command] in head]
    titles = [
        line
        for place, (above, line) in enumerate(pairwise(lines), 1)
        if line and not above and any(own.startswith("──") for own in lines[place : place + 6])
    ]
    assert titles
    assert len(titles) == len(set(titles))
    assert WHOLE[command] not in titles
    run(*words, "-o", str(tmp_path / "all.xlsx"))
    names = openpyxl.load_workbook(tmp_path / "all.xlsx").sheetnames
    assert len(names) == len(set(names))
    assert set(rows) <= set(names)
