"""The ground of a polar diagram: a cross and whole circles, each with its value where room is."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise
from math import ceil, cos, floor, log10, pi, sin
from typing import NamedTuple

import numpy as np

from crankstar.charts.drawing import brief
from crankstar.charts.labels import Box, Label, box, crossed, meets
from crankstar.charts.letters import SMALL
from crankstar.charts.plane import Frame, Stroke
from crankstar.spectra import Complex

STEPS = (0.2, 0.25, 0.5, 1.0, 2.0, 2.5, 5.0)
"""Steps between circles, in powers of ten."""
FEWEST, MOST = 2, 4
"""Numbers of circles."""
AROUND = 10.0
"""px around the outermost circle, for the crank angles at dots on it."""
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
    radii = tuple(float(f"{step * power * place:.9g}") for place in range(1, count + 1))
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


def values(grid: Grid, strokes: Sequence[Stroke]) -> list[Label]:
    """The values of the circles, inside them beside one half of the cross, clear of the strokes.

    The half and its side are those where the most have room; where the outermost has none, it
    stands in a corner of the square, outside all circles.
    """
    scale = grid.frame.scale
    lines: Complex = np.array(
        [(a * scale, b * scale) for each in strokes for a, b in pairwise(each.points)], complex
    ).reshape(-1, 2)
    ways = [(way, side) for way in (1j, -1j, -1 + 0j, 1 + 0j) for side in (-1, 1)]
    columns = [_column(grid, lines, way, side) for way, side in ways]
    best = max(columns, key=lambda column: (_outer(column, grid) is not None, len(column)))
    if _outer(best, grid) is None:
        corner = grid.outermost * complex(-(0.5**0.5), 0.5**0.5)
        best.append(_value(grid.outermost, corner, -1 + 1j))
    return best


def _outer(column: Sequence[Label], grid: Grid) -> Label | None:
    return next((label for label in column if abs(label.anchor) >= grid.outermost * 0.999), None)


def _column(grid: Grid, lines: Complex, way: complex, side: int) -> list[Label]:
    """The values that have room beside one half of the cross, the outermost first."""
    scale = grid.frame.scale
    kept: list[Label] = []
    taken: list[Box] = []
    for place in reversed(range(len(grid.radii))):
        label = _value(grid.radii[place], grid.radii[place] * way, -way + side * 1j * way)
        here = box(label, theta=0.0, scale=scale)
        inner = (here.middle * way.conjugate()).real
        inner -= here.across if way.imag else here.upright
        below = grid.radii[place - 1] * scale if place else 0.0
        free = not crossed([here], lines).any() and not any(meets(here, other) for other in taken)
        if free and inner > below:
            kept.append(label)
            taken.append(here)
    return kept


def _value(radius: float, anchor: complex, way: complex) -> Label:
    return Label(brief(radius), anchor, way, size=SMALL, gap=2.0)
