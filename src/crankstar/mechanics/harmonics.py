"""What a unit mass, or a unit moment of inertia, at each moving part does in its group's frame.

The motion of a group of cylinders on one pin is worked out once, as if its cylinder axis were
vertical and its pin at top dead centre; `excitation` turns, delays and weighs it.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from crankstar.engine import motion
from crankstar.mechanics.mechanism import Mechanism
from crankstar.spectra import Complex, Real


class Harmonics(NamedTuple):
    """Force, moment and kinetic energy of unit bodies, [..., cylinder, k - 1], k = 1, 2, ...

    Force `with_angle` exp(i k psi) + `against_angle` exp(-i k psi); `moment` about the own shaft
    axis and `energy`, dT/dpsi, as `Re(c exp(i k psi))`.
    """

    with_angle: Complex
    against_angle: Complex
    moment: Complex
    energy: Complex


def bodies(machine: Mechanism) -> list[list[tuple[Harmonics, Real]]]:
    """Harmonics and masses (or inertias) of pistons, rods and big ends, where there are any."""
    moved = motion.resolved(machine.links)
    harmonics = [[(_of_mass(moved.piston), machine.reciprocating_mass)]]
    if np.any(machine.rod_mass):
        share = (machine.rod_centre / machine.links.rod_length)[..., None]
        centre = motion.Path(
            *(q + share * (p - q) for p, q in zip(moved.piston, moved.big_end, strict=True))
        )
        harmonics.append(
            [
                (_of_mass(centre), machine.rod_mass),
                (_of_inertia(moved.direction), machine.rod_inertia),
            ]
        )
    if np.any(machine.big_end_mass):
        harmonics.append([(_of_mass(moved.big_end), machine.big_end_mass)])
    return harmonics


def _of_mass(path: motion.Path) -> Harmonics:
    """Force -P'', moment Im(conj(P) force) and dT/dpsi = Re(conj(P') P'') of a unit mass."""
    moment = -np.imag(np.conj(path.place) * path.second)
    energy = np.real(np.conj(path.first) * path.second)
    place, first, second = (_greatest(part) for part in path)
    return Harmonics(
        *vector(-path.second, second),
        _signal(moment, place * second),
        _signal(energy, first * second),
    )


def _of_inertia(direction: motion.Path) -> Harmonics:
    """Moment -b'' and dT/dpsi = b' b'' of a unit inertia on a rod of bearing b."""
    rate = np.imag(np.conj(direction.place) * direction.first)
    bend = np.imag(np.conj(direction.place) * direction.second)
    first, second = _greatest(direction.first), _greatest(direction.second)
    none = np.zeros_like(direction.place)
    return Harmonics(
        *vector(none, second), _signal(-bend, second), _signal(rate * bend, first * second)
    )


def _greatest(values: Complex) -> Real:
    return np.abs(values).max(axis=-1, keepdims=True)


def vector(samples: Complex, scale: Real) -> tuple[Complex, Complex]:
    """Coefficients of exp(i k psi) and exp(-i k psi); rounding beside `scale` is zero."""
    # Up and right apart, so that a force along an axis stays exactly on it.
    up, right = (_signal(part, scale) / 2 for part in (np.real(samples), np.imag(samples)))
    return up + 1j * right, np.conj(up) + 1j * np.conj(right)


def _signal(samples: Real, scale: Real) -> Complex:
    """Amplitudes c of `Re(c exp(i k psi))`, k = 1, 2, ...; rounding beside `scale` is zero."""
    count = samples.shape[-1]
    amplitudes = 2 * np.fft.rfft(samples, axis=-1)[..., 1 : count // 2] / count
    return np.where(np.abs(amplitudes) > motion.TAIL * scale, amplitudes, 0.0)


def highest(unit: Harmonics) -> int:
    """The highest harmonic that is not rounding."""
    present = np.any(
        [np.any(values.reshape(-1, values.shape[-1]), axis=0) for values in unit], axis=0
    )
    return int(np.max(np.nonzero(present)[0], initial=0)) + 1
