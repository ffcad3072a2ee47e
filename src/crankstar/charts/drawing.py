"""The common parts of figures: colours, sizes, panels under a title, the crank angle."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from html import escape
from math import degrees, isfinite
from typing import TYPE_CHECKING, Any

from crankstar.charts.canvas import BETWEEN, curve_height, foot_room, names_engine, panel_width
from crankstar.charts.grammar import Channel, Chart, Layer, field
from crankstar.charts.letters import TEXT, folded
from crankstar.charts.resting import Rests, foot_panel, told
from crankstar.language.messages import MessageError, _
from crankstar.language.numbers import RPM, number

if TYPE_CHECKING:
    from crankstar.engine.engine import Engine

GREY = "#808080"
"""Text and axes: can be read on white and on black."""
VERMILION, BLUE = "#d55e00", "#2b83c6"
"""Which the colour-blind tell apart, and which show on white and on black."""
GREEN, ORANGE, PURPLE, SKY = "#009e73", "#e69f00", "#cc79a7", "#56b4e9"
YELLOW = "#f0e442"
PALE, DEEP = "#eef4f9", "#a9cbe6"
"""The least and the greatest of what is shown as a colour; letters on it can be read."""
PALETTE = (BLUE, GREEN, ORANGE, PURPLE, SKY)
"""For curves, after M. Okabe and K. Ito; vermilion marks the crank angle and optima."""
HALO = "#ffffff00"
"""The line around letters; what shows a figure gives it the colour of its ground."""
HEIGHT = 170
"""Of a panel of curves, px."""
TITLE = 14
"""Size of the letters of titles, px."""
THETA = "theta"
"""The parameter of figures that depend on the crank angle, in degrees."""

BELOW = 'paint-order="stroke" stroke-linejoin="round"'
"""Attributes of an SVG with which the line around letters lies below them."""
LONG = re.compile(r"-?\d+\.\d{3,}")


class ChartError(MessageError):
    """A figure that cannot be drawn; the message names what can."""


Panel = dict[str, Any]
"""A part of a figure as Vega-Lite."""


def styled(*layers: Layer) -> Chart:
    """A chart of layers with a transparent ground, grey text and axes, and its legend above."""
    panel = layered(layers, width=panel_width(), height=curve_height(HEIGHT))
    return Chart({**panel, "background": "transparent", "config": STYLE})


LINES = {
    "orient": "top",
    "title": None,
    "columnPadding": 22,
    "symbolType": "stroke",
    "symbolStrokeWidth": 3,
}
"""A legend of lines above a panel."""


def named_in_legend(
    lines: Sequence[tuple[str, str, Sequence[float]]], *, columns: int
) -> dict[str, Channel]:
    """The channels of colour and dashes of lines by their names, `what`, and one legend of both.

    `lines` are name, colour and dashes; a solid line has the dashes (1, 0).
    """
    legend = {**LINES, "columns": columns}
    names = [name for name, _colour, _dash in lines]
    ranges = {
        "color": [colour for _name, colour, _dash in lines],
        "strokeDash": [[*dash] for _name, _colour, dash in lines],
    }
    return {
        channel: field("what:N", scale={"domain": names, "range": values}, legend=legend)
        for channel, values in ranges.items()
    }


STYLE = {
    "font": "sans-serif",
    "view": {"stroke": None},
    "numberFormat": ".9~g",
    "aria": False,
    "mark": {"aria": False},
    "text": {"stroke": HALO, "strokeWidth": 4},
    "axis": {
        **{f"{part}Color": GREY for part in ("label", "title", "tick", "domain", "grid")},
        "labelFontSize": 13,
        "titleFontSize": TITLE,
        "titleFontWeight": "normal",
        "gridOpacity": 0.25,
        "labelSeparation": 8,
    },
    "axisY": {
        "titlePadding": 10
    },  # a browser's own letters may be wider than those that are reckoned with
    "legend": {"labelColor": GREY, "labelFontSize": 13, "labelLimit": 200},
    "title": {
        "color": GREY,
        "fontSize": TITLE,
        "fontWeight": "normal",
        "anchor": "start",
        "offset": 8,
        "subtitleColor": GREY,
        "subtitleFontSize": TEXT,
        "subtitlePadding": 4,
    },
}
"""Grey text and axes, which can be read on light and on dark."""


def layered(layers: Sequence[Layer], *, width: float, height: float, title: str = "") -> Panel:
    """A panel of layers, the first below the others; each line of its title is on its own line."""
    panel: Panel = {
        "layer": [layer.spec for layer in layers],
        "width": round(width, 3),
        "height": round(height, 3),
    }
    lines = [line for part in title.split("\n") for line in folded(part, width=width)]
    return {**panel, "title": _head(lines)} if title else panel


def stacked(panels: Sequence[Panel], *, title: Sequence[str]) -> Panel:
    """Panels one below the other as one, under a title in lines."""
    return {"vconcat": panels, "spacing": 8, "title": _head(title)}


def _head(lines: Sequence[str]) -> dict[str, Any]:
    return {"text": lines, "fontSize": TEXT}


def figure(
    rows: Sequence[Sequence[Panel]],
    *,
    title: str,
    subtitle: Sequence[str] = (),
    theta: float | None = None,
    turns: int = 1,
    rests: Rests | None = None,
) -> Chart:
    """Panels in rows under one title; the crank angle `theta` (radians), if given, is a parameter.

    In HTML the parameter has a slider over `turns` of the crankshaft; in a picture it leaves no
    trace. What the numbers rest on stands below the panels.
    """
    width = max(map(_row_width, rows))
    below = [line for text in subtitle for line in folded(text, width=width)]
    above = folded(title, width=width, size=TITLE)
    parts: dict[str, Any] = {
        "vconcat": [
            {"hconcat": list(row), "spacing": BETWEEN} if len(row) > 1 else row[0] for row in rows
        ],
        "title": {"text": above, **({"subtitle": below} if below else {})},
        "spacing": 14,
        "background": "transparent",
        "config": STYLE,
    }
    if theta is not None:
        slider = {
            "input": "range",
            "min": 0,
            "max": 360 * turns,
            "step": 1,
            "name": _("crank angle θ (degrees)") + " ",
        }
        value = round(degrees(checked_angle(theta)), 9)
        parts["params"] = [{"name": THETA, "value": value, "bind": slider}]
    known = told(rests)
    if known.foot:
        lines = {"all": known.foot, "name": [known.named], "": []}[foot_room()]
        parts["vconcat"] += [foot_panel(lines, width=width)] if lines else []
        parts["usermeta"] = known.facts
    return Chart(parts, known.sentences)


def _row_width(row: Sequence[Panel]) -> float:
    """Of panels side by side, px."""
    return sum(_width(panel) for panel in row) + BETWEEN * (len(row) - 1)


def _width(panel: Panel) -> float:
    return max(map(_width, panel["vconcat"])) if "vconcat" in panel else panel["width"]


def named(engine: Engine) -> str:
    """The name of an engine, and its direction of rotation if that is counter-clockwise."""
    if engine.sense > 0:
        return engine.name
    return _("{engine}; turns counter-clockwise", engine=engine.name)


def heading(engine: Engine, *, speed: float | None = None) -> list[str]:
    """What a figure of one engine says below its title: its name, unless the canvas leaves it.

    With the `speed` (rad/s) of its forces, where they are in newtons.
    """
    if names_engine():
        return [named(engine), *speed_lines([engine], speed)]
    return [] if engine.sense > 0 else [_("turns counter-clockwise")]


def speed_lines(engines: Sequence[Engine], speed: float | None) -> list[str]:
    """At which speed the forces of engines are, where that is known and they have masses."""
    if speed is None or any({"mass", "radius"} & {*engine.relative} for engine in engines):
        return []
    return [_("at {rpm} rpm", rpm=number(speed * RPM))]


def checked_angle(theta: float) -> float:
    """The crank angle if it is finite; raises ChartError."""
    if not isfinite(theta):
        raise ChartError(_("the crank angle is {angle}; give an angle in radians", angle=theta))
    return float(theta)


def checked_order(order: float) -> float:
    """The order if it is positive; raises ChartError."""
    if not isfinite(order) or order <= 0:
        raise ChartError(_("the order is {order}; it must be greater than 0", order=f"{order:g}"))
    return float(order)


def brief(value: float) -> str:
    """A number for a label, to three figures.

    >>> brief(1190.4), brief(0.25402)
    ('1190', '0.254')
    """
    return number(float(f"{value:.3g}"))


def svg(chart: Chart, title: str) -> str:
    """A chart as an SVG with a title for screen readers, coordinates in hundredths of a pixel."""
    return svg_later(chart, title)()


def svg_later(chart: Chart, title: str) -> Callable[[], str]:
    """The same; the chart may be drawn while other work is done, until the text is asked for."""
    from crankstar.charts import converter

    drawing = converter.drawn(chart.to_dict())
    return lambda: _titled(drawing.result(), title)


def _titled(drawing: str, title: str) -> str:
    drawing = re.sub(
        r' (?:xmlns:xlink|version|aria-[\w-]+|role)="[^"]*"', "", drawing[drawing.index("<svg") :]
    )
    drawing = re.sub(
        r' (?:d|transform|[xy]2?)="[^"]*"', lambda match: LONG.sub(_rounded, match.group()), drawing
    )
    drawing = drawing.replace(f'stroke="{HALO}"', f'stroke="{HALO}" {BELOW}')
    drawing = re.sub(r"^<svg\b", '<svg role="img"', drawing)
    head, rest = drawing.split(">", 1)
    return f"{head}><title>{escape(title)}</title>{rest}".replace("\n", "")


def _rounded(match: re.Match[str]) -> str:
    return f"{float(match.group()):.2f}".rstrip("0").rstrip(".")
