"""The block on its mounts, as the page has it: modes, axes, vibration over speed and at a speed.

Nothing of mounts is loaded for an engine without `[[mounts]]`.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace
from functools import lru_cache
from math import pi
from typing import TYPE_CHECKING, NamedTuple, cast

import numpy as np

from crankstar.engine.engine import Engine
from crankstar.language.numbers import unit_text
from crankstar.language.shown_units import shown
from crankstar.mechanics.operating_points import GasError
from crankstar.page.mount_records import (
    MountAxis,
    MountedMode,
    MountNumbers,
    Mounts,
    MountShown,
    MountsOverSpeed,
    MountVibration,
    Place,
)
from crankstar.page.printed import printed
from crankstar.page.torque import cycles, wave_of
from crankstar.page.unit_records import Table, Unit
from crankstar.spectra import Complex, Real

if TYPE_CHECKING:
    from crankstar.dynamics.mount_analysis import MountAnalysis
    from crankstar.dynamics.mount_modes import Axis, MountMode
    from crankstar.dynamics.mount_response import MountResponse
    from crankstar.tables.table import Document

MOST_POINTS, MOST_PEAKS = 6, 4
"""Operating points, and speeds at which the block shakes most, whose vibration is sent."""
LEAST = 1e-10
"""Share of the greatest motion or force below which an order is left out."""
RPM = 30 / pi


class _Driven(NamedTuple):
    """The vibration at a speed with the gas of a point, where it may shake most."""

    point: str
    peak: bool
    response: MountResponse


class _Standing(NamedTuple):
    """All that is known of an engine on its mounts."""

    found: MountAnalysis
    driven: tuple[_Driven, ...]


@lru_cache(maxsize=16)
def _standing(engine: Engine) -> _Standing | None:
    """An engine on its mounts, None without any."""
    if not engine.mounts:
        return None
    from crankstar.dynamics.mount_analysis import mounts  # with scipy, for these engines alone

    found = mounts(engine)
    return _Standing(found, tuple(_vibrations(engine, found)))


def _vibrations(engine: Engine, found: MountAnalysis) -> Iterator[_Driven]:
    """At the speeds of points, else of the file; at the ends of the range; where it shakes most."""
    from crankstar.dynamics.mount_excitation import mount_excitation
    from crankstar.dynamics.mount_response import mount_response, rms

    over = found.over
    if over is None:
        return

    def driven(point: str, speed: float, *, peak: bool = False) -> _Driven:
        at = np.array([speed])
        push = mount_excitation(found.block, engine, speeds=at, point=point)
        return _Driven(point, peak, mount_response(found.block, push))

    known: list[float] = []
    for point, speed in _points(engine):
        known.append(speed)
        yield driven(point, speed)
    velocity = rms(over.velocity(found.point))
    inner = (velocity[1:-1] > velocity[:-2]) & (velocity[1:-1] >= velocity[2:])
    peaks = sorted(1 + np.flatnonzero(inner), key=lambda place: -velocity[place])[:MOST_PEAKS]
    for place in sorted({0, over.speeds.size - 1, *map(int, peaks)}):
        speed = float(over.speeds[place])
        if not any(abs(speed - other) < 1e-9 * speed for other in known):
            yield driven("", speed, peak=place in peaks)


def _points(engine: Engine) -> list[tuple[str, float]]:
    """Operating points with their speeds, else the speed of the file."""
    points: list[tuple[str, float]] = []
    if engine.gas is not None:
        try:
            gases = [each.burning for each in cycles(engine)]
        except GasError:
            gases = []
        points = [(gas.name, gas.speed) for gas in gases[:MOST_POINTS] if gas.speed is not None]
    return points or ([("", engine.speed)] if engine.speed is not None else [])


def mounts_shown(engine: Engine) -> Mounts | None:
    """An engine on its mounts; None without [[mounts]].

    >>> from crankstar.files.catalog import load
    >>> places = [("left", "-0.5 m", "0 m"), ("right", "0.5 m", "0 m"), ("rear", "0 m", "-0.3 m")]
    >>> rubber = [{"name": n, "right": r, "z": z, "stiffness": "50 N/mm"} for n, r, z in places]
    >>> five = load("audi-25-tfsi", changes={"mounts": rubber, "block": {"mass": "150 kg"}})
    >>> shown = mounts_shown(five)
    >>> round(sum(each.load[0] for each in shown.mounts), 6), len(shown.modes)  # its weight, N
    (-1470.9975, 6)
    """
    known = _standing(engine)
    if known is None:
        return None
    found, driven = known
    block = found.block
    axes = _axes(found)
    kept = _kept(driven)
    return Mounts(
        centres=tuple(map(_place, block.centres)),
        point=_place(found.point),
        mounts=tuple(
            MountShown(
                name=mount.name,
                place=(mount.up, mount.right, mount.z),
                axes=cast("tuple[Place, Place, Place]", tuple(map(_place, axes[index]))),
                below=index >= block.of_block,
                load=_place(found.loads[index] @ axes[index]),
            )
            for index, mount in enumerate(block.mounts)
        ),
        modes=tuple(_mode(found, axes, index, mode) for index, mode in enumerate(found.modes)),
        torque_roll=_axis(found.torque_roll),
        elastic=_axis(found.elastic),
        over=_over(found, found.over) if found.over is not None else None,
        orders=tuple(driven[0].response.orders[kept].tolist()) if driven else (),
        vibrations=tuple(_vibration(each, axes, kept) for each in driven),
    )


def _axes(found: MountAnalysis) -> Real:
    """The directions of the axes of every mount [mount, axis, (up, right, z)]."""
    from crankstar.engine.rigid_block import mount_axes

    return np.array([mount_axes(each) for each in found.block.mounts])


def _place(values: Iterable[float]) -> Place:
    up, right, z = (float(each) + 0.0 for each in values)
    return up, right, z


def _axis(axis: Axis) -> MountAxis:
    return MountAxis(point=_place(axis.point), direction=_place(axis.direction))


def _mode(found: MountAnalysis, axes: Real, index: int, mode: MountMode) -> MountedMode:
    block = found.block
    stiff = block.along * block.stiffening(mode.speed)[:, None]
    along = stiff * (block.arms @ mode.shape)
    return MountedMode(
        number=index + 1,
        frequency_hz=mode.frequency,
        damping=mode.damping,
        energy=tuple(mode.energy.tolist()),
        shape=tuple(mode.shape.tolist()),
        forces=tuple(map(_place, np.einsum("ma,mai->mi", along, axes))),
    )


def _over(found: MountAnalysis, own: MountResponse) -> MountsOverSpeed:
    from crankstar.dynamics.mount_response import rms

    through = own.transmissibility.T
    return MountsOverSpeed(
        speeds_rpm=_short(own.speeds * RPM),
        displacement=_short(rms(own.displacement(found.point))),
        velocity=_short(rms(own.velocity(found.point))),
        force=_short(rms(own.ground_force[..., :3])),
        transmissibility=tuple(
            tuple(None if np.isnan(each) else _short([each])[0] for each in line)
            for line in through
        ),
    )


def _short(values: Iterable[float]) -> tuple[float, ...]:
    return tuple(float(f"{value:.9g}") for value in values)


def _kept(driven: tuple[_Driven, ...]) -> Real:
    """Which orders make up the vibrations, those of nothing but rounding left out."""
    if not driven:
        return np.array([], bool)
    out = np.zeros(driven[0].response.orders.size, bool)
    for _point, _peak, at in driven:
        flat = at.mount_force[0].reshape(out.size, -1)
        for size in (np.abs(flat).max(axis=1), *np.abs(at.motion[0]).T):
            out |= size > LEAST * max(float(size.max(initial=0.0)), 1e-300)
    return out


def _vibration(driven: _Driven, axes: Real, kept: Real) -> MountVibration:
    point, peak, at = driven
    forces: Complex = np.einsum("kma,mai->mik", at.mount_force[0, kept], axes)
    return MountVibration(
        point=point,
        gas=not at.excitation.without_gas,
        speed_rpm=float(at.speeds[0]) * RPM,
        peak=peak,
        motion=tuple(map(wave_of, at.motion[0, kept].T)),
        forces=tuple((wave_of(up), wave_of(right), wave_of(z)) for up, right, z in forces),
    )


def mount_numbers(engine: Engine) -> MountNumbers | None:
    """Its numbers as the command prints them, in the units of the context."""
    known = _standing(engine)
    if known is None:
        return None
    from crankstar.dynamics.mount_response import rms
    from crankstar.tables.mounts import mounts_document

    found, driven = known
    plain = mounts_document(engine, found)
    still = replace(found, over=None)
    at_speeds = [mounts_document(engine, replace(still, at=each.response)) for each in driven]
    forces = [float(rms(each.response.ground_force[..., :3])[0]) for each in driven]
    notes, doubts = (
        tuple(line for part in plain.sentences if part.kind == kind for line in part.lines)
        for kind in ("note", "doubt")
    )
    return MountNumbers(
        displacement_unit=_small("um", 1e6),
        velocity_unit=_small("mm/s", 1e3),
        force_unit=_unit(max(forces, default=1.0) or 1.0),
        load_unit=_unit(float(np.abs(found.loads).max())),
        mounts=_table(plain, "mounts"),
        modes=_table(plain, "modes"),
        axes=_table(plain, "axes"),
        speeds=_table(plain, "speeds"),
        vibrations=tuple(
            (_table(each, "orders"), _table(each, "mounts_at_speed")) for each in at_speeds
        ),
        notes=notes,
        doubts=doubts,
    )


def _unit(largest: float) -> Unit:
    unit = shown("N", largest)
    return Unit(label=unit_text(unit.unit), factor=unit.factor)


def _small(unit: str, count: float) -> Unit:
    """The unit for one of which there are `count` in SI."""
    said = shown(unit, 1.0)
    label = "µm" if said.unit == "um" else unit_text(said.unit)
    return Unit(label=label, factor=count * said.factor)


def _table(document: Document, key: str) -> Table:
    tables = printed(table for table in document.tables if table.key == key)
    return tables[0] if tables else Table(title="", heads=(), rows=())
