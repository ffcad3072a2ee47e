"""An engine on its mounts speed by speed: a point of it, the ground, the worst of its mounts."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from crankstar.analysis.document import Column, Table, Value, for_each
from crankstar.dynamics.mount_analysis import MountAnalysis
from crankstar.dynamics.mount_response import COUNTS, MountResponse, peak, rms
from crankstar.language.messages import _
from crankstar.language.numbers import RPM, number
from crankstar.language.shown_units import quantity_text
from crankstar.spectra import Real

MM, UM = 1e3, 1e6
ROUNDING = 1e-9
ROWS = 13
"""Speeds that are shown to readers; all are in JSON and CSV."""


def speed_tables(found: MountAnalysis, own: MountResponse) -> tuple[Table, ...]:
    """Vibration of the point, force on the ground and in the mounts; for readers at few speeds."""
    names = tuple(own.block.mounts[index].name for index in range(own.block.of_block))
    columns = (
        Column(_("speed"), "rpm", key="speed_rpm", label=True),
        Column(_("displacement, rms"), "um", key="displacement_rms"),
        Column(_("peak"), "um", key="displacement_peak", optional=1),
        Column(_("velocity, rms"), "mm/s", key="velocity_rms"),
        Column(_("peak"), "mm/s", key="velocity_peak", optional=1),
        Column(_("force on the ground, rms"), "N", key="force_rms"),
        Column(_("peak"), "N", key="force_peak", optional=1),
        Column(_("moment, rms"), "N*m", key="moment_rms"),
        Column(_("most force in a mount, rms"), "N", optional=2),
        Column(_("mount"), kind="text", optional=2),
        Column(_("greatest transmissibility"), optional=3, digits=3),
        Column(_("mount"), kind="text", optional=3),
        Column("", "N", kind="list", key="mount_force_rms", machine=True, names=names),
        Column("", "N", kind="list", key="mount_force_peak", machine=True, names=names),
        Column("", kind="list", key="transmissibility", machine=True, names=names),
    )
    displacement, velocity = own.displacement(found.point), own.velocity(found.point)
    force, moment = own.ground_force[..., :3], own.ground_force[..., 3:]
    each_rms, each_peak = of_mounts(own)
    cells = np.column_stack(
        [
            own.speeds * RPM,
            UM * rms(displacement),
            UM * peak(displacement, orders=own.orders),
            MM * rms(velocity),
            MM * peak(velocity, orders=own.orders),
            rms(force),
            peak(force, orders=own.orders),
            rms(moment),
        ]
    )
    asked = np.searchsorted(own.speeds, found.asked)
    if asked.size > 2 * ROWS:
        asked = asked[np.unique(np.linspace(0, asked.size - 1, ROWS).round().astype(int))]
    rows: list[tuple[Value, ...]] = []
    for place in range(own.speeds.size):
        most = _first_greatest(each_rms[place])
        through = known(own.transmissibility[place])
        rows.append(
            (
                *map(float, cells[place]),
                float(each_rms[place, most]),
                names[most],
                *_greatest(through, names),
                tuple(each_rms[place].tolist()),
                tuple(each_peak[place].tolist()),
                through,
            )
        )
    title = _("Vibration over the speeds")
    blank = without_ratio(own)
    said = (*(_worst_notes(cells) if len(rows) > 1 else ()), *blank)
    few = tuple(rows[place] for place in asked.tolist())
    return for_each(
        Table(title, columns, few, said if len(few) > 1 else blank, key="speeds"),
        Table(title, columns, tuple(rows), said, key="speeds"),
    )


def _greatest(
    through: Sequence[float | None], names: Sequence[str]
) -> tuple[float | None, str | None]:
    """The greatest transmissibility and its mount; a mount may pass on most and have little force.

    >>> _greatest((0.4, None, 2.2), ("left", "right", "rear"))
    (2.2, 'rear')
    >>> _greatest((2.2, 2.2 + 1e-15), ("left", "right"))
    (2.2, 'left')
    """
    sizes = np.array([-1.0 if size is None else size for size in through])
    place = _first_greatest(sizes)
    return (None, None) if sizes[place] < 0 else (float(sizes[place]), names[place])


def _first_greatest(sizes: Real) -> int:
    """The first of those that are the greatest but for rounding."""
    return int(np.argmax(sizes >= sizes.max() * (1 - ROUNDING)))


def _worst_notes(cells: Real) -> tuple[str, ...]:
    """At the slowest speed, and where the point shakes most."""
    top = int(np.argmax(cells[:, 3]))
    return (
        _(
            "At the slowest speed, {rpm} rpm, the point moves by {size} rms; it shakes most at "
            "{worst} rpm: {velocity} rms.",
            rpm=number(float(cells[0, 0])),
            size=quantity_text(float(f"{cells[0, 1]:.4g}"), "um"),
            worst=number(float(round(cells[top, 0]))),
            velocity=quantity_text(float(f"{cells[top, 3]:.4g}"), "mm/s"),
        ),
    )


def of_mounts(own: MountResponse) -> tuple[Real, Real]:
    """The force in each mount of the block, rms and peak, N [speed, mount]."""
    mounts = range(own.block.of_block)
    each = [own.mount_force[:, :, index] for index in mounts]
    return (
        np.column_stack([rms(force) for force in each]),
        np.column_stack([peak(force, orders=own.orders) for force in each]),
    )


def without_ratio(own: MountResponse) -> tuple[str, ...]:
    """Which mounts have no transmissibility at some speed at which others have one, and why."""
    blank = np.isnan(own.transmissibility)
    some = blank[~blank.all(axis=1)].any(axis=0)
    names = [own.block.mounts[place].name for place in np.flatnonzero(some).tolist()]
    if not names:
        return ()
    return (
        _(
            "No transmissibility where a mount would bear less than {share} % of what another "
            "bears, if nothing had inertia: {mounts}.",
            share=number(100 * COUNTS),
            mounts=", ".join(names),
        ),
    )


def known(values: Real) -> tuple[float | None, ...]:
    """Transmissibilities, None where a mount has none."""
    return tuple(None if np.isnan(each) else float(each) for each in values)
