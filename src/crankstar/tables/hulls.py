"""How far the convex hulls of points in the plane are from zero.

The distance is the greatest, over directions, of the least component of a point. So each direction
tried gives a distance that is not too large: it is tried in finer and finer steps.
"""

from __future__ import annotations

import numpy as np

from crankstar.spectra import Complex, Real

FIRST, AFTER = 32, 8
"""Directions tried all around, and to either side of the best one in each later round."""
ROUNDS = 6
"""Later rounds; the last steps by 2 pi / 32 / 8**6, 7.5e-7 rad."""


def distances(points: Complex, *, rounds: int = ROUNDS) -> Real:
    """The distance of zero from the hull of the last axis of `points` [..., n], 0 within it.

    >>> distances(np.array([[1 + 1j, 1 - 1j, 3], [1 + 1j, 1 - 1j, -3]])).round(6).tolist()
    [1.0, 0.0]
    """
    middle, step = np.angle(points.mean(axis=-1)), 2 * np.pi / FIRST
    best = _least(points, middle)
    turns = np.arange(FIRST)
    for _round in range(rounds + 1):
        ways = middle[..., None] + step * turns
        least = np.stack([_least(points, ways[..., place]) for place in range(turns.size)], axis=-1)
        at = np.argmax(least, axis=-1)[..., None]
        middle = np.take_along_axis(ways, at, axis=-1)[..., 0]
        best = np.maximum(best, np.take_along_axis(least, at, axis=-1)[..., 0])
        turns, step = np.arange(-AFTER, AFTER + 1), step / AFTER
    return np.maximum(best, 0.0)


def _least(points: Complex, ways: Real) -> Real:
    """The least component [...] of points [..., n] along directions [...]."""
    along = np.real(points) * np.cos(ways)[..., None] + np.imag(points) * np.sin(ways)[..., None]
    return along.min(axis=-1)


def greatest_sum(points: Complex) -> Real:
    """The distances of the parts of a row added up, of the row where they are greatest.

    `points` [..., row, part, n] give [...]. A first round chooses the row.

    >>> greatest_sum(np.array([[[3, 4], [1j, 2j]], [[5, 6], [0, 0]]])).round(6).tolist()
    5.0
    """
    rows = distances(points, rounds=0).sum(axis=-1)
    at = np.argmax(rows, axis=-1)[..., None, None, None]
    return distances(np.take_along_axis(points, at, axis=-3)[..., 0, :, :]).sum(axis=-1)
