"""The reaction of a driven machine on the frame that it is fixed to, of a load with a course.

With s the sense of rotation the block rolls by M = axis moment - s (T_inertia + T_gas), wherever
the load is (`gas_torque`). A driven machine that takes the torque T_L(theta) of the shaft is turned
by it in the sense of rotation, so that a frame of both feels

    M + s T_L = axis moment - s J dw/dt,      J dw/dt = T_inertia + T_gas - T_L        N m

that is what the rotor takes, and no more. Of the load its alternating part counts, at even speed:

    T_L = (T_mean - T_f) g(theta)/mean(g)

with g the course of the file (`drive.load_torque`), straight between its values, T_mean the mean
torque of the gas and T_f what friction takes of it where the file says so
(`uneven.friction_apart`). A steady load has none, whatever its exponent; nor does one for which
nothing is left, or with an engine that is turned from outside (`uneven.load_taken`).
"""

from __future__ import annotations

import numpy as np

from crankstar import spectra
from crankstar.dynamics.uneven import friction_apart, load_taken
from crankstar.engine.drive import Drive, mean_share
from crankstar.engine.engine import Engine
from crankstar.mechanics.gas import Cycle
from crankstar.mechanics.gas_torque import HIGHEST, added, gas_torque
from crankstar.spectra import Complex, Real, Spectrum

ROUNDING = 1e-12
"""Share of the largest order below which an order of a course is a rounding error."""
NARROW = 1e-9
"""Share of a cycle below which a piece of a course is a jump: from its last angle to its first."""


def load_reaction(engine: Engine, cycle: Cycle) -> Spectrum | None:
    """The alternating reaction of the driven machine on its own frame, N m; None of a steady load.

    >>> from crankstar import cycle, load
    >>> course = {"load_torque": [2, 0], "load_angle": ["0 deg", "360 deg"]}
    >>> five = load("audi-25-tfsi", changes={"drive": course})
    >>> idle = cycle(five, speed="800 rpm", imep="2 bar")
    >>> load_reaction(five, idle).orders[:2].tolist(), load_reaction(load("audi-25-tfsi"), idle)
    ([0.5, 1.0], None)
    """
    drive = load_taken(engine, cycle)
    if drive is None:
        return None
    period = cycle.volumes.cycle
    orders = np.arange(1, int(HIGHEST * period / (2 * np.pi)) + 1) * (2 * np.pi / period)
    wave = _of_course(drive, orders, period)
    wave = np.where(np.abs(wave) > ROUNDING * np.abs(wave).max(), wave, 0)
    mean = float(gas_torque(cycle).mean.sum()) - friction_apart(cycle)
    return spectra.real_signal(orders, engine.sense * mean * wave)


def on_one_frame(roll: Spectrum, engine: Engine, cycle: Cycle) -> Spectrum:
    """The rolling moment on a frame of engine and driven machine, from that on the engine, N m."""
    reaction = load_reaction(engine, cycle)
    return roll if reaction is None else added(roll, reaction)


def _of_course(drive: Drive, orders: Real, period: float) -> Complex:
    """The amplitudes of g/mean(g) [order], each straight piece of the course integrated exactly.

    Of g exp(-i k theta) over a piece of the slope s: [i/k g exp(-i k theta) + s/k^2 exp(-i k
    theta)] from its start to its end.
    """
    angle = np.array([*drive.load_angle, drive.load_angle[0] + period])
    peak = max(map(abs, drive.load_torque))
    load = np.array([*drive.load_torque, drive.load_torque[0]]) / peak
    width = np.diff(angle)
    wide = width > NARROW * period
    slope = np.where(wide, np.diff(load), 0.0) / np.where(wide, width, 1.0)
    turned = np.exp(-1j * np.outer(orders, angle))
    k = orders[:, None]
    pieces = 1j / k * np.diff(load * turned) + slope / k**2 * np.diff(turned)
    out: Complex = 2 * pieces[:, wide].sum(axis=1) / (mean_share(drive, period) * period)
    return out
