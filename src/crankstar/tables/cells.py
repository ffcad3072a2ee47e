"""Values as readers see them: the one way in which a cell and a heading are written."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from crankstar.analysis.document import ROW_UNIT, Column, Ranged, Table, Value
from crankstar.language.messages import _
from crankstar.language.numbers import number, unit_text, wave


def cell(column: Column, value: Value) -> str:
    """A value as its column writes it.

    >>> cell(Column("force", kind="wave"), 2j), cell(Column("stars"), 12000)
    ('2 ∠ 90°', '12,000')
    >>> cell(Column("z"), None)
    ''
    >>> cell(Column("order", kind="order"), (1, 3, 4, 2)), cell(Column("", kind="span"), (720, 180))
    ('1-3-4-2', '720–180')
    """
    if value is None:
        return ""
    if isinstance(value, str):
        return unit_text(value) if column.kind == "unit" else value
    if isinstance(value, tuple):
        return _row(column, value)
    if isinstance(value, Ranged):
        return ranged_text(value)
    if isinstance(value, complex):
        return wave(value)
    return f"{value:,}" if isinstance(value, int) else number(value, digits=column.digits)


ROUGH = 3
"""Figures of a value that rests on estimates."""


def ranged_text(value: Ranged) -> str:
    """A value with its range, if that is seen in ROUGH figures; of a wave the amplitude has one.

    >>> ranged_text(Ranged(1234.5, 900.0, 1600.0)), ranged_text(Ranged(2j, 1.5, 2.5))
    ('1230 (900 to 1600)', '2 (1.5 to 2.5) ∠ 90°')
    """
    size = abs(value.value) if isinstance(value.value, complex) else value.value
    typical, low, high = (rough(number) for number in (size, value.low, value.high))
    text = _("{typical} ({low} to {high})", typical=typical, low=low, high=high)
    text = typical if low == high else text
    written = wave(value.value) if isinstance(value.value, complex) else ""
    return f"{text} ∠ {written.partition('∠ ')[2]}" if "∠" in written else text


def rough(value: float) -> str:
    """A number that rests on estimates.

    >>> rough(1234.5), rough(0.0123456), rough(123456)
    ('1230', '0.0123', '123000')
    """
    return number(float(f"{value:.{ROUGH}g}"))


def _row(column: Column, values: Sequence[Any]) -> str:
    if column.kind == "span":
        return "–".join(number(value) for value in values) or _("none")
    written = [_one(column, value) for value in values]
    return ("-" if column.kind == "order" else ", ").join(written) or "-"


def _one(column: Column, value: Any) -> str:
    if isinstance(value, tuple):
        return "-".join(map(str, value))
    return str(value) if isinstance(value, int | str) else number(value, digits=column.digits)


def heading(column: Column) -> tuple[str, str]:
    """Heading and unit of a column, the unit in brackets.

    >>> heading(Column("couple", "m*r*w^2*a"))
    ('couple', '[m r ω² a]')
    """
    unit = "" if column.unit == ROW_UNIT else unit_text(column.unit)
    words = column.heading
    if column.estimated:
        words = _("{heading} (estimated)", heading=words).strip()
    return words, f"[{unit}]" if unit else ""


def head(column: Column) -> str:
    """Heading and unit in one line."""
    return " ".join(filter(None, heading(column)))


def cells(table: Table) -> list[list[str]]:
    """The rows of a table as text."""
    return [
        [cell(column, value) for column, value in zip(table.columns, row, strict=True)]
        for row in table.rows
    ]
