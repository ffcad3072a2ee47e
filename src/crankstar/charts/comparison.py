"""Several engines side by side: panels of one kind on common axes."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

from crankstar.charts.drawing import HALF, ChartError, Panel, checked_angle, figure, folded, named, stacked
from crankstar.charts.hodographs import MOST_TURNS, course, course_panel, course_title
from crankstar.charts.polygons import polygon_panels, polygon_reach
from crankstar.charts.spectra import bar_panels, side_bars
from crankstar.charts.stars import star_margin, star_panels, turns_of
from crankstar.charts.turns import MOST_ORDERS, curve_panels, curves
from crankstar.charts.vectors import Stars, heading, stars
from crankstar.engine import Engine

if TYPE_CHECKING:
    import altair


class Compared(NamedTuple):
    """Blocks of panels, one block for each engine, under one title; `turns` of the slider."""

    blocks: list[Any]
    title: str
    turns: int


def side_by_side(engines: Sequence[Engine], kind: str, *, theta: float = 0.0, **options: Any) -> altair.VConcatChart:
    """Several engines in one figure on common axes, two in a row, each under its name.

    `kind` is one of hodograph, over-turn, spectrum, vector-star and polygon; `options` are those of this figure. Raises
    ChartError, also where the engines are not counted in the same unit.
    """
    if kind not in KINDS:
        raise ChartError(f"{kind!r} cannot be drawn side by side; give one of {', '.join(KINDS)}")
    if not engines:
        raise ChartError("no engine is given; name at least one")
    theta = checked_angle(theta)
    found = KINDS[kind](engines, theta, options)
    title = found.title if options.get("speed") is not None or len(engines) < 2 else f"{found.title}, each in its own m, r and a"
    across = 2 if len(found.blocks) > 1 else 1
    rows = [found.blocks[i : i + across] for i in range(0, len(found.blocks), across)]
    return figure(rows, title=title, theta=None if kind == "spectrum" else theta, turns=found.turns)


def _same_unit(units: Sequence[str]) -> str:
    different = list(dict.fromkeys(units))
    if len(different) > 1:
        raise ChartError(
            f"the engines are counted in different units ({', '.join(different)}); leave the speed out to compare them"
        )
    return different[0]


def _name(engine: Engine) -> str:
    return "\n".join(folded(named(engine), 30))


def _hodographs(engines: Sequence[Engine], theta: float, options: dict[str, Any]) -> Compared:
    found = [course(engine, **options) for engine in engines]
    _same_unit([one.unit for one in found])
    reach = max(one.reach for one in found)
    blocks = [
        course_panel(one, reach=reach, theta=theta, width=HALF - 10, title=_name(engine))
        for one, engine in zip(found, engines, strict=True)
    ]
    return Compared(blocks, course_title(found[0]), min(max(one.turns for one in found), MOST_TURNS))


def _curves(engines: Sequence[Engine], _theta: float, options: dict[str, Any]) -> Compared:
    found = [curves(engine, **options) for engine in engines]
    unit = _same_unit([one.unit for one in found])
    reach, turns = max(one.reach for one in found), max(one.turns for one in found)
    shown = sorted({order for one in found for order in one.shown})[: 2 * MOST_ORDERS]
    blocks = []
    for one, engine in zip(found, engines, strict=True):
        panels = curve_panels(one, reach, shown, turns=turns, width=HALF - 30, title=_name(engine))
        blocks.append(stacked(panels) if len(panels) > 1 else panels[0])
    return Compared(blocks, f"{found[0].quantity.capitalize()} over the crank angle, in {unit}", turns)


def _spectra(engines: Sequence[Engine], _theta: float, options: dict[str, Any]) -> Compared:
    found = side_bars(engines, **options)
    for column in zip(*found, strict=True):
        _same_unit([one.unit for one in column])
    orders = sorted({order for engine in found for one in engine for order in one.orders})
    reaches = [max(one.reach for one in column) for column in zip(*found, strict=True)]
    blocks = []
    for one, engine in zip(found, engines, strict=True):
        panels = bar_panels(one, orders=orders, reaches=reaches, width=HALF - 30, title=_name(engine))
        blocks.append(stacked([panel[0] for panel in panels]))
    return Compared(blocks, "Greatest force, couple and roll of the block by order", 1)


def _stars(engines: Sequence[Engine], theta: float, options: dict[str, Any]) -> Compared:
    found = _same_stars(engines, options)
    reach = max(one.reach for one in found)
    margin = max(star_margin(one) for one in found)
    blocks = [_block(star_panels(one, reach=reach, theta=theta, width=HALF, margin=margin), one) for one in found]
    return Compared(blocks, heading(found[0]), turns_of(found[0].order))


def _polygons(engines: Sequence[Engine], theta: float, options: dict[str, Any]) -> Compared:
    found = _same_stars(engines, options)
    reach = max(polygon_reach(one) for one in found)
    blocks = [_block(polygon_panels(one, reach=reach, theta=theta, width=HALF), one) for one in found]
    return Compared(blocks, heading(found[0], "polygon"), turns_of(found[0].order))


def _same_stars(engines: Sequence[Engine], options: dict[str, Any]) -> list[Stars]:
    found = [stars(engine, **options) for engine in engines]
    _same_unit([one.unit for one in found])
    return found


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
"""What can be drawn side by side."""
