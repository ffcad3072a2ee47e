"""Distances of convex hulls from zero, against the exact corners and edges."""

from __future__ import annotations

from itertools import combinations

import numpy as np
from hypothesis import example, given
from hypothesis import strategies as st

from crankstar.tables.hulls import distances, greatest_sum

POINTS = st.lists(
    st.complex_numbers(max_magnitude=100, allow_nan=False, allow_infinity=False),
    min_size=1,
    max_size=12,
)


def exact(points: np.ndarray) -> float:
    """The greatest least component, along a point or across the line through two of them."""
    ways = [*points, *(sign * 1j * (a - b) for a, b in combinations(points, 2) for sign in (1, -1))]
    units = [way / abs(way) for way in ways if abs(way) > 1e-9]
    least = [float(np.min(np.real(np.conj(unit) * points))) for unit in units]
    return max(0.0, *least) if least else 0.0


@example([1j, 1 - 19j], 0j)  # two directions in which a coarse step finds as little
@given(POINTS, st.complex_numbers(max_magnitude=300, allow_nan=False, allow_infinity=False))
def test_the_distance_is_that_of_the_nearest_corner_or_edge(
    cloud: list[complex], aside: complex
) -> None:
    points = np.array(cloud) + aside
    found, largest = float(distances(points)), float(np.max(np.abs(points)))
    assert exact(points) - 2e-6 * largest <= found <= exact(points) + 1e-9 * (1 + largest)


@given(st.lists(POINTS, min_size=1, max_size=4))
def test_no_row_is_promised_more_than_its_parts_have(clouds: list[list[complex]]) -> None:
    size = min(map(len, clouds))
    rows = np.array([[cloud[:size]] for cloud in clouds])
    most = max(exact(row[0]) for row in rows)
    assert float(greatest_sum(rows)) <= most + 1e-9 * (1 + most)


def test_the_row_that_promises_most_is_taken() -> None:
    rows = np.array([[[3, 4], [1j, 2j]], [[5, 6], [0, 0]], [[1, 2], [2, 3]]], complex)
    assert float(greatest_sum(rows)) == 5.0
