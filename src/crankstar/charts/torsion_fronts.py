"""The first points of a front over stars and firing orders: crank star, and vectors of torsion."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from crankstar.charts.canvas import half_width
from crankstar.charts.crank_stars import crank_panel
from crankstar.charts.drawing import ChartError, Panel, brief, figure
from crankstar.charts.grammar import Chart
from crankstar.charts.search_values import FrontPoints, order_lines, sequence_points, units_text
from crankstar.charts.vector_panels import vectors_panel
from crankstar.language.messages import _
from crankstar.language.numbers import number, order_text
from crankstar.stars.sequence_engines import engine_of
from crankstar.stars.shafts import Fired, Shaft
from crankstar.stars.vector_sums import OrderSum

if TYPE_CHECKING:
    from crankstar.stars.sequence_fronts import SequenceFront

SHOWN = 3
"""Points in a figure by default."""
MOST = 12
"""Greatest number of points in a figure."""
ACROSS = 2
"""Pictures in a row."""
ROOM = 60.0
"""Px above and below a star together, for its labels."""


def sequence_stars(front: SequenceFront, *, count: int = SHOWN) -> Chart:
    """The first points: the throws from the front, and the star of each order of torsion.

    Above each crank star are its row, firing order and values; beside it the vectors of the
    cylinders in the orders that were searched for, at order times firing angle, clockwise from up,
    and their sum. Raises ChartError.

    A crank star and three orders, two in a row:

    >>> from crankstar.options.sequences import sequences_of
    >>> from crankstar.options.words import SearchWords, SequenceWords
    >>> from crankstar.stars.sequence_fronts import sequence_front
    >>> asked = sequences_of(4, SearchWords(minimise="M1,twist"), SequenceWords())
    >>> found = sequence_front(asked.question)
    >>> len(sequence_stars(found, count=1).to_dict()["vconcat"])
    2
    """
    points = sequence_points(front)
    if not points.orders:
        raise ChartError(_("there is no star to draw: the search found none within the limits"))
    if not 1 <= count <= MOST:
        raise ChartError(
            _("{count} stars do not fit in a figure; give 1 to {most}", count=count, most=MOST)
        )
    shown = min(count, len(points.orders))
    goals = [one for goal in front.question.goals for one in goal.sums if one.kind == "T"]
    torsions = list(dict.fromkeys(goals))
    rows: list[list[Panel]] = []
    for index in range(shown):
        fired = front.points[index].fired
        panels = [_star(points, index, front.question.shaft, fired)]
        panels += [_vectors(one, front.question.shaft, fired) for one in torsions]
        rows += [panels[at : at + ACROSS] for at in range(0, len(panels), ACROSS)]
    subtitle = [points.engine]
    if shown < len(points.orders):
        subtitle.append(_("{shown} of {count} stars", shown=shown, count=len(points.orders)))
    if torsions:
        subtitle.append(_("blue: cylinders at order times firing angle; orange: their sum"))
    subtitle += filter(None, [units_text(points.heads)])
    title = _("Crank stars, and stars of torsion")
    return figure(rows, title=title, subtitle=subtitle, theta=0.0)


def _star(points: FrontPoints, index: int, shaft: Shaft, fired: Fired) -> Panel:
    """The crank from the front, under its firing order and values."""
    values = [
        f"{head.name} {number(value, digits=4)}"
        for head, value in zip(points.heads, points.values[index], strict=True)
    ]
    if not any(head.counted for head in points.heads):
        values.append(_("neighbours {count}", count=points.neighbours[index]))
    order = order_lines(points.orders[index], width=half_width() - 24)
    lines = [f"{index + 1}:  {order[0]}", *order[1:]]
    lines += [", ".join(values[at : at + 2]) for at in range(0, len(values), 2)]
    panel, _moved = crank_panel(
        engine_of(shaft, fired), theta=0.0, width=half_width(), room=ROOM, title="\n".join(lines)
    )
    return panel


def _vectors(one: OrderSum, shaft: Shaft, fired: Fired) -> Panel:
    """The vectors of the cylinders in an order of torsion."""
    angles = shaft.angles_deg(fired)
    numbers = [number for pin in shaft.numbers for number in pin]
    phases = float(one.order) * np.radians([float(angles[each]) for each in numbers])
    vectors = np.array([float(weight) for weight in one.weights]) * np.exp(1j * phases)
    size = one.length(shaft, fired)
    total = complex(vectors.sum()) if size else 0j
    title = _(
        "order {order}: sum {size}",
        order=order_text(float(one.order)),
        size=brief(size) if size else "0",
    )
    return vectors_panel(vectors, total, numbers, width=half_width(), title=title)
