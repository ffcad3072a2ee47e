"""An erratum over one turn, or over rod lengths: printed, derived, and by momentum."""

from __future__ import annotations

from math import pi
from typing import NamedTuple

import numpy as np

from crankstar.derive.algebra.evaluation import value
from crankstar.derive.algebra.formula import Formula
from crankstar.derive.errata import momentum
from crankstar.derive.errata.records import ErrataError, Erratum
from crankstar.files.catalog import load
from crankstar.language.messages import _
from crankstar.spectra import Real

SHORTEST, LONGEST = 0.75, 3.0
"""Rod lengths in strokes, shortest and longest built, between which series are compared."""


class Curves(NamedTuple):
    """Printed, derived and by momentum over crank angles, in the unit of the erratum.

    theta [sample] is in radians. `printed` is NaN where the source says nothing.
    """

    theta: Real
    printed: Real
    ours: Real
    momentum: Real


class SeriesErrors(NamedTuple):
    """By which share the printed and the true series, cut alike, miss the exact A_k.

    Over rods of `ratio` strokes [sample].
    """

    ratio: Real
    printed: Real
    ours: Real


def curves(erratum: Erratum, samples: int = 241) -> Curves:
    """The printed formula, the derived one and momentum over a turn, both ends included.

    Raises ErrataError for an erratum that is no sum over the engine.

    >>> from crankstar.derive.errata.reading import errata
    >>> drawn = curves(errata()[1], 5)
    >>> both = drawn.printed, drawn.ours
    >>> [round(float(np.abs(curve - drawn.momentum).max()), 6) for curve in both]
    [2.828427, 0.0]
    """
    if erratum.kind not in ("result", "step"):
        raise ErrataError(
            _(
                "{erratum} is not a sum over the parts of an engine, so it has no curves over a "
                "turn.",
                erratum=erratum.id,
            )
        )
    theta = np.linspace(0.0, 2 * pi, samples)
    judged = (judge(erratum) * np.exp(1j * erratum.order * theta)).real
    return Curves(
        theta, _printed(erratum, theta), _over(erratum.ours, theta, erratum.letter), judged
    )


def judge(erratum: Erratum) -> complex:
    """The complex amplitude of an erratum's quantity by momentum alone, in its unit."""
    engine = load(erratum.engine, changes=dict(erratum.changes))
    if erratum.quantity == "roll":
        return momentum.roll(engine, erratum.order)
    bearing = {"up": 0.0, "right": pi / 2}.get(erratum.component)
    if bearing is None:
        bearing = next(c.bearing for c in engine.cylinders if c.number == erratum.cylinders[0])
    return (
        momentum.component(engine, erratum.order, erratum.quantity, bearing, erratum.cylinders)
        / erratum.scale
    )


def _printed(erratum: Erratum, theta: Real) -> Real:
    if erratum.printed is not None:
        return _over(erratum.printed, theta, erratum.letter)
    out = np.full(theta.shape, np.nan)
    for degrees, size in erratum.points:
        out[np.isclose(theta, degrees * pi / 180, rtol=0, atol=1e-9)] = float(size)
    return out


def _over(written: Formula, theta: Real, letter: str) -> Real:
    """A formula over a turn, its length counted as 1."""
    symbols = {letter: 1.0} if letter else {}
    return np.array([value(written, symbols | {"theta": float(angle)}) for angle in theta])


def series_errors(erratum: Erratum, samples: int = 181) -> SeriesErrors:
    """Errors of the printed and the true series of A_k, equally long, at 0.75 to 3 strokes.

    Raises ErrataError for an erratum that is no series.

    >>> from crankstar.derive.errata.reading import errata
    >>> two = next(erratum for erratum in errata() if erratum.id == "series-2")
    >>> bool(np.all(np.abs(series_errors(two).ours) < np.abs(series_errors(two).printed)))
    True
    """
    if erratum.kind != "series" or erratum.printed is None:
        raise ErrataError(
            _(
                "{erratum} is not a series, so it has no curves over the length of the rod.",
                erratum=erratum.id,
            )
        )
    ratio = np.linspace(SHORTEST, LONGEST, samples)
    exact = momentum.harmonics(ratio, erratum.order)
    printed, ours = (
        np.array([value(written, {"L": float(length)}) for length in ratio]) / exact - 1
        for written in (erratum.printed, erratum.ours)
    )
    return SeriesErrors(ratio, printed, ours)
