"""What is great in a table, beside which a difference is rounding."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from crankstar.analysis.document import ROW_UNIT, Column, Table, Value


def tops(table: Table, others: Sequence[Table]) -> list[Callable[[tuple[Value, ...]], float]]:
    """The greatest number of each column, of those that a row can be measured by.

    Rows of several units are measured by those of their own; a plain number by itself alone.
    """
    units = [index for index, column in enumerate(table.columns) if column.kind == "unit"]
    every = [row for each in (table, *others) for row in each.rows]

    def top_of(index: int, column: Column) -> Callable[[tuple[Value, ...]], float]:
        of_row = units[0] if units and column.unit == ROW_UNIT else None
        most: dict[Value, float] = {}
        for row in every:
            if index < len(row) and isinstance(row[index], int | float | complex):
                unit = "" if of_row is None else row[of_row]
                most[unit] = max(most.get(unit, 0.0), abs(row[index]))  # pyright: ignore[reportArgumentType]
        if of_row is None:
            return lambda _row: most.get("", 0.0)
        return lambda row: most.get(row[of_row], 0.0) if row[of_row] else 0.0

    return [top_of(index, column) for index, column in enumerate(table.columns)]
