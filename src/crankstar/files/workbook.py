"""The form of `sheets` in an .xlsx file, written and read; needs openpyxl.

Sheets of other names, such as those of results, are left alone. Every mistake of a cell is a fault
with its sheet and cell.
"""

from __future__ import annotations

import datetime
import io
import re
import warnings
import zipfile
from collections.abc import Iterator, Mapping, Sequence
from difflib import get_close_matches
from itertools import islice
from pathlib import PurePosixPath
from typing import Any

from crankstar.engine.records import Record
from crankstar.files.errors import EngineFileError, refused
from crankstar.files.forms import field_at, form_of
from crankstar.files.mistakes import Path, SpreadsheetTree, Tree
from crankstar.files.sheets import HEADS, MAIN, ROW, SOURCES, Cell, Sheet, depth, heading, value_of
from crankstar.files.sheets import lists as lists_of
from crankstar.language.faults import Fault
from crankstar.language.quoting import one_line, seen

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
)
"""What openpyxl and zipfile raise for files that are none."""


def add_sheets(book: Any, sheets: Sequence[Sheet]) -> None:
    """Append sheets to a write-only workbook of openpyxl, with choices for their cells."""
    from openpyxl.cell import WriteOnlyCell
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
        heads = [WriteOnlyCell(page, head) for head in sheet.heads]
        for head in heads:
            head.font = Font(bold=True)
        page.append(heads)
        for row in sheet.rows:
            page.append([_text(page, value) for value in row])


def _text(page: Any, value: Cell) -> Any:
    """A cell; text that begins like a formula stays text."""
    if not isinstance(value, str):
        return value
    from openpyxl.cell import WriteOnlyCell

    cell = WriteOnlyCell(page, value)
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
    return _Reading(pages, stored, name).tree()


def _unpackable(raw: bytes, name: str) -> None:
    """Refuse what is no spreadsheet, and what is far larger than it looks."""
    try:
        with zipfile.ZipFile(io.BytesIO(raw)) as packed:
            entries = packed.infolist()
    except UNREADABLE:
        raise refused(name, "not-spreadsheet") from None
    if sum(entry.file_size for entry in entries) > GREATEST_UNPACKED or len(entries) > 1000:
        raise refused(name, "spreadsheet-large", greatest=GREATEST_UNPACKED // 1_000_000)
    if not {PurePosixPath(entry.filename).name for entry in entries} >= PARTS:
        raise refused(name, "not-spreadsheet")


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
    own = {
        title: page
        for title, page in sheets.items()
        if title == MAIN or title.startswith(f"{MAIN}.")
    }
    for title, page in own.items():
        rows, columns = page.max_row, page.max_column
        if rows > GREATEST_ROWS or columns > GREATEST_COLUMNS:
            limits = {"rows": GREATEST_ROWS, "columns": get_column_letter(GREATEST_COLUMNS)}
            corner = f"{get_column_letter(columns)}{rows}"
            raise refused_sheet(name, "too-long", sheet=title, corner=corner, **limits)
    return own


def refused_sheet(name: str, code: str, **values: Any) -> EngineFileError:
    """The error of a spreadsheet as a whole."""
    return EngineFileError(name, [Fault((), f"sheet.{code}", values)])


class _Reading:
    """The sheets of an engine while they are read: tree, cells and faults so far."""

    def __init__(self, pages: Mapping[str, Any], stored: Mapping[str, Any], name: str) -> None:
        self.pages, self.stored, self.name = pages, stored, name
        self.out: Tree = {}
        self.cells: dict[Path, str] = {}
        self.faults: list[Fault] = []
        self.form: type[Record] = form_of({})

    def tree(self) -> SpreadsheetTree:
        """The tree of all sheets. Raises EngineFileError where a heading is missing."""
        rows = [*self._rows(MAIN, HEADS[:3])]
        if not rows:
            raise refused_sheet(self.name, "empty", sheet=MAIN)
        kind = next((row["value"][1] for row in rows if row["key"][1] == "layout.type"), None)
        tables = {tuple(title.split(".")[1:]) for title in self.pages if title != MAIN}
        hint: Tree = {path[0]: [] for path in tables}
        self.form = form_of(hint if kind is None else {"layout": {"type": kind}})
        for row in rows:
            self._value(row)
        known = [*lists_of(self.form), (SOURCES,)]
        for title in sorted(self.pages, key=lambda title: title.count(".")):
            path = tuple(title.split(".")[1:])
            if path and path not in known:
                self._unknown(title, known)
            elif path == (SOURCES,):
                self._sources(title)
            elif path:
                self._table(title, path)
        self._merged()
        return SpreadsheetTree(self.out, self.cells, self.faults)

    def _merged(self) -> None:
        """Faults of merged cells in rows that give a value; titles and notes may be merged."""
        rows: dict[Path, list[str]] = {
            path: re.split("[!:]", cell) for path, cell in self.cells.items()
        }
        for title, page in self.pages.items():
            for cells in page.merged_cells.ranges:
                within = range(cells.min_row, cells.max_row + 1)
                touched: list[Path] = [
                    path
                    for path, (sheet, cell, *_) in rows.items()
                    if sheet == title and int(re.sub("[A-Z]", "", cell)) in within
                ]
                if touched:
                    own = min(touched, key=lambda path: path[0] == SOURCES)
                    self._fault("cell.merged", path=own, cell=f"{title}!{cells}")

    def _fault(self, code: str, *, path: Path = (), **values: Any) -> None:
        self.faults.append(Fault(path, code, values))

    def _unknown(self, title: str, known: Sequence[Path]) -> None:
        names = [".".join((MAIN, *map(str, path))) for path in known]
        near = get_close_matches(title, names, 1, 0.8)
        values: dict[str, Any] = {"sheet": one_line(title, longest=40)}
        if near:
            self._fault("sheet.unknown-near", meant=near[0], **values)
        else:
            self._fault("sheet.unknown", sheets=", ".join(names), **values)

    def _rows(self, title: str, needed: Sequence[str]) -> Iterator[dict[str, tuple[str, Any]]]:
        """The rows of a sheet that are not empty: by heading the cell and its value."""
        page = self.pages[title]
        heads: dict[int, str] = {}
        if title == MAIN and page.max_row == page.max_column == 1 and page["A1"].value is None:
            raise refused_sheet(self.name, "empty", sheet=title)
        for cell in next(page.iter_rows(max_row=1), ()):
            text = str(cell.value).strip() if cell.value is not None else ""
            text = text.lower() if text.lower() in needed else text
            if text and text in heads.values():
                self._fault(
                    "sheet.heading-twice", cell=f"{title}!{cell.coordinate}", heading=seen(text)
                )
            elif text:
                heads[cell.column] = text
        missing = [head for head in needed if head not in heads.values()]
        if missing:
            self._fault(
                "sheet.heading-missing",
                cell=f"{title}!1:1",
                headings=", ".join(needed),
                missing=", ".join(missing),
            )
            raise EngineFileError(self.name, self.faults)
        for row in page.iter_rows(min_row=2):
            cells = {heads[c.column]: c for c in row if c.column in heads}
            if any(c.value is not None and str(c.value).strip() for c in cells.values()):
                yield {
                    head: (f"{title}!{c.coordinate}", self._content(title, c))
                    for head, c in cells.items()
                }

    def _content(self, title: str, cell: Any) -> Any:
        """What a cell holds; for a formula what was stored for it, a Fault where that is none."""
        value = cell.value
        if cell.data_type == "f":
            value = self.stored[title][cell.coordinate].value
            if value is None:
                return Fault((), "cell.formula")
        if isinstance(value, str) and (
            cell.data_type == "e" or re.fullmatch(r"#[A-Z/0]+[!?]?", value)
        ):
            return Fault((), "cell.error", {"value": seen(value)})
        if isinstance(value, datetime.date | datetime.time | datetime.timedelta):
            return Fault((), "cell.date")
        return None if isinstance(value, str) and not value.strip() else value

    def _value(self, row: Mapping[str, tuple[str, Any]]) -> None:
        """A row of the main sheet: a value by its key path, and its source."""
        (key_cell, key), (cell, value), (_unit_cell, unit) = (row[head] for head in HEADS[:3])
        if key is None:
            if value is not None and not isinstance(value, Fault):
                self._fault("cell.no-key", cell=cell, value=seen(value), heading=seen("key"))
            return
        path = tuple(str(key).strip().split("."))
        source = {
            name: row[name][1] for name in ("status", "source") if row.get(name, ("", None))[1]
        }
        if source:
            self._set(
                ("provenance", ".".join(path)),
                source,
                row["status"][0] if "status" in row else cell,
            )
        if value is not None:
            self._put(self.out, path, path, value, unit, cell, key_cell=key_cell)

    def _put(
        self,
        table: Tree,
        keys: Sequence[str],
        path: Path,
        value: Any,
        unit: Any,
        cell: str,
        *,
        key_cell: str,
    ) -> None:
        """Put a value at its keys into a table, whose keys are the end of `path`."""
        if path in self.cells:
            self._fault("cell.key-twice", cell=key_cell, key=".".join(map(str, keys)))
            return
        self.cells[path] = cell
        if isinstance(value, Fault):
            self.faults.append(value._replace(path=path))
            return
        info = field_at(self.form, path)
        for key in keys[:-1]:
            table = table.setdefault(key, {})
            if not isinstance(table, dict):
                self._fault("cell.key-twice", cell=key_cell, key=".".join(map(str, keys)))
                return
        measured = None if unit is None or isinstance(unit, Fault) else str(unit).strip()
        table[keys[-1]] = value_of(value, measured, info.annotation if info else None)

    def _set(self, path: Path, value: Any, cell: str) -> None:
        table: Any = self.out
        for key in path[:-1]:
            table = table.setdefault(key, {})
        table[path[-1]] = value
        self.cells[path] = cell

    def _sources(self, title: str) -> None:
        for row in self._rows(title, ("key",)):
            cell, key = row["key"]
            source = {
                head: value
                for head, (_, value) in row.items()
                if head != "key" and value is not None
            }
            if key is not None:
                self._set((SOURCES, str(key)), source, cell)

    def _table(self, title: str, path: Path) -> None:
        """The sheet of a list of tables: a row for each, within the rows that it names."""
        outer = [path[:size] for size in range(1, len(path)) if _is_list(self.form, path[:size])]
        inside = [f"in {'.'.join(map(str, above))}" for above in outer]
        for row in self._rows(title, inside):
            place, home = self._home(row, outer, inside)
            if home is None:
                continue
            way = [str(key) for key in path[len(outer[-1]) if outer else 0 :]]
            for key in way[:-1]:
                home = home.setdefault(key, {})
            rows = home.setdefault(way[-1], [])
            whole = (*place, *way, len(rows))
            table: Tree = {}
            rows.append(table)
            number = re.sub(r".*![A-Z]+", "", next(iter(row.values()))[0])
            self.cells[whole] = f"{title}!{number}:{number}"
            for head, (cell, value) in row.items():
                key, unit = heading(head)
                if head not in (ROW, *inside) and value is not None:
                    keys = key.split(".")
                    self._put(table, keys, (*whole, *keys), value, unit, cell, key_cell=cell)

    def _home(
        self, row: Mapping[str, tuple[str, Any]], outer: Sequence[Path], inside: Sequence[str]
    ) -> tuple[Path, Tree | None]:
        """The key path of the table that a row is in, and that table; None where there is none."""
        place: Path = ()
        home: Any = self.out
        for above, head in zip(outer, inside, strict=True):
            for key in above[len([step for step in place if isinstance(step, str)]) :]:
                home = home.get(key, {}) if isinstance(home, dict) else {}
                place = (*place, key)
            cell, number = row[head]
            count = len(home) if isinstance(home, list) else 0
            if not (isinstance(number, int | float) and number in range(1, count + 1)):
                sheet = ".".join((MAIN, *map(str, above)))
                value = number if not isinstance(number, Fault) else ""
                self._fault("cell.no-row", cell=cell, value=seen(value), sheet=sheet, count=count)
                return place, None
            home, place = home[int(number) - 1], (*place, int(number) - 1)
        return place, home


def _is_list(form: type[Record], path: Path) -> bool:
    info = field_at(form, path)
    return info is not None and bool(depth(info.annotation))
