"""Results over two varied values of the engine file as contours; the front of two results."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise
from typing import Any

import numpy as np

from crankstar.charts.canvas import curve_height, panel_width
from crankstar.charts.contour_lines import Contour, labelled_contours
from crankstar.charts.curve_names import curve_name, names_of
from crankstar.charts.drawing import (
    BLUE,
    DEEP,
    GREY,
    PALE,
    VERMILION,
    ChartError,
    Panel,
    figure,
    layered,
)
from crankstar.charts.grammar import DISC, Chart, Layer, constant, field, of_rows, span
from crankstar.charts.labels import Box
from crankstar.charts.letters import SMALL, TEXT, folded
from crankstar.charts.resting import of_sweep
from crankstar.charts.sweeps import RING, value_axis
from crankstar.language.messages import N_, _
from crankstar.language.numbers import number, unit_text
from crankstar.language.shown_units import quantity_text, shown
from crankstar.spectra import Real
from crankstar.studies.best_pair import BestPair, Unbeaten
from crankstar.studies.best_value import FINENESS
from crankstar.studies.sweep import Axis, Curve, Sweep
from crankstar.tables.field_names import field_name

HEIGHT = 250
"""Of a panel, px."""
CELLS = (44, 34)
"""Coloured cells across and up."""
MOST_LINES = 121
"""Values of each number between which contours are drawn."""
MOST_POINTS = 1500
"""Pairs of values that are drawn beside a front."""


def contours(
    sweep: Sweep,
    curves: Sequence[Curve],
    *,
    best: Sequence[BestPair] = (),
    front: Sequence[Unbeaten] = (),
) -> Chart:
    """A panel of contours for each curve of a sweep of two numbers, the first of them across.

    `best`, one for each curve, is marked; `front` has a panel of the first two results. Raises
    ChartError without curves, and for a sweep of one number.
    """
    if not curves:
        raise ChartError(_("there is no curve to draw; watch a quantity, such as force"))
    if len(sweep.axes) != 2:
        raise ChartError(_("contours need two numbers that are varied; this sweep has one"))
    pairs = list(zip(curves, best or [None] * len(curves), strict=True))
    rows = [[_panel(sweep, curve, optimum)] for curve, optimum in pairs]
    if front:
        rows.append([_front_panel(curves, front)])
    names = {"first": field_name(sweep.axes[0].path), "second": field_name(sweep.axes[1].path)}
    title = _("{quantities} over {first} and {second}", quantities=names_of(curves), **names)
    subtitle = [sweep.engine.name, *_words(pairs, sweep)]
    rests = of_sweep(sweep, curves)
    made = figure(rows, title=title[0].upper() + title[1:], subtitle=subtitle, rests=rests)
    own = {"color": "independent"}
    return replace(made, spec={**made.spec, "resolve": {"scale": own, "legend": own}})


def _words(pairs: Sequence[tuple[Curve, BestPair | None]], sweep: Sweep) -> list[str]:
    lines: list[str] = []
    for curve, optimum in pairs:
        if optimum is None:
            continue
        top = curve.top
        least = optimum.result if optimum.result > FINENESS * top else 0.0
        places = [
            f"{number(value)}{f' {axis.unit}' if axis.unit else ''}"
            for axis, value in zip(sweep.axes, optimum.values, strict=True)
        ]
        values = {
            "quantity": curve_name(curve),
            "result": quantity_text(least, curve.unit, beside=top),
            "first": places[0],
            "second": places[1],
        }
        lines.append(_(_words_of(optimum), count=optimum.also + 1, **values))
    return lines


def _words_of(optimum: BestPair) -> str:
    """What is said of the best pair, by whether others are as good."""
    if optimum.flat:
        return N_("{quantity}: {result} at every pair")
    if optimum.ridge:
        return N_("{quantity}: {result} along a line of pairs, as at {first}, {second}")
    if optimum.also:
        return N_("{quantity}: {result} at {count} pairs, as at {first}, {second}")
    return N_("{quantity}: best at {first}, {second}: {result}")


def _panel(sweep: Sweep, curve: Curve, optimum: BestPair | None) -> Panel:
    """The colours and the contours of a curve, and the ring at its best pair."""
    said = shown(curve.unit, curve.top)
    ascending = [np.unique(axis.values, return_index=True) for axis in sweep.axes]
    (x, rows), (y, columns) = ascending
    z = curve.values[np.ix_(rows, columns)] * said.factor
    size = (panel_width(), curve_height(HEIGHT))
    across, up = (_axis(axis, name) for axis, name in zip(sweep.axes, "xy", strict=True))
    layers = [_colours(x, y, z, curve, said.unit, across, up)]
    taken: list[Box] = []
    if optimum is not None and not optimum.flat:
        a, b = optimum.values
        middle = complex((b - y[0]) / np.ptp(y) * size[1], (a - x[0]) / np.ptp(x) * size[0])
        taken.append(Box(middle, 8.0, 8.0))
    thin = [_thinned(values.size) for values in (x, y)]
    lines = labelled_contours(x[thin[0]], y[thin[1]], z[np.ix_(*thin)], size=size, taken=taken)
    layers += _contour_layers(lines, across, up)
    if taken and optimum is not None:
        mark = of_rows([{"x": optimum.values[0], "y": optimum.values[1]}])
        style = {**DISC, "filled": False, "size": RING, "strokeWidth": 2.2, "color": VERMILION}
        layers.append(mark.mark("point", **style).encode(x=across, y=up))
    return layered(layers, width=size[0], height=size[1])


def _thinned(count: int) -> list[int]:
    return sorted({round(place) for place in np.linspace(0, count - 1, min(count, MOST_LINES))})


def _axis(axis: Axis, name: str) -> dict[str, Any]:
    room = panel_width() if name == "x" else curve_height(HEIGHT)
    return value_axis(axis, name, room=room, grid=False)


def _colours(
    x: Real, y: Real, z: Real, curve: Curve, unit: str, across: dict[str, Any], up: dict[str, Any]
) -> Layer:
    """The result as a colour, in cells; the colour scale has its unit."""
    edges = [np.linspace(v[0], v[-1], n + 1) for v, n in zip((x, y), CELLS, strict=True)]
    middles = [(each[:-1] + each[1:]) / 2 for each in edges]
    values = _between(x, y, z, *middles)
    over = [0.12 * (each[1] - each[0]) for each in edges]  # no gap is seen between cells
    rows = [
        {
            "x": float(edges[0][i]),
            "x2": min(float(edges[0][i + 1] + over[0]), float(x[-1])),
            "y": float(edges[1][j]),
            "y2": min(float(edges[1][j + 1] + over[1]), float(y[-1])),
            "z": float(f"{values[i, j]:.5g}"),
        }
        for i in range(CELLS[0])
        for j in range(CELLS[1])
        if np.isfinite(values[i, j])
    ]
    name = f"{curve_name(curve)} [{unit_text(unit)}]"
    legend = {
        "orient": "top",
        "title": folded(name, width=panel_width()),
        "titleColor": GREY,
        "titleFontSize": TEXT,
        "titleFontWeight": "normal",
        "titleLimit": panel_width(),
        "gradientLength": panel_width() - 20,
        "gradientThickness": 10,
        "tickCount": 5,
    }
    low, high = float(np.nanmin(z)), float(np.nanmax(z))
    flat = high - low <= 1e-9 * max(abs(low), abs(high))
    ends = [low - 0.5 * abs(low), high + 0.5 * abs(high) or 1.0] if flat else [low, high]
    scale = {"domain": ends, "range": [PALE, DEEP], "nice": False}
    cells = of_rows(rows).mark("rect", stroke=None)
    return cells.encode(
        x=across,
        y=up,
        x2=field("x2"),
        y2=field("y2"),
        color=field("z:Q", scale=scale, legend=legend),
    )


def _between(x: Real, y: Real, z: Real, a: Real, b: Real) -> Real:
    """The result at other values, straight between those of the sweep."""
    along = np.array([np.interp(a, x, column) for column in z.T])  # [y, a]
    return np.array([np.interp(b, y, row) for row in along.T])


def _contour_layers(
    lines: Sequence[Contour], across: dict[str, Any], up: dict[str, Any]
) -> list[Layer]:
    """The lines, and over them their values."""
    points = [
        {"x": a, "y": b, "line": f"{contour.level:g}/{piece}", "at": index}
        for contour in lines
        for piece, own in enumerate(contour.pieces)
        for index, (a, b) in enumerate(own)
    ]
    labels = [
        {"x": a, "y": b, "text": number(contour.level)}
        for contour in lines
        for a, b in contour.labels
    ]
    out: list[Layer] = []
    if points:
        style = {"color": GREY, "strokeWidth": 1.1, "strokeJoin": "round"}
        drawn = of_rows(points).mark("line", **style)
        out.append(drawn.encode(x=across, y=up, detail=field("line:N"), order=field("at:Q")))
    if labels:
        style = {"fontSize": SMALL, "color": GREY, "baseline": "middle"}
        # on colours a halo would be a spot, and the lines leave room
        texts = of_rows(labels).mark("text", **style, stroke=None)
        out.append(texts.encode(x=across, y=up, text=field("text:N")))
    return out


def _front_panel(curves: Sequence[Curve], front: Sequence[Unbeaten]) -> Panel:
    """Two results of all pairs of values, and those of the pairs that none beats."""
    saids = [shown(curve.unit, curve.top) for curve in curves[:2]]
    results = [
        curve.values.ravel() * said.factor for curve, said in zip(curves, saids, strict=True)
    ]
    axes = [
        field(
            f"{name}:Q",
            scale={**span(*_reach(values)), "zero": False},
            title=folded(f"{curve_name(curve)} [{unit_text(said.unit)}]", width=room),
            axis={"tickCount": 5},
        )
        for name, values, curve, said, room in zip(
            "xy", results, curves, saids, (panel_width(), curve_height(HEIGHT)), strict=False
        )
    ]
    x, y = axes
    step = max(1, results[0].size // MOST_POINTS)
    others = [
        {"x": float(a), "y": float(b)}
        for a, b in zip(results[0][::step], results[1][::step], strict=True)
        if np.isfinite(a) and np.isfinite(b)
    ]
    best = [
        {
            name: result * said.factor
            for name, result, said in zip("xy", pair.results, saids, strict=True)
        }
        for pair in front
    ]
    cloud = {**DISC, "opacity": 0.35, "size": 9, "color": GREY}
    layers = [of_rows(others).mark("point", **cloud).encode(x=x, y=y)]
    corners = [{"x": right["x"], "y": left["y"]} for left, right in pairwise(best)]
    steps = [point for pair in zip(best, corners, strict=False) for point in pair] + best[-1:]
    if len(steps) > 1:
        line = of_rows([{**point, "at": index} for index, point in enumerate(steps)])
        style = {"color": BLUE, "strokeWidth": 1.3}
        layers.append(line.mark("line", **style).encode(x=x, y=y, order=field("at:Q")))
    dots = of_rows(best).mark("point", **DISC, size=40)
    layers.append(dots.encode(x=x, y=y, color=constant(BLUE)))
    return layered(
        layers,
        width=panel_width(),
        height=curve_height(HEIGHT),
        title=_("Blue: no other pair of values is better in both"),
    )


def _reach(values: Real) -> tuple[float, float]:
    """A little more than from the least to the greatest."""
    low, high = float(np.nanmin(values)), float(np.nanmax(values))
    room = 0.05 * (high - low) or 0.05 * abs(high) or 1.0
    return max(low - room, 0.0) if low >= 0 else low - room, high + room
