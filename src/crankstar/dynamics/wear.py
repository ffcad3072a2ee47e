"""Where journals and pins are loaded most and least over a cycle: wear, and the oil hole.

A load presses on the surface within 60 degrees to both sides of where it acts, evenly, as the wear
diagrams of the textbooks have it. Over a cycle the surface at the direction phi gets

    W(phi) = mean over theta of |L(theta)|, counted where |arg L(theta) - phi| < 60 deg        N

in the frame that turns with the shaft. The oil hole belongs where W is least; where W is greatest,
journal or pin wears. A main journal pushes its bearing with L and is pressed on the side to which L
points; rods push a crank pin with L, and it is pressed on the other side.

Source: A. Kolchin, V. Demidov, Design of Automotive Engines (1984), wear diagram of a crank pin.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import pi

import numpy as np

from crankstar import spectra
from crankstar.spectra import Complex, Real, Spectrum

SPREAD = pi / 3
"""Radians to each side of where a load acts, on which it presses."""
PLACES = 360
SAMPLES = 720
"""Crank angles in a turn."""
EVEN = 2e-3
"""Share of the mean of W within which places are pressed alike."""


@dataclass(frozen=True)
class Wear:
    """W [direction] in the unit of the load, at `bearing` [direction] (radians from -pi, at
    theta = 0, clockwise from up), and the mean size of the load over a cycle.

    `least` and `most` are the directions of its ends, the middle of a range; None where W is even.
    """  # noqa: D205

    bearing: Real
    pressed: Real
    mean: float
    least: float | None
    most: float | None


def wear(load: Spectrum, *, speed_ratio: float, inward: bool = False) -> Wear:
    """W of one load on a journal that turns `speed_ratio` times with the reference crankshaft.

    `inward`: the load pushes on it, as rods do on a crank pin; else it pushes with the load.

    A weight that turns with the journal presses it always at the same side:

    >>> turning = Spectrum(np.array([1.0]), np.array([2.0 + 0j]), np.array([0j]))
    >>> found = wear(turning, speed_ratio=1.0)
    >>> found.mean, found.most, abs(found.least or 0.0) > 3.1
    (2.0, 0.0, True)
    """
    turns = spectra.period(load)
    theta = np.arange(SAMPLES * turns) * (2 * pi / SAMPLES)
    vectors = spectra.over_period(load, theta.size) * np.exp(-1j * load.sense * speed_ratio * theta)
    vectors = -vectors if inward else vectors
    bearing = (np.arange(PLACES) - PLACES // 2) * (2 * pi / PLACES)
    pressed = _pressed(vectors, bearing)
    even = float(np.ptp(pressed)) <= EVEN * float(pressed.mean())
    return Wear(
        bearing,
        pressed,
        float(np.abs(vectors).mean()),
        None if even else _middle(bearing, pressed <= pressed.min() + EVEN * pressed.mean()),
        None if even else _middle(bearing, pressed >= pressed.max() - EVEN * pressed.mean()),
    )


def _pressed(vectors: Complex, bearing: Real) -> Real:
    """The mean of the sizes of the vectors that act within SPREAD of each direction.

    The share of a vector among the directions of its range is 1, at each end w and 1 - w, so wide
    that no single crank angle decides. Its differences are four, and the sum over all vectors of
    the differences, added up along the directions, is W: linear in the crank angles.
    """
    step = 2 * pi / bearing.size
    size = np.abs(vectors)
    at = (np.angle(vectors) - bearing[0]) / step
    half = SPREAD / step + 0.5
    wraps = int(np.ceil(half / bearing.size)) + 1
    last = np.floor(at + half - 1)  # of the directions that the whole of the vector presses
    first = np.ceil(at - half + 1)
    above, below = size * (at + half - 1 - last), size * (first - (at - half + 1))
    places = np.concatenate([first - 1, first, last + 1, last + 2]).astype(int)
    changes = np.concatenate([below, size - below, above - size, -above])
    width = (2 * wraps + 1) * bearing.size
    steps = np.bincount(places + wraps * bearing.size, weights=changes, minlength=width)
    summed = np.cumsum(steps)[:width].reshape(-1, bearing.size).sum(axis=0)
    return np.maximum(summed, 0.0) / size.size  # a sum of rounding is not less than nothing


def _middle(bearing: Real, within: Real) -> float:
    """The middle of the longest range of directions, round the circle, radians."""
    count = within.size
    if within.all():
        return 0.0
    start = int(np.flatnonzero(~within)[0])
    turned = np.roll(within, -start)
    edges = np.flatnonzero(np.diff(np.concatenate([[False], turned, [False]]).astype(int)))
    ranges = edges.reshape(-1, 2)
    low, high = ranges[int(np.argmax(ranges[:, 1] - ranges[:, 0]))]
    place = float(bearing[0]) + 2 * pi / count * (start + (int(low) + int(high) - 1) / 2)
    return float(np.angle(np.exp(1j * place)))
