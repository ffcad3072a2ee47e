"""What is asked of the gas: a degree of irregularity, mean effective pressures."""

from __future__ import annotations

from fractions import Fraction

from crankstar.engine.quantities import PRESSURE
from crankstar.files import units
from crankstar.options import values as request
from crankstar.options.values import refusal

MOST_LOADS = 12
"""Columns of a table of harmonics."""
LEAST_IRREGULARITY, GREATEST_IRREGULARITY = 1e-4, 1.0


def degree_of_irregularity(text: str | None) -> float | None:
    """The share of --irregularity, as a number or a fraction. Raises RequestError."""
    if text is None:
        return None
    try:
        value = float(Fraction(text.replace(" ", "")))
    except (ValueError, ZeroDivisionError, OverflowError):
        value = 0.0
    if not LEAST_IRREGULARITY <= value <= GREATEST_IRREGULARITY:
        raise refusal(
            "--irregularity", text, "give a share from 1/10000 to 1, such as 1/50 or 0.02"
        )
    return value


def gas_orders(text: str | None) -> list[float] | None:
    """The orders of --orders up to those of a cycle, None without. Raises RequestError.

    >>> gas_orders("0.5,2"), gas_orders(None)
    ([0.5, 2.0], None)
    """
    from crankstar.mechanics.gas_torque import HIGHEST

    wanted = request.orders(text, [n / 2 for n in range(1, int(2 * HIGHEST) + 1)])
    if wanted and max(wanted) > HIGHEST:
        raise refusal("--orders", text or "", "give orders up to {highest}", highest=f"{HIGHEST:g}")
    return wanted


def mean_pressures(text: str | None) -> tuple[float, ...]:
    """The pressures of --tangential, Pa. Raises RequestError."""
    parts = request.listed(text)
    if text is not None and not 1 <= len(parts) <= MOST_LOADS:
        raise refusal(
            "--tangential",
            text,
            'give one to {most} pressures with commas, such as "4 bar, 8 bar"',
            most=MOST_LOADS,
        )
    out: list[float] = []
    for part in parts:
        with request.reading("--tangential"):
            value = units.si(part, PRESSURE)
        if value <= 0:
            raise request.not_positive("--tangential", part, PRESSURE)
        out.append(value)
    return tuple(out)
