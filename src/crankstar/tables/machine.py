"""Tables for machines: one JSON object for a Document, CSV for a Table.

Columns without a key are for readers only. Keys with slashes nest. All digits are given. A value
that rests on estimates has the ends of its range beside it, `_low` and `_high`, those of a wave or
a vector being of its amplitude, and `_estimated`, which is true.
"""

from __future__ import annotations

import csv
import io
import json
import re
from cmath import phase
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from math import degrees
from typing import Any

from crankstar.analysis.document import ROW_UNIT, Column, Document, Ranged, Table, Value
from crankstar.language.quoting import CONTROL
from crankstar.tables.conversion import in_units

FORMAT = 2
"""Version of the JSON objects."""
FORMULA = ("=", "+", "-", "@", "\t", "\r", "＝", "＋", "－", "＠")
"""How text begins that a spreadsheet takes for a formula when it opens CSV."""
NUMBER = r"[-+]?[.\d]+(?:[eE][-+]?\d+)?"
NUMBERS = re.compile(rf"{NUMBER}(?:[\s,]+{NUMBER})*", re.ASCII)
"""Text of numbers alone, with spaces or commas between them."""


def tree(document: Document) -> dict[str, Any]:
    """A document as one object: its facts, and each table with a key as a list of rows.

    >>> column = Column("force", "N", kind="vector", key="force/forward")
    >>> tree(Document("", (Table("", (column,), ((1 + 2j,),), key="orders"),), {"engine": "V8"}))
    {'format': 2, 'engine': 'V8', 'orders': [{'force': {'forward': [1.0, 2.0]}}]}
    """
    tables = document.for_machines.tables
    lists = {table.key: objects(table) for table in tables if table.key}
    return {"format": FORMAT, **document.facts, **lists}


def objects(table: Table) -> list[dict[str, Any]]:
    """The rows of a table, each as an object."""
    out: list[dict[str, Any]] = []
    for row in table.rows:
        nested: dict[str, Any] = {}
        for column, value in zip(table.columns, row, strict=True):
            if not column.key:
                continue
            *outer, last = column.key.split("/")
            place = nested
            for key in outer:
                place = place.setdefault(key, {})
            if isinstance(value, Ranged):
                place |= {last: _plain(column, value.value)}
                place |= {f"{last}_low": value.low, f"{last}_high": value.high}
                place |= {f"{last}_estimated": True}
            else:
                place[last] = _plain(column, value)
        out.append(nested)
    return out


def _plain(column: Column, value: Value) -> Any:
    if isinstance(value, tuple):
        return [_plain(column, item) for item in value]
    if isinstance(value, complex):
        if column.kind == "wave":
            return {"amplitude": abs(value), "phase_deg": _phase(value)}
        return [value.real + 0.0, value.imag + 0.0]
    return value + 0.0 if isinstance(value, float) else value


def _phase(value: complex) -> float:
    return degrees(phase(value)) + 0.0 if value else 0.0


def json_text(tree: Mapping[str, Any]) -> str:
    """A tree as JSON, a row of numbers on one line."""
    text = json.dumps(tree, indent=1, ensure_ascii=False, allow_nan=False)
    # A raw line break cannot stand inside a string, so no name is touched.
    text = re.sub(r"\[\n\s+([-+.\de]+(?:,\n\s+[-+.\de]+)*)\n\s+\]", _joined, text) + "\n"
    return CONTROL.sub(lambda sign: json.dumps(sign.group())[1:-1], text)


def _joined(match: re.Match[str]) -> str:
    return "[" + " ".join(match.group(1).split()) + "]"


def columns(table: Table) -> tuple[list[str], list[list[Any]]]:
    """Heads with units and rows of plain values, for CSV, spreadsheets and data frames.

    A vector takes two columns, up and right; a wave its amplitude and phase; a signal its real and
    imaginary part; a row of numbers stands in one cell, or in a column for each of their names.
    Numbers are in the units that the context
    chooses, else in those of the table, so that programs find the same unit in every file.
    """
    table = in_units(table, prefixed=False)
    wanted = [index for index, column in enumerate(table.columns) if column.key]
    heads = [head for place in wanted for head in _heads(table.columns[place])]
    rows = [
        [cell for place in wanted for cell in plain_values(table.columns[place], row[place])]
        for row in table.rows
    ]
    return heads, rows


PARTS = {"vector": ("up", "right"), "wave": ("amplitude", "phase"), "signal": ("real", "imaginary")}


def _heads(column: Column) -> Iterator[str]:
    name = column.key.replace("/", "_")
    unit = "" if column.unit in ("", ROW_UNIT) else f" [{column.unit}]"
    for part in column.names or PARTS.get(column.kind, ("",)):
        yield f"{name}_{part} [deg]" if part == "phase" else f"{name}{part and '_'}{part}{unit}"
    if column.estimated:
        yield from (f"{name}_low{unit}", f"{name}_high{unit}", f"{name}_estimated")


def plain_values(column: Column, value: Value) -> list[Any]:
    """The cells of a value; in an estimated column the ends of its range, and whether it has one.

    The names of the other columns are those of an engine without estimates.
    """
    if isinstance(value, Ranged):
        return [*_single(column, value.value), value.low, value.high, True]
    if not column.estimated:
        return _single(column, value)
    size = abs(value) if isinstance(value, complex) else value
    ends = [size if isinstance(size, int | float) else None] * 2
    return [*_single(column, value), *ends, False]


def _single(column: Column, value: Value) -> list[Any]:
    if column.kind in PARTS:
        if value is None or isinstance(value, str | tuple | Ranged):
            return [None, None]
        number = complex(value)
        if column.kind == "wave":
            return [abs(number), _phase(number)]
        return [number.real + 0.0, number.imag + 0.0]
    if column.names:
        return list(value) if isinstance(value, tuple) else [value] * len(column.names)
    if isinstance(value, tuple):
        return [("-" if column.kind == "order" else " ").join(_short(item) for item in value)]
    return [value]


def _short(value: Any) -> str:
    if isinstance(value, tuple):
        return "-".join(map(_short, value))
    if value is None:
        return "-"
    return f"{value + 0.0:.10g}" if isinstance(value, float) else str(value)


def _written(cell: Any) -> Any:
    r"""A cell of CSV: text that no spreadsheet takes for a formula and no terminal for a command.

    >>> _written("=1+2"), _written("-2+3"), _written("-120 -240"), _written("A\x1b[31m")
    ("'=1+2", "'-2+3", '-120 -240', 'A?[31m')
    """
    if not isinstance(cell, str):
        return cell
    text = CONTROL.sub("?", cell)
    return "'" + text if text[:1] in FORMULA and not NUMBERS.fullmatch(text) else text


def stacked(tables: Sequence[Table]) -> Table:
    """Tables under one another, as one whose first column names the table of each row.

    Columns of the same key, unit and kind are one; a row is empty in those of other tables.

    >>> order, force = Column("", key="order"), Column("", "N", key="force")
    >>> orders = Table("", (order, force), ((1.0, 20.0),), key="orders")
    >>> print(csv_text(stacked([orders, Table("", (order,), ((2.0,),), key="more")])), end="")
    table,order,force [N]
    orders,1.0,20.0
    more,2.0,
    """
    shared: dict[tuple[str, str, str], Column] = {}
    places: list[dict[tuple[str, str, str], int]] = []
    for table in tables:
        own = {(c.key, c.unit, c.kind): at for at, c in enumerate(table.columns) if c.key}
        places.append(own)
        for name, at in own.items():
            column = table.columns[at]
            known = shared.setdefault(name, column)
            shared[name] = replace(known, estimated=known.estimated or column.estimated)
    rows = tuple(
        (table.key, *(row[own[name]] if name in own else None for name in shared))
        for table, own in zip(tables, places, strict=True)
        for row in table.rows
    )
    return Table("", (Column("", kind="text", key="table"), *shared.values()), rows)


def csv_text(table: Table) -> str:
    """A table as CSV, units in the header."""
    heads, rows = columns(table)
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    writer.writerows([_written(cell) for cell in row] for row in (heads, *rows))
    return out.getvalue()
