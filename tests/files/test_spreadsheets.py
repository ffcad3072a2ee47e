"""Engine files as spreadsheets: written, read back the same, refused cell by cell."""

from __future__ import annotations

import io
import zipfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

import openpyxl
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from openpyxl.chart import BarChart, Reference
from tests.catalog import EVERY_ENGINE
from tests.strategies import OF_ANY_KIND

import crankstar
import crankstar.spectra
from crankstar.engine.engine import Engine
from crankstar.files import EngineFileError, engine_of, explicit, read_file
from crankstar.files.box import ranges
from crankstar.files.catalog import load, tree_of
from crankstar.files.estimate import estimated
from crankstar.files.sheets import sheets_of
from crankstar.files.source import tree_of as text_tree
from crankstar.files.starters import STARTERS
from crankstar.files.workbook import workbook_bytes, workbook_tree


def back(tree: dict[str, Any]) -> Engine:
    return engine_of(workbook_tree(workbook_bytes(sheets_of(tree)), "engine.xlsx"))


@pytest.mark.release
@settings(deadline=None, max_examples=25)
@given(st.one_of(*OF_ANY_KIND.values()))
def test_any_engine_comes_back_from_a_spreadsheet(engine: Engine) -> None:
    assert back(explicit(engine)) == engine_of(explicit(engine))


@pytest.mark.many(first=13)
@EVERY_ENGINE
def test_every_file_of_the_catalog_comes_back_in_its_own_form(name: str) -> None:
    _shown, tree = tree_of(name)
    assert back(tree) == load(name)


@pytest.mark.release
@pytest.mark.parametrize("layout", STARTERS)
def test_a_starter_with_all_its_blanks_is_the_engine_of_the_text(layout: str) -> None:
    tree = text_tree(STARTERS[layout])
    form = workbook_bytes(sheets_of(tree, blank=True))
    assert engine_of(workbook_tree(form, "mine.xlsx")) == engine_of(tree)
    book = openpyxl.load_workbook(io.BytesIO(form))
    keys = {row[0].value: row for row in book["engine"].iter_rows(min_row=2)}
    assert keys["name"][1].value
    assert all(row[5].value for row in keys.values())  # every key says what it means


Change = Callable[[Any], None]


def spoilt(name: str, *changes: Change) -> bytes:
    """The spreadsheet of a catalog engine after changes by hand."""
    book = openpyxl.load_workbook(io.BytesIO(workbook_bytes(sheets_of(tree_of(name)[1]))))
    for change in changes:
        change(book)
    out = io.BytesIO()
    book.save(out)
    return out.getvalue()


def row_of(book: Any, key: str) -> int:
    return next(row[0].row for row in book["engine"].iter_rows() if row[0].value == key)


def put(key: str, value: Any, column: str = "B") -> Change:
    def change(book: Any) -> None:
        book["engine"][f"{column}{row_of(book, key)}"].value = value

    return change


def faults(raw: bytes) -> list[str]:
    with pytest.raises(EngineFileError) as error:
        engine_of(workbook_tree(raw, "mine.xlsx"), name="mine.xlsx")
    return [line.strip() for line in str(error.value).splitlines()[1:]]


STROKE = "cylinder.stroke"
MISTAKES: dict[str, tuple[Change, str]] = {
    "missing": (put("name", None), "name is missing"),
    "renamed": (put(STROKE, "cylinder.strok", "A"), "(cylinder.strok) is not a key"),
    "textual": (put(STROKE, "long"), '(cylinder.stroke) is "long", not a number with a unit'),
    "comma decimals": (put(STROKE, "82,5"), '(cylinder.stroke) is "82,5 mm"; write numbers with a'),
    "wrong dimension": (put(STROKE, "kg", "C"), 'kg", a mass; a length is needed'),
    "no unit": (put(STROKE, None, "C"), "Did you mean"),
    "formula": (put(STROKE, "=80+2"), "(cylinder.stroke) is a formula without a stored value"),
    "error": (put(STROKE, "#DIV/0!"), '(cylinder.stroke) is "#DIV/0!", an error of a formula'),
    "key twice": (put("cylinder.bore", STROKE, "A"), "the key cylinder.stroke stands twice"),
    "key away": (put(STROKE, None, "A"), "but the row has no key"),
    "merged": (
        lambda book: book["engine"].merge_cells("A4:B5"),
        "the cells engine!A4:B5 are merged; unmerge them",
    ),
    "heading away": (
        lambda book: book["engine"].__setitem__("B1", "val"),
        "engine!1:1: the first row must have the headings key, value, unit; there is no value",
    ),
    "heading twice": (
        lambda book: book["engine"].__setitem__("F1", "value"),
        'engine!F1: the heading "value" stands twice',
    ),
    "heading misspelt": (
        lambda book: book["engine"].__setitem__("G1", "rnage"),
        'engine!G1: the heading "rnage" is not read; did you mean range?',
    ),
    "unit by formula": (put(STROKE, "=A1", "C"), "(cylinder.stroke) is a formula without a stored"),
    "sheet renamed": (
        lambda book: setattr(book["engine"], "title", "motor"),
        "there is no sheet engine; the sheets are: motor",
    ),
    "sheet capitalised": (
        lambda book: setattr(book["engine"], "title", "Engine "),
        'there is no sheet engine; rename the sheet "Engine "',
    ),
    "emptied": (
        lambda book: book["engine"].delete_rows(1, 500),
        "the sheet engine is empty; `crankstar new vee -o mine.xlsx` writes one",
    ),
    "only headings": (lambda book: book["engine"].delete_rows(2, 500), "the sheet engine is empty"),
    "formatted to the end": (
        lambda book: book["engine"].__setitem__("C99999", " "),
        "the sheet engine reaches to the cell F99999; delete what stands or is formatted beyond",
    ),
    "table renamed": (
        lambda book: setattr(book["engine.layout.banks"], "title", "engine.layout.bank"),
        "the sheet engine.layout.bank is no table of an engine; did you mean engine.layout.banks?",
    ),
    "table with another mark": (
        lambda book: setattr(book["engine.layout.banks"], "title", "engine_layout_banks"),
        "the sheet engine_layout_banks is no table of an engine; did you mean engine.layout.banks?",
    ),
    "table in capitals": (
        lambda book: setattr(book["engine.layout.banks"], "title", "Engine.Layout.Banks1"),
        "the sheet Engine.Layout.Banks1 is no table of an engine; did you mean engine.layout.banks",
    ),
    "number without a heading": (
        lambda book: book["engine.layout.banks"].__setitem__("J3", 900),
        "engine.layout.banks!J3 is 900, but its column has no heading in the first row",
    ),
    "two units": (
        lambda book: book["engine.layout.banks"].__setitem__("B2", "87.5 mm"),
        'engine.layout.banks!B2 is "87.5 mm", but the unit beside it is "deg"; write the unit',
    ),
    "bearing textual": (
        lambda book: book["engine.layout.banks"].__setitem__("B2", "left"),
        "engine.layout.banks!B2 (layout.banks[1].bearing) is",
    ),
}


@pytest.mark.many(first=14)
@pytest.mark.parametrize("kind", MISTAKES)
def test_a_mistake_in_a_spreadsheet_is_one_sentence_with_its_cell(kind: str) -> None:
    change, sentence = MISTAKES[kind]
    said = faults(spoilt("toyota-1uz-fe", change))
    assert any(sentence in line for line in said), said


COMPLETED = estimated(tree_of("gm-3800")[1], name="gm-3800").tree
"""An engine with estimated masses."""
RECIPROCATING, INERTIA = "cylinder.reciprocating_mass", "cylinder.rod.inertia"
FORMULA = "is a formula without a stored value"
SOURCE_MISTAKES: dict[str, tuple[Change, str, str]] = {
    "status": (put("cylinder.bore", "rumour", "D"), "D9", 'is "rumour"; it can be "published"'),
    "status by formula": (put("cylinder.bore", "=A1", "D"), "D9", FORMULA),
    "range": (put(RECIPROCATING, "1.2, 1.1", "F"), "F12", "is [1.2, 1.1]; give the lowest and"),
    "range by formula": (put(RECIPROCATING, "=1", "F"), "F12", FORMULA),
    "range of words": (
        put(RECIPROCATING, "a, b", "F"),
        "F12",
        "give multiples of the value without",
    ),
    "astray": (put(INERTIA, "cylinder.rodd", "G"), "G16", 'is "cylinder.rodd"; name another key'),
    "key by formula": (put("cylinder.bore", "=B1", "A"), "A9", FORMULA),
    "other key": (
        lambda book: book["engine.provenance"].__setitem__("A2", "layout.bankss"),
        "A2",
        'did you mean "layout.banks"?',
    ),
    "other key by formula": (
        lambda book: book["engine.provenance"].__setitem__("A2", "=A1"),
        "A2",
        FORMULA,
    ),
    "other key twice": (
        lambda book: book["engine.provenance"].__setitem__(
            "A3", book["engine.provenance"]["A2"].value
        ),
        "A3:",
        "stands twice; leave one of them out",
    ),
    "other status": (
        lambda book: book["engine.provenance"].__setitem__("B2", "rumour"),
        "B2",
        'is "rumour"; it can be "published"',
    ),
}


def spoilt_sources(*changes: Change) -> bytes:
    """The spreadsheet of an engine with estimated masses after changes by hand."""
    book = openpyxl.load_workbook(io.BytesIO(workbook_bytes(sheets_of(COMPLETED))))
    for change in changes:
        change(book)
    out = io.BytesIO()
    book.save(out)
    return out.getvalue()


@pytest.mark.many(first=10)
@pytest.mark.parametrize("kind", SOURCE_MISTAKES)
def test_a_mistake_in_a_source_is_the_only_one_and_names_its_cell(kind: str) -> None:
    change, cell, sentence = SOURCE_MISTAKES[kind]
    (said,) = faults(spoilt_sources(change))
    assert f"!{cell}" in said
    assert sentence in said


@pytest.mark.parametrize("form", ["short", "explicit"])
def test_ranges_of_estimated_values_come_back(form: str) -> None:
    tree = explicit(engine_of(COMPLETED)) if form == "explicit" else COMPLETED
    again = workbook_tree(workbook_bytes(sheets_of(tree)), "mine.xlsx")
    assert ranges(again) == ranges(tree)
    assert len(ranges(tree)) >= 5
    assert engine_of(again) == engine_of(tree)


def test_merged_cells_are_the_only_mistake_of_their_row() -> None:
    def merge(book: Any) -> None:
        row = row_of(book, STROKE)
        book["engine"].merge_cells(f"B{row}:C{row}")

    (said,) = faults(spoilt("toyota-1uz-fe", merge))
    assert "are merged" in said


@pytest.mark.release
def test_titles_may_be_merged_and_headings_be_capital() -> None:
    def note(book: Any) -> None:
        page = book["engine"]
        page["A1"].value, page["B1"].value = "Key", "VALUE"
        page[f"A{page.max_row + 2}"].value = "my notes"
        page.merge_cells(f"A{page.max_row}:F{page.max_row}")

    plain, noted = (
        engine_of(workbook_tree(spoilt("toyota-1uz-fe", *how), "x")) for how in ((), (note,))
    )
    assert plain == noted


def test_a_mistake_names_the_very_cell_and_all_come_at_once() -> None:
    raw = spoilt(
        "toyota-1uz-fe", put(STROKE, "82,5"), put("cylinder.bore", "=1+"), put("cycle", "left")
    )
    book = openpyxl.load_workbook(io.BytesIO(raw))
    said = faults(raw)
    for key in (STROKE, "cylinder.bore", "cycle"):
        assert any(line.startswith(f"engine!B{row_of(book, key)} ({key}) is ") for line in said)


def test_a_row_of_a_table_names_the_row_it_is_in() -> None:
    def astray(book: Any) -> None:
        book["engine.shaft.throw"]["A2"].value = 7

    raw = workbook_bytes(sheets_of(explicit(load("i4"))))
    book = openpyxl.load_workbook(io.BytesIO(raw))
    astray(book)
    out = io.BytesIO()
    book.save(out)
    said = faults(out.getvalue())
    assert said[0] == (
        "engine.shaft.throw!A2 is 7; it must be the number of a row of the sheet engine.shaft, "
        "from 1 to 1"
    )


@pytest.mark.many(first=4)
@pytest.mark.parametrize("number", [2, 3, True, "two", 1.5])
def test_a_row_has_the_number_that_it_calls_itself_by(number: Any) -> None:
    book = openpyxl.load_workbook(io.BytesIO(workbook_bytes(sheets_of(explicit(load("i4"))))))
    assert book["engine.shaft"]["A1"].value == "row"
    book["engine.shaft"]["A2"].value = number
    out = io.BytesIO()
    book.save(out)
    (said,) = faults(out.getvalue())
    assert said.startswith("engine.shaft!A2 is ")
    assert "this row is number 1 of its table: number the rows from 1, or clear" in said


def test_a_row_of_a_sheet_that_is_not_there_is_no_row_from_1_to_0() -> None:
    tree = {**tree_of("v8-flat-plane")[1], "crankshaft": [{"weight": [{"z": "0 mm"}]}]}
    book = openpyxl.load_workbook(io.BytesIO(workbook_bytes(sheets_of(tree))))
    del book["engine.crankshaft"]
    out = io.BytesIO()
    book.save(out)
    told = " ".join(faults(out.getvalue()))
    assert "the number of a row of the sheet engine.crankshaft, which has none; fill" in told
    assert "from 1 to 0" not in told


def test_a_word_in_the_place_of_a_number_is_quoted_without_the_unit_beside_it() -> None:
    (told,) = faults(spoilt("toyota-2jz", put(STROKE, "eighty")))
    assert '"eighty", not a number with a unit' in told


def test_true_is_no_row() -> None:
    book = openpyxl.load_workbook(io.BytesIO(workbook_bytes(sheets_of(explicit(load("i4"))))))
    book["engine.shaft.throw"]["A2"].value = True
    out = io.BytesIO()
    book.save(out)
    assert faults(out.getvalue())[0].startswith("engine.shaft.throw!A2 is true; it must be the")


def test_a_spreadsheet_with_a_sheet_of_its_own_for_a_chart_is_read() -> None:
    book = openpyxl.load_workbook(io.BytesIO(workbook_bytes(sheets_of(tree_of("i4")[1]))))
    sheet = book.create_chartsheet("chart")
    chart = BarChart()
    chart.add_data(
        Reference(book["engine"], min_col=2, min_row=1, max_row=5), titles_from_data=True
    )
    sheet.add_chart(chart)
    out = io.BytesIO()
    book.save(out)
    assert engine_of(workbook_tree(out.getvalue(), "mine.xlsx")) == load("i4")


def zipped(**files: bytes) -> bytes:
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w", zipfile.ZIP_DEFLATED) as packed:
        for name, content in files.items():
            packed.writestr(name, content)
    return out.getvalue()


WHOLE = {
    "another zip": (zipped(readme=b"hello"), "is not a spreadsheet in the form .xlsx"),
    "a bomb": (
        zipped(**{"workbook.xml": b" " * 40_000_000, "[Content_Types].xml": b""}),
        "unpacks to more than 30 MB",
    ),
    "half a spreadsheet": (
        zipped(**{"workbook.xml": b"<a", "[Content_Types].xml": b"<b/>"}),
        "is not a spreadsheet in the form .xlsx",
    ),
    "cut off": (
        workbook_bytes(sheets_of(STARTERS and {"name": "x"}))[:900],
        "is not a spreadsheet",
    ),
    "with a password": (
        b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1" + bytes(2000),
        "protected by a password",
    ),
    "text": (b"name = 'x'\n", "is not a spreadsheet in the form .xlsx"),
}


@pytest.mark.parametrize("kind", WHOLE)
def test_what_is_no_spreadsheet_is_refused_in_one_line(kind: str, tmp_path: Path) -> None:
    content, sentence = WHOLE[kind]
    file = tmp_path / "mine.xlsx"
    file.write_bytes(content)
    with pytest.raises(EngineFileError) as error:
        read_file(file)
    assert sentence in str(error.value)
    assert len(str(error.value).splitlines()) == 2


@pytest.mark.release
@pytest.mark.parametrize("name", ["analysis.xlsx", "ANALYSIS.XLSX"])
def test_the_spreadsheet_of_an_analysis_is_an_engine_and_its_numbers(
    name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    from crankstar import cli

    monkeypatch.chdir(tmp_path)
    with pytest.raises(SystemExit) as ended:
        cli.main(["analyze", "audi-25-tfsi", "-o", name])
    assert not ended.value.code
    assert load(tmp_path / name) == load("audi-25-tfsi")
    book = openpyxl.load_workbook(tmp_path / name)
    heads, *rows = book["amplitudes"].iter_rows(values_only=True)
    engine = load("audi-25-tfsi")
    sums = crankstar.total(crankstar.balance(engine, speed=engine.speed))
    second = crankstar.spectra.selected(sums.couple, 2)
    row = next(
        dict(zip(heads, row, strict=True)) for row in rows if row[3:6] == (2, "pitch", "vertical")
    )
    assert row["amplitude"] == pytest.approx(abs(crankstar.spectra.vertical(second)[0]), rel=1e-14)
    assert "yaw M_H (horizontal), phase [deg]" in [
        cell.value for cell in book["Couple on the block"][1]
    ]


def test_a_bad_spreadsheet_on_the_command_line_ends_with_two_and_writes_nothing(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    from crankstar import cli

    monkeypatch.chdir(tmp_path)
    (tmp_path / "mine.xlsx").write_bytes(spoilt("toyota-1uz-fe", put(STROKE, "82,5")))
    with pytest.raises(SystemExit) as ended:
        cli.main(["analyze", "mine.xlsx", "-o", "out.xlsx"])
    assert ended.value.code == 2
    assert "engine!B" in capsys.readouterr().err
    assert [path.name for path in tmp_path.iterdir()] == ["mine.xlsx"]


def test_a_starter_offers_words_and_units_to_choose_from() -> None:
    form = workbook_bytes(sheets_of(text_tree(STARTERS["vee"]), blank=True))
    sheet = openpyxl.load_workbook(io.BytesIO(form))["engine"]
    offers = {str(offer.sqref): offer.formula1 for offer in sheet.data_validations.dataValidation}
    where = {row[0].value: row[0].row for row in sheet.iter_rows(min_row=2)}

    def offered(cell: str) -> str:
        return next(words for cells, words in offers.items() if cell in cells.split())

    assert offered(f"B{where['cycle']}") == '"two-stroke,four-stroke"'
    assert offered(f"C{where['cylinder.stroke']}") == '"mm,cm,m,in"'
