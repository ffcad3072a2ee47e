"""A chain that twists as tables: masses and shafts, modes with their shapes and nodes, Holzer's."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from crankstar.analysis.document import Column, Table, Value, for_each
from crankstar.dynamics.torsion_modes import HolzerRow, Mode, Node
from crankstar.dynamics.torsion_system import TorsionChain
from crankstar.language.messages import _

STIFFNESS = 1e-3
"""From N m/rad to the kN m/rad that tables have."""


def mass_table(chain: TorsionChain) -> Table:
    """The masses from front to rear, each with what damps it and how it is geared."""
    columns = (
        Column(_("mass"), kind="text", key="name", label=True),
        Column(_("inertia"), "kg*m^2", key="inertia"),
        Column(_("speed ratio"), key="speed_ratio", machine=bool((chain.ratio == 1).all())),
        Column(
            _("damping to ground"),
            "N*m*s/rad",
            key="absolute_damping",
            fixed=True,
            machine=not chain.absolute_damping.any(),
        ),
    )
    rows = [
        (name, float(inertia), float(ratio), float(lost))
        for name, inertia, ratio, lost in zip(
            chain.names, chain.inertia, chain.ratio, chain.absolute_damping, strict=True
        )
    ]
    return Table(_("Masses"), columns, tuple(rows), key="masses")


def pendulum_table(chain: TorsionChain) -> Table:
    """Pendulum absorbers: where they swing, and the order that each holds back."""
    columns = (
        Column(_("pendulum on"), kind="text", key="on", label=True),
        Column(_("count"), key="count"),
        Column(_("mass of one"), "kg", key="mass"),
        Column(_("radius of the pivot"), "mm", key="radius"),
        Column(_("length"), "mm", key="length"),
        Column(_("holds back order"), key="order"),
    )
    rows = tuple(
        (
            chain.names[node],
            each.count,
            each.mass,
            each.radius * 1e3,
            each.length * 1e3,
            each.tuned_order,
        )
        for node, each in chain.pendulums
    )
    note = _(
        "A pendulum counts by the order: natural frequencies and shapes have it at rest, critical "
        "speeds, vector sums and the response as it swings."
    )
    return Table(_("Pendulums"), columns, rows, notes=(note,), key="pendulums")


def section_tables(chain: TorsionChain) -> tuple[Table, ...]:
    """The shafts between the masses, for readers along the chain."""
    columns = (
        Column(_("shaft"), kind="text", key="name", label=True),
        Column(_("stiffness"), "kN*m/rad", key="stiffness", fixed=True),
        Column(_("damping"), "N*m*s/rad", key="damping", fixed=True),
        Column(_("loss factor"), key="loss_factor"),
        Column(_("diameter"), "mm", key="diameter"),
        Column(_("bore"), "mm", key="bore"),
    )
    rows = [
        (
            chain.section_name(index),
            each.stiffness * STIFFNESS,
            each.damping,
            each.loss_factor,
            None if each.diameter is None else each.diameter * 1e3,
            each.bore * 1e3 if each.diameter is not None else None,
        )
        for index, each in enumerate(chain.sections)
    ]
    columns = (
        *columns[:2],
        *(
            replace(column, machine=not any(row[number] for row in rows))
            for number, column in enumerate(columns[2:], 2)
        ),
    )
    table = Table(_("Shafts between them"), columns, tuple(rows), key="sections")
    return for_each(replace(table, rows=tuple(rows[index] for index in chain.along)), table)


def mode_table(chain: TorsionChain, modes: Sequence[Mode]) -> Table:
    """Natural frequencies, with the shape [mass] and the nodes."""
    columns = (
        Column(_("mode"), key="mode", label=True),
        Column(_("frequency"), "Hz", key="frequency_hz", fixed=True, digits=6),
        Column(_("per minute"), "1/min", fixed=True, digits=6),
        Column(_("nodes"), kind="text", wraps=True),
        Column("", kind="list", key="shape", machine=True, names=tuple(chain.names)),
        Column("", kind="list", key="nodes", machine=True),
    )
    rows: list[tuple[Value, ...]] = [
        (
            mode.number,
            mode.frequency,
            mode.frequency * 60,
            "; ".join(_node(chain, node) for node in mode.nodes),
            tuple(map(float, mode.shape)),
            tuple((chain.names[node.before], chain.names[node.after]) for node in mode.nodes),
        )
        for mode in modes
    ]
    return Table(_("Natural frequencies"), columns, tuple(rows), key="modes")


def _node(chain: TorsionChain, node: Node) -> str:
    if node.before == node.after:
        return _("at {mass}", mass=chain.names[node.before])
    return _("{before} to {after}", before=chain.names[node.before], after=chain.names[node.after])


def shape_table(chain: TorsionChain, modes: Sequence[Mode]) -> Table:
    """The shapes side by side, masses from front to rear."""
    columns = (
        Column(_("mass"), kind="text", key="name", label=True),
        *(
            Column(_("mode {number}", number=mode.number), key=f"mode_{mode.number}")
            for mode in modes
        ),
    )
    rows = [
        (name, *(float(mode.shape[index]) for mode in modes))
        for index, name in enumerate(chain.names)
    ]
    return Table(_("Mode shapes"), columns, tuple(rows), key="shapes")


def holzer_table(mode: Mode, rows: Sequence[HolzerRow]) -> Table:
    """Holzer's table of a mode, as textbooks print it."""
    columns = (
        Column(_("mass"), kind="text", key="name", label=True),
        Column("J", "kg*m^2", key="inertia"),
        Column("J ω²", "kN*m/rad", key="inertia_torque", fixed=True, optional=1),
        Column("θ", key="amplitude"),
        Column("J ω² θ", "kN*m", key="torque", fixed=True),
        Column("Σ J ω² θ", "kN*m", key="sum", fixed=True),
        Column("k", "kN*m/rad", key="stiffness", fixed=True),
        Column(_("twist"), key="twist"),
    )
    scale = max((abs(row.sum) for row in rows), default=0.0)
    values: list[tuple[Value, ...]] = [
        (
            row.name,
            row.inertia,
            row.inertia_torque * STIFFNESS,
            row.amplitude,
            row.torque * STIFFNESS,
            row.sum * STIFFNESS if abs(row.sum) > 1e-9 * scale else 0.0,
            None if row.stiffness is None else row.stiffness * STIFFNESS,
            row.twist,
        )
        for row in rows
    ]
    title = _("Holzer's table of mode {number}", number=mode.number)
    return Table(title, columns, tuple(values), key="holzer")
