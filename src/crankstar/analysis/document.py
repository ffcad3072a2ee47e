"""An analysis as a record: tables of values and the remarks around them.

Every analysis gives a `Document`; `terminal`, `html`, `machine` (JSON and CSV), `spreadsheet` and
`arrow` render it. Values stay values: no module reads a number back out of rendered text.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from typing import Any, Literal

from crankstar.language.shown_units import Choice


@dataclass(frozen=True)
class Ranged:
    """A value that rests on estimates, with its range; of a complex one that of its amplitude."""

    value: float | complex
    low: float
    high: float


Value = str | int | float | complex | tuple[Any, ...] | Ranged | None
"""What a cell holds. None is a value that does not exist, and an empty cell."""

Kind = Literal[
    "text", "number", "wave", "phase", "vector", "signal", "order", "list", "span", "unit"
]
"""How the values of a column are written.

text, number; wave: a complex amplitude, `a ∠ p°`; phase: that of a wave, in degrees, which has no
range; vector: up + i right; signal: the c of
Re(c exp(i k theta)); order: numbers joined by hyphens, as firing orders and intervals are; list:
numbers with commas; span: two crank angles; unit: the unit of the row's numbers in the columns
whose unit is ROW_UNIT.
"""
Audience = Literal["all", "readers", "machines"]
"""Who is shown a table: terminal, page, report and print, or JSON, CSV and Parquet, or both.

A spreadsheet is for both: where a table has one form for each, it holds that of machines.
"""
ROW_UNIT = "row"
"""The unit of a Column whose unit stands in each row, in the column of the kind unit."""


@dataclass(frozen=True)
class Column:
    """A column: its heading, its unit as in a Balance (`m*r*w^2`), how its values are written.

    A lone `m` is the mass that others are counted in, not the metre; lengths are in `mm`. Renderers
    show numbers in the units of the context (`conversion`), those of a `fixed` column as they are.

    `key` is its name in JSON and CSV, slashes nest (`force/forward`); without one it is for readers
    only. `optional`
    columns are left out where a table is too wide, 1 before 2; `wraps`: text that may
    take several lines; `label`: repeated where a table is split; `machine`: not for
    readers; `estimated`: some of its values rest on estimates, which its heading says.
    `names`: what the numbers of a list are of; CSV has a column for each.
    """

    heading: str
    unit: str = ""
    kind: Kind = "number"
    key: str = ""
    digits: int = 5
    optional: int = 0
    wraps: bool = False
    label: bool = False
    machine: bool = False
    fixed: bool = False
    estimated: bool = False
    names: tuple[str, ...] = ()

    @property
    def left(self) -> bool:
        """Whether it is aligned to the left: words, and rows of numbers."""
        return self.kind in ("text", "order", "list", "unit")


@dataclass(frozen=True)
class Table:
    """Rows of values under headings, with the sentences that belong to them.

    `key` is its name in JSON; `doubtful` are the rows that rest on unverified values; `usual` the
    units that its readers expect, of each dimension of which none is chosen; `audience`: who is
    shown it, so that it can have a short form and a whole one of the same key.
    """

    title: str
    columns: tuple[Column, ...]
    rows: tuple[tuple[Value, ...], ...]
    notes: tuple[str, ...] = ()
    key: str = ""
    doubtful: frozenset[int] = frozenset()
    usual: Choice = field(default_factory=dict)
    audience: Audience = "all"

    def __post_init__(self) -> None:
        """Refuse rows that do not fit the columns."""
        if any(len(row) != len(self.columns) for row in self.rows):
            raise ValueError(f"a row of the table {self.title!r} does not fit its columns")

    @property
    def readable(self) -> Table:
        """The table without the columns that are for machines."""
        kept = [index for index, column in enumerate(self.columns) if not column.machine]
        columns = tuple(self.columns[place] for place in kept)
        rows = tuple(tuple(row[place] for place in kept) for row in self.rows)
        return replace(self, columns=columns, rows=rows)


@dataclass(frozen=True)
class Remarks:
    """Sentences outside tables, for readers: text, a faint note, a doubt, or a list of points.

    What is `assumed` gives way to the record of all that an answer rests on, where that is printed.
    By its `key` a host leaves one out that it answers itself.
    """

    lines: tuple[str, ...]
    title: str = ""
    kind: Literal["text", "note", "doubt", "assumed", "list"] = "text"
    key: str = ""


@dataclass(frozen=True)
class Document:
    """An analysis: what it is of, its tables and remarks in reading order.

    `facts` are the values for machines that stand in no table: engine, speed, units.
    """

    title: str
    parts: tuple[Table | Remarks, ...]
    facts: Mapping[str, Any] = field(default_factory=dict)

    @property
    def tables(self) -> Iterator[Table]:
        """Its tables in reading order."""
        return (part for part in self.parts if isinstance(part, Table))

    @property
    def sentences(self) -> Iterator[Remarks]:
        """Its remarks in reading order."""
        return (part for part in self.parts if isinstance(part, Remarks))

    @property
    def for_readers(self) -> Document:
        """The document without the tables that are for machines."""
        kept = [
            part for part in self.parts if isinstance(part, Remarks) or part.audience != "machines"
        ]
        return replace(self, parts=tuple(kept))

    @property
    def for_machines(self) -> Document:
        """The tables that are for machines, with its facts."""
        kept = [part for part in self.tables if part.audience != "readers"]
        return replace(self, parts=tuple(kept))

    @property
    def whole(self) -> Document:
        """The document with each table in the form that has all of it, as in a spreadsheet."""
        if all(part.audience == "all" for part in self.tables):
            return self
        return with_tables(self.for_readers, self.for_machines)


def with_tables(document: Document, machine: Document) -> Document:
    """A document with every table that programs read, in the place of its own of the same key.

    A spreadsheet has room for all rows where a reader is shown the highest or the nearest.
    """
    whole = {table.key: table for table in machine.tables if table.key and table.rows}
    parts = [
        whole.pop(part.key, part) if isinstance(part, Table) else part for part in document.parts
    ]
    return replace(document, parts=(*parts, *whole.values()))


def for_each(readers: Table, machines: Table) -> tuple[Table, ...]:
    """A table in the form for readers and in that for machines, or once where they are the same.

    One without rows is not shown to readers.
    """
    if readers == machines:
        return (readers if readers.rows else replace(readers, audience="machines"),)
    shown = (replace(readers, audience="readers"),) if readers.rows else ()
    return (*shown, replace(machines, audience="machines"))


def remarks(*lines: str, **how: Any) -> tuple[Remarks, ...]:
    """The lines that say something as one part, none where none does."""
    said = tuple(line for line in lines if line)
    return (Remarks(said, **how),) if said else ()
