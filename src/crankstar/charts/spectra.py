"""The spectrum of an engine: how great force, couple and roll of each order become."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from crankstar import phasor
from crankstar.balance import balance, total
from crankstar.charts.drawing import BLUE, GREY, ORANGE, SMALL, WIDTH, Panel, brief, figure, layered, of_rows, text_width
from crankstar.charts.labels import WIDER, Box, meets
from crankstar.engine import Engine
from crankstar.mechanism import Reference, Totals, block_roll
from crankstar.phasor import Spectrum
from crankstar.wording import unit_text

if TYPE_CHECKING:
    import altair

VISIBLE = 1e-3
"""Share of the greatest order of a quantity above which an order is drawn."""
MOST_ORDERS = 12
HEIGHT, HEADROOM = 90, 1.25
"""Px of a panel, and how far its axis reaches beside the greatest bar."""
NARROW = 26
"""Px for an order below which nothing is written above its bar."""
AHEAD, AGAINST, ROLL = "with the crank", "against it", "roll"


class Bars(NamedTuple):
    """Lengths by order: of what turns with the crank and against it for force and couple, the amplitude for roll."""

    quantity: str
    unit: str
    orders: tuple[float, ...]
    ahead: tuple[float, ...]
    against: tuple[float, ...]

    @property
    def reach(self) -> float:
        """The greatest of all orders."""
        return max((a + b for a, b in zip(self.ahead, self.against, strict=True)), default=0.0)

    def visible(self) -> tuple[float, ...]:
        """The orders that can be seen beside the greatest, no more than can be drawn."""
        sizes = zip(self.orders, self.ahead, self.against, strict=True)
        return tuple(order for order, a, b in sizes if a + b > VISIBLE * self.reach)[:MOST_ORDERS]

    def of(self, orders: Collection[float]) -> Bars:
        """The bars of these orders alone, as far as they are there."""
        kept = [row for row in zip(self.orders, self.ahead, self.against, strict=True) if row[0] in orders]
        return self._replace(**{name: tuple(row[i] for row in kept) for i, name in enumerate(("orders", "ahead", "against"))})


def bars(engine: Engine, *, speed: float | None = None, reference: Reference | None = None) -> tuple[Bars, ...]:
    """Force, couple and roll of the block (a flywheel takes the torque) by order; what is rounding beside its parts is left out."""
    return side_bars([engine], speed=speed, reference=reference)[0]


def side_bars(
    engines: Sequence[Engine], *, speed: float | None = None, reference: Reference | None = None
) -> list[tuple[Bars, ...]]:
    """The bars of several engines: an order that can be seen of a quantity in one of them is there in all that have it."""
    found = [_all_bars(engine, speed=speed, reference=reference) for engine in engines]
    shown = [{order for one in column for order in one.visible()} for column in zip(*found, strict=True)]
    return [tuple(one.of(orders) for one, orders in zip(row, shown, strict=True)) for row in found]


def _all_bars(engine: Engine, *, speed: float | None, reference: Reference | None) -> tuple[Bars, ...]:
    result = balance(engine, speed=speed, reference=reference)
    sums = total(result)
    return tuple(
        _bars(quantity, spectrum, shares, result.units._asdict()[quantity])
        for quantity, spectrum, shares in (
            ("force", sums.force, result.force),
            ("couple", sums.couple, result.couple),
            ("roll", block_roll(sums), block_roll(Totals(result.force, result.couple, result.roll, result.torque))),
        )
    )


def _bars(quantity: str, spectrum: Spectrum, shares: Spectrum, unit: str) -> Bars:
    ahead, against = np.abs(spectrum.forward), np.abs(spectrum.backward)
    if quantity == "roll":
        ahead, against = np.abs(phasor.amplitude(spectrum)), 0 * against
    scale = float((np.abs(shares.forward) + np.abs(shares.backward)).sum(axis=-2).max(initial=0.0))
    sizes = ahead + against
    kept = np.flatnonzero(sizes > 1e-9 * scale)
    return Bars(quantity, unit_text(unit), *(tuple(values[kept].tolist()) for values in (spectrum.orders, ahead, against)))


def spectrum(engine: Engine, *, speed: float | None = None, reference: Reference | None = None) -> altair.VConcatChart:
    """How great force, couple and roll of each order become, as bars.

    The bars of force and couple are stacked: the length of the vector that turns with the crank and of the one against it,
    which together are the greatest length, the long half axis of the ellipse. In units of m r w^2 or, at a `speed` (rad/s),
    in N and N m.
    """
    found = bars(engine, speed=speed, reference=reference)
    return figure(bar_panels(found), title="Greatest force, couple and roll of the block by order", subtitle=[engine.name])


def bar_panels(
    found: Sequence[Bars],
    *,
    orders: Sequence[float] | None = None,
    reaches: Sequence[float] | None = None,
    width: float = WIDTH,
    title: str = "",
) -> list[list[Panel]]:
    """The panels of a spectrum one below the other, on common `orders` and `reaches` where they are given."""
    orders = orders or sorted({order for one in found for order in one.orders})
    reaches = reaches or [one.reach for one in found]
    last = len(found) - 1
    return [
        [_panel(one, orders, reach or 1.0, width, foot=i == last, title=title if i == 0 else "")]
        for i, (one, reach) in enumerate(zip(found, reaches, strict=True))
    ]


def _panel(one: Bars, orders: Sequence[float], reach: float, width: float, *, foot: bool, title: str) -> Panel:
    import altair as alt

    names = [f"{order:g}" for order in orders] or ["1"]
    x = alt.X(
        "order:N",
        sort=None,
        scale=alt.Scale(domain=names),
        title="order" if foot else None,
        axis=alt.Axis(labelAngle=0, labels=foot),
    )
    y = alt.Y(
        "to:Q",
        title=f"{one.quantity} ({one.unit})".replace(" (", "\n(").split("\n"),
        scale=alt.Scale(domain=[0, HEADROOM * reach], nice=False),
        axis=alt.Axis(tickCount=3, titlePadding=18),  # its second line stands where one would end
    )
    colours = alt.Scale(domain=[AHEAD, AGAINST], range=[BLUE, ORANGE])
    legend = alt.Legend(orient="top", title=None, symbolType="square", columnPadding=26)
    layers = [
        of_rows(_rows(one))
        .mark_bar(size=_breadth(names, width))
        .encode(x=x, y=y, y2=alt.Y2("from:Q"), color=_colour(alt, one, colours, legend))
    ]
    told = tops(one, names, reach=reach, width=width)
    if told:
        text = of_rows(told).mark_text(fontSize=SMALL, color=GREY)
        layers.append(text.encode(x=x, y=y, text=alt.Text("text:N")))
    if not one.orders:
        middle = of_rows([{"to": 0.6 * reach}]).mark_text(fontSize=13, color=GREY)
        layers.append(middle.encode(x=alt.XValue(width / 2), y=y, text=alt.TextValue(f"no {one.quantity}")))
    return layered(layers, width=width, height=HEIGHT, title=title)


def _breadth(names: Sequence[str], width: float) -> float:
    return max(6.0, min(22.0, width / len(names) * 0.6))


def tops(one: Bars, names: Sequence[str], *, reach: float, width: float) -> list[dict[str, Any]]:
    """What each bar is long, above it: raised where it would meet another, left out where there is no place; the greatest first.

    `to` is where the middle of the text stands, in the unit of the bars.
    """
    slot = width / len(names)
    if slot <= NARROW:
        return []
    lengths = [(names.index(f"{order:g}"), a + b) for order, a, b in zip(one.orders, one.ahead, one.against, strict=True)]
    px = HEIGHT / (HEADROOM * reach)
    taken: list[Box] = [
        Box(complex(size * px / 2, (at + 0.5) * slot), _breadth(names, width) / 2, size * px / 2) for at, size in lengths
    ]
    out: list[dict[str, Any]] = []
    for at, size in sorted(lengths, key=lambda bar: -bar[1]):
        text = brief(size)
        half = WIDER * text_width(text, SMALL) / 2
        for lift in (8.0, 21.0, 34.0):
            here = Box(complex(size * px + lift, (at + 0.5) * slot), half, SMALL / 2)
            if here.middle.real + here.upright <= HEIGHT + 4 and not any(meets(here, other) for other in taken):
                taken.append(here)
                out.append({"order": names[at], "to": (size * px + lift) / px, "text": text})
                break
    return out


def _colour(alt: Any, one: Bars, colours: Any, legend: Any) -> Any:
    return alt.ColorValue(GREY) if one.quantity == "roll" else alt.Color("what:N", scale=colours, legend=legend)


def _rows(one: Bars) -> list[dict[str, Any]]:
    rows = []
    for order, ahead, against in zip(one.orders, one.ahead, one.against, strict=True):
        if one.quantity == "roll":
            rows.append({"order": f"{order:g}", "from": 0.0, "to": ahead, "what": ROLL})
            continue
        rows.append({"order": f"{order:g}", "from": 0.0, "to": ahead, "what": AHEAD})
        rows.append({"order": f"{order:g}", "from": ahead, "to": ahead + against, "what": AGAINST})
    return [row for row in rows if row["to"] > row["from"]]
