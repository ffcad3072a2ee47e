"""The form of `sheets` in an .xlsx file, written and read; needs openpyxl.

Sheets of other names, such as those of results, are left alone.
"""

from __future__ import annotations

import io
import lzma
import warnings
import zipfile
import zlib
from collections.abc import Sequence
from itertools import islice
from pathlib import PurePosixPath
from typing import Any

from crankstar.files.cells import Cells, refused_sheet, spelt
from crankstar.files.errors import refused
from crankstar.files.mistakes import SpreadsheetTree
from crankstar.files.sheets import MAIN, Cell, Sheet
from crankstar.language.quoting import CONTROL, one_line, seen

ZIP, PROTECTED = b"PK\x03\x04", b"\xd0\xcf\x11\xe0"
"""How an .xlsx begins; how one with a password, and an .xls, begin."""
PARTS = {"workbook.xml", "[Content_Types].xml"}
"""Files without which a zip is no spreadsheet."""
GREATEST_UNPACKED = 30_000_000
GREATEST_ROWS, GREATEST_COLUMNS = 20_000, 200
WIDTHS = {"key": 30, "value": 24, "source": 40, "meaning": 70}
UNREADABLE = (
    *(KeyError, ValueError, TypeError, AttributeError, IndexError, SyntaxError, OSError),
    *(EOFError, NotImplementedError, RuntimeError, zipfile.BadZipFile, RecursionError),
    *(zlib.error, lzma.LZMAError, OverflowError, MemoryError, AssertionError),
)
"""What openpyxl and zipfile raise for files that are none."""


def add_sheets(book: Any, sheets: Sequence[Sheet]) -> None:
    """Append sheets to a write-only workbook of openpyxl, with choices for their cells."""
    from openpyxl.styles import Font
    from openpyxl.utils import get_column_letter
    from openpyxl.worksheet.datavalidation import DataValidation

    for sheet in sheets:
        page = book.create_sheet(sheet.name)
        page.freeze_panes = "A2"
        for column, head in enumerate(sheet.heads, 1):
            width = WIDTHS.get(head, max(12, len(head) + 2))
            page.column_dimensions[get_column_letter(column)].width = width
        offers: dict[tuple[str, ...], Any] = {}
        for (row, column), words in sheet.choices.items():
            listed = ",".join(words)
            offer = offers.setdefault(
                words, DataValidation("list", formula1=f'"{listed}"', showErrorMessage=False)
            )
            offer.add(f"{get_column_letter(column + 1)}{row + 2}")
        page.data_validations.dataValidation.extend(offers.values())
        heads = [_text(page, head) for head in sheet.heads]
        for head in heads:
            head.font = Font(bold=True)
        page.append(heads)
        for row in sheet.rows:
            page.append([_text(page, value) for value in row])


def _text(page: Any, value: Cell) -> Any:
    """A cell; text that begins like a formula stays text, and what a cell cannot hold is marked."""
    if not isinstance(value, str):
        return value
    from openpyxl.cell import WriteOnlyCell

    cell = WriteOnlyCell(page, CONTROL.sub("?", value))
    cell.data_type = "s"
    return cell


def workbook_bytes(sheets: Sequence[Sheet]) -> bytes:
    """Sheets as an .xlsx file. Raises ImportError without openpyxl."""
    from openpyxl import Workbook

    book = Workbook(write_only=True)
    add_sheets(book, sheets)
    out = io.BytesIO()
    book.save(out)
    return out.getvalue()


def workbook_tree(raw: bytes, name: str) -> SpreadsheetTree:
    """The tree of keys in the sheets of an .xlsx file, with the cell of each value.

    Raises EngineFileError where it is no spreadsheet, or has no engine in it.
    """
    if raw[:4] == PROTECTED:
        raise refused(name, "spreadsheet-protected")
    try:
        import openpyxl  # noqa: F401
    except ImportError:
        raise refused(name, "no-openpyxl") from None
    _unpackable(raw, name)
    pages = _pages(raw, name, values=False)
    if any(
        cell.data_type == "f" for page in pages.values() for row in page.iter_rows() for cell in row
    ):
        stored = _pages(raw, name, values=True)
    else:
        stored = pages
    return Cells(pages, stored, name).tree()


def _unpackable(raw: bytes, name: str) -> None:
    """Refuse what is no spreadsheet, and what is far larger than it looks."""
    try:
        entries = _entries(raw)
    except UNREADABLE:
        raise refused(name, "not-spreadsheet") from None
    if unpacked_size(raw) > GREATEST_UNPACKED or len(entries) > 1000:
        raise refused(name, "spreadsheet-large", greatest=GREATEST_UNPACKED // 1_000_000)
    if not {PurePosixPath(entry.filename).name for entry in entries} >= PARTS:
        raise refused(name, "not-spreadsheet")


def unpacked_size(raw: bytes) -> int:
    """Bytes that a spreadsheet says it has when it is unpacked; 0 where it is none."""
    try:
        return sum(entry.file_size for entry in _entries(raw))
    except UNREADABLE:
        return 0


def _entries(raw: bytes) -> list[zipfile.ZipInfo]:
    with zipfile.ZipFile(io.BytesIO(raw)) as packed:
        return packed.infolist()


def _pages(raw: bytes, name: str, *, values: bool) -> dict[str, Any]:
    """The sheets of an engine by name. Raises EngineFileError."""
    from openpyxl import load_workbook
    from openpyxl.utils import get_column_letter

    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            book = load_workbook(io.BytesIO(raw), data_only=values)
            sheets = {page.title: page for page in book.worksheets}
    except UNREADABLE:
        raise refused(name, "not-spreadsheet") from None
    if MAIN not in sheets:
        named = ", ".join(one_line(sheet, longest=40) for sheet in islice(sheets, 12))
        near = next((sheet for sheet in sheets if sheet.strip().lower() == MAIN), None)
        if near is not None:
            raise refused_sheet(name, "missing-near", sheet=MAIN, meant=seen(near))
        raise refused_sheet(name, "missing", sheet=MAIN, sheets=named)
    own = {title: page for title, page in sheets.items() if spelt(title)[0] == MAIN}
    for title, page in own.items():
        rows, columns = page.max_row, page.max_column
        if rows > GREATEST_ROWS or columns > GREATEST_COLUMNS:
            limits = {"rows": GREATEST_ROWS, "columns": get_column_letter(GREATEST_COLUMNS)}
            corner = f"{get_column_letter(columns)}{rows}"
            raise refused_sheet(name, "too-long", sheet=title, corner=corner, **limits)
    return own
