"""The ranges of a sweep whose engine has estimated values: a band about each curve.

At each value of the swept number a result has the range that an analysis of that engine gives it
(`ranges`).
"""

from __future__ import annotations

from collections.abc import Sequence
from math import isnan
from typing import NamedTuple

import numpy as np

from crankstar import spectra
from crankstar.analysis.document import Ranged, Remarks
from crankstar.language.messages import _
from crankstar.language.numbers import unit_text
from crankstar.language.shown_units import shown
from crankstar.mechanics.bounds import of_order, of_peak
from crankstar.spectra import Complex, Real
from crankstar.studies.best_value import Best
from crankstar.studies.sweep import WATCHABLE, Curve, Sweep, spectrum_of, watched
from crankstar.tables.cells import rough
from crankstar.tables.estimates import typical_remarks
from crankstar.tables.hulls import greatest_sum
from crankstar.tables.number_ranges import real_range
from crankstar.tables.ranges import doubt

ENDS = ("typical", "low", "high")
MOST_VALUES = 2000
"""Values of a sweep that are given with ranges; each takes as long as one for every corner."""


class Band(NamedTuple):
    """The range of a curve at every value; where it is best, and over the ranges of estimates.

    `cells` are the results [n], those with a range Ranged; `best` is the best one, `reach` the
    least and the greatest value of the sweep at which it may lie, None where they are the same.
    """

    cells: tuple[float | Ranged, ...]
    best: float | Ranged
    reach: tuple[float, float] | None

    @property
    def low(self) -> Real:
        """The lowest results [n]."""
        return np.array([getattr(cell, "low", cell) for cell in self.cells])

    @property
    def high(self) -> Real:
        """The greatest results [n]."""
        return np.array([getattr(cell, "high", cell) for cell in self.cells])


def bands(
    sweep: Sweep, curves: Sequence[Curve], found: Sequence[Best], *, greatest: bool = False
) -> tuple[Band | None, ...]:
    """The ranges of the curves of a sweep of one number; None of those that have none."""
    none = (None,) * len(curves)
    if len(sweep.axes) > 1 or sweep.values.size > MOST_VALUES:
        return none
    ends = sweep.ends()
    if not ends:
        return none
    return tuple(
        _band(sweep, ends, curve, best, greatest=greatest)
        for curve, best in zip(curves, found, strict=True)
    )


def _band(
    sweep: Sweep, ends: Sequence[Sweep], curve: Curve, best: Best, *, greatest: bool
) -> Band | None:
    others = np.array([watched(end, curve.what, order=curve.order).values for end in ends])
    rows = np.column_stack([curve.values, others.T])
    top = float(np.nanmax(rows))
    low = _bounds([sweep, *ends], curve)
    cells = tuple(_cell(row, top, bound=each) for row, each in zip(rows.tolist(), low, strict=True))
    if not any(isinstance(cell, Ranged) for cell in cells):
        return None
    there = np.array([best.value])  # between those of the sweep
    at_there = [end.again(there) for end in ends]
    results = [watched(end, curve.what, order=curve.order) for end in at_there]
    (low,) = _bounds(at_there, curve)
    sizes = [best.result, *(float(each.values[0]) for each in results)]
    at_best = real_range(sizes, top, bound=low)
    places = sweep.values[(np.nanargmax if greatest else np.nanargmin)(rows, axis=0)].tolist()
    lone = not (best.flat or best.also or best.stretch or sweep.axes[0].closed)
    apart = lone and max(places) > min(places)
    return Band(cells, at_best, (min(places), max(places)) if apart else None)


def _cell(row: Sequence[float], top: float, *, bound: float) -> float | Ranged:
    """A result with its range; where an end has none, that of the others."""
    known = [value for value in row if not isnan(value)]
    if isnan(row[0]) or len(known) == 1:
        return row[0]
    if len(known) < len(row):
        return Ranged(row[0], min(known), max(known))
    return real_range(row, top, bound=bound)


def _bounds(sweeps: Sequence[Sweep], curve: Curve) -> list[float]:
    """What a curve is nowhere below at each value, by the amplitudes it comes from; else nought."""
    if curve.what not in WATCHABLE:
        return [0.0] * int(np.prod(sweeps[0].shape))
    own = [_amplitudes(each, curve) for each in sweeps]
    return [float(greatest_sum(np.stack(rows, axis=-1))) for rows in zip(*own, strict=True)]


def _amplitudes(sweep: Sweep, curve: Curve) -> list[Complex]:
    """What bounds a curve at each value [row, part]."""
    out: list[Complex] = [np.zeros(0)] * int(np.prod(sweep.shape))
    for group in sweep.groups:
        spectrum = spectrum_of(group.sums, curve.what)
        if curve.order is None:
            rows = of_peak(spectrum)
        else:
            chosen = spectra.selected(spectrum, [curve.order])
            rows = of_order(chosen.forward[:, 0], chosen.backward[:, 0])
        for place, row in zip(group.rows, rows, strict=True):
            out[place] = row
    return out


def ranged_text(value: Ranged, unit: str, *, beside: float) -> str:
    """A result with its range and unit, in a sentence."""
    said = shown(unit, beside)
    sizes = [rough(float(abs(n)) * said.factor) for n in (value.value, value.low, value.high)]
    words = _("about {typical} ({low} to {high}, estimated)", **dict(zip(ENDS, sizes, strict=True)))
    return f"{words} {unit_text(said.unit)}"


def estimate_remarks(sweep: Sweep, bands: Sequence[Band | None] = ()) -> tuple[Remarks, ...]:
    """What is estimated, before everything else, and whether results have their ranges."""
    return doubt(sweep.engine) if any(bands) else typical_remarks(sweep.engine)
