"""Compiled loops over sums of vectors with signs, by halves; and over the rows of a front.

All signs of the first classes meet all of the last ones: 2^(K/2) sums of each instead of 2^K.

Source: E. Horowitz and S. Sahni, Computing partitions with applications to the knapsack problem,
Journal of the ACM 21 (1974) 277 (sums of signs by halves).
"""

from __future__ import annotations

from typing import Any

import numpy as np

from crankstar.stars.compiling import compiled
from crankstar.stars.kernels import entered
from crankstar.stars.sums import SAME


@compiled
def signed(
    delta: Any, turns: Any, first: int, last: int, fixed: bool, out: Any, low: int, high: int
) -> int:
    """Number of sums over the classes from first to last with all signs; writes them [2 m, rows].

    fixed: the sign of the first class is +. Bit b of a row is set where class first + b (after the
    fixed one) has the sign -. Of the sums only the columns from low to high.
    """
    for c in range(low, high):
        total = 0.0
        for own in range(first, last):
            total += delta[own] * turns[own, c]
        out[c, 0] = total
    rows = 1
    for own in range(first + (1 if fixed else 0), last):
        for c in range(low, high):
            twice = 2.0 * delta[own] * turns[own, c]
            for row in range(rows):
                out[c, rows + row] = out[c, row] - twice
        rows *= 2
    return rows


@compiled
def short(x: Any, y: Any, rear: Any, c: int, rows: int, square: float) -> int:
    """How many of the rear half make a sum with x + iy whose square is at most so great."""
    count = 0
    for row in range(rows):
        dx = x + rear[c, row]
        dy = y + rear[c + 1, row]
        count += dx * dx + dy * dy <= square
    return count


@compiled
def largest(front: Any, i: int, rear: Any, j: int, weights: Any) -> float:
    """The largest of the weighted lengths of the sums of two rows."""
    most = 0.0
    for o in range(weights.shape[0]):
        if weights[o] > 0.0:
            x = front[2 * o, i] + rear[2 * o, j]
            y = front[2 * o + 1, i] + rear[2 * o + 1, j]
            most = max(most, weights[o] * weights[o] * (x * x + y * y))
    return np.sqrt(most)


@compiled
def driver(weights: Any) -> int:
    """The sum with the greatest weight."""
    best = 0
    for o in range(weights.shape[0]):
        if weights[o] > weights[best]:
            best = o
    return best


@compiled
def least(front: Any, fronts: int, rear: Any, rears: int, weights: Any) -> float:
    """The least value of a goal over all signs."""
    drive = driver(weights)
    best = np.inf
    for i in range(fronts):
        square = (best / weights[drive]) ** 2
        if short(front[2 * drive, i], front[2 * drive + 1, i], rear, 2 * drive, rears, square):
            for j in range(rears):
                best = min(best, largest(front, i, rear, j, weights))
    return best


@compiled
def beyond(tables: Any, walk: Any, code: int, drive: int, weights: Any, square: float) -> float:
    """Square of the largest weighted sum but the driver with some signs; -1 where it is greater.

    Greater than `square`, at once.
    """
    classes, most = tables.turns.shape[0], 0.0
    for o in range(weights.shape[0]):
        if o == drive or weights[o] == 0.0:
            continue
        x, y = 0.0, 0.0
        for own in range(classes):
            size = walk.delta[own]
            if own > 0 and (code >> (own - 1)) & 1:
                size = -size
            x += size * tables.turns[own, 2 * o]
            y += size * tables.turns[own, 2 * o + 1]
        own_square = weights[o] * weights[o] * (x * x + y * y)
        if own_square > square:
            return -1.0
        most = max(most, own_square)
    return most


@compiled
def sifted(values: Any, times: Any, points: Any, size: int, home: Any) -> None:
    """Find the point of each row, and keep so many rows of each: home is -1 for the others.

    points: ascending by the sum of their values; times: how many orders a row stands for; the first
    row of a point gets them all. A row whose values are no point's is dominated.
    """
    goals = values.shape[1]
    seen = np.zeros(points.shape[0], np.int64)
    first = np.zeros(points.shape[0], np.int64)
    sums = np.zeros(points.shape[0])
    for f in range(points.shape[0]):
        for q in range(goals):
            sums[f] += points[f, q]
    slack = 3 * goals * SAME
    for row in range(values.shape[0]):
        home[row] = -1
        whole = 0.0
        for q in range(goals):
            whole += values[row, q]
        f = np.searchsorted(sums, whole - slack)
        while f < points.shape[0] and sums[f] <= whole + slack:
            same = True
            for q in range(goals):
                if abs(values[row, q] - points[f, q]) > 2 * SAME:
                    same = False
                    break
            if same:
                if seen[f] == 0:
                    first[f] = row
                else:
                    times[first[f]] += times[row]
                    times[row] = 0
                if seen[f] < size:
                    home[row] = f
                seen[f] += 1
                break
            f += 1


@compiled
def surpassed(values: Any, front: Any, known: int, slack: float) -> bool:
    """Whether a point of the front is as good in all values and better in one.

    slack: by how much the values may be off. Such a point changes places with one halfway to the
    first: those that turn many away are soon looked at first.
    """
    for f in range(known):
        better = False
        for q in range(values.shape[0]):
            if front[f, q] > values[q] + SAME - slack:
                break
            if front[f, q] < values[q] - SAME - slack:
                better = True
        else:
            if better:
                ahead = f // 2
                for q in range(values.shape[0]):
                    front[f, q], front[ahead, q] = front[ahead, q], front[f, q]
                return True
    return False


@compiled
def joined(points: Any, known: int, others: Any) -> int:
    """Number of points of a front that others have joined, where no known one is as good."""
    for row in range(others.shape[0]):
        needed = True
        for f in range(known):
            worse = False
            for q in range(others.shape[1]):
                if points[f, q] > others[row, q] + SAME:
                    worse = True
                    break
            if not worse:
                needed = False
                break
        if needed:
            known = entered(others[row], points, known)
    return known
