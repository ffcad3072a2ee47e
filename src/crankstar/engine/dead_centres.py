"""Top and bottom dead centres of each combustion chamber, from the geometry.

A chamber is at top dead centre where its volume is least: for one piston where the piston is
farthest out, for two that share a chamber where the sum of bore area times outward travel is
greatest. Of two on one axis that move against each other, the second faces the first: its crown is
turned to the crankshaft, and it counts inward.
"""

from __future__ import annotations

from functools import lru_cache
from math import asin, degrees, pi
from typing import NamedTuple

import numpy as np

from crankstar.engine import motion
from crankstar.engine.assembly import Assembly

NEARLY_OUT, AS_FAR = 0.02, 1e-9
"""Shares of the stroke below the highest: of samples near a maximum, and of maxima as high."""
SAME_ANGLE = 1e-6
"""Degrees: dead centres closer than this are simultaneous."""


class DeadCentre(NamedTuple):
    """The top dead centre of a chamber in degrees of the reference shaft, and its period."""

    angle_deg: float
    period_deg: float


def dead_centres(engine: Assembly) -> dict[int, DeadCentre]:
    """Top dead centre of each chamber, degrees of the reference crankshaft, from 0 up."""
    return _dead_centres(engine, outward=1.0)


def bottom_dead_centres(engine: Assembly) -> dict[int, DeadCentre]:
    """Bottom dead centre of each chamber, its greatest volume, degrees of the reference shaft.

    Half a turn after the top only where the axis of a plain rod's cylinder meets the shaft's: for
    an offset e it is at sin psi = -e/(l - r), and the top at e/(l + r).

    >>> from crankstar.engine.basis import Basis, Sizes
    >>> from crankstar.engine.layouts import inline
    >>> sizes = Sizes(stroke=0.08, rod_length=0.12, offset=0.01)
    >>> one = inline(Basis(name="desaxe", cylinder=sizes), throws=(0.0,))
    >>> round(bottom_dead_centres(one)[1].angle_deg, 6)  # 180 + asin(1/8) - asin(1/16) deg
    183.597434
    """
    return _dead_centres(engine, outward=-1.0)


class Pistons(NamedTuple):
    """The pistons of an engine: their rods, and the places of cylinders by number in the arrays.

    `lag` [cylinder] is the angle of the crank from the axis of its group at theta = 0, radians,
    `ratio` [cylinder] its clockwise turns per turn of the reference shaft; `crown` [cylinder] is 1
    where the crown of the piston is turned outward, -1 where it faces another one below.
    """

    links: motion.Linkage
    place: dict[int, int]
    lag: np.ndarray
    ratio: np.ndarray
    crown: np.ndarray


def pistons(engine: Assembly) -> Pistons:
    """What moves the pistons of an engine, as arrays."""
    links = motion.linkage(engine)
    place = {cylinder.number: index for index, cylinder in enumerate(engine.cylinders)}
    root = motion.roots(links.master)
    lag = np.array(
        [
            engine.throw(c).angle - engine.cylinders[root[i]].bearing
            for i, c in enumerate(engine.cylinders)
        ]
    )
    ratio = np.array(
        [float(engine.shaft(c.shaft).speed_ratio) * engine.sense for c in engine.cylinders]
    )
    return Pistons(links, place, lag, ratio, _crowns(engine, links, place, lag, ratio))


ON_AXIS = 1e-9
"""Radians: two cylinders that point the same way."""
FACING = 24
"""Crank angles at which the travel of two pistons is compared."""


def _crowns(
    engine: Assembly,
    links: motion.Linkage,
    place: dict[int, int],
    lag: np.ndarray,
    ratio: np.ndarray,
) -> np.ndarray:
    """-1 of the second of two pistons on one axis that move against each other, 1 of all others.

    On one crankshaft and in a common chamber they compress if they face each other, and hardly if
    they stand side by side.
    """
    out = np.ones(len(engine.cylinders))
    theta = np.arange(FACING) * (2 * np.pi / FACING)
    for members in engine.chambers.values():
        first = place[members[0].number]
        for member in members[1:]:
            other = place[member.number]
            apart = np.exp(1j * (links.bearing[first] - links.bearing[other])) - 1
            if abs(apart) > ON_AXIS or member.shaft != members[0].shaft:
                continue
            one, two = (
                outward(links, [n], theta, lag, ratio, np.ones(lag.size))[0] for n in (first, other)
            )
            if float((one - one.mean()) @ (two - two.mean())) < 0:
                out[other] = -1.0
    return out


def _dead_centres(engine: Assembly, *, outward: float) -> dict[int, DeadCentre]:
    """Where a chamber's pistons are farthest out (outward = 1) or in (-1)."""
    links, place, lag, ratio, crown = pistons(engine)
    bores = np.array([1.0 if c.bore is None else c.bore**2 for c in engine.cylinders])
    area = outward * crown * bores
    chambers = tuple(
        (number, tuple(place[c.number] for c in pistons))
        for number, pistons in engine.chambers.items()
    )
    arrays = (*(getattr(links, name) for name in motion.ARRAYS), lag, ratio, area)
    return dict(
        _kept(links.master, tuple(tuple(map(float, values)) for values in arrays), chambers)
    )


@lru_cache(maxsize=256)
def _kept(
    master: tuple[int, ...],
    arrays: tuple[tuple[float, ...], ...],
    chambers: tuple[tuple[int, tuple[int, ...]], ...],
) -> tuple[tuple[int, DeadCentre], ...]:
    """Dead centres by chamber, cached: firing, strokes, verdict and drawing all need them."""
    *linked, lag, ratio, area = (np.array(values) for values in arrays)
    links = motion.Linkage(master=master, **dict(zip(motion.ARRAYS, linked, strict=True)))
    found = {
        number: _in_line(links, own[0], lag, ratio, area)
        for number, own in chambers
        if len(own) == 1 and _is_in_line(links, own[0])
    }
    left = [(number, list(own)) for number, own in chambers if number not in found]
    if left:
        others = _searched(links, [own for _number, own in left], lag, ratio, area)
        found |= {number: centre for (number, _own), centre in zip(left, others, strict=True)}
    return tuple((number, found[number]) for number, _own in chambers)


def _is_in_line(links: motion.Linkage, piston: int) -> bool:
    """Whether the rod of a piston is on the crank pin and comes in line with the crank twice."""
    room = float(links.rod_length[piston]) - float(links.crank_radius[piston])
    return links.master[piston] < 0 and room > abs(float(links.offset[piston]))


def _in_line(
    links: motion.Linkage, piston: int, lag: np.ndarray, ratio: np.ndarray, area: np.ndarray
) -> DeadCentre:
    """The dead centre of one piston on a crank pin in closed form: rod and crank are in line.

    For an offset e at sin psi = e/(l + r) at the top, at psi = 180 deg + asin(e/(l - r)) at the
    bottom.
    """
    crank, rod, offset = (
        float(values[piston]) for values in (links.crank_radius, links.rod_length, links.offset)
    )
    psi = asin(offset / (rod + crank)) if area[piston] > 0 else pi + asin(offset / (rod - crank))
    return _centre((psi - float(lag[piston])) / float(ratio[piston]), abs(float(ratio[piston])))


def _centre(theta: float, speed: float) -> DeadCentre:
    """The dead centre at theta (radians) of a shaft with a speed relative to the first."""
    turn = 360.0 / speed
    angle = degrees(theta) % turn
    return DeadCentre(0.0 if min(angle, turn - angle) < SAME_ANGLE / 100 else angle, turn)


def _searched(
    links: motion.Linkage,
    chambers: list[list[int]],
    lag: np.ndarray,
    ratio: np.ndarray,
    area: np.ndarray,
) -> list[DeadCentre]:
    """Search a grid over one turn of the pistons' own shaft, then refine by Newton's method.

    All maxima of all chambers at once: each has its own crank angle in a row of samples. Of several
    that are as high, as a mirror makes them, the first is meant.
    """
    parts = np.zeros((len(chambers), len(area)))
    for row, own in zip(parts, chambers, strict=True):
        row[own] = 1.0
    axis = np.exp(1j * links.bearing)[:, None]

    def travelled(theta: np.ndarray, parts: np.ndarray) -> list[np.ndarray]:
        """Bore area times outward travel [row, sample], and two derivatives."""
        moved = motion.rods(links, ratio[:, None] * theta + lag[:, None])
        return [
            parts @ ((area * ratio**power)[:, None] * (path / axis).real)
            for power, path in enumerate(moved.piston)
        ]

    own_speeds = np.array([abs(float(ratio[own[0]])) for own in chambers])
    grid = np.arange(360) * (2 * np.pi / 360)
    starts: list[tuple[int, float]] = []
    lengths = np.zeros(len(chambers))
    for speed in {*own_speeds.tolist()}:
        travel = travelled(grid / speed, parts)[0]
        for chamber in np.flatnonzero(own_speeds == speed).tolist():
            path = travel[chamber]
            lengths[chamber] = float(np.ptp(path))
            high = path >= path.max() - NEARLY_OUT * lengths[chamber]
            top = high & (path > np.roll(path, 1)) & (path >= np.roll(path, -1))
            top[np.argmax(path)] = True
            starts += [(chamber, float(each) / speed) for each in grid[top]]
    whose = np.array([chamber for chamber, _start in starts])
    theta = np.array([start for _chamber, start in starts])
    parts, speeds = parts[whose], own_speeds[whose]
    moving = np.ones(theta.size, bool)
    for _ in range(20):
        _travel, slope, bend = (np.diagonal(part) for part in travelled(theta, parts))
        step = np.divide(-slope, bend, out=np.zeros_like(theta), where=moving & (bend < 0))
        theta += np.clip(step, -0.02 / speeds, 0.02 / speeds)
        moving &= np.abs(step) >= 1e-15
        if not moving.any():
            break
    heights = np.diagonal(travelled(theta, parts)[0])
    found: list[DeadCentre] = []
    for chamber, length in enumerate(lengths.tolist()):
        own = whose == chamber
        farthest = own & (heights >= heights[own].max() - AS_FAR * length)
        turning = float(own_speeds[chamber])
        found.append(min(_centre(each, turning) for each in theta[farthest].tolist()))
    return found


def outward(
    links: motion.Linkage,
    pistons: list[int],
    theta: np.ndarray,
    lag: np.ndarray,
    ratio: np.ndarray,
    area: np.ndarray,
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Bore area times outward travel of a chamber's pistons over theta, and two derivatives."""
    total = [np.zeros_like(theta) for _ in range(3)]
    for index in pistons:
        chain = motion.chain(links.master, index)
        moved = motion.rods(motion.parted(links, chain), ratio[index] * theta + lag[index])
        axis = np.exp(1j * links.bearing[index])
        for power, (target, path) in enumerate(zip(total, moved.piston, strict=True)):
            np.add(target, area[index] * ratio[index] ** power * (path[-1] / axis).real, out=target)
    return total[0], total[1], total[2]
