"""A chart as a file: SVG, PNG, PDF without a browser, a page that needs no network, or its Vega-Lite description."""

from __future__ import annotations

import json
from typing import Any

from crankstar.charts.drawing import ChartError, svg

SUFFIXES = ("svg", "png", "pdf", "html", "json")
"""What `saved` can write."""
DENSITY = 2
"""Pixels of a PNG to one of the figure."""
GROUND = "white"
"""Of a PNG: what shows one differs in what it puts behind it."""


def saved(chart: Any, suffix: str, *, title: str) -> bytes:
    """A chart as the contents of a file with this suffix (svg, png, pdf, html, json); `title` is for those who do not see it.

    Raises ChartError for another suffix.
    """
    import vl_convert

    kind = suffix.lower().removeprefix(".")
    if kind == "svg":
        return svg(chart, title).encode()
    if kind == "png":
        return vl_convert.vegalite_to_png({**chart.to_dict(validate=False), "background": GROUND}, scale=DENSITY)
    if kind == "pdf":
        return vl_convert.vegalite_to_pdf(chart.to_dict(validate=False))
    if kind == "html":
        return _page(chart, title).encode()
    if kind == "json":
        return json.dumps({**chart.to_dict(validate=False), "description": title}, ensure_ascii=False, indent=1).encode()
    raise ChartError(
        f"a chart cannot be written as {suffix!r}; end the name of the file in one of {', '.join('.' + s for s in SUFFIXES)}"
    )


def _page(chart: Any, title: str) -> str:
    """A page with all scripts in it, which asks nothing of the network; what an engine is called stays text."""
    from html import escape

    shown = type(chart)(**_disarmed(chart._kwds))
    text = shown.to_html(inline=True, embed_options={"actions": False, "renderer": "svg"})
    text = text.replace(BRACKET, "\\u003c").replace(json.dumps(BRACKET)[1:-1], "\\u003c")
    return text.replace("<head>", f'<head><title>{escape(title)}</title><meta name="viewport" content="width=device-width">', 1)


BRACKET = "\ue03c"
"""Stands for an opening angle bracket in the description of a chart, so that no text in it can end the script it is in."""


def _disarmed(value: Any) -> Any:
    """The same tree with every opening angle bracket in its texts replaced."""
    if isinstance(value, str):
        return value.replace("<", BRACKET)
    if isinstance(value, dict):
        return {key: _disarmed(item) for key, item in value.items()}
    if isinstance(value, list | tuple):
        return [_disarmed(item) for item in value]
    return value
