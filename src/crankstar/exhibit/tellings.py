"""Tables that were made for the terminal, as plain records."""

from __future__ import annotations

from collections.abc import Iterator

from rich.console import Group, RenderableType
from rich.table import Table as Drawn
from rich.text import Text

from crankstar.exhibit.records import Table


def tables(renderable: RenderableType) -> tuple[Table, ...]:
    """The tables of a renderable, each under the bold line before it and with the plain lines after it as notes.

    Lines before the first table stand in a table of their own without rows.
    """
    found: list[Table] = []
    title, notes = "", []
    for part in _parts(renderable):
        if isinstance(part, Drawn):
            if notes:
                found = _noted(found, notes)
            rows = zip(*([_plain(cell) for cell in column.cells] for column in part.columns), strict=True)
            heads = tuple(_plain(column.header) for column in part.columns)
            found.append(Table(title=title, heads=heads, rows=tuple(tuple(row) for row in rows)))
            title, notes = "", []
        elif _is_title(part):
            if title:
                notes.append(title)
            title = part.plain.strip()
        else:
            notes += [line.strip() for line in part.plain.splitlines() if line.strip()]
            if title and notes:
                found, title, notes = [*_noted(found, []), Table(title=title, heads=(), rows=(), notes=tuple(notes))], "", []
    if title:
        notes.append(title)
    return tuple(_noted(found, notes))


def _parts(renderable: RenderableType) -> Iterator[Drawn | Text]:
    if isinstance(renderable, Group):
        for part in renderable.renderables:
            yield from _parts(part)
    elif isinstance(renderable, Drawn | Text):
        yield renderable
    else:
        yield Text(str(renderable))


def _is_title(text: Text) -> bool:
    return "bold" in str(text.style)


def _noted(found: list[Table], notes: list[str]) -> list[Table]:
    if not notes:
        return found
    if not found:
        return [Table(title="", heads=(), rows=(), notes=tuple(notes))]
    return [*found[:-1], found[-1].model_copy(update={"notes": (*found[-1].notes, *notes)})]


def _plain(cell: object) -> str:
    return cell.plain if isinstance(cell, Text) else str(cell)
