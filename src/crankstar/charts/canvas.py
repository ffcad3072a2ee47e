"""The room for a figure: how wide its panels are, and how tall the panels of curves."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal

if TYPE_CHECKING:
    from crankstar.engine.engine import Engine

USUAL_WIDTH = 330.0
BETWEEN, BESIDE = 18.0, 68.0
"""px between two panels in a row; px of the axes beside a panel."""


@dataclass(frozen=True)
class Canvas:
    """The width of a panel that stands alone, px; the height of curves in their usual height.

    `named` is whether the titles name the engine, which on a page of its own goes without saying.
    `alone`: of several engines the first is drawn, to the scale of all, each at its own speed.
    `rests` is whether a figure says what its numbers rest on, which a page lists beside them;
    `foot` is the room for it below the panels: all, the line that names who lists it, or none.
    """

    width: float = USUAL_WIDTH
    stretch: float = 1.0
    named: bool = True
    alone: bool = False
    rests: bool = True
    foot: Literal["all", "name", ""] = "all"


_USUAL = Canvas()
_CANVAS: ContextVar[Canvas] = ContextVar("canvas", default=_USUAL)


@contextmanager
def drawn_on(canvas: Canvas) -> Iterator[None]:
    """Within it, figures have this room."""
    token = _CANVAS.set(canvas)
    try:
        yield
    finally:
        _CANVAS.reset(token)


def panel_width() -> float:
    """Of the plotting area of a panel that stands alone, px."""
    return _CANVAS.get().width


def figure_width() -> float:
    """Of a figure with its axes, px.

    >>> figure_width()
    398.0
    """
    return panel_width() + BESIDE


def half_width() -> float:
    """Of a panel that has another one beside it, px."""
    return (figure_width() - BETWEEN) / 2


def curve_height(usual: float) -> float:
    """Of a panel of curves or bars, whose scales may differ, px."""
    return usual * _CANVAS.get().stretch


def names_engine() -> bool:
    """Whether titles name the engine."""
    return _CANVAS.get().named


def shows_rests() -> bool:
    """Whether figures say what their numbers rest on."""
    return _CANVAS.get().rests


def foot_room() -> str:
    """The room below the panels for what the numbers rest on."""
    return _CANVAS.get().foot


def abreast(engines: int) -> int:
    """Of these engines those that stand side by side in a figure."""
    return 1 if _CANVAS.get().alone else engines


def speed_of(engine: Engine, speed: float | None) -> float | None:
    """The speed at which an engine of a figure at this `speed` turns, rad/s."""
    return engine.speed if _CANVAS.get().alone else speed


def relative_width() -> float:
    """Of panels, in their usual width."""
    return panel_width() / USUAL_WIDTH
