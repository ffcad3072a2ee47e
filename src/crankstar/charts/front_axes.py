"""Axes of a front: from values to px and back, straight or logarithmic with a place for 0."""

from __future__ import annotations

from collections.abc import Sequence
from math import ceil, floor, log10
from typing import NamedTuple

from crankstar.charts.grammar import Channel, field, span

DECADES = 2.0
"""Powers of ten spanned by values whose axis is logarithmic by default."""
GAP, EDGE = 0.18, 0.05
"""Shares of the span of a logarithmic axis: between 0 and the least value, and beyond the ends."""


class Axis(NamedTuple):
    """From values to px: linear, or by powers of ten with a place for 0 beside a gap."""

    low: float
    high: float
    length: float
    powers: bool = False
    zero: float | None = None

    def drawn(self, value: float) -> float:
        """The place of a value on the axis, which differs for 0 among powers of ten."""
        return self.zero if self.zero is not None and value <= 0 else value

    def place(self, value: float) -> float:
        """Px from the lower end of the axis."""
        value = self.drawn(value)
        if self.powers:
            return log10(value / self.low) / log10(self.high / self.low) * self.length
        return (value - self.low) / (self.high - self.low) * self.length

    def value(self, place: float) -> float:
        """The value at a place, px."""
        share = place / self.length
        if self.powers:
            return self.low * (self.high / self.low) ** share
        return self.low + share * (self.high - self.low)

    @property
    def ticks(self) -> list[float]:
        """The numbers of a logarithmic axis: powers of ten, multiples of few, and 0."""
        least = self.low if self.zero is None else self.zero * (self.high / self.low) ** (GAP / 2)
        tens = [10.0**power for power in range(floor(log10(least)), ceil(log10(self.high)) + 1)]
        among = [ten for ten in tens if least < ten <= self.high]
        for steps in ((1, 2, 5), range(1, 10)):
            if len(among) < 3:
                among = [
                    ten * step for ten in tens for step in steps if least < ten * step <= self.high
                ]
        return among if self.zero is None else [self.zero, *among]


def spans_decades(values: Sequence[float]) -> bool:
    """Whether values span so many decades that their axis is logarithmic by default."""
    sizes = [value for value in values if value > 0]
    return bool(sizes) and max(sizes) >= 10**DECADES * min(sizes)


def axis_of(values: Sequence[float], length: float, *, powers: bool) -> Axis:
    """The axis of these values over a length, px."""
    sizes = [value for value in values if value > 0]
    if not powers or not sizes:
        return Axis(0.0, 1.08 * max(sizes, default=1.0), length)
    low, high = min(sizes), max(sizes)
    span = max(high / low, 10.0)
    zero = low / span**GAP if min(values) <= 0 else None
    return Axis((zero or low) / span**EDGE, high * span**EDGE, length, powers=True, zero=zero)


def channel(name: str, axis: Axis, title: str) -> Channel:
    """The axis as a channel of a figure."""
    scale, marks = span(axis.low, axis.high), {"tickCount": 5}
    if axis.powers:
        zero = 0 if axis.zero is None else axis.zero * (axis.high / axis.low) ** (EDGE / 2)
        label = f"datum.value < {zero!r} ? '0' : format(datum.value, '~g')"
        scale, marks = scale | {"type": "log"}, {"values": axis.ticks, "labelExpr": label}
    return field(f"{name}:Q", scale=scale, title=title, axis=marks)
