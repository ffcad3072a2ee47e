"""The rotating and reciprocating masses on each crank pin, and its bobweight.

A rod as a rigid body is shared between its ends as its centre of mass divides it; a slave rod's
share of the crank end turns, near enough, with the pin of its master.
"""

from __future__ import annotations

from typing import NamedTuple

from crankstar.engine.engine import Engine


class Load(NamedTuple):
    """A crank pin: throw (from 1), bearing at theta = 0, place, cylinders, masses at its radius.

    `rotating` hangs on the pin; `own` is what the crank throw itself has, which is no part of a
    bobweight since it turns in the balancing machine too.
    """

    shaft: str
    throw: int
    angle: float
    radius: float
    z: float
    cylinders: tuple[int, ...]
    rotating: float
    reciprocating: float
    own: float = 0.0

    @property
    def whole(self) -> float:
        """All the masses that move with the pin."""
        return self.rotating + self.own + self.reciprocating


def loads(engine: Engine) -> tuple[Load, ...]:
    """The pins of all crankshafts; pins without cylinders too, which may have rotating mass.

    >>> from crankstar.files.catalog import load
    >>> [(pin.cylinders, pin.reciprocating) for pin in loads(load("v2-90"))]
    [((1, 2), 2.0)]
    """
    pins: list[Load] = []
    for shaft in engine.shafts:
        for number, throw in enumerate(shaft.throws, 1):
            on = [
                cylinder
                for cylinder in engine.cylinders
                if (cylinder.shaft, cylinder.throw) == (shaft.name, number)
            ]
            pins.append(
                Load(
                    shaft=shaft.name,
                    throw=number,
                    angle=throw.angle,
                    radius=throw.radius,
                    z=throw.z,
                    cylinders=tuple(cylinder.number for cylinder in on),
                    rotating=throw.rotating_mass + sum(cylinder.rotating for cylinder in on),
                    reciprocating=sum(cylinder.reciprocating for cylinder in on),
                    own=throw.throw_mass,
                )
            )
    return tuple(pins)


def bobweight(load: Load, factor: float) -> float:
    """The mass clamped on a pin to balance the crankshaft: rotating + factor * reciprocating, kg.

    `factor` is the share of *all* the reciprocating mass on the pin. A shop that counts one
    cylinder's only calls the same crankshaft by `factor` times the number of cylinders on the pin.

    >>> from crankstar.files.catalog import load
    >>> bobweight(loads(load("v2-90"))[0], 0.5)  # half of two pistons: all of one
    1.0
    """
    return load.rotating + factor * load.reciprocating
