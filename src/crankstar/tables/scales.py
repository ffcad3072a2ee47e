"""The units in which lengths, masses and unbalances of an engine are counted.

Where the file gives no sizes or masses, they are counted in m, r and a, as the engine has them.
"""

from __future__ import annotations

from typing import NamedTuple

from crankstar.engine.engine import Engine
from crankstar.language.shown_units import quantity_text


class Scale(NamedTuple):
    """A unit, and the factor from an engine's own numbers to it."""

    factor: float
    unit: str

    def of(self, value: float) -> float:
        """A value in the unit, without a rounding error that would be printed."""
        return round(value * self.factor, 9) + 0.0

    def text(self, value: float) -> str:
        """A value in the unit that it is shown in."""
        return quantity_text(value * self.factor, self.unit)


class Scales(NamedTuple):
    """Of lengths across and along the crankshaft, masses, and unbalances."""

    across: Scale
    along: Scale
    mass: Scale
    unbalance: Scale


def along_in_radii(engine: Engine) -> bool:
    """Whether lengths along the crankshaft are counted in crank radii, for want of a bore pitch."""
    lone = len({cylinder.z for cylinder in engine.cylinders}) == 1 and engine.bore_pitch is None
    return lone and "radius" in engine.relative


def scales(engine: Engine) -> Scales:
    """The scales of an engine.

    >>> from crankstar.files.catalog import load
    >>> [scale.unit for scale in scales(load("i4"))]
    ['r', 'a', 'm', 'm*r']
    """
    sized, weighed = "radius" not in engine.relative, "mass" not in engine.relative
    metric, radii = Scale(1000.0, "mm"), Scale(1.0, "r")
    along = Scale(1.0, "a") if "pitch" in engine.relative else metric
    return Scales(
        metric if sized else radii,
        radii if along_in_radii(engine) else along,
        Scale(1.0, "kg" if weighed else "m"),
        Scale(1.0, f"kg*{'m' if sized else 'r'}")
        if weighed
        else Scale(1 / engine.throw(engine.first).radius, "m*r"),
    )
