"""Force, couple, rolling moment and torque over the crank angle, order by order and together."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import chain, cycle, islice
from math import degrees, pi
from typing import Any, NamedTuple, get_args

import numpy as np

from crankstar import spectra
from crankstar.charts.canvas import abreast, curve_height, half_width, panel_width
from crankstar.charts.choices import quantity_shown
from crankstar.charts.comparison import compared
from crankstar.charts.crank_angle import across, at_theta, waves
from crankstar.charts.drawing import GREY, LINES, PALETTE, VERMILION, Panel, checked_order, layered
from crankstar.charts.grammar import (
    DISC,
    Channel,
    Chart,
    Layer,
    constant,
    field,
    of_rows,
    own,
    span,
)
from crankstar.charts.letters import together
from crankstar.charts.resting import of_inertia
from crankstar.charts.sums import Engines, Quantity, Signal, Sum, in_one_unit, several, sums
from crankstar.language.messages import N_, _
from crankstar.mechanics.excitation import Reference
from crankstar.mechanics.remains import NEGLIGIBLE, sizes
from crankstar.spectra import Complex, Real, Spectrum

VISIBLE = 0.01
"""Share of the greatest order below which one is not drawn by itself, unless asked for."""
MOST_ORDERS = 4
TOTAL = N_("all orders")
BAND = N_("Estimated masses or lengths: the band is the range of all orders together.")
TITLES = {
    "force": N_("Force over the crank angle, in {unit}"),
    "couple": N_("Couple over the crank angle, in {unit}"),
    "roll": N_("Rolling moment over the crank angle, in {unit}"),
    "torque": N_("Inertia torque over the crank angle, in {unit}"),
}
COMPONENTS = {
    ("force", "up"): (N_("force up"), N_("no vertical force")),
    ("force", "right"): (N_("force right"), N_("no horizontal force")),
    ("couple", "up"): (N_("pitch M_V"), N_("no pitch")),
    ("couple", "right"): (N_("yaw M_H"), N_("no yaw")),
    ("roll", "roll"): (N_("rolling moment"), N_("no rolling moment")),
    ("torque", "torque"): (N_("inertia torque"), N_("no inertia torque")),
}
"""The title of the axis of each component, and the note where it is zero."""


class Curve(NamedTuple):
    """A component over the crank angle: `amplitudes` c of Re(c exp(i k theta)) by order k.

    `ends` are orders and amplitudes in the middle and at the corners of the ranges of an engine.
    """

    component: str
    orders: Real
    amplitudes: Complex
    ends: tuple[tuple[Real, Complex], ...] = ()

    def value(self, angles: Real) -> Real:
        """At crank angles, radians."""
        return np.real(self.amplitudes @ np.exp(1j * self.orders[:, None] * angles))

    def band(self, angles: Real) -> tuple[Real, Real] | None:
        """The lowest and the highest value at crank angles; None of an engine without ranges."""
        if not self.ends:
            return None
        values = np.array([Curve("", *end).value(angles) for end in self.ends])
        own = self.value(angles)
        return np.minimum(own, values.min(axis=0)), np.maximum(own, values.max(axis=0))

    def of(self, kept: Real) -> Curve:
        """The share of some orders."""
        return Curve(self.component, self.orders[kept], self.amplitudes[kept])


def _curves(whole: Sum) -> tuple[Curve, ...]:
    """The components of force and couple upward and to the right, or a signal as one."""
    parts = _components(whole.quantity, whole.spectrum)
    ends = [_components(whole.quantity, end) for end in whole.ends]
    orders = [end.orders for end in whole.ends]
    least = NEGLIGIBLE * sizes(whole.spectrum).max(initial=0.0)
    return tuple(
        Curve(name, whole.spectrum.orders, amplitudes)
        .of(np.abs(amplitudes) > least)
        ._replace(ends=tuple(zip(orders, [end[name] for end in ends], strict=True)))
        for name, amplitudes in parts.items()
    )


def _components(quantity: str, spectrum: Spectrum) -> dict[str, Complex]:
    """The amplitudes of the upward and the rightward component, or of a signal."""
    if quantity in get_args(Quantity):
        return {"up": spectra.vertical(spectrum), "right": spectra.horizontal(spectrum)}
    return {quantity: spectra.amplitude(spectrum)}


def _reach(curves: Sequence[Curve], turns: int) -> float:
    """The greatest value of any curve, together or of one order."""
    angles = np.linspace(0, 2 * pi * turns, 721)
    values = [np.abs(part) for one in curves for part in (one.amplitudes, one.value(angles))]
    values += [np.abs(end) for one in curves for end in one.band(angles) or ()]
    return max(float(each.max(initial=0.0)) for each in values)


def _strongest(curves: Sequence[Curve]) -> list[float]:
    """The orders that are drawn by themselves."""
    greatest: dict[float, float] = {}
    for curve in curves:
        for order, size in zip(curve.orders.tolist(), np.abs(curve.amplitudes), strict=True):
            greatest[order] = max(greatest.get(order, 0.0), size)
    ranked = sorted(greatest, key=lambda order: -greatest[order])[:MOST_ORDERS]
    return [order for order in ranked if greatest[order] >= VISIBLE * greatest[ranked[0]]]


def over_turn(
    engine: Engines,
    *,
    quantity: Signal | None = None,
    orders: Sequence[float] | None = None,
    speed: float | None = None,
    reference: Reference | None = None,
    theta: float = 0.0,
) -> Chart:
    """A quantity over one period of the crank angle: by order (thin), sum (thick), rule at `theta`.

    Without a `quantity` it is the first of force, couple, rolling moment and torque of which
    something is left. Force and couple have a panel for their upward and one for their rightward
    component. `orders` names those drawn by themselves, else the strongest four; the sum is always
    of all. In units of m r w^2 or, at a `speed` (rad/s), in N and N m. Several engines stand side
    by side on common axes. Raises ChartError.
    """
    engines = several(engine)
    choice = quantity_shown(engines, quantity, among=Signal, reference=reference)
    asked = None if orders is None else [checked_order(order) for order in orders]
    wholes = in_one_unit(
        [sums(one, [choice.quantity], speed=speed, reference=reference)[0] for one in engines]
    )
    turns = max(one.turns for one in wholes)
    curves = [_curves(whole) for whole in wholes]
    shown = [sorted(_strongest(each) if asked is None else asked) for each in curves]
    names = [*map(_name, sorted({*chain(*shown)})), _(TOTAL)]
    reach = max(_reach(each, turns) for each in curves) or 1.0
    width = panel_width() if abreast(len(engines)) == 1 else half_width() - 30
    blocks = [
        [
            [
                _panel(
                    curve, choice.quantity, _rows(curve, orders, turns), names, reach, turns, width
                )
            ]
            for curve in each
        ]
        for each, orders in zip(curves, shown, strict=True)
    ]
    title = _(TITLES[choice.quantity], unit=together(wholes[0].unit))
    return compared(
        engines,
        blocks,
        title=title,
        speed=speed,
        theta=theta,
        turns=turns,
        ranges=_(BAND),
        rests=of_inertia(engines, [choice.quantity], speed=speed, reference=reference),
    )


def _name(order: float) -> str:
    return _("order {order}", order=f"{order:g}")


def _panel(
    curve: Curve,
    quantity: str,
    rows: list[dict[str, Any]],
    names: Sequence[str],
    reach: float,
    turns: int,
    width: float,
) -> Panel:
    """A component from -`reach` to `reach`; `names` have a colour each, the sum is grey."""
    colours = {"domain": names, "range": [*islice(cycle(PALETTE), len(names) - 1), GREY]}
    x = across(
        turns, ticks=(90 if width > half_width() else 180) * turns, foot=curve.component != "up"
    )
    title, none = (_(words) for words in COMPONENTS[quantity, curve.component])
    y = field("y:Q", scale=span(-1.08 * reach, 1.08 * reach), title=title, axis={"tickCount": 4})
    lines = (
        of_rows(rows)
        .mark("line", strokeJoin="round")
        .encode(
            x=x,
            y=y,
            color=field("what:N", scale=colours, legend={**LINES, "columns": 3}),
            strokeWidth=own("width:Q"),
        )
    )
    rule = at_theta(turns, y=waves(curve.orders, curve.amplitudes))
    line = rule.mark("rule", color=VERMILION, strokeWidth=1.2, strokeDash=[3, 2]).encode(x=x)
    dot = rule.mark("point", **DISC, color=VERMILION, size=70).encode(x=x, y=y)
    band = _band(curve, turns, reach, x, y)
    layers = [*band, lines, line, dot]
    if not curve.orders.size and not band:  # other masses than the typical ones leave the band
        note = of_rows([{"x": 180 * turns, "y": 0}]).mark("text", dy=-12, fontSize=13, color=GREY)
        layers.append(note.encode(x=x, y=y, text=constant(none)))
    return layered(
        layers, width=width, height=curve_height(170 if curve.component == quantity else 120)
    )


def _band(curve: Curve, turns: int, reach: float, x: Channel, y: Channel) -> list[Layer]:
    """The range of all orders together as an area; none where it is rounding beside `reach`."""
    angles = _angles(curve, turns)
    band = curve.band(angles)
    if band is None or not np.any(band[1] - band[0] > NEGLIGIBLE * reach):
        return []
    rows = [
        {"x": round(degrees(a), 6), "y": float(low), "y2": float(high)}
        for a, low, high in zip(angles, *band, strict=True)
    ]
    area = of_rows(rows).mark("area", color=GREY, opacity=0.3)
    return [area.encode(x=x, y=y, y2=field("y2"))]


def _angles(curve: Curve, turns: int) -> Real:
    """The crank angles of a curve, radians."""
    highest = float(curve.orders.max(initial=1.0))
    return np.linspace(0, 2 * pi * turns, int(min(max(120, 20 * highest * turns), 1500)) + 1)


def _rows(curve: Curve, shown: Sequence[float], turns: int) -> list[dict[str, Any]]:
    """The curve of all orders, and over it those of single ones."""
    angles = _angles(curve, turns)
    drawn = [(_(TOTAL), 3.2, curve)]
    for order in reversed(shown):
        part = curve.of(np.abs(curve.orders - order) < 1e-9)
        drawn += [(_name(order), 1.8, part)] if part.orders.size else []
    return [
        {"x": round(degrees(a), 6), "y": float(v), "what": name, "width": width}
        for name, width, part in drawn
        for a, v in zip(angles, part.value(angles), strict=True)
    ]
