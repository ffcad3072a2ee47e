"""Where labels stand: beyond the heads of arrows, off other labels and off the lines, within the frame."""

from __future__ import annotations

from cmath import exp
from collections.abc import Sequence
from math import pi
from typing import NamedTuple

import numpy as np

from crankstar.charts.drawing import TEXT, text_width
from crankstar.phasor import Real

ASIDE = (0, 40, -40, 75, -75, 110, -110)
"""Degrees off the direction a label would like, in the order in which they are tried."""
GREATEST_LABELS = 60
"""More than so many cannot be read."""
WIDER = 1.14
"""By how much the letters of a browser's own font may be wider than those that are reckoned with."""
GAP = 5.0
"""Between the tip of an arrow and its label, px."""


class Label(NamedTuple):
    """A text beside a point that may turn: the point is `place + anchor` at theta = 0, and `anchor` turns with `rate`.

    `direction` (a unit vector at theta = 0 that turns as well) tells on which side of the point the text stands,
    `gap` (px) how far from it, times `away`. All in the clock plane, up + i*right, in the units of the figure.
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
    return WIDER * text_width(label.text, label.size) / 2, 0.6 * label.size * (1 + label.text.count("\n"))


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
    """The labels, moved aside where they would meet another one or lie on a stroke; what finds no place is left out.

    `strokes` are the lines drawn at `theta`, from and to, px; `within` the rectangle all must keep to, `around` those where
    something else is written.
    """
    taken: list[Box] = list(around)
    out: list[Label] = []
    for label in labels[:GREATEST_LABELS]:
        best: tuple[float, Label, Box] | None = None
        for away in (1.0, 1.7, 2.6):
            for turn in ASIDE:
                tried = label._replace(direction=label.direction * exp(1j * turn * pi / 180), away=away)
                here = box(tried, theta=theta, scale=scale)
                if any(meets(here, other) for other in taken) or not _inside(here, within):
                    continue
                cost = abs(turn) / 60 + 2 * (away - 1) + 4 * _crossed(here, strokes)
                if best is None or cost < best[0] - 1e-9:
                    best = (cost, tried, here)
        if best is not None:
            out.append(best[1])
            taken.append(best[2])
    return out


def meets(one: Box, other: Box) -> bool:
    """Whether two rectangles overlap."""
    between = one.middle - other.middle
    return abs(between.imag) < one.across + other.across + 1 and abs(between.real) < one.upright + other.upright


def _inside(one: Box, frame: Box) -> bool:
    off = one.middle - frame.middle
    return abs(off.imag) + one.across / WIDER <= frame.across + 1 and abs(off.real) + one.upright <= frame.upright + 1


STEPS: Real = np.linspace(0, 1, 25)


def _crossed(one: Box, strokes: Sequence[tuple[complex, complex]]) -> int:
    """How many strokes run through a rectangle."""
    if not strokes:
        return 0
    ends = np.array(strokes)
    along = ends[:, :1] + (ends[:, 1:] - ends[:, :1]) * STEPS - one.middle
    hit = (np.abs(along.imag) < one.across) & (np.abs(along.real) < 0.8 * one.upright)
    return int(np.any(hit, axis=1).sum())
