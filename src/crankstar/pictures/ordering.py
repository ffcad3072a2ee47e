"""The order in which bodies are painted, so that what is nearer covers what is behind it.

A body A cannot cover B if a plane stands between them with A on the side away from the eye. Planes
across the shafts, along and across the cylinder axes, and those that are seen edge-on are tried.
Of two bodies that could cover each other, as a rod in its piston, the rank decides, else depth.
"""

from __future__ import annotations

from collections.abc import Sequence
from heapq import heapify, heappop, heappush

import numpy as np
from numpy.typing import NDArray

from crankstar.spectra import Real

TOUCHING = 1e-6
"""Share of the size of everything by which bodies that touch may overlap."""


def painted_order(
    points: Real,
    starts: NDArray[np.int_],
    normals: Real,
    back: Sequence[float],
    families: NDArray[np.int_],
    ranks: Real,
) -> list[int]:
    """Places of bodies in the order in which they are painted.

    `points` (x, y, z) [point] of all bodies, each beginning at its start; `normals` [plane] of
    planes; `back` points to the eye. Ranks are compared within a family.
    """
    facing = normals @ np.asarray(back)
    normals = np.where(facing[:, None] < 0, -normals, normals)
    values = points @ normals.T
    low = np.minimum.reduceat(values, starts, axis=0).T
    high = np.maximum.reduceat(values, starts, axis=0).T
    slack = TOUCHING * float(np.ptp(values)) if values.size else 0.0
    below = high[:, :, None] <= low[:, None, :] + slack  # [plane, A, B]
    edge_on = np.abs(facing) < 1e-9
    apart = below[edge_on].any(axis=0)
    apart |= apart.T
    cannot = below[~edge_on].any(axis=0) | apart
    depth = np.add.reduceat(points @ np.asarray(back), starts) / np.diff([*starts, len(points)])
    # bodies that are as near as each other keep one order at all angles
    depth = np.round(depth / max(slack, 1e-300)) * slack
    either = ~cannot & ~cannot.T
    kin = families[:, None] == families[None, :]
    first = np.where(
        kin & (ranks[:, None] != ranks[None, :]),
        ranks[:, None] < ranks[None, :],
        depth[:, None] < depth[None, :],
    )
    before = (cannot & ~cannot.T) | (either & first)
    np.fill_diagonal(before, val=False)
    return _sorted(before, depth.tolist())


def _sorted(before: NDArray[np.bool_], depth: list[float]) -> list[int]:
    """A topological order, the farthest first; a circle is broken at its farthest body."""
    waiting = before.sum(axis=0).tolist()
    ready = [(depth[index], index) for index, count in enumerate(waiting) if not count]
    heapify(ready)
    left = set(range(len(depth)))
    order: list[int] = []
    while left:
        while ready:
            place = heappop(ready)[1]
            if place not in left:
                continue
            left.remove(place)
            order.append(place)
            for following in np.flatnonzero(before[place]).tolist():
                waiting[following] -= 1
                if not waiting[following] and following in left:
                    heappush(ready, (depth[following], following))
        if left:
            farthest = min(left, key=depth.__getitem__)
            heappush(ready, (depth[farthest], farthest))
    return order
