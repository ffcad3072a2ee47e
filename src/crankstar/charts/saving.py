"""A chart as a file: SVG, PNG, PDF, an HTML page without network, or its Vega-Lite description."""

from __future__ import annotations

import json
import re
from importlib.resources import files
from typing import Any

from crankstar.charts.drawing import HALO, ChartError, svg
from crankstar.charts.fonts import registered
from crankstar.charts.grammar import Chart
from crankstar.charts.paper import Print
from crankstar.language.messages import _

SUFFIXES = ("svg", "png", "pdf", "html", "json")
"""The formats of `saved`."""
DENSITY = 2
"""Pixels of a PNG to one of the figure."""
GROUND = "white"
"""Background of a PNG, which viewers would otherwise choose."""


def saved(chart: Chart, suffix: str, *, title: str) -> bytes:
    """A chart as the contents of a file with this suffix (svg, png, pdf, html, json).

    `title` is the text for readers who cannot see it.

    Raises ChartError for another suffix.
    """
    import vl_convert

    registered()
    kind = suffix.lower().removeprefix(".")
    if kind == "svg":
        return svg(chart, title).encode()
    if kind == "png":
        drawing = svg(Chart({**chart.spec, "background": GROUND}), title).replace(HALO, GROUND)
        return vl_convert.svg_to_png(drawing, scale=DENSITY)
    if kind == "pdf":
        return vl_convert.vegalite_to_pdf(chart.to_dict())
    if kind == "html":
        return _page(chart, title).encode()
    if kind == "json":
        return json.dumps(
            {**chart.to_dict(), "description": title}, ensure_ascii=False, indent=1
        ).encode()
    raise ChartError(
        _(
            "a chart cannot be written as {suffix}; the file name must end in {suffixes}",
            suffix=repr(suffix),
            suffixes=", ".join(f".{name}" for name in SUFFIXES),
        )
    )


def saved_print(made: Print, suffix: str, *, title: str) -> bytes:
    """A figure for paper as the contents of a file with this suffix.

    An HTML page and a description have its theme and layout, but no size on paper. Raises
    ChartError for another suffix.
    """
    import vl_convert

    registered()
    kind = suffix.lower().removeprefix(".")
    if kind == "svg":
        return made.scaled("mm").encode()
    if kind == "png":
        return vl_convert.svg_to_png(made.scaled("px"), scale=72 / 96, ppi=made.paper.dpi)
    if kind == "pdf":
        return vl_convert.svg_to_pdf(made.scaled("pt"))
    return saved(made.chart, suffix, title=title)


def _page(chart: Chart, title: str) -> str:
    """A page with all its scripts; the names of engines in it are text only."""
    from html import escape

    import vl_convert

    own = chart.to_dict()
    meta = {**own.get("usermeta", {}), "embedOptions": {"actions": False}}
    tree = _disarmed({**own, "usermeta": meta})
    text = vl_convert.vegalite_to_html(tree, bundle=True, renderer="svg")
    text = text.replace(BRACKET, "\\u003c").replace(json.dumps(BRACKET)[1:-1], "\\u003c")
    viewport = '<meta name="viewport" content="width=device-width">'
    ground = tree["background"].replace("transparent", GROUND)
    halo = f'<style>text[stroke="{HALO}"] {{ stroke: {ground}; paint-order: stroke }}</style>'
    head = f"<title>{escape(title)}</title>{viewport}{halo}\n{_licences()}"
    return text.replace("<title>Chart</title>", head, 1)


def _licences() -> str:
    """The licences of Vega, which the bundle contains as well, as a comment."""
    notices = files("crankstar") / "bundle" / "third-party-licences.txt"
    if not notices.is_file():
        return ""
    text = re.sub("-{2,}", lambda dashes: "=" * len(dashes.group()), notices.read_text("utf-8"))
    return f"<!-- The scripts of this page are Vega, Vega-Lite and Vega-Embed.\n\n{text}\n-->\n"


BRACKET = "\ue03c"
"""Replaces `<` in the description of a chart, so that its text cannot end a script element."""


def _disarmed(value: Any) -> Any:
    """The same tree with every opening angle bracket in its texts replaced."""
    if isinstance(value, str):
        return value.replace("<", BRACKET)
    if isinstance(value, dict):
        return {key: _disarmed(item) for key, item in value.items()}
    if isinstance(value, list | tuple):
        return [_disarmed(item) for item in value]
    return value
