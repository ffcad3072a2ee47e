"""The Campbell diagram: natural frequencies and orders over the speed, and where they meet."""

from __future__ import annotations

from collections.abc import Sequence
from math import pi
from typing import Any, NamedTuple

from crankstar.analyses.torsion.charts.words import (
    NO_SPEED,
    RPM,
    TWISTING,
    hertz,
    load_lines,
    named_lines,
    refused,
    rests,
    strongest_line,
)
from crankstar.charts.canvas import curve_height, panel_width
from crankstar.charts.drawing import BLUE, GREY, VERMILION, checked_order, figure, layered
from crankstar.charts.grammar import Channel, Chart, Layer, field, of_rows, own, span
from crankstar.charts.letters import SMALL
from crankstar.dynamics.torsion_analysis import TorsionAnalysis, torsion
from crankstar.dynamics.torsion_criticals import Critical, strength
from crankstar.dynamics.torsion_system import TorsionError
from crankstar.engine.engine import Engine
from crankstar.engine.torsion import Chain
from crankstar.language.messages import N_, _
from crankstar.language.numbers import order_text

TITLE = N_("Campbell diagram of torsion")
MOST_RAYS, MOST_MODES = 7, 6
HEIGHT = 260.0
ABOVE, BESIDE = 1.12, 1.1
"""Lengths of the axes in the highest frequency and the highest speed."""
APART = 20.0
"""px between the numbers of two orders."""
LEAST, GREATEST = 22.0, 150.0
"""px^2: the marks of critical speeds, by their strength."""


class _Field(NamedTuple):
    """The ends of the axes: rpm and Hz."""

    right: float
    top: float

    def channels(self) -> tuple[Channel, Channel]:
        """The axes, the same of all layers."""
        x = field("x:Q", scale=span(0, self.right), title=_("speed (rpm)"), axis={"tickCount": 5})
        y = field("y:Q", scale=span(0, self.top), title=_("frequency (Hz)"), axis={"tickCount": 5})
        return x, y


def campbell(
    source: Engine | Chain,
    *,
    speeds: Sequence[float] | None = None,
    orders: Sequence[float] | None = None,
    point: str | None = None,
) -> Chart:
    """Natural frequencies (level lines), orders (rays) and the critical speeds where they meet.

    Over `speeds` (rad/s), else those of the file, which are shaded. The orders are those named, or
    of an engine those whose critical speeds count for most; a mark is as large as its equilibrium
    amplitude. A drive line has no orders of its own. An engine without a table [torsion], and what
    has no speed, has a figure that says so. Raises ChartError for an order that is none, GasError
    for an operating point that is not there.
    """
    title = _(TITLE)
    asked = None if orders is None else [checked_order(order) for order in orders]
    try:
        found = torsion(source, point=point or "", speeds=[*(speeds or ())], orders=asked)
    except TorsionError as error:
        return refused(source, title=title, reason=str(error))
    if not found.modes:
        reason = _("Nothing twists: all masses are rigidly coupled, or by a fluid alone.")
        return refused(source, title=title, reason=reason)
    if not found.speeds.size:
        return refused(source, title=title, reason=_(NO_SPEED))
    marks = found.criticals if asked is not None else found.noted
    subtitle = [*named_lines(source), *load_lines(source, found)]
    if asked is not None or isinstance(source, Engine):
        subtitle += strongest_line(found)
    if found.chain.pendulums:
        subtitle.append(_("Level lines: pendulums at rest; marks: pendulums as at their order."))
    rays = asked or [*dict.fromkeys(each.order for each in marks)][:MOST_RAYS]
    marks = [each for each in marks if each.order in rays]
    area = _area(found, marks)
    x, y = area.channels()
    lines, values = _levels(found, area, x, y)
    layers = [_range(found, x), lines, *_rays(rays, area, x, y)]
    if marks:
        layers.append(_marks(marks, x, y))
    layers.append(values)  # last, so that no ray crosses them
    panel = layered(layers, width=panel_width(), height=curve_height(HEIGHT))
    rests_on = rests(source, quantities=TWISTING, point=point or "", speeds=[*(speeds or ())])
    return figure([[panel]], title=title, subtitle=subtitle, rests=rests_on)


def _area(found: TorsionAnalysis, marks: Sequence[Critical]) -> _Field:
    met = [each.order * each.speed / (2 * pi) for each in marks]
    top = max([found.modes[0].frequency, *met])
    return _Field(BESIDE * float(found.speeds[-1]) * RPM, ABOVE * top)


def _range(found: TorsionAnalysis, x: Channel) -> Layer:
    """The speeds that are asked for, shaded."""
    ends = {"x": float(found.speeds[0] * RPM), "x2": float(found.speeds[-1] * RPM)}
    return of_rows([ends]).mark("rect", color=GREY, opacity=0.1).encode(x=x, x2=field("x2"))


def _levels(found: TorsionAnalysis, area: _Field, x: Channel, y: Channel) -> tuple[Layer, Layer]:
    """The natural frequencies, and their values at the left."""
    seen = [mode for mode in found.modes if mode.frequency <= area.top][:MOST_MODES]
    rows = [
        {
            "x": 0.0,
            "x2": area.right,
            "y": mode.frequency,
            "text": _("mode {number}: {size} Hz", number=mode.number, size=hertz(mode.speed)),
        }
        for mode in seen
    ]
    base = of_rows(rows)
    lines = base.mark("rule", color=BLUE, strokeWidth=2).encode(x=x, x2=field("x2"), y=y)
    words = base.mark(
        "text", align="left", baseline="bottom", dx=4, dy=-3, color=BLUE, fontSize=SMALL
    )
    return lines, words.encode(x=x, y=y, text=field("text:N"))


def _rays(rays: Sequence[float], area: _Field, x: Channel, y: Channel) -> list[Layer]:
    """The orders, each with its number at its end; of two that are close the first has one."""
    rows: list[dict[str, Any]] = []
    taken: list[complex] = []
    height = curve_height(HEIGHT)
    for order in rays:
        right = min(0.96 * area.right, 0.95 * area.top * 60 / order)
        end = {"x": right, "y": order * right / 60}
        place = complex(end["x"] / area.right * panel_width(), end["y"] / area.top * height)
        clear = all(abs(place - other) > APART for other in taken)
        if clear:
            taken.append(place)
        rows.append({"x0": 0.0, "y0": 0.0, **end, "text": order_text(order) if clear else ""})
    if not rows:
        return []
    base = of_rows(rows)
    lines = base.mark("rule", color=GREY, strokeWidth=1).encode(
        x={**x, "field": "x0"}, y={**y, "field": "y0"}, x2=field("x"), y2=field("y")
    )
    words = base.mark("text", align="center", baseline="bottom", dy=-2, color=GREY, fontSize=SMALL)
    return [lines, words.encode(x=x, y=y, text=field("text:N"))]


def _marks(marks: Sequence[Critical], x: Channel, y: Channel) -> Layer:
    top = max(map(strength, marks)) or 1.0
    rows = [
        {
            "x": each.speed * RPM,
            "y": each.order * each.speed / (2 * pi),
            "order": each.order,
            "mode": each.mode,
            "size": round(LEAST + (GREATEST - LEAST) * strength(each) / top, 2),
        }
        for each in marks
    ]
    dots = of_rows(rows).mark("point", shape="circle", filled=True, opacity=0.85, color=VERMILION)
    return dots.encode(x=x, y=y, size=own("size:Q"))
