"""The ground of a polar diagram: a cross and whole circles, each with its value on it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise
from math import ceil, cos, floor, log10, pi, sin
from typing import NamedTuple

import numpy as np

from crankstar.charts.drawing import brief
from crankstar.charts.labels import Box, Label, box, crossed, meets
from crankstar.charts.letters import SMALL
from crankstar.charts.plane import Dot, Frame, Stroke, around
from crankstar.spectra import Complex

STEPS = (0.2, 0.25, 0.5, 1.0, 2.0, 2.5, 5.0)
"""Steps between circles, in powers of ten."""
FEWEST, MOST = 2, 4
"""Numbers of circles."""
AROUND = 10.0
"""px around the outermost circle, for the crank angles at dots on it."""
WAYS = tuple(
    complex(cos(angle), sin(angle))
    for aside in (20, 35, 50, 65, 0, 90)
    for angle in (pi / 180 * each for each in (aside, -aside, 180 - aside, aside - 180))
)
"""Directions for the values of circles: beside the upright half of the cross their texts, which are
wider than high, reach into the fewest other circles."""
ACROSS, ASIDE = 10.0, 0.5
"""The cost of a value across a line, and of one in another direction than most; of one across
another circle it is 1."""
CIRCLE = np.exp(1j * np.linspace(0, 2 * pi, 181))


class Grid(NamedTuple):
    """A square frame and the radii of the circles in it, the innermost first."""

    frame: Frame
    radii: tuple[float, ...]

    @property
    def outermost(self) -> float:
        """The radius of the outermost circle."""
        return self.radii[-1]


def polar_grid(reach: float, *, side: float) -> Grid:
    """Two to four circles at round radii in a square of `side` px; the last encloses the reach.

    >>> polar_grid(1.25, side=150).radii, polar_grid(952, side=150).radii
    ((0.5, 1.0, 1.5), (500.0, 1000.0))
    """
    power = 10.0 ** floor(log10(reach)) if reach > 0 else 1.0
    size = (reach or 1.0) / power
    counts = [(step, ceil(size / step - 1e-9)) for step in STEPS]
    _outer, count, step = min(
        (round(step * count, 9), count, step) for step, count in counts if FEWEST <= count <= MOST
    )
    radii = tuple(float(f"{step * power * index:.9g}") for index in range(1, count + 1))
    half = side / 2
    scale = (half - AROUND) / radii[-1]
    return Grid(Frame(-half / scale, half / scale, -half / scale, half / scale, scale), radii)


def ground(grid: Grid, directions: Sequence[float]) -> Iterator[Stroke]:
    """The cross, the circles, and dashed lines in these directions (radians)."""
    long = grid.outermost
    yield Stroke((-1j * long, 1j * long), width=0.6, faint=True)
    yield Stroke((-long + 0j, long + 0j), width=0.6, faint=True)
    for radius in grid.radii:
        yield Stroke(tuple((radius * CIRCLE).tolist()), width=0.5, faint=True)
    for angle in directions:
        yield Stroke((0j, long * complex(cos(angle), sin(angle))), width=1.0, dashed=True)


def values(grid: Grid, strokes: Sequence[Stroke], dots: Sequence[Dot] = ()) -> list[Label]:
    """The values of the circles, each on its own circle, clear of strokes, dots and each other.

    They stand in the one direction in which all have most room, and a value that has none there
    where it has most.
    """
    scale = grid.frame.scale
    lines: Complex = np.array(
        [(a * scale, b * scale) for each in strokes for a, b in pairwise(each.points)], complex
    ).reshape(-1, 2)
    taken = [around(dot, scale) for dot in dots]
    labels = [[_value(radius, way) for way in WAYS] for radius in grid.radii]
    costs = np.array([[_cost(grid, label, lines, taken) for label in row] for row in labels])
    common = int(costs.sum(axis=0).argmin())
    kept: list[Label] = []
    for row, cost in zip(reversed(labels), costs[::-1], strict=True):
        boxes = [box(label, theta=0.0, scale=scale) for label in kept]
        others = [
            ACROSS * any(meets(box(label, theta=0.0, scale=scale), other) for other in boxes)
            + ASIDE * (way != common)
            for way, label in enumerate(row)
        ]
        kept.append(row[int((cost + others).argmin())])
    return kept


def _cost(grid: Grid, label: Label, lines: Complex, taken: Sequence[Box]) -> float:
    """How badly a value stands: on lines, on dots, out of the frame, on circles of other values."""
    scale = grid.frame.scale
    here = box(label, theta=0.0, scale=scale)
    up, right = abs(here.middle.real), abs(here.middle.imag)
    half = grid.frame.width / 2
    bad = crossed([here], lines).any() or any(meets(here, other) for other in taken)
    bad = bad or up + here.upright > half or right + here.across > half
    near = abs(complex(max(up - here.upright, 0.0), max(right - here.across, 0.0)))
    far = abs(complex(up + here.upright, right + here.across))
    own = abs(label.place)
    others = sum(near < radius * scale < far for radius in grid.radii if radius != own)
    return ACROSS * bool(bad) + others


def _value(radius: float, way: complex) -> Label:
    return Label(brief(radius), 0j, 0j, place=radius * way, size=SMALL)
