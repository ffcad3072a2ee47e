"""Force, couple, rolling moment or torque over a varied value of the engine file; the optimum."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import cycle, islice
from math import isnan
from typing import Any

from crankstar.charts.canvas import curve_height, panel_width
from crankstar.charts.crank_angle import angle_ticks
from crankstar.charts.curve_names import curve_name, names_of
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
from crankstar.charts.estimates import estimate_lines
from crankstar.charts.grammar import DISC, Channel, Chart, field, of_rows, span
from crankstar.charts.letters import folded, text_width, together
from crankstar.charts.resting import of_sweep
from crankstar.language.messages import N_, _
from crankstar.language.numbers import number, unit_text
from crankstar.language.shown_units import Shown, quantity_text, shown
from crankstar.spectra import Real
from crankstar.studies.best_value import Best
from crankstar.studies.sweep import Axis, Curve, Sweep
from crankstar.tables.field_names import axis_name, field_name
from crankstar.tables.sweep_ranges import Band

MOST_POINTS = 2000
"""Greatest number of drawn values of a curve."""
BAND = N_("Estimated masses or lengths: the bands are the ranges of the curves.")
RING = 90.0
"""Area of the mark at a best value, px^2."""
CLEAR = {"labelPadding": 5}
"""px beyond the ticks of an axis: at its edge the mark stays clear of the numbers."""
HEIGHT = 190
"""px: the usual height of a panel."""
STROKE = 30
"""px: of a stroke of the legend with the room about it."""
DASHES = ([1, 0], [6, 3], [2, 2])
"""Of the curves that have the first colours, the same again, and once more."""
ROUNDED = 1e-7
"""Share of the greatest value of a curve below which its best value is zero."""


def swept(
    sweep: Sweep,
    curves: Sequence[Curve],
    *,
    best: Sequence[Best] = (),
    bands: Sequence[Band | None] = (),
) -> Chart:
    """The curves of a sweep, a panel for each unit; `best`, one for each curve, is marked.

    `bands` are the ranges of the curves where values of the engine are estimated. Raises
    ChartError without curves.
    """
    if not curves:
        raise ChartError(_("there is no curve to draw; watch a quantity, such as force"))
    pairs = list(zip(curves, best or [None] * len(curves), strict=True))
    ranged = list(bands) or [None] * len(curves)
    units = list(dict.fromkeys(curve.unit for curve in curves))
    panels: list[Panel] = []
    for unit in units:
        own = [index for index, curve in enumerate(curves) if curve.unit == unit]
        said = shown(unit, max(curves[place].top for place in own))
        areas = [
            row
            for place in own
            for row in _area(sweep.values, curves[place], ranged[place], said.factor)
        ]
        drawn = _scaled([pairs[place] for place in own], said)
        panels.append(_panel(sweep, drawn, areas, foot=unit == units[-1]))
    title = _("{quantities} over {path}", quantities=names_of(curves), path=field_name(sweep.path))
    title = title[0].upper() + title[1:]
    doubt = [_(BAND)] if any(bands) else estimate_lines([sweep.engine])
    subtitle = [sweep.engine.name, *doubt, *_words(pairs, sweep)]
    rests = of_sweep(sweep, curves)
    made = figure([[panel] for panel in panels], title=title, subtitle=subtitle, rests=rests)
    own = {"color": "independent", "strokeDash": "independent"}  # each panel has its own curves
    return replace(made, spec={**made.spec, "resolve": {"scale": own, "legend": own}})


def _words(pairs: Sequence[tuple[Curve, Best | None]], sweep: Sweep) -> list[str]:
    unit = f" {sweep.unit}" if sweep.unit else ""
    lines = []
    for curve, optimum in pairs:
        if optimum is None:
            continue
        top = curve.top
        least = optimum.result if optimum.result > ROUNDED * top else 0.0
        text = quantity_text(least, curve.unit, beside=top)
        result = {"quantity": curve_name(curve), "result": together(text)}
        lines.append(
            _("{quantity}: {result} at every value", **result)
            if optimum.flat
            else _("{quantity}: best at {value}, {result}", value=_places(optimum, unit), **result)
        )
    return lines


def _places(optimum: Best, unit: str) -> str:
    """The best value; where several are as good, all of them."""
    if optimum.stretch is not None:
        low, high = map(number, optimum.stretch)
        return _("{low} to {high}{unit}", low=low, high=high, unit=unit)
    return f"{', '.join(map(number, (optimum.value, *optimum.also)))}{unit}"


def value_axis(axis: Axis, name: str, *, room: float, foot: bool = True, **more: Any) -> Channel:
    """The values of a swept number along an axis; its title at the foot only."""
    low, high = float(axis.values.min()), float(axis.values.max())
    ticks = {"values": angle_ticks(low=low, high=high)} if axis.unit == "deg" else {"tickCount": 5}
    title = folded(axis_name(axis.path, axis.unit), width=room) if foot else None
    return field(f"{name}:Q", scale=span(low, high), title=title, axis={**ticks, **CLEAR, **more})


def _scaled(
    pairs: Sequence[tuple[Curve, Best | None]], said: Shown
) -> list[tuple[Curve, Best | None]]:
    """Curves of one unit with their best values, in the unit that they are shown in."""
    return [
        (
            curve._replace(values=curve.values * said.factor, unit=said.unit),
            best and best._replace(result=best.result * said.factor),
        )
        for curve, best in pairs
    ]


def _area(values: Real, curve: Curve, band: Band | None, factor: float) -> list[dict[str, Any]]:
    """The band of a curve from left to right, in the unit that it is shown in."""
    if band is None:
        return []
    rows = zip(values.tolist(), band.low.tolist(), band.high.tolist(), strict=True)
    return [
        {"x": x, "y": low * factor, "y2": high * factor, "what": curve_name(curve)}
        for x, low, high in sorted(rows)
        if not isnan(low)
    ]


def _panel(
    sweep: Sweep,
    pairs: Sequence[tuple[Curve, Best | None]],
    areas: Sequence[dict[str, Any]],
    *,
    foot: bool,
) -> Panel:
    names = [curve_name(curve) for curve, _ in pairs]
    colours = {"domain": names, "range": [*islice(cycle(PALETTE), len(names))]}
    legend = _legend(names) if len(names) > 1 else None
    x = value_axis(sweep.axes[0], "x", room=panel_width(), foot=foot)
    tops = [curve.top for curve, _ in pairs]
    reach = max(*tops, *(row["y2"] for row in areas), 0.0)
    ticks = {"tickCount": 4} if reach > 0 else {"values": [0]}
    unit = unit_text(pairs[0][0].unit)
    height = curve_height(HEIGHT)
    said = unit if len(names) > 1 else folded(f"{names[0]} [{together(unit)}]", width=height)
    y = field("y:Q", scale=span(0, 1.08 * reach or 1.0), title=said, axis={**ticks, **CLEAR})
    rows = [row for curve, _ in pairs for row in _rows(sweep.values, curve)]
    lines = of_rows(rows).mark("line", strokeWidth=2.4, strokeJoin="round")
    colour = field("what:N", scale=colours, legend=legend)
    ways = {"x": x, "y": y, "color": colour}
    if len(names) > len(PALETTE):  # the colours come again, with dashes
        dashes = [DASHES[index // len(PALETTE) % len(DASHES)] for index in range(len(names))]
        scale = {"domain": names, "range": dashes}
        ways["strokeDash"] = field("what:N", scale=scale, legend=legend)
    layers = [lines.encode(**ways)]
    if areas:
        area = of_rows(areas).mark("area", opacity=0.25)
        layers.insert(0, area.encode(x=x, y=y, y2=field("y2"), color=colour))
    marks = [
        {"x": best.value, "y": best.result, "what": curve_name(curve)}
        for curve, best in pairs
        if best is not None and not best.flat
    ]
    if marks:
        drop = of_rows(marks).mark("rule", color=GREY, strokeDash=[3, 3], strokeWidth=1)
        style = {**DISC, "filled": False, "size": RING, "strokeWidth": 2.2, "color": VERMILION}
        layers += [drop.encode(x=x), of_rows(marks).mark("point", **style).encode(x=x, y=y)]
    return layered(layers, width=panel_width(), height=height)


def _legend(names: Sequence[str]) -> dict[str, Any]:
    """Two names in a row where they have room; its strokes are not as pale as bands."""
    room = panel_width() / 2 - STROKE
    columns = 2 if max(map(text_width, names)) <= room else 1
    return {**LINES, "columns": columns, "labelLimit": panel_width(), "symbolOpacity": 1}


def _rows(values: Real, curve: Curve) -> list[dict[str, Any]]:
    step = max(1, values.size // MOST_POINTS)
    pairs = sorted(zip(values.tolist(), curve.values.tolist(), strict=True))
    kept = [*pairs[::step], pairs[-1]] if step > 1 else pairs
    return [  # a line has a gap where there is no number
        {"x": x, "y": None if isnan(y) else y, "what": curve_name(curve)} for x, y in kept
    ]
