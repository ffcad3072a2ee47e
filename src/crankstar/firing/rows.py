"""Crankshafts of one row of cylinders that fire evenly: the customary one, and better ones.

The pins of n cylinders stand on the rays of a star: n rays in a two-stroke engine and where n is
odd, n/2 with two pins each in a four-stroke engine of an even n. Where two pins share a ray they
stand as far from the middle as each other, so that nothing of any order rocks the engine. On a star
of n rays the couples of orders 1 and 2 depend on which pin has which ray:

    M_k = |sum of z_p exp(i k a_p)| m r w^2 a A_k,

z_p the place of pin p from the middle in bore pitches, a_p its ray.
"""

from __future__ import annotations

from functools import cache
from itertools import permutations
from math import pi
from typing import NamedTuple

import numpy as np

from crankstar.engine.quantities import Cycle
from crankstar.spectra import Real

CUSTOMARY: dict[tuple[Cycle, int], tuple[int, ...]] = {
    ("four-stroke", 3): (1, 3, 2),
    ("four-stroke", 4): (1, 3, 4, 2),
    ("four-stroke", 5): (1, 2, 4, 5, 3),
    ("four-stroke", 6): (1, 5, 3, 6, 2, 4),
    ("four-stroke", 8): (1, 6, 2, 5, 8, 3, 7, 4),
    ("two-stroke", 3): (1, 3, 2),
    ("two-stroke", 4): (1, 3, 2, 4),
    ("two-stroke", 5): (1, 4, 3, 2, 5),
    ("two-stroke", 6): (1, 5, 3, 4, 2, 6),
    ("two-stroke", 7): (1, 7, 2, 5, 4, 3, 6),
    ("two-stroke", 8): (1, 8, 2, 6, 4, 5, 3, 7),
}
"""Firing orders that engines of one row usually have (general knowledge)."""
UNEVEN: dict[int, tuple[tuple[float, ...], ...]] = {
    2: ((0.0, 180.0), (0.0, 90.0)),
    4: ((0.0, 90.0, -90.0, 180.0),),
}
"""Pins, degrees from pin 1, of four-stroke engines that are built though they fire unevenly."""
ALL_STARS = 8
"""Rays up to which every star is tried; beyond, those of firing orders that step regularly."""
DIGITS = 9


class RowCrank(NamedTuple):
    """Pins of a row from front to rear, degrees clockwise from pin 1, and their couples.

    `couples`: of orders 1 and 2, in m r w^2 a A_k.
    """

    throws_deg: tuple[float, ...]
    couples: tuple[float, float]


@cache
def row_cranks(*, cylinders: int, cycle: Cycle, most: int = 4) -> tuple[RowCrank, ...]:
    """Crankshafts that fire evenly, the customary one first, then by what they leave.

    Of cranks that leave alike couples, mirror images included, one is listed; at most `most`.
    They are those of an engine that turns clockwise; mirrored, of one that turns the other way.

    >>> [crank.throws_deg for crank in row_cranks(cylinders=4, cycle="four-stroke")]
    [(0.0, 180.0, 180.0, 0.0)]
    >>> best = row_cranks(cylinders=5, cycle="four-stroke")
    >>> [round(couple, 3) for couple in best[0].couples]
    [0.449, 4.98]
    """
    if cycle == "four-stroke" and cylinders % 2 == 0:
        stars = _mirrored(cylinders)
    else:
        stars = _stars(cylinders)
    usual = CUSTOMARY.get((cycle, cylinders))
    if usual:
        stars = np.vstack([_star_of(usual, cycle), stars])
    moments = np.round(couples(stars * 2 * pi / _rays(cylinders, cycle)), DIGITS)
    others = np.lexsort((moments[:, 1], moments[:, 0]))
    places = [0, *(place for place in others if place)] if usual else list(others)
    listed: dict[tuple[float, ...], RowCrank] = {}
    for place in places:
        key = (float(moments[place, 0]), float(moments[place, 1]))
        angles = stars[place] * 360.0 / _rays(cylinders, cycle)
        listed.setdefault(key, RowCrank(tuple(map(_turn, angles.tolist())), key))
    return tuple(listed.values())[:most]


def couples(angles: Real) -> Real:
    """The couples of orders 1 and 2 [star, 2] of pins at these angles [star, pin], radians."""
    pins = angles.shape[1]
    z = (pins - 1) / 2 - np.arange(pins)
    return np.abs(np.exp(1j * angles[:, :, None] * np.array([1, 2])).transpose(0, 2, 1) @ z)


def _rays(cylinders: int, cycle: Cycle) -> int:
    return cylinders // 2 if cycle == "four-stroke" and cylinders % 2 == 0 else cylinders


def _turn(degrees: float) -> float:
    """An angle from above -180 to 180 degrees."""
    return float(round(degrees - 360.0 * np.ceil((degrees - 180.0) / 360.0), 9) + 0.0)


def _star_of(order: tuple[int, ...], cycle: Cycle) -> Real:
    """The rays [1, pin] of the crank that reaches its dead centres in this order."""
    rays = _rays(len(order), cycle)
    turns = {"two-stroke": 1, "four-stroke": 2}[cycle]
    step = turns * rays / len(order)
    places = {number: (-step * index) % rays for index, number in enumerate(order)}
    return np.array([[(places[number] - places[1]) % rays for number in sorted(places)]])


def _mirrored(cylinders: int) -> Real:
    """Stars whose rear half is the mirror image of the front one, by the couple of a half."""
    halves = _stars(cylinders // 2)
    inner = np.round(couples(halves * 2 * pi / max(1, cylinders // 2))[:, 0], DIGITS)
    halves = halves[np.argsort(inner, kind="stable")]
    return np.hstack([halves, halves[:, ::-1]])


def _stars(rays: int) -> Real:
    """Rays [star, pin] of stars with one pin on each ray, pin 1 on the first."""
    if rays <= ALL_STARS:
        rows = [(0, *rest) for rest in permutations(range(1, rays))]
        return np.array(rows, float).reshape(len(rows), rays)
    pins = np.arange(rays)
    regular = [pins * step % rays for step in range(1, rays) if np.gcd(step, rays) == 1]
    return np.vstack([_swapped(np.array(star, float), rays) for star in regular])


def _swapped(star: Real, rays: int) -> Real:
    """The star [1, pin] after swapping rays of two pins as long as that lessens its couples."""
    best, least = star, _left(star[None], rays)[0]
    while True:
        tries = np.array([_exchanged(best, a, b) for a in range(1, rays) for b in range(a)])
        left = _left(tries, rays)
        place = int(np.argmin(left))
        if left[place] >= least - 1e-9:
            return ((best - best[0]) % rays)[None]
        best, least = tries[place], left[place]


def _exchanged(star: Real, a: int, b: int) -> Real:
    other = star.copy()
    other[[a, b]] = other[[b, a]]
    return other


def _left(stars: Real, rays: int) -> Real:
    """What the couples of both orders leave [star], the second a quarter as large by its rods."""
    return couples(stars * 2 * pi / rays) @ np.array([1.0, 0.25])
