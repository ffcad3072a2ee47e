"""The values and firing orders of found stars as text: objectives, units, engine."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import TYPE_CHECKING, NamedTuple

from crankstar.charts.letters import SMALL, text_width, together
from crankstar.language.messages import _, _n
from crankstar.language.numbers import numbers_text, unit_text
from crankstar.language.shown_units import shown
from crankstar.stars.engines import firing_order
from crankstar.stars.shafts import Shaft, followed
from crankstar.stars.star import Stars

if TYPE_CHECKING:
    from crankstar.stars.answer import Answer, AnswerRow
    from crankstar.stars.sequence_fronts import SequenceFront


class Column(NamedTuple):
    """A value of a found star: its name, the unit it is shown in, whether it is a count.

    `factor` is what a value of the search is multiplied by in that unit.
    """

    name: str
    unit: str
    counted: bool
    factor: float = 1.0

    @property
    def title(self) -> str:
        """The name with its unit, for an axis."""
        return f"{self.name} ({unit_text(self.unit)})" if self.unit else self.name


def columns(answer: Answer) -> tuple[Column, ...]:
    """The values of found stars as they are shown: the objectives, then Python functions."""
    question = answer.question
    named = [
        Column(each.name, each.unit, counted=bool(each.neighbours) and not each.terms)
        for each in question.objectives
    ]
    named += [Column(judge.name, judge.unit, counted=False) for judge in question.functions]
    tops: dict[str, float] = {}  # values of one unit have one prefix
    for row in answer.rows:
        for column, value in zip(named, row.values, strict=True):
            tops[column.unit] = max(tops.get(column.unit, 0.0), abs(value))
    units = [shown(column.unit, tops.get(column.unit, 0.0)) for column in named]
    return tuple(
        column._replace(unit=unit.unit, factor=unit.factor)
        for column, unit in zip(named, units, strict=True)
    )


def values_of(row: AnswerRow, heads: Sequence[Column]) -> tuple[float, ...]:
    """The values of a star in the units of the columns."""
    return tuple(value * head.factor for value, head in zip(row.values, heads, strict=False))


def engine_text(stars: Stars) -> str:
    """The engine of the stars in a line."""
    pitches = {a - b for a, b in pairwise(stars.positions)}
    count = stars.cylinders
    parts = [_n("{count} cylinder", "{count} cylinders", count, count=count), _(stars.cycle)]
    if stars.symmetric:
        parts.append(_("symmetric crank"))
    if len(pitches) > 1:
        parts.append(_("unequal pitches"))
    if stars.fixed:
        fixed = numbers_text([cylinder for cylinder, _angle in stars.fixed])
        parts.append(_("throws of {cylinders} fixed", cylinders=fixed))
    return ", ".join(parts)


def units_text(heads: Sequence[Column]) -> str:
    """The units of the values: `M1, M2 in m r ω² a`."""
    units = list(dict.fromkeys(head.unit for head in heads if head.unit))
    return "; ".join(
        _(
            "{values} in {unit}",
            values=", ".join(head.name for head in heads if head.unit == unit),
            unit=together(unit_text(unit)),
        )
        for unit in units
    )


def order_lines(order: Sequence[int], *, width: float) -> list[str]:
    """A firing order in lines of this width, px; all but the last end in a dash."""
    lines = [""]
    for number, cylinder in enumerate(order, 1):
        piece = f"{cylinder}-" if number < len(order) else str(cylinder)
        if lines[-1] and text_width(lines[-1] + piece, SMALL) > width:
            lines.append("")
        lines[-1] += piece
    return lines


class FrontPoints(NamedTuple):
    """The points of a front as they are drawn: values [point][column] in the units of the heads.

    `orders` and `neighbours` in succession are those of each point; `engine` is a line of text.
    """

    heads: tuple[Column, ...]
    values: tuple[tuple[float, ...], ...]
    orders: tuple[tuple[int, ...], ...]
    neighbours: tuple[int, ...]
    engine: str


def points_of(answer: Answer) -> FrontPoints:
    """Those of a search for stars."""
    heads, stars = columns(answer), answer.question.stars
    return FrontPoints(
        heads,
        tuple(values_of(row, heads) for row in answer.rows),
        tuple(firing_order(stars, row.star) for row in answer.rows),
        tuple(row.neighbours for row in answer.rows),
        engine_text(stars),
    )


def sequence_points(front: SequenceFront) -> FrontPoints:
    """Those of a search for stars and firing orders together."""
    shaft, goals = front.question.shaft, front.question.goals
    orders = tuple(shaft.firing_order(point.fired) for point in front.points)
    return FrontPoints(
        tuple(Column(goal.name, goal.unit, counted=goal.neighbours) for goal in goals),
        tuple(point.values for point in front.points),
        orders,
        tuple(len(followed(shaft, order).neighbours) for order in orders),
        shaft_text(shaft),
    )


def shaft_text(shaft: Shaft) -> str:
    """The engine of a shaft in a line."""
    kind = str(shaft.cylinders)
    if shaft.rods == 2:  # on each pin
        kind = f"V{shaft.cylinders}, {abs(float(shaft.bank_angle_deg)):g}°"
    return f"{kind}, {_(shaft.cycle)}"
