"""A figure at a stated size on paper: laid out for its letters, so that they keep their size.

A figure is laid out in px with letters of `SMALL` px and more. On paper the smallest letters have
the stated size s, so a px is s / SMALL; the panels are as wide as the stated width then leaves
room for. What a figure with equal scales leaves of the stated height stays empty.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass, replace

from crankstar.charts.canvas import Canvas, drawn_on
from crankstar.charts.drawing import HALO, ChartError, svg
from crankstar.charts.grammar import Chart
from crankstar.charts.letters import SMALL
from crankstar.charts.resting import known_once
from crankstar.charts.themes import THEMES, ThemeName, themed
from crankstar.language.messages import _
from crankstar.language.numbers import number

POINT = 0.0254 / 72
"""A typographic point, m."""
LEAST_LETTERS, USUAL_LETTERS = 8.0, 9.0
"""Sizes of letters, pt: the least that is legible in print, and the usual size of the smallest."""
NARROWEST, SHORTEST = 150.0, 0.4
"""The least width of a panel, px, and the least height of curves in their usual height."""
TRIES = 9
SIZE = re.compile(r'width="([\d.]+)" height="([\d.]+)" viewBox="0 0 [\d.]+ [\d.]+"')


@dataclass(frozen=True)
class Paper:
    """Theme, width and height (m; None is what the figure needs), dots per inch, letters in pt."""

    theme: ThemeName = "light"
    width: float | None = None
    height: float | None = None
    dpi: float = 192.0
    font_size: float = USUAL_LETTERS

    @property
    def px(self) -> float:
        """The length of a px of the layout, m."""
        return self.font_size / SMALL * POINT


@dataclass(frozen=True)
class Print:
    """A figure for paper: its chart, its drawing as SVG in the layout's px, and its size in px."""

    chart: Chart
    drawing: str
    size: tuple[float, float]
    paper: Paper

    def scaled(self, unit: str) -> str:
        """The drawing at its size in `pt`, `px` (of 1/96 in) or `mm`."""
        length = {"pt": POINT, "px": 0.0254 / 96, "mm": 1e-3}[unit]
        scale = self.paper.px / length
        wide, high = (f"{side * scale:.6g}{'mm' * (unit == 'mm')}" for side in self.size)
        inner = SIZE.search(self.drawing)
        drawn = [float(side) for side in inner.groups()] if inner else list(self.size)
        left, top = ((drawn[at] - self.size[at]) / 2 for at in (0, 1))
        view = f"{left:.6g} {top:.6g} {self.size[0]:.6g} {self.size[1]:.6g}"
        ground = THEMES[self.paper.theme].ground
        whole = f'<rect x="{left:.6g}" y="{top:.6g}" width="100%" height="100%" fill="{ground}"/>'
        head = f'width="{wide}" height="{high}" viewBox="{view}"'
        return SIZE.sub(head, self.drawing, count=1).replace("</title>", f"</title>{whole}", 1)


def printed(draw: Callable[[], Chart], paper: Paper, *, title: str) -> Print:
    """A figure laid out for a paper; `draw` draws it in the room that it is given.

    Raises ChartError where letters are too small to be read, or the paper is too small for them.
    """
    if not paper.font_size >= LEAST_LETTERS:
        raise ChartError(
            _(
                "letters of {size} pt cannot be read in print; give {least} pt or more",
                size=number(paper.font_size),
                least=number(LEAST_LETTERS),
            )
        )
    room = tuple(None if side is None else side / paper.px for side in (paper.width, paper.height))

    def made(canvas: Canvas) -> tuple[Chart, str]:
        with drawn_on(canvas):
            chart = themed(draw(), paper.theme)
        return chart, svg(chart, title).replace(HALO, THEMES[paper.theme].ground)

    sizes: list[tuple[float, float]] = []
    with known_once():
        for canvas in (Canvas(), Canvas(foot="name"), Canvas(foot="")):
            best, tried = _largest(made, canvas, room)
            sizes += tried
            if best is not None:
                chart, drawing = best
                own = zip(_size(drawing), room, strict=True)
                wide, high = (size if side is None else side for size, side in own)
                return Print(chart, drawing, (wide, high), paper)
    raise _too_small(paper, min(sizes, key=lambda size: _excess(size, room)))


def _largest(
    made: Callable[[Canvas], tuple[Chart, str]], canvas: Canvas, room: tuple[float | None, ...]
) -> tuple[tuple[Chart, str] | None, list[tuple[float, float]]]:
    """The largest drawing that fits into the room, from a canvas on; and the sizes of all."""
    best: tuple[Chart, str] | None = None
    sizes: list[tuple[float, float]] = []
    for _try in range(TRIES if any(room) else 1):
        chart, drawing = made(canvas)
        sizes.append(_size(drawing))
        if _fits(sizes[-1], room) and (best is None or sizes[-1] > _size(best[1])):
            best = chart, drawing
        following = _following(canvas, sizes[-1], room)
        if following == canvas:
            break
        canvas = following
    return best, sizes


def _size(drawing: str) -> tuple[float, float]:
    """The width and height of a drawing, px."""
    match = SIZE.search(drawing)
    if match is None:
        raise ValueError("a drawing without its size")
    return float(match[1]), float(match[2])


def _excess(size: tuple[float, float], room: tuple[float | None, ...]) -> float:
    """How much larger than the room a figure is, on its worse side."""
    return max(own / side for own, side in zip(size, room, strict=True) if side is not None)


def _fits(size: tuple[float, float], room: tuple[float | None, ...]) -> bool:
    return all(side is None or own <= side + 0.5 for own, side in zip(size, room, strict=True))


def _following(canvas: Canvas, size: tuple[float, float], room: tuple[float | None, ...]) -> Canvas:
    """The next room to try: as much wider or narrower as the figure differs from the paper."""
    wide, high = room
    width, stretch = canvas.width, canvas.stretch
    if wide is not None:
        around = size[0] - canvas.width if size[0] < 1.6 * canvas.width else 0.0
        width = wide - around if around > 0 else canvas.width * wide / size[0]
    if high is not None:
        stretch = canvas.stretch * high / size[1]
        if stretch < SHORTEST or (canvas.stretch != 1.0 and size[1] > high):
            width = min(width, canvas.width - 1.01 * (size[1] - high))
    width = max(NARROWEST, 0.998 * width)
    stretch = round(min(max(stretch, SHORTEST), 6.0), 3)
    return replace(canvas, width=round(width, 1), stretch=stretch)


def _too_small(paper: Paper, size: tuple[float, float]) -> ChartError:
    wide, high = (f"{1000 * side * paper.px:.0f} mm" for side in size)
    return ChartError(
        _(
            "the chart does not fit on this size with letters of {letters} pt; it needs {width} by "
            "{height}, or smaller letters (at least {least} pt)",
            letters=number(paper.font_size),
            width=wide,
            height=high,
            least=number(LEAST_LETTERS),
        )
    )
