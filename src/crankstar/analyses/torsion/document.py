"""Torsional vibration as tables: chain, modes, critical speeds, twist, stress, heat of damping."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from math import degrees
from typing import Any

import numpy as np

from crankstar.analyses.torsion.chain_tables import (
    holzer_table,
    mass_table,
    mode_table,
    pendulum_table,
    section_tables,
    shape_table,
)
from crankstar.analyses.torsion.fatigue_tables import fatigue_of, fatigue_tables
from crankstar.analyses.torsion.question import Question
from crankstar.analysis.document import Column, Document, Remarks, Table, Value, for_each, remarks
from crankstar.dynamics.torsion_analysis import SAME_ORDER, TorsionAnalysis
from crankstar.dynamics.torsion_criticals import Critical, stresses
from crankstar.dynamics.torsion_modes import holzer
from crankstar.dynamics.torsion_response import Response
from crankstar.engine.engine import Engine
from crankstar.engine.torsion import LOSS_FACTOR, STEEL, Chain
from crankstar.language.messages import _, _n
from crankstar.language.numbers import NEGLIGIBLE, RPM, number
from crankstar.mechanics.doubts import torsion_doubts
from crankstar.mechanics.gas import Cycle
from crankstar.spectra import Complex, Real
from crankstar.tables.gas_words import (
    burning_words,
    cycle_state,
    cycle_words,
    range_facts,
    range_words,
    state_facts,
    weaker_facts,
)
from crankstar.tables.headings import heading
from crankstar.tables.torque import assumed_notes
from crankstar.tables.torque import notes as cycle_notes

MODES = 4
"""How many are shown to readers, unless they ask."""
MPA = 1e-6


def document(source: Engine | Chain, found: TorsionAnalysis, asked: Question) -> Document:
    """All of an analysis, with Holzer's table of a mode that is asked for.

    At one speed orders of note are told, else those asked for. Raises TorsionError.
    """
    chain = found.chain
    told, every = found.modes[: asked.modes or MODES], found.modes[: asked.modes]
    parts: list[Table | Remarks] = [heading(source)] if isinstance(source, Engine) else []
    parts += [mass_table(chain), *section_tables(chain), *for_each(*[pendulum_table(chain)] * 2)]
    parts += for_each(mode_table(chain, told), mode_table(chain, every))
    parts += for_each(shape_table(chain, told), shape_table(chain, every)) if every else ()
    if asked.holzer is not None:
        mode = found.modes[asked.holzer - 1]
        parts.append(holzer_table(mode, holzer(chain, speed=mode.speed)))
    parts += _critical_tables(found)
    if found.response is not None:
        parts.append(_over_speeds(found, found.response))
        parts += [_worst_table(found, found.response)] if chain.sections else []
    if found.at is not None:
        parts += [_section_table_at(found.at, found.exact, found.cycle)] if chain.sections else []
        parts.append(_order_table(found, found.at, asked.orders))
    heat = found.at or found.response
    if heat is not None and (heat.heat.any() or heat.absolute_heat.any()):
        parts.append(_heat_table(heat))
    parts += for_each(*[_barred_table(found)] * 2)
    fatigue, why = fatigue_of(source, found) if isinstance(source, Engine) else (None, "")
    if fatigue is not None and isinstance(source, Engine):
        parts += fatigue_tables(source, found, fatigue)
    parts += [*remarks(*_notes(source, found), kind="note"), *_doubts(source, found, why)]
    facts = _facts(source, found) | ({"without_fatigue": why} if why else {})
    return Document(source.name, tuple(parts), facts)


def _facts(source: Engine | Chain, found: TorsionAnalysis) -> dict[str, Any]:
    cycle = found.cycle
    return {
        "format": 1,
        "chain" if isinstance(source, Chain) else "engine": source.name,
        **state_facts(None if cycle is None else cycle_state(cycle)),
        "speed_rpm": None if cycle is None or cycle.speed is None else cycle.speed * RPM,
        "gas_over_speeds": range_facts(source, found.point) if isinstance(source, Engine) else [],
        "imep": None if cycle is None else cycle.imep,
        "off": [] if cycle is None else list(cycle.off),
        "weaker": weaker_facts(cycle),
        "without_gas": found.without_gas or None,
        "free_end": found.chain.names[found.free_end],
        "assumed": [*found.chain.assumed, *(() if cycle is None else cycle.assumed)],
        "estimated_stiffness": list(found.chain.estimated),
        "shear_limit": found.limit,
        "units": {
            "inertia": "kg*m^2",
            "stiffness": "kN*m/rad",
            "damping": "N*m*s/rad",
            "torque": "N*m",
            "stress": "MPa",
            "heat": "W",
        },
    }


def _critical_tables(found: TorsionAnalysis) -> tuple[Table, ...]:
    """Where orders meet modes; for readers those of note."""
    columns = (
        Column(_("mode"), key="mode", label=True),
        Column(_("order"), key="order", label=True),
        Column(_("speed"), "rpm", key="speed_rpm"),
        Column(_("vector sum"), key="vector_sum"),
        Column(_("torque of excitation"), "N*m", key="torque"),
        Column(_("equilibrium amplitude"), "deg", key="equilibrium_deg"),
    )
    rows: dict[Critical, tuple[Value, ...]] = {
        each: (
            each.mode,
            each.order,
            each.speed * RPM,
            each.vector_sum,
            each.torque,
            None if each.equilibrium is None else degrees(each.equilibrium),
        )
        for each in found.criticals
    }
    told = sorted(found.noted, key=lambda each: (each.mode, -each.speed))
    left = len(found.criticals) - len(told)
    said = _n(
        "{count} more is left out, in which the cylinders hardly join; --json has it.",
        "{count} more are left out, in which the cylinders hardly join; --json has them.",
        left,
        count=left,
    )
    if found.cycle is None and found.chain.cylinders:
        said = _("Without gas those of the first mode are listed; --json has all.")
    title, notes = _("Critical speeds"), (said,) if left else ()
    return for_each(
        Table(title, columns, tuple(rows[each] for each in told), notes, key="criticals"),
        Table(title, columns, tuple(rows.values()), key="criticals"),
    )


def _over_speeds(found: TorsionAnalysis, own: Response) -> Table:
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
            float(own.speeds[place] * RPM),
            degrees(turns[place]),
            _list(peak[place]),
            _list(sums[place]),
            _list(stress[place] * MPA),
            _list(added[place] * MPA),
            _list(heat[place]),
        )
        for place in range(own.speeds.size)
    ]
    title = _("Response")
    return Table(title, columns, tuple(rows), key="response", audience="machines")


def _list(values: Real) -> tuple[float | None, ...]:
    return tuple(None if np.isnan(each) else float(each) for each in values)


def _worst_table(found: TorsionAnalysis, own: Response) -> Table:
    """The greatest torque and stress of each shaft over the speeds."""
    peak, added = own.peak, own.added
    worst = np.argmax(peak, axis=0)
    here = np.arange(peak.shape[1])
    title = _(
        "Greatest vibration between {low} and {high} rpm",
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


def _section_table_at(own: Response, exact: Response | None, cycle: Cycle | None) -> Table:
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
    columns = [
        Column(_("shaft"), kind="text", key="name", label=True),
        *([] if speeds is None else [Column(_("at speed"), "rpm", key="speed_rpm")]),
        Column(_("torque"), "N*m", key="torque"),
        Column(_("sum of amplitudes"), "N*m", key="torque_sum"),
    ]
    if with_stress:
        columns += [
            Column(_("shear stress"), "MPa", key="stress", fixed=True),
            Column(_("sum of amplitudes"), "MPa", key="stress_sum", fixed=True),
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


def _order_table(
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
        (float(order), complex(turns[place]), *((complex(torque[place, worst]),) if name else ()))
        for place, order in enumerate(own.orders)
        if (abs(turns[place]) > least if asked is None else _is_among(order, asked))
    ]
    return Table(_("By order at this speed"), tuple(columns), tuple(rows), key="orders")


def _without_rounding(amplitudes: Complex) -> Complex:
    """Amplitudes of all orders, zero where there is nothing beside the greatest."""
    size = np.abs(amplitudes)
    return np.where(size > NEGLIGIBLE * size.max(initial=0.0), amplitudes, 0j)


def _is_among(order: float, asked: Sequence[float]) -> bool:
    return any(abs(order - each) < SAME_ORDER for each in asked)


def _heat_table(own: Response) -> Table:
    """Where the work of the excitation goes, at the speed at which it is greatest."""
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


def _barred_table(found: TorsionAnalysis) -> Table:
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


def _notes(source: Engine | Chain, found: TorsionAnalysis) -> list[str]:
    """What it rests on, and what is left out."""
    lines = [
        _(
            "Rigid turns of the whole are left out; a shape is 1 at the first mass that a shaft "
            "holds."
        )
    ]
    if not found.modes:
        lines = [_("Nothing twists: all masses are rigidly coupled, or by a fluid alone.")]
    if found.chain.rings:
        lines.append(
            _("A ring that its fluid alone takes along stands still in the natural frequencies.")
        )
    if isinstance(source, Chain):
        return lines
    if any(shaft.weights and not shaft.throws for shaft in source.shafts):
        lines.append(_("Balance shafts are in it where the table [torsion] has them as discs."))
    if not found.speeds.size:
        lines.append(_("Without a speed nothing is driven: give --speeds, or speed in the file."))
        return lines
    if found.response is None:
        lines.append(_("Without masses and without gas nothing is driven."))
        return lines
    if found.cycle is not None:
        lines += cycle_notes(source, found.cycle)
        lines.append(range_words(source, found.point))
        if found.at is not None:
            lines.append(cycle_words(source, found.cycle))
    if found.range_assumed:
        lines.append(_("The range of speeds is taken about the one that is known; see --speeds."))
    lines.append(
        _(
            "Torque and stress are those of vibration: the greatest over a cycle, orders with "
            "their phases, beside the sum of all amplitudes; without the mean torque, and without "
            "the concentration of stress at fillets and oil holes."
        )
    )
    return lines


def _doubts(source: Engine | Chain, found: TorsionAnalysis, unfit: str) -> tuple[Remarks, ...]:
    """What is doubtful of the chain, and what is missing of the excitation.

    `unfit`: why there is no fatigue, though it is asked for.
    """
    lines: list[str] = []
    if isinstance(source, Engine):
        lines += [fault.sentence for fault in torsion_doubts(source)]
    if found.response is not None and not found.chain.damped:
        lines.append(
            _(
                "Nothing damps: at a critical speed the vibration has no bound, and near one what "
                "is printed means little; give torsion.damping or torsion.loss_factor."
            )
        )
    if found.without_gas:
        lines.append(_("Without gas: {reason}.", reason=found.without_gas.rstrip(".")))
    if found.response is not None and found.response.without_inertia:
        lines.append(_("Without masses there is no inertia torque: this is gas alone."))
    if unfit:
        lines.append(_("Without fatigue: {reason}.", reason=unfit.rstrip(".")))
    return (*remarks(*lines, kind="doubt"), *remarks(*_assumed(source, found), kind="assumed"))


def _assumed(source: Engine | Chain, found: TorsionAnalysis) -> list[str]:
    """What is assumed of the shafts and of the cycle."""
    lines: list[str] = []
    if found.chain.estimated:
        lines.append(
            _("The stiffness between the throws is estimated from their dimensions by a formula.")
        )
    if "torsion.dimensions.shear_modulus" in found.chain.assumed:
        lines.append(_("Shear modulus: {value} GPa, assumed.", value=number(STEEL / 1e9)))
    if any(name.endswith("loss_factor") for name in found.chain.assumed):
        value = number(LOSS_FACTOR)
        if found.response is None:
            lines.append(_("Assumed: {paths}.", paths=f"loss_factor ({value})"))
        else:
            lines.append(
                _(
                    "Loss factor of the shafts: {value}, assumed; amplitudes at resonance go with "
                    "it.",
                    value=value,
                )
            )
    if found.cycle is not None and isinstance(source, Engine):
        lines += assumed_notes(source, found.cycle)
    return lines
