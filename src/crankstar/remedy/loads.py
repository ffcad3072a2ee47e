"""What each crank pin carries: the masses that turn with it and those that go to and fro, and the bobweight that stands for them.

A rod as a rigid body is shared between its ends as its centre of mass divides it; a slave rod's share of the crank end
turns, near enough, with the pin of its master.
"""

from __future__ import annotations

from typing import NamedTuple

from crankstar.engine import Engine
from crankstar.records import Cylinder


class Load(NamedTuple):
    """A crank pin: shaft, number of the throw (from 1), bearing at theta = 0, radius, z, cylinders, and masses at its radius."""

    shaft: str
    throw: int
    angle: float
    radius: float
    z: float
    cylinders: tuple[int, ...]
    rotating: float
    reciprocating: float


def loads(engine: Engine) -> tuple[Load, ...]:
    """The pins of all crankshafts; pins without cylinders too, which may have rotating mass.

    >>> from crankstar.catalog import load
    >>> [(pin.cylinders, pin.reciprocating) for pin in loads(load("v2-90"))]
    [((1, 2), 2.0)]
    """
    found: list[Load] = []
    for shaft in engine.shafts:
        for number, throw in enumerate(shaft.throws, 1):
            on = [cylinder for cylinder in engine.cylinders if (cylinder.shaft, cylinder.throw) == (shaft.name, number)]
            found.append(
                Load(
                    shaft=shaft.name,
                    throw=number,
                    angle=throw.angle,
                    radius=throw.radius,
                    z=throw.z,
                    cylinders=tuple(cylinder.number for cylinder in on),
                    rotating=throw.rotating_mass + sum(map(_turning, on)),
                    reciprocating=sum(map(_moving, on)),
                )
            )
    return tuple(found)


def _moving(cylinder: Cylinder) -> float:
    """Reciprocating mass: the piston's, and the rod's share at its pin."""
    rod = cylinder.rod
    return cylinder.reciprocating_mass + (rod.mass * rod.centre / cylinder.rod_length if rod else 0.0)


def _turning(cylinder: Cylinder) -> float:
    """The rod's share at the crank."""
    rod = cylinder.rod
    return cylinder.big_end_mass + (rod.mass * (1 - rod.centre / cylinder.rod_length) if rod else 0.0)


def bobweight(load: Load, factor: float) -> float:
    """The mass that is clamped on a pin to spin the crankshaft: rotating + factor * reciprocating, of all cylinders of the pin, kg.

    `factor` is the share of *all* the reciprocating mass on the pin. A shop that counts one cylinder's only calls the same
    crankshaft by `factor` times the number of cylinders on the pin.

    >>> from crankstar.catalog import load
    >>> bobweight(loads(load("v2-90"))[0], 0.5)  # half of two pistons: all of one
    1.0
    """
    return load.rotating + factor * load.reciprocating
