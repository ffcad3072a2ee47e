"""Side thrust: how hard each piston presses on its cylinder wall over a working cycle.

Gas pushes a piston inward along its cylinder axis with (p - p_0) A; piston, rod and wall are in
equilibrium as in `pin_loads`, by the same equations: for a plain rod at the angle phi to the axis

    N_gas = (p - p_0) A tan(phi)                        N

and the inertia forces of piston and rod add to it with the square of the speed. Positive is towards
the thrust side, to which gas presses during expansion: the left of a cylinder that stands up,
where the crankshaft turns clockwise as seen from the front; negative is the other side.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from crankstar import spectra
from crankstar.engine import motion
from crankstar.engine.dead_centres import pistons
from crankstar.engine.engine import Engine
from crankstar.engine.volumes import crown_areas
from crankstar.mechanics.gas import Cycle
from crankstar.mechanics.kinetic import samples_over
from crankstar.mechanics.maxima import refined
from crankstar.mechanics.mechanism import mechanism
from crankstar.mechanics.pin_loads import Applied, guides, pin_loads
from crankstar.spectra import Complex, Real

SAMPLES = 720
JUMP = 1e-3
"""Share of the peak pressure: a third difference of samples beyond it is a jump. That of a smooth
pressure is a thousandth of it, that of a kink a tenth."""


@dataclass(frozen=True)
class SideThrust:
    """Side thrust [cylinder, angle] on each wall, N, at crank angles `theta`, radians.

    `inertia` is None without speed or masses.

    >>> from crankstar import cycle, load
    >>> five = load("audi-25-tfsi")
    >>> found = side_thrust(five, cycle(five, speed="3000 rpm", imep="9 bar"))
    >>> found.numbers, found.total.shape
    ((1, 2, 3, 4, 5), (5, 720))
    """

    numbers: tuple[int, ...]
    theta: Real
    gas: Real
    inertia: Real | None

    @property
    def total(self) -> Real:
        """Of gas and inertia together."""
        return self.gas if self.inertia is None else self.gas + self.inertia


def side_thrust(engine: Engine, cycle: Cycle, *, samples: int = SAMPLES) -> SideThrust:
    """The side thrust of every piston over a working cycle of the reference crankshaft.

    A centred piston at top dead centre has its rod in line, and no side thrust; on its way down it
    presses to the thrust side:

    >>> from crankstar.files.catalog import load
    >>> from crankstar.mechanics.gas import cycle
    >>> engine = load("audi-25-tfsi")
    >>> found = side_thrust(engine, cycle(engine))
    >>> bool(abs(found.gas[0, 0]) < 1e-6), bool(found.gas[0, 30] > 1000)
    (True, True)
    """
    return _pressing(engine, cycle)(samples_over(engine, samples))


def greatest_side_thrust(engine: Engine, cycle: Cycle) -> SideThrust:
    """The same over a cycle, from its start to its end, with the angles at which it is greatest.

    >>> from crankstar.files.catalog import load
    >>> from crankstar.mechanics.gas import cycle
    >>> engine = load("audi-25-tfsi")
    >>> one, fine = greatest_side_thrust(engine, cycle(engine)), cycle(engine)
    >>> dense = side_thrust(engine, fine, samples=36000).total.max()
    >>> bool(abs(one.total.max() / dense - 1) < 1e-6)
    True
    """
    theta = np.append(samples_over(engine, SAMPLES), cycle.volumes.cycle)

    def both_sides(found: SideThrust) -> Real:
        whole = found.total.T
        return np.maximum(np.hstack([whole, -whole]), 0.0)

    at = _pressing(engine, cycle)
    return refined(theta, at(theta), at=at, joined=_joined, curves=both_sides)


def _pressing(engine: Engine, cycle: Cycle) -> Callable[[Real], SideThrust]:
    """The side thrust at any crank angles; what does not depend on them is found once."""
    ratio, numbers = pistons(engine).ratio, tuple(each.number for each in engine.cylinders)
    axis = np.exp(1j * np.array([cylinder.bearing for cylinder in engine.cylinders]))[:, None]
    speed, guide = cycle.speed, None
    if speed is not None and {"mass", "radius"}.isdisjoint(engine.relative):
        guide = pin_loads(mechanism(engine)).guide

    def at(theta: Real) -> SideThrust:
        inertia = None
        if guide is not None and speed is not None:
            inertia = spectra.value(guide, theta) * speed**2 / axis
        return SideThrust(
            numbers,
            theta,
            _of_gas(engine, cycle, theta),
            None if inertia is None else _to_thrust_side(inertia, ratio),
        )

    return at


def _joined(one: SideThrust, two: SideThrust) -> SideThrust:
    """Both by ascending angle."""
    theta = np.concatenate([one.theta, two.theta])
    order = np.argsort(theta, kind="stable")
    inertia = None
    if one.inertia is not None and two.inertia is not None:
        inertia = np.hstack([one.inertia, two.inertia])[:, order]
    return SideThrust(one.numbers, theta[order], np.hstack([one.gas, two.gas])[:, order], inertia)


def pressure_at(cycle: Cycle, theta: Real) -> Real:
    """The pressure of each chamber at angles of the reference crankshaft, Pa [chamber, angle].

    Between two samples the cubic through them and their neighbours; straight beside a jump, as
    ideal cycles have it.

    >>> from crankstar import cycle, load
    >>> found = cycle(load("audi-25-tfsi"))
    >>> fires = found.volumes.fires[1]
    >>> bool(np.isclose(pressure_at(found, np.array([fires]))[1, 0], found.pressure[1, 0]))
    True
    """
    count = cycle.pressure.shape[-1]
    place = np.asarray(theta) - cycle.volumes.fires[:, None]
    place = place % cycle.volumes.cycle * (count / cycle.volumes.cycle)
    low = np.floor(place).astype(int)
    part = place - low
    before, one, two, after = (
        np.take_along_axis(cycle.pressure, (low + step) % count, axis=-1) for step in (-1, 0, 1, 2)
    )
    bend, next_bend = before - 2 * one + two, one - 2 * two + after
    curved = part * (1 - part) / 6 * ((2 - part) * bend + (1 + part) * next_bend)
    jumps = np.abs(next_bend - bend) > JUMP * cycle.peak
    return one + part * (two - one) - np.where(jumps, 0.0, curved)


def _of_gas(engine: Engine, cycle: Cycle, theta: Real) -> Real:
    moving = pistons(engine)
    links, ratio = moving.links, moving.ratio
    along = np.exp(1j * np.asarray(links.bearing))[:, None]
    return _to_thrust_side(gas_guides(engine, cycle, theta) / along, ratio)


def gas_push(engine: Engine, cycle: Cycle, theta: Real) -> Real:
    """(p - p_0) A inward of each piston at angles of the reference crankshaft, N [cylinder, angle].

    Negative of a piston whose crown faces inward.
    """
    moving = pistons(engine)
    areas = crown_areas(engine, moving)
    pressures = dict(zip(cycle.volumes.numbers, pressure_at(cycle, theta), strict=True))
    push = np.zeros((areas.size, theta.size))
    for number, members in engine.chambers.items():
        for cylinder in members:
            row = moving.place[cylinder.number]
            push[row] = (pressures[number] - cycle.crankcase) * areas[row]
    return push


def gas_guides(engine: Engine, cycle: Cycle, theta: Real) -> Complex:
    """Guide forces of gas alone at crank angles, N [cylinder, angle], in the frame of its group."""
    push = gas_push(engine, cycle, theta)
    along = np.exp(1j * np.asarray(pistons(engine).links.bearing))[:, None]
    none = np.zeros_like(push)
    applied = Applied(-push * along, none, none, none)
    return guides(mechanism(engine), rods_over(engine, theta), applied)


def rods_over(engine: Engine, theta: Real) -> motion.Rods:
    """The rods of every cylinder at angles of the reference shaft, each in the frame of its group.

    That frame has the axis of the group's root cylinder up and its crank turning clockwise.
    """
    links, _place, lag, ratio, _crown = pistons(engine)
    return motion.rods(links, ratio[:, None] * theta + lag[:, None])


def rod_speeds(engine: Engine, theta: Real) -> Real:
    """How fast each rod swings clockwise, of the speed of the reference shaft [cylinder, angle].

    Im(conj(d) d') of its direction d by the angle of its own crank, times the turns of that.

    >>> from crankstar.files.catalog import load
    >>> four = load("i4", changes={"cylinder.rod_ratio": 4})
    >>> rod_speeds(four, np.array([0.0]))[0].tolist()  # at top dead centre -r/l
    [-0.25]
    """
    direction = rods_over(engine, theta).direction
    return np.imag(np.conj(direction.place) * direction.first) * pistons(engine).ratio[:, None]


def _to_thrust_side(guide: Complex, ratio: Real) -> Real:
    """The part across the axis, positive to the side to which expansion presses."""
    return -np.imag(guide) * np.sign(ratio)[:, None]
