"""The greatest length of periodic vectors over their period."""

from __future__ import annotations

from dataclasses import replace
from math import cos
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from crankstar.spectra.spectrum import Complex, Real, Spectrum, distinct, over_period, period

POINTS = 16
"""Samples to one turn of the highest order; a quarter as many where there were too many."""
POINTS_AT_MOST = 1 << 22
"""Samples in all."""
CANDIDATES = 256
"""Samples beside which a peak is looked for."""
SAMPLES_AT_ONCE = 1 << 18
"""Samples of a batch that are held at a time."""
EQUAL = 1e-11
"""Share within which peaks are equal."""
ALIKE = 1e-15
"""Share by which a maximum beside a sample is higher than the sample, if it is another."""
WIDER = 1e-9
"""Share by which a bound is widened, far more than what adding up rounds off."""
FLAT = 1e-13
"""A sample above its neighbours by less than this share of it needs no search beside it."""


class Peak(NamedTuple):
    """The greatest length of a vector over its period, its crank angle, the vector there."""

    value: float
    theta: float
    vector: complex


def peak(spectrum: Spectrum) -> Peak:
    """The greatest length of the vector over its period, to machine precision; the first of equals.

    Samples over the period show where it can be; Newton's method on |v|^2 goes from each of these
    to the maximum beside it.
    """
    return tops(spectrum[None])[0]


def tops(spectrum: Spectrum) -> list[Peak]:
    """The `peak` of every vector of a batch [vector, n]."""
    out = [Peak(0.0, 0.0, 0j)] * len(spectrum.forward)
    moving = np.flatnonzero((spectrum.forward != 0).any(-1) | (spectrum.backward != 0).any(-1))
    if not moving.size:
        return out
    spectrum = spectrum[moving]
    period_angle = 2 * np.pi * period(spectrum)
    samples, least = _over_period(spectrum)
    step = period_angle / samples.shape[-1]
    near = [_candidates(lengths, least) for lengths in np.abs(samples)]
    rows = np.repeat(np.arange(len(near)), [places.size for places in near])
    starts, own = np.concatenate(near) * step, spectrum[rows]
    # Between two maxima close together lies a minimum: go from it to either side.
    maxima = [_maxima(own, starts, step, side=side).theta for side in (1, -1)]
    theta, rows = np.concatenate([starts, *maxima]) % period_angle, np.tile(rows, 3)
    theta = np.where(period_angle - theta < 1e-9, 0.0, theta)
    lengths = np.abs(_derivatives(spectrum[rows], theta)[0])
    # A sample counts where no maximum beside it is higher, but by rounding.
    beside = lengths.reshape(3, -1)
    beside[0, beside[0] * (1 + ALIKE) < beside[1:].max(axis=0)] = -1.0
    greatest = np.zeros(moving.size)
    np.maximum.at(greatest, rows, lengths)
    # Equal peaks differ by rounding, and by how near Newton's method came: take the first.
    first, high = np.full(moving.size, np.inf), lengths >= greatest[rows] * (1 - EQUAL)
    np.minimum.at(first, rows[high], theta[high])
    first = np.where(first < 1e-9, 0.0, first)
    for row, angle, here in zip(moving, first, _derivatives(spectrum, first)[0], strict=True):
        out[row] = Peak(abs(complex(here)), float(angle), complex(here))
    return out


def _over_period(spectrum: Spectrum) -> tuple[Complex, float]:
    """The vector at equal steps over the period [..., step], fine enough for its highest order.

    And the share of the peak that the highest of these has, at least.
    """
    highest = _highest(spectrum)
    samples = _steps(highest)
    return over_period(spectrum, samples), _least(samples, highest)


def _highest(spectrum: Spectrum) -> int:
    """The highest harmonic of the period."""
    return round(float(spectrum.orders.max()) * period(spectrum))


def _steps(highest: int) -> int:
    """The number of samples over the period for its highest harmonic."""
    return (POINTS if (highest + 4) * POINTS < POINTS_AT_MOST else POINTS // 4) * (highest + 4)


def _least(samples: int, highest: int) -> float:
    """The share of the peak that the sample nearest to it has, at least; of its highest harmonic.

    Of a trigonometric sum of degree n, f(at the peak + x) >= f(at the peak) cos(n x) for |n x| up
    to pi (M. Riesz); so it is for a vector along its direction at the peak.
    """
    return cos(np.pi * highest / samples) * (1 - WIDER)


def _candidates(lengths: Real, least: float) -> NDArray[np.int_]:
    """The samples beside which the peak can be: local maxima near the highest, and the first."""
    local = (
        (lengths >= np.roll(lengths, 1))
        & (lengths >= np.roll(lengths, -1))
        & (lengths >= least * lengths.max())
    )
    strongest = np.flatnonzero(local)
    strongest = strongest[np.argsort(-lengths[strongest], kind="stable")][:CANDIDATES]
    return distinct(np.append(strongest, np.argmax(lengths >= lengths.max() * (1 - 1e-9))))


def peaks(spectrum: Spectrum) -> Real:
    """The greatest length over the period of every vector of a batch [...], as `peak` finds it.

    Never more than the true value, and less by 1e-9 of it at most.

    >>> forward, backward = np.array([[1.0 + 0j], [2j]]), np.array([[1.0 + 0j], [1.0 + 0j]])
    >>> lines = Spectrum(np.array([1.0]), forward, backward)
    >>> peaks(lines).round(12).tolist()
    [2.0, 3.0]
    """
    lead = spectrum.forward.shape[:-1]
    if spectrum.orders.size == 0 or 0 in lead:
        return np.zeros(lead)
    forward, backward = (
        values.reshape(-1, spectrum.orders.size) for values in (spectrum.forward, spectrum.backward)
    )
    block = max(1, SAMPLES_AT_ONCE // _steps(_highest(spectrum)))
    blocks = [slice(start, start + block) for start in range(0, len(forward), block)]
    values = [
        _peaks(replace(spectrum, forward=forward[rows], backward=backward[rows])) for rows in blocks
    ]
    return np.concatenate(values).reshape(lead)


def _peaks(spectrum: Spectrum) -> Real:
    """The peaks of a few vectors [row]: the highest sample, and the maxima near all high ones."""
    samples, least = _over_period(spectrum)
    squared = np.abs(samples) ** 2
    before, after = np.roll(squared, 1, axis=-1), np.roll(squared, -1, axis=-1)
    highest = squared.max(axis=-1)
    local = (
        (squared >= before) & (squared >= after) & (2 * squared - before - after > FLAT * squared)
    )
    rows, places = np.nonzero(local & (squared >= least**2 * highest[:, None]))
    step = 2 * np.pi * period(spectrum) / squared.shape[-1]
    greatest = np.sqrt(highest)
    right = _maxima(spectrum[rows], places * step, step, side=1)
    np.maximum.at(greatest, rows, right.length)
    rows, places = rows[right.hollow], places[right.hollow]
    left = _maxima(spectrum[rows], places * step, step, side=-1)
    np.maximum.at(greatest, rows, left.length)
    return greatest


class _Maxima(NamedTuple):
    """Maxima of length found from starting angles, one per row.

    `theta` where the search ended (radians), `length` the greatest on the way, `hollow` whether it
    began beside a minimum.
    """

    theta: Real
    length: Real
    hollow: NDArray[np.bool_]


def _maxima(spectrum: Spectrum, starts: Real, step: float, *, side: int) -> _Maxima:
    """Newton's method on the derivative of |v|^2 from each start, kept within a step of it.

    The spectrum is one, or one per start [start, n]. Between two maxima the search goes to the one
    on the given `side`; where the length is constant it stays.
    """
    theta, length = starts.astype(float), np.zeros(starts.size)
    hollow = np.zeros(starts.size, bool)
    going, each = np.arange(starts.size), spectrum.forward.ndim > 1
    for _ in range(16):
        own = spectrum[going] if each else spectrum
        here, slope, bend = _derivatives(own, theta[going])
        length[going] = np.maximum(length[going], np.abs(here))
        gradient = np.real(np.conj(here) * slope)
        curvature = np.abs(slope) ** 2 + np.real(np.conj(here) * bend)
        between = curvature > FLAT * np.abs(here) * np.abs(bend)
        hollow[going] |= between
        steep = (curvature < 0) & (np.abs(gradient) > 1e-15 * np.abs(here) ** 2)
        to_maximum = -gradient / np.where(steep, curvature, 1.0)
        move = np.where(steep, to_maximum, np.where(between, side * step / 4, 0.0))
        ahead = np.clip(theta[going] + move, starts[going] - step, starts[going] + step)
        far = np.abs(ahead - theta[going]) > 1e-6 * step
        theta[going] = ahead
        going = going[far]
        if not going.size:
            break
    return _Maxima(theta, length, hollow)


def _derivatives(spectrum: Spectrum, theta: Real) -> list[Complex]:
    """The vector and its two derivatives by theta, of one spectrum at each angle or row by row."""
    rate = 1j * spectrum.sense * spectrum.orders
    phase = np.exp(rate * theta[:, None])
    with_crank, against = spectrum.forward * phase, spectrum.backward * np.conj(phase)
    both, apart = with_crank + against, with_crank - against
    return [both.sum(axis=-1), (rate * apart).sum(axis=-1), (rate**2 * both).sum(axis=-1)]
