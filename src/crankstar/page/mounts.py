"""The block on its mounts, as the page has it: modes, axes, points, what shakes it at any speed.

Nothing of mounts is loaded for an engine without `[[mounts]]`.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import lru_cache
from typing import TYPE_CHECKING, NamedTuple, cast

import numpy as np

from crankstar.engine.engine import Engine
from crankstar.language.numbers import RPM, unit_text
from crankstar.language.shown_units import shown
from crankstar.mechanics.operating_points import GasError
from crankstar.page.mount_driving import driving, place_of, points_of, short
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
from crankstar.spectra import Real

if TYPE_CHECKING:
    from crankstar.analysis.document import Document
    from crankstar.dynamics.mount_analysis import MountAnalysis
    from crankstar.dynamics.mount_modes import Axis, MountMode
    from crankstar.dynamics.mount_response import MountResponse

MOST_POINTS, MOST_PEAKS = 6, 4
"""Operating points, and resonances, that are offered."""
PROMINENT = 0.1
"""How far a resonance stands out of the velocity beside it, of the greatest at any speed."""
LEAST = 1e-10
"""Share of the greatest motion or force at every speed below which an order is left out."""


class _Driven(NamedTuple):
    """The vibration at a speed with the gas of a point; whether it is a resonance."""

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
    """At the speeds of points, else of the file; at the ends of the range; at resonances."""
    from scipy.signal import find_peaks

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
    found_at, how = find_peaks(velocity, prominence=PROMINENT * velocity.max())
    peaks = found_at[np.argsort(-how["prominences"])][:MOST_PEAKS].tolist()
    for place in sorted({0, over.speeds.size - 1, *peaks}):
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
    block, over = found.block, found.over
    axes = _axes(found)
    kept = _kept(over, driven)
    return Mounts(
        centres=tuple(map(place_of, block.centres)),
        points=points_of(engine, found),
        mounts=tuple(
            MountShown(
                name=mount.name,
                place=(mount.up, mount.right, mount.z),
                axes=cast("tuple[Place, Place, Place]", tuple(map(place_of, axes[index]))),
                below=index >= block.of_block,
                load=place_of(found.loads[index] @ axes[index]),
            )
            for index, mount in enumerate(block.mounts)
        ),
        modes=tuple(_mode(found, axes, index, mode) for index, mode in enumerate(found.modes)),
        torque_roll=_axis(found.torque_roll),
        elastic=_axis(found.elastic),
        over=None if over is None else _over(over),
        orders=() if over is None else tuple(over.orders[kept].tolist()),
        driving=None if over is None else driving(engine, over, kept),
        vibrations=tuple(_vibration(each, kept) for each in driven),
    )


def _axes(found: MountAnalysis) -> Real:
    """The directions of the axes of every mount [mount, axis, (up, right, z)]."""
    from crankstar.engine.rigid_block import mount_axes

    return np.array([mount_axes(each) for each in found.block.mounts])


def _axis(axis: Axis) -> MountAxis:
    return MountAxis(point=place_of(axis.point), direction=place_of(axis.direction))


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
        forces=tuple(map(place_of, np.einsum("ma,mai->mi", along, axes))),
    )


def _over(own: MountResponse) -> MountsOverSpeed:
    from crankstar.dynamics.mount_response import rms

    return MountsOverSpeed(
        speeds_rpm=short(own.speeds * RPM),
        force=short(rms(own.ground_force[..., :3])),
        transmissibility=tuple(
            tuple(None if np.isnan(each) else short([each])[0] for each in line)
            for line in own.transmissibility.T
        ),
    )


def _kept(over: MountResponse | None, driven: tuple[_Driven, ...]) -> Real:
    """Which orders shake the block, those of nothing but rounding left out."""
    if over is None:
        return np.array([], bool)
    out = np.zeros(over.orders.size, bool)
    for at in (over, *(each.response for each in driven)):
        forces = at.mount_force.reshape(*at.motion.shape[:2], -1)
        sizes = [np.abs(forces).max(axis=2), *np.moveaxis(np.abs(at.motion), 2, 0)]
        for size in sizes:  # [speed, order]
            out |= (size > LEAST * np.maximum(size.max(axis=1, keepdims=True), 1e-300)).any(axis=0)
    return out


def _vibration(driven: _Driven, kept: Real) -> MountVibration:
    point, peak, at = driven
    return MountVibration(
        point=point,
        gas=wave_of(at.excitation.gas[0, kept, 5]) if point else None,
        speed_rpm=float(at.speeds[0]) * RPM,
        peak=peak,
    )


def mount_numbers(engine: Engine) -> MountNumbers | None:
    """Its numbers as the command prints them, in the units of the context."""
    known = _standing(engine)
    if known is None:
        return None
    from crankstar.analyses.mounts.document import document as mounts_document
    from crankstar.analyses.mounts.question import Question
    from crankstar.dynamics.mount_response import rms

    found, driven = known
    plain = mounts_document(engine, found, Question())
    forces = [float(rms(each.response.ground_force[..., :3])[0]) for each in driven]
    notes, doubts = (
        tuple(
            line
            for part in plain.sentences
            if part.kind in kinds and part.key != "point"  # which the reader chooses
            for line in part.lines
        )
        for kinds in (("note",), ("doubt", "assumed"))
    )
    return MountNumbers(
        displacement_unit=_small("um", 1e6),
        velocity_unit=_small("mm/s", 1e3),
        acceleration_unit=_small("m/s^2", 1.0),
        heat_unit=_small("W", 1.0),
        force_unit=_unit(max(forces, default=1.0) or 1.0),
        load_unit=_unit(float(np.abs(found.loads).max())),
        mounts=_table(plain, "mounts"),
        modes=_table(plain, "modes"),
        axes=_table(plain, "axes"),
        speeds=_table(plain, "speeds"),
        notes=notes,
        doubts=doubts,
    )


def _unit(largest: float) -> Unit:
    unit = shown("N", largest)
    return Unit(label=unit_text(unit.unit), factor=unit.factor)


def _small(unit: str, count: float) -> Unit:
    """The unit for one of which there are `count` in SI."""
    said = shown(unit, 1.0, prefixed=False)
    return Unit(label=unit_text(said.unit), factor=count * said.factor)


def _table(document: Document, key: str) -> Table:
    tables = printed(table for table in document.for_readers.tables if table.key == key)
    return tables[0] if tables else Table(title="", heads=(), rows=())
