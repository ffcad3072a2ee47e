"""Labels of figures: which lines run through them, by points along the lines."""

from __future__ import annotations

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from crankstar.charts.labels import Box, crossed

PLACES = st.builds(complex, st.integers(-40, 40), st.integers(-40, 40))
BOXES = st.builds(Box, PLACES, st.integers(2, 30).map(float), st.integers(2, 20).map(float))
POINTS = np.linspace(0.0, 1.0, 2001)
EDGE = 0.1
"""px: how near the edge of a label a line may run and be taken either way."""


@given(st.lists(BOXES, min_size=1, max_size=4), st.lists(st.tuples(PLACES, PLACES), min_size=1))
def test_a_line_runs_through_a_label_where_one_of_its_points_is_inside(
    boxes: list[Box], lines: list[tuple[complex, complex]]
) -> None:
    found = crossed(boxes, np.array(lines))
    for row, box in enumerate(boxes):
        for place, (start, end) in enumerate(lines):
            off = start + (end - start) * POINTS - box.middle
            beyond = np.maximum(np.abs(off.imag) - box.across, np.abs(off.real) - 0.8 * box.upright)
            nearest = float(beyond.min())
            if abs(nearest) > EDGE:
                assert found[row, place] == (nearest < 0)
