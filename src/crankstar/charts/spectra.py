"""The spectrum of an engine: peak force, couple and roll of each order."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from typing import Any, NamedTuple

import numpy as np

from crankstar import spectra
from crankstar.charts.drawing import (
    BLUE,
    GREY,
    ORANGE,
    SMALL,
    WIDTH,
    Panel,
    brief,
    figure,
    layered,
    text_width,
)
from crankstar.charts.grammar import Chart, constant, field, of_rows
from crankstar.charts.labels import WIDER, Box, meets
from crankstar.engine.engine import Engine
from crankstar.language.messages import N_, _
from crankstar.language.numbers import unit_text
from crankstar.mechanics.balance import balance, total
from crankstar.mechanics.excitation import Reference, Totals, rolling_moment
from crankstar.mechanics.remains import NEGLIGIBLE
from crankstar.spectra import Spectrum

VISIBLE = 1e-3
"""Share of the greatest order of a quantity from which an order is drawn."""
MOST_ORDERS = 12
HEIGHT, HEADROOM = 90, 1.25
"""Px of a panel, and the end of its axis in lengths of the greatest bar."""
NARROW = 26
"""Px for an order below which bars have no numbers."""
AHEAD, AGAINST = N_("with the crank"), N_("against the crank")
TITLE = N_("Peak force, couple and roll by order")
AXES = {
    "force": N_("force\n({unit})"),
    "couple": N_("couple\n({unit})"),
    "roll": N_("roll\n({unit})"),
}
NONE = {"force": N_("no force"), "couple": N_("no couple"), "roll": N_("no roll")}


class Bars(NamedTuple):
    """Lengths by order: of the vectors with and against the crank, or the amplitude of the roll."""

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
        """The orders that are visible beside the greatest, up to MOST_ORDERS."""
        sizes = zip(self.orders, self.ahead, self.against, strict=True)
        return tuple(order for order, a, b in sizes if a + b > VISIBLE * self.reach)[:MOST_ORDERS]

    def of(self, orders: Collection[float]) -> Bars:
        """The bars of these orders."""
        kept = [
            row
            for row in zip(self.orders, self.ahead, self.against, strict=True)
            if row[0] in orders
        ]
        return self._replace(
            **{
                name: tuple(row[i] for row in kept)
                for i, name in enumerate(("orders", "ahead", "against"))
            }
        )


def bars(
    engine: Engine, *, speed: float | None = None, reference: Reference | None = None
) -> tuple[Bars, ...]:
    """Force, couple and rolling moment by order, without those that are rounding errors."""
    return side_bars([engine], speed=speed, reference=reference)[0]


def side_bars(
    engines: Sequence[Engine], *, speed: float | None = None, reference: Reference | None = None
) -> list[tuple[Bars, ...]]:
    """The bars of several engines, with every order that is visible in one of them."""
    engines_bars = [_all_bars(engine, speed=speed, reference=reference) for engine in engines]
    shown = [
        {order for one in column for order in one.visible()}
        for column in zip(*engines_bars, strict=True)
    ]
    return [
        tuple(one.of(orders) for one, orders in zip(row, shown, strict=True))
        for row in engines_bars
    ]


def _all_bars(
    engine: Engine, *, speed: float | None, reference: Reference | None
) -> tuple[Bars, ...]:
    result = balance(engine, speed=speed, reference=reference)
    sums = total(result)
    return tuple(
        _bars(
            quantity,
            spectrum,
            shares,
            getattr(result.units, "moment" if quantity == "roll" else quantity),
        )
        for quantity, spectrum, shares in (
            ("force", sums.force, result.force),
            ("couple", sums.couple, result.couple),
            (
                "roll",
                rolling_moment(sums),
                rolling_moment(
                    Totals(result.force, result.couple, result.axis_moment, result.torque)
                ),
            ),
        )
    )


def _bars(quantity: str, spectrum: Spectrum, shares: Spectrum, unit: str) -> Bars:
    ahead, against = np.abs(spectrum.forward), np.abs(spectrum.backward)
    if quantity == "roll":
        ahead, against = np.abs(spectra.amplitude(spectrum)), 0 * against
    scale = float((np.abs(shares.forward) + np.abs(shares.backward)).sum(axis=-2).max(initial=0.0))
    sizes = ahead + against
    kept = np.flatnonzero(sizes > NEGLIGIBLE * scale)
    return Bars(
        quantity,
        unit_text(unit),
        *(tuple(values[kept].tolist()) for values in (spectrum.orders, ahead, against)),
    )


def spectrum(
    engine: Engine, *, speed: float | None = None, reference: Reference | None = None
) -> Chart:
    """Peak force, couple and roll of each order as bars.

    The bars of force and couple are stacked: the vector with the crank and the one against it,
    whose sum is the semi-major axis of the ellipse. In units of m r w^2 or, at a `speed` (rad/s),
    in N and N m.
    """
    shown = bars(engine, speed=speed, reference=reference)
    return figure(bar_panels(shown), title=_(TITLE), subtitle=[engine.name])


def bar_panels(
    quantities: Sequence[Bars],
    *,
    orders: Sequence[float] | None = None,
    reaches: Sequence[float] | None = None,
    width: float = WIDTH,
    title: str = "",
) -> list[list[Panel]]:
    """The panels of a spectrum one below the other, on common `orders` and `reaches` if given."""
    orders = orders or sorted({order for one in quantities for order in one.orders})
    reaches = reaches or [one.reach for one in quantities]
    last = len(quantities) - 1
    return [
        [_panel(one, orders, reach or 1.0, width, foot=i == last, title=title if i == 0 else "")]
        for i, (one, reach) in enumerate(zip(quantities, reaches, strict=True))
    ]


def _panel(
    one: Bars, orders: Sequence[float], reach: float, width: float, *, foot: bool, title: str
) -> Panel:
    names = [f"{order:g}" for order in orders] or ["1"]
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
        scale={"domain": [0, HEADROOM * reach], "nice": False},
        axis={"tickCount": 3, "titlePadding": 18},  # its second line stands where one would end
    )
    colours = {"domain": [_(AHEAD), _(AGAINST)], "range": [BLUE, ORANGE]}
    legend = {"orient": "top", "title": None, "symbolType": "square", "columnPadding": 26}
    layers = [
        of_rows(_rows(one))
        .mark("bar", size=_breadth(names, width))
        .encode(x=x, y=y, y2=field("from"), color=_colour(one, colours, legend))
    ]
    lengths_above = tops(one, names, reach=reach, width=width)
    if lengths_above:
        text = of_rows(lengths_above).mark("text", fontSize=SMALL, color=GREY)
        layers.append(text.encode(x=x, y=y, text=field("text:N")))
    if not one.orders:
        middle = of_rows([{"to": 0.6 * reach}]).mark("text", fontSize=13, color=GREY)
        layers.append(
            middle.encode(x=constant(width / 2), y=y, text=constant(_(NONE[one.quantity])))
        )
    return layered(layers, width=width, height=HEIGHT, title=title)


def _breadth(names: Sequence[str], width: float) -> float:
    return max(6.0, min(22.0, width / len(names) * 0.6))


def tops(one: Bars, names: Sequence[str], *, reach: float, width: float) -> list[dict[str, Any]]:
    """The length of each bar above it, higher or left out where it would overlap another.

    `to` is the middle of the text in the unit of the bars.
    """
    slot = width / len(names)
    if slot <= NARROW:
        return []
    lengths = [
        (names.index(f"{order:g}"), a + b)
        for order, a, b in zip(one.orders, one.ahead, one.against, strict=True)
    ]
    px = HEIGHT / (HEADROOM * reach)
    taken: list[Box] = [
        Box(complex(size * px / 2, (at + 0.5) * slot), _breadth(names, width) / 2, size * px / 2)
        for at, size in lengths
    ]
    out: list[dict[str, Any]] = []
    for at, size in sorted(lengths, key=lambda bar: -bar[1]):
        text = brief(size)
        half = WIDER * text_width(text, SMALL) / 2
        for lift in (8.0, 21.0, 34.0):
            here = Box(complex(size * px + lift, (at + 0.5) * slot), half, SMALL / 2)
            if here.middle.real + here.upright <= HEIGHT + 4 and not any(
                meets(here, other) for other in taken
            ):
                taken.append(here)
                out.append({"order": names[at], "to": (size * px + lift) / px, "text": text})
                break
    return out


def _colour(one: Bars, colours: Any, legend: Any) -> Any:
    return (
        constant(GREY) if one.quantity == "roll" else field("what:N", scale=colours, legend=legend)
    )


def _rows(one: Bars) -> list[dict[str, Any]]:
    rows = []
    for order, ahead, against in zip(one.orders, one.ahead, one.against, strict=True):
        if one.quantity == "roll":
            rows.append({"order": f"{order:g}", "from": 0.0, "to": ahead, "what": "roll"})
            continue
        rows.append({"order": f"{order:g}", "from": 0.0, "to": ahead, "what": _(AHEAD)})
        rows.append(
            {"order": f"{order:g}", "from": ahead, "to": ahead + against, "what": _(AGAINST)}
        )
    return [row for row in rows if row["to"] > row["from"]]
