"""What the cells of a spreadsheet mean: a tree of keys, with the cell of each value.

Every mistake of a cell is a fault with its sheet and cell.
"""

from __future__ import annotations

import datetime
import re
from collections.abc import Iterator, Mapping, Sequence
from difflib import get_close_matches
from typing import Any

from crankstar.engine.records import Record
from crankstar.files.errors import EngineFileError
from crankstar.files.forms import field_at, form_of
from crankstar.files.mistakes import Path, SpreadsheetTree, Tree
from crankstar.files.sheets import (
    BOUNDS,
    HEADS,
    MAIN,
    ROW,
    SOURCES,
    heading,
    is_list,
    lists,
    own_unit,
    value_of,
)
from crankstar.language.faults import Fault
from crankstar.language.quoting import one_line, seen
from crankstar.language.units import measured as unit_of


def refused_sheet(name: str, code: str, **values: Any) -> EngineFileError:
    """The error of a spreadsheet as a whole."""
    return EngineFileError(name, [Fault((), f"sheet.{code}", values)])


def spelt(title: str) -> list[str]:
    """The words of the name of a sheet, whatever parts them and in capitals or not.

    >>> spelt("Engine_Shaft.throw"), spelt("engine.shaft.throw")
    (['engine', 'shaft', 'throw'], ['engine', 'shaft', 'throw'])
    """
    return re.split(r"[\s._-]+", title.strip().lower())


class Cells:
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
        titles = [title for title in self.pages if title.startswith(f"{MAIN}.")]
        tables = {tuple(title.split(".")[1:]) for title in titles}
        hint: Tree = {path[0]: [] for path in tables}
        self.form = form_of(hint if kind is None else {"layout": {"type": kind}})
        for row in rows:
            self._value(row)
        known = [*lists(self.form), (SOURCES,)]
        for title in sorted(titles, key=lambda title: title.count(".")):
            path = tuple(title.split(".")[1:])
            if path not in known:
                self._unknown(title, known)
            elif path == (SOURCES,):
                self._sources(title)
            else:
                self._table(title, path)
        for title in sorted(self.pages.keys() - {MAIN, *titles}):  # others are left alone
            self._unknown(title, known, near=True)
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

    def _unknown(self, title: str, known: Sequence[Path], *, near: bool = False) -> None:
        """A fault of a sheet that is no table of an engine; `near`: only if it nearly is one."""
        names = [".".join((MAIN, *map(str, path))) for path in known]
        meant = get_close_matches(".".join(spelt(title)), names, 1, 0.9 if near else 0.8)
        values: dict[str, Any] = {"sheet": one_line(title, longest=40)}
        if meant:
            self._fault("sheet.unknown-near", meant=meant[0], **values)
        elif not near:
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
                self._check_heading(title, cell.coordinate, text)
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
            for c in row:
                if c.column not in heads and isinstance(c.value, int | float):
                    self._fault("cell.no-heading", cell=f"{title}!{c.coordinate}", value=c.value)
            cells = {heads[c.column]: c for c in row if c.column in heads}
            if any(c.value is not None and str(c.value).strip() for c in cells.values()):
                yield {
                    head: (f"{title}!{c.coordinate}", self._content(title, c))
                    for head, c in cells.items()
                }

    def _check_heading(self, title: str, cell: str, text: str) -> None:
        """A fault where a heading of the main sheet looks like one that is read, but is none."""
        known = (*HEADS, *BOUNDS)
        near = get_close_matches(text.lower(), known, 1, 0.8)
        if title == MAIN and text not in known and near:
            self._fault(
                "sheet.heading-near", cell=f"{title}!{cell}", heading=seen(text), meant=near[0]
            )

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
        (key_cell, key), (cell, value), (unit_cell, unit) = (row[head] for head in HEADS[:3])
        if key is None:
            if value is not None and not isinstance(value, Fault):
                self._fault("cell.no-key", cell=cell, value=seen(value), heading=seen("key"))
            return
        if isinstance(key, Fault):
            self._broken(key, key_cell)
            return
        path = tuple(str(key).strip().split("."))
        told = {head: row[head] for head in (*HEADS[3:-1], *BOUNDS) if head in row}
        self._source(".".join(path), key_cell, told)
        if isinstance(unit, Fault) and value is not None and not isinstance(value, Fault):
            value, cell = unit, unit_cell
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
        if measured and _other_unit(own_unit(value), measured):
            self._fault("cell.two-units", cell=cell, value=seen(value), unit=seen(measured))
            return
        table[keys[-1]] = value_of(value, measured, info.annotation if info else None)

    def _source(self, key: str, key_cell: str, row: Mapping[str, tuple[str, Any]]) -> None:
        """What a row tells of where the value at a key comes from; nothing where it is empty."""
        for head, (cell, value) in row.items():
            if value is None:
                continue
            path = (SOURCES, key, head)
            self.cells[path[:-1]], self.cells[path] = key_cell, cell
            source = self.out.setdefault(SOURCES, {}).setdefault(key, {})
            if isinstance(value, Fault):
                self.faults.append(value._replace(path=path))
            else:
                source[head] = value

    def _sources(self, title: str) -> None:
        for row in self._rows(title, ("key",)):
            cell, key = row.pop("key")
            if isinstance(key, Fault):
                self._broken(key, cell)
            elif (SOURCES, str(key)) in self.cells:
                self._fault("cell.key-twice", cell=cell, key=one_line(str(key), longest=40))
            elif key is not None:
                self._source(str(key), cell, row)

    def _broken(self, fault: Fault, cell: str) -> None:
        """A key that cannot be read, on which all others of its row hang."""
        title, _, place = cell.partition("!")
        path = (*title.split("."), "row", int(re.sub("[A-Z]", "", place)) - 1, "key")
        self.cells[path] = cell
        self.faults.append(fault._replace(path=path))

    def _table(self, title: str, path: Path) -> None:
        """The sheet of a list of tables: a row for each, within the rows that it names."""
        outer = [path[:size] for size in range(1, len(path)) if is_list(self.form, path[:size])]
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
            if ROW in row:
                self._check_number(*row[ROW], len(rows))
            for head, (cell, value) in row.items():
                key, unit = heading(head)
                if head not in (ROW, *inside) and value is not None:
                    keys = key.split(".")
                    self._put(table, keys, (*whole, *keys), value, unit, cell, key_cell=cell)

    def _check_number(self, cell: str, number: Any, right: int) -> None:
        """A fault where a row calls itself by another number than the one that it has."""
        if number is not None and (isinstance(number, bool | Fault) or number != right):
            value = "" if isinstance(number, Fault) else number
            self._fault("cell.row-number", cell=cell, value=seen(value), right=right)

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
            if isinstance(number, bool) or number not in range(1, count + 1):
                sheet = ".".join((MAIN, *map(str, above)))
                value = number if not isinstance(number, Fault) else ""
                code = "cell.no-row" if count else "cell.no-rows"
                self._fault(code, cell=cell, value=seen(value), sheet=sheet, count=count)
                return place, None
            home, place = home[int(number) - 1], (*place, int(number) - 1)
        return place, home


def _other_unit(own: str, beside: str) -> bool:
    """Whether the unit of a cell is another than that beside it, however both are written."""
    try:
        return bool(own) and unit_of(own) != unit_of(beside)
    except ValueError:  # which reading the value tells
        return False
