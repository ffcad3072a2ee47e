"""The places of views on a picture: one that fills it, or a sheet in third-angle projection."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal, NamedTuple

import numpy as np

from crankstar.pictures.looks import Discs, Look, View, look_of
from crankstar.spectra import Real

Sight = Literal["isometric", "front", "side", "plan", "sheet"]
SIGHTS: tuple[Sight, ...] = ("isometric", "front", "side", "plan", "sheet")
GAP, HEAD = 16.0, 20.0
"""px: between the views of a sheet, and above each for its name."""
PICTORIAL = (0.36, 0.4)
"""Shares of breadth and height that the isometric view of a sheet has at least."""
MARGIN = 1.06
"""How much larger than the engine the picture is."""


class Box(NamedTuple):
    """A rectangle of a picture, px from its upper left corner."""

    x: float
    y: float
    width: float
    height: float


class Pane(NamedTuple):
    """A view in its place: what is in the middle (x, y, z), px to one unit of length."""

    view: View
    box: Box
    look: Look
    centre: Real
    scale: float

    def at(self, points: Real) -> tuple[Real, Real]:
        """Points (x, y, z) [..., 3] on the picture, px to the right and down."""
        beside = np.asarray(points, float) - self.centre
        middle = self.box.x + self.box.width / 2, self.box.y + self.box.height / 2
        return (
            middle[0] + self.scale * (beside @ np.array(self.look.right)),
            middle[1] - self.scale * (beside @ np.array(self.look.up)),
        )


def panes_of(sight: Sight, discs: Discs, box: Box, *, azimuth: float) -> list[Pane]:
    """The views of a picture in a rectangle of it."""
    if sight == "sheet":
        return _sheet(discs, box, azimuth)
    return [_fitted(sight, discs, box, azimuth)]


def _fitted(view: View, discs: Discs, box: Box, azimuth: float) -> Pane:
    """A view as large as its rectangle allows."""
    look = look_of(view, azimuth)
    centre, spans = np.zeros(3), []
    for axis in look:
        low, high = discs.reach(axis)
        centre += np.array(axis) * (low + high) / 2
        spans.append(high - low)
    scale = min(box.width / spans[0], box.height / spans[1]) / MARGIN
    return Pane(view, box, look, centre, scale)


def _sheet(discs: Discs, box: Box, azimuth: float) -> list[Pane]:
    """Front and side view in line, the plan above the side, the engine as it stands in the corner.

    Front, side and plan have one scale.
    """
    reaches = [discs.reach(axis) for axis in ((1, 0, 0), (0, 1, 0), (0, 0, 1))]
    centre = np.array([(low + high) / 2 for low, high in reaches])
    x, y, z = (MARGIN * (high - low) for low, high in reaches)
    across, upward = box.width - GAP, box.height - GAP - 2 * HEAD
    corner, top = PICTORIAL[0] * across, PICTORIAL[1] * upward
    scale = min(across / (x + z), (across - corner) / z, upward / (x + y), (upward - top) / y)
    right = _shared(across, z * scale, max(corner, x * scale))
    lower = _shared(upward, y * scale, max(top, x * scale))
    left_x, right_x = box.x, box.x + box.width - right
    upper_y, lower_y = box.y + HEAD, box.y + box.height - lower
    columns = ((left_x, across - right), (right_x, right))
    rows = ((upper_y, upward - lower), (lower_y, lower))

    def place(column: int, row: int) -> Box:
        return Box(columns[column][0], rows[row][0], columns[column][1], rows[row][1])

    places: Sequence[tuple[View, int, int]] = (("plan", 1, 0), ("front", 0, 1), ("side", 1, 1))
    flat = [
        Pane(view, place(column, row), look_of(view, azimuth), centre, scale)
        for view, column, row in places
    ]
    return [_fitted("isometric", discs, place(0, 0), azimuth), *flat]


def _shared(length: float, own: float, other: float) -> float:
    """The part of a length for one of two that need `own` and `other`; what is left is shared."""
    return own + max(0.0, length - own - other) / 2
