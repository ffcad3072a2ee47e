"""The best stars of a search side by side: throws from the front, firing order, values."""

from __future__ import annotations

from typing import TYPE_CHECKING

from crankstar.charts.canvas import half_width
from crankstar.charts.crank_stars import crank_panel
from crankstar.charts.drawing import ChartError, Panel, checked_angle, figure
from crankstar.charts.grammar import Chart
from crankstar.charts.search_values import columns, engine_text, order_lines, units_text, values_of
from crankstar.language.messages import _
from crankstar.language.numbers import number
from crankstar.stars.engines import engine, firing_order

if TYPE_CHECKING:
    from crankstar.stars.answer import Answer

SHOWN = 6
"""Stars in a figure by default."""
ROOM = 60.0
"""Px above and below a star together, for its labels."""
MOST = 24
"""Greatest number of stars in a figure."""


def best_stars(answer: Answer, *, count: int = SHOWN, theta: float = 0.0) -> Chart:
    """The first stars of a search from the front at the crank angle `theta` (radians).

    Two in a row. Each throw has the number of its cylinder, cylinder 1 is up at theta = 0; above
    each star are its row in the answer, its firing order and its values. `count`: 1 to 24 stars.
    Raises ChartError.
    """
    if not answer.rows:
        raise ChartError(_("there is no star to draw: the search found none within the limits"))
    if not 1 <= count <= MOST:
        raise ChartError(
            _("{count} stars do not fit in a figure; give 1 to {most}", count=count, most=MOST)
        )
    theta = checked_angle(theta)
    panels = [_panel(answer, index, theta) for index in range(min(count, len(answer.rows)))]
    rows = [panels[index : index + 2] for index in range(0, len(panels), 2)]
    subtitle = [engine_text(answer.question.stars)]
    if len(panels) < len(answer.rows):
        subtitle.append(_("{shown} of {count} stars", shown=len(panels), count=len(answer.rows)))
    subtitle += filter(None, [units_text(columns(answer))])
    return figure(rows, title=_("Crank stars, seen from the front"), subtitle=subtitle, theta=theta)


def _panel(answer: Answer, index: int, theta: float) -> Panel:
    row, stars = answer.rows[index], answer.question.stars
    heads = columns(answer)
    values = [
        f"{head.name} {number(value, digits=4)}"
        for head, value in zip(heads, values_of(row, heads), strict=True)
    ]
    if not any(head.counted for head in heads):
        values.append(_("neighbours {count}", count=row.neighbours))
    order = order_lines(firing_order(stars, row.star), width=half_width() - 20)
    words = [f"{index + 1}:  {order[0]}", *order[1:], *_pairs(values)]
    panel, _moved = crank_panel(
        engine(stars, row.star), theta=theta, width=half_width(), room=ROOM, title="\n".join(words)
    )
    return panel


def _pairs(values: list[str]) -> list[str]:
    """Values, two on a line."""
    return [", ".join(values[index : index + 2]) for index in range(0, len(values), 2)]
