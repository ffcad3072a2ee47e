"""When each combustion chamber can fire: dead centres from the geometry, firing angles and intervals from the order.

A chamber fires at a top dead centre, where its volume is least: for one piston where the piston is farthest out, for
two that share a chamber where the sum of bore area times outward travel is greatest. In one cycle (one turn of a
two-stroke engine, two of a four-stroke one) each fires once. A firing order fits when such dead centres can be found
one after the other within one cycle; where there is a choice, the most even intervals are taken.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from itertools import pairwise
from math import asin, degrees, inf, pi
from typing import NamedTuple

import numpy as np

from crankstar import motion
from crankstar.engine import Engine
from crankstar.fault import EngineError, Fault
from crankstar.records import Cylinder

SAME_ANGLE = 1e-6
"""Degrees: dead centres closer than this are simultaneous."""
ANGLE_TOLERANCE = 1.0
"""Degrees by which a firing angle written in a file may miss the dead centre it names."""


class DeadCentre(NamedTuple):
    """The top dead centre of a chamber: crank angle in degrees of the reference shaft, and how often it comes round."""

    angle_deg: float
    period_deg: float


@dataclass(frozen=True)
class Firing:
    """The chambers in firing order, the crank angle of each firing (degrees, ascending), and the interval to the next."""

    order: tuple[int, ...]
    angles_deg: tuple[float, ...]
    intervals_deg: tuple[float, ...]
    cycle_deg: float

    @property
    def even(self) -> bool:
        """Whether all intervals are equal, to a thousandth of a degree."""
        return max(self.intervals_deg) - min(self.intervals_deg) < 1e-3


def dead_centres(engine: Engine) -> dict[int, DeadCentre]:
    """Top dead centre of each combustion chamber, in degrees of the reference crankshaft from 0 up to its period."""
    return _dead_centres(engine, outward=1.0)


def bottom_dead_centres(engine: Engine) -> dict[int, DeadCentre]:
    """Bottom dead centre of each combustion chamber, where its volume is greatest, in the same degrees.

    Half a turn after the top only where the axis of a plain rod's cylinder meets the shaft's: for an offset e it is at
    sin psi = -e/(l - r), and the top at e/(l + r).

    >>> from crankstar.arrangement import Basis, Sizes
    >>> from crankstar.layouts import inline
    >>> one = inline(Basis(name="desaxe", cylinder=Sizes(stroke=0.08, rod_length=0.12, offset=0.01)), throws=(0.0,))
    >>> round(bottom_dead_centres(one)[1].angle_deg, 6)  # 180 + asin(1/8) - asin(1/16) deg
    183.597434
    """
    return _dead_centres(engine, outward=-1.0)


def _dead_centres(engine: Engine, *, outward: float) -> dict[int, DeadCentre]:
    """Where a chamber's pistons are farthest out (outward = 1) or in (-1)."""
    links = motion.linkage(engine)
    place = {cylinder.number: index for index, cylinder in enumerate(engine.cylinders)}
    root = motion.roots(links.master)
    lag = np.array([engine.throw(c).angle - engine.cylinders[root[i]].bearing for i, c in enumerate(engine.cylinders)])
    ratio = np.array([float(engine.shaft(c.shaft).speed_ratio) * engine.sense for c in engine.cylinders])
    area = outward * np.array([1.0 if c.bore is None else c.bore**2 for c in engine.cylinders])
    chambers = tuple((number, tuple(place[c.number] for c in pistons)) for number, pistons in engine.chambers.items())
    arrays = (*(getattr(links, name) for name in motion.ARRAYS), lag, ratio, area)
    return dict(_kept(links.master, tuple(tuple(map(float, values)) for values in arrays), chambers))


@lru_cache(maxsize=256)
def _kept(
    master: tuple[int, ...], arrays: tuple[tuple[float, ...], ...], chambers: tuple[tuple[int, tuple[int, ...]], ...]
) -> tuple[tuple[int, DeadCentre], ...]:
    """Dead centres by chamber: found once for an engine, of which firing, strokes, verdict and drawing all ask them."""
    *linked, lag, ratio, area = (np.array(values) for values in arrays)
    links = motion.Linkage(master=master, **dict(zip(motion.ARRAYS, linked, strict=True)))
    return tuple((number, _dead_centre(links, list(pistons), lag, ratio, area)) for number, pistons in chambers)


def _dead_centre(links: motion.Linkage, pistons: list[int], lag: np.ndarray, ratio: np.ndarray, area: np.ndarray) -> DeadCentre:
    """Where rod and crank lie in line, for one piston on a crank pin; else searched for.

    For an offset e that is at sin psi = e/(l + r) at the top, at psi = 180 deg + asin(e/(l - r)) at the bottom.
    """
    first = pistons[0]
    crank, rod, offset = (float(values[first]) for values in (links.crank_radius, links.rod_length, links.offset))
    if len(pistons) > 1 or links.master[first] >= 0 or rod - crank <= abs(offset):
        return _searched(links, pistons, lag, ratio, area)
    psi = asin(offset / (rod + crank)) if area[first] > 0 else pi + asin(offset / (rod - crank))
    return _centre((psi - float(lag[first])) / float(ratio[first]), abs(float(ratio[first])))


def _centre(theta: float, speed: float) -> DeadCentre:
    """The dead centre at theta (radians) of a shaft that turns so many times as fast as the first."""
    turn = 360.0 / speed
    angle = degrees(theta) % turn
    return DeadCentre(0.0 if min(angle, turn - angle) < SAME_ANGLE / 100 else angle, turn)


def _searched(links: motion.Linkage, pistons: list[int], lag: np.ndarray, ratio: np.ndarray, area: np.ndarray) -> DeadCentre:
    """Search a grid over one turn of the pistons' own shaft, then Newton's method on the outward travel's derivative."""
    speed = abs(float(ratio[pistons[0]]))
    grid = np.arange(360) * (2 * np.pi / 360)
    travel, _, _ = _outward(links, pistons, grid / speed, lag, ratio, area)
    theta = float(grid[np.argmax(travel)]) / speed
    for _ in range(20):
        _, slope, bend = (float(part[0]) for part in _outward(links, pistons, np.array([theta]), lag, ratio, area))
        step = -slope / bend if bend < 0 else 0.0
        theta += float(np.clip(step, -0.02 / speed, 0.02 / speed))
        if abs(step) < 1e-15:
            break
    return _centre(theta, speed)


def _outward(
    links: motion.Linkage, pistons: list[int], theta: np.ndarray, lag: np.ndarray, ratio: np.ndarray, area: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Bore area times outward travel of a chamber's pistons over theta, with its first two derivatives."""
    total = [np.zeros_like(theta) for _ in range(3)]
    for index in pistons:
        chain = motion.chain(links, index)
        moved = motion.rods(motion.parted(links, chain), ratio[index] * theta + lag[index])
        axis = np.exp(1j * links.bearing[index])
        for power, (target, path) in enumerate(zip(total, moved.piston, strict=True)):
            np.add(target, area[index] * ratio[index] ** power * (path[-1] / axis).real, out=target)
    return total[0], total[1], total[2]


def firing(engine: Engine) -> Firing:
    """When each chamber fires. Raises EngineError, with the table of dead centres, where the order does not fit."""
    faults, angles = _fired(engine)
    if faults:
        raise EngineError(faults)
    if not angles:
        return Firing((), (), (), engine.cycle_angle)
    following = [*angles[1:], angles[0] + engine.cycle_angle]
    intervals = tuple(round(b - a, 9) for a, b in zip(angles, following, strict=True))
    return Firing(engine.firing_order, tuple(angles), intervals, engine.cycle_angle)


def unfit(engine: Engine) -> list[Fault]:
    """Why the firing order cannot be: empty if it can (or if there is none)."""
    return _fired(engine)[0]


def _fired(engine: Engine) -> tuple[list[Fault], list[float]]:
    """Why the firing order cannot be, and if it can the angles at which it fires."""
    if not engine.firing_order:
        return [], []
    centres = dead_centres(engine)
    if engine.firing_angles:
        faults = _wrong_angles(engine, centres)
        return faults, [] if faults else _given_angles(engine)
    angles = _evenest(engine.firing_order, centres, engine.cycle_angle)
    return ([], angles) if angles is not None else ([_unfit(engine, centres)], [])


def _unfit(engine: Engine, centres: dict[int, DeadCentre]) -> Fault:
    """Why the order of an engine cannot be, with its dead centres."""
    order = "-".join(map(str, engine.firing_order))
    table = ", ".join(f"{number} at {centre.angle_deg:.4g}" for number, centre in sorted(centres.items()))
    message = (
        f"is {order}, which this geometry cannot fire in one cycle of {engine.cycle_angle:.0f} deg. "
        f"Top dead centres, in degrees of crank angle: {table}. " + _hint(engine, centres)
    )
    return Fault(("firing_order",), message)


def _hint(engine: Engine, centres: dict[int, DeadCentre]) -> str:
    """What would make the order fit: the banks or the rotation mirrored, or a firing angle for those that coincide."""

    def fits(other: dict[int, DeadCentre]) -> bool:
        return _evenest(engine.firing_order, other, engine.cycle_angle) is not None

    found: list[str] = []
    if len({round(c.bearing, 9) for c in engine.cylinders}) > 1 and fits(dead_centres(with_banks_mirrored(engine))):
        sides = "; ".join(
            f"{', '.join(map(str, numbers))} at bearing {-np.degrees(_bearing(engine, numbers[0])):+.4g} deg"
            for numbers in engine.banks.values()
        )
        found.append(f"with the banks on the other sides ({sides}: 'left' may be the driver's, not the viewer's)")
    mirrored = with_rotation_reversed(engine)
    if fits(dead_centres(mirrored)):
        found.append(f'with the crankshaft turning the other way (rotation = "{mirrored.rotation}")')
    if found:
        return "It would fit " + ", or ".join(found) + "."
    together = _simultaneous(centres, engine.cycle_angle)
    if together:
        return f"Cylinders {together} are at dead centre together; if they are meant to fire together, say so with firing_angles."
    return "Check the order, the throws and the bearings."


def _bearing(engine: Engine, number: int) -> float:
    return next(c.bearing for c in engine.cylinders if c.number == number) or 0.0


def _simultaneous(centres: dict[int, DeadCentre], cycle: float) -> str:
    """Chambers that share a dead centre more often than the cycle has turns to part them."""
    by_angle: dict[int, list[int]] = {}
    for number, centre in centres.items():
        by_angle.setdefault(round(centre.angle_deg * 1000), []).append(number)
    crowded = [numbers for numbers in by_angle.values() if len(numbers) > cycle / centres[numbers[0]].period_deg + 1e-9]
    return "; ".join(" and ".join(map(str, sorted(numbers))) for numbers in crowded)


def with_banks_mirrored(engine: Engine) -> Engine:
    """The engine with every bank on the other side and the crank turned so that the first cylinder keeps its dead centre."""
    turn = -2 * engine.first.bearing
    shafts = tuple(
        shaft.model_copy(update={"throws": tuple(t.model_copy(update={"angle": t.angle + turn}) for t in shaft.throws)})
        for shaft in engine.shafts
    )
    return engine.model_copy(update={"shafts": shafts, "cylinders": tuple(_in_the_mirror(c) for c in engine.cylinders)})


def _in_the_mirror(cylinder: Cylinder) -> Cylinder:
    """A cylinder on the other side, its offset and its knuckle pin with it."""
    link = cylinder.articulated
    knuckle = None if link is None else link.model_copy(update={"angle": -link.angle})
    return cylinder.model_copy(update={"bearing": -cylinder.bearing, "offset": -cylinder.offset, "articulated": knuckle})


def with_rotation_reversed(engine: Engine) -> Engine:
    """The same engine turning the other way."""
    other = "counter-clockwise" if engine.rotation == "clockwise" else "clockwise"
    return engine.model_copy(update={"rotation": other})


def _evenest(order: tuple[int, ...], centres: dict[int, DeadCentre], cycle: float) -> list[float] | None:
    """Firing angles for an order, strictly ascending within a cycle, with the least sum of squared intervals; or None.

    Dynamic programming over which of its dead centres in the cycle each chamber fires at.
    """
    if not order:
        return []
    first = centres[order[0]].angle_deg
    reached, cost = np.array([first]), np.zeros(1)
    steps: list[tuple[np.ndarray, np.ndarray]] = []
    for number in order[1:]:
        centre = centres[number]
        start = centre.angle_deg + centre.period_deg * np.ceil((first - centre.angle_deg) / centre.period_deg - 1e-12)
        choices = np.arange(start, first + cycle - SAME_ANGLE, centre.period_deg)
        interval = choices[:, None] - reached
        costs = np.where(interval > SAME_ANGLE, cost + interval**2, inf)
        possible = np.isfinite(costs).any(axis=1)
        if not possible.any():
            return None
        steps.append((reached, costs[possible].argmin(axis=1)))
        reached, cost = choices[possible], costs[possible].min(axis=1)
    at = int(np.argmin(cost + (first + cycle - reached) ** 2))
    angles = [float(reached[at])]
    for before, came_from in reversed(steps):
        at = int(came_from[at])
        angles.insert(0, float(before[at]))
    return angles


def _given_angles(engine: Engine) -> list[float]:
    """The firing angles of the file, moved onto the dead centres they name."""
    centres = dead_centres(engine)
    angles: list[float] = []
    for number, given in zip(engine.firing_order, np.degrees(engine.firing_angles or ()), strict=True):
        centre = centres[number]
        turns = round((float(given) - centre.angle_deg) / centre.period_deg)
        angles.append(centre.angle_deg + turns * centre.period_deg)
    return angles


def _wrong_angles(engine: Engine, centres: dict[int, DeadCentre]) -> list[Fault]:
    faults: list[Fault] = []
    given = [float(angle) for angle in np.degrees(engine.firing_angles or ())]
    for index, (number, written, exact) in enumerate(zip(engine.firing_order, given, _given_angles(engine), strict=True)):
        if abs(written - exact) > ANGLE_TOLERANCE:
            centre = centres[number]
            faults.append(
                Fault(
                    ("firing_angles", index),
                    f"is {written:.6g} deg; cylinder {number} is at top dead centre at {centre.angle_deg:.6g} deg "
                    f"and every {centre.period_deg:.4g} deg from there, {exact:.6g} deg is the nearest",
                )
            )
    exact = _given_angles(engine)
    falling = any(later < earlier - SAME_ANGLE for earlier, later in pairwise(exact))
    if not faults and (falling or exact[-1] - exact[0] >= engine.cycle_angle - SAME_ANGLE):
        told = (
            f"is not in order; the angles must ascend within one cycle of {engine.cycle_angle:.0f} deg, as firing_order lists them"
        )
        faults.append(Fault(("firing_angles",), told))
    return faults
