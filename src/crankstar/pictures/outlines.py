"""Closed outlines across a shaft, `up + i right`, as complex arrays, anticlockwise or clockwise."""

from __future__ import annotations

from math import acos, ceil, pi

import numpy as np

from crankstar.spectra import Complex

CORNERS = 28
"""Of a circle."""


def circle(radius: float, *, centre: complex = 0j, corners: int = CORNERS) -> Complex:
    """A circle as a polygon."""
    return centre + radius * np.exp(2j * pi * np.arange(corners) / corners)


def arc(radius: float, *, middle: float, half: float, steps: int) -> Complex:
    """Points about the origin, `half` to either side of a bearing, both ends included."""
    return radius * np.exp(1j * np.linspace(middle - half, middle + half, steps + 1))


def band(*, radius: float, distance: float, bearing: float, other: float) -> Complex:
    """A band round two circles: one about the origin, the other at a distance and bearing.

    >>> float(band(radius=1.0, distance=4.0, bearing=0.0, other=1.0).real.max())
    5.0
    """
    far = distance * np.exp(1j * bearing)
    if distance <= abs(radius - other):
        return circle(radius) if radius >= other else circle(other, centre=complex(far))
    lean = acos((radius - other) / distance)
    return np.concatenate(
        [
            arc(radius, middle=bearing + pi, half=pi - lean, steps=18),
            far + arc(other, middle=bearing, half=lean, steps=12),
        ]
    )


def sector(*, outer: float, bearing: float, half: float) -> Complex:
    """A piece of a disc, at most half of it, `half` to either side of a bearing."""
    half = min(half, pi / 2)
    return np.append(arc(outer, middle=bearing, half=half, steps=max(6, ceil(half * 12))), 0j)


def strip(*, low: float, high: float, wide: float, narrow: float) -> Complex:
    """A strip along the bearing 0 between two heights, as wide (halves) as said at each."""
    return np.array([low - 1j * wide, low + 1j * wide, high + 1j * narrow, high - 1j * narrow])


def gear(radius: float, teeth: int) -> Complex:
    """A gear wheel of this pitch radius; its first tooth stands at the bearing 0."""
    depth = min(0.12 * radius, 2.1 * radius / teeth)
    tooth = np.array([(-0.3, -0.55), (-0.13, 0.45), (0.13, 0.45), (0.3, -0.55)])
    turns = (np.arange(teeth)[:, None] + tooth[:, 0]) * (2 * pi / teeth)
    return ((radius + depth * tooth[:, 1]) * np.exp(1j * turns)).ravel()
