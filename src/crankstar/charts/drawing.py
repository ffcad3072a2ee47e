"""What all figures have in common: colours, text that can be read on light and dark pages, the crank angle as a parameter."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from functools import cache
from html import escape
from math import degrees, isfinite
from textwrap import wrap
from typing import TYPE_CHECKING, Any

from crankstar.wording import number

if TYPE_CHECKING:
    import altair

    from crankstar.engine import Engine

GREY = "#808080"
"""Text and axes: can be read on white and on black."""
PRINTED, OURS = "#d55e00", "#2b83c6"
"""Vermilion and blue, which the colour-blind tell apart, and which show on white and on black."""
VERMILION, BLUE = PRINTED, OURS
GREEN, ORANGE, PURPLE, SKY = "#009e73", "#e69f00", "#cc79a7", "#56b4e9"
PALETTE = (BLUE, GREEN, ORANGE, PURPLE, SKY)
"""For curves that stand side by side, after M. Okabe and K. Ito; vermilion marks the crank angle, and the best value."""
WIDTH, HEIGHT = 330, 170
"""Of the plotting area; with its axes a figure is about 400 pixels wide."""
HALF = 190
"""Width of a panel that has another one beside it."""
SMALL, TEXT = 12, 13
"""Sizes of letters, px."""
LETTER = 0.56
"""Mean width of a letter in its size; enough to keep labels apart."""
THETA = "theta"
"""The one parameter of every figure that depends on the crank angle, in degrees."""

LONG = re.compile(r"-?\d+\.\d{3,}")


class ChartError(ValueError):
    """A figure that cannot be drawn, as one sentence that says what can."""


@contextmanager
def swiftly() -> Iterator[None]:
    """While this lasts Altair does not check every part of a chart as it is made, which takes three times as long as making it.

    What figures are made of is checked by the tests. To be entered by one thread at a time: Altair has one switch for all.
    """
    from altair.utils.schemapi import debug_mode

    with debug_mode(False):
        yield


def of_rows(rows: Sequence[dict[str, Any]]) -> altair.Chart:
    """A chart of rows of data, without a mark as yet."""
    import altair as alt

    # a tuple, because Altair copies lists row by row, again and again, when it puts charts together
    return alt.Chart(alt.Data(values=tuple(rows)))


Panel = dict[str, Any]
"""A part of a figure as Vega-Lite: made of Altair's charts, put together without copying each of them again and again."""


def styled(chart: Any) -> altair.LayerChart:
    """A chart with a transparent ground, grey text and axes, and its legend above."""
    shown = chart.properties(width=WIDTH, height=HEIGHT, background="transparent")
    shown.config = STYLE
    return shown


STYLE = {
    "font": "sans-serif",
    "view": {"stroke": None},
    "axis": {
        "labelColor": GREY,
        "titleColor": GREY,
        "tickColor": GREY,
        "domainColor": GREY,
        "gridColor": GREY,
        "labelFontSize": 13,
        "titleFontSize": 14,
        "titleFontWeight": "normal",
        "gridOpacity": 0.25,
        "labelSeparation": 8,
    },
    "axisY": {"titlePadding": 10},  # a browser's own letters may be wider than those that are reckoned with
    "legend": {"labelColor": GREY, "labelFontSize": 13, "labelLimit": 200},
    "title": {
        "color": GREY,
        "fontSize": 14,
        "fontWeight": "normal",
        "anchor": "start",
        "offset": 8,
        "subtitleColor": GREY,
        "subtitleFontSize": TEXT,
        "subtitlePadding": 4,
    },
}
"""Grey text and axes, which can be read on light and on dark."""


def layered(layers: Sequence[altair.Chart], *, width: float, height: float, title: str = "") -> Panel:
    """A panel of layers, the first below the others; each line of its title on a line of its own."""
    import altair as alt

    specs = []
    for layer in layers:
        bare = layer.copy(deep=False)
        bare.data = alt.Undefined
        rows = list(layer["data"]["values"])
        specs.append({**bare.to_dict(validate=False, context={"top_level": False}), "data": {"values": rows}})
    panel: Panel = {"layer": specs, "width": round(width, 3), "height": round(height, 3)}
    return {**panel, "title": _head(title)} if title else panel


def stacked(panels: Sequence[Panel], *, title: str = "") -> Panel:
    """Panels one below the other as one."""
    block: Panel = {"vconcat": list(panels), "spacing": 8}
    return {**block, "title": _head(title)} if title else block


def _head(title: str) -> dict[str, Any]:
    return {"text": title.split("\n"), "fontSize": TEXT}


def figure(
    rows: Sequence[Sequence[Panel]], *, title: str, subtitle: Sequence[str] = (), theta: float | None = None, turns: int = 1
) -> altair.VConcatChart:
    """Panels in rows under one title, with the crank angle `theta` (radians) as a parameter where one is given.

    In HTML the parameter has a slider over `turns` of the crankshaft; in a picture it leaves no trace.
    """
    below = [line for text in subtitle for line in folded(text)]
    parts: dict[str, Any] = {
        "vconcat": [{"hconcat": list(row), "spacing": 18} if len(row) > 1 else row[0] for row in rows],
        "title": {"text": folded(title), **({"subtitle": below} if below else {})},
        "spacing": 14,
        "background": "transparent",
        "config": STYLE,
    }
    if theta is not None:
        slider = {"input": "range", "min": 0, "max": 360 * turns, "step": 1, "name": "crank angle θ (degrees) "}
        parts["params"] = [{"name": THETA, "value": round(degrees(theta), 9), "bind": slider}]
    return _assembled()(**parts)


@cache
def _assembled() -> type[altair.VConcatChart]:
    """Altair's chart of panels one below the other, for panels that are Vega-Lite already."""
    import altair as alt

    class Assembled(alt.VConcatChart):
        """A figure put together from Vega-Lite; to be shown, saved and written, not to be taken apart."""

        def __init__(self, **parts: Any) -> None:
            super(alt.VConcatChart, self).__init__(**parts)  # not Altair's own, which merges what its panels have in common

    return Assembled


def folded(text: str, width: int = 48) -> list[str]:
    """A text in lines that fit a figure."""
    return wrap(text, width, break_long_words=True) or [""]


def named(engine: Engine) -> str:
    """The name of an engine under a title, and which way it turns where that is not clockwise seen from the front."""
    return engine.name if engine.sense > 0 else f"{engine.name}; turns counter-clockwise"


def checked_angle(theta: float) -> float:
    """A crank angle that is a number; raises ChartError."""
    if not isfinite(theta):
        raise ChartError(f"the crank angle is {theta}; give an angle in radians")
    return float(theta)


def checked_order(order: float) -> float:
    """An order that can be; raises ChartError."""
    if not isfinite(order) or order <= 0:
        raise ChartError(f"the order is {order:g}; give one greater than 0, counted per turn of the reference crankshaft")
    return float(order)


def numbers_text(numbers: Sequence[int]) -> str:
    """Numbers for a label: runs of three and more as a range, long lists by their ends.

    >>> numbers_text([1, 8]), numbers_text([1, 2, 3, 5])
    ('1, 8', '1–3, 5')
    """
    runs: list[list[int]] = []
    for one in sorted(numbers):
        if runs and one == runs[-1][-1] + 1:
            runs[-1].append(one)
        else:
            runs.append([one])
    said = [text for run in runs for text in ([f"{run[0]}–{run[-1]}"] if len(run) > 2 else map(str, run))]
    return ", ".join(said) if len(said) <= 6 else f"{', '.join(said[:3])} … {said[-1]}"


def brief(value: float) -> str:
    """A number for a label, to three figures.

    >>> brief(1190.4), brief(0.25402)
    ('1190', '0.254')
    """
    return number(float(f"{value:.3g}"))


def text_width(text: str, size: float = TEXT) -> float:
    """About how wide the longest line of a text is, px."""
    return LETTER * size * max(map(len, text.split("\n")))


def svg(chart: Any, title: str) -> str:
    """A chart as an SVG that fits the width it is given, with a title for those who do not see it.

    Coordinates are rounded to hundredths of a pixel.
    """
    import vl_convert

    drawing = vl_convert.vegalite_to_svg(chart.to_dict(validate=False))
    drawing = re.sub(r' (?:xmlns:xlink|version|aria-[\w-]+|role)="[^"]*"', "", drawing[drawing.index("<svg") :])
    drawing = re.sub(r' (?:d|transform|[xy]2?)="[^"]*"', lambda found: LONG.sub(_rounded, found.group()), drawing)
    drawing = re.sub(r"^<svg\b", '<svg role="img"', drawing)
    head, rest = drawing.split(">", 1)
    return f"{head}><title>{escape(title)}</title>{rest}".replace("\n", "")


def _rounded(found: re.Match[str]) -> str:
    return f"{float(found.group()):.2f}".rstrip("0").rstrip(".")
