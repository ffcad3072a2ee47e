"""The torque of an engine over a working cycle: of gas and inertia, by cylinder, by load, by order.

Torque is that on the crankshaft, positive in its direction of rotation.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from typing import Literal

import numpy as np

from crankstar import spectra
from crankstar.charts.canvas import curve_height, panel_width
from crankstar.charts.drawing import (
    BLUE,
    GREEN,
    GREY,
    ORANGE,
    PALETTE,
    VERMILION,
    Panel,
    figure,
    layered,
    stacked,
)
from crankstar.charts.gas_curves import ROOM, Line, about, over_angle, reach, without
from crankstar.charts.grammar import Chart, constant, field, of_rows, span
from crankstar.charts.letters import SMALL, folded, text_width
from crankstar.charts.resting import of_gas
from crankstar.charts.sums import checked_quantity
from crankstar.engine.engine import Engine
from crankstar.firing.exhaust_orders import firing_rate
from crankstar.language.messages import N_, _
from crankstar.language.numbers import RPM, number, order_text, unit_text
from crankstar.language.shown_units import shown
from crankstar.mechanics.balance import balance, total
from crankstar.mechanics.gas import Cycle, check_gas, cycle
from crankstar.mechanics.gas_torque import gas_torque, over_cycle
from crankstar.mechanics.kinetic import samples_over
from crankstar.mechanics.operating_points import GasError
from crankstar.spectra import Real
from crankstar.tables.torque_orders import by_order

TorqueView = Literal["together", "cylinders", "loads", "orders"]
TITLES = {
    "together": N_("Torque over the cycle"),
    "cylinders": N_("Gas torque of each cylinder"),
    "loads": N_("Torque motored and under load"),
    "orders": N_("Torque by order"),
}
AXIS = N_("torque ({unit})")
SAMPLES = 720
HIGHEST = 8.0
"""The highest order of the bars."""
VISIBLE = 0.005
"""Share of the greatest bar from which one is drawn."""
MOST_LOADS = 4
NAMES, LOW = 4, 0.4
"""The part of a row that a name takes, and how high a curve may be there, as a share of its top."""
ROW, LEAST_ROW, ROWS = 44.0, 15.0, 420.0
"""Px of a cylinder's row, at least, and of all rows together."""


def torque_chart(
    engine: Engine,
    *,
    quantity: TorqueView | None = None,
    point: str | None = None,
    speed: float | None = None,
    off: Sequence[int] = (),
) -> Chart:
    """The torque of an engine at an operating point, or at the load of its file.

    `together`: gas, inertia, their sum and the mean. `cylinders`: the gas torque of each below the
    other, on one scale, in firing order, and their sum. `loads`: the sum motored and at each
    operating point. `orders`: bars of gas, inertia and sum. At `speed` (rad/s), with cylinders that
    are `off`. An engine without bores, sizes or firing order has a figure that says so. Raises
    ChartError, and GasError for a point or a cylinder that is not there.
    """
    wanted: TorqueView = "together" if quantity is None else checked_quantity(quantity, TorqueView)
    title = _(TITLES[wanted])
    try:
        check_gas(engine)
    except GasError as error:
        return without(engine, title=title, reason=str(error))
    make = partial(cycle, point=point or "", speed=speed, off=off)
    found = make(engine)
    panels = _PANELS[wanted](engine, found)
    subtitle = [*about(engine, found), *_about(wanted)]
    rests = of_gas(engine, make, ("roll", "mean torque"), "torque")
    return figure([[panel] for panel in panels], title=title, subtitle=subtitle, rests=rests)


def _about(view: TorqueView) -> list[str]:
    if view == "orders":
        return [_("An order that is not there is nought.")]
    return []


def inertia_torque(engine: Engine, found: Cycle, theta: Real) -> Real | None:
    """The inertia torque of an engine at crank angles, N m; None without speed or masses."""
    result = balance(engine, speed=found.speed)
    if found.speed is None or result.speed is None:
        return None
    return np.real(spectra.value(total(result).torque, theta))


def _together(engine: Engine, found: Cycle) -> list[Panel]:
    theta = samples_over(engine, SAMPLES)
    gas = over_cycle(found, SAMPLES).sum(axis=0)
    moving = inertia_torque(engine, found, theta)
    whole = gas if moving is None else gas + moving
    lines = [Line(_("gas"), BLUE, 1.8, gas)]
    if moving is not None:
        lines = [
            Line(_("together"), GREY, 3.2, whole),
            *lines,
            Line(_("inertia"), GREEN, 1.8, moving),
        ]
    lines.append(Line(_("mean"), VERMILION, 1.4, np.full_like(gas, gas.mean())))
    return [over_angle(theta, lines, title=AXIS, unit="N*m", height=200)]


def _cylinders(engine: Engine, found: Cycle) -> list[Panel]:
    theta = samples_over(engine, SAMPLES)
    each = over_cycle(found, SAMPLES)
    rows = sorted(range(len(each)), key=lambda row: float(found.volumes.fires[row]))
    lines = [Line(str(found.volumes.numbers[row]), PALETTE[0], 1.6, each[row]) for row in rows]
    ends = reach(lines)
    height = max(LEAST_ROW, min(ROW, ROWS / len(rows)))
    narrow = [
        _named(
            over_angle(
                theta, [line], title="", unit="N*m", height=height, foot=False, ends=ends,
                legend=False, ticks=0,
            ),
            _("cylinder {number}", number=line.name),
            line.values,
        )
        for line in lines
    ]  # fmt: skip
    whole = Line(_("together"), GREY, 2.6, each.sum(axis=0))
    foot = over_angle(theta, [whole], title=AXIS, unit="N*m", height=120, legend=False)
    return [stacked(narrow, title=folded(_scale(ends), width=panel_width())), foot]


def _scale(ends: tuple[float, float]) -> str:
    said = shown("N*m", max(map(abs, ends)))
    low, high = (number(float(f"{said.factor * end / ROOM:.3g}")) for end in ends)
    return _(
        "One scale for all cylinders, from {low} to {high} {unit}.",
        low=low,
        high=high,
        unit=unit_text(said.unit),
    )


def _named(panel: Panel, name: str, values: Real) -> Panel:
    """A panel with its name inside at the top, where its curve of these values [angle] is low."""
    room = values.size // NAMES
    middle = (values.size - room) // 2
    right, left, between = values[-room:], values[:room], values[middle : middle + room]
    tops = [float(each.max()) for each in (right, left, between)]
    at = tops.index(min(tops)) if tops[0] > LOW * float(values.max()) else 0
    align, share, shift = (("right", 1.0, -4), ("left", 0.0, 4), ("center", 0.5, 0))[at]
    label = of_rows([{"x": 0}]).mark(
        "text", fontSize=SMALL, color=GREY, align=align, baseline="top", dx=shift
    )
    words = label.encode(x=constant(share * panel_width()), y=constant(0), text=constant(name))
    return {**panel, "layer": [*panel["layer"], words.spec]}


def _loads(engine: Engine, found: Cycle) -> list[Panel]:
    theta = samples_over(engine, SAMPLES)
    points = [each.name for each in engine.gas.points] if engine.gas is not None else []
    runs = [(_("motored"), GREY, cycle(engine, speed=found.speed, motored=True))]
    if found.name or not points:
        runs.append((found.name or _("under load"), BLUE, found))
    else:
        colours = (BLUE, GREEN, ORANGE, VERMILION)
        kept = points[: MOST_LOADS - 1] + points[-1:] if len(points) > MOST_LOADS else points
        runs += [
            (name, colour, cycle(engine, point=name))
            for name, colour in zip(kept, colours, strict=False)
        ]
    lines: list[Line] = []
    for name, colour, each in runs:
        gas = over_cycle(each, SAMPLES).sum(axis=0)
        moving = inertia_torque(engine, each, theta)
        label = (
            name
            if each.speed is None
            else _("{load}, {rpm} rpm", load=name, rpm=number(round(each.speed * RPM)))
        )
        lines.append(Line(label, colour, 1.8, gas if moving is None else gas + moving))
    return [over_angle(theta, lines, title=AXIS, unit="N*m", height=220)]


def _orders(engine: Engine, found: Cycle) -> list[Panel]:
    waves = by_order(engine, found, gas_torque(found))
    highest = max(HIGHEST, firing_rate(engine))
    kept = [index for index, order in enumerate(waves.orders) if order <= highest]
    series = [(_("gas"), BLUE, waves.gas)]
    if waves.inertia is not None:
        series += [(_("inertia"), GREEN, waves.inertia), (_("together"), GREY, waves.total)]
    greatest = max(float(np.abs(wave[kept]).max(initial=0.0)) for _name, _colour, wave in series)
    said = shown("N*m", greatest)
    names = [order_text(waves.orders[place]) for place in kept]
    slot = panel_width() / len(names)
    fits = max(text_width(name, SMALL) for name in names) < 0.9 * slot
    whole = [name for name, place in zip(names, kept, strict=True) if waves.orders[place] % 1 == 0]
    rows = [
        {
            "order": order_text(waves.orders[place]),
            "what": name,
            "to": float(f"{abs(wave[place]) * said.factor:.6g}"),
            "from": 0.0,
        }
        for name, _colour, wave in series
        for place in kept
        if abs(wave[place]) > VISIBLE * greatest
    ]
    colours = {"domain": [s[0] for s in series], "range": [s[1] for s in series]}
    bars = of_rows(rows).mark("bar")
    drawn = bars.encode(
        x=field(
            "order:N",
            sort=None,
            scale={"domain": names},
            title=_("order"),
            axis={"labelAngle": 0, "values": names if fits else whole, "labelOverlap": False},
        ),
        xOffset=field("what:N", sort=None, scale={"domain": colours["domain"]}),
        y=field(
            "to:Q",
            title=_(AXIS, unit=unit_text(said.unit)),
            scale=span(0, ROOM * (greatest * said.factor or 1.0)),
            axis={"tickCount": 4},
        ),
        color=field("what:N", scale=colours, legend={"orient": "top", "title": None}),
    )
    return [layered([drawn], width=panel_width(), height=curve_height(170))]


_PANELS = {"together": _together, "cylinders": _cylinders, "loads": _loads, "orders": _orders}
