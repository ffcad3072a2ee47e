"""The best stars of a search side by side: throws from the front, firing order, values."""

from __future__ import annotations

from typing import TYPE_CHECKING

from crankstar.charts.drawing import HALF, ChartError, Panel, checked_angle, figure
from crankstar.charts.fronts import columns, engine_words, order_lines, units_text
from crankstar.charts.stars import crank_panel
from crankstar.search.engines import engine
from crankstar.wording import number

if TYPE_CHECKING:
    import altair

    from crankstar.search.findings import Findings

SHOWN = 6
"""Stars in a figure, where nothing else is said."""
ROOM = 60.0
"""Px above and below a star together, for its labels."""
MOST = 24
"""Stars that can be drawn in one figure."""


def best_stars(found: Findings, *, count: int = SHOWN, theta: float = 0.0) -> altair.VConcatChart:
    """The first stars of a search, two in a row, seen from the front at the crank angle `theta` (radians).

    Each throw has the number of its cylinder, and cylinder 1 is up at theta = 0; above each star stand its number in the
    findings, its firing order and its values. `count`: how many are drawn, up to 24; if there are more, the subtitle says so.
    Raises ChartError.
    """
    if not found.rows:
        raise ChartError("there is no star to draw; none was found within the limits")
    if not 1 <= count <= MOST:
        raise ChartError(f"{count} stars cannot be drawn in one figure; give a number from 1 to {MOST}")
    theta = checked_angle(theta)
    panels = [_panel(found, place, theta) for place in range(min(count, len(found.rows)))]
    rows = [panels[place : place + 2] for place in range(0, len(panels), 2)]
    part = f"the first {len(panels)} of {len(found.rows)}" if len(panels) < len(found.rows) else ""
    subtitle = filter(None, [engine_words(found.question.stars), part, units_text(columns(found))])
    return figure(rows, title="Crank stars from the front", subtitle=list(subtitle), theta=theta)


def _panel(found: Findings, place: int, theta: float) -> Panel:
    row, stars = found.rows[place], found.question.stars
    heads = columns(found)
    values = [f"{head.name} {number(value, digits=4)}" for head, value in zip(heads, row.values, strict=True)]
    if not any(head.counted for head in heads):
        values.append(f"neighbours {row.neighbours}")
    order = order_lines(stars, row, width=HALF - 20)
    words = [f"{place + 1}:  {order[0]}", *order[1:], *_pairs(values)]
    panel, _ = crank_panel(engine(stars, row.star), theta=theta, width=HALF, room=ROOM, title="\n".join(words))
    return panel


def _pairs(values: list[str]) -> list[str]:
    """Values, two on a line."""
    return [", ".join(values[place : place + 2]) for place in range(0, len(values), 2)]
