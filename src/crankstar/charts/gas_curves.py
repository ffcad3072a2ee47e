"""The common parts of the figures of gas: curves over a working cycle, and why there are none."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from math import pi
from typing import NamedTuple

import numpy as np

from crankstar.charts.canvas import (
    curve_height,
    names_engine,
    panel_width,
    relative_width,
    shows_rests,
)
from crankstar.charts.crank_angle import across
from crankstar.charts.drawing import GREY, LINES, Panel, figure, heading, layered
from crankstar.charts.grammar import Chart, Layer, constant, field, of_rows, own, span
from crankstar.charts.letters import folded
from crankstar.engine.engine import Engine
from crankstar.language.messages import _
from crankstar.language.numbers import RPM, number, unit_text
from crankstar.language.shown_units import shown
from crankstar.mechanics.gas import Cycle
from crankstar.spectra import Real
from crankstar.tables.gas_words import points_text

ROOM = 1.08
"""Length of an axis in the greatest value."""
MOST_POINTS = 720


class Line(NamedTuple):
    """A named curve with its colour and its width, px; its values are in SI units."""

    name: str
    colour: str
    width: float
    values: Real


def reach(lines: Sequence[Line]) -> tuple[float, float]:
    """The ends of an axis on which all lines and nought have room."""
    low = min(0.0, *(float(line.values.min()) for line in lines))
    high = max(0.0, *(float(line.values.max()) for line in lines))
    return (ROOM * low, ROOM * high) if low < high else (-1.0, 1.0)


def over_angle(
    theta: Real,
    lines: Sequence[Line],
    *,
    title: str,
    unit: str,
    height: float,
    foot: bool = True,
    ends: tuple[float, float] | None = None,
    legend: bool = True,
    ticks: int = 4,
) -> Panel:
    """Curves over the crank angle, radians from 0, that come back at the end of a cycle."""
    whole = float(theta[-1] + theta[1] - theta[0])
    turns = max(1, round(whole / (2 * pi)))
    low, high = reach(lines) if ends is None else ends
    said = shown(unit, max(-low, high))
    step = max(1, theta.size // MOST_POINTS)
    at = np.append(np.degrees(theta[::step]), 360.0 * turns)
    rows = [
        {
            "x": round(float(x), 6),
            "y": float(f"{y * said.factor:.6g}"),
            "what": line.name,
            "width": line.width,
        }
        for line in lines
        for x, y in zip(at, np.append(line.values[::step], line.values[0]), strict=True)
    ]
    colours = {"domain": [line.name for line in lines], "range": [line.colour for line in lines]}
    drawn = (
        of_rows(rows)
        .mark("line", strokeJoin="round")
        .encode(
            x=across(turns, ticks=(90 if relative_width() > 0.8 else 180) * turns, foot=foot),
            y=field(
                "y:Q",
                scale=span(low * said.factor, high * said.factor),
                title=_(title, unit=unit_text(said.unit)).split("\n") if title else None,
                axis={"tickCount": ticks, "minExtent": 34} if ticks else None,
            ),
            color=field(
                "what:N", scale=colours, legend={**LINES, "columns": 2} if legend else None
            ),
            strokeWidth=own("width:Q"),
        )
    )
    return layered(
        [nought(drawn, low=low * said.factor, high=high * said.factor), drawn],
        width=panel_width(),
        height=curve_height(height),
    )


def nought(beside: Layer, *, low: float, high: float) -> Layer:
    """A thin line at nought, on the axes of another layer."""
    line = of_rows([{"y": 0}])
    y = beside.spec["encoding"]["y"]
    rule = line.mark("rule", color=GREY, strokeWidth=1, opacity=0.5, clip=True)
    return rule.encode(y={**y, "scale": span(low, high)})


def about(engine: Engine, cycle: Cycle) -> list[str]:
    """What a figure of gas says below its title: engine, operating point, load, assumptions."""
    lines = heading(engine)
    told = [_("imep {pressure}", pressure=said_pressure(cycle.imep))]
    if cycle.speed is not None:
        told.insert(0, _("at {rpm} rpm", rpm=number(float(f"{cycle.speed * RPM:.6g}"))))
    if cycle.name or len(cycle.shares) > 1:
        told.insert(0, points_text(cycle.shares))
    lines.append(", ".join(told))
    if cycle.off:
        lines.append(_("not firing: {numbers}", numbers=", ".join(map(str, cycle.off))))
    if cycle.assumed and names_engine() and not shows_rests():
        lines.append(_("Part of the cycle is assumed: `crankstar torque` names what."))
    return lines


def said_pressure(pressure: float) -> str:
    """A pressure (Pa) to four figures with its unit."""
    said = shown("Pa", abs(pressure))
    return f"{number(float(f'{pressure * said.factor:.4g}'))} {unit_text(said.unit)}"


def without(engine: Engine, *, title: str, reason: str) -> Chart:
    """A figure that says why there is no curve."""
    return refusal(reason, title=title, subtitle=heading(engine))


def refusal(reason: str, *, title: str, subtitle: Sequence[str]) -> Chart:
    """A figure that shows a sentence only."""
    return replace(figure([[nothing(reason)]], title=title, subtitle=subtitle), lacking=reason)


def nothing(reason: str) -> Panel:
    """A panel with a sentence instead of a curve."""
    lines = folded(reason, width=panel_width())
    words = of_rows([{"x": 0}]).mark("text", fontSize=13, color=GREY)
    only = words.encode(x=constant(panel_width() / 2), text=constant(lines))
    return layered([only], width=panel_width(), height=60)
