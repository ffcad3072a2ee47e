"""The rotating and reciprocating masses on each crank pin, and its bobweight.

A rod as a rigid body is shared between its ends as its centre of mass divides it; a slave rod's
share of the crank end turns, near enough, with the pin of its master: `slave_error` says how near.
"""

from __future__ import annotations

from cmath import exp
from typing import NamedTuple

from crankstar import spectra
from crankstar.engine.engine import Engine
from crankstar.mechanics.balance import balance, scales


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


def slave_error(engine: Engine, load: Load) -> float:
    """What slave rods on a pin put on the crank beside their masses counted at the pin, a mass.

    All moving parts of the cylinders on the pin have of order 1 a vector F r w^2 that turns with
    the crank; with knuckle pins at the crank pin it were that of rotating + reciprocating / 2. The
    size of the difference of the two, in kg or the unit of masses: 0 without articulated rods.

    >>> from crankstar.files.catalog import load
    >>> radial = load("radial-9", changes={"cylinder.rotating_mass": 0.6})
    >>> round(slave_error(radial, loads(radial)[0]), 4)
    0.06
    """
    on = [each for each in engine.cylinders if each.number in load.cylinders]
    if not any(each.articulated for each in on):
        return 0.0
    found = balance(engine)
    rows = [index for index, part in enumerate(found.parts) if part.cylinder in load.cylinders]
    whole = spectra.selected(spectra.total(found.force[rows, :]), [1.0]).forward[0]
    moving = complex(whole) / scales(engine, None)[0].force / load.radius
    counted = sum(each.rotating + each.reciprocating / 2 for each in on)
    return abs(moving - counted * exp(1j * load.angle))
