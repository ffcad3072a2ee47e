"""Torsional vibration over the speed: order by order, and all orders with their phases."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import cycle, islice
from typing import Any, Literal, NamedTuple

import numpy as np

from crankstar.analyses.torsion.charts.words import (
    NO_SPEED,
    RPM,
    TWISTED,
    TWISTING,
    load_lines,
    named_lines,
    refused,
    rests,
    rpm_text,
)
from crankstar.charts.canvas import curve_height, panel_width, relative_width
from crankstar.charts.drawing import (
    GREY,
    PALETTE,
    VERMILION,
    Panel,
    checked_order,
    figure,
    layered,
    named_in_legend,
)
from crankstar.charts.gas_curves import ROOM
from crankstar.charts.grammar import Channel, Chart, Layer, field, of_rows, own, span
from crankstar.charts.sums import checked_quantity
from crankstar.dynamics.torsion_analysis import TorsionAnalysis, torsion
from crankstar.dynamics.torsion_criticals import stresses
from crankstar.dynamics.torsion_response import Response
from crankstar.dynamics.torsion_system import TorsionError
from crankstar.engine.engine import Engine
from crankstar.language.messages import N_, _
from crankstar.language.numbers import number, order_text, unit_text
from crankstar.language.shown_units import Shown, shown
from crankstar.spectra import Real

TorsionView = Literal["amplitude", "stress", "torque"]
TITLES = {
    "amplitude": N_("Torsional vibration of the free end over the speed"),
    "stress": N_("Shear stress of torsional vibration over the speed"),
    "torque": N_("Torque of torsional vibration over the speed"),
}
AXES = {
    "amplitude": N_("amplitude ({unit})"),
    "stress": N_("shear stress ({unit})"),
    "torque": N_("torque ({unit})"),
}
UNITS = {"amplitude": "deg", "stress": "MPa", "torque": "N*m"}
TOTAL, ADDED = N_("all orders"), N_("sum of amplitudes (dashed)")
MOST_ORDERS, VISIBLE = 4, 0.02
"""Orders that are drawn by themselves, and the share of the greatest that one of them has."""
HEIGHT = 230.0
MPA = 1e-6


class _Courses(NamedTuple):
    """A quantity over the speeds: by order [speed, order], its peak and the sum of amplitudes.

    `where` says of what it is, `view` which one; in degrees, MPa or N m.
    """

    of_order: Real
    peak: Real
    added: Real
    where: str
    view: str

    @property
    def shown(self) -> Shown:
        """The unit in which they are drawn; stress in MPa unless another one is chosen."""
        greatest = float(self.added.max(initial=0.0))
        return shown(UNITS[self.view], greatest, prefixed=self.view == "torque")


def torsion_response_chart(
    engine: Engine,
    *,
    quantity: TorsionView | None = None,
    speeds: Sequence[float] | None = None,
    orders: Sequence[float] | None = None,
    point: str | None = None,
) -> Chart:
    """The vibration of the free end, or stress or torque of the shaft that has most, by speed.

    The strongest orders (thin), or those named, and the greatest of all orders over a cycle, with
    their phases (thick), beside the sum of their amplitudes (dashed). `speeds` in rad/s, else those
    of the file; critical speeds are computed besides. Barred speeds are shaded. An engine without a
    table [torsion], without a speed or without diameters has a figure that says so. Raises
    ChartError, and GasError for an operating point that is not there.
    """
    wanted: TorsionView = (
        "amplitude" if quantity is None else checked_quantity(quantity, TorsionView)
    )
    asked = None if orders is None else [checked_order(order) for order in orders]
    title = _(TITLES[wanted])
    try:
        found = torsion(engine, point=point or "", speeds=[*(speeds or ())])
    except TorsionError as error:
        return refused(engine, title=title, reason=str(error))
    own_response = found.response
    if own_response is None:
        reason = _("Without masses and without gas nothing is driven.")
        return refused(engine, title=title, reason=reason if found.speeds.size else _(NO_SPEED))
    courses = _courses(found, own_response, wanted)
    if courses is None:
        reason = _("Shear stress needs the diameter of a shaft: give torsion.diameter.")
        if wanted == "torque":
            reason = _("Nothing twists: all masses are rigidly coupled, or by a fluid alone.")
        return refused(engine, title=title, reason=reason)
    panel = _panel(found, own_response, courses, asked)
    subtitle = [*named_lines(engine), courses.where, *_words(found, courses)]
    drawn = TWISTING if wanted == "amplitude" else TWISTED
    rests_on = rests(engine, quantities=drawn, point=point or "", speeds=[*(speeds or ())])
    lines = [*subtitle, *load_lines(engine, found)]
    return figure([[panel]], title=title, subtitle=lines, rests=rests_on)


def _courses(found: TorsionAnalysis, response: Response, view: str) -> _Courses | None:
    """None where no shaft has what is wanted."""
    if view == "amplitude":
        size = np.abs(response.turns[..., found.free_end])
        name = found.chain.names[found.free_end]
        return _Courses(
            np.degrees(size),
            np.degrees(response.peak_turn(found.free_end)),
            np.degrees(size.sum(axis=1)),
            _("{mass}, to either side; uneven running of the whole is in it", mass=name),
            view,
        )
    peak, added = (response.peak, response.added) if view == "torque" else stresses(response)
    if not peak.size or np.all(np.isnan(peak)):
        return None
    worst = int(np.nanargmax(np.nanmax(np.where(np.isnan(peak), -1.0, peak), axis=0)))
    own = found.chain.sections[worst].modulus or 1.0
    factor = 1.0 if view == "torque" else MPA
    return _Courses(
        np.abs(response.torque[..., worst]) * (1.0 if view == "torque" else MPA / own),
        peak[:, worst] * factor,
        added[:, worst] * factor,
        _("in {shaft}, the shaft that has most", shaft=found.chain.section_name(worst)),
        view,
    )


def _words(found: TorsionAnalysis, courses: _Courses) -> list[str]:
    top = int(np.argmax(courses.peak))
    size, unit = courses.peak[top] * courses.shown.factor, courses.shown.unit
    said = "°" if courses.view == "amplitude" else f" {unit_text(unit)}"
    lines = [
        _(
            "peak {size} at {rpm} rpm",
            size=f"{number(float(f'{size:.4g}'))}{said}",
            rpm=rpm_text(float(found.speeds[top])),
        )
    ]
    if courses.view == "stress" and found.limit:
        lines.append(_("dashed across: the limit, {limit} MPa", limit=number(found.limit * MPA)))
    if found.barred:
        ranges = ", ".join(f"{rpm_text(low)}–{rpm_text(high)}" for low, high in _merged(found))
        lines.append(_("shaded: barred by the stress of some shaft, {ranges} rpm", ranges=ranges))
    return lines


def _merged(found: TorsionAnalysis) -> list[tuple[float, float]]:
    """The barred speeds of all shafts, ranges that overlap as one."""
    out: list[tuple[float, float]] = []
    for each in found.barred:
        if out and each.low <= out[-1][1]:
            out[-1] = (out[-1][0], max(out[-1][1], each.high))
        else:
            out.append((each.low, each.high))
    return out


def _kept(response: Response, courses: _Courses, asked: Sequence[float] | None) -> list[int]:
    """The places of the orders that are drawn by themselves."""
    orders = response.orders.tolist()
    if asked is not None:
        return [index for index, order in enumerate(orders) if order in asked]
    tops = courses.of_order.max(axis=0)
    least = VISIBLE * float(tops.max(initial=0.0))
    strongest = np.argsort(-tops, kind="stable")[:MOST_ORDERS].tolist()
    return sorted(place for place in strongest if tops[place] > least)


def _panel(
    found: TorsionAnalysis, response: Response, courses: _Courses, asked: Sequence[float] | None
) -> Panel:
    view = courses.view
    kept = _kept(response, courses, asked)
    limit = found.limit * MPA if view == "stress" and found.limit else None
    said = courses.shown
    speeds = (response.speeds * RPM).tolist()
    series: list[tuple[str, str, float, list[int], Real]] = [
        (_(ADDED), GREY, 1.2, [4, 3], courses.added),
        (_(TOTAL), GREY, 3.0, [1, 0], courses.peak),
    ]
    colours = islice(cycle(PALETTE), len(kept))
    for place, colour in zip(kept, colours, strict=True):
        name = _("order {order}", order=order_text(response.orders[place]))
        series.append((name, colour, 1.8, [1, 0], courses.of_order[:, place]))
    rows = [
        {"x": x, "y": float(f"{y * said.factor:.6g}"), "what": name, "width": width}
        for name, _colour, width, _dash, values in series
        for x, y in zip(speeds, values.tolist(), strict=True)
    ]
    x = field(
        "x:Q",
        scale=span(speeds[0], speeds[-1]),
        title=_("speed (rpm)"),
        axis={"tickCount": 5 if relative_width() > 0.8 else 3},
    )
    top = ROOM * max(float(courses.added.max()), limit or 0.0) * said.factor or 1.0
    y = field(
        "y:Q",
        scale=span(0, top),
        title=_(AXES[view], unit="°" if view == "amplitude" else unit_text(said.unit)),
        axis={"tickCount": 4, "minExtent": 34},
    )
    order = [series[1], *series[2:], series[0]]
    lines = of_rows(rows).mark("line", strokeJoin="round")
    drawn = lines.encode(
        x=x,
        y=y,
        **named_in_legend([(s[0], s[1], s[3]) for s in order], columns=2),
        strokeWidth=own("width:Q"),
    )
    return layered(
        [*_shades(found, x), *_limit(limit, said.factor, y), drawn],
        width=panel_width(),
        height=curve_height(HEIGHT),
    )


def _shades(found: TorsionAnalysis, x: Channel) -> list[Layer]:
    """The barred speeds."""
    rows = [{"x": low * RPM, "x2": high * RPM} for low, high in _merged(found)]
    if not rows:
        return []
    mark = of_rows(rows).mark("rect", color=VERMILION, opacity=0.15)
    return [mark.encode(x=x, x2=field("x2"))]


def _limit(limit: float | None, factor: float, y: dict[str, Any]) -> list[Layer]:
    """The stress that bars a speed."""
    if limit is None:
        return []
    rule = of_rows([{"y": limit * factor}]).mark(
        "rule", color=VERMILION, strokeWidth=1.2, strokeDash=[6, 3]
    )
    return [rule.encode(y=y)]
