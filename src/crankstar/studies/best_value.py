"""The best value of a sweep of one number: the least or greatest, refined between its points."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from crankstar.files import EngineFileError
from crankstar.spectra import Real
from crankstar.studies.sweep import Curve, Sweep, watched
from crankstar.studies.variants import SweepError

ALIKE = 1e-9
"""Results that differ by no more than this share of the greatest of the curve are equally good."""
FINENESS = 1e-8
"""Share of the range to which the best value is found: 16 values at a time at six places."""
CLOSER, PLACES, ALSO = 16, 6, 8


class Best(NamedTuple):
    """The best value of a sweep and what it gives.

    `at_edge`: it is an end of the range, and might be better beyond. `at_gap`: it stands beside
    values that were asked for and have no result. `flat`: the curve is the same
    all along. `also`: other values that are as good, up to eight. `stretch`: where it is equally
    good from one value to another, these two.
    """

    value: float
    result: float
    at_edge: bool
    flat: bool
    also: tuple[float, ...] = ()
    stretch: tuple[float, float] | None = None
    at_gap: bool = False


def best(sweep: Sweep, curve: Curve, *, greatest: bool = False) -> Best:
    """The value at which the curve is least (or `greatest`), also between values of the sweep.

    Every place where the curve may come lowest, a smooth hollow or the tip of a V, is swept again
    more and more closely. Values without a result are none.

    >>> from crankstar.studies.sweep import swept
    >>> sweep = swept("single", over="balance_factor", values=np.linspace(0, 1, 8))
    >>> found = best(sweep, watched(sweep, "force", order=1))
    >>> round(found.value, 6), round(found.result, 6), found.at_edge
    (0.5, 0.5, False)
    """
    sign = -1.0 if greatest else 1.0
    known = np.flatnonzero(np.isfinite(curve.values))
    x, where = np.unique(sweep.values[known], return_index=True)
    y = sign * curve.values[known][where]
    even = ALIKE * float(np.abs(y).max())
    low, span = float(x[0]), float(x[-1] - x[0])
    if float(np.ptp(y)) <= even:
        return Best(
            float(sweep.values[known[0]]),
            float(curve.values[known[0]]),
            at_edge=False,
            flat=True,
            stretch=(float(x[0]), float(x[-1])),
        )
    round_about = sweep.axes[0].closed
    if round_about:
        x, y = _begun_at_the_highest(x, y)
    runs = _hollows(x, y, even)
    try:
        tips = _tips(sweep, curve, runs, x, sign)
    except (
        EngineFileError,
        SweepError,
    ):  # not every number between two good ones is one: a ratio of teeth
        tips = [None] * len(runs)
    minima: list[Minimum] = []
    for (first, last), tip in zip(runs, tips, strict=True):
        if tip is not None and tip[1] < y[first] - even:
            minima.append((*tip, None))
        else:
            middle = (first + last) // 2
            minima.append(
                (
                    float(x[middle]),
                    float(y[middle]),
                    (float(x[first]), float(x[last])) if last > first else None,
                )
            )
    least = min(result for _, result, _ in minima)
    good = [minimum for minimum in minima if minimum[1] <= least + even]
    if round_about:
        good = sorted(_within(minimum, low, span) for minimum in good)
    value, result, stretch = good[0]
    ends, gaps = _bounds(sweep, curve)
    edge = bool({value, *(stretch or ())} & ends) and not round_about
    return Best(
        value,
        sign * result,
        edge,
        flat=False,
        also=tuple(minimum[0] for minimum in good[1 : ALSO + 1]),
        stretch=stretch,
        at_gap=bool({value, *(stretch or ())} & gaps),
    )


def _bounds(sweep: Sweep, curve: Curve) -> tuple[set[float], set[float]]:
    """The ends of the range that have a result, and the values beside which one has none."""
    order = np.argsort(sweep.values)
    x, there = sweep.values[order], np.isfinite(curve.values[order])
    beside = there & ~(np.r_[True, there[:-1]] & np.r_[there[1:], True])
    ends = {float(x[place]) for place in (0, -1) if there[place]}
    return ends, {float(value) for value in x[beside]}


Minimum = tuple[float, float, tuple[float, float] | None]
"""Value, result, and from where to where it is the same."""


def _begun_at_the_highest(x: Real, y: Real) -> tuple[Real, Real]:
    """A closed range from its highest value on: so that no hollow lies across its ends."""
    top = int(np.argmax(y[:-1]))
    return np.concatenate([x[top:-1], x[: top + 1] + (x[-1] - x[0])]), np.concatenate(
        [y[top:-1], y[: top + 1]]
    )


def _within(minimum: Minimum, low: float, span: float) -> Minimum:
    """A minimum of a closed range with its values in that range."""
    value, result, stretch = minimum

    def inside(number: float) -> float:
        turned = low + (number - low) % span
        return low if low + span - turned < FINENESS * span else turned

    return inside(value), result, stretch and (inside(stretch[0]), inside(stretch[1]))


def _hollows(x: Real, y: Real, even: float) -> list[tuple[int, int]]:
    """Runs of equal results lower than both neighbours, in or beside which a minimum may lie."""
    runs: list[tuple[int, int]] = []
    first = 0
    for last in range(x.size):
        if last + 1 < x.size and abs(y[last + 1] - y[first]) <= even:
            continue
        before = y[first - 1] if first else np.inf
        after = y[last + 1] if last + 1 < x.size else np.inf
        if before > y[first] and after > y[first]:
            runs.append((first, last))
        first = last + 1

    def depth(run: tuple[int, int]) -> float:
        """How low a V could reach that has the steeper of the two slopes beside the run."""
        slopes = [
            abs(y[a] - y[b])
            for a, b in ((run[0], run[0] - 1), (run[1], run[1] + 1))
            if 0 <= b < x.size
        ]
        return float(y[run[0]] - max(slopes, default=0.0))

    hopeful = [run for run in runs if depth(run) <= y.min() + even]
    exact = [run for run in hopeful if y[run[0]] <= y.min() + even]
    kept = sorted(hopeful, key=depth)[:PLACES]
    return sorted({*kept, *exact[: ALSO + 1]})


def _tips(
    sweep: Sweep, curve: Curve, runs: Sequence[tuple[int, int]], x: Real, sign: float
) -> list[tuple[float, float] | None]:
    """The lowest point in or beside each run, by sweeping all of them closer and closer.

    Signed results.
    """
    brackets = [
        (float(x[max(first - 1, 0)]), float(x[min(last + 1, x.size - 1)])) for first, last in runs
    ]
    tips: list[tuple[float, float] | None] = [None] * len(runs)
    span = float(x[-1] - x[0])
    while max(high - low for low, high in brackets) > FINENESS * span:
        closer = np.concatenate([np.linspace(low, high, CLOSER + 1) for low, high in brackets])
        again = sign * watched(sweep.again(closer), curve.what, order=curve.order).values
        again = np.where(np.isnan(again), np.inf, again)
        for index in range(len(brackets)):
            own = slice(index * (CLOSER + 1), (index + 1) * (CLOSER + 1))
            here, results = closer[own], again[own]
            lowest = int(np.argmin(results))
            tips[index] = min(
                filter(None, (tips[index], (float(here[lowest]), float(results[lowest])))),
                key=lambda tip: tip[1],
            )
            brackets[index] = (
                float(here[max(lowest - 1, 0)]),
                float(here[min(lowest + 1, CLOSER)]),
            )
    return tips
