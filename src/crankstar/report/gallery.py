"""The figures of a report, drawn while its words are being written."""

from __future__ import annotations

import re
from collections.abc import Iterator
from concurrent.futures import Future, ThreadPoolExecutor
from contextlib import contextmanager
from typing import Any

from crankstar.charts import CHARTS, GREY, ChartError, side_by_side, svg, swiftly
from crankstar.report.markup import figure
from crankstar.report.matter import Matter

NAMED = re.compile(r'(\bid="|url\(#|href="#)')
"""Where a drawing names a part of its own; no two drawings on one page may name theirs alike."""
PLACE = re.compile(r"<!--figure (\d+)-->")


class Gallery:
    """Figures of `CHARTS` that are being drawn; pages hold places for them until they are hung."""

    def __init__(self, matter: Matter, pool: ThreadPoolExecutor) -> None:
        self._matter, self._pool = matter, pool
        self._drawn: list[Future[str]] = []

    def figure(self, name: str, caption: str, kind: str = "", **options: Any) -> str:
        """The place of a figure with a line under it; it stays empty where the engine has nothing of the kind."""
        count = len(self._drawn)
        self._drawn.append(self._pool.submit(self._figure, count, name, caption, kind, options))
        return f"<!--figure {count}-->"  # no text of an engine can hold this, since every text is escaped

    def hung(self, page: str) -> str:
        """A page with its figures in their places."""
        return PLACE.sub(lambda found: self._drawn[int(found.group(1))].result(), page)

    def _figure(self, count: int, name: str, caption: str, kind: str, options: dict[str, Any]) -> str:
        try:
            drawing = svg(self._chart(name, options), f"{self._matter.engine.name}: {name}")
        except ChartError:
            return ""
        return figure(NAMED.sub(rf"\g<1>g{count}-", drawing.replace(GREY, "currentColor")), caption, kind)

    def _chart(self, name: str, options: dict[str, Any]) -> Any:
        if "beside" in options:
            engines = [self._matter.engine, options["beside"]]
            return side_by_side(engines, name, **{key: value for key, value in options.items() if key != "beside"})
        return CHARTS[name].draw(self._matter.engine, **options)


@contextmanager
def opened(matter: Matter) -> Iterator[Gallery]:
    """A gallery in which drawing goes on beside other work; what is not yet begun when it closes is not drawn."""
    pool = ThreadPoolExecutor(2)  # one draws while the other waits for its picture
    with swiftly():
        try:
            yield Gallery(matter, pool)
        finally:
            pool.shutdown(cancel_futures=True)
