"""The Pareto front of a search: numbered points by two objectives, and a key of firing orders."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import TYPE_CHECKING, Any

from crankstar.charts.canvas import panel_width
from crankstar.charts.drawing import BLUE, GREY, PALETTE, ChartError, Panel, figure, layered
from crankstar.charts.front_axes import Axis, axis_of, channel, spans_decades
from crankstar.charts.front_keys import front_key
from crankstar.charts.front_numbers import DOT, HEIGHT, point_numbers
from crankstar.charts.grammar import DISC, Chart, constant, field, of_rows
from crankstar.charts.letters import SMALL, TEXT
from crankstar.charts.search_values import (
    Column,
    FrontPoints,
    points_of,
    sequence_points,
    values_of,
)
from crankstar.language.messages import _
from crankstar.stars.question import Front

if TYPE_CHECKING:
    from crankstar.stars.answer import Answer
    from crankstar.stars.sequence_fronts import SequenceFront

CELL = 2.0
"""px: one of the other stars is drawn in a square of this size."""
MOST_DRAWN = 2000
"""Greatest number of points that are all drawn; of more, covered points are left out."""


def pareto_front(
    answer: Answer, *, others: Answer | None = None, logarithmic: bool | None = None
) -> Chart:
    """The points of a front by two objectives, coloured by the third, with firing orders.

    With two objectives no star lies below and left of the dashed line. `others` are further stars
    with the same two objectives, drawn pale. `logarithmic` axes have a place of their own for 0; by
    default they are used where values span two powers of ten, not for counts. Raises ChartError.
    """
    if others is not None and _objectives(others) != _objectives(answer):
        raise ChartError(_("the other stars have other objectives; the first two must be the same"))
    points = points_of(answer)
    _checked(points)
    pale = [values_of(row, points.heads[:2]) for row in others.rows] if others is not None else []
    proved = isinstance(answer.question.ask, Front)
    return _front(points, pale, logarithmic, title="" if proved else _starry(points))


def sequence_chart(front: SequenceFront, *, logarithmic: bool | None = None) -> Chart:
    """The same of a front over stars and firing orders together. Raises ChartError."""
    points = sequence_points(front)
    _checked(points)
    return _front(points, [], logarithmic)


def _checked(points: FrontPoints) -> None:
    """Raises ChartError where there is no front to draw."""
    if len(points.heads) < 2:
        raise ChartError(
            _(
                "a front needs two objectives, the search has {count}; draw the stars instead",
                count=len(points.heads),
            )
        )
    if not points.values:
        raise ChartError(_("there is no star to draw: the search found none within the limits"))


def _starry(points: FrontPoints) -> str:
    """The title of stars that are no front."""
    *first, last = (head.name for head in points.heads)
    return _("Crank stars by {objectives} and {last}", objectives=", ".join(first), last=last)


def _front(
    points: FrontPoints,
    pale: Sequence[tuple[float, ...]],
    logarithmic: bool | None,
    *,
    title: str = "",
) -> Chart:
    """The figure, under a title that says front where there is none."""
    heads = points.heads
    measured = [place for place in (0, 1) if not heads[place].counted]
    if logarithmic is None:
        logarithmic = any(
            spans_decades([point[place] for point in points.values]) for place in measured
        )
    first, second = ([point[place] for point in (*points.values, *pale)] for place in (0, 1))
    across = axis_of(first, panel_width(), powers=logarithmic and 0 in measured)
    upward = axis_of(second, HEIGHT, powers=logarithmic and 1 in measured)
    panel, every_number = _front_panel(points, across, upward, pale)
    *before, last = (head.name for head in heads)
    title = title or _(
        "Pareto front of {objectives} and {last}", objectives=", ".join(before), last=last
    )
    subtitle = [points.engine]
    if not every_number:
        subtitle.append(_("numbers where there is room"))
    return figure([[panel], [front_key(points)]], title=title, subtitle=subtitle)


def _front_panel(
    own: FrontPoints, across: Axis, upward: Axis, pale: Sequence[tuple[float, ...]]
) -> tuple[Panel, bool]:
    """The points in a panel, and whether each has its number."""
    heads, points = own.heads, own.values
    x, y = (channel("x", across, heads[0].title), channel("y", upward, heads[1].title))
    layers: list[Any] = []
    if pale:
        spots = (pale[index] for index in _seen(pale, across, upward))
        dots = of_rows([_spot(spot, across, upward) for spot in spots])
        style = {**DISC, "opacity": 0.4, "size": 16, "color": GREY}
        layers.append(dots.mark("point", **style).encode(x=x, y=y))
    steps = _steps(points, across, upward) if len(heads) == 2 else []
    if steps:
        line = of_rows(steps).mark("line", color=GREY, strokeWidth=1.3, strokeDash=[5, 3])
        layers.append(line.encode(x=x, y=y, order=field("at:Q")))
    shown = range(len(points)) if len(points) <= MOST_DRAWN else _seen(points, across, upward)
    rows = [_row(own, place, across, upward) for place in shown]
    hints = [field("row:N", title=_("row")), field("order:N", title=_("firing order"))]
    hints += [field(f"value{index}:Q", title=head.title) for index, head in enumerate(heads)]
    dots = of_rows(rows).mark("point", **DISC, size=DOT)
    layers.append(dots.encode(x=x, y=y, color=_colour(heads, rows), tooltip=hints))
    numbers, leaders = point_numbers(rows, steps, across, upward)
    if leaders:
        lines = of_rows(leaders).mark("rule", color=GREY, strokeWidth=0.8)
        layers.append(lines.encode(x=x, y=y, x2=field("x2"), y2=field("y2")))
    texts = of_rows(numbers).mark("text", fontSize=SMALL, color=GREY, baseline="middle")
    layers.append(texts.encode(x=x, y=y, text=field("text:N")))
    return layered(layers, width=panel_width(), height=HEIGHT), len(numbers) == len(points)


def _row(own: FrontPoints, index: int, across: Axis, upward: Axis) -> dict[str, Any]:
    """A point: its place, number, firing order and values."""
    order = "-".join(map(str, own.orders[index]))
    values = own.values[index]
    named = {f"value{column}": value for column, value in enumerate(values)}
    return {**_spot(values, across, upward), "row": index + 1, "order": order, **named}


def _objectives(answer: Answer) -> list[tuple[str, str]]:
    """The names and units of the first two values, as the search counts them."""
    question = answer.question
    named = [(each.name, each.unit) for each in (*question.objectives, *question.functions)]
    return named[:2]


def _spot(values: Sequence[float], across: Axis, upward: Axis) -> dict[str, float]:
    """Where a star is drawn: at its first two values."""
    return {"x": across.drawn(values[0]), "y": upward.drawn(values[1])}


def _colour(heads: Sequence[Column], rows: Sequence[dict[str, Any]]) -> Any:
    """One colour, or that of the third objective: a palette for few counts, else a scale."""
    if len(heads) < 3 or len({row["value2"] for row in rows}) < 2:
        return constant(BLUE)
    legend = {
        "orient": "top",
        "title": heads[2].title,
        "titleColor": GREY,
        "titleFontSize": TEXT,
        "titleFontWeight": "normal",
    }
    kinds = sorted({row["value2"] for row in rows})
    if heads[2].counted and len(kinds) <= len(PALETTE):
        colours = {"domain": kinds, "range": list(PALETTE[: len(kinds)])}
        return field(
            "value2:O", scale=colours, legend=legend | {"titleOrient": "left", "format": "d"}
        )
    legend |= {"gradientLength": panel_width(), "gradientThickness": 10, "tickCount": 5}
    return field("value2:Q", scale={"scheme": "viridis"}, legend=legend)


def _seen(points: Sequence[tuple[float, ...]], across: Axis, upward: Axis) -> list[int]:
    """The indices of the visible points: the first of those that cover each other."""
    first: dict[tuple[int, int], int] = {}
    for index, point in enumerate(points):
        place = round(across.place(point[0]) / CELL), round(upward.place(point[1]) / CELL)
        first.setdefault(place, index)
    return list(first.values())


def _steps(
    points: Sequence[tuple[float, ...]], across: Axis, upward: Axis
) -> list[dict[str, float]]:
    """The corners of the line below which no star lies, from the upper to the right edge."""
    best: list[tuple[float, float]] = []
    for x, y, *_others in sorted(points):
        if not best or y < best[-1][1]:
            best.append((x, y))
    corners = [(best[0][0], upward.high), best[0]]
    for (_left, above), (x, y) in pairwise(best):
        corners += [(x, above), (x, y)]
    corners.append((across.high, best[-1][1]))
    return [{**_spot(spot, across, upward), "at": index} for index, spot in enumerate(corners)]
