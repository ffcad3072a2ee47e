"""Force, couple, rolling moment or torque over a varied value of the engine file; the optimum."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import cycle, islice
from typing import Any

from crankstar.charts.canvas import curve_height, panel_width
from crankstar.charts.drawing import (
    GREY,
    LINES,
    PALETTE,
    VERMILION,
    ChartError,
    Panel,
    figure,
    layered,
)
from crankstar.charts.grammar import DISC, Chart, field, of_rows, span
from crankstar.charts.letters import folded
from crankstar.language.messages import _
from crankstar.language.numbers import number, unit_text
from crankstar.language.shown_units import quantity_text, shown
from crankstar.spectra import Real
from crankstar.studies.best_value import Best
from crankstar.studies.sweep import Curve, Sweep

MOST_POINTS = 2000
"""Greatest number of drawn values of a curve."""
ROUNDED = 1e-7
"""Share of the greatest value of a curve below which its best value is zero."""


def swept(sweep: Sweep, curves: Sequence[Curve], *, best: Sequence[Best] = ()) -> Chart:
    """The curves of a sweep, a panel for each unit; `best`, one for each curve, is marked.

    Raises ChartError without curves.
    """
    if not curves:
        raise ChartError(_("there is no curve to draw; watch a quantity, such as force"))
    pairs = list(zip(curves, best or [None] * len(curves), strict=True))
    units = list(dict.fromkeys(curve.unit for curve in curves))
    panels = [
        _panel(sweep, _scaled([p for p in pairs if p[0].unit == unit]), foot=unit == units[-1])
        for unit in units
    ]
    labels = ", ".join(curve.label for curve in curves)
    title = _("{quantities} over {path}", quantities=labels, path=sweep.path)
    title = title[0].upper() + title[1:]
    subtitle = [sweep.engine.name, *_words(pairs, sweep)]
    return figure([[panel] for panel in panels], title=title, subtitle=subtitle)


def _words(pairs: Sequence[tuple[Curve, Best | None]], sweep: Sweep) -> list[str]:
    unit = f" {sweep.unit}" if sweep.unit else ""
    lines = []
    for curve, optimum in pairs:
        if optimum is None:
            continue
        top = float(curve.values.max())
        least = optimum.result if optimum.result > ROUNDED * top else 0.0
        result = {"quantity": curve.label, "result": quantity_text(least, curve.unit, beside=top)}
        lines.append(
            _("{quantity}: {result} at every value", **result)
            if optimum.flat
            else _(
                "{quantity}: best at {value}, {result}",
                value=f"{number(optimum.value)}{unit}",
                **result,
            )
        )
    return lines


def _scaled(pairs: Sequence[tuple[Curve, Best | None]]) -> list[tuple[Curve, Best | None]]:
    """Curves of one unit with their best values, in the unit that they are shown in."""
    said = shown(pairs[0][0].unit, max(float(curve.values.max()) for curve, _ in pairs))
    return [
        (
            curve._replace(values=curve.values * said.factor, unit=said.unit),
            best and best._replace(result=best.result * said.factor),
        )
        for curve, best in pairs
    ]


def _panel(sweep: Sweep, pairs: Sequence[tuple[Curve, Best | None]], *, foot: bool) -> Panel:
    names = [curve.label for curve, _ in pairs]
    colours = {"domain": names, "range": [*islice(cycle(PALETTE), len(names))]}
    legend = {**LINES, "columns": 2} if len(names) > 1 else None
    name = f"{sweep.path} ({sweep.unit})" if sweep.unit else sweep.path
    x = field(
        "x:Q",
        scale=span(float(sweep.values.min()), float(sweep.values.max())),
        title=folded(name, width=panel_width()) if foot else None,
        axis={"tickCount": 5},
    )
    reach = max(float(curve.values.max()) for curve, _ in pairs) or 1.0
    unit = unit_text(pairs[0][0].unit)
    y = field("y:Q", scale=span(0, 1.08 * reach), title=unit, axis={"tickCount": 4})
    rows = [row for curve, _ in pairs for row in _rows(sweep.values, curve)]
    lines = of_rows(rows).mark("line", strokeWidth=2.4, strokeJoin="round")
    layers = [lines.encode(x=x, y=y, color=field("what:N", scale=colours, legend=legend))]
    marks = [
        {"x": best.value, "y": best.result, "what": curve.label}
        for curve, best in pairs
        if best is not None and not best.flat
    ]
    if marks:
        drop = of_rows(marks).mark("rule", color=GREY, strokeDash=[3, 3], strokeWidth=1)
        style = {**DISC, "filled": False, "size": 90, "strokeWidth": 2.2, "color": VERMILION}
        layers += [drop.encode(x=x), of_rows(marks).mark("point", **style).encode(x=x, y=y)]
    return layered(layers, width=panel_width(), height=curve_height(190))


def _rows(values: Real, curve: Curve) -> list[dict[str, Any]]:
    step = max(1, values.size // MOST_POINTS)
    pairs = sorted(zip(values.tolist(), curve.values.tolist(), strict=True))
    kept = [*pairs[::step], pairs[-1]] if step > 1 else pairs
    return [{"x": x, "y": y, "what": curve.label} for x, y in kept]
