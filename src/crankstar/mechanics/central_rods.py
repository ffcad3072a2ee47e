"""Rods of one crankpin in one plane: at most two can be there, one forked about the other.

Where more turn about one pin, one of them is a master rod and carries the knuckle pins of the
others, which changes the force of the second order and the firing intervals.
"""

from __future__ import annotations

from collections.abc import Iterator
from math import pi

from crankstar.engine.copies import wrapped
from crankstar.engine.engine import Engine
from crankstar.engine.records import Cylinder
from crankstar.language.faults import Fault

FORK_AND_BLADE = 2
"""Rods that can turn about one crankpin in one plane."""
KNUCKLES = (0.7, 0.9)
"""Knuckle radius of radial engines in crank radii: our judgement, of drawings.

The radial engines of the catalog have 0.8 and 0.82, orders of size both.
"""


def abreast(engine: Engine) -> list[list[Cylinder]]:
    """The cylinders whose rods, none on a knuckle pin, are on one crankpin in one plane.

    >>> from crankstar.files.catalog import load
    >>> [len(rods) for rods in abreast(load("i4"))], [len(rods) for rods in abreast(load("v2-90"))]
    ([1, 1, 1, 1], [2])
    """
    on: dict[tuple[str, int, float], list[Cylinder]] = {}
    for cylinder in engine.cylinders:
        if cylinder.articulated is None:
            on.setdefault((cylinder.shaft, cylinder.throw, cylinder.z), []).append(cylinder)
    return [*on.values()]


def central_rods(engine: Engine) -> list[list[Cylinder]]:
    """Those of `abreast` that are more than can be there.

    >>> from crankstar.files.catalog import load
    >>> star = load("radial-9", changes={"layout.knuckle_radius": None})
    >>> [len(rods) for rods in central_rods(star)], central_rods(load("radial-9"))
    ([9], [])
    """
    return [rods for rods in abreast(engine) if len(rods) > FORK_AND_BLADE]


def middle_rod(rods: list[Cylinder]) -> Cylinder:
    """That of the cylinder in the middle of the others, seen from the crankpin; else the first.

    >>> from crankstar.files.catalog import load
    >>> [middle_rod(rods).bank for rods in central_rods(load("napier-lion"))][:1]
    ['middle']
    """

    def reach(own: Cylinder) -> float:
        return max(abs((each.bearing - own.bearing + pi) % (2 * pi) - pi) for each in rods)

    return min(rods, key=lambda own: round(reach(own), 6))


def knuckle_angle(master: Cylinder, slave: Cylinder) -> float:
    """From the master rod to the knuckle pin as far as the cylinders are turned, radians.

    >>> from crankstar.files.catalog import load
    >>> first, second, *_others = load("radial-9").cylinders
    >>> round(knuckle_angle(first, second) * 180 / pi, 6)
    40.0
    """
    return wrapped(slave.bearing - master.bearing)


def central_doubts(engine: Engine) -> Iterator[Fault]:
    """More rods on one crankpin in one plane than can be there.

    >>> from crankstar.files.catalog import load
    >>> star = load("radial-9", changes={"layout.knuckle_radius": None})
    >>> [(fault.code, fault.values["count"]) for fault in central_doubts(star)]
    [('doubt.central-rods', 9)]
    """
    found = central_rods(engine)
    if found:
        values = {"count": max(map(len, found)), "low": KNUCKLES[0], "high": KNUCKLES[1]}
        yield Fault(("layout", "knuckle_radius"), "doubt.central-rods", values)
