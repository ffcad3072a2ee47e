"""Force, pitch, yaw and rolling moment over the speed, order by order and together."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import cycle, islice
from typing import Any, NamedTuple

import numpy as np

from crankstar import spectra
from crankstar.charts.canvas import curve_height, panel_width, relative_width
from crankstar.charts.curves import BAND
from crankstar.charts.drawing import (
    GREY,
    LINES,
    PALETTE,
    Panel,
    checked_order,
    figure,
    heading,
    layered,
)
from crankstar.charts.estimates import ends_of, estimate_lines, size_range
from crankstar.charts.grammar import Chart, constant, field, of_rows, own, span
from crankstar.charts.resting import of_speeds
from crankstar.engine.engine import Engine
from crankstar.language.messages import N_, _
from crankstar.language.numbers import RPM, number, unit_text
from crankstar.language.shown_units import shown
from crankstar.mechanics.balance import balance
from crankstar.mechanics.excitation import Reference
from crankstar.mechanics.gas_loads import gas_over_speeds
from crankstar.mechanics.gas_torque import roll_with_gas
from crankstar.mechanics.operating_points import GasError
from crankstar.spectra import Real
from crankstar.studies.study import rad_per_s
from crankstar.studies.sweep import Sweep, swept, watched
from crankstar.tables.conditions import missing_sentence
from crankstar.tables.gas_words import points_text, range_points
from crankstar.tables.over_speeds import COMPONENTS, Component, remaining, rpm, waves

HEIGHT = 120
MOST_ORDERS, VISIBLE = 4, 0.01
"""Orders that are drawn by themselves, and the share of the greatest that one of them has."""
USUAL = 6000 / RPM
"""The highest speed [rad/s] where neither the chart nor the engine names one."""
LOWEST = 0.1
"""Share of the highest speed at which the usual range begins."""
TOTAL = N_("all orders")
AXES = {
    "vertical": N_("vertical\nforce ({unit})"),
    "horizontal": N_("horizontal\nforce ({unit})"),
    "pitch": N_("pitch M_V\n({unit})"),
    "yaw": N_("yaw M_H\n({unit})"),
    "roll": N_("rolling\nmoment ({unit})"),
}
NOTHING = N_("No force and no moment of these orders.")


class Drawn(NamedTuple):
    """A component at every speed, in `unit`: by order, and the greatest value of all together.

    `ends`: the range of that peak, as shares of it, where it rests on estimates.
    """

    component: Component
    unit: str
    of_order: dict[float, Real]
    peak: Real
    ends: tuple[float, float] | None = None


def amplitudes(
    engine: Engine,
    *,
    speeds: Sequence[float] | None = None,
    orders: Sequence[float] | None = None,
    reference: Reference | None = None,
    point: str | None = None,
) -> Chart:
    """The amplitude of each order over the speed (thin) and the peak of all (thick), by component.

    Where the file says what the gas does, the rolling moment is that of gas and inertia together,
    half orders included: at the load of an operating `point`, else interpolated over the speeds of
    the operating points, else at the load of the file. Raises GasError for an unknown point.

    `speeds` in rad/s, else from a tenth of the engine's own speed to all of it. Components of which
    nothing is left have no panel. In N and N m, or in m r omega_0^2, omega_0 the highest speed.
    Raises ChartError, and SweepError for fewer than two speeds.
    """
    asked = None if orders is None else [checked_order(order) for order in orders]
    top = engine.speed or USUAL
    values = np.linspace(LOWEST * top, top, 46) if speeds is None else np.asarray(speeds, float)
    sweep = swept(engine, over="speed", values=np.sort(values), unit=None, reference=reference)
    ends = [
        swept(each, over="speed", values=np.sort(values), unit=None, reference=sweep.reference)
        for each in ends_of(engine)
    ]
    left = remaining(balance(engine, reference=reference), asked)
    shown_parts = [
        _drawn(sweep, ends, component, left[component.key], all_orders=asked is not None)
        for component in COMPONENTS
        if left[component.key]
    ]
    burning = _with_gas(sweep, engine, point, asked)
    if burning is not None:
        shown_parts = [part for part in shown_parts if part.component.key != "roll"]
        shown_parts.append(burning)
    names = sorted({order for part in shown_parts for order in part.of_order})
    panels = [
        [_panel(rpm(sweep), part, names, foot=part is shown_parts[-1])] for part in shown_parts
    ]
    lines = estimate_lines([engine], drawn=_(BAND))
    subtitle = [*heading(engine), *_words(engine, sweep), *lines]
    if burning is not None:
        subtitle.append(_gas_words(engine, point))
    if not panels:
        panels, subtitle = [[_empty(rpm(sweep))]], [*subtitle, _(NOTHING)]
    rests = of_speeds(
        engine,
        [part.component.key for part in shown_parts],
        top=float(values.max()),
        orders=asked,
        reference=reference,
        point=None if burning is None else point or "",
    )
    return figure(panels, title=_("Amplitude over the speed"), subtitle=subtitle, rests=rests)


def _words(engine: Engine, sweep: Sweep) -> list[str]:
    lines = [_("Inertia forces grow with the square of the speed.")]
    if sweep.units.force != "N" and sweep.highest_speed:
        highest = number(sweep.highest_speed * RPM)
        lines.append(_("ω0 is the highest speed, {rpm} rpm.", rpm=highest))
    return [*lines, *filter(None, [missing_sentence(engine)])]


def _drawn(
    sweep: Sweep,
    ends: Sequence[Sweep],
    component: Component,
    orders: Sequence[float],
    *,
    all_orders: bool,
) -> Drawn:
    """A component with its strongest orders, or all of those that were asked for.

    `ends` are the same of the engine at the ends of its estimated ranges.
    """
    sums, curve = sweep.sums, watched(sweep, component.what)
    said = shown(curve.unit, float(curve.values.max()))
    size = np.abs(waves(component, sums)) * said.factor
    places = {order: int(np.argmin(np.abs(sums.force.orders - order))) for order in orders}
    by_order = {order: size[:, place] for order, place in places.items()}
    if not all_orders:
        tops = {order: float(values.max()) for order, values in by_order.items()}
        strongest = sorted(tops, key=lambda order: -tops[order])[:MOST_ORDERS]
        least = VISIBLE * max(tops.values())
        by_order = {order: by_order[order] for order in sorted(strongest) if tops[order] >= least}
    top = float(curve.values[-1])
    reach = size_range(top, [float(watched(end, component.what).values[-1]) for end in ends])
    shares = None if reach is None or not top else (reach[0] / top, reach[1] / top)
    return Drawn(component, said.unit, by_order, curve.values * said.factor, shares)


def _with_gas(
    sweep: Sweep, engine: Engine, point: str | None, asked: Sequence[float] | None
) -> Drawn | None:
    """The rolling moment of gas and inertia; None where the gas or the newtons are not known."""
    if point is None and engine.gas is None:
        return None
    speeds = rad_per_s(sweep.values, sweep.unit)
    try:
        gas = gas_over_speeds(engine, speeds, point=point or "")
    except GasError:
        if point is not None:
            raise
        return None
    if sweep.units.force != "N":
        return None
    roll = roll_with_gas(sweep.sums, gas)
    size = np.abs(spectra.amplitude(roll))
    tops = size.max(axis=0)
    kept = [
        place
        for place in np.argsort(-tops)
        if (asked is None and tops[place] > VISIBLE * tops.max() > 0)
        or (asked is not None and float(roll.orders[place]) in asked)
    ]
    kept = kept if asked is not None else kept[:MOST_ORDERS]
    if not tops.max(initial=0.0):
        return None
    peak = spectra.peaks(roll)
    said = shown("N*m", float(peak.max()))
    by_order = {
        order: size[:, place] * said.factor
        for order, place in sorted((float(roll.orders[place]), place) for place in kept)
    }
    return Drawn(COMPONENTS[-1], said.unit, by_order, peak * said.factor)


def _gas_words(engine: Engine, point: str | None) -> str:
    known = range_points(engine, point or "")
    if len(known) > 1:
        return _(
            "Rolling moment with gas, its load from {first} to {last} by the operating points.",
            first=points_text([(known[0][0], 1.0)]),
            last=points_text([(known[-1][0], 1.0)]),
        )
    if known[0][0]:
        return _("Rolling moment with gas at the load of {point}.", point=known[0][0])
    return _("Rolling moment with gas at the load of the file.")


def _panel(speeds: Real, part: Drawn, orders: Sequence[float], *, foot: bool) -> Panel:
    names = [*(_("order {order}", order=f"{order:g}") for order in orders), _(TOTAL)]
    colours = {"domain": names, "range": [*islice(cycle(PALETTE), len(orders)), GREY]}
    title = _(AXES[part.component.key], unit=unit_text(part.unit)).split("\n")
    x = _across(speeds, foot=foot)
    tops = [part.peak.max() * max(part.ends or (1.0,)), *(v.max() for v in part.of_order.values())]
    reach = 1.08 * float(max(tops))
    y = field("y:Q", scale=span(0, reach), title=title, axis={"tickCount": 3, "titlePadding": 18})
    rows = _rows(speeds, part.peak, _(TOTAL), 3.2)
    for order, values in part.of_order.items():
        rows += _rows(speeds, values, _("order {order}", order=f"{order:g}"), 1.8)
    lines = of_rows(rows).mark("line", strokeJoin="round")
    drawn = lines.encode(
        x=x,
        y=y,
        color=field("what:N", scale=colours, legend={**LINES, "columns": 3}),
        strokeWidth=own("width:Q"),
    )
    layers = [drawn]
    if part.ends is not None:
        low, high = (part.peak * end for end in part.ends)
        band = [
            {"x": a, "low": b, "high": c}
            for a, b, c in zip(speeds.tolist(), low.tolist(), high.tolist(), strict=True)
        ]
        area = of_rows(band).mark("area", color=GREY, opacity=0.25)
        layers.insert(0, area.encode(x=x, y={**y, "field": "low"}, y2=field("high")))
    return layered(layers, width=panel_width(), height=curve_height(HEIGHT))


def _across(speeds: Real, *, foot: bool) -> dict[str, Any]:
    return field(
        "x:Q",
        scale=span(float(speeds[0]), float(speeds[-1])),
        title=_("speed (rpm)") if foot else None,
        axis={"tickCount": 4 if relative_width() > 0.8 else 2, "labels": foot},
    )


def _rows(speeds: Real, values: Real, name: str, width: float) -> list[dict[str, Any]]:
    return [
        {"x": x, "y": float(f"{y:.6g}"), "what": name, "width": width}
        for x, y in zip(speeds.tolist(), values.tolist(), strict=True)
    ]


def _empty(speeds: Real) -> Panel:
    """A panel without curves, whose note says that there is nothing."""
    middle = [{"x": float(speeds[0] + speeds[-1]) / 2, "y": 0.5}]
    y = field("y:Q", scale=span(0, 1), title=None, axis=None)
    note = of_rows(middle).mark("text", fontSize=13, color=GREY)
    layer = note.encode(x=_across(speeds, foot=True), y=y, text=constant(_(NOTHING)))
    return layered([layer], width=panel_width(), height=curve_height(HEIGHT))
