"""A Table in the units of the context: the one step between records in SI and any renderer."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace

from crankstar.analysis.document import ROW_UNIT, Column, Ranged, Table, Value
from crankstar.language.shown_units import Shown, choice, dimension, shown, shown_in
from crankstar.language.units import measured


def in_units(table: Table, *, prefixed: bool = True) -> Table:
    """The table with each number in the unit that the context chooses for its dimension.

    Without a chosen unit, the one that is usual in the table, else SI with the prefix that fits the
    greatest number of the dimension in it; not `prefixed`: as it is. So one table has one unit of
    force, and its columns compare.

    >>> table = Table("", (Column("force", "N"),), ((25_000.0,), (10.0,)))
    >>> in_units(table).columns[0].unit, in_units(table).rows
    ('kN', ((25.0,), (0.01,)))
    """
    if prefixed and table.usual:
        with shown_in({**table.usual, **choice()}):
            return in_units(replace(table, usual={}))
    largest = _largest(table)
    chosen = [
        Shown(column.unit, 1.0) if column.fixed else _of(column.unit, largest, prefixed)
        for column in table.columns
    ]
    columns = tuple(
        replace(column, unit=unit.unit) for column, unit in zip(table.columns, chosen, strict=True)
    )
    rows = table.rows
    if any(unit.factor != 1.0 for unit in chosen):
        rows = tuple(
            tuple(scaled(value, unit.factor) for value, unit in zip(row, chosen, strict=True))
            for row in rows
        )
    if any(column.kind == "unit" for column in columns):
        rows = _rows_in_units(columns, rows, prefixed)
    return replace(table, columns=columns, rows=rows)


def scaled(value: Value, factor: float) -> Value:
    """A value times a factor; words and missing values as they are."""
    if factor == 1.0 or value is None or isinstance(value, str):
        return value
    if isinstance(value, tuple):
        return tuple(scaled(item, factor) for item in value)
    if isinstance(value, Ranged):
        return Ranged(value.value * factor, value.low * factor, value.high * factor)
    return value * factor


def _of(unit: str, largest: Mapping[tuple[str, str], float], prefixed: bool) -> Shown:
    """The unit for a unit, by the greatest numbers (SI) of each dimension."""
    group = dimension(unit)
    if group not in largest:  # of no dimension, or one that goes with others
        return shown(unit, 0.0, prefixed=prefixed)
    return shown(unit, largest[group] / _factor(unit, group), prefixed=prefixed)


def _largest(table: Table) -> dict[tuple[str, str], float]:
    """By dimension the greatest number, in SI."""
    sizes: dict[tuple[str, str], float] = {}
    for index, column in enumerate(table.columns):
        group = dimension(column.unit)
        if not group[0] or column.fixed:
            continue
        size = _greatest(row[index] for row in table.rows)
        sizes[group] = max(sizes.get(group, 0.0), size * _factor(column.unit, group))
    return sizes


def _factor(unit: str, group: tuple[str, str]) -> float:
    return measured(unit.removesuffix(f"*{group[1]}") if group[1] else unit).factor


def _greatest(values: Iterable[Value]) -> float:
    sizes = [_greatest(value) if isinstance(value, tuple) else _size(value) for value in values]
    return max(sizes, default=0.0)


def _size(value: Value) -> float:
    if isinstance(value, Ranged):
        return value.high
    return abs(value) if isinstance(value, int | float | complex) else 0.0


def _rows_in_units(
    columns: Sequence[Column], rows: Sequence[tuple[Value, ...]], prefixed: bool
) -> tuple[tuple[Value, ...], ...]:
    """Rows whose numbers have the unit that stands in each; one unit for each dimension."""
    place = next(index for index, column in enumerate(columns) if column.kind == "unit")
    own = [at for at, column in enumerate(columns) if column.unit == ROW_UNIT]
    units = [str(row[place] or "") for row in rows]
    largest: dict[tuple[str, str], float] = {}
    for row, unit in zip(rows, units, strict=True):
        group = dimension(unit)
        if group[0]:
            size = _greatest(row[at] for at in own) * _factor(unit, group)
            largest[group] = max(largest.get(group, 0.0), size)
    chosen = [_of(unit, largest, prefixed) for unit in units]
    return tuple(
        tuple(
            unit.unit if at == place else scaled(value, unit.factor) if at in own else value
            for at, value in enumerate(row)
        )
        for row, unit in zip(rows, chosen, strict=True)
    )
