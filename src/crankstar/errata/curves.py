"""An erratum over one turn, or over rod lengths: what is printed, what we derive, and what momentum says."""

from __future__ import annotations

from math import pi
from typing import NamedTuple

import numpy as np

from crankstar.catalog import load
from crankstar.derive import formula
from crankstar.errata import momentum
from crankstar.errata.records import ErrataError, Erratum
from crankstar.phasor import Real

SHORTEST, LONGEST = 0.75, 3.0
"""Rods in strokes, between which the series are compared: from the shortest that are built to the longest."""


class Curves(NamedTuple):
    """Over crank angles theta [sample] (radians): printed, ours, and the judge, all in the unit of the erratum.

    `printed` is NaN where the source says nothing.
    """

    theta: Real
    printed: Real
    ours: Real
    momentum: Real


class SeriesErrors(NamedTuple):
    """Over rods of `ratio` strokes [sample]: by which share the printed and the true series, cut alike, miss the exact A_k."""

    ratio: Real
    printed: Real
    ours: Real


def curves(erratum: Erratum, samples: int = 241) -> Curves:
    """What is printed, what we derive and what momentum says at `samples` crank angles from 0 to a full turn, both included.

    Raises ErrataError for an erratum that is no sum over the engine.

    >>> from crankstar.errata.reading import errata
    >>> found = curves(errata()[1], 5)
    >>> [round(float(np.abs(curve - found.momentum).max()), 6) for curve in (found.printed, found.ours)]
    [2.828427, 0.0]
    """
    if erratum.kind not in ("result", "step"):
        raise ErrataError(f"{erratum.id} is no sum over the parts of an engine, so there are no curves over a turn")
    theta = np.linspace(0.0, 2 * pi, samples)
    judged = (judge(erratum) * np.exp(1j * erratum.order * theta)).real
    return Curves(theta, _printed(erratum, theta), _over(erratum.ours, theta, erratum.letter), judged)


def judge(erratum: Erratum) -> complex:
    """The complex amplitude of an erratum's quantity by momentum alone, in its unit."""
    engine = load(erratum.engine, changes=dict(erratum.changes))
    if erratum.quantity == "roll":
        return momentum.roll(engine, erratum.order)
    bearing = {"up": 0.0, "right": pi / 2}.get(erratum.component)
    if bearing is None:
        bearing = next(c.bearing for c in engine.cylinders if c.number == erratum.cylinders[0])
    return momentum.component(engine, erratum.order, erratum.quantity, bearing, erratum.cylinders) / erratum.scale


def _printed(erratum: Erratum, theta: Real) -> Real:
    if erratum.printed is not None:
        return _over(erratum.printed, theta, erratum.letter)
    out = np.full(theta.shape, np.nan)
    for degrees, value in erratum.points:
        out[np.isclose(theta, degrees * pi / 180, rtol=0, atol=1e-9)] = float(value)
    return out


def _over(written: formula.Formula, theta: Real, letter: str) -> Real:
    """A formula over a turn, its length counted as 1."""
    symbols = {letter: 1.0} if letter else {}
    return np.array([formula.value(written, symbols | {"theta": float(angle)}) for angle in theta])


def series_errors(erratum: Erratum, samples: int = 181) -> SeriesErrors:
    """By how much the printed and the true series of A_k miss the exact one, for rods of 0.75 to 3 strokes.

    Both have as many terms. Raises ErrataError for an erratum that is no series.

    >>> from crankstar.errata.reading import errata
    >>> two = next(one for one in errata() if one.id == "series-2")
    >>> bool(np.all(np.abs(series_errors(two).ours) < np.abs(series_errors(two).printed)))
    True
    """
    if erratum.kind != "series" or erratum.printed is None:
        raise ErrataError(f"{erratum.id} is no series, so it has no curves over the rod's length")
    ratio = np.linspace(SHORTEST, LONGEST, samples)
    exact = momentum.harmonics(ratio, erratum.order)
    printed, ours = (
        np.array([formula.value(written, {"L": float(length)}) for length in ratio]) / exact - 1
        for written in (erratum.printed, erratum.ours)
    )
    return SeriesErrors(ratio, printed, ours)
