"""Force, couple, roll and torque over the crank angle, order by order and together."""

from __future__ import annotations

from collections.abc import Sequence
from math import degrees, pi
from typing import TYPE_CHECKING, Any, Literal, NamedTuple

import numpy as np

from crankstar import phasor
from crankstar.balance import balance, total
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
    of_rows,
)
from crankstar.charts.vectors import NOTHING, checked_quantity
from crankstar.engine import Engine
from crankstar.mechanism import Reference
from crankstar.phasor import Real
from crankstar.wording import unit_text

if TYPE_CHECKING:
    import altair

Signal = Literal["force", "couple", "roll", "torque"]
VISIBLE = 0.01
"""Share of the greatest order below which one is not drawn by itself, unless asked for."""
MOST_ORDERS = 4
MOST_TURNS = 12
TOTAL = "all orders"


class Curve(NamedTuple):
    """A component over the crank angle: `amplitudes` c of `Re(c exp(i k theta))` for its `orders` k."""

    component: str
    orders: Real
    amplitudes: Real


class Curves(NamedTuple):
    """What is drawn over the crank angle: a curve for each component, the orders drawn by themselves, unit, period."""

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
        return max(*single, *(float(np.abs(_value(c, angles)).max(initial=0.0)) for c in self.components), 0.0)


def curves(
    engine: Engine,
    *,
    quantity: Signal = "force",
    orders: Sequence[float] | None = None,
    speed: float | None = None,
    reference: Reference | None = None,
) -> Curves:
    """A quantity of the whole engine over the crank angle; `orders` are those drawn by themselves."""
    checked_quantity(quantity, ("force", "couple", "roll", "torque"))
    result = balance(engine, speed=speed, reference=reference)
    spectrum = getattr(total(result), quantity)
    unit = unit_text(result.units._asdict()["roll" if quantity == "torque" else quantity])
    if quantity in ("roll", "torque"):
        found = [Curve(quantity, spectrum.orders, phasor.amplitude(spectrum))]
    else:
        found = [
            Curve(way, spectrum.orders, part(spectrum)) for way, part in (("up", phasor.vertical), ("right", phasor.horizontal))
        ]
    shares = getattr(result, quantity)
    scale = float((np.abs(shares.forward) + np.abs(shares.backward)).sum(axis=-2).max(initial=0.0))
    found = [_present(curve, scale) for curve in found]
    shown = _strongest(found) if orders is None else tuple(checked_order(order) for order in orders)
    present = np.unique(np.concatenate([curve.orders for curve in found]))
    turns = phasor.period(phasor.real_signal(present, np.ones(present.size, complex)))
    return Curves(engine.name, quantity, unit, tuple(found), shown, min(turns, MOST_TURNS))


def _present(curve: Curve, scale: float) -> Curve:
    kept = np.abs(curve.amplitudes) > NOTHING * scale
    return Curve(curve.component, curve.orders[kept], curve.amplitudes[kept])


def _strongest(found: Sequence[Curve]) -> tuple[float, ...]:
    sizes: dict[float, float] = {}
    for curve in found:
        for order, amplitude in zip(curve.orders.tolist(), np.abs(curve.amplitudes).tolist(), strict=True):
            sizes[order] = max(sizes.get(order, 0.0), amplitude)
    greatest = max(sizes.values(), default=0.0)
    seen = sorted((order for order in sizes if sizes[order] >= VISIBLE * greatest), key=lambda order: -sizes[order])
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
) -> altair.VConcatChart:
    """A quantity over the crank angle for one period: by order (thin) and all orders together (thick), a rule at `theta`.

    Force and couple have a panel for their upward and one for their rightward component. `orders` names those drawn by
    themselves, else the strongest four; the sum is always of all. In units of m r w^2 or, at a `speed` (rad/s), in N and
    N m. Raises ChartError.
    """
    found = curves(engine, quantity=quantity, orders=orders, speed=speed, reference=reference)
    theta = checked_angle(theta)
    panels = curve_panels(found, found.reach, found.shown)
    title = f"{found.quantity.capitalize()} over the crank angle, in {found.unit}"
    return figure([[panel] for panel in panels], title=title, subtitle=[engine.name], theta=theta, turns=found.turns)


def curve_panels(
    found: Curves, reach: float, shown: Sequence[float], *, turns: int | None = None, width: float = WIDTH, title: str = ""
) -> list[Panel]:
    """A panel for each component, on an axis that reaches from -`reach` to `reach`, coloured by the orders `shown`."""
    last = len(found.components) - 1
    return [
        _panel(found, curve, reach or 1.0, shown, turns or found.turns, width, foot=i == last, title=title if i == 0 else "")
        for i, curve in enumerate(found.components)
    ]


def order_names(orders: Sequence[float]) -> list[str]:
    """What the curves are called, the sum last."""
    return [*(f"order {order:g}" for order in orders), TOTAL]


def _panel(
    found: Curves, curve: Curve, reach: float, shown: Sequence[float], turns: int, width: float, *, foot: bool, title: str
) -> Panel:
    import altair as alt

    names = order_names(shown)
    colours = alt.Scale(domain=names, range=[*(PALETTE[i % len(PALETTE)] for i in range(len(shown))), GREY])
    legend = alt.Legend(orient="top", title=None, columns=3, columnPadding=22, symbolType="stroke", symbolStrokeWidth=3)
    ticks = list(range(0, 360 * turns + 1, (90 if width > HALF else 180) * turns))
    axis = alt.Axis(values=ticks) if foot else alt.Axis(values=ticks, labels=False)
    x = alt.X(
        "x:Q", scale=alt.Scale(domain=[0, 360 * turns], nice=False), title="crank angle θ (degrees)" if foot else None, axis=axis
    )
    y = alt.Y(
        "y:Q",
        scale=alt.Scale(domain=[-1.08 * reach, 1.08 * reach], nice=False),
        title=_axis_title(found, curve),
        axis=alt.Axis(tickCount=4),
    )
    rows = _rows(curve, found.shown, turns)
    base = of_rows(rows).mark_line(strokeJoin="round")
    lines = base.encode(
        x=x, y=y, color=alt.Color("what:N", scale=colours, legend=legend), strokeWidth=alt.StrokeWidth("width:Q", scale=None)
    )
    rule = of_rows([{}]).transform_calculate(x=f"theta - {360 * turns} * floor(theta / {360 * turns + 1e-6})", y=_sum(curve))
    line = rule.mark_rule(color=VERMILION, strokeWidth=1.2, strokeDash=[3, 2]).encode(x=x)
    dot = rule.mark_point(color=VERMILION, filled=True, opacity=1, size=70, shape="circle").encode(x=x, y=y)
    layers = [lines, line, dot]
    if not curve.orders.size:
        said = of_rows([{"x": 180 * turns, "y": 0}]).mark_text(dy=-12, fontSize=13, color=GREY)
        layers.append(said.encode(x=x, y=y, text=alt.TextValue(_nothing(found, curve))))
    return layered(layers, width=width, height=120 if len(found.components) > 1 else 170, title=title)


def _axis_title(found: Curves, curve: Curve) -> str:
    return curve.component if curve.component == found.quantity else f"{found.quantity} {curve.component}"


def _nothing(found: Curves, curve: Curve) -> str:
    where = "" if curve.component == found.quantity else {"up": " up or down", "right": " to the sides"}[curve.component]
    return f"no {found.quantity}{where}"


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
            {"x": round(degrees(a), 6), "y": float(v), "what": name, "width": width} for a, v in zip(angles, values, strict=True)
        ]
    # the sum first, so that the orders are drawn over it
    return sorted(rows, key=lambda row: row["what"] != TOTAL)


def _sum(curve: Curve) -> str:
    terms = [
        f"({c.real:.12g}) * cos({order:.12g} * theta * PI / 180) - ({c.imag:.12g}) * sin({order:.12g} * theta * PI / 180)"
        for order, c in zip(curve.orders.tolist(), curve.amplitudes.tolist(), strict=True)
    ]
    return " + ".join(terms) or "0"
