"""Where shafts, rods and pistons of a drawn engine stand at crank angles."""

from __future__ import annotations

from fractions import Fraction
from math import lcm
from typing import NamedTuple

import numpy as np

from crankstar.engine import motion
from crankstar.engine.engine import Engine
from crankstar.page.records import Scene
from crankstar.spectra import Complex, Real


class Motion(NamedTuple):
    """Places `up + i right` [cylinder, angle] in the scene's unit; bearings [shaft, angle], rad.

    `rod` is the direction from the big end to the piston pin, of length 1.
    """

    theta: Real
    shaft: Real
    big_end: Complex
    piston: Complex
    rod: Complex


def motion_of(engine: Engine, drawn: Scene, theta: Real) -> Motion:
    """The exact motion of the parts of a scene of this engine at these crank angles, radians."""
    theta = np.atleast_1d(np.asarray(theta, float))
    ratios = np.array([shaft.speed_ratio for shaft in drawn.shafts])
    turned = engine.sense * ratios[:, None] * theta
    links = motion.linkage(engine)
    roots = motion.roots(links.master)
    big_end = np.empty((len(drawn.cylinders), theta.size), complex)
    piston, rod = big_end.copy(), big_end.copy()
    moved: dict[tuple[int, int, int], motion.Rods] = {}
    for row, shown in enumerate(drawn.cylinders):
        axis = engine.cylinders[roots[row]].bearing
        psi = shown.throw_angle + turned[shown.shaft] - axis
        key = (roots[row], shown.shaft, shown.throw)
        if key not in moved:
            moved[key] = motion.rods(links, psi)
        shaft, frame = drawn.shafts[shown.shaft], np.exp(1j * axis)
        home = complex(shaft.up, shaft.right)
        big_end[row] = home + frame * moved[key].big_end.place[row]
        piston[row] = home + frame * moved[key].piston.place[row]
        rod[row] = frame * moved[key].direction.place[row]
    return Motion(theta, turned, big_end, piston, rod)


def turns_of(engine: Engine) -> int:
    """Turns of the first shaft after which every shaft is back where it began.

    >>> from crankstar.files.catalog import load
    >>> turns_of(load("i4"))
    1
    """
    return lcm(*(Fraction(shaft.speed_ratio).denominator for shaft in engine.shafts))
