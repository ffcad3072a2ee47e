"""The rolling moment of an order on the block, and what a turning force adds by its place."""

from __future__ import annotations

from fractions import Fraction

import numpy as np

from crankstar import spectra
from crankstar.engine.engine import Engine
from crankstar.engine.records import Shaft
from crankstar.mechanics.excitation import Reference, part_spectra, rolling_moment, total
from crankstar.mechanics.mechanism import mechanism
from crankstar.remedy.kept import vectors
from crankstar.spectra import Spectrum

ZERO = 1e-9
"""Share of the roll without shafts, of a box, or of the weights of a shaft, that is rounding."""


def push(shaft: Shaft) -> complex:
    """The force of the weights of a shaft at 1 rad/s of the reference crankshaft, N, at theta = 0.

    Up + i right.
    """
    own = vectors(shaft.weights)
    net = sum(own, 0j)
    if abs(net) <= ZERO * sum(map(abs, own)):
        return 0j  # a couple
    return float(shaft.speed_ratio) ** 2 * net


def roll(engine: Engine, order: Fraction, reference: Reference) -> complex:
    """The rolling moment of an order on the block at 1 rad/s: the c of Re(c exp(i k theta))."""
    whole = rolling_moment(total(part_spectra(mechanism(engine), reference=reference)))
    return complex(spectra.amplitude(spectra.selected(whole, [float(order)]))[0])


def roll_of(engine: Engine, *, force: complex, ratio: Fraction, place: complex) -> complex:
    """Amplitude of the roll about the crankshaft of a force that turns at a ratio, at a place."""
    vector, none = np.array([force]), np.zeros(1, complex)
    ahead = ratio > 0
    turning = Spectrum(
        np.array([abs(float(ratio))]),
        vector if ahead else none,
        none if ahead else vector,
        engine.sense,
    )
    return complex(spectra.horizontal(spectra.scaled(turning, np.conj(place)))[0])
