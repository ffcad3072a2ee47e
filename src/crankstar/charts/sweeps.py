"""What becomes of force, couple, roll or torque when a number of the engine file is varied, and where it is best."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from crankstar.charts.drawing import GREY, PALETTE, VERMILION, WIDTH, ChartError, Panel, figure, folded, layered, of_rows
from crankstar.phasor import Real
from crankstar.sweep import Best, Curve, Sweep
from crankstar.wording import number, unit_text

if TYPE_CHECKING:
    import altair

MOST_POINTS = 2000
"""Values of a curve that are drawn; more could not be told apart."""


def swept(sweep: Sweep, curves: Sequence[Curve], *, best: Sequence[Best] = ()) -> altair.VConcatChart:
    """The curves of a sweep over the values, a panel for each unit; `best`, one for each curve or none, is marked and written.

    Raises ChartError where there is nothing to draw.
    """
    if not curves:
        raise ChartError("there is no curve to draw; watch something, such as force")
    found = list(best) or [None] * len(curves)
    units = list(dict.fromkeys(curve.unit for curve in curves))
    panels = []
    for place, unit in enumerate(units):
        own = [(curve, one) for curve, one in zip(curves, found, strict=True) if curve.unit == unit]
        panels.append(_panel(sweep, own, unit, foot=place == len(units) - 1))
    title = f"{', '.join(curve.label for curve in curves)} over {sweep.path}"
    title = title[0].upper() + title[1:]
    return figure([[panel] for panel in panels], title=title, subtitle=[sweep.engine.name, *_words(curves, found, sweep)])


def _words(curves: Sequence[Curve], best: Sequence[Best | None], sweep: Sweep) -> list[str]:
    unit = f" {sweep.unit}" if sweep.unit else ""
    told = []
    for curve, one in zip(curves, best, strict=True):
        if one is None:
            continue
        result = f"{number(one.result, 100 * float(curve.values.max()))} {unit_text(curve.unit)}"
        told.append(
            f"{curve.label}: {result} at every value" if one.flat else f"{curve.label}: best at {number(one.value)}{unit}, {result}"
        )
    return told


def _panel(sweep: Sweep, curves: Sequence[tuple[Curve, Best | None]], unit: str, *, foot: bool) -> Panel:
    import altair as alt

    names = [curve.label for curve, _ in curves]
    colours = alt.Scale(domain=names, range=[PALETTE[i % len(PALETTE)] for i in range(len(names))])
    legend = alt.Legend(orient="top", title=None, columns=2, symbolType="stroke", symbolStrokeWidth=3) if len(names) > 1 else None
    ends = [float(sweep.values.min()), float(sweep.values.max())]
    name = f"{sweep.path} ({sweep.unit})" if sweep.unit else sweep.path
    x = alt.X("x:Q", scale=alt.Scale(domain=ends, nice=False), title=folded(name, 44) if foot else None, axis=alt.Axis(tickCount=5))
    reach = max(float(curve.values.max()) for curve, _ in curves) or 1.0
    y = alt.Y("y:Q", scale=alt.Scale(domain=[0, 1.08 * reach], nice=False), title=unit_text(unit), axis=alt.Axis(tickCount=4))
    rows = [row for curve, _ in curves for row in _rows(sweep.values, curve)]
    lines = (
        of_rows(rows)
        .mark_line(strokeWidth=2.4, strokeJoin="round")
        .encode(x=x, y=y, color=alt.Color("what:N", scale=colours, legend=legend))
    )
    layers = [lines]
    marks = [{"x": one.value, "y": one.result, "what": curve.label} for curve, one in curves if one is not None and not one.flat]
    if marks:
        dots = of_rows(marks).mark_point(size=90, filled=False, strokeWidth=2.2, color=VERMILION, opacity=1, shape="circle")
        drop = of_rows(marks).mark_rule(color=GREY, strokeDash=[3, 3], strokeWidth=1)
        layers += [drop.encode(x=x), dots.encode(x=x, y=y)]
    return layered(layers, width=WIDTH, height=190)


def _rows(values: Real, curve: Curve) -> list[dict[str, Any]]:
    step = max(1, values.size // MOST_POINTS)
    pairs = sorted(zip(values.tolist(), curve.values.tolist(), strict=True))
    kept = [*pairs[::step], pairs[-1]] if step > 1 else pairs
    return [{"x": x, "y": y, "what": curve.label} for x, y in kept]
