"""Strokes, valve events, exhaust intervals, and cylinders that disturb each other."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import degrees
from typing import Any

import numpy as np

from crankstar.analyses.strokes.question import Question
from crankstar.analysis.document import Column, Document, Remarks, Table, Value, remarks
from crankstar.engine.engine import Engine
from crankstar.engine.valves import EVENTS
from crankstar.firing.exhaust_orders import exhaust_orders, firing_rate
from crankstar.firing.intervals import Firing
from crankstar.firing.strokes import (
    EVEN,
    ChamberStrokes,
    ExhaustGroup,
    Window,
    WorkingCycle,
    are_even,
    disturbances,
    exhaust_groups,
    exhaust_intervals,
)
from crankstar.firing.succession import Follower, in_succession, neighbours, partners
from crankstar.language.messages import _
from crankstar.language.numbers import number, order_text
from crankstar.spectra import Complex, Real
from crankstar.tables.headings import heading, timing_lines

HIGHEST = 4.0
"""The highest order of the exhaust that is listed."""


def document(engine: Engine, cycle: WorkingCycle, _question: Question) -> Document:
    """The working cycle of an engine."""
    return Document(
        engine.name, (heading(engine), *tables(engine, cycle)), facts=_facts(engine, cycle)
    )


def tables(engine: Engine, cycle: WorkingCycle) -> Iterator[Table | Remarks]:
    """The tables of a working cycle, without the heading of the engine."""
    groups = exhaust_groups(engine)
    assumed = _(
        "Assumed angles are typical of {cycle} engines; the table [valves] of the file "
        "gives others.",
        cycle=_(engine.cycle),
    )
    yield Remarks(
        (*_ring(cycle.firing), *timing_lines(engine), *([assumed] if cycle.timing.assumed else []))
    )
    yield _cylinders(cycle, groups)
    yield _exhausts(cycle, groups)
    yield _orders(engine)
    yield from _pulses(engine)
    yield _disturbances(cycle, groups)
    sides, pins = (in_succession(cycle.firing, of(engine)) for of in (neighbours, partners))
    yield from remarks(
        _("Neighbours that fire in succession: {pairs}.", pairs=succession_text(sides)),
        _("Cylinders on one pin that fire in succession: {pairs}.", pairs=succession_text(pins)),
    )


def _facts(engine: Engine, cycle: WorkingCycle) -> dict[str, Any]:
    fired = cycle.firing
    pairs = {"neighbours": neighbours, "partners": partners}
    return {
        "engine": engine.name,
        "cycle_deg": cycle.cycle_deg,
        "firing_order": list(fired.order),
        "firing_angles_deg": [round(angle, 9) for angle in fired.angles_deg],
        "firing_intervals_deg": list(fired.intervals_deg),
        "timing_deg": {
            name: float(f"{degrees(getattr(cycle.timing, name)):.12g}") for name in EVENTS
        },
        "assumed": list(cycle.timing.assumed),
        **{
            f"{name}_in_succession": [
                [step.first, step.then] for step in in_succession(fired, of(engine))
            ]
            for name, of in pairs.items()
        },
    }


def succession_text(steps: Sequence[Follower]) -> str:
    """Firings and the next ones with the angle between them: `5-7 (90 deg)`."""
    intervals = [number(round(step.interval_deg, 9)) for step in steps]
    pairs = zip(steps, intervals, strict=True)
    return ", ".join(f"{s.first}-{s.then} ({interval} deg)" for s, interval in pairs) or _("none")


def _ring(fired: Firing) -> list[str]:
    """Whether the firing is even, and the crank angle at which each cylinder fires."""
    places = ", ".join(
        _("{number} at {angle}", number=n, angle=number(round(a % fired.cycle_deg, 9)))
        for n, a in zip(fired.order, fired.angles_deg, strict=True)
    )
    where = _(
        "Firing angles in {cycle} deg: {places}.", cycle=f"{fired.cycle_deg:g}", places=places
    )
    if len(fired.order) > 1 and max(fired.intervals_deg) > fired.cycle_deg - EVEN:
        return [_("All cylinders fire together."), where]
    if fired.even:
        return [_("Even firing."), where]
    interval = number(fired.cycle_deg / len(fired.order))
    return [_("Odd firing; even intervals would be {interval} deg.", interval=interval), where]


def _cylinders(cycle: WorkingCycle, groups: Sequence[ExhaustGroup]) -> Table:
    """Every stroke and every event, as spans of crank angle."""
    names = {
        "power": _("power"),
        "exhaust": _("exhaust"),
        "intake": _("intake"),
        "compression": _("compression"),
    }
    strokes = [stroke.name for stroke in cycle.chambers[0].strokes]
    columns = (
        Column(_("cylinder"), key="number", label=True),
        Column(_("exhaust group"), kind="text", key="exhaust", wraps=True),
        Column(_("fires"), "deg", key="fires_deg", optional=1),
        *(Column(names[name], "deg", kind="span", key=f"strokes/{name}") for name in strokes),
        Column(_("exhaust open"), "deg", kind="span", key="exhaust_open"),
        Column(_("blow-down"), "deg", kind="span", key="blow_down"),
        Column(_("intake open"), "deg", kind="span", key="intake_open"),
    )
    home = {number: group.name for group in groups for number in group.chambers}
    rows = [
        (
            chamber.number,
            home[chamber.number],
            chamber.fires_deg,
            *(_span(window, cycle.cycle_deg) for window in _windows(chamber)),
        )
        for chamber in sorted(cycle.chambers, key=lambda chamber: chamber.number)
    ]
    return Table(_("Strokes and valve events"), columns, tuple(rows), key="cylinders")


def _windows(chamber: ChamberStrokes) -> list[Window]:
    return [
        *(stroke.window for stroke in chamber.strokes),
        chamber.exhaust,
        chamber.blow_down,
        chamber.intake,
    ]


def _span(window: Window, cycle: float) -> tuple[float, ...]:
    """A span of crank angle, its end counted within the cycle; empty where there is none."""
    if window.length_deg <= 0:
        return ()
    end = window.end_deg if window.end_deg <= cycle else window.end_deg - cycle
    return (round(window.start_deg, 9) + 0.0, round(end, 9) + 0.0)


def _exhausts(cycle: WorkingCycle, groups: Sequence[ExhaustGroup]) -> Table:
    """The order in which the exhausts of a group open, and the intervals between them."""
    columns = (
        Column(_("exhaust group"), kind="text", key="name", wraps=True),
        Column(_("cylinders"), kind="order", key="cylinders"),
        Column(_("intervals"), "deg", kind="order", key="intervals_deg", digits=4, wraps=True),
        Column("", kind="text"),
    )
    rows = []
    for group in groups:
        steps = exhaust_intervals(cycle, group.chambers)
        even = "" if len(steps) == 1 else _("even") if are_even(steps) else _("uneven")
        order = tuple(step.first for step in steps)
        rows.append((group.name, order, tuple(step.interval_deg for step in steps), even))
    alone = _(
        "Every cylinder has its own exhaust; valves.manifolds = [[1, 2], ...] in the engine file "
        "joins them."
    )
    notes = (alone,) if all(len(group.chambers) == 1 for group in groups) else ()
    return Table(_("Exhaust pulses"), columns, tuple(rows), notes=notes, key="exhausts")


def _orders(engine: Engine) -> Table:
    """|S_q| of every exhaust group of several cylinders and of the engine."""
    found = exhaust_orders(engine, highest=_highest(engine))
    kept = _kept(found.orders, found.sums)
    columns, alone = _order_columns(found.orders[kept]), found.groups[0]
    rows: list[tuple[Value, ...]] = [
        (group.name, *np.abs(sums[kept]).tolist())
        for group, sums in zip(found.groups, found.sums, strict=True)
        if len(group.chambers) > 1
    ]
    if len(found.groups) > 1:
        rows.append((_("whole engine"), *np.abs(found.whole[kept]).tolist()))
    rows = rows or [(alone.name, *np.abs(found.sums[0, kept]).tolist())]
    note = _("|sum of exp(-i q θ)| over the firing angles θ, in equal pulses of one cylinder.")
    notes = (note, *_up_to(engine))
    return Table(_("Exhaust orders"), columns, tuple(rows), notes=notes, key="exhaust_orders")


def _highest(engine: Engine) -> float:
    """The highest order that is listed: at least that in which an even engine fires."""
    return max(HIGHEST, firing_rate(engine))


def _kept(orders: Real, sums: Complex) -> Real:
    """Which orders are listed: all up to HIGHEST, above it those that some group has."""
    return np.flatnonzero((orders <= HIGHEST + 1e-9) | (np.abs(sums) > 0).any(axis=0))


def _up_to(engine: Engine) -> list[str]:
    """Which orders above HIGHEST are listed."""
    highest = _highest(engine)
    if highest <= HIGHEST:
        return []
    return [
        _(
            "Orders up to {highest}, the number of firings per revolution; above {usual} those "
            "that occur.",
            highest=order_text(highest),
            usual=order_text(HIGHEST),
        )
    ]


def _order_columns(orders: Real, unit: str = "") -> tuple[Column, ...]:
    """The exhaust group, and a column for each order."""
    return (
        Column(_("exhaust group"), kind="text", key="name", label=True),
        *(
            Column(
                _("order {order}", order=order_text(order)), unit, key=f"pulses/{order_text(order)}"
            )
            for order in orders.tolist()
        ),
    )


def _pulses(engine: Engine) -> tuple[Table, ...]:
    """The same pulses with the pressure of the cycle, where the file has one."""
    if engine.gas is None:
        return ()
    from crankstar.mechanics.exhaust_pulses import exhaust_pulses  # with the cycle it needs
    from crankstar.mechanics.gas import cycle
    from crankstar.mechanics.operating_points import GasError

    try:
        found = exhaust_pulses(engine, cycle(engine), highest=_highest(engine))
    except GasError:
        return ()
    kept = _kept(found.orders, found.sums)
    columns = _order_columns(found.orders[kept], "Pa")
    rows = [
        (group.name, *np.abs(sums[kept]).tolist())
        for group, sums in zip(found.groups, found.sums, strict=True)
    ]
    if len(found.groups) > 1:
        rows.append((_("whole engine"), *np.abs(found.whole[kept]).tolist()))
    note = _(
        "Pressure above that of the exhaust while it is open, times the lift of the valve, at the "
        "load of the file: ratios of orders, not a sound pressure."
    )
    title = _("Exhaust pulses of the cycle")
    return (Table(title, columns, tuple(rows), notes=(note,), key="exhaust_pulses"),)


def _disturbances(cycle: WorkingCycle, groups: Sequence[ExhaustGroup]) -> Table:
    """Blow-downs that meet an open exhaust."""
    columns = (
        Column(_("cylinder"), key="blowing"),
        Column(_("blows down into"), key="disturbed"),
        Column(_("exhaust of that cylinder open for"), "deg", key="exhaust_open_deg"),
        Column(_("exhaust and intake open for"), "deg", key="both_open_deg"),
    )
    rows = tuple(
        tuple(getattr(disturbance, column.key) for column in columns)
        for group in groups
        for disturbance in disturbances(cycle, group.chambers)
    )
    notes = () if rows else (_("No cylinder blows down into the open exhaust of another."),)
    title = _("Blow-down into an open exhaust")
    return Table(title, columns, rows, notes=notes, key="disturbances")
