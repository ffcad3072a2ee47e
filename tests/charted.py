"""Figures as trees of Vega-Lite: their panels without the line on what the numbers rest on."""

from collections.abc import Iterator, Mapping
from typing import Any

import pytest

from crankstar.charts.canvas import Canvas, drawn_on
from crankstar.charts.resting import FOOT


@pytest.fixture
def bare_canvas() -> Iterator[None]:
    """Figures without what their numbers rest on, which takes longer to find than they to draw."""
    with drawn_on(Canvas(rests=False)):
        yield


def rows_drawn(spec: Mapping[str, Any]) -> list[dict[str, Any]]:
    """The panels of a figure from top to bottom, those side by side as one."""
    return [row for row in spec["vconcat"] if row.get("name") != FOOT]


def foot(spec: Mapping[str, Any]) -> list[str]:
    """The lines below the panels; none where the numbers rest on nothing assumed."""
    own = [row for row in spec["vconcat"] if row.get("name") == FOOT]
    return [line["text"] for row in own for line in row["layer"][0]["data"]["values"]]
