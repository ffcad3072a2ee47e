"""The places of labels: beyond the heads of arrows, clear of other labels and of lines."""

from __future__ import annotations

from cmath import exp
from collections.abc import Sequence
from functools import cache, lru_cache
from math import copysign, inf, pi
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from crankstar.charts.letters import TEXT, text_width
from crankstar.spectra import Complex, Real

ASIDE = (0, 25, -25, 50, -50, 80, -80, 115, -115, 150, -150, 180)
"""Degrees from the preferred direction of a label, in the order in which they are tried."""
FARTHER = (0.0, 9.0, 20.0, 32.0, 46.0, 62.0, 80.0, 100.0, 122.0, 146.0)
"""px beyond the gap of a label, in the order in which they are tried."""
Place = tuple[float, float, float]
"""How much farther than the gap of a label (px), how far aside (degrees), and its cost."""
PLACES: tuple[Place, ...] = tuple(
    (farther, turn, abs(turn) / 60 + farther / 14) for farther in FARTHER for turn in ASIDE
)
"""The places of a label in the order in which they are tried."""
ROUND = 48
"""Places that are compared at once."""
SAME = 1e-9
"""Costs that differ by so little are the same: the first place is taken."""
NEAREST = tuple(place for place in PLACES if place[0] <= FARTHER[2] and abs(place[1]) <= 25)
"""Those in which every way of a label is tried."""
BESIDE = 75
"""Degrees aside from which a label has a leader, as it has where it is farther away."""
ACROSS_TEXT, ACROSS_FAINT, ACROSS_LINE = 4.0, 2.0, 0.4
"""The cost of a line or faint lines through a text, and of a leader over a line.

In steps of 14 px or 60 deg.
"""
ANOTHER, NEAR_LINE, NEAR_LABEL, CLEAR = 0.04, 1.5, 0.6, 11.0
"""The cost of the next way in which a label may stand, and of another line than its own or another
label nearer to it than so many px."""
CLOSE = 2.5
"""px between a line and a corner of its label."""
GREATEST_LABELS = 150
"""Greatest number of legible labels."""
GAP = 5.0
"""Between the tip of an arrow and its label, px."""


class Label(NamedTuple):
    """A text beside a point that may turn.

    The point is `place + anchor` at theta = 0, and `anchor` turns with `rate`.

    `direction` (a unit vector at theta = 0 that turns as well) is the side of the point on which
    the text is, `gap` (px) its distance; a label that is `led` has a line to its point. One
    `beside` a line keeps from others, and its leader ends in a dot. All in the clock plane,
    up + i*right, in the units of the figure.
    """

    text: str
    anchor: complex
    direction: complex
    rate: float = 0.0
    place: complex = 0j
    colour: str = "#808080"
    size: int = TEXT
    gap: float = GAP
    led: bool = False
    beside: bool = False


class Box(NamedTuple):
    """A rectangle on the screen, px: its middle `up + i*right`, half its width and height."""

    middle: complex
    across: float
    upright: float


def extent(label: Label) -> tuple[float, float]:
    """Half the width and half the height of a text, px."""
    return text_width(label.text, label.size) / 2, 0.6 * label.size * (1 + label.text.count("\n"))


def box(label: Label, *, theta: float, scale: float) -> Box:
    """Where a label stands at a crank angle (radians), px; `scale` in px per unit."""
    across, upright = extent(label)
    point, way = _point(label, theta=theta, scale=scale)
    shift = complex((upright + label.gap) * way.real, (across + label.gap) * way.imag)
    return Box(point + shift, across, upright)


def _point(label: Label, *, theta: float, scale: float) -> tuple[complex, complex]:
    """The point of a label, px, and the side of it on which the text is."""
    phase = exp(1j * label.rate * theta)
    return (label.place + label.anchor * phase) * scale, label.direction * phase


@lru_cache(maxsize=256)  # weights change no order above the first: their engine is drawn as before
def apart(
    labels: tuple[tuple[Label, ...], ...],
    *,
    theta: float,
    scale: float,
    strokes: tuple[tuple[complex, complex], ...],
    within: Box,
    around: tuple[Box, ...] = (),
    faint: tuple[tuple[complex, complex], ...] = (),
) -> tuple[Label, ...]:
    """The labels, moved aside from other labels and strokes, with leaders where they are far.

    Each is given as the ways in which it may stand, the best first; only that one may be far.
    `strokes` are the lines drawn at `theta`, from and to, px, and `faint` those on which a text may
    stand rather than far away; `within` is the rectangle for labels, `around` the occupied
    rectangles. Labels that find no place are left out.
    """
    taken: Complex = np.array(around, complex).reshape(-1, 3)
    lines: Complex = np.array([*faint, *strokes], complex).reshape(-1, 2)
    out: list[Label] = []
    for ways in labels[:GREATEST_LABELS]:
        best = _placed(ways, _Ground(taken, lines, len(faint), within, theta, scale))
        if best is not None:
            out.append(best.label)
            taken = np.concatenate([taken, np.array([best.box], complex)])
            if best.label.led:
                point, _way = _point(best.label, theta=theta, scale=scale)
                leader = np.array([[point, leader_end(point, best.box)]])
                lines = np.concatenate([lines, leader])
    return tuple(out)


class _Place(NamedTuple):
    """A label where it may stand."""

    label: Label
    box: Box


class _Ground(NamedTuple):
    """What a label is placed among, px: rows of `Box`, and lines of which the first are faint."""

    taken: Complex
    lines: Complex
    faint: int
    within: Box
    theta: float
    scale: float


def _placed(ways: Sequence[Label], ground: _Ground) -> _Place | None:
    """The cheapest place of a label, of several the first; None where there is none.

    Places are compared in rounds, the nearest first: none is cheaper than it is far.
    """
    best: tuple[float, int] = (inf, 0)
    found: Label | None = None
    for places in _rounds(len(ways)):
        if places.far[0] > best[0] + SAME:
            break
        boxes = _boxes(ways, places, ground)
        free = np.nonzero(_inside(boxes, ground.within) & ~_met(boxes, ground.taken))[0]
        cost = places.far[free] + _in_the_way(ways, places.owner[free], boxes[free], ground)
        for at in np.argsort(cost, kind="stable"):
            if cost[at] > best[0] + SAME:
                break
            place = int(free[at])
            owner, farther, turn = (values[place].item() for values in places[:3])
            moved = _moved(ways[owner], farther, turn)
            whole = round(float(cost[at]) + _cost_of_leader(moved, ground), 9)
            if (whole, int(places.rank[place])) < best:
                best, found = (whole, int(places.rank[place])), moved
    return found and _Place(found, box(found, theta=ground.theta, scale=ground.scale))


class _Places(NamedTuple):
    """Places to try at once [place]: of which way of a label, where, at what cost, which is first.

    How much farther (px) and how far aside (degrees) than it stands, as in `Place`.
    """

    owner: NDArray[np.int_]
    farther: Real
    turn: Real
    far: Real
    rank: NDArray[np.int_]


@cache
def _rounds(ways: int) -> tuple[_Places, ...]:
    """All places of a label of so many ways, the nearest first, in rounds."""
    several = ways if ways > 1 else 0
    owner = np.repeat([*range(several), 0], [len(NEAREST)] * several + [len(PLACES)])
    places: Real = np.array([*NEAREST * several, *PLACES])
    far = places[:, 2] + ANOTHER * owner
    rank = np.argsort(far, kind="stable")
    parts = np.array_split(rank, np.arange(ROUND, rank.size, ROUND))
    return tuple(
        _Places(owner[part], places[part, 0], places[part, 1], far[part], part) for part in parts
    )


def _in_the_way(
    ways: Sequence[Label], owner: NDArray[np.int_], boxes: Complex, ground: _Ground
) -> Real:
    """What lines through the rectangles of texts cost, and what is near those beside a line."""
    lines, faint = ground.lines[ground.faint :], ground.lines[: ground.faint]
    across = ACROSS_FAINT * crossed(boxes, faint).any(axis=1) if len(faint) else 0.0
    if not ways[0].beside:
        return ACROSS_TEXT * crossed(boxes, lines).sum(axis=1) + across
    wider = boxes + np.array([0, CLEAR, CLEAR])
    through, near = np.split(crossed(np.concatenate([boxes, wider]), lines), 2)
    points = np.array([_point(way, theta=ground.theta, scale=ground.scale)[0] for way in ways])
    others = _away(points, lines)[owner]
    return (
        ACROSS_TEXT * through.sum(axis=1)
        + across
        + NEAR_LINE * (near & others).sum(axis=1)
        + NEAR_LABEL * _met(wider, ground.taken)
    )


def _boxes(labels: Sequence[Label], places: _Places, ground: _Ground) -> Complex:
    """The rectangles of labels at places, as rows of `Box`."""
    owner = places.owner
    shown = [_point(label, theta=ground.theta, scale=ground.scale) for label in labels]
    point, way = np.array(shown, complex)[owner].T
    across, upright = np.array([extent(label) for label in labels])[owner].T
    turned = way * np.exp(1j * np.radians(places.turn))
    gap = np.array([label.gap for label in labels])[owner] + places.farther
    middle = point + (upright + gap) * np.real(turned) + 1j * (across + gap) * np.imag(turned)
    return np.column_stack([middle, across, upright])


def _cost_of_leader(label: Label, ground: _Ground) -> float:
    """What the texts and lines cost over which the leader of a label runs, if it has one."""
    if not label.led:
        return 0.0
    here = box(label, theta=ground.theta, scale=ground.scale)
    point, _way = _point(label, theta=ground.theta, scale=ground.scale)
    leader = np.array([[point, leader_end(point, here)]])
    over_texts = int(crossed(ground.taken, leader).sum())
    return ACROSS_TEXT * over_texts + ACROSS_LINE * _crossings(
        leader[0], ground.lines[ground.faint :]
    )


def _away(points: Complex, lines: Complex) -> NDArray[np.bool_]:
    """Which lines do not run through points, [point, line], px."""
    ways, off = lines[:, 1] - lines[:, 0], points[:, None] - lines[:, 0]
    along = np.real(np.conj(ways) * off) / np.maximum(np.abs(ways) ** 2, 1e-12)
    nearest: Real = np.abs(np.clip(along, 0.0, 1.0) * ways - off)
    return nearest > 1.0


def beside(label: Label, *, theta: float) -> Label:
    """The label of a line through its point, across its direction, CLOSE to it with a corner.

    `box` puts texts farther aside than up, which at a slanting line is too near.
    """
    (across, upright), way = extent(label), _point(label, theta=theta, scale=1.0)[1]
    up, right = abs(way.real), abs(way.imag)
    nearer = upright * (up - up**2) + across * (right - right**2)
    return label._replace(gap=CLOSE + nearer, beside=True)


def _moved(label: Label, farther: float, turn: float) -> Label:
    """The label farther from its point, and turned aside by so many degrees."""
    led = farther > 0 or abs(turn) > BESIDE
    direction = label.direction * exp(1j * turn * pi / 180)
    return label._replace(direction=direction, gap=label.gap + farther, led=led)


def leader_end(point: complex, box: Box) -> complex:
    """Where the leader of a point ends at the rectangle of its text, px."""
    off = box.middle - point
    across, up = off.imag, off.real
    return point + complex(
        copysign(max(abs(up) - box.upright, 0.0), up),
        copysign(max(abs(across) - box.across, 0.0), across),
    )


def gathered(places: Sequence[complex], near: float) -> list[list[int]]:
    """The indices of points that lie together: within `near` of the first of them.

    >>> gathered([0, 5, 0.1], 1)
    [[0, 2], [1]]
    """
    groups: list[list[int]] = []
    for index, place in enumerate(places):
        home = next((group for group in groups if abs(places[group[0]] - place) <= near), None)
        home.append(index) if home is not None else groups.append([index])
    return groups


def meets(box: Box, other: Box) -> bool:
    """Whether two rectangles overlap."""
    between = box.middle - other.middle
    return (
        abs(between.imag) < box.across + other.across + 1
        and abs(between.real) < box.upright + other.upright
    )


def _met(boxes: Complex, others: Complex) -> NDArray[np.bool_]:
    """Which rectangles, rows of `Box`, overlap with one of others."""
    between = boxes[:, None, 0] - others[:, 0]
    across, upright = (np.real(boxes[:, None, i] + others[:, i]) for i in (1, 2))
    met: NDArray[np.bool_] = np.abs(np.imag(between)) < across + 1
    met &= np.abs(np.real(between)) < upright
    return np.any(met, axis=1)


def _inside(boxes: Complex, frame: Box) -> NDArray[np.bool_]:
    """Which rectangles, rows of `Box`, are within another one."""
    off, across, upright = boxes[:, 0] - frame.middle, np.real(boxes[:, 1]), np.real(boxes[:, 2])
    return (np.abs(np.imag(off)) + across <= frame.across + 1) & (
        np.abs(np.real(off)) + upright <= frame.upright + 1
    )


def crossed(boxes: Sequence[Box] | Complex, lines: Complex) -> NDArray[np.bool_]:
    """Which lines [line, end] run through which rectangles, [box, line]; height taken tightly.

    A line misses a rectangle where the two lie apart across, upright or along the normal of the
    line (separating axes).
    """
    half = (lines[:, 1] - lines[:, 0]) / 2
    up, right = np.real(half), np.imag(half)
    sizes: Complex = np.asarray(boxes, complex).reshape(-1, 3)
    off = lines[:, 0] + half - sizes[:, :1]
    across, upright = np.real(sizes[:, 1:2]), 0.8 * np.real(sizes[:, 2:])
    ahead, aside = np.real(off), np.imag(off)
    high, wide = np.abs(up), np.abs(right)
    return (
        (np.abs(aside) < across + wide)
        & (np.abs(ahead) < upright + high)
        & (np.abs(aside * up - ahead * right) <= across * high + upright * wide)
    )


def _crossings(leader: Complex, lines: Complex) -> int:
    """How many lines [line, end] a leader crosses, its own ends aside."""
    start, step = leader[0], leader[1] - leader[0]
    if abs(step) < 1:
        return 0
    across = np.imag(np.conj(step) * (lines - start))
    ways = lines[:, 1] - lines[:, 0]
    ends = np.array([start + 0.08 * step, leader[1]])
    sides = np.imag(np.conj(ways)[:, None] * (ends - lines[:, :1]))
    hit: Real = (across[:, 0] * across[:, 1] < 0) & (sides[:, 0] * sides[:, 1] < 0)
    return int(hit.sum())
