"""From where an engine is looked at, and what it fills of the picture.

A point is (x, y, z): to the right, up, to the front. Plan and side view have the front of the
engine at the left, so that they stand under each other in third-angle projection.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import atan, cos, pi, sin, sqrt
from typing import Literal, NamedTuple

import numpy as np

from crankstar.page.records import CylinderShown, Scene
from crankstar.spectra import Real

View = Literal["isometric", "front", "side", "plan"]
VIEWS: tuple[View, ...] = ("isometric", "front", "side", "plan")
ISOMETRIC = atan(sqrt(0.5))
"""Elevation of an isometric view, radians."""
AZIMUTHS = (45, -45, 30, -30, 60, -60, 20, -20)
"""Degrees from the front to the right: the isometric ones first, then those between."""
WORTH = 0.03
"""A view that is not isometric must show at least this much more of the bores."""
ALONG, ACROSS = 6, 3
"""Points of a bore that are looked at, along it and across."""
LABEL = 0.3
"""Bores: room for the number of a cylinder beyond its head."""


class Look(NamedTuple):
    """Unit vectors to the right and up on the picture, and back from the engine to the eye."""

    right: tuple[float, float, float]
    up: tuple[float, float, float]
    back: tuple[float, float, float]


def look_of(view: View, azimuth: float) -> Look:
    """The look of a view; `azimuth` (radians) is that of the isometric one."""
    flat: dict[str, Look] = {
        "front": Look((1, 0, 0), (0, 1, 0), (0, 0, 1)),
        "plan": Look((0, 0, -1), (-1, 0, 0), (0, 1, 0)),
        "side": Look((0, 0, -1), (0, 1, 0), (1, 0, 0)),
    }
    return flat.get(view) or upright(azimuth=azimuth, elevation=ISOMETRIC)


def upright(*, azimuth: float, elevation: float) -> Look:
    """The look from an azimuth and an elevation, the vertical upright."""
    aside, ahead, rise, level = sin(azimuth), cos(azimuth), sin(elevation), cos(elevation)
    return Look(
        (ahead, 0.0, -aside),
        (-rise * aside, level, -rise * ahead),
        (level * aside, rise, level * ahead),
    )


def clearest_azimuth(drawn: Scene) -> float:
    """The azimuth from which least of the bores is hidden behind others, radians."""
    best, least = AZIMUTHS[0], _hidden_share(drawn, AZIMUTHS[0])
    for azimuth in AZIMUTHS[1:]:
        share = _hidden_share(drawn, azimuth)
        if share < least - (1e-9 if abs(azimuth) == 45 else WORTH):
            best, least = azimuth, share
    return best * pi / 180


def _hidden_share(drawn: Scene, azimuth: float) -> float:
    """The share of the bores that stands behind other bores, from 0 to 1."""
    axes = np.array(upright(azimuth=azimuth * pi / 180, elevation=ISOMETRIC)).T
    starts = np.array([along(drawn, c, c.bore_from) for c in drawn.cylinders]) @ axes
    ends = np.array([along(drawn, c, bore_end(drawn, c)) for c in drawn.cylinders]) @ axes
    halves = np.array([c.bore / 2 for c in drawn.cylinders])
    way = (ends - starts)[:, :2]
    long = np.maximum(np.hypot(*way.T), 1e-12)
    aside = 0.8 * halves[:, None] * np.column_stack([-way[:, 1], way[:, 0]]) / long[:, None]
    shares = np.linspace(0, 1, ALONG + 1)
    points = starts[:, None, None, :] + shares[:, None, None] * (ends - starts)[:, None, None, :]
    points = np.repeat(points, ACROSS, axis=2)
    points[..., :2] += np.linspace(-1, 1, ACROSS)[:, None] * aside[:, None, None, :]
    hidden = np.zeros(points.shape[:3], bool)
    for row, start in enumerate(starts):
        from_start = points - start
        share = np.clip((from_start[..., :2] @ way[row]) / long[row] ** 2, 0, 1)
        off = np.hypot(*np.moveaxis(from_start[..., :2] - share[..., None] * way[row], -1, 0))
        nearer = start[2] + share * (ends[row] - start)[2] > points[..., 2] + halves[row]
        covers = (off < halves[row]) & nearer
        covers[row] = False
        hidden |= covers
    return float(hidden.mean())


def along(drawn: Scene, cylinder: CylinderShown, distance: float) -> tuple[float, float, float]:
    """A point on the axis of a cylinder, so far from its shaft: x, y, z."""
    shaft = drawn.shafts[cylinder.shaft]
    axis = np.exp(1j * cylinder.bearing)
    place = complex(shaft.up, shaft.right) + axis * complex(distance, cylinder.offset)
    return place.imag, place.real, cylinder.z


def facing(drawn: Scene, cylinder: CylinderShown) -> CylinderShown | None:
    """The cylinder whose piston works in the same chamber from the other side."""
    for other in drawn.cylinders:
        opposite = cos(other.bearing - cylinder.bearing) < -0.99
        if other.chamber == cylinder.chamber and opposite:
            return other
    return None


def bore_end(drawn: Scene, cylinder: CylinderShown) -> float:
    """Where a bore ends: at its head, or halfway to the piston that faces its own."""
    other = facing(drawn, cylinder)
    if other is None:
        return cylinder.bore_to
    own, far = along(drawn, cylinder, cylinder.bore_to), along(drawn, other, other.bore_to)
    return cylinder.bore_to + float(np.hypot(far[0] - own[0], far[1] - own[1])) / 2


class Discs(NamedTuple):
    """Discs that must be visible: centres (x, y, z), the ways they face, radii."""

    centres: Real
    facings: Real
    radii: Real

    def reach(self, axis: Sequence[float]) -> tuple[float, float]:
        """The least and the greatest of what they reach along a direction."""
        lean = self.facings @ np.asarray(axis)
        half = self.radii * np.sqrt(np.maximum(0.0, 1 - lean**2))
        middle = self.centres @ np.asarray(axis)
        return float((middle - half).min()), float((middle + half).max())


def discs_of(drawn: Scene, *, numbered: bool) -> Discs:
    """What an engine fills at every crank angle; `numbered`: with room for cylinder numbers."""
    rows: list[tuple[Sequence[float], Sequence[float], float]] = []
    for shaft in drawn.shafts:
        across = [(z, shaft.journal_radius) for z in (shaft.z_from, shaft.z_to)]
        for throw in shaft.throws:
            radius = throw.radius + 1.4 * throw.pin_radius
            across += [(throw.pin_from, radius), (throw.pin_to, radius)]
        for weight in shaft.weights:
            ends = (weight.z - weight.thickness / 2, weight.z + weight.thickness / 2)
            across += [(z, weight.outer_radius) for z in ends]
        rows += [((shaft.right, shaft.up, z), (0, 0, 1), radius) for z, radius in across]
    for wheel in drawn.gears:
        shaft = drawn.shafts[wheel.shaft]
        rows.append(((shaft.right, shaft.up, wheel.z), (0, 0, 1), 1.05 * wheel.radius))
    for c in drawn.cylinders:
        way = (sin(c.bearing), cos(c.bearing), 0)
        beyond = LABEL * c.bore if numbered and facing(drawn, c) is None else 0.0
        rows.append((along(drawn, c, c.bore_from), way, 0.5 * c.bore))
        rows.append((along(drawn, c, c.bore_to), way, 0.5 * c.bore))
        rows.append((along(drawn, c, c.bore_to + beyond), way, 0.2 * c.bore))
    centres, ways, radii = (np.array(column, float) for column in zip(*rows, strict=True))
    return Discs(centres, ways, radii)
