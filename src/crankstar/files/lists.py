"""A list of values that someone wrote down: a CSV file, or a spreadsheet, with headings.

    no., piston [g], pin [g], small end [g], big end [g]
    1,   412.3,      98.6,    151.2,         388.0

Columns stand apart by commas, semicolons or tabs; between semicolons and tabs a comma is the
decimal sign. Empty lines and lines that begin with # are left out. A heading says its unit in
brackets; a cell may say its own. What is wrong is one sentence with file, line and column.
"""

from __future__ import annotations

import csv
import io
import re
import warnings
from collections.abc import Sequence
from dataclasses import dataclass, replace
from difflib import get_close_matches
from pathlib import Path
from typing import Any

from crankstar.engine.quantities import Quantity
from crankstar.files import units
from crankstar.files.workbook import PROTECTED, UNREADABLE, ZIP
from crankstar.language.faults import ValueFaultError
from crankstar.language.messages import MessageError, _
from crankstar.language.quoting import one_line, seen

GREATEST_LIST = 5_000_000
"""Bytes."""
GREATEST_ROWS = 10_000
_UNIT = re.compile(r"\s*[\[(]([^\])]*)[\])]\s*$")
_NUMBER = re.compile(r"[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?")


class ListError(MessageError):
    """A list that cannot be read, as one sentence with its file, line and column."""


@dataclass(frozen=True)
class Row:
    """A line of a list: its number in the file, its cells."""

    line: int
    cells: tuple[str, ...]


@dataclass(frozen=True)
class Listed:
    r"""A list: the name of its file, its headings as they stand there, its rows.

    >>> found = list_of("no.;piston [g]\n1;412,3", name="w.csv")
    >>> found.keys, found.rows[0].cells
    (('no', 'piston'), ('1', '412.3'))
    """

    name: str
    heads: tuple[str, ...]
    rows: tuple[Row, ...]

    @property
    def keys(self) -> tuple[str, ...]:
        """The headings as words: in small letters, without units and signs."""
        return tuple(key_of(head) for head in self.heads)


def key_of(head: str) -> str:
    """A heading as words: in small letters, without its unit and signs.

    >>> key_of("Rod, big end [g]"), key_of("no.")
    ('rod big end', 'no')
    """
    return " ".join(re.findall(r"\w+", re.sub(r"_", " ", _UNIT.sub("", head).lower())))


def read_list(place: str) -> Listed:
    """The list in a CSV file, or in the first sheet of a spreadsheet. Raises ListError."""
    name = one_line(Path(place).name or place, longest=80)
    try:
        with Path(place).open("rb") as opened:
            raw = opened.read(GREATEST_LIST + 1)
    except (OSError, ValueError):
        raise ListError(
            "{file}: there is no such file, or it cannot be read", file=one_line(place)
        ) from None
    if len(raw) > GREATEST_LIST:
        raise ListError(
            "{file} is larger than {greatest} MB; give one list alone",
            file=name,
            greatest=GREATEST_LIST // 1_000_000,
        )
    if raw[:4] in (ZIP, PROTECTED):
        return _listed(_of_spreadsheet(raw, name), name)
    try:
        text = raw.decode("utf-8-sig")
    except UnicodeDecodeError:
        raise ListError("{file} is no text in UTF-8; save the list as CSV", file=name) from None
    return list_of(text, name=name)


def list_of(text: str, *, name: str) -> Listed:
    """The list in the text of a CSV file. Raises ListError."""
    lines = [line for line in text.splitlines() if line.strip() and not line.startswith("#")]
    first = lines[0] if lines else ""
    sign = next((each for each in ("\t", ";") if each in first), ",")
    rows: list[Row] = []
    reader = csv.reader(io.StringIO(text), delimiter=sign, skipinitialspace=True)
    try:
        for cells in reader:
            row = tuple(cell.strip() for cell in cells)
            if not any(row) or row[0].startswith("#"):
                continue
            if rows and sign != ",":
                row = tuple(re.sub(r"^([-+]?\d*),(\d+)", r"\1.\2", cell) for cell in row)
            rows.append(Row(reader.line_num, row))
    except csv.Error:
        raise ListError(
            "{file}, line {line}: it is no line of a CSV file", file=name, line=reader.line_num
        ) from None
    return _listed(rows, name)


def _of_spreadsheet(raw: bytes, name: str) -> list[Row]:
    """The rows of the first sheet of a spreadsheet. Raises ListError."""
    try:
        from openpyxl import load_workbook
    except ImportError:
        raise ListError(
            '{file}: a spreadsheet needs openpyxl; install it with: pip install "crankstar'
            '[spreadsheet]", or save the list as CSV',
            file=name,
        ) from None
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            page: Any = load_workbook(io.BytesIO(raw), data_only=True).worksheets[0]
            cells = list(page.iter_rows(max_row=GREATEST_ROWS + 2, max_col=64, values_only=True))
    except UNREADABLE:
        raise ListError("{file} is no spreadsheet that can be read", file=name) from None
    rows = [
        Row(line, tuple("" if cell is None else str(cell).strip() for cell in row))
        for line, row in enumerate(cells, 1)
    ]
    kept = [replace(row, cells=_trimmed(row.cells)) for row in rows if any(row.cells)]
    return [row for row in kept if not row.cells[0].startswith("#")]


def _trimmed(cells: tuple[str, ...]) -> tuple[str, ...]:
    last = max(place for place, cell in enumerate(cells) if cell)
    return cells[: last + 1]


def _listed(rows: Sequence[Row], name: str) -> Listed:
    """A list of rows, the first of which has the headings. Raises ListError."""
    if len(rows) < 2:
        raise ListError("{file} has no rows under a line of headings", file=name)
    if len(rows) > GREATEST_ROWS:
        raise ListError(
            "{file} has more than {greatest} rows; give one list alone",
            file=name,
            greatest=GREATEST_ROWS,
        )
    heads = rows[0].cells
    if all(_NUMBER.fullmatch(cell) for cell in heads if cell):
        raise ListError(
            "{file}, line {line}: headings are missing; name each column and its unit, as in "
            "{example}",
            file=name,
            line=rows[0].line,
            example='"piston [g]"',
        )
    keys = [key_of(head) for head in heads]
    twice = next((head for head, key in zip(heads, keys, strict=True) if keys.count(key) > 1), None)
    if twice:
        raise ListError(
            '{file}, line {line}: the column "{head}" stands twice; leave one out',
            file=name,
            line=rows[0].line,
            head=one_line(twice, longest=60),
        )
    for row in rows[1:]:
        if len(row.cells) > len(heads):
            raise ListError(
                "{file}, line {line}: it has {count} cells under {heads} headings",
                file=name,
                line=row.line,
                count=len(row.cells),
                heads=len(heads),
            )
    whole = tuple(
        replace(row, cells=row.cells + ("",) * (len(heads) - len(row.cells))) for row in rows[1:]
    )
    return Listed(name, heads, whole)


def columns_of(
    listed: Listed, known: dict[str, str], *, needed: Sequence[str] = ()
) -> dict[str, int]:
    r"""The column of each name; `known` are the names by their headings. Raises ListError.

    >>> weights = list_of("no,Piston [g]\n1,412", name="w.csv")
    >>> columns_of(weights, {"no": "label", "piston": "piston"})
    {'label': 0, 'piston': 1}
    """
    found: dict[str, int] = {}
    for place, key in enumerate(listed.keys):
        if not key:
            if any(row.cells[place] for row in listed.rows):
                _refuse_head(listed, listed.heads[place], known)
            continue
        if key not in known:
            _refuse_head(listed, listed.heads[place], known)
        if known[key] in found:
            raise ListError(
                '{file}: the columns "{first}" and "{second}" mean the same; leave one out',
                file=listed.name,
                first=one_line(listed.heads[found[known[key]]], longest=60),
                second=one_line(listed.heads[place], longest=60),
            )
        found[known[key]] = place
    for name in needed:
        if name not in found:
            heads = [head for head, meant in known.items() if meant == name]
            raise ListError(
                '{file} has no column "{head}"; name it in the line of headings',
                file=listed.name,
                head=heads[0],
            )
    return found


def _refuse_head(listed: Listed, head: str, known: dict[str, str]) -> None:
    near = get_close_matches(key_of(head), list(known), 1, 0.75)
    if near:
        raise ListError(
            '{file}: the column {head} is not known; "{meant}" is',
            file=listed.name,
            head=seen(head),
            meant=near[0],
        )
    raise ListError(
        "{file}: the column {head} is not known; name columns {names}",
        file=listed.name,
        head=seen(head),
        names=", ".join(dict.fromkeys(known)),
    )


def place_of(listed: Listed, row: Row, column: int) -> str:
    """Where a cell stands, in words."""
    return _(
        '{file}, line {line}, column "{head}"',
        file=listed.name,
        line=row.line,
        head=one_line(listed.heads[column], longest=60),
    )


def refused_cell(listed: Listed, row: Row, column: int, why: str) -> ListError:
    """The error of a cell, `why` being a sentence in the language of the context."""
    return ListError("{where}: {why}", where=place_of(listed, row, column), why=why)


def value_of(
    listed: Listed, row: Row, column: int, quantity: Quantity, *, usual: str = ""
) -> float:
    r"""The SI number of a cell, with its own unit, else that of the heading, else the usual one.

    Raises ListError.

    >>> from crankstar.engine.quantities import MASS
    >>> weights = list_of("no,piston [g]\n1,412", name="w.csv")
    >>> round(value_of(weights, weights.rows[0], 1, MASS), 9)
    0.412
    """
    text = row.cells[column]
    bracket = _UNIT.search(listed.heads[column])
    unit = bracket[1].strip() if bracket else usual
    bare = _NUMBER.fullmatch(text) is not None
    if bare and not unit:
        why = _(
            'neither the heading nor the cell has a unit; name it, as in "{head} [{unit}]"',
            head=one_line(listed.heads[column], longest=60),
            unit=units.unit_of(quantity.example),
        )
        raise refused_cell(listed, row, column, why)
    try:
        return units.si(f"{text} {unit}" if bare else text, quantity)
    except ValueFaultError as error:
        raise ListError(error.at(place_of(listed, row, column))) from None


def number_of(listed: Listed, row: Row, column: int) -> float:
    """A plain number in a cell. Raises ListError."""
    text = row.cells[column]
    if not _NUMBER.fullmatch(text):
        raise refused_cell(listed, row, column, _("{text} is no number", text=seen(text)))
    return float(text)
