"""Spectra over crank order: a periodic vector in the clock plane as pairs of turning vectors.

A vector in the clock plane (seen from the front of the engine) is the complex number
`up + i*right`. A periodic one is a sum over orders k of

    forward_k * exp(+i s k theta)  +  backward_k * exp(-i s k theta)

with theta the angle of the reference crankshaft in its own direction of rotation and s = +1 for
a crankshaft that turns clockwise, -1 for one that turns the other way. So *forward* always turns
with the crankshaft. A real signal (a roll, a torque) is the same thing with s = 1 and
backward = conj(forward); its amplitude c in `Re(c exp(i k theta))` is forward + conj(backward).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import lru_cache
from math import cos, lcm
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from crankstar.language.messages import MessageError

# Arrays of complex and of real numbers; numpy's own types do not follow mixed arithmetic.
Complex = NDArray[Any]
Real = NDArray[Any]

ROUNDING = 1e-13
"""A sum smaller than this share of the magnitudes it was added up from is rounding error."""


@dataclass(frozen=True)
class Spectrum:
    """Turning vectors by order: `orders` [n] ascending; `forward`, `backward` [..., n]; `sense`.

    An order that is not listed is zero if they are `complete`, else not known.
    """

    orders: Real
    forward: Complex
    backward: Complex
    sense: int = 1
    complete: bool = True

    def __getitem__(self, index: object) -> Spectrum:
        """The same spectrum for some of the leading axis: one part, or several."""
        forward, backward = self.forward[index], self.backward[index]  # pyright: ignore[reportArgumentType, reportCallIssue]
        return Spectrum(self.orders, forward, backward, self.sense, self.complete)


class Ellipse(NamedTuple):
    """The path of one order's vector over a turn.

    `bearing` of the long axis in radians in (-pi/2, pi/2]. `sense` is +1 where the vector turns
    with the crankshaft, -1 against it, 0 on a straight line or a point.
    """

    semi_major: float
    semi_minor: float
    bearing: float
    sense: int


class Peak(NamedTuple):
    """The greatest length of a vector over its period, its crank angle, the vector there."""

    value: float
    theta: float
    vector: complex


def real_signal(orders: Real, amplitude: Complex) -> Spectrum:
    """The spectrum of the real signal `Re(sum amplitude_k exp(i k theta))`."""
    return Spectrum(orders, amplitude / 2, np.conj(amplitude) / 2)


def amplitude(spectrum: Spectrum) -> Complex:
    """The complex amplitude c of a real signal `Re(c exp(i k theta))`, [..., n]."""
    return spectrum.forward + np.conj(spectrum.backward)


def total(spectrum: Spectrum) -> Spectrum:
    """The sum over the last leading axis (the parts), with what is only rounding error set to zero.

    >>> forward = np.array([[1.0 + 0j], [-1.0 + 1e-17j]])
    >>> two = Spectrum(np.array([1.0]), forward, np.zeros((2, 1), complex))
    >>> total(two).forward
    array([0.+0.j])
    """
    size = np.maximum(np.abs(spectrum.forward), np.abs(spectrum.backward))
    noise = ROUNDING * np.einsum("...pn->...n", size)

    def added(values: Complex) -> Complex:
        out = np.einsum("...pn->...n", values)
        return np.where(np.abs(out.real) <= noise, 0.0, out.real) + 1j * np.where(
            np.abs(out.imag) <= noise, 0.0, out.imag
        )

    return replace(spectrum, forward=added(spectrum.forward), backward=added(spectrum.backward))


def stacked(spectra: Sequence[Spectrum]) -> Spectrum:
    """Spectra of the same orders one above the other, along a new leading axis."""
    forward, backward = (
        np.stack([getattr(spectrum, name) for spectrum in spectra])
        for name in ("forward", "backward")
    )
    return replace(spectra[0], forward=forward, backward=backward)


def scaled(spectrum: Spectrum, factor: ArrayLike) -> Spectrum:
    """The spectrum with every vector times `factor`, a number or an array that fits [..., n]."""
    factors = np.asarray(factor)
    return replace(
        spectrum, forward=spectrum.forward * factors, backward=spectrum.backward * factors
    )


def turned(spectrum: Spectrum, bearing: float) -> Spectrum:
    """The spectrum with every vector turned clockwise by `bearing` radians."""
    return scaled(spectrum, np.exp(1j * bearing))


def shifted(spectrum: Spectrum, theta: float) -> Spectrum:
    """The spectrum of the signal delayed by `theta` radians: value(x) becomes value(x - theta)."""
    phase = np.exp(-1j * spectrum.sense * spectrum.orders * theta)
    return replace(spectrum, forward=spectrum.forward * phase, backward=spectrum.backward / phase)


def selected(spectrum: Spectrum, orders: ArrayLike) -> Spectrum:
    """The spectrum at the given orders, in the order given.

    One that a complete spectrum, or what is selected from one, has not is zero: no part of the
    engine has it. One of a spectrum that was computed for others raises MessageError.
    """
    wanted = checked(np.atleast_1d(np.asarray(orders, float)))
    hits = np.abs(spectrum.orders - wanted[:, None]) <= 1e-9
    absent = wanted[~hits.any(axis=1)]
    if absent.size and not spectrum.complete:
        raise MessageError(
            "order {order} was not computed; there are the orders {orders}",
            order=f"{absent[0]:g}",
            orders=", ".join(f"{order:g}" for order in spectrum.orders) or "-",
        )
    if not hits.size or (hits.sum(axis=1) > 1).any():  # of orders that are alike the sum
        chosen = hits.T.astype(float)
        forward, backward = spectrum.forward @ chosen + 0j, spectrum.backward @ chosen + 0j
    else:
        place, there = hits.argmax(axis=1), hits.any(axis=1)
        forward, backward = (
            np.where(there, values[..., place], 0j)
            for values in (spectrum.forward, spectrum.backward)
        )
    return replace(spectrum, orders=wanted, forward=forward, backward=backward)


def checked(orders: Real) -> Real:
    """Orders, 0 for what stands still. Raises MessageError for other numbers."""
    for order in orders[~((orders >= 0) & (orders < np.inf))]:
        raise MessageError(
            "{order} is no crank order; give numbers above 0, such as 1 or 2", order=f"{order:g}"
        )
    return orders


def value(spectrum: Spectrum, theta: ArrayLike) -> Complex:
    """The vector `up + i*right` at the crank angles `theta` (radians), [..., *theta.shape].

    Of equal steps over whole periods it is one Fourier transform.

    >>> circle = Spectrum(np.array([1.0]), np.array([2.0 + 0j]), np.array([0j]))
    >>> complex(np.round(value(circle, np.pi / 2), 12))  # a quarter turn on, it points right
    2j
    """
    angles = np.asarray(theta, float)
    turns = _whole_turns(angles) if spectrum.orders.size > FEW_ORDERS else 0
    places = turns * spectrum.orders
    if turns and np.abs(places - places.round()).max() <= ROUNDING * places.max():
        return _at_steps(spectrum, angles.size, turns)
    phase = np.exp(1j * spectrum.sense * spectrum.orders[:, None] * angles.reshape(1, -1))
    flat = spectrum.forward @ phase + spectrum.backward @ np.conj(phase)
    return flat.reshape(flat.shape[:-1] + angles.shape)


FEW_ORDERS, FEW_STEPS = 8, 128
"""Up to so many a sum over orders is as fast as a Fourier transform."""


def _whole_turns(angles: Real) -> int:
    """The turns of which crank angles are equal steps from 0 on; 0 where they are anything else."""
    if angles.ndim != 1 or angles.size < FEW_STEPS or angles[0] != 0:
        return 0
    turns = angles[1] * angles.size / (2 * np.pi)
    whole = round(turns)
    if whole < 1 or abs(turns - whole) > ROUNDING * whole:
        return 0
    steps = np.arange(angles.size) * (2 * np.pi * whole / angles.size)
    return whole if np.abs(angles - steps).max() <= ROUNDING * steps[-1] else 0


def over_period(spectrum: Spectrum, steps: int) -> Complex:
    """The vector at so many equal steps over its `period`, from theta = 0, [..., step].

    The same as `value` there, as one Fourier transform: an order beyond half the steps is taken at
    the steps as well.

    >>> two = real_signal(np.array([0.5, 3.0]), np.array([1.0 + 2j, 0.5j]))
    >>> theta = np.arange(4) * (np.pi * period(two) / 2)
    >>> bool(np.allclose(over_period(two, 4), value(two, theta), atol=1e-15))
    True
    """
    return _at_steps(spectrum, steps, period(spectrum))


def _at_steps(spectrum: Spectrum, steps: int, turns: int) -> Complex:
    """The vector at equal steps over turns that are whole periods, by a Fourier transform."""
    places = np.round(spectrum.orders * turns).astype(int)
    coefficients = np.zeros((*spectrum.forward.shape[:-1], steps), complex)
    np.add.at(coefficients.T, spectrum.sense * places % steps, spectrum.forward.T)
    np.add.at(coefficients.T, -spectrum.sense * places % steps, spectrum.backward.T)
    return np.fft.ifft(coefficients) * steps


def vertical(spectrum: Spectrum) -> Complex:
    """Complex amplitude c, `Re(c exp(i k theta))`, of the upward component, [..., n]."""
    forward, backward = _by_exponent(spectrum)
    return forward + np.conj(backward)


def horizontal(spectrum: Spectrum) -> Complex:
    """Complex amplitude c, `Re(c exp(i k theta))`, of the rightward component, [..., n]."""
    forward, backward = _by_exponent(spectrum)
    return -1j * (forward - np.conj(backward))


def _by_exponent(spectrum: Spectrum) -> tuple[Complex, Complex]:
    if spectrum.sense > 0:
        return spectrum.forward, spectrum.backward
    return spectrum.backward, spectrum.forward


def ellipse(forward: complex, backward: complex) -> Ellipse:
    """The ellipse two counter-rotating vectors draw: semi-axes |f|+|b| and ||f|-|b||.

    >>> ellipse(1.0, 1.0)
    Ellipse(semi_major=2.0, semi_minor=0.0, bearing=0.0, sense=0)
    >>> ellipse(1.5j, 0.5j).bearing == np.pi / 2  # both point right at once: that is the long axis
    True
    """
    with_crank, against = abs(forward), abs(backward)
    line = abs(with_crank - against) <= ROUNDING * (with_crank + against)
    sense = 0 if line else int(np.sign(with_crank - against))
    bearing = 0.0
    if min(with_crank, against) > ROUNDING * max(with_crank, against):
        bearing = float(np.angle(forward) + np.angle(backward)) / 2
        bearing = (
            np.pi / 2 - (np.pi / 2 - bearing) % np.pi
        )  # an axis has no head: keep (-pi/2, pi/2]
        bearing = 0.0 if abs(bearing) < ROUNDING else float(bearing)
    return Ellipse(
        float(with_crank + against),
        0.0 if line else float(abs(with_crank - against)),
        bearing,
        sense,
    )


def period(spectrum: Spectrum) -> int:
    """Turns of the crankshaft after which the signal repeats: the orders' common denominator."""
    return lcm(*map(_denominator, spectrum.orders.tolist()), 1)


@lru_cache(maxsize=4096)
def _denominator(order: float) -> int:
    return Fraction(order).limit_denominator(10_000).denominator


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


POINTS, POINTS_AT_MOST = 16, 1 << 22
"""Samples to one turn of the highest order, and in all; beyond that, a quarter as many."""
CANDIDATES = 256
SAMPLES_AT_ONCE = 1 << 18
EQUAL = 1e-11
"""Share within which peaks are equal."""
ALIKE = 1e-15
"""Share by which a maximum beside a sample is higher than the sample, if it is another."""
ROUNDING = 1e-9
"""Share by which a bound is widened, far more than what adding up rounds off."""
FLAT = 1e-13
"""A sample above its neighbours by less than this share of it needs no search beside it."""


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


def distinct(values: Real) -> Real:
    """The values in order, each once; np.unique would load numpy.ma, a fifth of all of NumPy."""
    return np.array(sorted(set(values.tolist())), values.dtype)


def _least(samples: int, highest: int) -> float:
    """The share of the peak that the sample nearest to it has, at least; of its highest harmonic.

    Of a trigonometric sum of degree n, f(at the peak + x) >= f(at the peak) cos(n x) for |n x| up
    to pi (M. Riesz); so it is for a vector along its direction at the peak.
    """
    return cos(np.pi * highest / samples) * (1 - ROUNDING)


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
