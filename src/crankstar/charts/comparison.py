"""A figure of one engine, or of several side by side on common axes, each under its name."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from crankstar.charts.canvas import abreast, half_width
from crankstar.charts.drawing import ChartError, Panel, figure, heading, named, stacked
from crankstar.charts.estimates import estimate_lines
from crankstar.charts.grammar import Chart
from crankstar.charts.letters import folded
from crankstar.charts.resting import Rests
from crankstar.engine.engine import Engine
from crankstar.language.messages import _
from crankstar.language.numbers import unit_text
from crankstar.tables.compared_speeds import speed_head


def compared(
    engines: Sequence[Engine],
    blocks: Sequence[Sequence[Sequence[Panel]]],
    *,
    title: str,
    speed: float | None,
    theta: float | None = None,
    turns: int = 1,
    ranges: str = "",
    notes: Sequence[str] = (),
    rests: Rests | None = None,
) -> Chart:
    """The panels of each engine, in rows; several engines stand two in a row, each in a column.

    Where the canvas has the first `alone`, the others have only had their part in the scales.

    `ranges` says how the ranges of estimated engines are drawn, `notes` what else is to be known of
    the picture, `rests` what the numbers rest on.
    """
    engines = engines[: abreast(len(engines))]
    lines = [*notes, *estimate_lines(engines, drawn=ranges)]
    if len(engines) == 1:
        subtitle = [*heading(engines[0], speed=speed), *lines]
        return figure(
            blocks[0], title=title, subtitle=subtitle, theta=theta, turns=turns, rests=rests
        )
    width = half_width()
    columns = [
        stacked([panel for row in block for panel in row], title=folded(named(engine), width=width))
        for engine, block in zip(engines, blocks, strict=True)
    ]
    if speed is None:
        title = _("{title}, each in its own m, r and a", title=title)
        lines.append(
            _("Engines whose m, r, a or speed differ cannot be compared by the lengths drawn.")
        )
    rows = [columns[i : i + 2] for i in range(0, len(columns), 2)]
    names = [named(engine) for engine in engines]
    lines = [*filter(None, [head_of(engines, names, speed)]), *lines]
    return figure(rows, title=title, subtitle=lines, theta=theta, turns=turns, rests=rests)


def head_of(engines: Sequence[Engine], names: Sequence[str], speed: float | None) -> str:
    """At which speed (rad/s) the forces of engines are and why; empty without it, or masses."""
    if speed is None or any({"mass", "radius"} & {*engine.relative} for engine in engines):
        return ""
    return speed_head(engines, names, [speed] * len(engines))


def same_unit(units: Iterable[str]) -> str:
    """The unit that all engines share; raises ChartError where they differ."""
    different = list(dict.fromkeys(units))
    if len(different) > 1:
        raise ChartError(
            _(
                "the engines have different units ({units}); omit the speed to compare them",
                units=", ".join(map(unit_text, different)),
            )
        )
    return different[0]
