"""The places of labels: beyond the heads of arrows, clear of other labels and of lines."""

from __future__ import annotations

from cmath import exp
from collections.abc import Sequence
from math import pi
from typing import NamedTuple

import numpy as np

from crankstar.charts.drawing import TEXT, text_width
from crankstar.spectra import Complex, Real

ASIDE = (0, 40, -40, 75, -75, 110, -110)
"""Degrees from the preferred direction of a label, in the order in which they are tried."""
GREATEST_LABELS = 60
"""Greatest number of legible labels."""
WIDER = 1.14
"""Allowance for a font with wider letters."""
GAP = 5.0
"""Between the tip of an arrow and its label, px."""


class Label(NamedTuple):
    """A text beside a point that may turn.

    The point is `place + anchor` at theta = 0, and `anchor` turns with `rate`.

    `direction` (a unit vector at theta = 0 that turns as well) is the side of the point on which
    the text is, `gap` (px) times `away` its distance. All in the clock plane, up + i*right, in the
    units of the figure.
    """

    text: str
    anchor: complex
    direction: complex
    rate: float = 0.0
    place: complex = 0j
    colour: str = "#808080"
    size: int = TEXT
    gap: float = GAP
    away: float = 1.0


class Box(NamedTuple):
    """A rectangle on the screen, px: its middle `up + i*right`, half its width and height."""

    middle: complex
    across: float
    upright: float


def extent(label: Label) -> tuple[float, float]:
    """Half the width and half the height of a text, px."""
    return WIDER * text_width(label.text, label.size) / 2, 0.6 * label.size * (
        1 + label.text.count("\n")
    )


def box(label: Label, *, theta: float, scale: float) -> Box:
    """Where a label stands at a crank angle (radians), px; `scale` in px per unit."""
    across, upright = extent(label)
    phase = exp(1j * label.rate * theta)
    point, way = (label.place + label.anchor * phase) * scale, label.direction * phase
    shift = complex((upright + label.gap) * way.real, (across + label.gap) * way.imag) * label.away
    return Box(point + shift, across, upright)


def apart(
    labels: Sequence[Label],
    *,
    theta: float,
    scale: float,
    strokes: Sequence[tuple[complex, complex]],
    within: Box,
    around: Sequence[Box] = (),
) -> list[Label]:
    """The labels, moved aside from other labels and strokes, without those that find no place.

    `strokes` are the lines drawn at `theta`, from and to, px; `within` is the rectangle for labels,
    `around` the occupied rectangles.
    """
    taken: list[Box] = list(around)
    points = _points(strokes)
    out: list[Label] = []
    for label in labels[:GREATEST_LABELS]:
        best: tuple[float, Label, Box] | None = None
        for away in (1.0, 1.7, 2.6):
            for turn in ASIDE:
                least = abs(turn) / 60 + 2 * (away - 1)
                if best is not None and least >= best[0] - 1e-9:
                    continue
                tried = label._replace(
                    direction=label.direction * exp(1j * turn * pi / 180), away=away
                )
                here = box(tried, theta=theta, scale=scale)
                if any(meets(here, other) for other in taken) or not _inside(here, within):
                    continue
                cost = least + 4 * _crossed(here, points)
                if best is None or cost < best[0] - 1e-9:
                    best = (cost, tried, here)
        if best is not None:
            out.append(best[1])
            taken.append(best[2])
    return out


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


def _inside(box: Box, frame: Box) -> bool:
    off = box.middle - frame.middle
    return (
        abs(off.imag) + box.across / WIDER <= frame.across + 1
        and abs(off.real) + box.upright <= frame.upright + 1
    )


STEPS: Real = np.linspace(0, 1, 25)


def _points(strokes: Sequence[tuple[complex, complex]]) -> Complex:
    """Points along strokes [stroke, step]."""
    ends = np.array(strokes, complex).reshape(-1, 2)
    return ends[:, :1] + (ends[:, 1:] - ends[:, :1]) * STEPS


def _crossed(box: Box, points: Complex) -> int:
    """How many strokes run through a rectangle."""
    along = points - box.middle
    hit = (np.abs(along.imag) < box.across) & (np.abs(along.real) < 0.8 * box.upright)
    return int(np.any(hit, axis=1).sum())
