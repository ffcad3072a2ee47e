"""An engine with one of its values changed: by a factor, or to what it is usually.

Those that multiply one by its key path are in `scaled_values`.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from itertools import pairwise
from math import radians
from typing import Any

from crankstar.analysis.changed_masses import Vary
from crankstar.engine.block import Block
from crankstar.engine.copies import with_values
from crankstar.engine.drive import Drive
from crankstar.engine.engine import Engine
from crankstar.engine.gas import Gas, OperatingPoint
from crankstar.engine.main_bearings import main_bearings
from crankstar.engine.records import Shaft, Valves
from crankstar.engine.torsion import Disc
from crankstar.mechanics.gas import Cycle

INERTIAS = ("inertia_up", "inertia_right", "inertia_z")
"""The moments of inertia of a block, by their keys."""


def with_rod_inertias(numbers: Collection[int]) -> Vary:
    """The change of the moment of inertia (kg m^2) of the rods of these cylinders."""

    def vary(engine: Engine, inertia: float) -> Engine:
        cylinders = [
            with_values(cylinder, rod=with_values(cylinder.rod, inertia=inertia))
            if cylinder.rod is not None and cylinder.number in numbers
            else cylinder
            for cylinder in engine.cylinders
        ]
        return with_values(engine, cylinders=tuple(cylinders))

    return vary


def with_gas_value(name: str, factor: float, *, point: int | None = None) -> Vary:
    """The change of one value of the table [gas], given in a unit of `factor` SI units.

    Or of the operating point at the place `point`, from 0.
    """

    def vary(engine: Engine, value: float) -> Engine:
        gas, changed = engine.gas or Gas(), {name: value * factor}
        if point is not None:
            points = [*gas.points]
            points[point] = with_values(points[point], **changed)
            changed = {"points": tuple(points)}
        return with_values(engine, gas=with_values(gas, **changed))

    return vary


def with_gas_choice(name: str, choice: str, *, ignition: str) -> Vary:
    """The change of what the table [gas] names by a word, whatever the value.

    The `ignition` stays what it is where it is not the choice: the friction may imply another.
    """

    def vary(engine: Engine, _value: float) -> Engine:
        named = {"ignition": ignition, name: choice}
        return with_values(engine, gas=with_values(engine.gas or Gas(), **named))

    return vary


def with_valve_angle(name: str) -> Vary:
    """The change of one angle of the table [valves], degrees."""

    def vary(engine: Engine, value: float) -> Engine:
        changed = with_values(engine.valves or Valves(), **{name: radians(value)})
        return with_values(engine, valves=changed)

    return vary


def with_bearings_moved(engine: Engine, share: float) -> Engine:
    """The engine with its assumed main bearings further forward by `share` (%) of the least gap."""

    def places(shaft: Shaft) -> tuple[float, ...]:
        own = main_bearings(engine, shaft)
        gap = min((front - rear for front, rear in pairwise(own)), default=0.0)
        return tuple(z + share / 100 * gap for z in own)

    shafts = [
        with_values(shaft, bearings=places(shaft), bearing_count=None)
        if shaft.throws and not shaft.bearings
        else shaft
        for shaft in engine.shafts
    ]
    return with_values(engine, shafts=tuple(shafts))


def with_torsion_value(path: str, factor: float = 1.0) -> Vary:
    """The change of one value of the table [torsion], or of one below it, given in `factor`."""
    *above, name = path.split(".")

    def vary(engine: Engine, value: float) -> Engine:
        records: list[Any] = [engine.torsion]
        for key in above:
            records.append(getattr(records[-1], key))
        changed: Any = with_values(records[-1], **{name: value * factor})
        for key, record in zip(reversed(above), reversed(records[:-1]), strict=True):
            changed = with_values(record, **{key: changed})
        return with_values(engine, torsion=changed)

    return vary


def with_disc_damping(index: int) -> Vary:
    """The change of the damping of a disc of [torsion] against what stands still, N m s/rad."""

    def vary(engine: Engine, value: float) -> Engine:
        own = engine.torsion
        if own is None:
            return engine
        discs = [*own.discs]
        discs[index] = with_values(discs[index], absolute_damping=value)
        return with_values(engine, torsion=with_values(own, discs=tuple(discs)))

    return vary


def with_drive_inertia(engine: Engine, inertia: float) -> Engine:
    """The engine with another inertia of its drive, kg m^2."""
    return with_values(engine, drive=with_values(engine.drive or Drive(), inertia=inertia))


def with_rear_disc(engine: Engine, inertia: float) -> Engine:
    """The engine with one more disc (kg m^2), rigid at the rear of its shaft that twists."""
    own = engine.torsion
    if own is None:
        return engine
    more = Disc(name="drive.inertia", inertia=inertia, to="rear")
    return with_values(engine, torsion=with_values(own, discs=(*own.discs, more)))


def with_block_mass(engine: Engine, mass: float) -> Engine:
    """The engine with a block of this mass (kg), where its file gives none."""
    return with_values(engine, block=with_values(engine.block or Block(), mass=mass))


def with_block_value(name: str, *, mass: float, factor: float) -> Vary:
    """The change of one value of the block, of this mass (kg) if there is none, in `factor` SI."""

    def vary(engine: Engine, value: float) -> Engine:
        block = engine.block or Block(mass=mass)
        return with_values(engine, block=with_values(block, **{name: value * factor}))

    return vary


def with_block_product(name: str, mass: float, inertia: Sequence[float]) -> Vary:
    """The change of a product of inertia of the block, whose mass and moments are these (SI)."""
    moments = dict(zip(INERTIAS, inertia, strict=True))

    def vary(engine: Engine, value: float) -> Engine:
        block = with_values(engine.block or Block(), mass=mass, **{**moments, name: value})
        return with_values(engine, block=block)

    return vary


def with_block_inertia(
    mass: float, inertia: Sequence[float], highest: Sequence[float] = (2.0, 2.0, 2.0)
) -> Vary:
    """The block, of this mass (kg) if there is none, with these moments of inertia by a factor.

    `highest` are the highest factors of the three; above 1 each goes as far towards its own as the
    highest of them does.
    """

    def vary(engine: Engine, factor: float) -> Engine:
        way = max(factor - 1, 0.0) / (max(highest) - 1)
        factors = [min(factor, 1.0) + way * (most - 1) for most in highest]
        values = {name: own * by for name, own, by in zip(INERTIAS, inertia, factors, strict=True)}
        block = engine.block or Block(mass=mass)
        return with_values(engine, block=with_values(block, **values))

    return vary


def with_mount_loss(engine: Engine, loss: float) -> Engine:
    """The engine with this loss factor of those mounts whose damping is not given."""
    mounts = [
        with_values(mount, loss_factor=loss) if mount.assumed else mount for mount in engine.mounts
    ]
    return with_values(engine, mounts=tuple(mounts))


def point_value(name: str, gas: Cycle | None, number: int | None = None) -> Vary | None:
    """The change by a factor of one value of the operating points that a cycle is of.

    With a `number`, counted from one, of that point of the file alone.
    """
    if gas is None or name not in OperatingPoint.model_fields or name in ("name", "speed"):
        return None

    names = {each for each, _share in gas.shares}

    def vary(engine: Engine, factor: float) -> Engine:
        own = engine.gas
        assert own is not None  # noqa: S101  # a cycle was computed
        points = [
            with_values(point, **{name: getattr(point, name) * factor})
            if index == (number or index)
            and point.name in names
            and getattr(point, name) is not None
            else point
            for index, point in enumerate(own.points, 1)
        ]
        return with_values(engine, gas=with_values(own, points=tuple(points)))

    return vary
