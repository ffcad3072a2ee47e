"""What a verdict and a comparison say of mounts: the mode of roll, the worst of force and shake."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from crankstar.analysis.document import Column, Table, Value
from crankstar.dynamics.mount_analysis import MountAnalysis, mounts
from crankstar.dynamics.mount_worst import ROLL, Worst, roll_mode, worst
from crankstar.dynamics.mounted_block import MountError
from crankstar.engine.engine import Engine
from crankstar.language.alike import as_given
from crankstar.language.messages import _
from crankstar.language.numbers import RPM, number, order_text
from crankstar.language.shown_units import quantity_text

MM = 1e3
NONE = 1e-9
"""N, or m/s: less is nothing."""


class _Told(NamedTuple):
    """An analysis, its worst force on the ground and its worst velocity of the point."""

    found: MountAnalysis
    force: Worst | None
    velocity: Worst | None


def sentences(engine: Engine, *, speed: float | None = None) -> list[str]:
    """The natural modes, the worst force on the ground, the worst shake of the point; or nothing.

    >>> from crankstar.files.catalog import load
    >>> at = [("left", "-0.5 m", "0 m"), ("right", "0.5 m", "0 m"), ("rear", "0 m", "-0.3 m")]
    >>> rubber = [{"name": n, "right": r, "z": z, "stiffness": "50 N/mm"} for n, r, z in at]
    >>> about = {"inertia_up": "8 kg*m^2", "inertia_right": "9 kg*m^2", "inertia_z": "4 kg*m^2"}
    >>> block = {"mass": "150 kg", "z": "0 m", **about}
    >>> five = load("audi-25-tfsi", changes={"mounts": rubber, "block": block})
    >>> sentences(five)[0]  # sqrt(2 * 50 N/mm * (0.5 m)^2 / 4 kg m^2)/2 pi
    'Roll on the mounts: 12.58 Hz, all six modes between 2.621 and 12.58 Hz.'
    """
    if not engine.mounts:
        return []
    try:
        told = _told(engine, speed)
    except MountError as error:
        return [str(error)]
    lines = [_mode_sentence(told.found)]
    over = told.found.over
    if over is None or told.force is None or told.velocity is None:
        return lines
    low, high = (number(round(float(over.speeds[place]) * RPM)) for place in (0, -1))
    if told.force.size < NONE:
        return [*lines, _("Nothing shakes it between {low} and {high} rpm.", low=low, high=high)]
    lines.append(
        _(
            "Between {low} and {high} rpm the force on the ground is greatest at {rpm} rpm: {size} "
            "rms, most of it of order {order}.",
            low=low,
            high=high,
            **_words("force", told.force, 1.0, "N"),
        )
    )
    lines.append(
        _(
            "{point} shakes most at {rpm} rpm: {size} rms, most of it of order {order}.",
            point=_point(engine),
            **_words("velocity", told.velocity, MM, "mm/s"),
        )
    )
    if over.excitation.without_gas:
        reason = over.excitation.without_gas.rstrip(".")
        lines.append(_("Without gas: {reason}.", reason=reason))
    return lines


def _told(engine: Engine, speed: float | None) -> _Told:
    found = mounts(engine, speed=speed)
    over = found.over
    if over is None:
        return _Told(found, None, None)
    force = worst(over, over.ground_force[..., :3])
    return _Told(found, force, worst(over, over.velocity(found.point)))


def _mode_sentence(found: MountAnalysis) -> str:
    place = as_given("mode of roll", roll_mode(found.modes))
    roll, low, high = (found.modes[each] for each in (place, 0, -1))
    return _(
        "Roll on the mounts: {roll} Hz, all {modes} between {low} and {high} Hz.",
        roll=_hertz(roll.frequency),
        modes=_("six modes") if len(found.modes) == ROLL + 1 else _("twelve modes"),
        low=_hertz(low.frequency),
        high=_hertz(high.frequency),
    )


def _hertz(frequency: float) -> str:
    return number(float(f"{frequency:.4g}"))


def _words(name: str, own: Worst, factor: float, unit: str) -> dict[str, str]:
    """Size, speed and order as text; the order is the one that the engine as given decides."""
    return {
        "rpm": number(round(own.speed * RPM)),
        "size": quantity_text(float(f"{own.size * factor:.4g}"), unit),
        "order": order_text(as_given(("worst order on mounts", name), own.order)),
    }


def _point(engine: Engine) -> str:
    """The point of which motion is told."""
    if engine.block is not None and engine.block.points:
        return _("The point {name}", name=engine.block.points[0].name)
    return _("The centre of mass")


def compared(
    engines: Sequence[Engine], names: Sequence[str], speeds: Sequence[float | None]
) -> tuple[Table, ...]:
    """Modes, force on the ground and shake of the engines that have mounts."""
    rows: list[tuple[Value, ...]] = []
    for engine, name, speed in zip(engines, names, speeds, strict=True):
        if engine.mounts:
            told = _told(engine, speed)
            modes = told.found.modes
            roll = modes[roll_mode(modes)]
            ends = (modes[0].frequency, modes[-1].frequency)
            share = 100 * float(roll.energy[ROLL])
            rows.append((name, *ends, roll.frequency, share, *_cells(told)))
    if not rows:
        return ()
    columns = (
        Column(_("engine"), kind="text", label=True, wraps=True),
        Column(_("lowest mode"), "Hz", fixed=True, digits=4),
        Column(_("highest mode"), "Hz", fixed=True, digits=4, optional=1),
        Column(_("mode of roll"), "Hz", fixed=True, digits=4),
        Column(_("roll in it"), "%", digits=3, optional=2),
        Column(_("force on the ground, rms"), "N", digits=4),
        Column(_("at speed"), "rpm", digits=5, optional=3),
        Column(_("velocity of the point, rms"), "mm/s", digits=4),
        Column(_("at speed"), "rpm", digits=5, optional=3),
    )
    return (Table(_("On its mounts"), columns, tuple(rows)),)


def _cells(told: _Told) -> tuple[Value, ...]:
    if told.force is None or told.velocity is None:
        return (None,) * 4
    force, velocity = told.force, told.velocity
    return force.size, force.speed * RPM, velocity.size * MM, velocity.speed * RPM


def sizes(
    engines: Sequence[Engine], speeds: Sequence[float | None]
) -> list[tuple[str, float | None, list[float | None], str]]:
    """The same for machines: quantity, order, the value of each engine, unit.

    None for an engine without mounts.
    """
    if not any(engine.mounts for engine in engines):
        return []
    columns: list[tuple[float | None, ...]] = []
    for engine, speed in zip(engines, speeds, strict=True):
        told = _told(engine, speed) if engine.mounts else None
        columns.append((None,) * len(SIZES) if told is None else _sizes(told))
    return [
        (name, None, [*values], unit)
        for (name, unit), values in zip(SIZES, zip(*columns, strict=True), strict=True)
    ]


SIZES = (
    ("mount_lowest_mode", "Hz"),
    ("mount_highest_mode", "Hz"),
    ("mount_roll_mode", "Hz"),
    ("mount_roll_share", ""),
    ("mount_force", "N"),
    ("mount_force_speed", "rpm"),
    ("mount_velocity", "mm/s"),
    ("mount_velocity_speed", "rpm"),
)
"""What machines have of an engine on its mounts: quantity and unit."""


def _sizes(told: _Told) -> tuple[float | None, ...]:
    modes = told.found.modes
    roll = modes[roll_mode(modes)]
    force, velocity = told.force, told.velocity
    return (
        modes[0].frequency,
        modes[-1].frequency,
        roll.frequency,
        float(roll.energy[ROLL]),
        force and force.size,
        force and force.speed * RPM,
        velocity and velocity.size * MM,
        velocity and velocity.speed * RPM,
    )
