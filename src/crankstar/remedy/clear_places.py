"""The nearest place of a box that lies outside of circles, such as what cranks sweep.

The place wanted may lie in the box and outside of all circles; else the nearest one is on an edge
of the box or on a circle: at the foot of the perpendicular to an edge or along the radius to a
circle, at a corner, or where two of these lines meet. All of them are tried: the nearest is exact.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import combinations, product
from math import hypot, sqrt
from typing import NamedTuple

ROUNDING = 1e-9
"""Share of the greatest length by which a place may lie outside of the box or in a circle."""


class Box(NamedTuple):
    """The places open to a shaft: least and greatest `up` and `right` of the crankshaft."""

    up: tuple[float, float]
    right: tuple[float, float]


class Circle(NamedTuple):
    """What is kept clear: its centre, up + i right, and its radius."""

    centre: complex
    radius: float


def nearest_clear(wanted: complex, box: Box, circles: Sequence[Circle]) -> complex | None:
    """The place of the box outside of all circles nearest to `wanted`; None where there is none.

    >>> crank = Circle(0j, 2.0)
    >>> nearest_clear(0.5j, Box((-3, 3), (0, 3)), [crank])
    2j
    >>> nearest_clear(0j, Box((0, 1), (0, 1)), [crank]) is None
    True
    """
    room = ROUNDING * max(abs(edge) for span in box for edge in span)
    room = max(room, ROUNDING * max((circle.radius for circle in circles), default=0.0))
    best: complex | None = None
    for place in _candidates(wanted, box, circles):
        inside = all(
            low - room <= part <= high + room
            for part, (low, high) in zip((place.real, place.imag), box, strict=True)
        )
        clear = all(abs(place - circle.centre) >= circle.radius - room for circle in circles)
        if inside and clear and (best is None or abs(place - wanted) < abs(best - wanted) - room):
            best = place
    return best


def _candidates(wanted: complex, box: Box, circles: Sequence[Circle]) -> Iterator[complex]:
    up = min(max(wanted.real, box.up[0]), box.up[1])
    right = min(max(wanted.imag, box.right[0]), box.right[1])
    yield complex(up, right)
    yield from (complex(*corner) for corner in product(*box))
    yield from (complex(edge, right) for edge in box.up)
    yield from (complex(up, edge) for edge in box.right)
    for circle in circles:
        away = wanted - circle.centre
        way = away / abs(away) if away else 1j
        yield circle.centre + circle.radius * way
        yield from _on_edges(circle, box)
    for one, other in combinations(circles, 2):
        yield from _meetings(one, other)


def _on_edges(circle: Circle, box: Box) -> Iterator[complex]:
    """Where a circle meets the lines of the edges of a box."""
    centre = circle.centre
    for edge in box.up:
        square = circle.radius**2 - (edge - centre.real) ** 2
        if square >= 0:
            yield from (complex(edge, centre.imag + side * sqrt(square)) for side in (-1, 1))
    for edge in box.right:
        square = circle.radius**2 - (edge - centre.imag) ** 2
        if square >= 0:
            yield from (complex(centre.real + side * sqrt(square), edge) for side in (-1, 1))


def _meetings(one: Circle, other: Circle) -> Iterator[complex]:
    """Where two circles meet: a from the first centre along the line of both, h to either side."""
    line = other.centre - one.centre
    apart = hypot(line.real, line.imag)
    if apart == 0:
        return
    along = (apart**2 + one.radius**2 - other.radius**2) / (2 * apart)
    square = one.radius**2 - along**2
    if square >= 0:
        way = line / apart
        yield from (one.centre + way * complex(along, side * sqrt(square)) for side in (-1, 1))
