"""Force, couple, roll and torque over the crank angle, order by order and together."""

from __future__ import annotations

from collections.abc import Sequence
from math import degrees, pi
from typing import Any, Literal, NamedTuple

import numpy as np

from crankstar import spectra
from crankstar.charts.crank_angle import across, at_theta, waves
from crankstar.charts.drawing import (
    GREY,
    HALF,
    PALETTE,
    VERMILION,
    WIDTH,
    Panel,
    checked_angle,
    checked_order,
    figure,
    layered,
)
from crankstar.charts.grammar import Chart, constant, field, of_rows
from crankstar.charts.vectors import checked_quantity
from crankstar.engine.engine import Engine
from crankstar.language.messages import N_, _
from crankstar.language.numbers import unit_text
from crankstar.mechanics.balance import balance, total
from crankstar.mechanics.excitation import Reference, Totals, rolling_moment
from crankstar.mechanics.remains import NEGLIGIBLE
from crankstar.spectra import Real, Spectrum

Signal = Literal["force", "couple", "roll", "torque"]
VISIBLE = 0.01
"""Share of the greatest order below which one is not drawn by itself, unless asked for."""
MOST_ORDERS = 4
MOST_TURNS = 12
TOTAL = N_("all orders")
TITLES = {
    "force": N_("Force over the crank angle, in {unit}"),
    "couple": N_("Couple over the crank angle, in {unit}"),
    "roll": N_("Roll over the crank angle, in {unit}"),
    "torque": N_("Torque over the crank angle, in {unit}"),
}
AXES = {
    ("force", "up"): N_("force up"),
    ("force", "right"): N_("force right"),
    ("couple", "up"): N_("couple up"),
    ("couple", "right"): N_("couple right"),
    ("roll", "roll"): N_("roll"),
    ("torque", "torque"): N_("torque"),
}
NONE = {
    ("force", "up"): N_("no vertical force"),
    ("force", "right"): N_("no horizontal force"),
    ("couple", "up"): N_("no couple up or down"),
    ("couple", "right"): N_("no couple to either side"),
    ("roll", "roll"): N_("no roll"),
    ("torque", "torque"): N_("no torque"),
}


class Curve(NamedTuple):
    """A component over the crank angle: `amplitudes` c of Re(c exp(i k theta)) by order k."""

    component: str
    orders: Real
    amplitudes: Real


class Curves(NamedTuple):
    """The curves of a quantity, the orders drawn by themselves, the period in turns."""

    name: str
    quantity: str
    unit: str
    components: tuple[Curve, ...]
    shown: tuple[float, ...]
    turns: int

    @property
    def reach(self) -> float:
        """The greatest value of any curve."""
        angles = np.linspace(0, 2 * pi * self.turns, 721)
        single = [float(np.abs(c.amplitudes).max(initial=0.0)) for c in self.components]
        return max(
            *single,
            *(float(np.abs(_value(c, angles)).max(initial=0.0)) for c in self.components),
            0.0,
        )


def curves(
    engine: Engine,
    *,
    quantity: Signal = "force",
    orders: Sequence[float] | None = None,
    speed: float | None = None,
    reference: Reference | None = None,
) -> Curves:
    """A quantity of the whole engine over the crank angle; `orders` are drawn one by one."""
    checked_quantity(quantity, ("force", "couple", "roll", "torque"))
    result = balance(engine, speed=speed, reference=reference)
    spectrum = _of(total(result), quantity)
    unit = unit_text(
        getattr(result.units, "moment" if quantity in ("roll", "torque") else quantity)
    )
    if quantity in ("roll", "torque"):
        components = [Curve(quantity, spectrum.orders, spectra.amplitude(spectrum))]
    else:
        components = [
            Curve(way, spectrum.orders, part(spectrum))
            for way, part in (("up", spectra.vertical), ("right", spectra.horizontal))
        ]
    shares = _of(Totals(result.force, result.couple, result.axis_moment, result.torque), quantity)
    scale = float((np.abs(shares.forward) + np.abs(shares.backward)).sum(axis=-2).max(initial=0.0))
    components = [_present(curve, scale) for curve in components]
    shown = (
        _strongest(components)
        if orders is None
        else tuple(checked_order(order) for order in orders)
    )
    present = spectra.distinct(np.concatenate([curve.orders for curve in components]))
    turns = spectra.period(spectra.real_signal(present, np.ones(present.size, complex)))
    return Curves(engine.name, quantity, unit, tuple(components), shown, min(turns, MOST_TURNS))


def _of(sums: Totals, quantity: Signal) -> Spectrum:
    return rolling_moment(sums) if quantity == "roll" else getattr(sums, quantity)


def _present(curve: Curve, scale: float) -> Curve:
    kept = np.abs(curve.amplitudes) > NEGLIGIBLE * scale
    return Curve(curve.component, curve.orders[kept], curve.amplitudes[kept])


def _strongest(components: Sequence[Curve]) -> tuple[float, ...]:
    sizes: dict[float, float] = {}
    for curve in components:
        for order, amplitude in zip(
            curve.orders.tolist(), np.abs(curve.amplitudes).tolist(), strict=True
        ):
            sizes[order] = max(sizes.get(order, 0.0), amplitude)
    greatest = max(sizes.values(), default=0.0)
    seen = sorted(
        (order for order in sizes if sizes[order] >= VISIBLE * greatest),
        key=lambda order: -sizes[order],
    )
    return tuple(sorted(seen[:MOST_ORDERS]))


def _value(curve: Curve, angles: Real) -> Real:
    return np.real(curve.amplitudes @ np.exp(1j * curve.orders[:, None] * angles))


def over_turn(
    engine: Engine,
    *,
    quantity: Signal = "force",
    orders: Sequence[float] | None = None,
    speed: float | None = None,
    reference: Reference | None = None,
    theta: float = 0.0,
) -> Chart:
    """A quantity over one period of the crank angle: by order (thin), sum (thick), rule at `theta`.

    Force and couple have a panel for their upward and one for their rightward component. `orders`
    names those drawn by themselves, else the strongest four; the sum is always of all. In units of
    m r w^2 or, at a `speed` (rad/s), in N and N m. Raises ChartError.
    """
    whole = curves(engine, quantity=quantity, orders=orders, speed=speed, reference=reference)
    theta = checked_angle(theta)
    panels = curve_panels(whole, whole.reach, whole.shown)
    return figure(
        [[panel] for panel in panels],
        title=curves_title(whole),
        subtitle=[engine.name],
        theta=theta,
        turns=whole.turns,
    )


def curves_title(whole: Curves) -> str:
    """The quantity and its unit."""
    return _(TITLES[whole.quantity], unit=whole.unit)


def curve_panels(
    whole: Curves,
    reach: float,
    shown: Sequence[float],
    *,
    turns: int | None = None,
    width: float = WIDTH,
    title: str = "",
) -> list[Panel]:
    """A panel for each component, from -`reach` to `reach`, coloured by the orders `shown`."""
    last = len(whole.components) - 1
    return [
        _panel(
            whole,
            curve,
            reach or 1.0,
            shown,
            turns or whole.turns,
            width,
            foot=i == last,
            title=title if i == 0 else "",
        )
        for i, curve in enumerate(whole.components)
    ]


def order_names(orders: Sequence[float]) -> list[str]:
    """The names of the curves, the sum last."""
    return [*(_("order {order}", order=f"{order:g}") for order in orders), _(TOTAL)]


def _panel(
    whole: Curves,
    curve: Curve,
    reach: float,
    shown: Sequence[float],
    turns: int,
    width: float,
    *,
    foot: bool,
    title: str,
) -> Panel:
    names = order_names(shown)
    colours = {
        "domain": names,
        "range": [*(PALETTE[i % len(PALETTE)] for i in range(len(shown))), GREY],
    }
    legend = {
        "orient": "top",
        "title": None,
        "columns": 3,
        "columnPadding": 22,
        "symbolType": "stroke",
        "symbolStrokeWidth": 3,
    }
    x = across(turns, ticks=(90 if width > HALF else 180) * turns, foot=foot)
    y = field(
        "y:Q",
        scale={"domain": [-1.08 * reach, 1.08 * reach], "nice": False},
        title=_(AXES[whole.quantity, curve.component]),
        axis={"tickCount": 4},
    )
    rows = _rows(curve, whole.shown, turns)
    base = of_rows(rows).mark("line", strokeJoin="round")
    lines = base.encode(
        x=x,
        y=y,
        color=field("what:N", scale=colours, legend=legend),
        strokeWidth=field("width:Q", scale=None),
    )
    rule = at_theta(turns, y=waves(curve.orders, curve.amplitudes))
    line = rule.mark("rule", color=VERMILION, strokeWidth=1.2, strokeDash=[3, 2]).encode(x=x)
    dot = rule.mark(
        "point", color=VERMILION, filled=True, opacity=1, size=70, shape="circle"
    ).encode(x=x, y=y)
    layers = [lines, line, dot]
    if not curve.orders.size:
        note = of_rows([{"x": 180 * turns, "y": 0}]).mark("text", dy=-12, fontSize=13, color=GREY)
        words = constant(_(NONE[whole.quantity, curve.component]))
        layers.append(note.encode(x=x, y=y, text=words))
    height = 120 if len(whole.components) > 1 else 170
    return layered(layers, width=width, height=height, title=title)


def _rows(curve: Curve, shown: Sequence[float], turns: int) -> list[dict[str, Any]]:
    highest = float(curve.orders.max(initial=1.0))
    angles = np.linspace(0, 2 * pi * turns, int(min(max(120, 20 * highest * turns), 1500)) + 1)
    rows = []
    for order, name in zip([*shown, None], order_names(shown), strict=True):
        kept = curve.orders > 0 if order is None else np.abs(curve.orders - order) < 1e-9
        if order is not None and not kept.any():
            continue
        values = _value(Curve(curve.component, curve.orders[kept], curve.amplitudes[kept]), angles)
        width = 3.2 if order is None else 1.8
        rows += [
            {"x": round(degrees(a), 6), "y": float(v), "what": name, "width": width}
            for a, v in zip(angles, values, strict=True)
        ]
    # the sum first, so that the orders are drawn over it
    return sorted(rows, key=lambda row: row["what"] != _(TOTAL))
