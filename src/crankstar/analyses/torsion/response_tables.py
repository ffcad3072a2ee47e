"""The forced vibration of a crankshaft as tables: over the speeds, at one, heat, barred ranges."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from math import degrees

import numpy as np

from crankstar.analysis.document import Column, Table, Value
from crankstar.dynamics.torsion_analysis import SAME_ORDER, TorsionAnalysis
from crankstar.dynamics.torsion_criticals import stresses
from crankstar.dynamics.torsion_response import Response
from crankstar.language.messages import _
from crankstar.language.numbers import NEGLIGIBLE, RPM, number
from crankstar.mechanics.gas import Cycle
from crankstar.spectra import Complex, Real
from crankstar.tables.gas_words import burning_words

MPA = 1e-6


def response_table(found: TorsionAnalysis, own: Response) -> Table:
    """The whole response for machines, speed by speed; lists go over the shafts."""
    stress, added = stresses(own)
    names = tuple(map(found.chain.section_name, range(len(found.chain.sections))))
    columns = (
        Column(_("speed"), "rpm", key="speed_rpm"),
        Column(_("free end"), "deg", key="free_end_deg"),
        Column(_("torque"), "N*m", kind="list", key="torque", names=names),
        Column(_("sum of amplitudes"), "N*m", kind="list", key="torque_sum", names=names),
        Column(_("shear stress"), "MPa", kind="list", key="stress", fixed=True, names=names),
        Column(
            _("sum of amplitudes"), "MPa", kind="list", key="stress_sum", fixed=True, names=names
        ),
        Column(_("heat"), "W", kind="list", key="heat", fixed=True, names=names),
    )
    turns, peak, sums, heat = own.peak_turn(found.free_end), own.peak, own.added, own.heat
    rows = [
        (
            float(own.speeds[index] * RPM),
            degrees(turns[index]),
            _list(peak[index]),
            _list(sums[index]),
            _list(stress[index] * MPA),
            _list(added[index] * MPA),
            _list(heat[index]),
        )
        for index in range(own.speeds.size)
    ]
    title = _("Response")
    return Table(title, columns, tuple(rows), key="response", audience="machines")


def _list(values: Real) -> tuple[float | None, ...]:
    return tuple(None if np.isnan(each) else float(each) for each in values)


def worst_table(found: TorsionAnalysis, own: Response) -> Table:
    """The maximum torque and stress of each shaft over the speeds."""
    peak, added = own.peak, own.added
    worst = np.argmax(peak, axis=0)
    here = np.arange(peak.shape[1])
    title = _(
        "Maximum vibration between {low} and {high} rpm",
        low=number(float(own.speeds[0] * RPM)),
        high=number(float(own.speeds[-1] * RPM)),
    )
    if found.cycle is not None:
        title = burning_words(title, found.cycle)
    turns = own.peak_turn(found.free_end)
    top = int(np.argmax(turns))
    note = _(
        "The free end, {mass}, turns by up to {angle} deg to either side, at {rpm} rpm; uneven "
        "running of the whole is in it.",
        mass=found.chain.names[found.free_end],
        angle=number(degrees(turns[top])),
        rpm=number(float(own.speeds[top] * RPM)),
    )
    speeds = [float(own.speeds[place] * RPM) for place in worst]
    return _sections(
        title, own, peak[worst, here], added[worst, here], speeds, (note,), key="greatest"
    )


def section_table_at(own: Response, exact: Response | None, cycle: Cycle | None) -> Table:
    """Torque and stress of each shaft at one speed, and with the inertia of each angle."""
    title = _("Vibration at {rpm} rpm", rpm=number(float(own.speeds[0] * RPM)))
    if cycle is not None:
        title = burning_words(title, cycle)
    table = _sections(title, own, own.peak[0], own.added[0], None, (), key="sections_at_speed")
    if exact is None:
        return table
    heading = _("torque, inertia of each angle")
    column = Column(heading, "N*m", key="torque_of_each_angle", optional=1)
    rows = tuple(
        (*row, float(exact.peak[0, index]))
        for row, index in zip(table.rows, own.chain.along, strict=True)
    )
    return replace(table, columns=(*table.columns, column), rows=rows)


def _sections(
    title: str,
    own: Response,
    peak: Real,
    added: Real,
    speeds: Sequence[float] | None,
    said: tuple[str, ...],
    *,
    key: str = "",
) -> Table:
    """Shafts with their torque over the cycle and the sum of the amplitudes of all orders."""
    chain = own.chain
    with_stress = chain.stressed
    sums = _("sum of amplitudes") if speeds is None else _("sum of amplitudes there")
    columns = [
        Column(_("shaft"), kind="text", key="name", label=True),
        *([] if speeds is None else [Column(_("at speed"), "rpm", key="speed_rpm")]),
        Column(_("torque"), "N*m", key="torque"),
        Column(sums, "N*m", key="torque_sum"),
    ]
    if with_stress:
        columns += [
            Column(_("shear stress"), "MPa", key="stress", fixed=True),
            Column(sums, "MPa", key="stress_sum", fixed=True),
        ]
    rows: list[tuple[Value, ...]] = []
    for index in chain.along:
        each = chain.sections[index]
        row: list[Value] = [chain.section_name(index)]
        row += [] if speeds is None else [speeds[index]]
        row += [float(peak[index]), float(added[index])]
        if with_stress:
            unit = each.modulus
            row += [None if unit is None else float(v[index]) / unit * MPA for v in (peak, added)]
        rows.append(tuple(row))
    return Table(title, tuple(columns), tuple(rows), said, key=key)


def order_table(
    found: TorsionAnalysis, own: Response, asked: Sequence[float] | None = None
) -> Table:
    """The free end and the most twisted shaft, order by order, at one speed."""
    worst = int(np.argmax(own.peak[0])) if own.chain.sections else 0
    name = own.chain.section_name(worst) if own.chain.sections else ""
    columns = [
        Column(_("order"), key="order", label=True),
        Column(_("free end"), "deg", kind="wave", key="free_end"),
    ]
    if name:
        heading = _("torque in {shaft}", shaft=name)
        columns.append(Column(heading, "N*m", kind="wave", key="torque"))
    turns = _without_rounding(np.degrees(1) * own.turns[0, :, found.free_end])
    torque = _without_rounding(own.torque[0])
    least = 1e-3 * float(np.abs(turns).max(initial=0.0))
    rows = [
        (float(order), complex(turns[index]), *((complex(torque[index, worst]),) if name else ()))
        for index, order in enumerate(own.orders)
        if (abs(turns[index]) > least if asked is None else _is_among(order, asked))
    ]
    return Table(_("By order at this speed"), tuple(columns), tuple(rows), key="orders")


def _without_rounding(amplitudes: Complex) -> Complex:
    """Amplitudes of all orders, zero where there is nothing beside the maximum."""
    size = np.abs(amplitudes)
    return np.where(size > NEGLIGIBLE * size.max(initial=0.0), amplitudes, 0j)


def _is_among(order: float, asked: Sequence[float]) -> bool:
    return any(abs(order - each) < SAME_ORDER for each in asked)


def heat_table(own: Response) -> Table:
    """Where the work of the excitation goes, at the speed of its maximum."""
    whole = own.heat.sum(axis=-1) + own.absolute_heat.sum(axis=-1)
    top = int(np.argmax(whole))
    rpm = float(own.speeds[top] * RPM)
    rows: list[tuple[Value, ...]] = [
        (own.chain.section_name(index), rpm, float(value))
        for index in own.chain.along
        if (value := own.heat[top, index]) > 0
    ]
    rows += [
        (_("{mass} to ground", mass=own.chain.names[node]), rpm, float(value))
        for node, value in enumerate(own.absolute_heat[top])
        if value > 0
    ]
    columns = (
        Column(_("where"), kind="text", key="name", label=True),
        Column("", "rpm", key="speed_rpm", machine=True),
        Column(_("heat"), "W", key="heat", fixed=True),
    )
    title = _("Heat of damping at {rpm} rpm", rpm=number(rpm))
    return Table(title, columns, tuple(rows), key="heat")


def barred_table(found: TorsionAnalysis) -> Table:
    """The speeds at which a shaft has more stress than the limit."""
    columns = (
        Column(_("from"), "rpm", key="low_rpm"),
        Column(_("to"), "rpm", key="high_rpm"),
        Column(_("shaft"), kind="text", key="name", label=True),
    )
    rows = [
        (each.low * RPM, each.high * RPM, found.chain.section_name(each.section))
        for each in found.barred
    ]
    return Table(_("Barred speeds"), columns, tuple(rows), key="barred")
