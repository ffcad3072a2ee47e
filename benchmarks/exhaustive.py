"""The plain road, for comparison.

Depth first through all stars, sums carried along, the front kept. Compiled as the search is.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit

SAME = 1e-12


@njit(cache=True)
def _front(arms: Any, cosines: Any, sines: Any, front: Any) -> int:
    """Write the squares of the front's lengths (M1, M2) and return its number of points."""
    n = arms.shape[0]
    choice = np.zeros(n, np.int64)
    used = np.zeros(n, np.bool_)
    sums = np.zeros((n + 1, 4))
    used[0] = True
    for c in range(2):
        sums[1, 2 * c] = arms[0] * cosines[0]
        sums[1, 2 * c + 1] = arms[0] * sines[0]
    known = 0
    depth = 1
    choice[1] = 0
    while depth > 0:
        chosen = choice[depth]
        if chosen > 0:
            used[chosen] = False
        chosen += 1
        while chosen < n and used[chosen]:
            chosen += 1
        if chosen == n:
            choice[depth] = 0
            depth -= 1
            continue
        choice[depth] = chosen
        used[chosen] = True
        twice = (2 * chosen) % n
        sums[depth + 1, 0] = sums[depth, 0] + arms[depth] * cosines[chosen]
        sums[depth + 1, 1] = sums[depth, 1] + arms[depth] * sines[chosen]
        sums[depth + 1, 2] = sums[depth, 2] + arms[depth] * cosines[twice]
        sums[depth + 1, 3] = sums[depth, 3] + arms[depth] * sines[twice]
        if depth < n - 1:
            depth += 1
            choice[depth] = 0
            continue
        one = sums[n, 0] ** 2 + sums[n, 1] ** 2
        two = sums[n, 2] ** 2 + sums[n, 3] ** 2
        worse = False
        for f in range(known):
            if front[f, 0] <= one + SAME and front[f, 1] <= two + SAME:
                worse = True
                break
        if worse:
            continue
        kept = 0
        for f in range(known):
            if not (one <= front[f, 0] + SAME and two <= front[f, 1] + SAME):
                front[kept] = front[f]
                kept += 1
        front[kept, 0] = one
        front[kept, 1] = two
        known = kept + 1
    return known


def front(cylinders: int) -> list[tuple[float, float]]:
    """The (M1, M2) front of a two-stroke engine with equal pitches, by all stars."""
    arms = (cylinders - 1) / 2 - np.arange(cylinders)
    angles = 2 * np.pi * np.arange(cylinders) / cylinders
    points = np.empty((4096, 2))
    known = _front(arms, np.cos(angles), np.sin(angles), points)
    return sorted((float(one), float(two)) for one, two in np.sqrt(points[:known]))
