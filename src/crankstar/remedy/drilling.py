"""What to drill, or which slugs of heavy metal to fit, to correct an unbalance.

A drill of diameter d and tip angle t that cuts to the depth h at full diameter leaves a cylinder
and under it a cone of height c = d / (2 tan(t/2)). Radially inward from radius R it takes away the
unbalance, with A = pi d^2 / 4,

    U = rho A (h (R - h/2) + c/3 (R - h - c/4)),

and parallel to the crank axis, its own axis at R,

    U = rho A (h + c/3) R.

A slug of density rho_s fills the cylinder: it adds rho_s A h (R - h/2), or rho_s A h R, less U.
Where one hole would be too deep there are n, an angle a apart about the same direction with a wall
of a quarter of the diameter between them; together they have sin(n a/2) / sin(a/2) times the
unbalance of one. The curve of the rim within the hole is left out (d^2 / 32 R of its depth).
"""

from __future__ import annotations

from math import asin, inf, isfinite, pi, sin, tan
from typing import NamedTuple

import numpy as np

from crankstar.engine.engine import Engine
from crankstar.language.shown_units import quantity_text
from crankstar.remedy.counterweights import RemedyError
from crankstar.remedy.kept import changes

STEEL = 7850.0
"""Density of a steel crankshaft, kg/m^3."""
TUNGSTEN = 17_000.0
"""Density of usual tungsten alloys for crankshafts, kg/m^3."""
TIP = 118 * pi / 180
"""Angle of the tip of a usual twist drill."""
MOST_HOLES = 24
WALL = 1.25
"""Diameters between the axes of neighbouring holes where they are closest."""
WIDEST = 2 * pi / 3
"""Angle between the first and the last hole, at most: what a counterweight spans."""
STEPS = 512
"""Depths that are tried before the right one is closed in on."""


class Drill(NamedTuple):
    """A drill or slug: diameter, radius R of the rim or of an axial hole, greatest depth, m.

    `tip` is the whole angle of the tip, pi for a flat one; densities are in kg/m^3.
    """

    diameter: float
    radius: float
    deepest: float
    tip: float = TIP
    density: float = STEEL
    slug: float | None = None
    axial: bool = False

    @property
    def cone(self) -> float:
        """Height of the cone under the hole, m."""
        return 0.0 if self.tip >= pi else self.diameter / 2 / tan(self.tip / 2)


class Holes(NamedTuple):
    """Equal holes: how many, depth at full diameter and to the tip [m], angles from their middle.

    `mass` [kg] is what all of them take away, or add.
    """

    number: int
    depth: float
    tip_depth: float
    angles: tuple[float, ...]
    mass: float


class HeavySpot(NamedTuple):
    """Where a crankshaft is too heavy: shaft, place z, unbalance, its bearing at theta = 0."""

    shaft: str
    z: float
    unbalance: float
    angle: float


def unbalance_of_hole(depth: float, drill: Drill) -> float:
    """Unbalance [kg m] that a hole of a depth takes away, or that the slug in it adds.

    >>> drill = Drill(diameter=0.0127, radius=0.08, deepest=0.04)
    >>> round(unbalance_of_hole(0.025, drill) * 1e6)  # g mm
    1746
    >>> round(unbalance_of_hole(0.025, drill._replace(tip=pi, slug=17_000)) * 1e6)
    1956
    """
    area, cone, radius = pi / 4 * drill.diameter**2, drill.cone, drill.radius
    inward = 0.0 if drill.axial else 1.0
    cylinder = area * depth * (radius - inward * depth / 2)
    tip = area * cone / 3 * (radius - inward * (depth + cone / 4))
    if drill.slug is None:
        return drill.density * (cylinder + tip)
    return drill.slug * cylinder - drill.density * (cylinder + tip)


def mass_of_hole(depth: float, drill: Drill) -> float:
    """Mass [kg] that a hole takes away, or that the slug adds net of the steel taken away."""
    area = pi / 4 * drill.diameter**2
    removed = drill.density * area * (depth + drill.cone / 3)
    return removed if drill.slug is None else drill.slug * area * depth - removed


def holes(unbalance: float, drill: Drill) -> Holes:
    """The fewest equal holes that have this unbalance [kg m] together; for 0 there are none.

    Raises RemedyError where the drill is impossible, or no number of holes is enough.

    >>> drill = Drill(diameter=0.0127, radius=0.08, deepest=0.03)
    >>> two = holes(0.0035, drill)
    >>> two.number, round(two.depth * 1000, 1), round(two.angles[1] * 180 / pi, 1)
    (2, 25.4, 8.4)
    """
    possible(drill)
    if not unbalance > 0:
        return Holes(0, 0.0, 0.0, (), 0.0)
    if drill.slug is None and unbalance < unbalance_of_hole(0.0, drill):
        return _countersunk(unbalance, drill)
    greatest = 0.0
    for count in range(1, MOST_HOLES + 1):
        depths = np.linspace(0, drill.deepest, STEPS + 1)[1:]
        sums = [_together(float(depth), count, drill) for depth in depths]
        greatest = max(greatest, *sums)
        place = next((at for at, size in enumerate(sums) if size >= unbalance), None)
        if place is not None:
            low, high = float(depths[place]) - drill.deepest / STEPS, float(depths[place])
            depth = _closed_in(unbalance, low, high, count, drill)
            step = _step(depth, drill) if count > 1 else 0.0
            angles = tuple((index - (count - 1) / 2) * step for index in range(count))
            mass = count * mass_of_hole(depth, drill)
            return Holes(count, depth, depth + drill.cone, angles, mass)
    if drill.slug is not None:
        raise RemedyError(
            "an unbalance of {needed} is more than slugs of {diameter}, side by side and {deepest} "
            "long and {share} % denser than what they replace, can have ({greatest}); take a "
            "denser metal, a larger diameter or radius, or more planes",
            needed=quantity_text(unbalance, "kg*m"),
            diameter=_length(drill.diameter),
            deepest=_length(drill.deepest),
            share=f"{100 * (drill.slug / drill.density - 1):.3g}",
            greatest=_greatest(greatest),
        )
    raise RemedyError(
        "an unbalance of {needed} is more than holes of {diameter}, side by side and {deepest} "
        "deep, can have ({greatest}); take a larger diameter or radius, or more planes",
        needed=quantity_text(unbalance, "kg*m"),
        diameter=_length(drill.diameter),
        deepest=_length(drill.deepest),
        greatest=_greatest(greatest),
    )


def _greatest(unbalance: float) -> str:
    """The most that holes can have, kg m, in three figures whatever was asked of them."""
    return quantity_text(float(f"{max(unbalance, 0.0):.3g}"), "kg*m")


def possible(drill: Drill) -> None:
    """Refuse a drill without size, or one that goes beyond the crank axis. Raises RemedyError."""
    if not drill.diameter > 0 or not drill.deepest > 0 or not isfinite(drill.radius):
        raise RemedyError("the diameter and the greatest depth must be greater than 0")
    if drill.diameter >= drill.radius:
        raise RemedyError(
            "a hole of {diameter} does not fit at a radius of {radius}; give a smaller diameter",
            diameter=_length(drill.diameter),
            radius=_length(drill.radius),
        )
    room = drill.radius - drill.cone
    if not drill.axial and drill.deepest >= room:
        raise RemedyError(
            "a hole {deepest} deep from a radius of {radius} reaches the crank axis; give a "
            "greatest depth below {room}",
            deepest=_length(drill.deepest),
            radius=_length(drill.radius),
            room=_length(room),
        )
    if drill.slug is not None and drill.slug <= drill.density:
        raise RemedyError(
            "a slug of {slug} is no heavier than the {density} that it replaces; give a denser "
            "metal, such as {example}",
            slug=quantity_text(drill.slug, "kg/m^3"),
            density=quantity_text(drill.density, "kg/m^3"),
            example=quantity_text(TUNGSTEN, "kg/m^3"),
        )


def _length(metres: float) -> str:
    return quantity_text(1000 * metres, "mm")


def _step(depth: float, drill: Drill) -> float:
    """Angle between neighbouring holes, whose walls are thinnest at their bottoms."""
    closest = drill.radius - (0.0 if drill.axial else depth)
    share = WALL * drill.diameter / 2 / closest
    return 2 * asin(share) if share < 1 else inf


def _together(depth: float, count: int, drill: Drill) -> float:
    """Unbalance of so many holes of a depth; none where they do not fit side by side."""
    single = unbalance_of_hole(depth, drill)
    if count == 1:
        return single
    step = _step(depth, drill)
    if (count - 1) * step > WIDEST:
        return -inf
    return single * sin(count * step / 2) / sin(step / 2)


def _closed_in(unbalance: float, low: float, high: float, count: int, drill: Drill) -> float:
    """The depth between two at which so many holes have the unbalance."""
    for _ in range(60):
        middle = (low + high) / 2
        if middle > 0 and _together(middle, count, drill) >= unbalance:
            high = middle
        else:
            low = middle
    return high


def _countersunk(unbalance: float, drill: Drill) -> Holes:
    """The hole that a part of the tip leaves, for less than a whole one takes away."""
    low, high = 0.0, drill.cone
    for _ in range(60):
        middle = (low + high) / 2
        if _cone(middle, drill)[0] < unbalance:
            low = middle
        else:
            high = middle
    return Holes(1, 0.0, high, (0.0,), _cone(high, drill)[1])


def _cone(height: float, drill: Drill) -> tuple[float, float]:
    """Unbalance and mass of the cone that the tip cuts to this depth."""
    mass = drill.density * pi * (height * tan(drill.tip / 2)) ** 2 * height / 3
    return mass * (drill.radius - (0.0 if drill.axial else height / 4)), mass


def heavy_spots(before: Engine, after: Engine) -> tuple[HeavySpot, ...]:
    """Where a crankshaft is heavier than it should be: opposite the weights that it still needs.

    `after` has those besides (`with_counterweights`).

    >>> from crankstar.files.catalog import load
    >>> from crankstar.remedy.counterweights import with_counterweights
    >>> twin = load("v2-90")  # without counterweights it is heavy at the pin
    >>> (spot,) = heavy_spots(twin, with_counterweights(twin, factor=0.5))
    >>> pin = twin.shafts[0].throws[0].angle
    >>> spot.unbalance, bool(np.isclose(np.exp(1j * spot.angle), np.exp(1j * pin)))
    (1.0, True)
    """
    became = changes(before, after)
    return tuple(
        HeavySpot(shaft.name, weight.z, weight.unbalance, weight.angle + pi)
        for shaft in after.shafts
        if shaft.throws
        for weight in became[shaft.name].added
    )
