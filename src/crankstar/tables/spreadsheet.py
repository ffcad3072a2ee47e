"""A Document as a spreadsheet (.xlsx): a sheet for each table, one for its sentences.

Numbers are numbers, a complex amplitude has a column for its peak value and one for its phase, and
units stand in the headings. The sheets of an engine file can follow, so that the workbook is read
back as an engine. Needs openpyxl.
"""

from __future__ import annotations

import io
import re
from collections.abc import Sequence
from typing import Any

from crankstar.analysis.document import Column, Document, Remarks, Table
from crankstar.files.sheets import MAIN, Sheet
from crankstar.files.workbook import add_sheets
from crankstar.language.messages import _
from crankstar.language.quoting import CONTROL
from crankstar.tables.cells import cell, head
from crankstar.tables.conversion import in_units
from crankstar.tables.machine import columns, plain_values

LONGEST_NAME = 31
"""Letters that a sheet may have in its name."""


def spreadsheet_bytes(document: Document, engine: Sequence[Sheet] = ()) -> bytes:
    """The tables of a document, its sentences, and the sheets of an engine file.

    Raises ImportError without openpyxl.
    """
    from openpyxl import Workbook

    document = document.whole
    book = Workbook(write_only=True)
    sheets: list[Sheet] = []
    for table in document.tables:
        heads, rows = columns(table) if _keyed(table) else _readable(table)
        name = _name(table.title if not table.key else table.key, sheets)
        body = [[_plain(value) for value in row] for row in rows]
        body += [[note] for note in table.notes]
        sheets.append(Sheet(name, tuple(heads), body))
    lines = [
        line
        for part in document.parts
        if isinstance(part, Remarks)
        for line in (part.title, *part.lines)
        if line
    ]
    if lines:
        name = _name(_("notes"), sheets)
        sheets.append(Sheet(name, (document.title,), [[line] for line in lines]))
    add_sheets(book, [*sheets, *engine])
    out = io.BytesIO()
    book.save(out)
    return out.getvalue()


def _keyed(table: Table) -> bool:
    return any(column.key for column in table.columns) and bool(table.key)


def _readable(table: Table) -> tuple[list[str], list[list[Any]]]:
    """Headings with units and values of the columns that a reader sees."""
    shown = in_units(table.readable, prefixed=False)
    heads: list[str] = []
    for column in shown.columns:
        name, unit = column.heading, head(column)
        waves = {
            "wave": (unit, _("{quantity}, phase [deg]", quantity=name)),
            "vector": (_("{quantity}, up", quantity=unit), _("{quantity}, right", quantity=unit)),
            "signal": (f"{unit}, Re", f"{unit}, Im"),
        }
        heads += [*waves.get(column.kind, (unit,))]
    rows = [
        [
            item
            for column, value in zip(shown.columns, row, strict=True)
            for item in _cells(column, value)
        ]
        for row in shown.rows
    ]
    return heads, rows


def _cells(column: Column, value: Any) -> list[Any]:
    if column.kind in ("order", "list", "span") or isinstance(value, tuple):
        return [cell(column, value)]
    return plain_values(column, value)


def _plain(value: Any) -> Any:
    return value if isinstance(value, str | int | float | None) else str(value)


def _name(title: str, sheets: Sequence[Sheet]) -> str:
    """A name that a sheet may have, and that neither another one nor the engine has."""
    plain = re.sub(r"[\[\]:*?/\\']", " ", CONTROL.sub(" ", title)).strip() or _("table")
    taken = {sheet.name.lower() for sheet in sheets}
    for number in range(1, 1000):
        name = plain[:LONGEST_NAME] if number == 1 else f"{plain[: LONGEST_NAME - 4]} {number}"
        reserved = name.lower() == MAIN or name.lower().startswith(f"{MAIN}.")
        if name.lower() not in taken and not reserved:
            return name
    return plain[:LONGEST_NAME]
