"""The figures of a report, drawn in threads while its pages are written."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from concurrent.futures import Future, ThreadPoolExecutor
from contextlib import contextmanager
from contextvars import copy_context
from dataclasses import replace
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
PLACE = re.compile(r"<!--figure (\d+)-->")


class Gallery:
    """Figures of `CHARTS` in the making; pages hold places for them."""

    def __init__(self, subject: Subject, pool: ThreadPoolExecutor) -> None:
        self._matter, self._pool = subject, pool
        self._drawn: list[Future[str]] = []

    def figure(self, name: str, caption: str, kind: str = "", **options: Any) -> str:
        """The place of a figure with a caption, which stays empty if the figure cannot be drawn."""
        count = len(self._drawn)
        # a thread knows neither the units nor the language that were chosen
        run = copy_context().run
        self._drawn.append(
            self._pool.submit(run, self._figure, count, name, caption, kind, options)
        )
        # no other text can hold this, since every text is escaped
        return f"<!--figure {count}-->"

    def filled(self, page: str) -> str:
        """A page with its figures in their places."""
        return PLACE.sub(lambda place: self._drawn[int(place.group(1))].result(), page)

    def _figure(
        self, count: int, name: str, caption: str, kind: str, options: dict[str, Any]
    ) -> str:
        try:
            drawing = svg(self._chart(name, **options), f"{self._matter.engine.name}: {name}")
        except ChartError:
            return ""
        return figure(
            NAMED.sub(rf"\g<1>g{count}-", drawing.replace(GREY, "currentColor")), caption, kind
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


@contextmanager
def opened(subject: Subject) -> Iterator[Gallery]:
    """A gallery that draws in threads; figures not begun when it closes are not drawn."""
    pool = ThreadPoolExecutor(2)  # one draws while the other waits for its picture
    try:
        yield Gallery(subject, pool)
    finally:
        pool.shutdown(cancel_futures=True)
