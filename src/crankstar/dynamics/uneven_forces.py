"""Forces and couples of an engine that turns unevenly.

Let p(theta) be the momentum of all that moves at 1 rad/s of the crankshaft. The force on the block
is minus the change of momentum, whatever the speed w(theta) does:

    F = -d(p w)/dt = -p' w^2 - p w w'       N, a prime for d/dtheta

The first term is what a Balance has, F = f w^2, and p = -integral of f. The second is there only
where the speed changes. Couples follow the same law with z p. Both are read over time, as a
vibration pickup hears them: order k is k times per turn at the mean speed.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from crankstar import spectra
from crankstar.dynamics.uneven import Running
from crankstar.engine.engine import Engine
from crankstar.mechanics.balance import balance, total
from crankstar.spectra import Complex, Real, Spectrum

WORTH_TELLING = 0.01
"""Share of the greatest order of a quantity from which a change is told."""
HIGHEST = 8.0


class Change(NamedTuple):
    """An order of force or couple: its greatest value at even speed and at the uneven one, SI."""

    quantity: str
    order: float
    even: float
    uneven: float


def uneven_spectrum(steady: Spectrum, running: Running) -> Spectrum:
    """A force or couple over time at uneven speed, from its spectrum at the mean speed.

    The orders are those of the working cycle. At even speed it is what it was:

    >>> from dataclasses import replace
    >>> from crankstar import load, total
    >>> from crankstar.mechanics.balance import balance
    >>> from crankstar.dynamics.uneven import running
    >>> from crankstar.mechanics.gas import cycle
    >>> engine = load("audi-25-tfsi")
    >>> even = running(engine, cycle(engine, speed=300.0), flywheel=1e6)
    >>> couple = total(balance(engine, speed=300.0)).couple
    >>> again = spectra.selected(uneven_spectrum(couple, even), couple.orders)
    >>> bool(np.allclose(again.forward, couple.forward, atol=1e-4 * abs(couple.forward).max()))
    True
    """
    from scipy.interpolate import CubicSpline

    theta, speed, mean = running.theta, running.speed, running.mean_speed
    step = float(theta[1] - theta[0])
    count = theta.size
    kept = _of_cycle(steady.orders, count * step)
    orders = steady.orders[kept]
    turn = 1j * steady.sense * orders
    waves = np.exp(np.outer(theta, turn))
    forward, backward = steady.forward[kept], steady.backward[kept]
    even = waves @ forward + np.conj(waves) @ backward
    momentum = waves @ (-forward / turn) + np.conj(waves) @ (backward / turn)
    rising = _slope(speed, step)
    force = (even * speed - momentum * rising) * speed / mean**2
    time = _times(speed, step)
    whole = CubicSpline(
        np.append(time, time[0] + count * step / mean),
        np.append(force, force[0]),
        bc_type="periodic",
    )
    at = np.arange(count) * (step / mean)
    lines = np.fft.fft(whole(at)) / count
    numbers = np.arange(1, int(HIGHEST * count * step / (2 * np.pi)) + 1)
    first, second = lines[numbers], lines[-numbers]
    if steady.sense < 0:
        first, second = second, first
    return Spectrum(numbers * (2 * np.pi / (count * step)), first, second, steady.sense)


def changes(engine: Engine, running: Running) -> tuple[Change, ...]:
    """Every order of force and couple at even speed and at the uneven one."""
    sums = total(balance(engine, speed=running.mean_speed))
    out: list[Change] = []
    for name in ("force", "couple"):
        steady: Spectrum = getattr(sums, name)
        if not steady.orders.size:
            continue
        uneven = uneven_spectrum(steady, running)
        even = spectra.selected(steady, uneven.orders)
        before, after = spectra.peaks(_split(even)), spectra.peaks(_split(uneven))
        out += [
            Change(name, float(order), float(a), float(b))
            for order, a, b in zip(uneven.orders, before, after, strict=True)
        ]
    return tuple(out)


def worth_telling(changed: Sequence[Change]) -> list[tuple[str, float]]:
    """The orders that change by more than 1 % of the greatest order of the same quantity."""
    out: list[tuple[str, float]] = []
    for name in ("force", "couple"):
        own = [each for each in changed if each.quantity == name]
        least = WORTH_TELLING * max((each.even for each in own), default=0.0)
        out += [(name, e.order) for e in own if least > 0 and abs(e.uneven - e.even) > least]
    return out


def _split(spectrum: Spectrum) -> Spectrum:
    """Each order as a part of its own."""
    return Spectrum(
        spectrum.orders, np.diag(spectrum.forward), np.diag(spectrum.backward), spectrum.sense
    )


def _of_cycle(orders: Real, cycle: float) -> Real:
    """Which orders come back after a cycle."""
    turns = orders * cycle / (2 * np.pi)
    return np.abs(turns - np.round(turns)) < 1e-9


def _slope(values: Real, step: float) -> Real:
    """The derivative of a periodic function."""
    numbers = np.fft.fftfreq(values.size, step / (2 * np.pi))
    wave: Complex = np.fft.fft(values) * 1j * numbers
    return np.real(np.fft.ifft(wave))


def _times(speed: Real, step: float) -> Real:
    """When each crank angle is passed, seconds from that of theta = 0.

    The integral of 1/w: its mean exactly, the rest harmonic by harmonic.
    """
    slowness = 1 / speed
    wave = np.fft.fft(slowness)
    numbers = np.fft.fftfreq(speed.size, step / (2 * np.pi))
    mean = float(np.real(wave[0])) / speed.size
    wave[0] = 0
    wave[1:] /= 1j * numbers[1:]
    ripple = np.real(np.fft.ifft(wave))
    return np.arange(speed.size) * step * mean + ripple - ripple[0]
