"""A list of values that someone wrote down: a CSV file, or a spreadsheet, with headings.

    no., piston [g], pin [g], small end [g], big end [g]
    1,   412.3,      98.6,    151.2,         388.0

Columns stand apart by commas, semicolons or tabs; between semicolons and tabs a comma is the
decimal sign. Empty lines and lines that begin with # are left out. `columns` reads the values.
"""

from __future__ import annotations

import csv
import io
import re
import warnings
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from operator import attrgetter
from pathlib import Path
from typing import Any, NamedTuple

from crankstar.engine.arguments import unboxed
from crankstar.files.errors import on_one_screen
from crankstar.files.kinds import kind_of
from crankstar.files.read_files import note
from crankstar.files.workbook import GREATEST_UNPACKED, PROTECTED, UNREADABLE, ZIP, unpacked_size
from crankstar.language.faults import sentence
from crankstar.language.file_faults import KINDS
from crankstar.language.messages import MessageError, _
from crankstar.language.quoting import given as quoted
from crankstar.language.quoting import one_line, seen

GREATEST_LIST = 5_000_000
"""Bytes."""
GREATEST_ROWS, GREATEST_COLUMNS = 10_000, 64
UNIT = re.compile(r"\s*[\[(]([^\])]*)[\])]\s*$")
"""The unit behind a heading."""
ERROR = re.compile(r"#(?:N/A|REF!|NAME\?|DIV/0!|VALUE!|NUM!|NULL!)")
"""What a spreadsheet shows for an error of a formula."""
NUMBER = re.compile(r"[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?")


class ListError(MessageError):
    """A list that cannot be read: one sentence, or all of its mistakes with line and column."""


class Mistake(NamedTuple):
    """What is wrong in a line of a list, as a sentence that names the line; nought: the list."""

    line: int
    told: str


def refused_list(name: str, mistakes: Sequence[Mistake]) -> ListError:
    """The error of a list with these mistakes, by line."""
    lines = [each.told for each in sorted(mistakes, key=attrgetter("line"))]
    return ListError(on_one_screen(name, lines, count=len(lines)))


@dataclass(frozen=True)
class Row:
    """A line of a list: its number in the file, its cells."""

    line: int
    cells: tuple[str, ...]


@dataclass(frozen=True)
class Listed:
    r"""A list: the name of its file, its headings as they stand there, its rows.

    `line` is that of the headings; `mistakes` are those of its form, to be told with the others.

    >>> found = list_of("no.;piston [g]\n1;412,3", name="w.csv")
    >>> found.keys, found.rows[0].cells
    (('no', 'piston'), ('1', '412.3'))
    """

    name: str
    heads: tuple[str, ...]
    rows: tuple[Row, ...]
    line: int = 1
    mistakes: tuple[Mistake, ...] = ()

    @property
    def keys(self) -> tuple[str, ...]:
        """The headings as words: in small letters, without units and signs."""
        return tuple(key_of(head) for head in self.heads)


def key_of(head: str) -> str:
    """A heading as words: in small letters, without its unit and signs.

    >>> key_of("Rod, big end [g]"), key_of("no.")
    ('rod big end', 'no')
    """
    return " ".join(re.findall(r"\w+", re.sub(r"_", " ", UNIT.sub("", head).lower())))


def read_list(path: str) -> Listed:
    """The list in a CSV file, or in the first full sheet of a spreadsheet. Raises ListError."""
    name = one_line(Path(path).name or path, longest=80)
    if not path.strip():
        raise ListError("the name of a list is empty; name a CSV file or a spreadsheet")
    try:
        if Path(path).exists() and not Path(path).is_file() and not Path(path).is_dir():
            raise ListError(
                "{file} is no regular file; name a CSV file or a spreadsheet", file=one_line(path)
            )
        with Path(path).open("rb") as opened:
            note(opened)
            raw = opened.read(GREATEST_LIST + 1)
    except ListError:
        raise
    except IsADirectoryError:
        raise ListError(
            "{file} is a directory; name a list in it, CSV or a spreadsheet", file=one_line(path)
        ) from None
    except (OSError, ValueError):
        raise ListError(
            "{file}: there is no such file, or it cannot be read", file=one_line(path)
        ) from None
    if len(raw) > GREATEST_LIST:
        raise ListError(
            "{file} is larger than {greatest} MB; give one list alone",
            file=name,
            greatest=GREATEST_LIST // 1_000_000,
        )
    if raw[:4] in (ZIP, PROTECTED):
        told, rows = _of_spreadsheet(raw, name)
        return _listed(rows, told)
    try:
        text = raw.decode("utf-8-sig")
    except UnicodeDecodeError:
        raise ListError("{file} is no text in UTF-8; save the list as CSV", file=name) from None
    if (found := kind_of(text)) not in (None, "list"):
        raise ListError(
            "{file} is {found}; a list with headings is wanted, CSV or a spreadsheet",
            file=name,
            found=_(KINDS[found]),
        )
    return list_of(text, name=name)


def list_of(text: str, *, name: str) -> Listed:
    """The list in the text of a CSV file. Raises ListError."""
    text = text.replace("\r\n", "\n").replace("\r", "\n")
    lines = [line for line in text.split("\n") if line.strip() and not line.startswith("#")]
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


def list_given(given: Any, *, name: str) -> Listed:
    """A list as Python has it: a file, a data frame, or rows as dicts by heading.

    Raises ListError, and TypeError for what is none.

    >>> list_given([{"run": "initial", "gain [g]": 2.5}, {"run": "check"}], name="runs").rows
    (Row(line=2, cells=('initial', '2.5')), Row(line=3, cells=('check', '')))
    """
    if isinstance(given, Path):
        return read_list(str(given))
    rows: Any = given
    if hasattr(given, "to_dict"):
        rows = given.to_dict("records") if hasattr(given, "columns") else None  # not a Series
    rows = unboxed(rows)
    listed = isinstance(rows, Iterable) and not isinstance(rows, bytes | Mapping)
    lines: list[Any] = [*rows] if listed else [None]
    if not all(isinstance(line, Mapping) for line in lines):
        raise TypeError(
            _(
                "{argument} takes the name of a CSV file or spreadsheet, a data frame, or a list "
                "of dicts by heading, not {given}",
                argument=name,
                given=quoted(given),
            )
        )
    heads = [*dict.fromkeys(head for line in lines for head in line)]
    table = [heads, *([line.get(head) for head in heads] for line in lines)]
    return _listed([Row(n, tuple(map(_cell, cells))) for n, cells in enumerate(table, 1)], name)


def _cell(given: Any) -> str:
    """The text of a cell; empty for what is missing: None, nan, NA of pandas."""
    try:
        missing = given is None or bool(given != given)
    except (TypeError, ValueError):  # NA is neither, as is an array
        missing = type(given).__name__ in ("NAType", "NaTType")
    return _text(None if missing else given)


def _of_spreadsheet(raw: bytes, name: str) -> tuple[str, list[Row]]:
    """The name and the rows of the first sheet of a spreadsheet that is shown and has any.

    Raises ListError.
    """
    try:
        from openpyxl import load_workbook
    except ImportError:
        raise ListError(
            '{file}: a spreadsheet needs openpyxl; install it with: pip install "crankstar'
            '[spreadsheet]", or save the list as CSV',
            file=name,
        ) from None
    check_unpacked(raw, name)
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            page, several = _page(load_workbook(io.BytesIO(raw)))
            lines, stored = list(_cells(page)), page
            if any(cell.data_type == "f" for line in lines for cell in line):
                stored = load_workbook(io.BytesIO(raw), data_only=True)[page.title]
            told = f"{name} ({one_line(page.title, longest=40)})" if several else name
            found = [_row(line, stored) for line in lines]
    except UNREADABLE:
        raise ListError("{file} is no spreadsheet that can be read", file=name) from None
    if mistakes := [each for _row_read, told_of in found for each in told_of]:
        raise refused_list(told, mistakes)
    return told, [row for row, _none in found if row is not None]


def check_unpacked(raw: bytes, name: str) -> None:
    """Refuse a spreadsheet that is far larger than it looks. Raises ListError."""
    if unpacked_size(raw) > GREATEST_UNPACKED:
        raise ListError(
            "{file} is larger than {greatest} MB; give one list alone",
            file=name,
            greatest=GREATEST_UNPACKED // 1_000_000,
        )


def _page(book: Any) -> tuple[Any, bool]:
    """The first sheet that is shown and has something in it, and whether there are several."""
    shown = [page for page in book.worksheets if page.sheet_state == "visible"] or book.worksheets
    full = [page for page in shown if page.max_row > 1 or page.max_column > 1]
    return (full or shown)[0], len(shown) > 1


def _cells(page: Any) -> Any:
    """The rows of a sheet, no more than are read."""
    most = min(page.max_row, GREATEST_ROWS + 2)
    return page.iter_rows(max_row=most, max_col=min(page.max_column, GREATEST_COLUMNS))


def _row(cells: Sequence[Any], stored: Any) -> tuple[Row | None, list[Mistake]]:
    """A row of a sheet, formulas as their stored values; none where it is empty or a remark.

    Its mistakes are formulas without a value, and errors of formulas.
    """
    words: list[str] = []
    mistakes: list[Mistake] = []
    line = cells[0].row
    for cell in cells:
        value = cell.value if cell.data_type != "f" else stored[cell.coordinate].value
        code = "cell.formula" if cell.data_type == "f" and value is None else ""
        if isinstance(value, str) and ERROR.fullmatch(value):
            code = "cell.error"
        if code:
            told = sentence(code, {"value": seen(str(value))}, place=cell.coordinate)
            mistakes.append(Mistake(line, told))
        words.append(_text(value))
    if not any(words) and not mistakes:
        return None, []
    if words[0].startswith("#") and not ERROR.fullmatch(words[0]):
        return None, []
    return Row(line, _trimmed(tuple(words))), mistakes


def _text(value: Any) -> str:
    """What a cell of a sheet shows; midnight is left out of a date."""
    if value is None:
        return ""
    return str(value).strip().removesuffix(" 00:00:00")


def _trimmed(cells: tuple[str, ...]) -> tuple[str, ...]:
    last = max((index for index, cell in enumerate(cells) if cell), default=0)
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
    if all(NUMBER.fullmatch(cell) for cell in heads if cell):
        raise ListError(
            "{file}, line {line}: headings are missing; name each column and its unit, as in "
            "{example}",
            file=name,
            line=rows[0].line,
            example='"piston [g]"',
        )
    keys = [key_of(head) for head in heads]
    mistakes = [
        Mistake(
            rows[0].line,
            _(
                'line {line}: the column "{head}" stands twice; leave one out',
                line=rows[0].line,
                head=one_line(head, longest=60),
            ),
        )
        for index, head in enumerate(heads)
        if keys[index] and keys.index(keys[index]) < index
    ]
    mistakes += [
        Mistake(
            row.line,
            _(
                "line {line}: it has {count} cells under {heads} headings; if a comma is a decimal "
                "sign there, write a point, or part the columns by semicolons",
                line=row.line,
                count=len(row.cells),
                heads=len(heads),
            ),
        )
        for row in rows[1:]
        if len(row.cells) > len(heads)
    ]
    whole = tuple(
        replace(row, cells=(row.cells + ("",) * (len(heads) - len(row.cells)))[: len(heads)])
        for row in rows[1:]
    )
    return Listed(name, heads, whole, rows[0].line, tuple(mistakes))
