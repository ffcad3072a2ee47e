"""Gears between crankshafts as a table: what each mesh passes on, the flywheel here or there."""

from __future__ import annotations

from collections.abc import Sequence
from math import degrees

from crankstar.analysis.document import Column, Table, Value
from crankstar.dynamics.meshes import Mesh, meshes, shares
from crankstar.dynamics.uneven import Running
from crankstar.engine.drive import Drive
from crankstar.engine.engine import Engine
from crankstar.language.messages import _
from crankstar.mechanics.gas import Cycle


def mesh_table(engine: Engine, cycle: Cycle, *, running: Running | None = None) -> Table | None:
    """Every mesh, None for an engine with one crankshaft.

    Where the file does not say how the inertia is shared, twice: alike, and all with the load.
    """
    found = meshes(engine, cycle, running=running)
    if not found:
        return None
    if not (engine.drive or Drive()).inertia_shares:
        beside = shares(engine, with_load=True)
        found += meshes(engine, cycle, running=running, inertia_shares=beside)
    columns = [
        Column(_("crankshaft"), kind="text", key="crankshaft", label=True, wraps=True),
        Column(_("geared to"), kind="text", label=True, wraps=True),
        Column("", kind="text", key="onto", machine=True),
        Column("", key="idler", machine=True),
        Column(_("share of inertia"), key="inertia_share", digits=3, label=True),
        Column(_("mean torque"), "N*m", key="mean"),
        Column(_("least"), "N*m", key="least"),
        Column("θ", "deg", key="least_deg", machine=True),
        Column(_("greatest"), "N*m", key="greatest"),
        Column("θ", "deg", key="greatest_deg", machine=True),
        Column(_("reversals"), key="reversals"),
        Column("θ", kind="list", key="reversals_deg", machine=True),
        Column("", key="drives", machine=True),
        Column(_("work passed"), "J", key="work"),
        Column("", key="work_share", machine=True),
        Column(_("greatest force"), "N", key="force"),
        Column("", "mm", key="pitch_radius", machine=True),
    ]
    table = Table(
        _("Gears between crankshafts"),
        tuple(columns),
        tuple(_row(mesh) for mesh in found),
        notes=tuple(_notes(engine, found)),
        key="meshes",
    )
    if any(mesh.force is not None for mesh in found):
        return table
    return _without(table, {"force", "pitch_radius"})


def _row(mesh: Mesh) -> tuple[Value, ...]:
    wheel = mesh.wheel
    onto = _("the output") if wheel.onto is None else wheel.onto
    radius = wheel.pitch_radius
    least, greatest = mesh.least, mesh.greatest
    return (
        wheel.crankshaft,
        _("idler, {shaft}", shaft=onto) if wheel.idler else onto,
        wheel.onto,
        wheel.idler,
        mesh.share,
        mesh.mean,
        least[0],
        degrees(least[1]),
        greatest[0],
        degrees(greatest[1]),
        len(mesh.reversals),
        tuple(round(degrees(angle), 3) for angle in mesh.reversals),
        mesh.driving,
        mesh.work,
        mesh.work_share,
        mesh.force,
        None if radius is None else radius * 1e3,
    )


def _without(table: Table, keys: set[str]) -> Table:
    """The table without columns that have no values."""
    kept = [index for index, column in enumerate(table.columns) if column.key not in keys]
    return Table(
        table.title,
        tuple(table.columns[place] for place in kept),
        tuple(tuple(row[place] for place in kept) for row in table.rows),
        notes=table.notes,
        key=table.key,
    )


def _notes(engine: Engine, found: Sequence[Mesh]) -> list[str]:
    """What is positive, what the columns count, and what is assumed."""
    drive = engine.drive or Drive()
    lines = [
        _(
            "Positive where the crankshaft drives; at a reversal contact goes to the other flanks "
            "of the teeth. Work passed: in both directions, per cycle, a measure of wear."
        )
    ]
    if not drive.inertia_shares:
        lines.append(
            _(
                "What the gears carry depends on how the inertia is shared, which is assumed: "
                "alike by the crankshafts or, with share 0, all of it with the load. "
                "drive.inertia_shares gives it."
            )
        )
    if drive.output is None and drive.gearing != "output":
        lines.append(
            _(
                "The load is assumed to be on the crankshaft {shaft}; drive.output names another, "
                'and drive.gearing = "output" gears each crankshaft to the output.',
                shaft=_root(found),
            )
        )
    if any(mesh.force is None for mesh in found):
        lines.append(
            _("For the force on the teeth give drive.pitch_radius, the radius of the gear wheels.")
        )
    return lines


def _root(found: Sequence[Mesh]) -> str:
    """The crankshaft on which the load is: the one that is geared to no other."""
    geared = {mesh.wheel.crankshaft for mesh in found}
    return next(
        mesh.wheel.onto for mesh in found if mesh.wheel.onto and mesh.wheel.onto not in geared
    )
