"""What gas does beside the torque, as tables: side thrust, uneven forces, handbook harmonics."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from math import degrees
from typing import Literal

import numpy as np

from crankstar.analysis.document import ROW_UNIT, Column, Table, Value
from crankstar.dynamics.uneven import Running
from crankstar.dynamics.uneven_forces import HIGHEST as HIGHEST_UNEVEN
from crankstar.dynamics.uneven_forces import changes, worth_telling
from crankstar.engine.engine import Engine
from crankstar.language.alike import as_given, of_any
from crankstar.language.messages import N_, _
from crankstar.language.numbers import numbers_text
from crankstar.language.shown_units import quantity_text
from crankstar.mechanics.gas import Cycle
from crankstar.mechanics.gas_loads import LoadedTorques
from crankstar.mechanics.side_thrust import SideThrust, greatest_side_thrust
from crankstar.spectra import Real

TANGENTIAL = 12.0
"""The highest order of tangential pressures that is listed."""
QUANTITIES = {"force": (N_("force"), "N"), "couple": (N_("couple"), "N*m")}


def side_thrust_tables(engine: Engine, cycle: Cycle) -> tuple[Table, Table]:
    """The maximum side thrust of each piston on both sides, and where it is.

    For readers pistons that press alike are one row, and angles count from the dead centre at which
    their cylinders fire; for machines each has its own, with crank angles.
    """
    thrust = greatest_side_thrust(engine, cycle)
    readers = _thrust_cells(thrust, _fires(engine, cycle), cycle)
    machines = _thrust_cells(thrust, dict.fromkeys(thrust.numbers, 0.0), cycle)
    groups: list[tuple[int, ...]] = as_given(("side thrust", engine.name), _alike(readers))
    head = _("cylinder") if all(len(group) == 1 for group in groups) else _("cylinders")
    after = _("after TDC") if cycle.motored else _("after firing")
    told = [(numbers_text(group), *readers[group[0]]) for group in groups]
    every = [(number, *cells) for number, cells in machines.items()]
    return (
        replace(_thrust_table(head, "text", after, told), audience="readers"),
        replace(
            _thrust_table(_("cylinder"), "number", _("crank angle"), every), audience="machines"
        ),
    )


def _thrust_cells(
    thrust: SideThrust, fires: Mapping[int, float], cycle: Cycle
) -> dict[int, tuple[float | None, ...]]:
    """Thrust on both sides with its angle, cylinder by cylinder."""
    whole = cycle.volumes.cycle
    return {
        number: (*_end(thrust.theta - fires[number], values, whole),
                 *_end(thrust.theta - fires[number], -values, whole))
        for number, values in zip(thrust.numbers, thrust.total, strict=True)
    }  # fmt: skip


def _thrust_table(
    head: str, kind: Literal["text", "number"], at: str, rows: Sequence[tuple[Value, ...]]
) -> Table:
    columns = (
        Column(head, key="cylinder", label=True, kind=kind),
        Column(_("thrust side"), "N", key="thrust_side"),
        Column(at, "deg", key="thrust_side_deg"),
        Column(_("other side"), "N", key="other_side"),
        Column(at, "deg", key="other_side_deg"),
    )
    title = _("Greatest side thrust of the pistons")
    return Table(title, columns, tuple(rows), key="side_thrust")


def _fires(engine: Engine, cycle: Cycle) -> dict[int, float]:
    """The firing angle of the chamber of each cylinder, radians."""
    of_chamber = dict(zip(cycle.volumes.numbers, cycle.volumes.fires.tolist(), strict=True))
    return {
        cylinder.number: of_chamber[number]
        for number, members in engine.chambers.items()
        for cylinder in members
    }


def _alike(cells: Mapping[int, Sequence[float | None]]) -> list[tuple[int, ...]]:
    """Cylinders with the same cells to three figures."""
    groups: dict[tuple[str, ...], list[int]] = {}
    for number, values in cells.items():
        key = tuple("" if value is None else f"{value:.3g}" for value in values[::2])
        groups.setdefault(key, []).append(number)
    return [tuple(group) for group in groups.values()]


def _end(theta: Real, values: Real, whole: float) -> tuple[float, float | None]:
    """The greatest value and where it is; nought and nowhere if there is none above nought."""
    at = int(np.argmax(values))
    if values[at] <= 0:
        return 0.0, None
    return float(values[at]), round(degrees(float(theta[at] % whole)), 9)


def changes_table(engine: Engine, running: Running) -> Table:
    """Orders of force and couple that uneven running changes by more than 1 %."""
    every = changes(engine, running)
    kept = of_any(("uneven", engine.name), worth_telling(every))
    columns = (
        Column("", kind="text", label=True, key="quantity"),
        Column(_("order"), key="order", label=True),
        Column(_("even speed"), ROW_UNIT, key="even"),
        Column(_("uneven speed"), ROW_UNIT, key="uneven"),
        Column(_("unit"), kind="unit", key="unit"),
    )
    rows = tuple(
        (_(QUANTITIES[c.quantity][0]), c.order, c.even, c.uneven, QUANTITIES[c.quantity][1])
        for c in every
        if (c.quantity, c.order) in kept
    )
    return Table(_("Forces that the uneven speed changes"), columns, rows, key="uneven_forces")


def unchanged_sentence() -> str:
    """That no order of force or couple is changed by the uneven speed."""
    return _(
        "Uneven running changes no order of force or couple up to {highest} by more than 1 % of "
        "the greatest.",
        highest=f"{HIGHEST_UNEVEN:g}",
    )


def tangential_table(found: LoadedTorques) -> Table:
    """The harmonics of the tangential pressure of one cylinder at each load, as amplitudes."""
    waves = np.abs(found.tangential)
    orders = found.torque.orders
    columns = [Column(_("order"), key="order", label=True)]
    columns += [
        Column(
            _("imep {pressure}", pressure=quantity_text(float(load), "Pa")),
            "Pa",
            key=f"imep {load / 1e5:g} bar",
        )
        for load in found.imep
    ]
    rows = tuple(
        (float(order), *map(float, waves[:, index]))
        for index, order in enumerate(orders)
        if order <= TANGENTIAL
    )
    return Table(
        _("Harmonics of the tangential pressure of one cylinder"),
        tuple(columns),
        rows,
        key="tangential",
    )
