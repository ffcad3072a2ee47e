"""Guide-force moments H and X of each order as bars, at an operating point."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from math import ceil

import numpy as np

from crankstar.analysis.assumptions import Answer
from crankstar.analysis.tried_values import Figures
from crankstar.charts.canvas import curve_height, panel_width
from crankstar.charts.drawing import BLUE, ORANGE, figure, layered
from crankstar.charts.gas_curves import ROOM, about, without
from crankstar.charts.grammar import Chart, field, of_rows, span
from crankstar.charts.letters import TEXT, text_width
from crankstar.charts.resting import Rests
from crankstar.engine.engine import Engine
from crankstar.language.messages import N_, _
from crankstar.language.numbers import order_text, unit_text
from crankstar.language.shown_units import shown
from crankstar.mechanics.gas import Cycle, check_gas, cycle
from crankstar.mechanics.guide_moments import GuideMoments, MarineError, guide_moments
from crankstar.mechanics.operating_points import GasError

TITLE = N_("Guide-force moments")
AXIS = N_("moment ({unit})")
APART = 6.0
"""px between the names of two orders."""
SYMBOL = 40.0
"""px of a square of the legend, and of what is left beside it."""


def guide_moment_chart(
    engine: Engine, *, point: str | None = None, speed: float | None = None
) -> Chart:
    """The H-moment and the X-moment of each order, of gas and, where masses are known, inertia.

    At an operating point, or at the load of the file, and at `speed` (rad/s). X needs the distance
    of the cylinders. Raises ChartError.
    """
    try:
        check_gas(engine)
        make = partial(cycle, point=point or "", speed=speed)
        found = make(engine)
        guide = guide_moments(engine, found)
    except (GasError, MarineError) as error:
        if point:
            raise
        return without(engine, title=_(TITLE), reason=str(error))
    series = [(_("H: all heads sway together"), BLUE, np.abs(guide.h))]
    subtitle = about(engine, found)
    if guide.pitch_known:
        series.append((_("X: front and rear sway apart"), ORANGE, np.abs(guide.x)))
    else:
        subtitle.append(_("X needs the distance of the cylinders: give layout.bore_pitch."))
    if not guide.with_inertia:
        subtitle.append(_("Of gas alone."))
    rests = Rests([engine], partial(guided, make=make), "torque")
    return figure([[_bars(guide, series)]], title=_(TITLE), subtitle=subtitle, rests=rests)


def guided(engine: Engine, make: Callable[[Engine], Cycle]) -> Answer:
    """The moments of the guide forces by order: H of all cylinders, X of front against rear."""

    def figures(each: Engine) -> Figures:
        guide = guide_moments(each, make(each))
        return {
            (name, float(order)): float(abs(size))
            for name, moments in (("H moment", guide.h), ("X moment", guide.x))
            for order, size in zip(guide.orders, moments, strict=True)
        }

    return Answer(
        figures=figures,
        unit=lambda _quantity, _engine: "N*m",
        uses=("inertia", "gas"),
        gas=make(engine),
    )


def _bars(guide: GuideMoments, series: list[tuple[str, str, np.ndarray]]) -> dict:
    """The bars of both moments beside each other, order by order: the orders of the table."""
    kept = guide.noted()
    greatest = max(float(values[kept].max(initial=0.0)) for _name, _colour, values in series)
    said = shown("N*m", greatest)
    names = [order_text(guide.orders[place]) for place in kept] or ["1"]
    rows = [
        {
            "order": order_text(guide.orders[place]),
            "what": name,
            "to": float(f"{values[place] * said.factor:.6g}"),
            "from": 0.0,
        }
        for name, _colour, values in series
        for place in kept
        if values[place] > 0
    ]
    colours = {"domain": [each[0] for each in series], "range": [each[1] for each in series]}
    drawn = (
        of_rows(rows)
        .mark("bar")
        .encode(
            x=field(
                "order:N",
                sort=None,
                scale={"domain": names},
                title=_("order"),
                axis={"labelAngle": 0, "values": names[:: _step(names)], "labelOverlap": False},
            ),
            xOffset=field("what:N", sort=None, scale={"domain": colours["domain"]}),
            y=field(
                "to:Q",
                title=_(AXIS, unit=unit_text(said.unit)),
                scale=span(0, ROOM * (greatest * said.factor or 1.0)),
                axis={"tickCount": 4},
            ),
            color=field("what:N", scale=colours, legend=_legend(series)),
        )
    )
    return layered([drawn], width=panel_width(), height=curve_height(170))


def _step(names: list[str]) -> int:
    """Every how many bars one is named, so that no name touches the next."""
    widest = max(text_width(name, TEXT) for name in names)
    return max(1, ceil((widest + APART) * len(names) / panel_width()))


def _legend(series: list[tuple[str, str, np.ndarray]]) -> dict[str, object]:
    """The names of both in one row, or below each other where they are longer than it."""
    row = sum(text_width(name, TEXT) + SYMBOL for name, _colour, _values in series)
    columns = len(series) if row < panel_width() else 1
    return {"orient": "top", "title": None, "columns": columns, "labelLimit": panel_width()}
