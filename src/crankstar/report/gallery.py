"""The figures of a report, each drawn as its page asks for it.

vl-convert draws one picture at a time and holds Python meanwhile: threads would win nothing.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace
from itertools import count
from typing import Any

from crankstar.charts import CHARTS, GREY, ChartError, over_ranges, side_by_side, svg
from crankstar.charts.canvas import Canvas, drawn_on
from crankstar.charts.grammar import Chart
from crankstar.engine.engine import Engine
from crankstar.files.box import Spread
from crankstar.report.markup import figure
from crankstar.report.subject import Subject

NAMED = re.compile(r'(\bid="|url\(#|href="#)')
"""The names of parts in a drawing, which must differ from those of other drawings on the page."""
COLUMN = Canvas(width=244.0, stretch=0.75)
"""A figure is as wide as half a page of A4, where its letters have 9 pt."""


class Gallery:
    """Figures of `CHARTS` for a report."""

    def __init__(self, subject: Subject) -> None:
        self._matter, self._numbers = subject, count()

    def figure(self, name: str, caption: str, kind: str = "", **options: Any) -> str:
        """A figure with a caption as HTML; empty if the figure cannot be drawn."""
        own = f"g{next(self._numbers)}-"
        try:
            drawing = svg(self._chart(name, **options), f"{self._matter.engine.name}: {name}")
        except ChartError:
            return ""
        return figure(
            NAMED.sub(rf"\g<1>{own}", drawing.replace(GREY, "currentColor")), caption, kind
        )

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
        canvas = replace(canvas, named=beside is not None)
        with drawn_on(canvas), over_ranges([*self._matter.spreads, *spreads]):
            if beside is not None:
                return side_by_side([engine, beside], name, **options)
            return CHARTS[name].draw(engine, **options)
