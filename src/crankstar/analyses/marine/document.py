"""External and guide-force moments as tables, in the manner of a project guide."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from math import degrees
from typing import Any

import numpy as np

from crankstar.analyses.marine.doubts import doubts, power_text
from crankstar.analyses.marine.marine_analysis import MarineAnalysis
from crankstar.analyses.marine.question import Question
from crankstar.analysis.document import Column, Document, Remarks, Table, Value, for_each, remarks
from crankstar.engine.engine import Engine
from crankstar.language.messages import N_, _, _n
from crankstar.language.numbers import RPM, number, order_text, rpm_of
from crankstar.mechanics import guide_moments as guides
from crankstar.mechanics.balance import scales, unit_unbalance
from crankstar.mechanics.external_moments import (
    NOTED,
    USUAL,
    ExternalMoments,
    Wanted,
    unbalance_class,
)
from crankstar.mechanics.guide_moments import GuideMoments
from crankstar.tables.gas_words import cycle_state, cycle_words, state_facts
from crankstar.tables.headings import heading

MM = 1e3
OF_GUIDES = {"moment": ("kN*m",), "power": ("kW",)}
"""The units of project guides, whatever the size of the engine."""
CLASSED = (1.0, 2.0)
"""Orders for which the makers class the power-related unbalance."""
SILENT = 1e-9
"""Share of the greatest moment below which one has no phase to tell."""


def document(engine: Engine, found: MarineAnalysis, question: Question) -> Document:
    """All of an analysis, of the engine with what is added to it."""
    engine, bracing = found.engine, question.bracing
    parts: list[Table | Remarks] = [heading(engine), _moment_table(found)]
    if found.compensators:
        parts.append(_compensator_table(found))
    if found.guide is not None:
        told, every = (
            _guide_places(found.guide, found.orders, every=each) for each in (False, True)
        )
        parts += for_each(
            guide_table(found.guide, bracing, places=told),
            guide_table(found.guide, bracing, places=every),
        )
    if found.speeds.size and found.after.speed is not None:
        parts.append(_speed_table(found))
    parts += remarks(*_notes(found, bracing), kind="note")
    parts += remarks(*doubts(found, bracing), kind="doubt")
    return Document(engine.name, tuple(parts), _facts(found, bracing))


def _facts(found: MarineAnalysis, bracing: tuple[float, float] | None) -> dict[str, Any]:
    guide = found.guide
    return {
        "format": 1,
        "engine": found.engine.name,
        "speed_rpm": rpm_of(found.after.speed),
        "power_kw": None if found.power is None else found.power / 1e3,
        **state_facts(None if found.cycle is None else cycle_state(found.cycle)),
        "about": found.after.z,
        "node": None if found.at_node is None else found.at_node[1].z,
        "horizontal_share": found.end_weights,
        "phase_error_deg": degrees(found.phase_error),
        "bracing": None if bracing is None else list(bracing),
        "guide_length": None if guide is None else guide.length,
        "with_inertia": None if guide is None else guide.with_inertia,
        "without_guide": found.without_guide or None,
        "units": {"moment": found.after.units.couple, "force": found.after.units.force},
    }


def _moment_table(found: MarineAnalysis) -> Table:
    """M_kV and M_kH, as they were where something was added, about the node, over the power."""
    after, units = found.after, found.after.units
    changed = bool(found.compensators) or found.end_weights is not None
    columns = [Column(_("order"), key="order", label=True)]
    if changed:
        columns += [
            Column(_("M_V before"), units.couple, key="vertical_before"),
            Column(_("M_H before"), units.couple, key="horizontal_before"),
        ]
    columns += [
        Column(_("M_V, vertical"), units.couple, "wave", key="vertical"),
        Column(_("M_H, horizontal"), units.couple, "wave", key="horizontal"),
    ]
    with_force = bool(after.pushing)
    if with_force:
        columns.append(Column(_("force, vertical"), units.force, key="force_vertical"))
        columns.append(Column(_("force, horizontal"), units.force, key="force_horizontal"))
    if found.at_node is not None:
        columns.append(Column(_("M_V about the node"), units.couple, "wave", key="at_node"))
    if found.power is not None and units.couple == "N*m":
        columns.append(Column(_("over the power"), "N*m/kW", key="unbalance", digits=3))
        columns.append(Column(_("compensator"), kind="text", key="compensator"))
    rows: list[tuple[Value, ...]] = []
    for order in after.orders.tolist():
        row: list[Value] = [order]
        if changed:
            row += [found.before.moment(order), found.before.moment(order, "H")]
        row += [_wave(after, after.vertical, order), _wave(after, after.horizontal, order)]
        if with_force:
            row += [
                abs(_wave(after, after.force_vertical, order)),
                abs(_wave(after, after.force_horizontal, order)),
            ]
        if found.at_node is not None:
            row.append(_wave(found.at_node[1], found.at_node[1].vertical, order))
        if found.power is not None and units.couple == "N*m":
            value = found.unbalance(_greater(found, order)) or 0.0
            row += [value, _(unbalance_class(value)) if order in CLASSED else ""]
        rows.append(tuple(row))
    title = _("External moments")
    if after.speed is not None:
        title = _("External moments at {rpm} rpm", rpm=number(round(after.speed * RPM, 6)))
    return Table(title, tuple(columns), tuple(rows), key="moments", usual=OF_GUIDES)


def _wave(moments: ExternalMoments, values: np.ndarray, order: float) -> complex:
    """The amplitude of an order, nought where rounding leaves it alone."""
    value = complex(values[np.abs(moments.orders - order) < 1e-9].sum())
    beside = (moments.vertical, moments.horizontal)
    if values is moments.force_vertical or values is moments.force_horizontal:
        beside = (moments.force_vertical, moments.force_horizontal)
    greatest = float(np.abs(beside).max(initial=0.0))
    return value if abs(value) > SILENT * greatest else 0j


def _greater(found: MarineAnalysis, order: float) -> float:
    """The greater of M_V and M_H of an order, about the node where there is one."""
    moments = found.after if found.at_node is None else found.at_node[1]
    return max(moments.moment(order), moments.moment(order, "H"))


def _compensator_table(found: MarineAnalysis) -> Table:
    """The masses of each compensator, and its force at the speed of the analysis."""
    engine = found.engine
    scale, units = scales(engine, found.after.speed)
    in_pitches = "pitch" in engine.relative
    weighed = {"mass", "radius"}.isdisjoint(engine.relative)
    unit = 1.0 if weighed else unit_unbalance(engine)
    mass = "kg*m" if weighed else "m*r"
    columns = (
        Column(_("order"), key="order", label=True),
        Column(_("place along the crankshaft"), "a" if in_pitches else "mm", key="z", fixed=True),
        Column(_("mass x radius of each of two"), mass, key="unbalance", fixed=True),
        Column(_("force, vertical"), units.force, "wave", key="force"),
    )
    rows = tuple(
        (
            each.order,
            each.z * (1.0 if in_pitches else MM),
            each.unbalance / unit,
            complex(each.force * scale.force),
        )
        for each in found.compensators
    )
    return Table(_("Compensators"), columns, rows, key="compensators")


def guide_table(
    guide: GuideMoments,
    bracing: tuple[float, float] | None = None,
    *,
    places: Mapping[float, int | None] | None = None,
) -> Table:
    """H and X of each order of note, and what they push the top bracings with.

    `places`: orders instead, and where they are; None: such an order has no moments.
    """
    columns = [
        Column(_("order"), key="order", label=True),
        Column(_("H-moment"), "N*m", "wave", key="h"),
    ]
    if guide.pitch_known:
        columns.append(Column(_("X-moment"), "N*m", "wave", key="x"))
        columns.append(Column("", "N*m^2", "signal", key="bimoment", machine=True))
    if bracing is not None:
        columns.append(Column(_("top bracings, H"), "N", key="bracing_h"))
        if guide.pitch_known:
            columns.append(Column(_("each end, X"), "N", key="bracing_x"))
    rows: list[tuple[Value, ...]] = []
    for order, place in (_guide_places(guide) if places is None else places).items():
        h, bimoment = 0j, 0j
        if place is not None:
            h, bimoment = complex(guide.h[place]), complex(guide.bimoment[place])
        row: list[Value] = [order, h]
        if guide.pitch_known:
            row += [bimoment / guide.length, bimoment]
        if bracing is not None:
            row.append(abs(h) / bracing[0])
            if guide.pitch_known:
                row.append(abs(bimoment) / (bracing[0] * bracing[1]))
        rows.append(tuple(row))
    return Table(
        _("Guide-force moments"), tuple(columns), tuple(rows), key="guide", usual=OF_GUIDES
    )


def _guide_places(
    guide: GuideMoments, orders: Wanted = None, *, every: bool = False
) -> dict[float, int | None]:
    """The orders that are told and their places, None of one that does not occur.

    Those that were asked for, else those of note; `every`: all that the record has.
    """
    if orders is not None and not isinstance(orders, str):
        near = {order: np.flatnonzero(np.abs(guide.orders - order) < 1e-9) for order in orders}
        return {order: int(at[0]) if at.size else None for order, at in sorted(near.items())}
    chosen = guide.noted() if orders is None else guide.noted(0.0)
    return (
        {float(guide.orders[place]): place for place in chosen}
        if not every
        else {float(order): index for index, order in enumerate(guide.orders)}
    )


def _speed_table(found: MarineAnalysis) -> Table:
    """The usual external moments, and those asked for, at other speeds: by the speed squared."""
    after = found.usual
    more = () if found.orders is None or isinstance(found.orders, str) else found.orders
    wanted = sorted({*USUAL, *more})
    asked = [(f"M_{order:g}{side}", order, side) for order in wanted for side in "VH"]
    asked = [each for each in asked if each[1:] == (1.0, "H") or each[2] == "V"]
    columns = [Column(_("speed"), "rpm", key="speed_rpm", label=True)]
    columns += [
        Column(name, after.units.couple, key=name.replace("_", "").lower())
        for name, _order, _side in asked
    ]
    rows = tuple(
        (
            float(speed * RPM),
            *(after.moment(order, side) * after.at(float(speed)) for _n, order, side in asked),
        )
        for speed in found.speeds
    )
    title = _("External moments over the speeds")
    return Table(title, tuple(columns), rows, key="speeds", usual=OF_GUIDES)


def _notes(found: MarineAnalysis, bracing: tuple[float, float] | None) -> list[str]:
    """What the numbers mean, and what is left out."""
    lines = [_about(found.after.pushing)]
    if found.end_weights is not None:
        share = number(round(100 * found.end_weights, 6))
        lines.append(
            _(
                "Weights at the ends of the crankshaft make {share} % of the first-order moment "
                "horizontal.",
                share=share,
            )
        )
    if found.compensators:
        lines.append(_(COMPENSATED))
    if found.phase_error:
        late = number(round(degrees(found.phase_error), 6))
        left = number(float(f"{200 * np.sin(abs(found.phase_error) / 2):.4g}"))
        lines.append(
            _(
                "Compensators that are {late} deg of their own turn late leave {left} % of what "
                "they should cancel.",
                late=late,
                left=left,
            )
        )
    if found.power is not None and found.after.units.couple == "N*m":
        lines.append(_(OVER_POWER, power=power_text(found.power)))
    if found.guide is not None and found.guide.pitch_known:
        lines.append(
            _(
                "X is the bimoment over the rod length, {length} m; forces of X are those of each "
                "of two planes of top bracing.",
                length=number(round(found.guide.length, 6)),
            )
            if bracing is not None
            else _(
                "X is the bimoment over the rod length, {length} m.",
                length=number(round(found.guide.length, 6)),
            )
        )
    if found.orders is None:
        lines += _shares(found.guide)
    if found.cycle is not None:
        lines.append(cycle_words(found.engine, found.cycle))
    lines.append(_("Axial vibration, and what the propeller does, are left out."))
    return lines


def _about(pushing: Sequence[float]) -> str:
    """About which point the moments are, and in which orders that matters."""
    if not pushing:
        return _(
            "Moments are about the middle of the cylinders; since the forces of the moving parts "
            "add up to nothing, they are the same about any point."
        )
    return _n(
        "Moments are about the middle of the cylinders; a force of order {orders} remains, so that "
        "the moment of this order differs about other points: see `crankstar marine --node`.",
        "Moments are about the middle of the cylinders; forces of orders {orders} remain, so that "
        "the moments of these orders differ about other points: see `crankstar marine --node`.",
        len(pushing),
        orders=", ".join(map(order_text, pushing)),
    )


def _shares(guide: GuideMoments | None) -> list[str]:
    """From which share orders are told, where none were asked for."""
    external = number(100 * NOTED)
    if guide is None:
        return [_(TOLD, external=external)]
    return [_(TOLD_OF_BOTH, external=external, guide=number(100 * guides.NOTED))]


TOLD = N_(
    "Orders of external moments are told from {external} % of the greatest, and 1, 2 and 4 always; "
    "`crankstar marine --orders` has others, or all."
)
TOLD_OF_BOTH = N_(
    "Orders of external moments are told from {external} % of the greatest, and 1, 2 and 4 always, "
    "those of guide-force moments from {guide} % of the greatest H or X; `crankstar marine "
    "--orders` has others, or all."
)
COMPENSATED = N_(
    "Each compensator is two equal masses that turn against each other at so many times the crank "
    "speed, by chain, gear or motor."
)
OVER_POWER = N_(
    "Over the power: the greater of M_V and M_H, about the node if there is one, set against "
    "the brake power, {power}; the need of a compensator is that of MAN B&W's table for orders 1 "
    "and 2."
)
