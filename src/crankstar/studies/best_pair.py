"""The best pair of a sweep of two numbers, and the pairs that none beats in two results."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from crankstar.files import EngineFileError
from crankstar.spectra import Real
from crankstar.studies.best_value import ALIKE
from crankstar.studies.sweep import Axis, Curve, Sweep, watched
from crankstar.studies.variants import SweepError

FINENESS = 1e-5
"""Share of each range to which the best pair is found."""
LEVEL = 1e-4
"""Share of the greatest result by which the pairs of a ridge may differ."""
BANDS = 3
"""Parts of each range, from the best pair of each of which the best one is looked for."""
PLACES, STAGES, NEAR = 5, 16, 0.01
"""Values of each number in a stage; the most stages, each of which halves what is left, or moves
it; the share of each range to which they go."""
ROUNDS, TRIALS = 3, 150
"""Searches by a simplex from the best pair so far, and the most pairs that each of them tries."""
TRIED, CLOSER = 5, 9
"""Values of one number that are tried for a ridge, and of the other in a stage."""


class BestPair(NamedTuple):
    """The best pair of values of a sweep of two numbers and what it gives.

    `at_edge`: by number, whether it is an end of its range, and might be better beyond. `flat`: the
    result is the same at every pair. `also`: at how many other pairs of the sweep it is as good.
    `ridge`: for other values of one number there is one of the other that is as good, so that the
    best pairs are a line.
    """

    values: tuple[float, float]
    result: float
    at_edge: tuple[bool, bool]
    flat: bool
    also: int = 0
    ridge: bool = False


def best_pair(sweep: Sweep, curve: Curve, *, greatest: bool = False) -> BestPair:
    """The pair at which the result is least (or `greatest`), also between those of the sweep.

    >>> from crankstar.studies.sweep import sweep
    >>> both = sweep("single", ["balance_factor=0..1/4", "cylinder.rod_ratio=3..5/2"])
    >>> pair = best_pair(both, watched(both, "force.forward", order=1))
    >>> round(pair.values[0], 3), pair.result < 1e-4, pair.flat
    (0.5, True, False)
    """
    sign = -1.0 if greatest else 1.0
    cells = _apart(sweep, _signed(curve, sign))
    top = float(np.nanmax(np.abs(curve.values)))
    even = ALIKE * top
    row, column = _innermost(cells <= cells.min() + even)
    place = [float(sweep.axes[0].values[row]), float(sweep.axes[1].values[column])]
    least = float(cells[row, column])
    also = int(np.count_nonzero(cells <= least + even)) - 1
    flat = float(np.ptp(cells[np.isfinite(cells)])) <= even
    if not flat and (greatest or least > even):
        try:
            found, refined = _refined(sweep, curve, _starts(sweep, cells), sign)
            if refined < least - even:
                place, least, also = found, refined, 0
        except (EngineFileError, SweepError):
            pass  # not every number between two good ones is one: a ratio of teeth
    edges = [
        not axis.closed and value in (float(axis.values.min()), float(axis.values.max()))
        for axis, value in zip(sweep.axes, place, strict=True)
    ]
    ridge = not flat and any(
        _as_good_along(sweep, curve, which, sign, least + LEVEL * top) for which in (0, 1)
    )
    ends = edges[0], edges[1]
    return BestPair((place[0], place[1]), sign * least, ends, flat, 0 if flat else also, ridge)


def _as_good_along(sweep: Sweep, curve: Curve, which: int, sign: float, enough: float) -> bool:
    """Whether the other number can make up for any value of one of them, tried at some."""
    own, other = sweep.axes[which], np.sort(sweep.axes[1 - which].values)
    order = np.argsort(sweep.axes[1 - which].values)
    for index in np.unique(np.linspace(0, own.values.size - 1, TRIED + 2).astype(int))[1:-1]:
        line = np.take(_signed(curve, sign), index, axis=which)[order]
        at = int(np.argmin(line))
        low, high = other[max(at - 1, 0)], other[min(at + 1, other.size - 1)]
        least = float(line[at])
        while least > enough and high - low > FINENESS * float(np.ptp(other)):
            closer = np.linspace(low, high, CLOSER)
            boxes = [own.values[index : index + 1], closer]
            again = sweep.again(*(boxes if which == 0 else boxes[::-1]))
            line = _signed(watched(again, curve.what, order=curve.order), sign).ravel()
            at = int(np.argmin(line))
            low, high = closer[max(at - 1, 0)], closer[min(at + 1, CLOSER - 1)]
            least = min(least, float(line[at]))
        if least > enough:
            return False
    return True


def _signed(curve: Curve, sign: float) -> Real:
    """The results, of which the least is the best; none is worse than any."""
    return np.where(np.isnan(curve.values), np.inf, sign * curve.values)


def _innermost(good: np.ndarray) -> tuple[int, int]:
    """The first of equally good pairs, of those that are at the ends of the fewest ranges."""
    rows, columns = np.nonzero(good)
    ends = sum(
        np.isin(places, (0, size - 1)).astype(int)
        for places, size in zip((rows, columns), good.shape, strict=True)
    )
    at = int(np.argmin(ends))
    return int(rows[at]), int(columns[at])


def _apart(sweep: Sweep, cells: Real) -> Real:
    """The results without the last values of closed ranges, which are the first ones."""
    rows, columns = (slice(-1 if axis.closed else None) for axis in sweep.axes)
    return cells[rows, columns]


def _starts(sweep: Sweep, cells: Real) -> list[list[float]]:
    """The best pairs of a sweep in each of some parts of its ranges."""
    places: set[tuple[int, int]] = set()
    for which in (0, 1):
        size = cells.shape[which]
        for band in np.array_split(np.arange(size), min(BANDS, size)):
            part = np.take(cells, band, axis=which)
            at = [int(index) for index in np.unravel_index(np.argmin(part), part.shape)]
            at[which] = int(band[at[which]])
            places.add((at[0], at[1]))
    return [
        [float(axis.values[at]) for axis, at in zip(sweep.axes, place, strict=True)]
        for place in sorted(places)
    ]


def _refined(
    sweep: Sweep, curve: Curve, starts: Sequence[list[float]], sign: float
) -> tuple[list[float], float]:
    """The best pair near those of the sweep: boxes around each, then a simplex from the best.

    Where it is best the result has an edge as a rule, of which the method of Nelder and Mead needs
    no slope.
    """
    from scipy.optimize import minimize

    place, least = min((_closer(sweep, curve, start, sign) for start in starts), key=lambda p: p[1])
    spans = np.array([float(np.ptp(axis.values)) for axis in sweep.axes])
    bounds = [
        (None, None) if axis.closed else (float(axis.values.min()), float(axis.values.max()))
        for axis in sweep.axes
    ]
    tops = np.array([np.inf if high is None else high for _low, high in bounds])
    whole = float(np.nanmax(np.abs(curve.values)))
    for _round in range(ROUNDS):
        step = NEAR * spans * np.where(place + NEAR * spans > tops, -1, 1)
        simplex = np.array(place) + np.array([[0, 0], [step[0], 0], [0, step[1]]])
        found = minimize(
            lambda trial: _single(sweep, curve, trial, sign),
            place,
            method="Nelder-Mead",
            bounds=bounds,
            options={
                "initial_simplex": simplex,
                "xatol": FINENESS * float(spans.min()),
                "fatol": ALIKE * whole,
                "maxfev": TRIALS,
            },
        )
        better = found.fun < least - LEVEL * whole
        if found.fun < least:
            place, least = found.x.tolist(), float(found.fun)
        if not better:
            break
    at_ends = [_at_end(axis, value) for axis, value in zip(sweep.axes, place, strict=True)]
    there = _single(sweep, curve, at_ends, sign)
    if there <= least + LEVEL**2 * whole:
        place, least = at_ends, there
    return [_in_range(axis, value) for axis, value in zip(sweep.axes, place, strict=True)], least


def _at_end(axis: Axis, value: float) -> float:
    """The end of a range that a value is at but for the fineness of the search, or the value."""
    ends = () if axis.closed else (float(axis.values.min()), float(axis.values.max()))
    near = FINENESS * float(np.ptp(axis.values))
    return next((end for end in ends if abs(value - end) <= near), value)


def _single(sweep: Sweep, curve: Curve, place: Sequence[float], sign: float) -> float:
    """The result of one pair, worse than any where it has none."""
    again = sweep.again(*(np.array([float(value)]) for value in place))
    try:
        return sign * float(watched(again, curve.what, order=curve.order).values[0, 0])
    except SweepError:
        return np.inf


def _closer(
    sweep: Sweep, curve: Curve, place: list[float], sign: float
) -> tuple[list[float], float]:
    """A better pair near one of the sweep: boxes around it, each half as large or moved."""
    spans = [float(np.ptp(axis.values)) for axis in sweep.axes]
    reach = [_step(axis, value) for axis, value in zip(sweep.axes, place, strict=True)]
    least = _single(sweep, curve, place, sign)
    for _stage in range(STAGES):
        boxes = [
            _box(axis, value, step)
            for axis, value, step in zip(sweep.axes, place, reach, strict=True)
        ]
        cells = _signed(watched(sweep.again(*boxes), curve.what, order=curve.order), sign)
        at = [int(index) for index in np.unravel_index(np.argmin(cells), cells.shape)]
        if cells[at[0], at[1]] < least - ALIKE * abs(least):
            least = float(cells[at[0], at[1]])
            place = [float(box[index]) for box, index in zip(boxes, at, strict=True)]
        inside = all(0 < index < PLACES - 1 for index in at)
        reach = [step / (2 if inside else 1.4) for step in reach]
        if all(step <= NEAR * span for step, span in zip(reach, spans, strict=True)):
            break
    return place, least


def _step(axis: Axis, value: float) -> float:
    """The greatest distance from a value to a neighbour."""
    places = np.unique(axis.values)
    at = int(np.argmin(np.abs(places - value)))
    return float(np.diff(places)[max(at - 1, 0) : at + 1].max())


def _box(axis: Axis, value: float, step: float) -> Real:
    """Values around a value, in the range unless that is closed."""
    low, high = value - step, value + step
    if not axis.closed:
        low, high = max(low, float(axis.values.min())), min(high, float(axis.values.max()))
    return np.linspace(low, high, PLACES)


def _in_range(axis: Axis, value: float) -> float:
    low, span = float(axis.values.min()), float(np.ptp(axis.values))
    return low + (value - low) % span if axis.closed else value


class Unbeaten(NamedTuple):
    """A pair of values that no other one beats in both results; `alike` others give the same."""

    values: tuple[float, float]
    results: tuple[float, float]
    alike: int


def front(
    sweep: Sweep, first: Curve, second: Curve, *, greatest: bool = False
) -> tuple[Unbeaten, ...]:
    """The pairs for which no other is at least as good in both results and better in one.

    Least is best, or `greatest`; by the first result, best first.

    >>> from crankstar.studies.sweep import sweep
    >>> both = sweep("single", ["balance_factor=0, 0.5, 1", "cylinder.rod_ratio=3, 4"])
    >>> curves = [watched(both, f"force.{way}", order=1) for way in ("up", "right")]
    >>> [(pair.values[0], pair.alike) for pair in front(both, *curves)]  # upright or sideways
    [(1.0, 1), (0.5, 1), (0.0, 1)]
    """
    sign = -1.0 if greatest else 1.0
    results = [_apart(sweep, _signed(curve, sign)) for curve in (first, second)]
    missing = ~np.logical_and(*map(np.isfinite, results))
    results = [np.where(missing, np.inf, each) for each in results]
    shape = results[0].shape
    even = [
        ALIKE * max(float(np.nanmax(np.abs(curve.values))), 1e-300) for curve in (first, second)
    ]
    x, y = (np.round(each.ravel() / least) for each, least in zip(results, even, strict=True))
    out: list[Unbeaten] = []
    best = np.inf
    for flat in np.lexsort((y, x)):
        if y[flat] >= best - 0.5 or np.isinf(y[flat]):
            continue
        best = y[flat]
        row, column = np.unravel_index(flat, shape)
        same = int(np.count_nonzero((x == x[flat]) & (y == y[flat]))) - 1
        place = float(sweep.axes[0].values[row]), float(sweep.axes[1].values[column])
        pair = sign * float(results[0][row, column]), sign * float(results[1][row, column])
        out.append(Unbeaten(place, pair, same))
    return tuple(out)
