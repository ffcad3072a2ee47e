"""Where to search: regions of stars that are searched whole, and when that proves the answer.

A region holds all stars whose sum of one kind is at most a radius long. For a front, one region for
each objective: a star outside all of them is longer than the radius in every objective, so one
found star that is within the radius in all, with as few neighbours in succession as there can be,
is better than everything outside. For a list of the best: a region in which enough stars were found
with values up to its radius. A limit on a sum is a region that holds all that is allowed, and needs
no proof. Where the proof fails the radii are doubled.

How many stars a region holds is estimated by the exact mean square of the sum over all stars, as if
the sum were normally distributed; only the running time hangs on the estimate.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import exp, factorial, inf, log1p, sqrt

import numpy as np

from crankstar.stars.halves import Halves
from crankstar.stars.question import All, Best, Question
from crankstar.stars.results import Results
from crankstar.stars.sums import SAME

WANTED = 8.0
"""Stars that are expected in all regions of a front at once when it is begun."""
CHEAP = 0.05
"""Pairs examined for each arrangement formed that cost little beside it."""


@dataclass(frozen=True)
class Regions:
    """Sums (by their place in the question) with radii, and values up to which they are whole.

    Radii are in the kernels' unit.

    whole: all stars within the limits are in a region; bounds: infinite for an objective without
    sums.
    """

    radii: tuple[tuple[int, float], ...]
    bounds: tuple[float, ...]
    whole: bool
    expected: float
    """How many stars they are expected to hold."""


def regions(question: Question, ready: Halves, *, attempt: int = 0) -> Regions:
    """The regions of an attempt, from 0; each is twice as wide as the one before."""
    everything = _everything(question, ready)
    if isinstance(question.ask, All) or question.functions:
        return everything
    driven = [_driver(row[:-1], ready.spread) for row in ready.tables.weights]
    if (isinstance(question.ask, Best) and driven[0] is None) or all(
        driver is None for driver in driven
    ):
        return everything
    scale = _scale(question, ready, driven) * 2.0**attempt
    radii: list[tuple[int, float]] = []
    bounds: list[float] = []
    for driver in driven:
        if driver is None:
            bounds.append(inf)
            continue
        place, weight = driver
        radii.append((place, scale * ready.spread[place]))
        bounds.append(radii[-1][1] * weight)
    expected = sum(_stars(ready) * _share(radius, ready.spread[place]) for place, radius in radii)
    if expected >= everything.expected:
        return everything
    return Regions(tuple(radii), tuple(bounds), False, expected)


def complete(question: Question, listed: Results, tried: Regions) -> bool:
    """Whether the stars found in the regions prove that none outside belongs to the answer."""
    if tried.whole:
        return True
    bounds = np.array(tried.bounds)
    if isinstance(question.ask, Best):
        return len(listed) >= question.ask.size and bool(
            listed.values[question.ask.size - 1, 0] <= bounds[0]
        )
    least = np.where(np.isinf(bounds), SAME, bounds)
    return bool((listed.values <= least).all(axis=1).any())


def _stars(ready: Halves) -> float:
    """Stars in all blocks, at most."""
    return float(ready.block_count) * ready.outer_rows * ready.inner_rows


def _share(radius: float, spread: float) -> float:
    """The part of all stars that a region is expected to hold."""
    return 1.0 if spread <= 1e-12 else 1.0 - exp(-((radius / spread) ** 2))


def _everything(question: Question, ready: Halves) -> Regions:
    """The region that holds all stars within the limits: that of the tightest limit, or all."""
    limits = ready.tables.limits[:-1]
    bounds = (inf,) * max(1, len(question.objectives))
    listed = [
        (_share(limit, spread), index)
        for index, (limit, spread) in enumerate(zip(limits, ready.spread, strict=True))
    ]
    share, place = min(listed)
    radius = min(limits[place] + 2 * SAME, ready.reach[place] * 1.001 + 1.0)
    return Regions(((place, float(radius)),), bounds, True, _stars(ready) * share)


def _driver(weights: np.ndarray, spread: tuple[float, ...]) -> tuple[int, float] | None:
    """The sum that matters most in an objective, and its weight; None if none varies."""
    widths = [
        (sqrt(weight) * width, index)
        for index, (weight, width) in enumerate(zip(weights, spread, strict=True))
    ]
    most, place = max(widths)
    return (place, sqrt(float(weights[place]))) if most > 1e-12 else None


def _scale(question: Question, ready: Halves, driven: list[tuple[int, float] | None]) -> float:
    """Radii over the root mean squares of the sums, by the stars needed and by what is cheap."""
    stars = _stars(ready)
    for limit, spread in zip(ready.tables.limits[:-1], ready.spread, strict=True):
        stars *= _share(limit, spread)
    wanted, planes, more = WANTED, sum(driver is not None for driver in driven), 1.0
    if isinstance(question.ask, Best):
        weights = ready.tables.weights[0][:-1]
        spread = np.array(
            [w for w, weight in zip(ready.spread, weights, strict=True) if weight > 0]
        )
        planes = len(spread)
        wanted = 4.0 * question.ask.size + WANTED
        place, weight = driven[0] or (0, 1.0)
        shares = np.sqrt(weights[weights > 0]) * spread / (weight * ready.spread[place])
        more = float(factorial(planes) * np.prod(shares**2))
    need = min(1.0, (wanted * more / max(stars, wanted)) ** (1.0 / planes))
    share = max(need, min(0.5, CHEAP * ready.rows / max(_stars(ready), 1.0)))
    return sqrt(-log1p(-min(share, 0.999)))
