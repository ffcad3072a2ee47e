"""The report of an engine with estimated values: one name for one mass, and words of its own."""

from __future__ import annotations

import re
import tomllib
from pathlib import Path

import pytest
from tests.commands import Run

from crankstar.analysis.document import Ranged, Table
from crankstar.files.box import spread
from crankstar.files.catalog import load
from crankstar.files.estimate import estimated
from crankstar.files.rewritten import rewritten
from crankstar.mechanics.balance import unit_mass
from crankstar.options.balancing import BalanceOptions, balanced
from crankstar.report import Subject
from crankstar.report.front import front
from crankstar.report.title import data
from crankstar.report.whirling import _table
from crankstar.tables.engines import cylinders, rotors
from crankstar.tables.ranges import ranged
from crankstar.tables.remedies import balancing_sheet

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


@pytest.fixture
def twin() -> Subject:
    """A twin of which the file gives neither masses nor a rod."""
    tree = dict(estimated(tomllib.loads(TWIN)).tree)
    ends = spread(tree)
    assert ends is not None
    return Subject(ends.engine, tree, "crankstar report twin.toml", spreads=(ends, None))


def span_of(text: str) -> list[float]:
    """Typical value, least and greatest in a cell of the data sheet, kg."""
    found = re.search(r"about ([\d.]+) \(([\d.]+) to ([\d.]+), estimated\) kg", text)
    assert found is not None, text
    return [float(part) for part in found.groups()]


@pytest.mark.release
def test_masses_of_the_data_sheet_are_those_of_the_bobweights(twin: Subject) -> None:
    """The share of a rigid rod is in what goes up and down and in what turns."""
    sheet = {datum.label: datum.value for datum in data(twin)}
    engine = twin.engine
    (first, _second) = next(
        table.rows
        for table in ranged(
            lambda each: balancing_sheet(balanced(each, BalanceOptions(factor="0.5"))),
            twin.spreads[0],
            engine,
        ).tables
        if table.key == "bobweights"
    )
    for label, cell in (
        ("Rotating mass per throw", first[2]),
        ("Reciprocating mass per cylinder", first[3]),
    ):
        assert isinstance(cell, Ranged)
        ends = [float(cell.value.real), cell.low, cell.high]
        assert span_of(sheet[label]) == pytest.approx(ends, rel=0.006), label
    assert span_of(sheet["Reciprocating mass per cylinder"])[0] == pytest.approx(
        unit_mass(engine), rel=0.006
    )
    bare = span_of(sheet["Piston group, without the rod"])[0]
    assert bare == pytest.approx(engine.first.reciprocating_mass, rel=0.006)
    own = span_of(sheet["Crank pin and webs, at crank radius"])[0]
    assert own == pytest.approx(engine.shafts[0].throws[0].throw_mass, rel=0.006)


@pytest.mark.release
def test_masses_in_the_file_are_named_as_being_without_the_rod(twin: Subject) -> None:
    headings = [
        [column.heading for column in table.columns if column.key.endswith("_mass")]
        for engine in (twin.engine, load("bmw-r1200"))
        for table in (rotors(engine), cylinders(engine))
    ]
    assert headings == [
        ["rotating mass, without the rod"],
        ["reciprocating mass, without the rod"],
        ["rotating mass"],
        ["reciprocating mass"],
    ]


@pytest.mark.release
def test_an_end_that_other_masses_alone_move_has_no_path_and_no_mark() -> None:
    """The file balances the first order for its estimated masses."""
    tree = dict(estimated(tomllib.loads(TWIN)).tree)
    ends = spread(tree)
    assert ends is not None
    options = BalanceOptions(factor="0.5", shafts="-1")
    quiet = rewritten({**tree, "name": "quiet"}, balanced(ends.engine, options).after)
    over = spread(quiet)
    assert over is not None
    subject = Subject(over.engine, quiet, "", spreads=(over, None))
    (table,) = subject.parts(lambda each: [_table(each, 1e6, "µm")])
    assert isinstance(table, Table)
    by_order = {row[0]: row for row in table.rows}
    assert by_order[1.0][1] == by_order[1.0][3] == ""
    assert isinstance(by_order[1.0][2], Ranged)
    assert by_order[3.0][1:] == ("none", 0.0, "none", 0.0)


@pytest.mark.release
def test_the_front_page_says_what_rolls_on_and_what_would_stop_it(twin: Subject) -> None:
    words = re.sub(r"<[^>]+>", " ", front(twin))
    todo = " ".join(words[words.index("What to do") :].split())
    found = re.search(
        r"Rolling moment without gas of order \d: about "
        r"([\d.]+) \([\d.]+ to [\d.]+, estimated\) N m is left; ",
        todo,
    )
    assert found is not None, todo
    assert "published" not in words


@pytest.mark.release
def test_the_command_of_a_report_names_the_file_that_was_typed(run: Run) -> None:
    Path("deep").mkdir()
    for output in ("mine.html", "deep/mine.html"):
        run("report", "i4", "-o", output)
        page = Path(output).read_text(encoding="utf-8")
        assert "crankstar report i4 -o mine.html" in page
    assert "-o i4-report.html" in run("report", "i4", "-o", "-").out
