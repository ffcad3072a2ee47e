"""One order of the negative rate of change of momentum, which judges formulas.

Only exact positions are used.

The places of pistons and rods come from `motion.rods` at the geometry of the engine, those of
turning masses from their angles; nothing is taken from the spectra of `mechanism`, nor from a
derivation. A body of mass m at p(theta) pushes on the block with

    F = -d(m v)/dt = -m w^2 p''(theta),     so that order k of F is m k^2 w^2 times order k of p.

The Fourier coefficient of p is the trapezoidal sum over a turn, which for a smooth periodic motion
is exact but for rounding [trefethen2014]. Source: Newton's second law.
"""

from __future__ import annotations

from math import fsum
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from crankstar.engine import motion
from crankstar.engine.engine import Engine
from crankstar.spectra import Complex, Real

FINE = 1 << 16
"""Samples a turn: rounding errors of the places average out to some 1e-17 of the crank radius."""
COARSE = 1 << 8
"""Samples a turn for moments, products of place and speed."""


class Body(NamedTuple):
    """A point mass: mass, place along the crankshaft, shaft axis, and path.

    `cylinder` is None where it turns with a shaft. `axis` and `path` are up + i right, the path
    relative to the axis, [sample]; SI units, or units of the engine where it gives none.
    """

    cylinder: int | None
    mass: float
    z: float
    axis: complex
    path: Complex


def bodies(engine: Engine, theta: Real) -> list[Body]:
    """Every body with a mass, at crank angles theta [sample] (radians) of the reference shaft."""
    links = motion.linkage(engine)
    out: list[Body] = []
    for index, cylinder in enumerate(engine.cylinders):
        chain = motion.chain(links.master, index)
        root = engine.cylinders[chain[0]]
        turned = (
            engine.throw(cylinder).angle + _turned(engine, cylinder.shaft, theta) - root.bearing
        )
        moved = motion.rods(motion.parted(links, chain), turned)
        frame = np.exp(1j * root.bearing)
        piston, joint, leaning = (
            frame * path.place[-1] for path in (moved.piston, moved.big_end, moved.direction)
        )
        axis = _axis(engine, cylinder.shaft)
        moving = [(cylinder.reciprocating_mass, piston), (cylinder.big_end_mass, joint)]
        if cylinder.rod is not None:
            moving.append((cylinder.rod.mass, joint + cylinder.rod.centre * leaning))
        out += [Body(cylinder.number, mass, cylinder.z, axis, path) for mass, path in moving]
    for shaft in engine.shafts:
        axis, turn = _axis(engine, shaft.name), _turned(engine, shaft.name, theta)
        for throw in shaft.throws:
            path = throw.radius * np.exp(1j * (throw.angle + turn))
            out.append(Body(None, throw.turning_mass, throw.z, axis, path))
        radius = (
            shaft.throws[0].radius if shaft.throws else 1.0
        )  # any: only mass times radius counts
        for weight in shaft.weights:
            path = radius * np.exp(1j * (weight.angle + turn))
            out.append(Body(None, weight.unbalance / radius, weight.z, axis, path))
    return [body for body in out if body.mass]


def _turned(engine: Engine, shaft: str, theta: Real) -> Real:
    return engine.sense * float(engine.shaft(shaft).speed_ratio) * theta


def _axis(engine: Engine, shaft: str) -> complex:
    axis = engine.shaft(shaft)
    return complex(axis.up, axis.right)


def _grid(count: int) -> Real:
    """Crank angles over a turn, each rounded by itself.

    A step that is too short in its last digit would add up.
    """
    turn = 8 * np.arctan(np.longdouble(1))
    return (np.arange(count, dtype=np.longdouble) * turn / count).astype(np.float64)


def amplitude(samples: NDArray[np.float64], order: int) -> complex:
    """The complex amplitude z of order k in samples x = ... + Re(z exp(i k theta)) over a turn.

    The sum is exact (fsum), and the angles k theta are reduced as whole numbers of steps: rounding
    in either, small as it is, would leak the first harmonic into the sixth.
    """
    steps = (np.arange(samples.size) * order + samples.size // 2) % samples.size - samples.size // 2
    turning = np.exp(-2j * np.pi / samples.size * steps)
    centred = samples - samples.mean()
    whole = complex(fsum(centred * np.real(turning)), fsum(centred * np.imag(turning)))
    return whole * 2 / samples.size


def harmonic(engine: Engine, order: int) -> float:
    """A_k of the first cylinder's piston, from its own motion."""
    first = engine.first
    links = motion.linkage(engine)
    index = engine.cylinders.index(first)
    piston = motion.rods(
        motion.parted(links, motion.chain(links.master, index)), _grid(FINE)
    ).piston.place[-1]
    along = np.real(piston * np.exp(-1j * links.bearing[index]))
    return order**2 * amplitude(along, order).real / engine.throw(first).radius


def harmonics(rod_over_stroke: Real, order: int) -> Real:
    """Exact A_k of centred cranks from piston positions, by rod length in strokes [...].

    >>> harmonics(np.array([2.0]), 2).round(12).tolist()
    [0.254025042307]
    """
    lengths = 2 * np.atleast_1d(rod_over_stroke)
    zero = np.zeros_like(lengths)
    links = motion.Linkage(zero + 1, lengths, zero, zero, zero, zero, (-1,) * lengths.size)
    paths = motion.rods(links, _grid(COARSE)).piston.place
    return order**2 * np.array([amplitude(np.real(path), order).real for path in paths])


def component(
    engine: Engine, order: int, quantity: str, bearing: float, cylinders: tuple[int, ...] = ()
) -> complex:
    """The complex amplitude of one order of the force or the couple along a bearing.

    The bearing is in radians clockwise from up. Counted in m r w^2 A_k (force) and m r w^2 A_k a
    (couple, about the middle of the cylinders' span), m and r of the first cylinder.
    `cylinders`: only what they do; none for all that moves.
    """
    places = [cylinder.z for cylinder in engine.cylinders]
    middle = (min(places) + max(places)) / 2
    whole = 0j
    for body in bodies(engine, _grid(FINE)):
        if cylinders and body.cylinder not in cylinders:
            continue
        arm = (body.z - middle) / engine.pitch if quantity == "couple" else 1.0
        along = np.real(body.path * np.exp(-1j * bearing))
        whole += body.mass * arm * order**2 * amplitude(along, order)
    return whole / (_unit(engine) * harmonic(engine, order))


def roll(engine: Engine, order: int) -> complex:
    """The complex amplitude of one order of the moment about the middle of the crankshafts.

    Clockwise. Minus the rate of change of angular momentum, m (right v_up - up v_right) counted
    counter-clockwise as here turned round; in m r w^2 A_k L, L the distance between the outermost
    shafts.
    """
    rights = [shaft.right for shaft in engine.shafts]
    middle, distance = (min(rights) + max(rights)) / 2, max(rights) - min(rights)
    whole = 0j
    for body in bodies(engine, _grid(COARSE)):
        place = body.axis + body.path - 1j * middle
        speed = np.fft.ifft(np.fft.fft(place) * 1j * np.fft.fftfreq(COARSE, 1 / COARSE))
        clockwise = place.real * speed.imag - place.imag * speed.real
        whole -= body.mass * 1j * order * amplitude(clockwise, order)
    return whole / (_unit(engine) * harmonic(engine, order) * distance)


def _unit(engine: Engine) -> float:
    """M r of the first cylinder, w being 1."""
    first = engine.first
    return first.reciprocating * engine.throw(first).radius
