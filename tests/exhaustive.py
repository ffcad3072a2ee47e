"""The search by brute force: every permutation, its sums added one by one.

Shares no code with the package.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Sequence
from fractions import Fraction
from functools import lru_cache

import numpy as np

NEAR = 1e-7


@lru_cache(maxsize=16)
def stars(directions: int, each: int) -> np.ndarray:
    """All ways to give each direction to `each` cylinders, cylinder 1 in direction 0.

    [stars, cylinders].
    """
    found = [((0,), tuple(each - (d == 0) for d in range(directions)))]
    for _ in range(directions * each - 1):
        found = [
            ((*row, d), (*left[:d], left[d] - 1, *left[d + 1 :]))
            for row, left in found
            for d in range(directions)
            if left[d]
        ]
    return np.array([row for row, _ in found])


def arms(cylinders: int) -> np.ndarray:
    """Distances from the middle at equal pitch, from the front."""
    return (cylinders - 1) / 2 - np.arange(cylinders)


def lengths(
    rows: np.ndarray, weights: Sequence[float] | np.ndarray, order: float, directions: int
) -> np.ndarray:
    """|sum of w_j exp(2 pi i order d_j/n)| of each star."""
    angles = 2 * np.pi * order * rows / directions
    return np.hypot(
        (np.cos(angles) * np.asarray(weights)).sum(axis=1),
        (np.sin(angles) * np.asarray(weights)).sum(axis=1),
    )


def front(*columns: np.ndarray) -> dict[tuple[float, ...], int]:
    """Values that nothing betters, rounded to 1e-6, and how many stars have them."""
    every = np.column_stack(columns)
    _, first, many = np.unique(np.round(every, 9), axis=0, return_index=True, return_counts=True)
    values = every[first]
    counts: dict[tuple[float, ...], int] = defaultdict(int)
    for row, number in zip(values, many, strict=True):
        better = (values <= row + NEAR).all(axis=1) & (values < row - NEAR).any(axis=1)
        if not better.any():
            counts[tuple(float(x) + 0.0 for x in np.round(row, 6))] += int(number)
    return dict(counts)


def image_class(star: Sequence[int], directions: int, *, ends: bool) -> tuple[int, ...]:
    """The least of a star's equivalents: mirrored, turned and, if `ends`, taken from the rear."""
    ways = [tuple(star), tuple(star)[::-1]] if ends else [tuple(star)]
    return min(
        tuple((sign * (d - row[0])) % directions for d in row) for row in ways for sign in (1, -1)
    )


def classes(rows: np.ndarray, directions: int, *, ends: bool) -> int:
    return len({image_class(row, directions, ends=ends) for row in rows.tolist()})


def neighbours(star: Sequence[int], *, directions: int, step: int) -> int:
    """Neighbours that fire one after the other; step 0: two to a direction, best of all orders."""
    if step:
        seat = {d: j for j, d in enumerate(star)}
        return sum(abs(seat[d] - seat[(d + step) % directions]) == 1 for d in range(directions))
    pairs = [[j for j, d in enumerate(star) if d == direction] for direction in range(directions)]
    best = len(star)
    for choice in range(2**directions):
        first = [pair[choice >> d & 1] for d, pair in enumerate(pairs)]
        second = [pair[1 - (choice >> d & 1)] for d, pair in enumerate(pairs)]
        order = [*first, *second]
        best = min(
            best, sum(abs(a - b) == 1 for a, b in zip(order, [*order[1:], order[0]], strict=True))
        )
    return best


def halves(cylinders: int) -> tuple[Fraction, ...]:
    """The same distances as fractions."""
    return tuple(Fraction(cylinders - 1, 2) - j for j in range(cylinders))
