"""An engine on its mounts: all that is asked of it, in one record.

The modes and axes hold at any speed. The engine shakes over a range of speeds: those that are asked
for, else from the lowest to the highest that the file knows, else about the one that is known.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from functools import partial

import numpy as np

from crankstar.dynamics.mount_excitation import MountExcitation, mount_excitation
from crankstar.dynamics.mount_modes import (
    Axis,
    MountMode,
    elastic_axis,
    mount_modes,
    torque_roll_axis,
)
from crankstar.dynamics.mount_response import MountResponse, joined, mount_response, rms
from crankstar.dynamics.mounted_block import MountedBlock, mounted_block, settled
from crankstar.engine.engine import Engine
from crankstar.mechanics.maxima import refined
from crankstar.mechanics.occurring_orders import check_orders
from crankstar.mechanics.operating_points import OperatingState, operating_state, points_by_speed
from crankstar.spectra import Real

STEPS = 151
"""Speeds of a range that is not asked for."""
SLOWEST, FASTEST = 0.25, 1.1
"""Of the one speed that is known: the range that is taken."""


@dataclass(frozen=True)
class MountAnalysis:
    """What stands on mounts, how it would vibrate freely, and how it does.

    `sag` is how it sits down under its weight [freedom], `loads` what each mount bears along its
    axes (N). `over` is the response over the range of speeds, the `asked` ones with its critical
    speeds, half-power points and maxima, `at` that at the one that is asked for; None where no
    speed is known. `point` is the point of the block of which motion is told, `operating_point` the
    one that is named, `state` the one that is meant where one speed is asked for.

    >>> from crankstar.files.catalog import load
    >>> places = [("left", "-0.5 m", "0 m"), ("right", "0.5 m", "0 m"), ("rear", "0 m", "-0.3 m")]
    >>> rubber = [{"name": n, "right": r, "z": z, "stiffness": "50 N/mm"} for n, r, z in places]
    >>> five = load("audi-25-tfsi", changes={"mounts": rubber, "block": {"mass": "150 kg"}})
    >>> found = mounts(five)
    >>> round(float(-found.sag[0]) * 1e3, 6)  # mm: 150 kg times 9.80665 m/s^2 on two of them
    14.709975
    """

    block: MountedBlock
    modes: tuple[MountMode, ...]
    torque_roll: Axis
    elastic: Axis
    sag: Real
    loads: Real
    point: tuple[float, float, float]
    over: MountResponse | None = None
    at: MountResponse | None = None
    range_assumed: bool = False
    asked: Real = field(default_factory=lambda: np.array([]))
    operating_point: str = ""
    state: OperatingState | None = None


def mounts(
    engine: Engine,
    *,
    point: str = "",
    speed: float | None = None,
    speeds: Sequence[float] | Real = (),
    orders: Sequence[float] | None = None,
    at: Sequence[float] | None = None,
) -> MountAnalysis:
    """How an engine shakes on its mounts.

    `point` names an operating point, `speed` is one of which more is listed, else that of the
    point; `speeds` are those of the range (rad/s), `at` is a point of the block (up, right, z),
    else the first of its file, else its centre of mass. Raises MountError without mounts,
    OrderError for an order that does not occur, and GasError for an
    operating point that the engine has not.

    >>> from crankstar.files.catalog import load
    >>> places = [("left", "-0.5 m", "0 m"), ("right", "0.5 m", "0 m"), ("rear", "0 m", "-0.3 m")]
    >>> rubber = [{"name": n, "right": r, "z": z, "stiffness": "50 N/mm"} for n, r, z in places]
    >>> five = load("audi-25-tfsi", changes={"mounts": rubber, "block": {"mass": "150 kg"}})
    >>> found = mounts(five, speeds=[80, 600])
    >>> len(found.modes), found.over.mount_force.shape[2:]
    (6, (3, 3))

    The faster it runs, the less of what shakes it goes through the mounts:

    >>> bool((found.over.transmissibility[1] < found.over.transmissibility[0]).all())
    True
    """
    block = mounted_block(engine)
    check_orders(engine, orders or (), gas=engine.gas is not None)
    if point and speed is None and not len(speeds):
        speed = operating_state(engine, point=point).speed
    wanted, assumed = _range(engine, speed, speeds)
    sag, loads = settled(block)

    def push(turning: Real) -> MountExcitation:
        return mount_excitation(block, engine, speeds=turning, point=point, orders=orders)

    modes = mount_modes(block)
    told = _told(engine, block) if at is None else (at[0], at[1], at[2])
    over = None
    if wanted.size:
        grid = wanted
        if grid.size > 1 and not point:
            grid = _inside(wanted, [*points_by_speed(engine)])
        over = peaked(block, modes, push(grid), partial(_told_curves, point=told))
    return MountAnalysis(
        block=block,
        modes=modes,
        torque_roll=torque_roll_axis(block),
        elastic=elastic_axis(block),
        sag=sag,
        loads=loads,
        point=told,
        over=over,
        at=None if speed is None else mount_response(block, push(np.array([speed]))),
        range_assumed=assumed,
        asked=wanted,
        operating_point=point,
        state=None if speed is None else operating_state(engine, point=point, speed=speed),
    )


def greatest_ground_force(
    engine: Engine, block: MountedBlock, *, speeds: tuple[float, float], point: str = ""
) -> float:
    """The greatest force on the ground from one speed (rad/s) to another, N rms, of all orders.

    That of `mounts` over this range, without all else that it lists.

    >>> from crankstar.files.catalog import load
    >>> places = [("left", "-0.5 m", "0 m"), ("right", "0.5 m", "0 m"), ("rear", "0 m", "-0.3 m")]
    >>> rubber = [{"name": n, "right": r, "z": z, "stiffness": "50 N/mm"} for n, r, z in places]
    >>> five = load("audi-25-tfsi", changes={"mounts": rubber, "block": {"mass": "150 kg"}})
    >>> whole = rms(mounts(five, speeds=[80, 600]).over.ground_force[..., :3]).max()
    >>> own = greatest_ground_force(five, mounted_block(five), speeds=(80, 600))
    >>> bool(abs(own / whole - 1) < 1e-5)
    True
    """
    grid = np.unique(np.array(speeds, float))
    if grid.size > 1 and not point:
        grid = _inside(grid, [*points_by_speed(engine)])
    push = mount_excitation(block, engine, speeds=grid, point=point)

    def curves(found: MountResponse) -> Real:
        return rms(found.ground_force[..., :3])[:, None]

    found = peaked(block, mount_modes(block), push, curves)
    return float(curves(found).max(initial=0.0))


def _inside(grid: Real, more: Sequence[float] | Real) -> Real:
    """A grid of speeds with those of some more that are between its ends."""
    added = np.asarray(more, float)
    return np.union1d(grid, added[(grid[0] < added) & (added < grid[-1])])


def peaked(
    block: MountedBlock,
    modes: Sequence[MountMode],
    push: MountExcitation,
    curves: Callable[[MountResponse], Real],
) -> MountResponse:
    """The response with the critical speeds, half-power points and maxima of the range in it.

    The maxima of the `curves` [speed, curve]. Mounts without damping have none at their resonance.

    >>> from crankstar.files.catalog import load
    >>> at = [("left", "-0.5 m", "0 m"), ("right", "0.5 m", "0 m"), ("rear", "0 m", "-0.3 m")]
    >>> own = [{"name": n, "right": r, "z": z, "stiffness": "50 N/mm"} for n, r, z in at]
    >>> five = load("audi-25-tfsi", changes={"mounts": own, "block": {"mass": "150 kg"}})
    >>> block = mounted_block(five)
    >>> push = mount_excitation(block, five, speeds=np.array([80.0, 600.0]))
    >>> found = peaked(block, mount_modes(block), push, lambda own: rms(own.ground_force)[:, None])
    >>> found.speeds.size > 2
    True
    """
    damped = [each for each in modes if each.damping > 0]
    if push.speeds.size == 1 or not push.orders.size or len(damped) < len(modes):
        return mount_response(block, push)
    at = np.array([each.speed * (1 + n * each.damping) for each in modes for n in (-1, 0, 1)])
    grid = _inside(push.speeds, np.divide.outer(at, push.orders).ravel())

    return refined(
        grid,
        mount_response(block, push.between(grid)),
        at=lambda speeds: mount_response(block, push.between(speeds)),
        joined=joined,
        curves=curves,
    )


def _told_curves(found: MountResponse, point: tuple[float, float, float]) -> Real:
    """What is greatest somewhere: the motion of the point, the force on the ground, in mounts."""
    ground, motion = found.ground_force, found.displacement(point)
    each = found.mount_force[:, :, : found.block.of_block]
    told = [ground[..., :3], ground[..., 3:], motion, found.velocity(point)]
    return np.column_stack([*map(rms, told), *map(rms, np.moveaxis(each, 2, 0))])


def _told(engine: Engine, block: MountedBlock) -> tuple[float, float, float]:
    """The point of which motion is told unless one is asked for."""
    points = () if engine.block is None else engine.block.points
    return points[0].place if points else block.body.centre


def _range(
    engine: Engine, speed: float | None, speeds: Sequence[float] | Real
) -> tuple[Real, bool]:
    """The speeds of the range, and whether they are assumed about a single one."""
    if len(speeds):
        return np.unique(np.asarray(speeds, float)), False
    known = {speed, engine.speed}
    if engine.gas is not None:
        known |= {engine.gas.speed, *(each.speed for each in engine.gas.points)}
    given = sorted(each for each in known if each is not None)
    if not given:
        return np.array([]), False
    if len(given) > 1:
        return np.linspace(given[0], given[-1], STEPS), False
    return np.linspace(SLOWEST * given[0], FASTEST * given[0], STEPS), True
