"""How far the convex hulls of points in the plane are from zero.

The distance is the greatest, over directions, of the least component of a point. So each direction
tried gives a distance that is not too large. Where zero is outside, the points lie in an arc of
less than half a turn as seen from it, and a direction in which all of them have a component is
less than a quarter turn from both its ends: there each component is concave, and so is the least of
them, which is brought in between two directions in finer and finer steps.
"""

from __future__ import annotations

import numpy as np

from crankstar.spectra import Complex, Real

TRIED = 17
"""Directions tried in each round, both ends of what is left included."""
ROUNDS = 7
"""Later rounds; the last steps by pi / 16 / 8**7, 9.4e-8 rad."""


def distances(points: Complex, *, rounds: int = ROUNDS) -> Real:
    """The distance of zero from the hull of the last axis of `points` [..., n], 0 within it.

    >>> distances(np.array([[1 + 1j, 1 - 1j, 3], [1 + 1j, 1 - 1j, -3]])).round(6).tolist()
    [1.0, 0.0]
    """
    angles = np.sort(np.angle(points), axis=-1)
    gaps = np.diff(angles, axis=-1, append=angles[..., :1] + 2 * np.pi)
    last = np.argmax(gaps, axis=-1)[..., None]
    end = np.take_along_axis(angles, last, axis=-1)[..., 0]
    room = np.maximum(np.take_along_axis(gaps, last, axis=-1)[..., 0] - np.pi, 0.0)
    low = end - np.pi / 2  # the arc ends there, and begins a turn less the gap before
    best = np.zeros(end.shape)
    for _round in range(rounds + 1):
        step = room / (TRIED - 1)
        ways = low[..., None] + step[..., None] * np.arange(TRIED)
        least = np.stack([_least(points, ways[..., index]) for index in range(TRIED)], axis=-1)
        at = np.argmax(least, axis=-1)
        best = np.maximum(best, np.take_along_axis(least, at[..., None], axis=-1)[..., 0])
        low, room = low + step * (np.clip(at, 1, TRIED - 2) - 1), 2 * step
    return best


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
