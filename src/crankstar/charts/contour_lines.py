"""Lines along which a result over two numbers has one value, and the places of their labels."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from math import ceil, floor, log10
from typing import NamedTuple

import numpy as np

from crankstar.charts.labels import Box, meets
from crankstar.charts.letters import SMALL, text_width
from crankstar.language.numbers import number
from crankstar.spectra import Real

STEPS = 7.0
"""About how many levels there are."""
FLAT = 1e-6
"""Share of the greatest value by which a result must vary for lines to be drawn."""
MARGIN, DENSE = 3.0, 3.0
"""px around a label that its line leaves free; px between the points of a line."""
SHORTEST = 2.2
"""Lengths of its label that a line must have to be labelled."""
_AROUND = {
    1: ((3, 0),),
    2: ((0, 1),),
    3: ((3, 1),),
    4: ((1, 2),),
    6: ((0, 2),),
    7: ((3, 2),),
    8: ((2, 3),),
    9: ((2, 0),),
    11: ((2, 1),),
    12: ((1, 3),),
    13: ((1, 0),),
    14: ((0, 3),),
}
"""The edges of a cell that a line joins, by the corners (1, 2, 4, 8) that lie above the level."""
_SADDLES = {(5, True): ((3, 2), (1, 0)), (5, False): ((3, 0), (1, 2))}
_SADDLES.update({(10, True): ((0, 3), (2, 1)), (10, False): ((0, 1), (2, 3))})
"""The same where opposite corners lie above, by whether the middle does as well."""

Point = tuple[float, float]
Edge = tuple[int, int, int]


class Contour(NamedTuple):
    """The lines of a level, in pieces that leave room for its labels, and where these are."""

    level: float
    pieces: list[list[Point]]
    labels: list[Point]


def levels(*, low: float, high: float) -> list[float]:
    """Round values between two, some seven of them; none where they are the same.

    >>> levels(low=0.0, high=1.0), levels(low=3.0, high=3.0)
    ([0.2, 0.4, 0.6, 0.8], [])
    """
    if high - low <= FLAT * max(abs(low), abs(high)):
        return []
    rough = (high - low) / STEPS
    ten = 10.0 ** floor(log10(rough))
    step = next(ten * each for each in (1, 2, 2.5, 5, 10) if ten * each >= rough * 0.999)
    wanted = (float(f"{k * step:.9g}") for k in range(ceil(low / step), floor(high / step) + 1))
    return [level for level in wanted if low + FLAT * step < level < high - FLAT * step]


def level_lines(x: Real, y: Real, z: Real, level: float) -> list[list[Point]]:
    """The lines on which z [x, y], straight between its points, has this value.

    None beside a point without a value (nan).

    >>> lines = level_lines(np.arange(2.0), np.arange(2.0), np.array([[0, 0], [1, 1]]), 0.25)
    >>> [[(float(a), float(b)) for a, b in line] for line in lines]
    [[(0.25, 0.0), (0.25, 1.0)]]
    """
    above = z >= level
    cases = above[:-1, :-1] + 2 * above[1:, :-1] + 4 * above[1:, 1:] + 8 * above[:-1, 1:]
    joined: dict[Edge, list[Edge]] = {}
    known = np.isfinite(z)
    whole = known[:-1, :-1] & known[1:, :-1] & known[1:, 1:] & known[:-1, 1:]
    for i, j in zip(*np.nonzero((cases > 0) & (cases < 15) & whole), strict=True):
        case, (row, column) = int(cases[i, j]), (int(i), int(j))
        middle = float(z[i : i + 2, j : j + 2].mean()) >= level
        edges = ((0, row, column), (1, row + 1, column), (0, row, column + 1), (1, row, column))
        for first, second in _AROUND.get(case) or _SADDLES[case, middle]:
            joined.setdefault(edges[first], []).append(edges[second])
            joined.setdefault(edges[second], []).append(edges[first])
    return [[_crossing(x, y, z, level, edge) for edge in chain] for chain in _chains(joined)]


def _crossing(x: Real, y: Real, z: Real, level: float, edge: Edge) -> Point:
    along_y, i, j = edge
    end = (i, j + 1) if along_y else (i + 1, j)
    low, high = float(z[i, j]), float(z[end])
    share = (level - low) / (high - low)
    return (float(x[i] + share * (x[end[0]] - x[i])), float(y[j] + share * (y[end[1]] - y[j])))


def _chains(joined: dict[Edge, list[Edge]]) -> list[list[Edge]]:
    """Edges in the order in which lines cross them; open lines first, from their ends."""
    left = {edge: list(others) for edge, others in joined.items()}
    out: list[list[Edge]] = []
    for start in sorted(left, key=lambda edge: len(joined[edge])):
        while left[start]:
            chain = [start]
            while left[chain[-1]]:
                following = left[chain[-1]].pop()
                left[following].remove(chain[-1])
                chain.append(following)
            out.append(chain)
    return out


def labelled_contours(
    x: Real, y: Real, z: Real, *, size: Point, taken: Iterable[Box] = ()
) -> list[Contour]:
    """The lines of round levels with labels clear of each other and of the boxes `taken` (px).

    `size`: width and height of the panel whose axes reach over x and y. Every level has a label
    where there is room on one of its lines.
    """
    scale = (size[0] / float(x[-1] - x[0]), size[1] / float(y[-1] - y[0]))
    boxes, out = [*taken], []
    for level in levels(low=float(np.nanmin(z)), high=float(np.nanmax(z))):
        pieces: list[list[Point]] = []
        labels: list[Point] = []
        text = number(level)
        half = text_width(text, SMALL) / 2 + MARGIN, SMALL / 2 + MARGIN
        for line in level_lines(x, y, z, level):
            places = [((a - x[0]) * scale[0], (b - y[0]) * scale[1]) for a, b in line]
            dense = _dense([(float(a), float(b)) for a, b in places])
            box = _place(dense, half, size, boxes)
            if box is not None:
                boxes.append(box)
                labels.append((box.middle.imag, box.middle.real))
            pieces += _outside(dense, box)
        out.append(
            Contour(
                level,
                [[_data(point, x, y, scale) for point in piece] for piece in pieces],
                [_data(point, x, y, scale) for point in labels],
            )
        )
    return out


def _data(point: Point, x: Real, y: Real, scale: Point) -> Point:
    return float(x[0]) + point[0] / scale[0], float(y[0]) + point[1] / scale[1]


def _dense(line: Sequence[Point]) -> list[Point]:
    """A line in px with a point at about every DENSE px."""
    places = np.array(line)
    lengths = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(places, axis=0).T))])
    count = max(2, ceil(lengths[-1] / DENSE) + 1)
    at = np.linspace(0, lengths[-1], count)
    return [
        (float(a), float(b))
        for a, b in zip(
            np.interp(at, lengths, places[:, 0]), np.interp(at, lengths, places[:, 1]), strict=True
        )
    ]


def _place(line: Sequence[Point], half: Point, size: Point, taken: Sequence[Box]) -> Box | None:
    """Where on a line its label has room, as near to its middle as can be."""
    if len(line) * DENSE < SHORTEST * 2 * half[0]:
        return None
    middle = len(line) // 2
    for index in sorted(range(len(line)), key=lambda place: abs(place - middle)):
        across, up = line[index]
        box = Box(complex(up, across), half[0], half[1])
        inside = half[0] <= across <= size[0] - half[0] and half[1] <= up <= size[1] - half[1]
        if inside and not any(meets(box, other) for other in taken):
            return box
    return None


def _outside(line: Sequence[Point], box: Box | None) -> list[list[Point]]:
    """The pieces of a line outside the box of its label."""
    if box is None:
        return [list(line)]
    pieces: list[list[Point]] = [[]]
    for across, up in line:
        hidden = (
            abs(across - box.middle.imag) < box.across and abs(up - box.middle.real) < box.upright
        )
        if not hidden:
            pieces[-1].append((across, up))
        elif pieces[-1]:
            pieces.append([])
    return [piece for piece in pieces if len(piece) > 1]
