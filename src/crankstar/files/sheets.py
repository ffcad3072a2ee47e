"""An engine file as the form that spreadsheet users know: sheets of cells, and back.

The sheet `engine` has a row for each value: key, value, unit, status and source of the value,
range and what it moves with where it is estimated, meaning. A list of tables, such as the throws
of a shaft, has a sheet of its own, `engine.shaft` or `engine.shaft.throw`, with a row for each
table, units in the headings, and in a column `in shaft` the number of the row of the table that it
belongs to. `engine.provenance` has the sources of all other values.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Literal, NamedTuple, get_args, get_origin

from crankstar.engine.records import Record
from crankstar.files.forms import by_key, field_at, form_of, quantity_of, record_in
from crankstar.files.plus_minus import parted, with_unit

MAIN = "engine"
HEADS = ("key", "value", "unit", "status", "source", "meaning")
BOUNDS = ("range", "moves_with")
"""Headings before the meaning where a value has them: more of its source than HEADS tell."""
SOURCES = "provenance"
ROW = "row"
"""Heading of the numbers by which a table in a list is named; only read by people."""
MEASURES = {
    "angle": ("deg", "rad"),
    "length": ("mm", "cm", "m", "in"),
    "length along the crankshaft": ("mm", "cm", "m", "in"),
    "mass": ("g", "kg", "oz", "lb"),
    "moment of inertia": ("kg*m^2", "g*mm^2"),
    "unbalance": ("kg*m", "g*mm"),
    "rotational speed": ("rpm", "rad/s", "Hz"),
}
"""Units offered for each dimension, the usual one first; others are read as well."""
Cell = str | int | float | None
_NUMBER = r"[-+]?(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][-+]?\d{1,3})?"
_MEASURED = re.compile(rf"(?!{_NUMBER}$)({_NUMBER})\s*([^\W\d_].*|[°/].*)")
"""A number with a unit; not one with an exponent."""
_HEADING = re.compile(r"(.*?)\s*(?:\[(.*)\])?")


@dataclass
class Sheet:
    """A sheet: its name, headings, rows of cells; choices by row and column, from nought."""

    name: str
    heads: tuple[str, ...]
    rows: list[list[Cell]] = field(default_factory=list)
    choices: dict[tuple[int, int], tuple[str, ...]] = field(default_factory=dict)


class _Row(NamedTuple):
    """A table of a list: the numbers of the tables that it is in, and its values by key."""

    inside: tuple[int, ...]
    values: dict[str, Any]


def sheets_of(tree: Mapping[str, Any], *, blank: bool = False) -> list[Sheet]:
    """The sheets of a valid tree; `blank`: also rows and columns for all that it leaves out."""
    form = form_of(tree)
    leaves, tables = _taken_apart(tree)
    sources = {key: dict(source) for key, source in tree.get(SOURCES, {}).items()}
    if blank:
        for path, _info in _scalars(form):
            leaves.setdefault(".".join(path), None)
        for path in lists(form):
            tables.setdefault(path, [])
    own = {key: sources.pop(key) for key in leaves if key in sources}
    more = tuple(head for head in BOUNDS if any(source.get(head) for source in own.values()))
    main = Sheet(MAIN, (*HEADS[:-1], *more, *HEADS[-1:]))
    for key, value in sorted(leaves.items(), key=lambda item: _place(form, item[0])):
        _add_value(main, form, key, value, own.get(key, {}))
    every = [main]
    for path, rows in tables.items():
        holds = any(other[: len(path)] == path for other in tables if other != path)
        every.append(_table(form, path, rows, blank=blank, numbered=holds))
    if sources:
        heads = ["key", *dict.fromkeys(name for source in sources.values() for name in source)]
        rows = [
            [key, *(_cell(source.get(head), measured=False)[0] for head in heads[1:])]
            for key, source in sources.items()
        ]
        every.append(Sheet(f"{MAIN}.{SOURCES}", tuple(heads), rows))
    return every


def _taken_apart(tree: Mapping[str, Any]) -> tuple[dict[str, Any], dict[tuple[str, ...], list]]:
    """The values of a tree by key, and the rows of its lists of tables by path."""
    tables: dict[tuple[str, ...], list[_Row]] = {}

    def values(table: Mapping[str, Any], path: tuple[str, ...], inside: tuple[int, ...]) -> dict:
        out: dict[str, Any] = {}
        for key, value in table.items():
            if value is None or value in ("", []) or (not path and key == SOURCES):
                continue
            if isinstance(value, Mapping):
                nested = values(value, (*path, key), inside)
                out |= {f"{key}.{name}": item for name, item in nested.items()}
            elif isinstance(value, list | tuple) and isinstance(value[0], Mapping):
                rows = tables.setdefault((*path, key), [])
                for number, item in enumerate(value, 1):
                    row = _Row(inside, {})
                    rows.append(row)
                    row.values.update(values(item, (*path, key), (*inside, number)))
            else:
                out[key] = value
        return out

    return values(tree, (), ()), tables


def _scalars(record: type[Record], path: tuple[str, ...] = ()) -> Iterator[tuple[tuple, Any]]:
    """The path of every value of a form that is not in a list of tables."""
    for key, info in by_key(record).items():
        inner = record_in(info.annotation)
        if inner is None:
            if (*path, key) != ("format",):
                yield (*path, key), info
        elif not depth(info.annotation) and get_origin(info.annotation) is not dict:
            yield from _scalars(inner, (*path, key))


def lists(record: type[Record], path: tuple[str, ...] = ()) -> Iterator[tuple[str, ...]]:
    """The path of every list of tables of a form."""
    for key, info in by_key(record).items():
        inner = record_in(info.annotation)
        if inner is None or (not path and key == SOURCES):
            continue
        if depth(info.annotation):
            yield (*path, key)
        yield from lists(inner, (*path, key))


def _place(form: type[Record], key: str) -> int:
    """The place of a key among those of its form, for the order of rows."""
    known = [".".join(path) for path, _ in _scalars(form)]
    return known.index(key) if key in known else len(known)


def _add_value(
    sheet: Sheet, form: type[Record], key: str, value: Any, source: Mapping[str, Any]
) -> None:
    info = field_at(form, key.split("."))
    quantity = quantity_of(info) if info else None
    cell, unit = _cell(value, measured=quantity is not None)
    usual = MEASURES.get(quantity.dimension, ()) if quantity else ()
    row = len(sheet.rows)
    if usual:
        sheet.choices[row, 2] = usual
    if info is not None and (words := _words(info.annotation)):
        sheet.choices[row, 1] = words
    sheet.choices[row, 3] = _words(_status())
    meaning = (info.description if info else "") or ""
    unit = unit or (usual[0] if usual and value is None else None)
    told = [_cell(source.get(head), measured=False)[0] for head in sheet.heads[3:-1]]
    sheet.rows.append([key, cell, unit, *told, meaning])


def _status() -> Any:
    from crankstar.engine.records import Provenance

    return Provenance.model_fields["status"].annotation


def _words(annotation: Any) -> tuple[str, ...]:
    """The words of which a value is one."""
    if get_origin(annotation) is Literal:
        return tuple(word for word in get_args(annotation) if isinstance(word, str))
    if depth(annotation):
        return ()
    return next((words for part in get_args(annotation) if (words := _words(part))), ())


def _table(
    form: type[Record], path: tuple[str, ...], rows: list[_Row], *, blank: bool, numbered: bool
) -> Sheet:
    """The sheet of a list of tables; `numbered`: others are in them, which name their rows."""
    outer = [path[:size] for size in range(1, len(path)) if is_list(form, path[:size])]
    keys = dict.fromkeys(key for row in rows for key in row.values)
    info = field_at(form, path)
    record = record_in(info.annotation) if info else None
    if blank and record is not None:
        keys |= dict.fromkeys(".".join(inner) for inner, _ in _scalars(record))
    heads = [f"in {'.'.join(above)}" for above in outer]
    columns: list[list[Cell]] = [[row.inside[index] for row in rows] for index in range(len(outer))]
    if numbered or not keys:
        heads.insert(0, ROW)
        columns.insert(0, [*range(1, len(rows) + 1)])
    for key in keys:
        inner = field_at(record, key.split(".")) if record else None
        quantity = quantity_of(inner) if inner else None
        cells = [_cell(row.values.get(key), measured=quantity is not None) for row in rows]
        units = {unit for (_value, unit), row in zip(cells, rows, strict=True) if key in row.values}
        unit = units.pop() if len(units) == 1 else None
        if not rows:
            unit = MEASURES.get(quantity.dimension, ("",))[0] if quantity else None
        heads.append(f"{key} [{unit}]" if unit else key)
        columns.append([value if unit or not own else f"{value} {own}" for value, own in cells])
    body = [list(row) for row in zip(*columns, strict=True)] if rows else []
    return Sheet(".".join((MAIN, *path)), tuple(heads), body)


def is_list(form: type[Record], path: Sequence[str | int]) -> bool:
    """Whether a list stands at a path of a form."""
    info = field_at(form, path)
    return info is not None and bool(depth(info.annotation))


def depth(annotation: Any) -> int:
    """How many lists a value is in: 0 a value, 1 a list, 2 a list of lists."""
    if get_origin(annotation) is tuple:
        return 1 + depth(get_args(annotation)[0])
    if get_origin(annotation) in (dict, Literal):
        return 0
    return max((depth(part) for part in get_args(annotation)), default=0)


def _cell(value: Any, *, measured: bool) -> tuple[Cell, str | None]:
    """A value as a cell, and its unit; a list is text with commas, lists in it with semicolons."""
    if isinstance(value, list | tuple):
        if any(isinstance(item, list | tuple) for item in value):
            return "; ".join(", ".join(map(str, item)) for item in value), None
        if not measured and any("," in str(item) for item in value):  # which would part it
            return "; ".join(map(str, value)) + ";" * (len(value) == 1), None
        cells = [_cell(item, measured=measured) for item in value]
        units = {unit for _, unit in cells}
        if len(units) == 1:
            return ", ".join(_short(number) for number, _ in cells), units.pop()
        return "; ".join(map(str, value)), None
    if parted(value):
        return value, None
    match = _MEASURED.fullmatch(value.strip()) if measured and isinstance(value, str) else None
    return (value, None) if match is None else (_number(float(match[1])), match[2].strip())


def _short(value: Cell) -> str:
    return repr(value) if isinstance(value, float) else str(value)


def _number(value: float) -> int | float:
    """A number that is whole as a whole number."""
    return int(value) if value.is_integer() and abs(value) < 1e15 else value


def value_of(cell: Cell, unit: str | None, annotation: Any) -> Any:
    """The value of an engine file that a cell and its unit stand for."""
    if depth(annotation) == 2 and isinstance(cell, str):
        return [[_item(item, None) for item in part.split(",")] for part in cell.split(";")]
    if depth(annotation):
        items = [cell]
        if isinstance(cell, str):
            items = re.split(";" if ";" in cell else ",", cell)
            if re.fullmatch(r"\s*\d+(\s*-\s*\d+)+\s*", cell):  # as firing orders are written
                items = cell.split("-")
        if items[-1] == "":  # behind the mark that its comma parts nothing
            items.pop()
        return [_item(item, unit) for item in items]
    text = _is_text(annotation)
    if isinstance(cell, bool):
        return cell
    if isinstance(cell, int | float):
        number = _number(float(cell))
        return f"{number!r} {unit}" if unit else str(number) if text else number
    words = str(cell).strip()
    if unit and not text and (toleranced := with_unit(words, unit)):
        return toleranced
    if text or not unit or _MEASURED.fullmatch(words) or not any(map(str.isdigit, words)):
        return cell  # as it was typed, where it is no number that wants the unit
    return f"{str(cell).strip()} {unit}"


def own_unit(cell: Cell) -> str:
    """The unit that stands in a cell behind its number; empty where none does.

    >>> own_unit("87.5 mm"), own_unit("38 g at 4 in"), own_unit(87.5), own_unit("V8")
    ('mm', 'g at 4 in', '', '')
    """
    match = _MEASURED.fullmatch(cell.strip()) if isinstance(cell, str) else None
    return match[2] if match else ""


def _item(item: Any, unit: str | None) -> Any:
    """An item of a list: a number, a number with a unit, or text."""
    text = _short(item) if isinstance(item, int | float) else str(item).strip()
    if unit:
        return text if _MEASURED.fullmatch(text) else with_unit(text, unit) or f"{text} {unit}"
    try:
        return _number(float(text))
    except (ValueError, OverflowError):
        return text


def _is_text(annotation: Any) -> bool:
    return annotation is str or any(map(_is_text, get_args(annotation)))


def heading(text: str) -> tuple[str, str | None]:
    """The key and the unit of a heading: `angle [deg]`."""
    match = _HEADING.fullmatch(text.strip())
    return (match[1], match[2] or None) if match else (text, None)
