"""A Document in a terminal of a given width: columns wrap, are left out, or tables are split.

Numbers are never cut.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, NamedTuple

from crankstar.analysis.document import Column, Document, Remarks, Table
from crankstar.language.messages import _
from crankstar.language.quoting import CONTROL
from crankstar.tables.cells import cells, heading
from crankstar.tables.conversion import in_units

if TYPE_CHECKING:
    from rich.console import RenderableType

GAP = 2
"""Spaces between columns."""
NARROWEST = 16
"""Letters of a wrapped column of text, at least, where its words allow."""
BROADEST = 18
"""Letters of a heading of more than one word, at most, above numbers that need less."""


class Drawn(NamedTuple):
    """A column as text: its lines of heading, its cells, the least and the best width."""

    column: Column
    heading: tuple[str, str]
    cells: Sequence[str]
    least: int
    best: int


def rendered(document: Document, *, width: int) -> RenderableType:
    """A document for rich's console, no line of its tables longer than `width`."""
    from rich.console import Group
    from rich.text import Text

    parts: list[RenderableType] = []
    if document.title:
        parts.append(Text(_shown(document.title), style="bold"))
    before: Table | Remarks | None = None
    for part in document.for_readers.parts:
        if isinstance(part, Table) and not (part.title or part.rows or part.notes):
            continue  # for machines only
        if isinstance(part, Remarks):
            parts += [Text()] if isinstance(before, Table) and not part.title else []
            parts += _remarks(part)
        else:
            parts += _table(part, width)
        before = part
    return Group(*parts)


def _shown(text: str) -> str:
    """Text without what a terminal takes for a command."""
    return CONTROL.sub("?", text)


def _remarks(part: Remarks) -> list[RenderableType]:
    from rich.padding import Padding
    from rich.text import Text

    style = {"note": "dim", "doubt": "yellow", "assumed": "yellow"}.get(part.kind, "")
    lines: list[RenderableType] = (
        [Text(), Text(_shown(part.title), style="bold")] if part.title else []
    )
    for line in part.lines:
        plain = Text(_shown(line), style=style)
        lines.append(Padding(plain, (0, 0, 0, 2)) if part.kind == "list" else plain)
    return lines


def _table(table: Table, width: int) -> list[RenderableType]:
    from rich.text import Text

    table = in_units(table.readable)
    parts: list[RenderableType] = [Text()]
    if table.title:
        parts.append(Text(_shown(table.title), style="bold"))
    if table.rows:
        drawn = _drawn(table)
        pieces = _pieces(drawn, width)
        for index, columns in enumerate(pieces):
            parts += [Text()] if index else []
            parts.append(_piece(table, columns, width))
        parts += _left_out(drawn, pieces)
    return [*parts, *(Text(_shown(note)) for note in table.notes)]


def _left_out(columns: list[Drawn], pieces: list[list[Drawn]]) -> list[RenderableType]:
    from rich.text import Text

    shown = {id(drawn) for piece in pieces for drawn in piece}
    hidden = [drawn.heading for drawn in columns if id(drawn) not in shown]
    if not hidden:
        return []
    names = (" ".join(filter(None, (words, unit))) for words, unit in hidden)
    line = _("Columns that do not fit in this width: {columns}.", columns=", ".join(names))
    return [Text(line, style="dim")]


def _drawn(table: Table) -> list[Drawn]:
    from rich.cells import cell_len

    texts = [[_shown(text) for text in row] for row in cells(table)]
    out: list[Drawn] = []
    for index, column in enumerate(table.columns):
        own = [row[index] for row in texts]
        words, unit = map(_shown, heading(column))
        longest = max(map(cell_len, own), default=0)
        broken = max((cell_len(word) for text in own for word in text.split()), default=0)
        above = max((cell_len(word) for word in [*words.split(), unit]), default=0)
        inner = (
            max(min(longest, NARROWEST), min(broken, 2 * NARROWEST)) if column.wraps else longest
        )
        whole = max(cell_len(unit), min(cell_len(words), max(BROADEST, longest)))
        least = max(inner, above, 1)
        out.append(Drawn(column, (words, unit), own, least, max(least, longest, whole)))
    return out


def _pieces(columns: list[Drawn], width: int) -> list[list[Drawn]]:
    """The columns, without optional ones if that suffices, else in pieces, each with labels."""
    steps = sorted({drawn.column.optional for drawn in columns} - {0})
    for count in range(len(steps) + 1):
        kept = [drawn for drawn in columns if drawn.column.optional not in steps[:count]]
        if _least(kept) <= width:
            return [kept]
    labels = [drawn for drawn in columns if drawn.column.label] or columns[:1]
    pieces, piece = [], list(labels)
    for drawn in columns:
        if drawn in labels:
            continue
        if len(piece) > len(labels) and _least([*piece, drawn]) > width:
            pieces.append(piece)
            piece = list(labels)
        piece.append(drawn)
    return [*pieces, piece]


def _least(columns: Sequence[Drawn]) -> int:
    return sum(drawn.least for drawn in columns) + GAP * (len(columns) - 1)


def _widths(columns: Sequence[Drawn], width: int) -> list[int]:
    """The width of each column: at least the least, the rest for those that want more."""
    widths = [drawn.least for drawn in columns]
    free = width - _least(columns)
    for place, drawn in sorted(enumerate(columns), key=lambda pair: pair[1].best - pair[1].least):
        more = min(free, drawn.best - drawn.least)
        widths[place] += max(more, 0)
        free -= max(more, 0)
    return widths


def _piece(table: Table, columns: Sequence[Drawn], width: int) -> RenderableType:
    from rich import box
    from rich.table import Table as Grid
    from rich.text import Text

    out = Grid(box=box.SIMPLE_HEAD, pad_edge=False, show_edge=False, header_style="")
    out.show_header = any(any(drawn.heading) for drawn in columns)
    out.padding = (0, 1)
    out.collapse_padding = True
    for drawn, wide in zip(columns, _widths(columns, width), strict=True):
        head = Text("\n".join(filter(None, drawn.heading)))
        out.add_column(
            head,
            justify="left" if drawn.column.left else "right",
            vertical="top",
            overflow="fold",
            min_width=wide,
            max_width=wide,
        )
    for index in range(len(table.rows)):
        style = "yellow" if index in table.doubtful else None
        out.add_row(*(Text(drawn.cells[index]) for drawn in columns), style=style)
    return out
