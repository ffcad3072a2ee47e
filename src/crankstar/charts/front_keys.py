"""The key of a front: number, firing order and values of its points as a table."""

from __future__ import annotations

from itertools import accumulate
from typing import Any

from crankstar.charts.drawing import GREY, Panel, layered
from crankstar.charts.front_numbers import MOST_LISTED
from crankstar.charts.grammar import field, of_rows, span
from crankstar.charts.letters import SMALL, text_width
from crankstar.charts.search_values import FrontPoints, order_lines
from crankstar.language.messages import _
from crankstar.language.numbers import number

KEY = 520
"""Greatest width of the key, px; longer firing orders are folded."""
LEFT = 24.0
"""Px from the left edge of the key to the axis."""
LINE = 17.0
"""Height of a line of the key, px."""


def front_key(points: FrontPoints) -> Panel:
    """Number, firing order, values, and neighbours that fire in succession."""
    names = [head.name for head in points.heads]
    cells = [[number(value, digits=4) for value in row] for row in points.values[:MOST_LISTED]]
    if not any(head.counted for head in points.heads):
        names.append(_("neighbours"))
        cells = [[*own, str(n)] for own, n in zip(cells, points.neighbours, strict=False)]
    widths = [
        max(text_width(text, SMALL) for text in column) + 16
        for column in zip(names, *cells, strict=True)
    ]
    room = max(KEY - sum(widths), 120.0)
    orders = [order_lines(order, width=room) for order in points.orders[:MOST_LISTED]]
    longest = max(text_width(line, SMALL) for order in orders for line in order)
    ends = list(accumulate(widths, initial=longest))
    texts = [
        _text(_("firing order"), 0, 0),
        *(_text(name, end, 0, "right") for name, end in zip(names, ends[1:], strict=True)),
    ]
    line = 1.3
    for index, (order, row) in enumerate(zip(orders, cells, strict=True), 1):
        texts += [_text(str(index), -10, line, "right")]
        texts += [_text(text, end, line, "right") for text, end in zip(row, ends[1:], strict=True)]
        texts += [_text(part, 0, line + further) for further, part in enumerate(order)]
        line += len(order)
    if len(points.values) > MOST_LISTED:
        more = len(points.values) - MOST_LISTED
        texts.append(_text(_("and {count} more", count=more), 0, line))
        line += 1
    width = ends[-1] - LEFT
    x = field("x:Q", scale=span(0, width), axis=None)
    y = field("y:Q", scale=span(line, 0), axis=None)
    layers = [
        of_rows([text for text in texts if text["side"] == side])
        .mark("text", fontSize=SMALL, color=GREY, align=side)
        .encode(x=x, y=y, text=field("text:N"))
        for side in ("left", "right")
    ]
    return layered(layers, width=width, height=line * LINE)


def _text(text: str, x: float, line: float, side: str = "left") -> dict[str, Any]:
    return {"text": text, "x": x - LEFT, "y": line + 0.5, "side": side}
