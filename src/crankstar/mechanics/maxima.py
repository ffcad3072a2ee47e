"""Where curves have their maxima, and where they cross a limit: points between those of a grid."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple, TypeVar

import numpy as np

from crankstar.spectra import Real

NEAR = 0.9
"""Share of a curve's highest sample from which a local maximum may be the highest of all."""
NEAR_LIMIT = 0.9
"""Share of a limit from which a local maximum may pass it."""
FLAT = 1e-6
"""A maximum is found once its neighbours are below it by no more than this share."""
SHARP = 1e-6
"""A crossing of a limit is found within this share of its position."""
BETWEEN, ROUNDS = 4, 16
"""Parts into which an interval is divided at a time, and how many times at most."""
SMOOTH = 0.5
"""Least share of second differences side by side in each other, where a curve has no corner."""
ALIKE = 1e-6
"""Share of the range of a curve within which extremes are alike: the first is meant."""

T = TypeVar("T")


class Extremes(NamedTuple):
    """The least and the greatest value of a curve over its period, and where each is first."""

    least: float
    least_at: float
    greatest: float
    greatest_at: float


def extremes(samples: Real, period: float) -> Extremes:
    """Those of a smooth periodic curve between its equal samples, the first at 0: of their spline.

    >>> turn = np.linspace(0, 2 * np.pi, 90, endpoint=False)
    >>> found = extremes(np.cos(turn - 0.1234), 2 * np.pi)
    >>> [round(each, 4) for each in found]
    [-1.0, 3.265, 1.0, 0.1234]
    """
    from scipy.interpolate import CubicSpline

    at = np.linspace(0.0, period, samples.size + 1)
    curve = CubicSpline(at, np.append(samples, samples[0]), bc_type="periodic")
    flat = curve.derivative().roots(extrapolate=False)
    places = np.union1d(at[:-1], flat[np.isfinite(flat)] % period)
    values = curve(places)
    near = ALIKE * float(np.ptp(values))

    def first(sign: int) -> float:
        """Where a value begins that is alike the greatest, at the top of its own hill."""
        high = sign * values >= (sign * values).max() - near
        start = int(np.argmax(high))
        end = start + int(np.argmin(np.append(high[start:], False)))
        return float(places[start + int(np.argmax(sign * values[start:end]))])

    return Extremes(float(values.min()), first(-1), float(values.max()), first(1))


def highest(rows: Real) -> float:
    """The greatest value of periodic curves [row, equal sample], that between samples too.

    The top of the parabola through the three samples there where a curve is smooth; its greatest
    sample where it has a corner, or is flat: the second differences beside it are others.

    >>> turn = np.linspace(0, 2 * np.pi, 90, endpoint=False)
    >>> round(float(np.cos(turn - 0.03).max()), 6), round(highest(np.cos([turn - 0.03])), 6)
    (0.99955, 1.0)
    """
    tops: list[float] = []
    for row in np.atleast_2d(rows):
        place = int(np.argmax(row))
        near = row[np.arange(place - 2, place + 3) % row.size]
        bends = np.diff(near, 2)
        smooth = bends.max() < 0 and bends.max() < SMOOTH * bends.min()
        rise = (near[3] - near[1]) ** 2 / (-8 * bends[1]) if smooth else 0.0
        tops.append(float(row[place] + rise))
    return max(tops)


def refined(
    grid: Real,
    found: T,
    *,
    at: Callable[[Real], T],
    joined: Callable[[T, T], T],
    curves: Callable[[T], Real],
    limits: Real | None = None,
) -> T:
    """What is found on a grid, and at the points added to it at which its curves are highest.

    `found` belongs to the ascending `grid`, `at` computes the same at other points, `joined` puts
    both in ascending order, `curves` has the values [point, curve], each of its point alone. Every
    local maximum that may be the highest of its curve is divided until it is flat to 1e-6; so is
    each crossing of `limits` [curve] (nan: none), to 1e-6 of its position.

    >>> peak = lambda x: 1 / ((x - 1.2345) ** 2 + 1e-4)[:, None]
    >>> grid = np.linspace(0, 3, 7)
    >>> both = lambda a, b: np.concatenate([a, b])[np.argsort(np.concatenate([a, b])[:, 0])]
    >>> pair = lambda x: np.column_stack([x, peak(x)])
    >>> found = refined(grid, pair(grid), at=pair, joined=both, curves=lambda a: a[:, 1:])
    >>> x, value = found[np.argmax(found[:, 1])]
    >>> round(float(x), 4), round(float(value), 2)
    (1.2345, 10000.0)
    """
    values, added = curves(found), None
    for _ in range(ROUNDS):
        beside = _beside_maxima(grid, values, limits)
        more = np.union1d(beside, _at_limits(grid, values, limits))
        if not more.size:
            break
        new = at(more)
        places = np.searchsorted(grid, more)
        grid = np.insert(grid, places, more)
        values = np.insert(values, places, curves(new), axis=0)
        added = new if added is None else joined(added, new)
    return found if added is None else joined(found, added)


def _divided(grid: Real, intervals: Real) -> Real:
    """Points within intervals of a grid, by the index of their lower end."""
    lows = np.unique(intervals)
    lows = lows[(lows >= 0) & (lows < grid.size - 1)].astype(int)
    shares = np.arange(1, BETWEEN) / BETWEEN
    points = grid[lows, None] + np.diff(grid)[lows, None] * shares
    inside = (points > grid[lows, None]) & (points < grid[lows + 1, None])
    return points[inside]


def _beside_maxima(grid: Real, values: Real, limits: Real | None) -> Real:
    """Points on both sides of the local maxima that are not flat yet."""
    size = np.abs(values)
    before = np.vstack([np.full((1, size.shape[1]), -np.inf), size[:-1]])
    after = np.vstack([size[1:], np.full((1, size.shape[1]), -np.inf)])
    floor = NEAR * np.nanmax(size, axis=0, initial=0.0)
    if limits is not None:
        floor = np.fmin(floor, NEAR_LIMIT * limits)
    lower = np.minimum(np.where(before < 0, size, before), np.where(after < 0, size, after))
    local = (size >= before) & (size >= after) & (size >= floor) & (size > 0)
    rows = np.nonzero(local & (size - lower > FLAT * size))[0]
    return _divided(grid, np.concatenate([rows - 1, rows]))


def _at_limits(grid: Real, values: Real, limits: Real | None) -> Real:
    """Points in the intervals in which a curve crosses its limit."""
    if limits is None:
        return np.empty(0)
    over = np.abs(values) > limits
    rows = np.unique(np.nonzero(over[1:] != over[:-1])[0])
    return _divided(grid, rows[np.diff(grid)[rows] > SHARP * grid[rows + 1]])
