"""An engine on its mounts as tables: mounts, natural modes, axes, vibration and forces by speed."""

from __future__ import annotations

from math import degrees, pi
from typing import Any

import numpy as np

from crankstar.analyses.mounts.question import Question
from crankstar.analyses.mounts.speed_tables import known, of_mounts, speed_tables, without_ratio
from crankstar.analysis.document import Column, Document, Remarks, Table, Value, remarks
from crankstar.dynamics.mount_analysis import MountAnalysis
from crankstar.dynamics.mount_doubts import mount_doubts
from crankstar.dynamics.mount_modes import Axis
from crankstar.dynamics.mount_response import MountResponse
from crankstar.dynamics.mounted_block import SIX
from crankstar.engine.engine import Engine
from crankstar.engine.mounts import RUBBER_LOSS_FACTOR
from crankstar.engine.rigid_block import FREEDOMS
from crankstar.language.messages import _
from crankstar.language.numbers import NEGLIGIBLE, RPM, number, rpm_of
from crankstar.language.shown_units import quantity_text
from crankstar.mechanics.mass_doubts import body_doubts
from crankstar.spectra import Complex
from crankstar.tables.estimates import typical_remarks
from crankstar.tables.gas_words import range_facts, range_words, state_facts, state_words
from crankstar.tables.headings import heading_lines
from crankstar.tables.mount_points import FREEDOM_NAMES, point_tables, told_point

MM, UM = 1e3, 1e6


def document(engine: Engine, found: MountAnalysis, asked: Question) -> Document:
    """All of an analysis, for readers a few of many speeds.

    Orders of which next to nothing is left are told where orders are asked for.
    """
    parts: list[Table | Remarks] = [Remarks((*heading_lines(engine), *_asked(engine, found)))]
    parts += [_mount_table(found), _mode_table(found), _axis_table(found)]
    parts += () if found.over is None else speed_tables(found, found.over)
    parts += point_tables(engine, found)
    if found.at is not None:
        parts += [
            _order_table(found, found.at, every=asked.orders is not None),
            _force_table(found.at),
        ]
    parts += [*_notes(engine, found), *remarks(*_doubts(engine, found), kind="doubt")]
    parts += [*remarks(*_assumed(found), kind="assumed"), *typical_remarks(engine)]
    return Document(engine.name, tuple(parts), _facts(engine, found))


def _facts(engine: Engine, found: MountAnalysis) -> dict[str, Any]:
    block, known = found.block, found.over or found.at
    return {
        "format": 1,
        "engine": engine.name,
        "mass": block.body.mass,
        "centre": list(block.body.centre),
        "inertia": block.mass[3:SIX, 3:SIX].tolist(),
        "point": list(found.point),
        "freedoms": list(FREEDOMS),
        "speed_rpm": None if found.state is None else rpm_of(found.state.speed or 0.0),
        "operating_point": None if found.state is None else found.state.point or None,
        "points": state_facts(found.state)["points"],
        "gas_over_speeds": range_facts(engine, found.operating_point),
        "without_gas": (known.excitation.without_gas or None) if known else None,
        "assumed": [
            *(["block"] if block.body.assumed else []),
            *(f"{each.name}.loss_factor" for each in block.mounts if each.assumed),
        ],
        "units": {
            "displacement": "um",
            "velocity": "mm/s",
            "acceleration": "m/s^2",
            "force": "N",
            "moment": "N*m",
            "sag": "mm, mrad",
            "place": "mm",
            "stiffness": "N/mm",
        },
        "sag": (found.sag * MM).tolist(),
    }


def _mount_table(found: MountAnalysis) -> Table:
    """The mounts, where they are, how stiff, and what each bears at rest."""
    columns = (
        Column(_("mount"), kind="text", key="name", label=True),
        Column(_("up"), "mm", key="up"),
        Column(_("right"), "mm", key="right"),
        Column(_("along"), "mm", key="z"),
        Column(_("stiffness along its axes"), "N/mm", kind="list", key="stiffness"),
        Column(_("loss factor"), key="loss_factor"),
        Column(_("load at rest"), "N", key="load"),
    )
    borne = np.linalg.norm(found.loads, axis=-1)
    borne = np.where(borne > NEGLIGIBLE * borne.max(initial=0.0), borne, 0.0)
    rows = tuple(
        (
            each.name,
            each.up * MM,
            each.right * MM,
            each.z * MM,
            tuple(value / MM for value in each.along),
            each.loss,
            float(load),
        )
        for each, load in zip(found.block.mounts, borne, strict=True)
    )
    title = _("Mounts") if found.block.freedoms == SIX else _("Mounts, and those of the foundation")
    level = _("At rest gravity acts against up, the crankshaft being level.")
    return Table(title, columns, rows, notes=(level,), key="mounts")


def _mode_table(found: MountAnalysis) -> Table:
    """Natural frequencies, with the share of each freedom in the kinetic energy."""
    based = found.block.freedoms > SIX
    freedoms = (*FREEDOMS, *(f"foundation_{name}" for name in FREEDOMS * based))
    columns = (
        Column(_("mode"), key="mode", label=True),
        Column(_("frequency"), "Hz", key="frequency_hz", fixed=True),
        Column(_("per minute"), "1/min", fixed=True),
        Column(_("damping ratio"), key="damping_ratio", digits=3),
        *(Column(_(FREEDOM_NAMES[name]), "%", digits=3, fixed=True) for name in FREEDOMS),
        *([Column(_("foundation"), "%", digits=3, fixed=True)] if based else []),
        Column("", kind="list", key="shape", machine=True, names=freedoms),
        Column("", kind="list", key="energy", machine=True, names=freedoms),
    )
    rows: list[tuple[Value, ...]] = []
    for index, mode in enumerate(found.modes):
        energy = [*mode.energy[:SIX], *([sum(mode.energy[SIX:])] if based else [])]
        shares = tuple(round(100 * float(share), 1) + 0.0 for share in energy)
        rows.append(
            (
                index + 1,
                mode.frequency,
                mode.frequency * 60,
                mode.damping,
                *shares,
                tuple(mode.shape.tolist()),
                tuple(mode.energy.tolist()),
            )
        )
    said = _("Shares of the freedoms of the block in the kinetic energy of each mode.")
    if based:
        said = _(
            "Shares of the freedoms of the block, and of the foundation, in the kinetic energy of "
            "each mode."
        )
    return Table(_("Natural modes"), columns, tuple(rows), (said,), key="modes")


def _axis_table(found: MountAnalysis) -> Table:
    """The torque-roll axis and the elastic axis."""
    columns = (
        Column(_("axis"), kind="text", label=True),
        Column("", kind="text", key="name", machine=True),
        Column(_("up"), "mm", key="up"),
        Column(_("right"), "mm", key="right"),
        Column(_("along"), "mm", key="z"),
        Column(_("from the crankshaft"), "deg", key="angle_deg"),
        Column("", kind="list", key="direction", machine=True, names=("up", "right", "z")),
        Column(_("advance"), "mm/rad", key="advance"),
    )

    def row(shown: str, name: str, axis: Axis) -> tuple[Value, ...]:
        place = (float(each) * MM for each in axis.point)
        way = tuple(axis.direction.tolist())
        return (shown, name, *place, degrees(axis.from_crank), way, axis.advance * MM)

    rows = (
        row(_("torque-roll axis"), "torque_roll", found.torque_roll),
        row(_("elastic axis"), "elastic", found.elastic),
    )
    said = _(
        "Advance: how far the block moves along the axis, positive to the front, for each radian "
        "that it turns about it clockwise, seen from the front."
    )
    return Table(_("Axes"), columns, rows, (said,), key="axes")


def _order_table(found: MountAnalysis, own: MountResponse, *, every: bool) -> Table:
    """Motion of the point and force on the ground at one speed, order by order."""
    columns = (
        Column(_("order"), key="order", label=True),
        Column(_("up"), "um", kind="wave", key="up"),
        Column(_("right"), "um", kind="wave", key="right"),
        Column(_("along"), "um", kind="wave", key="z"),
        Column(_("roll"), "deg", kind="wave", key="roll_deg"),
        Column(_("force on the ground, rms"), "N", key="force_rms"),
    )
    moved = UM * own.displacement(found.point)[0]
    roll: Complex = own.motion[0, :, 5] * (180 / pi)
    force = np.sqrt((np.abs(own.ground_force[0, :, :3]) ** 2).sum(axis=-1) / 2)
    size = np.abs(moved).max(axis=-1)
    least = 1e-3 * float(size.max(initial=0.0))
    rows: list[tuple[Value, ...]] = [
        (float(order), *map(complex, moved[index]), complex(roll[index]), float(force[index]))
        for index, order in enumerate(own.orders)
        if every or size[index] > least
    ]
    title = _("By order at {rpm} rpm", rpm=number(float(own.speeds[0] * RPM)))
    return Table(title, columns, tuple(rows), key="orders")


def _force_table(own: MountResponse) -> Table:
    """The force in each mount at one speed, along its own axes."""
    columns = (
        Column(_("mount"), kind="text", key="name", label=True),
        Column(_("along its axes, rms"), "N", kind="list", key="rms_along"),
        Column(_("rms"), "N", key="rms"),
        Column(_("peak"), "N", key="peak"),
        Column(_("transmissibility"), key="transmissibility", digits=3),
        Column(_("heat"), "W", key="heat", fixed=True),
    )
    along = np.sqrt((np.abs(own.mount_force[0]) ** 2).sum(axis=0) / 2)
    each_rms, each_peak = of_mounts(own)
    through, heat = known(own.transmissibility[0]), own.heat[0]
    rows = tuple(
        (
            own.block.mounts[index].name,
            tuple(along[index].tolist()),
            float(each_rms[0, index]),
            float(each_peak[0, index]),
            through[index],
            float(heat[index]),
        )
        for index in range(own.block.of_block)
    )
    title = _("Force in the mounts at {rpm} rpm", rpm=number(float(own.speeds[0] * RPM)))
    return Table(title, columns, rows, without_ratio(own), key="mounts_at_speed")


def _notes(engine: Engine, found: MountAnalysis) -> tuple[Remarks, ...]:
    """What it rests on, and what is left out."""
    sag = quantity_text(float(f"{-found.sag[0] * MM:.4g}"), "mm")
    lines = [_("Under its weight the block sits down by {sag} at its centre of mass.", sag=sag)]
    if found.over is None and found.at is None:
        lines.append(_("Without a speed nothing shakes it: give --speeds, or speed in the file."))
        return remarks(*lines, kind="note")
    lines.append(
        _(
            "Transmissibility: the force in a mount, rms, over that of the same shaking so slow "
            "that nothing has inertia, with the stiffness at rest and without damping."
        )
    )
    if found.state is not None:
        lines.append(state_words(engine, found.state))
    if found.over is not None and not found.over.excitation.without_gas:
        lines.append(range_words(engine, found.operating_point))
    lines.append(
        _(
            "The block is rigid, its motion small; the crankshaft runs on evenly. The mean torque, "
            "what the driveline does, and the gyroscopic moment of the crankshaft are left out."
        )
    )
    return remarks(*lines, kind="note")


def _asked(engine: Engine, found: MountAnalysis) -> list[str]:
    """Of which point the vibration is, and over which speeds where they are assumed."""
    if found.over is None and found.at is None:
        return []
    point = told_point(engine, found.point)
    lines = [_("Vibration is that of the point {point}; see --at.", point=point)]
    if found.over is not None and found.range_assumed:
        low, high = (number(float(found.over.speeds[place]) * RPM) for place in (0, -1))
        lines.append(
            _(
                "The speeds {low} to {high} rpm are assumed, about the one that is known; see "
                "--speeds.",
                low=low,
                high=high,
            )
        )
    return lines


def _doubts(engine: Engine, found: MountAnalysis) -> list[str]:
    """What is missing, and what is hardly right."""
    lines = [fault.sentence for fault in (*body_doubts(engine), *mount_doubts(engine))]
    if found.block.has_feet:
        lines.append(
            _(
                "Feet give way by their receptances, each by itself; natural modes and the load at "
                "rest are those on feet that stand still."
            )
        )
    known = found.over or found.at
    if known is not None and known.excitation.without_gas:
        reason = known.excitation.without_gas.rstrip(".")
        lines.append(_("Without gas: {reason}.", reason=reason))
    return lines


def _assumed(found: MountAnalysis) -> list[str]:
    """What is assumed of the block and of its mounts."""
    lines = [*found.block.body.assumed]
    if any(each.assumed for each in found.block.mounts):
        lines.append(
            _(
                "Loss factor of mounts without damping: {value}, assumed; vibration at resonance "
                "goes with it.",
                value=number(RUBBER_LOSS_FACTOR),
            )
        )
    return lines
