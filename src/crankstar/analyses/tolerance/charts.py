"""The amplitudes of engines built to their tolerances, and which tolerance matters most."""

from __future__ import annotations

from collections.abc import Sequence
from math import ceil, log10
from typing import Any

import numpy as np

from crankstar.analyses.tolerance.document import is_of, signal_text
from crankstar.analyses.tolerance.question import BEARING
from crankstar.analyses.tolerance.scatter import OrderScatter, Scatter
from crankstar.analysis.assumptions import MAIN_OF
from crankstar.charts.canvas import curve_height, half_width
from crankstar.charts.drawing import (
    BLUE,
    GREEN,
    GREY,
    VERMILION,
    ChartError,
    Panel,
    figure,
    heading,
    layered,
)
from crankstar.charts.estimates import estimate_lines
from crankstar.charts.grammar import COLOUR, Chart, constant, field, of_rows, span
from crankstar.charts.letters import SMALL, folded, text_width, together
from crankstar.charts.resting import Rests, of_inertia, of_loads
from crankstar.language.messages import _, _n
from crankstar.language.numbers import number, order_text, unit_text
from crankstar.language.shown_units import shown

CLASSES = 48
"""Bars of a histogram."""
BARS = 6
"""Tolerances with a bar of their own; the others are added up."""
MOST_ROWS = 6
"""Orders that are drawn; of how many are not, a line is told."""
SMALL_SHARE = 0.0005
"""Share below which a tolerance is not drawn."""
EXTENT = 24
"""px for the numbers of an axis: panels begin in one line."""
HEIGHT = 170
HEADROOM = 1.3
"""Where the axis of counts ends, in highest bars: room for the words at the rules."""


def rows_of(
    found: Scatter, *, quantities: Sequence[str] = (), orders: Sequence[float] = ()
) -> list[OrderScatter]:
    """The orders asked for; else of force and couple what scatters most.

    Raises ChartError.
    """
    names = list(quantities) or ["force", "couple"]
    out: list[OrderScatter] = []
    for name in names:
        own = [row for row in found.rows if is_of(row, name) and row.rms > 0]
        if orders:
            out += [row for row in own if any(abs(row.order - each) < 1e-9 for each in orders)]
        elif own:
            out.append(max(own, key=lambda row: row.one_in_20 - row.nominal))
    if not out:
        raise ChartError(_("none of these orders scatters; draw others"))
    return out


def scatter_chart(
    found: Scatter, *, quantities: Sequence[str] = (), orders: Sequence[float] = ()
) -> Chart:
    """Of each order the engines by amplitude, and the share of each tolerance in the variance.

    Rules mark the engine as drawn and what 5 % of the engines exceed. Raises ChartError.
    """
    every = rows_of(found, quantities=quantities, orders=orders)
    rows, left = every[:MOST_ROWS], len(every) - MOST_ROWS
    more = _n(
        "{count} further amplitude is not drawn",
        "{count} further amplitudes are not drawn",
        left,
        count=left,
    )
    panels = [[_distribution(found, row), _shares(row, foot=row is rows[-1])] for row in rows]
    said = _("{count} engines; right: shares in the variance", count=number(found.count))
    lines = [*heading(found.engine, speed=found.speed), *estimate_lines([found.engine]), said]
    return figure(
        panels,
        title=_("Engines built to their tolerances"),
        subtitle=[*lines, *([more] if left > 0 else [])],
        rests=_rests(found, rows),
    )


def _rests(found: Scatter, rows: Sequence[OrderScatter]) -> Rests:
    """What the amplitudes of the engine as drawn rest on; loads of bearings by their greatest."""
    kinds = list(dict.fromkeys(row.signal.partition(" ")[0].partition(".")[0] for row in rows))
    if BEARING in kinds:
        speed = found.speed
        return of_loads(found.engine, lambda _engine: None, MAIN_OF, speed=speed)
    return of_inertia(
        [found.engine],
        kinds,
        speed=found.speed,
        orders=sorted({row.order for row in rows}),
        command="tolerance",
        reference=found.reference,
    )


def _distribution(found: Scatter, row: OrderScatter) -> Panel:
    """How many of the engines have which amplitude, and what 5 % exceed."""
    sizes = found.amplitudes(row.signal, row.order)
    unit = shown(row.unit, row.one_in_100)
    low, high = (float(each) * unit.factor for each in np.quantile(sizes, (0.0, 0.9995)))
    low = 0.0 if low < 0.25 * high else min(low, row.nominal * unit.factor)
    high = max(high, row.nominal * unit.factor * (1 + 1e-6), low + 1e-12)
    above = row.one_in_20 * unit.factor
    counts, edges = np.histogram(sizes * unit.factor, bins=CLASSES, range=(low, high))
    shares = 100 * counts / len(sizes)
    width = half_width()
    top = HEADROOM * float(shares.max())
    name = _(
        "{quantity}, order {order}", quantity=signal_text(row.signal), order=order_text(row.order)
    )
    x = field(
        "x:Q",
        scale=span(low, high),
        title=folded(f"{name} [{together(unit_text(unit.unit))}]", width=width),
        axis={"tickCount": 4},
    )
    y = field(
        "y:Q", scale=span(0, top), title=_("engines, %"), axis={"tickCount": 3, "minExtent": EXTENT}
    )
    body = [
        {"x": float(a), "x2": float(b), "y": float(share), "y2": 0.0}
        for a, b, share in zip(edges[:-1], edges[1:], shares, strict=True)
    ]
    bars = (
        of_rows(body)
        .mark("rect")
        .encode(x=x, x2=field("x2"), y=y, y2=field("y2"), color=constant(BLUE))
    )
    marks = [
        _mark(row.nominal * unit.factor, _("as drawn"), GREEN, top, 0, low, high),
        _mark(
            above,
            _("{share} above {size}", share="5 %", size=_distinct(above, high - low)),
            VERMILION,
            top,
            1,
            low,
            high,
        ),
    ]
    rules = of_rows(marks).mark("rule", strokeWidth=2).encode(x=x, color=COLOUR)
    words = [
        of_rows([mark])
        .mark(
            "text",
            fontSize=SMALL,
            align="right" if mark["end"] else "left",
            dx=-5 if mark["end"] else 5,
        )
        .encode(x=x, y=field("y:Q"), text=field("text:N"), color=COLOUR)
        for mark in marks
    ]
    return layered([bars, rules, *words], width=width, height=curve_height(HEIGHT))


def _mark(
    x: float, text: str, colour: str, top: float, line: int, low: float, high: float
) -> dict[str, Any]:
    """A rule with its words, of the first rule on its left where there is room."""
    room = (text_width(text, SMALL) + 12) / half_width() * (high - low)
    end = x - low > room if line == 0 else high - x < room
    return {"x": x, "y": top * (0.95 - 0.1 * line), "text": text, "colour": colour, "end": end}


def _shares(row: OrderScatter, *, foot: bool) -> Panel:
    """The share of each tolerance in the variance, the greatest first."""
    pairs = [(path, share) for path, share in row.shares.items() if share > SMALL_SHARE]
    drawn = pairs if len(pairs) <= BARS else pairs[: BARS - 1]
    rest = pairs[len(drawn) :]
    if rest:
        others = _("{count} others", count=len(rest))
        drawn = [*drawn, (others, sum(share for _path, share in rest))]
    body = [
        {
            "to": 100 * share,
            "top": index + 0.55,
            "foot": index + 0.88,
            "words": index + 0.22,
            "text": f"{path} {_two_figures(100 * share)} %",
        }
        for index, (path, share) in enumerate(drawn)
    ]
    down = {"scale": span(BARS, 0), "title": None, "axis": None}
    y = field("top:Q", **down)
    x = field(
        "to:Q",
        scale=span(0, 100),
        title=_("share in the variance, %") if foot else None,
        axis={"tickCount": 3},
    )
    rows = of_rows([{**each, "from": 0.0} for each in body])
    bars = rows.mark("rect").encode(
        x=field("from:Q", **{key: x[key] for key in ("scale", "title", "axis")}),
        x2=field("to"),
        y=y,
        y2=field("foot"),
        color=constant(BLUE),
    )
    text = rows.mark("text", fontSize=SMALL, color=GREY, align="left")
    words = text.encode(x=constant(2), y=field("words:Q", **down), text=field("text:N"))
    # a reader's letters may be wider than those measured
    wide = max((1.25 * text_width(each["text"], SMALL) for each in body), default=0.0)
    return layered([bars, words], width=max(half_width(), wide), height=curve_height(HEIGHT))


def _two_figures(value: float) -> str:
    return number(float(f"{value:.2g}"))


def _distinct(value: float, span_of: float) -> str:
    """A number with as many figures as tell it from others in a range, three or more."""
    figures = 2 + ceil(log10(max(abs(value) / span_of, 10.0))) if value else 3
    return number(float(f"{value:.{figures}g}"), digits=max(5, figures))
