"""The crank angle in figures: its axis, the rule at the parameter theta, functions of theta."""

from __future__ import annotations

from math import ceil, floor
from typing import Any

from crankstar.charts.grammar import Channel, Layer, field, of_rows, span
from crankstar.language.messages import _
from crankstar.spectra import Complex, Real

STEPS = (1, 2, 5, 10, 15, 30, 45, 90, 180, 360, 720)
"""Degrees between the marks of an axis."""
MOST_TICKS = 8


def across(turns: int, *, ticks: int, foot: bool, **axis: Any) -> Channel:
    """The crank angle over some turns to the right; numbers and title only at the `foot`."""
    return field(
        "x:Q",
        scale=span(0, 360 * turns),
        axis={"values": list(range(0, 360 * turns + 1, ticks)), "labels": foot, **axis},
        title=_("crank angle θ (degrees)") if foot else None,
    )


def angle_ticks(*, low: float, high: float) -> list[float]:
    """Places along an axis in degrees at a step that divides a turn as engineers do.

    >>> angle_ticks(low=0, high=360), angle_ticks(low=-20, high=70)
    ([0, 45, 90, 135, 180, 225, 270, 315, 360], [-15, 0, 15, 30, 45, 60])
    """
    step = next((n for n in STEPS if (high - low) / n <= MOST_TICKS), (high - low) / 4)
    first, last = ceil(low / step - 1e-9), floor(high / step + 1e-9)
    return [index * step for index in range(first, last + 1)]


def at_theta(turns: int, **formulas: str) -> Layer:
    """One row with `x` at the parameter theta within these turns, and fields from formulas."""
    cycle = f"theta - {360 * turns} * floor(theta / {360 * turns + 1e-6})"
    return of_rows([{}]).calculate(x=cycle, **formulas)


def waves(orders: Real, amplitudes: Complex) -> str:
    """The sum of Re(c exp(i k theta)) over the orders k as an expression of the parameter theta."""
    terms = [
        f"({c.real:.12g}) * cos({order:.12g} * theta * PI / 180)"
        f" - ({c.imag:.12g}) * sin({order:.12g} * theta * PI / 180)"
        for order, c in zip(orders.tolist(), amplitudes.tolist(), strict=True)
    ]
    return " + ".join(terms) or "0"
