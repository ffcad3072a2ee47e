"""Documents as records of the page: tables with their cells as they are printed."""

from __future__ import annotations

from collections.abc import Iterable

from crankstar.analysis.document import Remarks
from crankstar.analysis.document import Table as Values
from crankstar.page.unit_records import Table
from crankstar.tables.cells import cells, head
from crankstar.tables.conversion import in_units
from crankstar.tables.html import MINUS


def printed(parts: Iterable[Values | Remarks]) -> tuple[Table, ...]:
    """The parts of a document for readers as tables; remarks have notes only.

    >>> from crankstar.analysis.document import Column
    >>> (table,) = printed([Values("Throws", (Column("z", "mm"),), ((-40.0,),))])
    >>> table.heads, table.rows, table.numeric
    (('z [mm]',), (('−40',),), (True,))
    """
    return tuple(
        _table(part) for part in parts if isinstance(part, Remarks) or part.audience != "machines"
    )


def _table(part: Values | Remarks) -> Table:
    if isinstance(part, Remarks):
        return Table(title=part.title, heads=(), rows=(), notes=part.lines)
    table = in_units(part.readable)
    return Table(
        title=table.title,
        heads=tuple(head(column) for column in table.columns) if table.rows else (),
        rows=tuple(tuple(MINUS.sub("−", cell) for cell in row) for row in cells(table)),
        notes=table.notes,
        numeric=tuple(not column.left for column in table.columns),
    )
