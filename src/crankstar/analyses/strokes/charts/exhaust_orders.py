"""The orders of the exhaust: equal pulses at the firings of each bank or manifold, added up."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from crankstar.analyses.strokes.charts.timing_diagram import NO_ORDER
from crankstar.charts.canvas import curve_height, panel_width
from crankstar.charts.drawing import GREY, PALETTE, Panel, figure, heading, layered
from crankstar.charts.grammar import Chart, constant, field, of_rows, span
from crankstar.charts.letters import SMALL, text_width
from crankstar.charts.resting import of_firing
from crankstar.engine.engine import Engine
from crankstar.firing.exhaust_orders import exhaust_orders, firing_rate
from crankstar.language.messages import _
from crankstar.language.numbers import number, order_text

HEIGHT, HEADROOM = 56, 1.35
"""Px of a panel, and the end of its axis in pulses of its cylinders."""
LIFT = 8.0
"""Px from the end of a bar to the middle of its number."""
HIGHEST = 8.0
"""The highest order that is drawn, or that in which the engine would fire evenly, if higher."""
VISIBLE = 0.01
"""Share of all pulses of a panel from which an order is drawn."""
EXTENT = 24
"""Px for the numbers of an axis: panels begin in one line."""


def exhaust_order_chart(engine: Engine) -> Chart:
    """|S_q| of every exhaust group and of the whole engine, to order 8 at least: bars in pulses.

    S_q is the sum of exp(-i q theta) over the firing angles theta of a group. A group of one
    cylinder has all orders alike, and no panel of its own beside the whole engine.
    """
    panels: list[Panel] = []
    if not engine.firing_order:
        words = of_rows([{"x": 0}]).mark("text", fontSize=13, color=GREY)
        only = words.encode(x=constant(panel_width() / 2), text=constant(_(NO_ORDER)))
        panels.append(layered([only], width=panel_width(), height=60))
    else:
        found = exhaust_orders(engine, highest=max(HIGHEST, firing_rate(engine)))
        several = len(found.groups) > 1
        shown = [
            (group.name, len(group.chambers), np.abs(sums).tolist())
            for group, sums in zip(found.groups, found.sums, strict=True)
            if len(group.chambers) > 1 or not several
        ]
        if several:
            whole = (_("whole engine"), len(engine.chambers), np.abs(found.whole).tolist())
            shown.append(whole)
        panels = [
            _panel(
                name,
                count,
                lengths,
                found.orders.tolist(),
                place=index,
                foot=index == len(shown) - 1,
            )
            for index, (name, count, lengths) in enumerate(shown)
        ]
    return figure(
        [[panel] for panel in panels],
        title=_("Exhaust orders"),
        subtitle=[*heading(engine), _("equal pulses at the firing angles")],
        rests=of_firing(engine),
    )


def _panel(
    title: str,
    count: int,
    lengths: Sequence[float],
    orders: Sequence[float],
    *,
    place: int,
    foot: bool,
) -> Panel:
    """One group: a bar for each order that is there, its length at its end."""
    names = [order_text(order) for order in orders]
    slot = panel_width() / len(names)
    fits = max(text_width(name, SMALL) for name in names) < 0.9 * slot
    shown = [name for name, order in zip(names, orders, strict=True) if fits or order % 1 == 0]
    x = field(
        "order:N",
        sort=None,
        scale={"domain": names},
        title=_("order") if foot else None,
        axis={"labelAngle": 0, "labels": foot, "values": shown, "labelOverlap": False},
    )
    y = field(
        "to:Q",
        title=_("pulses"),
        scale=span(0, HEADROOM * count),
        axis={"tickCount": 2, "minExtent": EXTENT, "labelOverlap": False},
    )
    rows = [
        {"order": name, "from": 0.0, "to": length, "text": number(round(length, 1))}
        for name, length in zip(names, lengths, strict=True)
        if length > VISIBLE * count
    ]
    bars = of_rows(rows).mark("bar", size=max(6.0, min(22.0, 0.6 * slot)))
    colour = constant(PALETTE[place % len(PALETTE)])
    layers = [bars.encode(x=x, y=y, y2=field("from"), color=colour)]
    if max((text_width(row["text"], SMALL) for row in rows), default=0.0) < slot:
        text = of_rows(rows).mark("text", fontSize=SMALL, color=GREY, dy=-LIFT)
        layers.append(text.encode(x=x, y=y, text=field("text:N")))
    return layered(layers, width=panel_width(), height=curve_height(HEIGHT), title=title)
