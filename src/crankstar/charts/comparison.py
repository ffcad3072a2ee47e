"""Several engines side by side: panels of one kind on common axes."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

from crankstar.charts.curves import MOST_ORDERS, curve_panels, curves, curves_title
from crankstar.charts.drawing import (
    HALF,
    ChartError,
    Panel,
    checked_angle,
    figure,
    folded,
    named,
    stacked,
)
from crankstar.charts.grammar import Chart
from crankstar.charts.hodographs import MOST_TURNS, course, course_panel, course_title
from crankstar.charts.polygons import polygon_heading, polygon_panels, polygon_reach
from crankstar.charts.spectra import TITLE, bar_panels, side_bars
from crankstar.charts.stars import star_margin, star_panels, turns_of
from crankstar.charts.vectors import Stars, heading, stars
from crankstar.engine.engine import Engine
from crankstar.language.messages import _


class Compared(NamedTuple):
    """A block of panels for each engine, their title, and the `turns` of the slider."""

    blocks: list[Any]
    title: str
    turns: int


def side_by_side(
    engines: Sequence[Engine], kind: str, *, theta: float = 0.0, **options: Any
) -> Chart:
    """Several engines in one figure on common axes, two in a row, each under its name.

    `kind` is one of hodograph, over-turn, spectrum, vector-star and polygon; `options` are those of
    this figure. Raises ChartError, also where the engines are not counted in the same unit.
    """
    if kind not in KINDS:
        raise ChartError(
            _(
                "{chart} cannot be drawn side by side; give one of {charts}",
                chart=repr(kind),
                charts=", ".join(KINDS),
            )
        )
    if not engines:
        raise ChartError(_("no engine is given; name at least one"))
    theta = checked_angle(theta)
    compared = KINDS[kind](engines, theta, options)
    title = compared.title
    if options.get("speed") is None and len(engines) > 1:
        title = _("{title}, each in its own m, r and a", title=title)
    across = 2 if len(compared.blocks) > 1 else 1
    rows = [compared.blocks[i : i + across] for i in range(0, len(compared.blocks), across)]
    return figure(
        rows, title=title, theta=None if kind == "spectrum" else theta, turns=compared.turns
    )


def _same_unit(units: Sequence[str]) -> str:
    different = list(dict.fromkeys(units))
    if len(different) > 1:
        raise ChartError(
            _(
                "the engines have different units ({units}); omit the speed to compare them",
                units=", ".join(different),
            )
        )
    return different[0]


def _name(engine: Engine) -> str:
    return "\n".join(folded(named(engine), 30))


def _hodographs(engines: Sequence[Engine], theta: float, options: dict[str, Any]) -> Compared:
    courses = [course(engine, **options) for engine in engines]
    _same_unit([one.unit for one in courses])
    reach = max(one.reach for one in courses)
    blocks = [
        course_panel(one, reach=reach, theta=theta, width=HALF - 10, title=_name(engine))
        for one, engine in zip(courses, engines, strict=True)
    ]
    return Compared(
        blocks, course_title(courses[0]), min(max(one.turns for one in courses), MOST_TURNS)
    )


def _curves(engines: Sequence[Engine], _theta: float, options: dict[str, Any]) -> Compared:
    wholes = [curves(engine, **options) for engine in engines]
    _same_unit([one.unit for one in wholes])
    reach, turns = max(one.reach for one in wholes), max(one.turns for one in wholes)
    shown = sorted({order for one in wholes for order in one.shown})[: 2 * MOST_ORDERS]
    blocks = []
    for one, engine in zip(wholes, engines, strict=True):
        panels = curve_panels(one, reach, shown, turns=turns, width=HALF - 30, title=_name(engine))
        blocks.append(stacked(panels) if len(panels) > 1 else panels[0])
    return Compared(blocks, curves_title(wholes[0]), turns)


def _spectra(engines: Sequence[Engine], _theta: float, options: dict[str, Any]) -> Compared:
    spectra = side_bars(engines, **options)
    for column in zip(*spectra, strict=True):
        _same_unit([one.unit for one in column])
    orders = sorted({order for engine in spectra for one in engine for order in one.orders})
    reaches = [max(one.reach for one in column) for column in zip(*spectra, strict=True)]
    blocks = []
    for one, engine in zip(spectra, engines, strict=True):
        panels = bar_panels(
            one, orders=orders, reaches=reaches, width=HALF - 30, title=_name(engine)
        )
        blocks.append(stacked([panel[0] for panel in panels]))
    return Compared(blocks, _(TITLE), 1)


def _stars(engines: Sequence[Engine], theta: float, options: dict[str, Any]) -> Compared:
    systems = _same_stars(engines, options)
    reach = max(one.reach for one in systems)
    margin = max(star_margin(one) for one in systems)
    blocks = [
        _block(star_panels(one, reach=reach, theta=theta, width=HALF, margin=margin), one)
        for one in systems
    ]
    return Compared(blocks, heading(systems[0]), turns_of(systems[0].order))


def _polygons(engines: Sequence[Engine], theta: float, options: dict[str, Any]) -> Compared:
    systems = _same_stars(engines, options)
    reach = max(polygon_reach(one) for one in systems)
    blocks = [
        _block(polygon_panels(one, reach=reach, theta=theta, width=HALF), one) for one in systems
    ]
    return Compared(blocks, polygon_heading(systems[0]), turns_of(systems[0].order))


def _same_stars(engines: Sequence[Engine], options: dict[str, Any]) -> list[Stars]:
    systems = [stars(engine, **options) for engine in engines]
    _same_unit([one.unit for one in systems])
    return systems


def _block(panels: list[Any], one: Stars) -> Panel:
    """The panels of an engine below each other under its name."""
    return stacked(panels, title="\n".join(folded(one.name, 30)))


KINDS: dict[str, Callable[[Sequence[Engine], float, dict[str, Any]], Compared]] = {
    "hodograph": _hodographs,
    "over-turn": _curves,
    "spectrum": _spectra,
    "vector-star": _stars,
    "polygon": _polygons,
}
"""The figures that can be drawn side by side."""
