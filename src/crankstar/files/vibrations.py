"""Amplitudes of vibration in a list: displacement, velocity or acceleration, by their unit."""

from __future__ import annotations

from math import nan
from typing import NamedTuple

from crankstar.engine.quantities import Quantity
from crankstar.files import units
from crankstar.files.columns import Columns
from crankstar.files.lists import Row
from crankstar.language.messages import _
from crankstar.language.quoting import seen

VIBRATIONS = (
    Quantity("length", "12 um", least=1e-12),
    Quantity("speed along a line", "3 mm/s", least=1e-10),
    Quantity("acceleration", "0.5 m/s^2", least=1e-8),
)
"""What is measured, each the rate of the one before it."""


class Vibration(NamedTuple):
    """An amplitude in SI units, and which of VIBRATIONS it is."""

    size: float
    rate: int


def vibration_of(columns: Columns, row: Row, name: str) -> Vibration:
    r"""The amplitude of a cell, in its own unit or that of its heading; nan where it is mistaken.

    >>> from crankstar.files.lists import list_of
    >>> found = Columns(list_of("order,amplitude [mm/s]\n1,3\n2,12 um", name="m.csv"), {
    ...     "order": "order", "amplitude": "amplitude"})
    >>> [vibration_of(found, row, "amplitude") for row in found.rows]
    [Vibration(size=0.003, rate=1), Vibration(size=1.2e-05, rate=0)]
    """
    text = columns.text(row, name)
    own = units.unit_of(text)
    rate = units.which(own or columns.unit(name), VIBRATIONS)
    if rate is not None or name not in columns:
        size = columns.value(row, name, VIBRATIONS[rate or 0])
        return Vibration(not_negative(columns, row, name, size), rate or 0)
    if not own:
        why = _(
            "it has no unit of a displacement, a velocity or an acceleration; name one, as in "
            "{example}",
            example=f'"{name} [um]"',
        )
        columns.refuse_head(name, why)
    else:
        why = _(
            "{text} is no displacement, velocity or acceleration; name its unit, as in {example}",
            text=seen(text),
            example=f'"{name} [um]"',
        )
        columns.refuse(row, name, why)
    return Vibration(nan, 0)


def not_negative(columns: Columns, row: Row, name: str, size: float) -> float:
    """An amplitude, noted as a mistake where it is negative."""
    if size < 0:
        columns.refuse(row, name, _("an amplitude is not negative; its phase says the sign"))
    return size
