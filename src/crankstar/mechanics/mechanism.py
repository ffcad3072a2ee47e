"""An engine, or a batch of engines, as arrays of numbers."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from crankstar.engine import motion
from crankstar.engine.engine import Engine
from crankstar.spectra import Complex, Real


@dataclass(frozen=True)
class Mechanism:
    """An engine as arrays, SI units; leading axes of any array are a batch of engines.

    Per cylinder [..., C]: `links` (the rods), masses, `throw_angle` and `bearing` of the group's
    root, `z`, and the index of the shaft. Per rotor [..., R], the throws first and then the
    weights: unbalance (kg m), angle, z, index of the shaft. Per shaft [S]: signed speed ratio
    numerators and denominators; [..., S]: place `up + i*right`.

    >>> from crankstar.files.catalog import load
    >>> mechanism(load("i4")).throw_angle.shape
    (4,)
    """

    links: motion.Linkage
    throw_angle: Real
    bearing: Real
    z: Real
    reciprocating_mass: Real
    big_end_mass: Real
    rod_mass: Real
    rod_centre: Real
    rod_inertia: Real
    cylinder_shaft: tuple[int, ...]
    unbalance: Real
    unbalance_angle: Real
    unbalance_z: Real
    rotor_shaft: tuple[int, ...]
    ratios: tuple[tuple[int, int], ...]
    place: Complex
    sense: int


def mechanism(engine: Engine) -> Mechanism:
    """An engine as arrays."""
    cylinders, shafts = engine.cylinders, engine.shafts
    index = {shaft.name: index for index, shaft in enumerate(shafts)}
    links = motion.linkage(engine)
    root = [cylinders[place] for place in motion.roots(links.master)]
    bodies = [
        (c.rod.mass, c.rod.centre, c.rod.turning_inertia(c.rod_length))
        if c.rod
        else (0.0, 0.0, 0.0)
        for c in cylinders
    ]
    rod_mass, rod_centre, rod_inertia = np.array(bodies).T
    throws = [
        (t.turning_mass * t.radius, t.angle, t.z, i) for i, s in enumerate(shafts) for t in s.throws
    ]
    weights = [(w.unbalance, w.angle, w.z, i) for i, s in enumerate(shafts) for w in s.weights]
    unbalance, angle, z, rotor_shaft = zip(*throws + weights, strict=True)
    return Mechanism(
        links=links,
        throw_angle=np.array([engine.throw(c).angle for c in cylinders]),
        bearing=np.array([c.bearing for c in root]),
        z=np.array([c.z for c in cylinders]),
        reciprocating_mass=np.array([c.reciprocating_mass for c in cylinders]),
        big_end_mass=np.array([c.big_end_mass for c in cylinders]),
        rod_mass=rod_mass,
        rod_centre=rod_centre,
        rod_inertia=rod_inertia,
        cylinder_shaft=tuple(index[c.shaft] for c in cylinders),
        unbalance=np.array(unbalance),
        unbalance_angle=np.array(angle),
        unbalance_z=np.array(z),
        rotor_shaft=rotor_shaft,
        ratios=tuple((s.speed_ratio.numerator, s.speed_ratio.denominator) for s in shafts),
        place=np.array([complex(s.up, s.right) for s in shafts]),
        sense=engine.sense,
    )
