"""The figures of a report: composed as its pages ask for them, drawn meanwhile, put in last."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import partial
from itertools import count
from typing import Any

from crankstar.charts import GREY, ChartError, draw, over_ranges, side_by_side
from crankstar.charts.canvas import Canvas, drawn_on
from crankstar.charts.drawing import svg_later
from crankstar.charts.grammar import Chart
from crankstar.engine.engine import Engine
from crankstar.files.box import Spread
from crankstar.report.markup import figure
from crankstar.report.subject import Subject

NAMED = re.compile(r'(\bid="|url\(#|href="#)')
"""The names of parts in a drawing, which must differ from those of other drawings on the page."""
PLACE, PLACES = "\ue001{}\ue001", re.compile("\ue001(\\d+)\ue001")
"""Stands for a drawing on a page."""
COLUMN = Canvas(width=244.0, stretch=0.75)
"""A figure is as wide as half a page of A4, where its letters have 9 pt."""
ACROSS = Canvas(width=610.0)
"""For figures of the whole width, on paper at their own size."""


class Gallery:
    """Figures of `crankstar.charts.CHARTS` for a report."""

    def __init__(self, subject: Subject) -> None:
        self._matter, self._numbers = subject, count()
        self._drawings: dict[str, Callable[[], str]] = {}

    def figure(self, name: str, caption: str, kind: str = "", **options: Any) -> str:
        """A figure with a caption as HTML, its drawing still to come; empty without any."""
        return self.drawn(name, caption, partial(self._chart, name, **options), kind)

    def drawn(self, name: str, caption: str, draw: Callable[[], Chart], kind: str = "") -> str:
        """The same of a figure that `draw` gives, on a canvas of its own."""
        own = str(next(self._numbers))
        try:
            chart = draw()
        except ChartError:
            return ""
        self._drawings[own] = svg_later(chart, f"{self._matter.engine.name}: {name}")
        return figure(PLACE.format(own), caption, kind)

    def filled(self, page: str) -> str:
        """The page with the drawings of its figures."""
        return PLACES.sub(lambda match: self._drawing(match[1]), page)

    def _drawing(self, number: str) -> str:
        drawing = self._drawings[number]().replace(GREY, "currentColor")
        return NAMED.sub(rf"\g<1>g{number}-", drawing)

    def _chart(
        self,
        name: str,
        *,
        beside: Engine | None = None,
        of: Engine | None = None,
        canvas: Canvas = COLUMN,
        spreads: Sequence[Spread | None] = (),
        **options: Any,
    ) -> Chart:
        """A figure of the engine, or `of` another one, alone or `beside` one more."""
        engine = of or self._matter.engine
        canvas = replace(canvas, named=beside is not None, rests=False)
        with drawn_on(canvas), over_ranges([*self._matter.spreads, *spreads]):
            if beside is not None:
                return side_by_side([engine, beside], name, **options)
            return draw(name, engine, **options)
