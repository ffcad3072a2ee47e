"""The pressure of a gas whose gamma follows its temperature, and whose heat goes to the walls.

    dp = -gamma p dV/V + (gamma - 1)/V (dQ_b - dQ_w),   T = p V/(m R)
    dQ_w/dt = h A (T - T_w),   h = 130 V^-0.06 p^0.8 T^-0.4 (c_m + 1.4)^0.8   W/(m^2 K)

(V in m^3, p in bar, T in K, mean piston speed c_m in m/s), A being piston, head of the same area
and liner; integrated by the classical Runge-Kutta method over the closed chamber and its blow-down.

Sources: G. F. Hohenberg, SAE 790825 (1979), heat transfer; M. F. J. Brunt, H. Rai, A. L. Emtage,
SAE 981052 (1998), gamma of the temperature.
"""

from __future__ import annotations

from collections.abc import Callable
from math import pi
from typing import NamedTuple

import numpy as np

from crankstar.mechanics.heat_release import Events, Grid, Parts, Release, placed, volume_at
from crankstar.spectra import Real

GAS_CONSTANT = 287.0
"""Of air, J/(kg K)."""
COLDEST, HOTTEST = 300.0, 3000.0
"""K: for these gamma of the temperature was found."""
GREATEST = 1e10
"""Pa: a pressure beyond is none."""
COARSE = 4
"""Samples to a step of the integration."""


class Charge(NamedTuple):
    """The charge: pressures (Pa), temperatures (K), bore and stroke (m), piston speed (m/s).

    `wall` is None where no heat goes to the walls; `gamma` None where it follows the temperature.
    """

    intake: float
    exhaust: float
    temperature: float
    bore: float
    stroke: float
    piston_speed: float
    wall: float | None = None
    gamma: float | None = None


def gamma_of(temperature: float) -> float:
    """The ratio of specific heats of a charge at a temperature (K), 300 to 3000 K.

    Beyond them it stays as it is there: the parabola would rise again.

    >>> round(gamma_of(1000.0), 3)
    1.288
    """
    within = min(max(temperature, COLDEST), HOTTEST)
    return 1.338 - 6.0e-5 * within + 1.0e-8 * within**2


def film_coefficient(
    *, volume: float, pressure: float, temperature: float, piston_speed: float
) -> float:
    """Hohenberg's coefficient of heat transfer, W/(m^2 K); m^3, Pa, K, m/s.

    >>> round(film_coefficient(volume=1e-4, pressure=50e5, temperature=2000.0, piston_speed=10.0))
    1731
    """
    moved = (pressure / 1e5) ** 0.8 * (piston_speed + 1.4) ** 0.8
    return 130 * volume**-0.06 * temperature**-0.4 * moved


def real_pressure(
    grid: Grid, events: Events, release: Release, charge: Charge, *, heat: float
) -> Real:
    """The pressure, Pa [sample], with a heat per cycle (J); raises ArithmeticError without one."""
    parts = placed(grid, events)
    closed = _closed(grid, events, release, charge, heat, parts)
    out = np.empty_like(grid.volume)
    out[parts.where] = parts.free * closed + (1 - parts.free) * charge.exhaust
    out[parts.rest] = parts.filled * charge.intake + (1 - parts.filled) * charge.exhaust
    return out


def _closed(
    grid: Grid, events: Events, release: Release, charge: Charge, heat: float, parts: Parts
) -> Real:
    """The pressure of the closed chamber at the angles of its samples, Pa."""
    from scipy.interpolate import CubicHermiteSpline

    start = volume_at(grid, events.closed)
    mass = charge.intake * start / (GAS_CONSTANT * charge.temperature)
    knots = np.append(parts.angle[::COARSE], parts.angle[-1] + grid.step)
    ends = [*parts.where, (parts.where[-1] + 1) % grid.volume.size]
    volume = CubicHermiteSpline(
        np.append(parts.angle, knots[-1]), grid.volume[ends], grid.rate[ends]
    )
    thirds = knots[:-1, None] + np.diff(knots)[:, None] * np.array([0.0, 0.5, 1.0])
    slope = _slope(charge, mass, volume(thirds), volume(thirds, 1), heat * _rates(release, thirds))
    gamma = charge.gamma or gamma_of(charge.temperature)
    pressure = charge.intake * (start / float(volume(knots[0]))) ** gamma
    found, slopes = [pressure], [slope(pressure, 0, 0)]
    for row, width in enumerate(np.diff(knots).tolist()):
        one = slope(pressure, row, 0)
        two = slope(pressure + width / 2 * one, row, 1)
        three = slope(pressure + width / 2 * two, row, 1)
        four = slope(pressure + width * three, row, 2)
        pressure += width / 6 * (one + 2 * two + 2 * three + four)
        if not 0 < pressure < GREATEST:
            raise ArithmeticError(pressure)
        found.append(pressure)
        slopes.append(slope(pressure, row, 2))
    return CubicHermiteSpline(knots, found, slopes)(parts.angle)


def _rates(release: Release, thirds: Real) -> Real:
    """The share of heat per radian [step, third], so that every step releases exactly its share.

    Wiebe's rate ends with a jump, and a short release falls between the places of a step; where
    the rule of the step misses a tenth of the share, it is spread over the step.
    """
    rates = release.rate(thirds)
    width = thirds[:, -1] - thirds[:, 0]
    share = release.burnt(thirds[:, -1]) - release.burnt(thirds[:, 0])
    seen = width / 6 * (rates @ np.array([1.0, 4.0, 1.0]))
    smooth = np.abs(seen - share) < share / 10
    factor = np.divide(share, seen, out=np.zeros_like(share), where=smooth)
    return np.where(smooth[:, None], factor[:, None] * rates, (share / width)[:, None])


def _slope(
    charge: Charge, mass: float, volumes: Real, rates: Real, burning: Real
) -> Callable[[float, int, int], float]:
    """Dp/dphi as a function of the pressure, the step and its beginning, middle or end."""
    area = pi / 4 * charge.bore**2
    # seconds per radian: half a turn is a stroke
    time = charge.stroke / (pi * charge.piston_speed) if charge.piston_speed else 0.0

    def slope(pressure: float, row: int, column: int) -> float:
        volume = float(volumes[row, column])
        if not 0 < pressure < GREATEST:
            raise ArithmeticError(pressure)
        temperature = pressure * volume / (mass * GAS_CONSTANT)
        gamma = charge.gamma or gamma_of(temperature)
        gained = float(burning[row, column])
        if charge.wall is not None:
            film = film_coefficient(
                volume=volume,
                pressure=pressure,
                temperature=temperature,
                piston_speed=charge.piston_speed,
            )
            wet = 2 * area + 4 * volume / charge.bore
            gained -= film * wet * (temperature - charge.wall) * time
        return ((gamma - 1) * gained - gamma * pressure * float(rates[row, column])) / volume

    return slope
