"""`crankstar match`: its tables, the engine file that it writes, and what it refuses."""

from __future__ import annotations

import datetime
import json
import signal
import zipfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import openpyxl
import pytest
from tests.commands import Run, csv_rows
from tests.files.test_parts import tree
from tests.methods.test_matching import TRIPLE, batch

import crankstar
from crankstar.analyses.match import answer
from crankstar.analyses.match.batch import MatchingError
from crankstar.files import tree_text

LIST = """no., piston [g], pin [g], small end [g], big end [g]
a, 412, 99.5, 151, 401
b, 410, 98.1, 150, 403
c, 411.4, 99, 152.5, 399
"""
Refused = Callable[..., str]


@pytest.fixture(autouse=True)
def _files(tmp_path: Path) -> None:
    """The files lie in the directory where the commands run."""
    (tmp_path / "triple.toml").write_text(TRIPLE, encoding="utf-8")
    (tmp_path / "w.csv").write_text(LIST, encoding="utf-8")


def test_what_is_left_is_what_analyze_finds_in_the_file_that_is_written(run: Run) -> None:
    said = json.loads(
        run("match", "triple.toml", "w.csv", "--engine-file", "new.toml", "--json").out
    )
    own = {row["parts"]: row for row in said["left"]}
    assert (said["format"], said["proved"]) == (1, True)
    found = json.loads(run("analyze", "new.toml", "--orders", "1,2", "--json").out)
    squares = 0.0
    for row in found["orders"]:
        for name, size in (("force", 1.0), ("couple", 1000 / said["arm_mm"])):
            for way in ("forward", "backward"):
                squares += size**2 * abs(complex(*row[name][way])) ** 2
    whole = said["whole_unbalance"] * own["matched"]["force"] / own["matched"]["unbalance"]
    assert squares**0.5 == pytest.approx(whole, rel=1e-9)
    assert own["matched"]["unbalance"] <= own["as_listed"]["unbalance"]


def test_csv_has_the_parts_of_each_cylinder(run: Run) -> None:
    rows = csv_rows(run("match", "triple.toml", "w.csv", "--csv").out, "cylinders")
    assert [row["cylinder"] for row in rows] == ["1", "2", "3"]
    assert {row["piston"] for row in rows} == {row["rod"] for row in rows} == {"a", "b", "c"}


def test_readers_are_told_what_is_least_and_of_what(run: Run) -> None:
    said = " ".join(run("match", "triple.toml", "w.csv").out.split())
    assert "is proved least: no other assignment" in said
    assert "of the orders 1, 2" in said
    assert "the heaviest with the lightest" in said
    assert "only the differences of the weights count" in said


def test_several_engines_have_a_file_each(run: Run, tmp_path: Path) -> None:
    more = LIST + LIST.split("\n", 1)[1].replace("a,", "d,").replace("b,", "e,").replace("c,", "f,")
    (tmp_path / "six.csv").write_text(more, encoding="utf-8")
    line = ("match", "triple.toml", "six.csv", "--engines", "2", "--engine-file", "own.toml")
    said = run(*line, "--json").out
    assert [row["engine"] for row in json.loads(said)["engines"]] == [1, 2]
    for number in (1, 2):
        assert run("check", f"own-{number}.toml").code == 0


def test_a_spreadsheet_of_weights_is_read_as_well(run: Run, tmp_path: Path) -> None:
    book = openpyxl.Workbook()
    for line in LIST.splitlines():
        cells = [cell.strip() for cell in line.split(",")]
        book.worksheets[0].append([float(c) if c[0].isdigit() else c for c in cells])
    book.save(tmp_path / "w.xlsx")
    assert (
        run("match", "triple.toml", "w.xlsx", "--csv").out
        == run("match", "triple.toml", "w.csv", "--csv").out
    )


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("", "w.csv has no rows under a line of headings"),
        ("1,2\n3,4\n", "w.csv, line 1: headings are missing"),
        ("no,piston [g]\n1,\n", 'line 2, column "piston [g]": the cell is empty'),
        ("no,piston [g]\n1,heavy\n", 'w.csv: 1 mistake line 2, column "piston [g]" is "heavy"'),
        ("no,piston [g]\n1,-3\n", "must be greater than 0"),
        ("no,piston\n1,412\n", "neither the heading nor the cell has a unit"),
        ("no,piston [mm]\n1,412\n2,3\n", '1 mistake line 1, column 2 is "piston [mm]", a length'),
        ("no,pistn [g]\n1,412\n", 'the column "pistn [g]" is not known; "piston" is'),
        ("no,colour\n1,red\n", 'the column "colour" is not known'),
        ("no\n1\n", "it has no weights"),
        ("no,piston [g],piston [kg]\n1,412,0.4\n", 'the column "piston [kg]" stands twice'),
        ("no,pin [g],wrist pin [g]\n1,99,98\n", "mean the same"),
        ("no,piston [g]\n1,412\n1,413\n", "line 3"),
        ("no,piston [g]\n1,412,9\n2,x\n", "w.csv: 2 mistakes"),
        ("no,pistn [g],pn [g]\n1,412,9\n", "w.csv: 2 mistakes"),
        ("no,piston [g]\n1,412,9\n", "line 2: it has 3 cells under 2 headings"),
        (
            "no,piston [kg]\n1,800\n2,850\n3,900\n",
            "in the list, piston: 850 kg; that is more than twice",
        ),
        ("no,piston [g]\n1,412\n2,41.3\n3,411\n", 'line 3, column "piston [g]": 41.3 g is far'),
        ("no,piston [g]\n1,412\n2,413\n", "the list has 2 of each part"),
    ],
)
def test_a_mistake_in_the_list_is_told_with_its_place(
    refused: Refused, tmp_path: Path, text: str, told: str
) -> None:
    (tmp_path / "w.csv").write_text(text, encoding="utf-8")
    assert told in " ".join(refused("match", "triple.toml", "w.csv").split())


@pytest.mark.parametrize(
    ("line", "told"),
    [
        (("triple.toml", "none.csv"), "none.csv: there is no such file"),
        (("i4", "w.csv"), "gives no masses"),
        (("triple.toml", "w.csv", "--orders", "0"), "give numbers above 0"),
        (("triple.toml", "w.csv", "--orders", "0.5,1"), "those that do are 1, 2, 3, 4"),
        (("triple.toml", "w.csv", "--quantity", "roll"), "choose from force, couple"),
        (("triple.toml", "w.csv", "--engines", "0"), "whole number from 1 to 100"),
        (("triple.toml", "w.csv", "--classes", "2 mm"), "a mass is needed"),
        (("triple.toml", "w.csv", "--engine-file", "x.csv"), "must end in .toml"),
        (("triple.toml", "w.csv", "--engine-file", "none/x.toml"), "no such directory"),
        (("triple.toml", "w.csv", "--engine-file", "triple.toml"), "would be lost"),
    ],
)
def test_a_request_that_cannot_be_met_is_one_sentence(
    refused: Refused, line: tuple[str, ...], told: str
) -> None:
    said = refused("match", *line)
    assert told in " ".join(said.split())


PISTONS = "no., piston [g]\na, 500.0\nb, 500.1\nc, 502.1\nd, 504.2\ne, 506.5\n"


@pytest.mark.release
def test_only_what_is_listed_is_spoken_of_with_what_is_left_over(run: Run, tmp_path: Path) -> None:
    (tmp_path / "p.csv").write_text(PISTONS, encoding="utf-8")
    said = " ".join(run("match", "triple.toml", "p.csv").out.split())
    assert "no other assignment of these parts leaves less" in said
    assert "2 of each part are left over" in said
    assert "mean of the fitted parts" in said
    assert "rods" not in said
    assert "pins" not in said
    assert "turns, listed" not in said
    (tmp_path / "more.csv").write_text(PISTONS + "f, 507.0\n", encoding="utf-8")
    sets = " ".join(run("match", "triple.toml", "more.csv", "--engines", "2").out.split())
    assert "greatest less least mass of pistons:" in sets
    both = " ".join(run("match", "triple.toml", "w.csv").out.split())
    assert "no other assignment of these parts, each piston with its pin, leaves less" in both


def test_csv_has_the_weights_as_they_were_listed(run: Run, tmp_path: Path) -> None:
    (tmp_path / "p.csv").write_text(PISTONS, encoding="utf-8")
    text = run("match", "triple.toml", "p.csv", "--csv").out
    rows = csv_rows(text, "cylinders")
    assert "rotating" not in " ".join(rows[0])
    listed = {cell.strip() for line in PISTONS.splitlines() for cell in line.split(",")}
    for row in rows:
        weights = [cell for name, cell in row.items() if name.endswith("[g]")]
        assert {f"{float(cell)}" for cell in weights} <= listed
        assert not [cell for cell in row.values() if len(cell) > 6]


def test_the_force_names_its_speed_and_that_the_couple_is_in_it(run: Run) -> None:
    said = " ".join(run("match", "triple.toml", "w.csv").out.split())
    assert "3000 rpm" in said
    assert "The force is the rms of force, and of couple over 90 mm, together" in said
    alone = " ".join(run("match", "triple.toml", "w.csv", "--quantity", "force").out.split())
    assert "The force is" not in alone


def test_orders_that_no_part_makes_are_refused(refused: Refused) -> None:
    told = refused("match", "triple.toml", "w.csv", "--orders", "3")
    assert "no part of this engine makes an order 3" in told


def test_parts_that_are_alike_leave_nothing_and_need_no_order(run: Run, tmp_path: Path) -> None:
    """Pistons that differ and pins that make up for it, in any order: no rounding is told."""
    (tmp_path / "p.csv").write_text(
        "piston [g], pin [g]\n412.1, 99.9\n412.3, 99.7\n412.2, 99.8\n", encoding="utf-8"
    )
    answer = json.loads(run("match", "triple.toml", "p.csv", "--json").out)
    left = {row["parts"]: row["unbalance"] for row in answer["left"]}
    assert [left[name] for name in ("matched", "as_listed", "by_chance", "alike")] == [0] * 4
    assert (
        "The parts are alike: every assignment leaves 0" in run("match", "triple.toml", "p.csv").out
    )
    whole = json.loads(run("match", "triple.toml", "p.csv", "--whole", "--json").out)
    assert whole["left"][0]["unbalance"] == pytest.approx(whole["whole_alike"], rel=1e-9)
    other = json.loads(run("match", "triple.toml", "w.csv", "--json").out)
    assert other["left"][0]["unbalance"] > 1e-6


def test_nothing_is_written_where_one_of_the_files_cannot_be(
    refused: Refused, tmp_path: Path
) -> None:
    line = ("match", "triple.toml", "w.csv", "--engine-file", "new.toml")
    assert "no such directory" in refused(*line, "-o", "none/x.csv")
    assert "name the same file" in refused(*line[:-1], "x.json", "-o", "x.json")
    assert not (tmp_path / "new.toml").exists()
    assert not (tmp_path / "x.json").exists()
    (tmp_path / "own-3.toml").mkdir()
    several = ("--engines", "3", "--engine-file", "own.toml")
    assert "it is a directory" in refused("match", "triple.toml", "w.csv", *several)
    assert not (tmp_path / "own-1.toml").exists()


def test_engine_files_never_replace_what_is_read(refused: Refused, tmp_path: Path) -> None:
    before = (tmp_path / "triple.toml").read_text(encoding="utf-8")
    (tmp_path / "w-1.csv").write_text(LIST, encoding="utf-8")
    (tmp_path / "e-1.toml").write_text(before, encoding="utf-8")
    same = ("--engine-file", "triple.toml")
    assert "would be lost" in refused("match", "triple.toml", "w.csv", *same)
    several = ("--engines", "2", "--engine-file", "e.toml")
    assert "would be lost" in refused("match", "e-1.toml", "w.csv", *several)
    assert (tmp_path / "e-1.toml").read_text(encoding="utf-8") == before


def book_of(tmp_path: Path, **cells: Any) -> openpyxl.Workbook:
    """The list as a spreadsheet, saved as w.xlsx, some of its cells others."""
    book = openpyxl.Workbook()
    page = book.worksheets[0]
    for line in LIST.splitlines():
        row = [cell.strip() for cell in line.split(",")]
        page.append([float(c) if c[0].isdigit() else c for c in row])
    for place, value in cells.items():
        page[place] = value
    book.save(tmp_path / "w.xlsx")
    return book


@pytest.mark.parametrize(
    ("cells", "told"),
    [
        ({"B3": "=410+0"}, "B3 is a formula without a stored value"),
        ({"B3": "#N/A"}, 'B3 is "#N/A", an error of a formula'),
        ({"A3": "#REF!"}, 'A3 is "#REF!", an error of a formula'),
        ({"B3": datetime.datetime(2024, 1, 2)}, 'line 3, column "piston [g]" is a date'),
        ({"A1": None}, "line 1: column 1 has values and no heading"),
    ],
)
def test_a_cell_that_holds_no_value_is_named(
    refused: Refused, tmp_path: Path, cells: dict[str, object], told: str
) -> None:
    book_of(tmp_path, **cells)
    assert told in " ".join(refused("match", "triple.toml", "w.xlsx").split())


def test_the_sheet_that_is_shown_and_has_rows_is_read(run: Run, tmp_path: Path) -> None:
    book = book_of(tmp_path)
    wrong = book.create_sheet("wrong", 0)
    for row in book.worksheets[1].iter_rows(values_only=True):
        wrong.append([2 * cell if isinstance(cell, float) else cell for cell in row])
    wrong.sheet_state = "hidden"
    book.create_sheet("nothing", 0)
    book.save(tmp_path / "w.xlsx")
    found = run("match", "triple.toml", "w.xlsx", "--csv")
    assert found.out == run("match", "triple.toml", "w.csv", "--csv").out


def test_a_sheet_with_something_else_is_called_by_its_name(
    refused: Refused, tmp_path: Path
) -> None:
    book = book_of(tmp_path)
    notes = book.create_sheet("Notes", 0)
    notes.append(["Weights of batch 7"])
    notes.append(["as weighed"])
    book.save(tmp_path / "w.xlsx")
    assert "w.xlsx (Notes): 1 mistake" in refused("match", "triple.toml", "w.xlsx")


def test_a_spreadsheet_that_unpacks_to_more_is_not_unpacked(
    refused: Refused, tmp_path: Path
) -> None:
    book_of(tmp_path)
    with zipfile.ZipFile(tmp_path / "w.xlsx", "a", zipfile.ZIP_DEFLATED) as packed:
        packed.writestr("xl/more.xml", b" " * 31_000_000)
    assert "larger than 30 MB" in refused("match", "triple.toml", "w.xlsx")


def test_one_engine_of_a_batch_is_printed_alike_with_and_without_its_number(run: Run) -> None:
    for more in ([], ["--whole"], ["--classes", "1 g, 3 g"]):
        own = run("match", "triple.toml", "w.csv", *more, "--json").out
        assert run("match", "triple.toml", "w.csv", *more, "--engines", "1", "--json").out == own


def test_what_classes_leave_is_told_of_each_of_several_engines(run: Run, tmp_path: Path) -> None:
    more = "".join(f"{x}, {411 + x}, 99, 151, {401 - x}\n" for x in range(3))
    (tmp_path / "six.csv").write_text(LIST + more, encoding="utf-8")
    asked = ("match", "triple.toml", "six.csv", "--engines", "2", "--classes", "1 g, 3 g")
    found = json.loads(run(*asked, "--json").out)
    assert [(row["engine"], row["width"]) for row in found["classes"]] == [
        *((1, 1.0), (1, 3.0), (2, 1.0), (2, 3.0))
    ]
    classes = csv_rows(run(*asked, "--csv").out, "classes")
    assert [float(row["most [kg*m]"]) for row in classes] == pytest.approx(
        [row["most"] for row in found["classes"]]
    )


def test_what_the_whole_engine_rests_on_is_said(
    run: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Without counterweights in its file; the parts alone rest on none."""
    monkeypatch.chdir(tmp_path)
    line = ("match", "triple.toml", "w.csv", "--json")
    whole = json.loads(run(*line, "--whole").out)
    [own] = [each for each in whole["rests_on"] if each["path"] == "crankshaft.weight"]
    [matched, *_others] = whole["left"]
    assert matched["parts"] == "matched"
    assert own["moves"]["now"] == pytest.approx(matched["unbalance"], rel=1e-9)
    assert own["moves"]["quantity"] == "unbalance left"
    assert own["moves"]["low"] < 0.8 * own["moves"]["now"]
    assert "rests_on" not in json.loads(run(*line).out)
    found = crankstar.match("triple.toml", "w.csv", whole=True)
    assert [each.path for each in found.rests_on] == [each["path"] for each in whole["rests_on"]]
    rows = found.to_frame("left").to_dict("records")
    assert rows[0]["unbalance_kg_m"] == pytest.approx(matched["unbalance"])
    few = [{"no.": 1, "piston [g]": 412}, {"no.": 2, "piston [g]": 410}]
    with pytest.raises(MatchingError, match="3 cylinders"):
        crankstar.match("triple.toml", few)
    with pytest.raises(ValueError, match="greater than 0"):
        crankstar.match("triple.toml", "w.csv", classes=[-0.001])


@pytest.mark.parametrize(("name", "halted"), [("triple", False), ("eight", True)])
def test_an_interrupt_gives_the_best_so_far(
    run: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, name: str, *, halted: bool
) -> None:
    """It comes as the search begins, which ends where it first tells how far it is, if it does.

    All ways to fill three cylinders are listed at once, and are proved.
    """
    whole = answer.divided

    def interrupted(*given: Any, **options: Any) -> Any:
        signal.raise_signal(signal.SIGINT)
        return whole(*given, **options)

    (tmp_path / "eight.toml").write_text(tree_text(tree()), encoding="utf-8")
    parts = batch(8)
    kinds = [f"{kind.replace('_', ' ')} [kg]" for kind in parts.masses]
    rows = np.column_stack([range(8), *parts.masses.values()]).tolist()
    lines = [",".join(map(str, row)) for row in (["no", *kinds], *rows)]
    (tmp_path / "w.csv").write_text("\n".join(lines), encoding="utf-8")
    monkeypatch.setattr(answer, "divided", interrupted)
    ran = run("match", f"{name}.toml", "w.csv")
    assert ran.code == 0
    assert ("Interrupted: what follows is the best so far" in ran.err) == halted
    assert ("that it is least is not proved" in " ".join(ran.out.split())) == halted
