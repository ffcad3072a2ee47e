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
from math import lcm
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from crankstar.language.messages import MessageError

# Arrays of complex and of real numbers; numpy's own types do not follow mixed arithmetic.
Complex = NDArray[Any]
Real = NDArray[Any]

ROUNDING = 1e-12
"""A sum smaller than this share of the magnitudes it was added up from is rounding error."""
THIN = 1e-9
"""An ellipse is a line where one axis is smaller than this share of the other."""


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
    line = abs(with_crank - against) <= THIN * (with_crank + against)
    sense = 0 if line else int(np.sign(with_crank - against))
    bearing = 0.0
    if min(with_crank, against) > THIN * max(with_crank, against):
        bearing = float(np.angle(forward) + np.angle(backward)) / 2
        bearing = (
            np.pi / 2 - (np.pi / 2 - bearing) % np.pi
        )  # an axis has no head: keep (-pi/2, pi/2]
        bearing = 0.0 if abs(bearing) < THIN else float(bearing)
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


def distinct(values: Real) -> Real:
    """The values in order, each once; np.unique would load numpy.ma, a fifth of all of NumPy."""
    return np.array(sorted(set(values.tolist())), values.dtype)
