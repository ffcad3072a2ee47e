"""The volume of each combustion chamber over its working cycle, and its rate, exactly.

With A the bore area of a piston and x its outward travel, both functions of the reference crank
angle theta, the volume of a chamber above its least, and its rate, are

    V(theta) - V_c = sum A x(at top dead centre) - sum A x(theta)        m^3
    V'(theta)      = -sum A x'(theta)                                     m^3/rad

over all pistons of the chamber: one, or two, on any shafts and any rods; A is negative of a piston
whose crown faces inward (`dead_centres.Pistons`).
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from math import pi, radians

import numpy as np

from crankstar.engine.assembly import Assembly
from crankstar.engine.dead_centres import (
    Pistons,
    bottom_dead_centres,
    dead_centres,
    outward,
    pistons,
)
from crankstar.engine.firing_angles import firing_angles
from crankstar.spectra import Real


@dataclass(frozen=True)
class Volumes:
    """The chambers of an engine over one working cycle, from the dead centre at which each fires.

    `numbers` [chamber], `fires` [chamber] (crank angle, radians), `kind` [chamber], the row of the
    chamber in `above` [kind, sample] (m^3 above the least volume), `rate` [kind, sample] (m^3/rad)
    and `swept` [kind] (m^3), the greatest of them, at `bottom` [kind], radians. `cycle` is the
    length of a cycle, radians of the reference shaft.
    """

    numbers: tuple[int, ...]
    fires: Real
    kind: tuple[int, ...]
    above: Real
    rate: Real
    swept: Real
    bottom: Real
    cycle: float


def volumes(engine: Assembly, count: int) -> Volumes:
    """The chambers at `count` equal steps of a cycle. The bores must be known.

    >>> from crankstar.files.catalog import load
    >>> found = volumes(load("audi-25-tfsi"), 720)
    >>> len(found.numbers), len(found.swept), round(float(found.swept[0]) * 1e6, 1)
    (5, 1, 496.1)
    """
    cycle = radians(engine.cycle_angle)
    centres = dead_centres(engine)
    fires = dict(zip(engine.firing_order, np.radians(firing_angles(engine)), strict=True))
    numbers = tuple(engine.chambers)
    if len(numbers) == 1 and not fires:
        fires = {numbers[0]: radians(centres[numbers[0]].angle_deg)}
    bottoms = bottom_dead_centres(engine)
    moving = pistons(engine)
    links, place, lag, ratio, _crown = moving
    area = crown_areas(engine, moving)
    step = np.arange(count) * (cycle / count)
    rows: dict[object, int] = {}
    kind: list[int] = []
    above: list[Real] = []
    rate: list[Real] = []
    swept: list[float] = []
    bottom: list[float] = []
    for number in numbers:
        own = [place[cylinder.number] for cylinder in engine.chambers[number]]
        first = own[0]
        plain = len(own) == 1 and links.master[first] < 0
        key: object = number
        if plain:  # chambers alike move alike
            sizes = (links.crank_radius, links.rod_length, area, ratio)
            key = (*(float(each[first]) for each in sizes), float(links.offset[first]))
        if key not in rows:
            rows[key] = len(above)
            top, low = centres[number], bottoms[number]
            after = radians((low.angle_deg - top.angle_deg) % top.period_deg)
            theta = np.append(step, [0.0, after]) + radians(top.angle_deg)
            travel, slope, _bend = outward(links, own, theta, lag, ratio, area)
            above.append(travel[-2] - travel[:-2])
            rate.append(-slope[:-2])
            swept.append(float(travel[-2] - travel[-1]))
            bottom.append(after)
        kind.append(rows[key])
    return Volumes(
        numbers,
        np.array([fires[number] for number in numbers]),
        tuple(kind),
        np.array(above),
        np.array(rate),
        np.array(swept),
        np.array(bottom),
        cycle,
    )


def crown_areas(engine: Assembly, moving: Pistons) -> Real:
    """The area of each crown, m^2 [cylinder], negative where it faces inward; 0 without a bore."""
    bores = np.array([cylinder.bore or 0.0 for cylinder in engine.cylinders])
    return moving.crown * pi / 4 * bores**2


@lru_cache(maxsize=16)
def piston_rates(engine: Assembly, count: int) -> Real:
    """The share of each piston in V' [cylinder, sample], m^3/rad; its chamber's are their sum.

    At `count` equal steps of a cycle from the dead centre of its chamber; not to be written to.

    >>> from crankstar.files.catalog import load
    >>> shares = piston_rates(load("jumo-205"), 720)[[0, 6]]  # both pistons of chamber 1
    >>> bool(np.allclose(shares.sum(axis=0), volumes(load("jumo-205"), 720).rate[0], atol=1e-9))
    True
    """
    centres = dead_centres(engine)
    moving = pistons(engine)
    links, place, lag, ratio, _crown = moving
    area = crown_areas(engine, moving)
    step = np.arange(count) * (radians(engine.cycle_angle) / count)
    rates = np.zeros((len(engine.cylinders), count))
    for number, own in engine.chambers.items():
        theta = step + radians(centres[number].angle_deg)
        for cylinder in own:
            index = place[cylinder.number]
            rates[index] = -outward(links, [index], theta, lag, ratio, area)[1]
    rates.setflags(write=False)
    return rates
