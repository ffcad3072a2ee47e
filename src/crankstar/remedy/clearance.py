"""Room for balance shafts: what the crank sweeps, and shafts that would be inside one another.

An engine file gives neither webs nor shaft diameters, so both circles are assumed by proportion: a
crank sweeps its greatest throw and, for webs and big ends, `HALF_BORE` bores more; a balance shaft
`SHAFT_BORE` bores. A shaft on the crank axis itself has no place given, and is left out.
"""

from __future__ import annotations

from itertools import combinations
from math import ceil, floor, log10
from typing import NamedTuple

from crankstar.engine.engine import Engine
from crankstar.engine.main_bearings import room
from crankstar.engine.records import Shaft
from crankstar.remedy.clear_places import Circle
from crankstar.remedy.counterweights import BEYOND

HALF_BORE, SHAFT_BORE = 0.45, 0.22
"""Bores: webs and big ends beyond the throw, and the swept radius of a balance shaft."""


class Clash(NamedTuple):
    """Two shafts nearer to each other than what they sweep; lengths as in the engine."""

    first: str
    second: str
    distance: float
    needed: float
    crank: bool


def balance_shafts(engine: Engine) -> tuple[Shaft, ...]:
    """The shafts without throws, but with weights."""
    return tuple(shaft for shaft in engine.shafts if shaft.weights and not shaft.throws)


def bore_of(engine: Engine) -> float:
    """The greatest bore; a square engine where the file gives none."""
    return max(cylinder.bore or 2 * engine.throw(cylinder).radius for cylinder in engine.cylinders)


def crank_sweep(engine: Engine, shaft: Shaft | None = None) -> float:
    """Radius of the circle that a crankshaft, or the greatest of all, is assumed to sweep.

    >>> from crankstar.files.catalog import load
    >>> crank_sweep(load("i4"))  # crank radii, bore as large as the stroke
    1.9
    """
    shafts = engine.shafts if shaft is None else (shaft,)
    return max(throw.radius for each in shafts for throw in each.throws) + (
        HALF_BORE * bore_of(engine)
    )


def raised(length: float) -> float:
    """A length to two figures, never less: what is nearer than it is too near.

    >>> raised(0.0901), raised(0.12)
    (0.091, 0.12)
    """
    step = 10.0 ** (floor(log10(length)) - 1)
    return float(f"{ceil(length / step - 1e-9) * step:.2g}")


def beyond_ends(engine: Engine) -> tuple[tuple[Shaft, float], ...]:
    """The balance shafts with a weight far beyond pins and cylinders, and its place z.

    No such place is refused: a compensator of a ship may stand at the end of its engine room.
    """
    places = [throw.z for shaft in engine.shafts for throw in shaft.throws]
    places += [cylinder.z for cylinder in engine.cylinders]
    far = BEYOND * room(engine)
    out: list[tuple[Shaft, float]] = []
    for shaft in balance_shafts(engine):
        outside = [w.z for w in shaft.weights if not min(places) - far <= w.z <= max(places) + far]
        out += [(shaft, max(outside, key=abs))] if outside else []
    return tuple(out)


def clashes(engine: Engine) -> tuple[Clash, ...]:
    """The balance shafts that lie inside each other or in the circle of a crankshaft.

    >>> from crankstar.files.catalog import load
    >>> from crankstar.remedy import with_balance_shaft
    >>> twin = with_balance_shaft(load("i2-360"), ratio=-1, planes=[0], up=-2.0)
    >>> [(clash.second, round(clash.needed, 2)) for clash in clashes(twin)]
    [('crank', 2.34)]
    """
    placed = [shaft for shaft in balance_shafts(engine) if not _on_a_crank(engine, shaft)]
    own = SHAFT_BORE * bore_of(engine)
    out: list[Clash] = []
    for shaft in placed:
        for crank in engine.shafts:
            if crank.throws:
                needed = crank_sweep(engine, crank) + own
                out += _near(shaft, crank, needed, crank=True)
    for first, second in combinations(placed, 2):
        out += _near(first, second, 2 * own, crank=False)
    return tuple(out)


def circles_of_cranks(engine: Engine) -> tuple[Circle, ...]:
    """The circles in which the axis of a balance shaft would be inside what a crank sweeps."""
    own = SHAFT_BORE * bore_of(engine)
    return tuple(
        Circle(complex(crank.up, crank.right), crank_sweep(engine, crank) + own)
        for crank in engine.shafts
        if crank.throws
    )


def is_clear_of_cranks(engine: Engine, place: complex) -> bool:
    """Whether a balance shaft at a place, up + i right, is outside what every crankshaft sweeps."""
    return all(abs(place - each.centre) >= each.radius for each in circles_of_cranks(engine))


def kept_clear(engine: Engine, name: str) -> tuple[Circle, ...]:
    """The circles in which the axis of a balance shaft would be inside a crank or another shaft.

    What lies on a crank axis itself has no place given.
    """
    own = SHAFT_BORE * bore_of(engine)
    others = [
        Circle(complex(other.up, other.right), 2 * own)
        for other in balance_shafts(engine)
        if other.name != name and not _on_a_crank(engine, other)
    ]
    return (*circles_of_cranks(engine), *others)


def _on_a_crank(engine: Engine, shaft: Shaft) -> bool:
    return any(
        (shaft.up, shaft.right) == (other.up, other.right)
        for other in engine.shafts
        if other.throws
    )


def _near(first: Shaft, second: Shaft, needed: float, *, crank: bool) -> list[Clash]:
    distance = abs(complex(first.up - second.up, first.right - second.right))
    if distance >= needed * (1 - 1e-9):
        return []
    return [Clash(first.name, second.name, distance, needed, crank)]
