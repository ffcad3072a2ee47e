"""The spectrum of an engine: peak force, couple and rolling moment of each order."""

from __future__ import annotations

from collections.abc import Container, Sequence
from typing import Any, NamedTuple

import numpy as np

from crankstar import spectra
from crankstar.charts.canvas import abreast, curve_height, half_width, panel_width
from crankstar.charts.comparison import compared
from crankstar.charts.drawing import BLUE, GREY, ORANGE, Panel, brief, layered
from crankstar.charts.estimates import length_ranges
from crankstar.charts.grammar import Chart, constant, field, of_rows, span
from crankstar.charts.labels import Box, meets
from crankstar.charts.letters import SMALL, text_width
from crankstar.charts.resting import of_inertia
from crankstar.charts.sums import Engines, Sum, in_one_unit, several, sums
from crankstar.language.messages import N_, _
from crankstar.mechanics.excitation import Reference

VISIBLE = 1e-3
"""Share of the greatest order of a quantity from which an order is drawn."""
MOST_ORDERS = 12
HEIGHT, HEADROOM = 90, 1.25
"""Px of a panel, and the end of its axis in lengths of the greatest bar."""
NARROW = 26
"""Px for an order below which bars have no numbers."""
LIFTS = (8.0, 21.0, 34.0)
"""px from the end of a bar to the middle of its number, in the order in which they are tried."""
TICK = 9
"""px: how wide the ends of a whisker are."""
SIDES = {0: "center", 1: "left", -1: "right"}
BESIDE = 8.0
"""The alignment of a number above its bar and to a side of a whisker; px between the two."""
AHEAD, AGAINST = N_("with the crank"), N_("against the crank")
TITLE = N_("Peak force, couple and rolling moment by order")
AXES = {
    "force": N_("force\n({unit})"),
    "couple": N_("couple\n({unit})"),
    "roll": N_("rolling moment\n({unit})"),
}
WHISKERS = N_("Estimated masses or lengths: each thin line is the range of a bar.")
FINEST = 0.01
"""Share of what one piston alone makes up to which an axis reaches at least."""
COARSE = N_("Each axis reaches at least {share} % of m r ω², m r ω² a or m r² ω² of one piston.")
NONE = {"force": N_("no force"), "couple": N_("no couple"), "roll": N_("no rolling moment")}


SYMBOL, COLUMNS_APART = 18.0, 26.0
"""px of the legend: a square with its room, and between two columns."""


class Bars(NamedTuple):
    """Lengths by order: of the vectors with and against the crank, or of the rolling moment.

    `ends` are the lowest and the highest sum of the two of an estimated engine; `least` is what an
    axis reaches at least.
    """

    quantity: str
    unit: str
    lengths: dict[float, tuple[float, float]]
    ends: dict[float, tuple[float, float]]
    least: float = 0.0

    @property
    def reach(self) -> float:
        """The greatest of all orders."""
        return max(map(self.top, self.lengths), default=0.0)

    def top(self, order: float) -> float:
        """The length of an order, or the upper end of its range."""
        return max(sum(self.lengths[order]), *self.ends.get(order, (0.0,)))

    def of(self, orders: Container[float]) -> Bars:
        """The lengths of some orders."""
        lengths = {order: two for order, two in self.lengths.items() if order in orders}
        return self._replace(lengths=lengths)

    def visible(self) -> list[float]:
        """The orders that are visible beside the greatest, up to MOST_ORDERS."""
        least = VISIBLE * self.reach
        return [order for order in self.lengths if self.top(order) > least][:MOST_ORDERS]


def spectrum(
    engine: Engines, *, speed: float | None = None, reference: Reference | None = None
) -> Chart:
    """Peak force, couple and rolling moment of each order as bars.

    The bars of force and couple are stacked: the vector with the crank and the one against it,
    whose sum is the semi-major axis of the ellipse. In units of m r w^2 or, at a `speed` (rad/s),
    in N and N m. An axis reaches at least FINEST of what one piston alone makes, m r w^2, m r w^2 a
    or m r^2 w^2, and the figure says so: a force of nothing is no full bar. Several engines stand
    side by side, with every order that is visible in one of them.
    """
    engines = several(engine)
    wholes = [sums(one, AXES, speed=speed, reference=reference) for one in engines]
    columns = [list(map(_bars, in_one_unit(column))) for column in zip(*wholes, strict=True)]
    bars = list(zip(*columns, strict=True))
    shown = [{order for one in column for order in one.visible()} for column in columns]
    names = [f"{order:g}" for order in sorted(set().union(*shown))] or ["1"]
    tops = [max(one.reach for one in column) for column in columns]
    floors = [max(one.least for one in column) for column in columns]
    reaches = list(map(max, tops, floors))
    raised = any(0 < top < floor for top, floor in zip(tops, floors, strict=True))
    notes = [_(COARSE, share=f"{100 * FINEST:g}")] if raised else []
    width = panel_width() if abreast(len(engines)) == 1 else half_width() - 30
    blocks = [
        [
            [_panel(one.of(own), names, reach or 1.0, width)]
            for one, own, reach in zip(row, shown, reaches, strict=True)
        ]
        for row in bars
    ]
    rests = of_inertia(engines, speed=speed, reference=reference)
    return compared(
        engines, blocks, title=_(TITLE), speed=speed, ranges=_(WHISKERS), notes=notes, rests=rests
    )


def _bars(whole: Sum) -> Bars:
    spectrum = whole.spectrum
    if whole.quantity == "roll":
        ahead = np.abs(spectra.amplitude(spectrum))
        against = 0 * ahead
    else:
        ahead, against = np.abs(spectrum.forward), np.abs(spectrum.backward)
    orders = spectrum.orders.tolist()
    lengths = dict(zip(orders, zip(ahead.tolist(), against.tolist(), strict=True), strict=True))
    ends = dict(zip(orders, length_ranges(spectrum, whole.ends), strict=False))
    return Bars(whole.quantity, whole.unit, lengths, ends, FINEST * whole.piston)


def _panel(one: Bars, names: Sequence[str], reach: float, width: float) -> Panel:
    foot = one.quantity == "roll"
    x = field(
        "order:N",
        sort=None,
        scale={"domain": names},
        title=_("order") if foot else None,
        axis={"labelAngle": 0, "labels": foot},
    )
    y = field(
        "to:Q",
        title=_(AXES[one.quantity], unit=one.unit).split("\n"),
        scale=span(0, HEADROOM * reach),
        axis={"tickCount": 3, "titlePadding": 18},  # its second line stands where one would end
    )
    colours = {"domain": [_(AHEAD), _(AGAINST)], "range": [BLUE, ORANGE]}
    colour = constant(GREY) if foot else field("what:N", scale=colours, legend=_legend())
    rows = []
    for order, (ahead, against) in one.lengths.items():
        for begin, length, what in ((0.0, ahead, AHEAD), (ahead, against, AGAINST)):
            if length > 0:
                bar = {"from": begin, "to": begin + length}
                rows.append({"order": f"{order:g}", **bar, "what": "roll" if foot else _(what)})
    bars = of_rows(rows).mark("bar", size=_breadth(names, width))
    layers = [bars.encode(x=x, y=y, y2=field("from"), color=colour)]
    whiskers = [
        {"order": f"{order:g}", "from": low, "to": high}
        for order, (low, high) in one.ends.items()
        if order in one.lengths and high > low
    ]
    if whiskers:
        rule = of_rows(whiskers).mark("rule", strokeWidth=1.6, color=GREY)
        layers.append(rule.encode(x=x, y=y, y2=field("from")))
        for end in ("from", "to"):
            tick = of_rows(whiskers).mark("tick", thickness=1.6, size=TICK, color=GREY)
            layers.append(tick.encode(x=x, y={**y, "field": end}))
    numbers = tops(one, names, reach=reach, width=width)
    for side, align in SIDES.items():
        own = [row for row in numbers if row["side"] == side]
        if own:
            style = {"align": align, "dx": side * BESIDE}
            text = of_rows(own).mark("text", fontSize=SMALL, color=GREY, **style)
            layers.append(text.encode(x=x, y=y, text=field("text:N")))
    if not one.lengths:
        middle = of_rows([{"to": 0.6 * reach}]).mark("text", fontSize=13, color=GREY)
        words = constant(_(NONE[one.quantity]))
        layers.append(middle.encode(x=constant(width / 2), y=y, text=words))
    return layered(layers, width=width, height=curve_height(HEIGHT))


def _legend() -> dict[str, Any]:
    """The names of the two directions in a row, or one below the other where that is too narrow."""
    row = text_width(_(AHEAD)) + text_width(_(AGAINST)) + 2 * SYMBOL + COLUMNS_APART
    return {
        "orient": "top",
        "title": None,
        "symbolType": "square",
        "columnPadding": COLUMNS_APART,
        "columns": 2 if row <= panel_width() else 1,
    }


def _breadth(names: Sequence[str], width: float) -> float:
    return max(6.0, min(22.0, width / len(names) * 0.6))


def tops(one: Bars, names: Sequence[str], *, reach: float, width: float) -> list[dict[str, Any]]:
    """The length of each bar at its end, or left out where it would overlap another.

    `to` is the middle of the text in the unit of the bars. Where a bar has a whisker, its length
    stands to a side of it, else above the bar, or higher where that is taken.
    """
    slot = width / len(names)
    if slot <= NARROW:
        return []
    px = curve_height(HEIGHT) / (HEADROOM * reach)
    sizes = {names.index(f"{order:g}"): sum(two) * px for order, two in one.lengths.items()}
    whiskers = {
        names.index(f"{order:g}"): (low * px, high * px)
        for order, (low, high) in one.ends.items()
        if order in one.lengths and high > low
    }
    half = _breadth(names, width) / 2
    taken = [_upright(0.0, size, (at + 0.5) * slot, half) for at, size in sizes.items()]
    taken += [_upright(*ends, (at + 0.5) * slot, TICK / 2) for at, ends in whiskers.items()]
    out: list[dict[str, Any]] = []
    for at, size in sorted(sizes.items(), key=lambda bar: -bar[1]):
        text = brief(size / px)
        wide = text_width(text, SMALL)
        places = [(side, 8.0) for side in (1, -1)] if at in whiskers else [(0, y) for y in LIFTS]
        for side, lift in places:
            middle = complex(size + lift, (at + 0.5) * slot + side * (BESIDE + wide / 2))
            here = Box(middle, wide / 2, SMALL / 2)
            inside = size + lift + SMALL / 2 <= curve_height(HEIGHT) + 4
            inside &= wide / 2 - 4 <= middle.imag <= width - wide / 2 + 4
            if inside and not any(meets(here, other) for other in taken):
                taken.append(here)
                out.append(
                    {"order": names[at], "to": (size + lift) / px, "text": text, "side": side}
                )
                break
    return out


def _upright(low: float, high: float, across: float, half: float) -> Box:
    """The place of a bar or a whisker between two heights, px."""
    return Box(complex((low + high) / 2, across), half, (high - low) / 2)
