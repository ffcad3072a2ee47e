"""The numbers of the points of a front: beside their points, or at the end of a line."""

from __future__ import annotations

from cmath import exp
from collections.abc import Sequence
from itertools import pairwise
from math import ceil, hypot, radians
from typing import Any

from crankstar.charts.canvas import panel_width
from crankstar.charts.front_axes import Axis
from crankstar.charts.labels import Box, meets
from crankstar.charts.letters import SMALL, text_width

HEIGHT = 250
"""Of the plotting area, px."""
DOT = 80.0
"""Area of the mark of a point, px^2."""
RADIUS = DOT**0.5 / 2
"""Of a mark, px."""
NEARER = 3.0
"""Px by which a number without a line is closer to its own mark than to any other."""
LED = (20.0, 27.0, 35.0, 45.0)
"""Px from marks to numbers at the end of a line."""
CROWD = 40
"""Number of points above which numbers are not led to their points by lines."""
MOST_LISTED = 20
"""Points whose firing orders are written below the chart."""


def point_numbers(
    rows: Sequence[dict[str, Any]], steps: Sequence[dict[str, float]], across: Axis, upward: Axis
) -> tuple[list[dict[str, Any]], list[dict[str, float]]]:
    """The numbers of the points where there is room, and the lines that lead to them.

    Points on the dashed line come first, then those of the key; others have no numbers.
    """
    spots = {row["row"]: complex(upward.place(row["y"]), across.place(row["x"])) for row in rows}
    corners = [complex(upward.place(step["y"]), across.place(step["x"])) for step in steps]
    on_line = [row for row, spot in spots.items() if spot in corners]
    lines = [
        Box((a + b) / 2, abs((b - a).imag) / 2, abs((b - a).real) / 2) for a, b in pairwise(corners)
    ]
    taken = [Box(spot, RADIUS, RADIUS) for spot in spots.values()]
    numbers, leaders = [], []

    def spot_of(place: complex, x: str = "x", y: str = "y") -> dict[str, float]:
        return {x: across.value(place.imag), y: upward.value(place.real)}

    for row in dict.fromkeys([*on_line, *(row for row in spots if row <= MOST_LISTED)]):
        spot, led = spots[row], row in on_line or len(rows) <= CROWD
        others = [other for other in spots.values() if other != spot]
        beside = _beside(str(row), spot, others, taken, lines)
        placed = beside or (_led(str(row), spot, taken, lines) if led else None)
        if placed is None:
            continue
        numbers.append({"text": str(row), **spot_of(placed.middle)})
        taken.append(placed)
        if not beside:
            line = _leader(spot, placed)
            taken += [Box(point, 1.0, 1.0) for point in line]
            leaders.append(spot_of(line[0]) | spot_of(line[-1], "x2", "y2"))
    return numbers, leaders


def _beside(
    text: str, spot: complex, others: Sequence[complex], taken: Sequence[Box], lines: Sequence[Box]
) -> Box | None:
    """A place for a number next to its dot, farther from all others; best below or left."""
    wide, high = text_width(text, SMALL) / 2, SMALL / 2
    places = []
    off = RADIUS + 1.0
    for up, right in ((-1, 0), (0, -1), (-1, -1), (1, -1), (-1, 1), (1, 0), (1, 1), (0, 1)):
        places.append(Box(spot + complex(up * (high + off), right * (wide + off)), wide, high))
    free = [place for place in places if _is_free(place, taken)]
    own = [
        place
        for place in free
        if all(_gap(place, other) > _gap(place, spot) + NEARER for other in others)
    ]
    return min(own, key=lambda place: sum(meets(place, line) for line in lines), default=None)


def _led(text: str, spot: complex, taken: Sequence[Box], lines: Sequence[Box]) -> Box | None:
    """The nearest place for a number at the end of a free line from its dot, or None."""
    wide, high = text_width(text, SMALL) / 2, SMALL / 2
    others = [box for box in taken if box.middle != spot]
    for far in LED:
        places = [
            Box(spot + far * exp(1j * radians(225 + turn)), wide, high)
            for turn in range(0, 360, 15)
        ]
        free = [place for place in places if _is_free(place, taken)]
        free = [
            place
            for place in free
            if all(_is_free(Box(point, 1.5, 1.5), others) for point in _leader(spot, place))
        ]
        if free:
            return min(free, key=lambda place: sum(meets(place, line) for line in lines))
    return None


def _leader(spot: complex, place: Box) -> list[complex]:
    """The points of the line from a dot to its number, from edge to edge, about a px apart."""
    off = place.middle - spot
    way = off / abs(off)
    within = min(place.across / max(abs(way.imag), 1e-9), place.upright / max(abs(way.real), 1e-9))
    length = abs(off) - 1.0 - within - RADIUS
    return [
        spot + way * (RADIUS + length * step / ceil(length)) for step in range(ceil(length) + 1)
    ]


def _is_free(place: Box, taken: Sequence[Box]) -> bool:
    off = place.middle - complex(HEIGHT, panel_width()) / 2
    inside = (
        abs(off.imag) + place.across <= panel_width() / 2
        and abs(off.real) + place.upright <= HEIGHT / 2
    )
    return inside and not any(meets(place, other) for other in taken)


def _gap(place: Box, spot: complex) -> float:
    """How far a point is from a rectangle, px."""
    off = spot - place.middle
    return hypot(max(abs(off.imag) - place.across, 0.0), max(abs(off.real) - place.upright, 0.0))
