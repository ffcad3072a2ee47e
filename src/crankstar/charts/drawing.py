"""What all figures have in common: colours, axes that can be read on light and dark pages, and SVG without a browser."""

from __future__ import annotations

import re
from html import escape
from io import StringIO
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    import altair

GREY = "#808080"
"""Text and axes: can be read on white and on black."""
PRINTED, OURS = "#d55e00", "#2b83c6"
"""Vermilion and blue, which the colour-blind tell apart, and which show on white and on black."""
WIDTH, HEIGHT = 330, 170
"""Of the plotting area; with its axes a figure is about 400 pixels wide."""

LONG = re.compile(r"-?\d+\.\d{3,}")


def styled(chart: Any) -> altair.LayerChart:
    """A chart with a transparent ground, grey text and axes, and its legend above."""
    axis = {"labelColor": GREY, "titleColor": GREY, "tickColor": GREY, "domainColor": GREY, "gridColor": GREY}
    sizes = {"labelFontSize": 13, "titleFontSize": 14, "titleFontWeight": "normal", "gridOpacity": 0.25}
    legend = {"labelColor": GREY, "labelFontSize": 13, "labelLimit": 200}
    return (
        chart.properties(width=WIDTH, height=HEIGHT, background="transparent")
        .configure(font="sans-serif")
        .configure_view(stroke=None)
        .configure_axis(**axis, **sizes)
        .configure_legend(**legend)
    )


def svg(chart: altair.LayerChart, title: str) -> str:
    """A chart as an SVG that fits the width it is given, with a title for those who do not see it.

    Coordinates are rounded to hundredths of a pixel.
    """
    text = StringIO()
    chart.save(text, format="svg")
    drawing = text.getvalue()
    drawing = re.sub(r' (?:xmlns:xlink|version|aria-[\w-]+|role)="[^"]*"', "", drawing[drawing.index("<svg") :])
    drawing = re.sub(r' (?:d|transform|[xy]2?)="[^"]*"', lambda found: LONG.sub(_rounded, found.group()), drawing)
    drawing = re.sub(r"^<svg\b", '<svg role="img"', drawing)
    head, rest = drawing.split(">", 1)
    return f"{head}><title>{escape(title)}</title>{rest}".replace("\n", "")


def _rounded(found: re.Match[str]) -> str:
    return f"{float(found.group()):.2f}".rstrip("0").rstrip(".")
