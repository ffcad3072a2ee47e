"""Force, couple, roll or torque over a varied value of the engine file, and the best value."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from crankstar.charts.drawing import (
    GREY,
    PALETTE,
    VERMILION,
    WIDTH,
    ChartError,
    Panel,
    figure,
    folded,
    layered,
)
from crankstar.charts.grammar import Chart, field, of_rows
from crankstar.language.messages import _
from crankstar.language.numbers import number, unit_text
from crankstar.spectra import Real
from crankstar.studies.best_value import Best
from crankstar.studies.sweep import Curve, Sweep

MOST_POINTS = 2000
"""Greatest number of drawn values of a curve."""


def swept(sweep: Sweep, curves: Sequence[Curve], *, best: Sequence[Best] = ()) -> Chart:
    """The curves of a sweep, a panel for each unit; `best`, one for each curve, is marked.

    Raises ChartError without curves.
    """
    if not curves:
        raise ChartError(_("there is no curve to draw; watch a quantity, such as force"))
    optima = list(best) or [None] * len(curves)
    units = list(dict.fromkeys(curve.unit for curve in curves))
    panels = []
    for place, unit in enumerate(units):
        own = [
            (curve, one) for curve, one in zip(curves, optima, strict=True) if curve.unit == unit
        ]
        panels.append(_panel(sweep, own, unit, foot=place == len(units) - 1))
    labels = ", ".join(curve.label for curve in curves)
    title = _("{quantities} over {path}", quantities=labels, path=sweep.path)
    title = title[0].upper() + title[1:]
    return figure(
        [[panel] for panel in panels],
        title=title,
        subtitle=[sweep.engine.name, *_words(curves, optima, sweep)],
    )


def _words(curves: Sequence[Curve], best: Sequence[Best | None], sweep: Sweep) -> list[str]:
    unit = f" {sweep.unit}" if sweep.unit else ""
    lines = []
    for curve, optimum in zip(curves, best, strict=True):
        if optimum is None:
            continue
        size = number(optimum.result, 100 * float(curve.values.max()))
        result = {"quantity": curve.label, "result": f"{size} {unit_text(curve.unit)}"}
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


def _panel(
    sweep: Sweep, curves: Sequence[tuple[Curve, Best | None]], unit: str, *, foot: bool
) -> Panel:
    names = [curve.label for curve, _ in curves]
    colours = {"domain": names, "range": [PALETTE[i % len(PALETTE)] for i in range(len(names))]}
    legend = (
        {
            "orient": "top",
            "title": None,
            "columns": 2,
            "symbolType": "stroke",
            "symbolStrokeWidth": 3,
        }
        if len(names) > 1
        else None
    )
    ends = [float(sweep.values.min()), float(sweep.values.max())]
    name = f"{sweep.path} ({sweep.unit})" if sweep.unit else sweep.path
    x = field(
        "x:Q",
        scale={"domain": ends, "nice": False},
        title=folded(name, 44) if foot else None,
        axis={"tickCount": 5},
    )
    reach = max(float(curve.values.max()) for curve, _ in curves) or 1.0
    y = field(
        "y:Q",
        scale={"domain": [0, 1.08 * reach], "nice": False},
        title=unit_text(unit),
        axis={"tickCount": 4},
    )
    rows = [row for curve, _ in curves for row in _rows(sweep.values, curve)]
    lines = (
        of_rows(rows)
        .mark("line", strokeWidth=2.4, strokeJoin="round")
        .encode(x=x, y=y, color=field("what:N", scale=colours, legend=legend))
    )
    layers = [lines]
    marks = [
        {"x": one.value, "y": one.result, "what": curve.label}
        for curve, one in curves
        if one is not None and not one.flat
    ]
    if marks:
        dots = of_rows(marks).mark(
            "point",
            size=90,
            filled=False,
            strokeWidth=2.2,
            color=VERMILION,
            opacity=1,
            shape="circle",
        )
        drop = of_rows(marks).mark("rule", color=GREY, strokeDash=[3, 3], strokeWidth=1)
        layers += [drop.encode(x=x), dots.encode(x=x, y=y)]
    return layered(layers, width=WIDTH, height=190)


def _rows(values: Real, curve: Curve) -> list[dict[str, Any]]:
    step = max(1, values.size // MOST_POINTS)
    pairs = sorted(zip(values.tolist(), curve.values.tolist(), strict=True))
    kept = [*pairs[::step], pairs[-1]] if step > 1 else pairs
    return [{"x": x, "y": y, "what": curve.label} for x, y in kept]
