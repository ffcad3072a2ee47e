"""A finite heat release by Wiebe's function, as pressure over the crank angle.

While the valves are closed the pressure follows from the first law for an ideal gas,

    dp = -gamma p dV/V + (gamma - 1)/V (dQ_b - dQ_w)
    Q_b = Q x_b,   x_b = (1 - exp(-a y^(m+1)))/(1 - exp(-a)),   y = (phi - start)/duration

With a constant gamma and no heat to the walls, Q_w = 0, that is a quadrature,

    p V^gamma = p_1 V_1^gamma + (gamma - 1) integral of V^(gamma-1) dQ_b

so that the pressure is p_1 f_1(phi) + p_e f_e(phi) + Q f_Q(phi): linear in intake pressure, exhaust
pressure and heat, and every load of an engine is a sum of three curves. A gas whose gamma follows
its temperature, or whose heat goes to the walls, is that of `real_gas`.

When the exhaust opens the pressure falls to that of the exhaust by bottom dead centre, as half a
cosine wave from what expansion would have left; in the overlap of valves it goes to that of the
intake in the same way. Waves in the manifolds are left out.

Sources: I. Wiebe (1962), the function; J. B. Heywood, Internal Combustion Engine Fundamentals,
chapter 9.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import ceil, floor, pi
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from crankstar.spectra import Real


@dataclass(frozen=True)
class Release:
    """When and how heat is released; angles in radians of the chamber's crank from firing."""

    start: float
    duration: float
    wiebe_a: float
    wiebe_m: float

    def burnt(self, angle: Real) -> Real:
        """The share of the heat released by an angle, from 0 to exactly 1.

        >>> release = Release(start=0.0, duration=1.0, wiebe_a=5.0, wiebe_m=2.0)
        >>> release.burnt(np.array([-0.1, 0.5, 1.0])).round(4).tolist()
        [0.0, 0.4679, 1.0]
        """
        done = np.clip((np.asarray(angle) - self.start) / self.duration, 0.0, 1.0)
        whole = -np.expm1(-self.wiebe_a)
        return -np.expm1(-self.wiebe_a * done ** (self.wiebe_m + 1)) / whole

    def rate(self, angle: Real) -> Real:
        """The share of the heat released per radian."""
        done = (np.asarray(angle) - self.start) / self.duration
        inside = (done > 0) & (done < 1)
        done = np.where(inside, done, 0.5)
        a, m = self.wiebe_a, self.wiebe_m
        rate = a * (m + 1) * done**m * np.exp(-a * done ** (m + 1)) / -np.expm1(-a)
        return np.where(inside, rate / self.duration, 0.0)


@dataclass(frozen=True)
class Events:
    """What happens when, radians of the chamber's crank from the dead centre of firing.

    Compression begins at `closed`, negative; the exhaust opens at `opened`, and the pressure is
    that of the exhaust at `emptied`; from `exchange[0]` to `exchange[1]` it goes to that of the
    intake.
    """

    closed: float
    opened: float
    emptied: float
    exchange: tuple[float, float]


class Curves(NamedTuple):
    """The pressure as a sum [sample]: intake pressure, exhaust pressure and heat times a curve."""

    intake: Real
    exhaust: Real
    heat: Real


class Grid(NamedTuple):
    """A chamber at equal steps of a cycle from the dead centre of firing: m^3 and m^3/rad.

    `volume` and `rate` [sample], `step` in radians.
    """

    volume: Real
    rate: Real
    step: float


def curves(grid: Grid, events: Events, release: Release, *, gamma: float) -> Curves:
    """The three curves of a constant gamma: of 1, 1 and 1/m^3.

    Without heat they are compression and expansion along p V^gamma:

    >>> angle = np.arange(720) * (4 * np.pi / 720)
    >>> grid = Grid(1.125 - np.cos(angle), np.sin(angle), 4 * np.pi / 720)
    >>> events = Events(-np.pi, np.pi, 1.2 * np.pi, (2 * np.pi - 0.3, 2 * np.pi + 0.3))
    >>> found = curves(grid, events, Release(0.0, 1.0, 5.0, 2.0), gamma=1.4)
    >>> bool(np.isclose(found.intake[0], 17.0**1.4))
    True
    """
    parts = placed(grid, events)
    where, angle = parts.where, parts.angle
    volume, rate = grid.volume[where], grid.rate[where]
    burnt = release.burnt(angle)
    # by parts, for x_b is smoother than its rate
    moved = integral(burnt * volume ** (gamma - 2) * rate, step=grid.step)
    heat = (gamma - 1) * (burnt / volume - (gamma - 1) * moved / volume**gamma)
    intake, exhaust, released = (np.zeros_like(grid.volume) for _ in range(3))
    intake[where] = parts.free * (volume_at(grid, events.closed) / volume) ** gamma
    released[where] = parts.free * heat
    exhaust[where] = 1 - parts.free
    exhaust[parts.rest] = 1 - parts.filled
    intake[parts.rest] = parts.filled
    return Curves(intake, exhaust, released)


def integral(values: Real, *, step: float) -> Real:
    """The integral from the first sample to each [sample], by the parabolas through three.

    Between two samples the mean of both parabolas. Not scipy's, whose import takes longer than all
    else that a page does.

    >>> integral(np.array([0.0, 1.0, 4.0, 9.0, 16.0]), step=1.0).round(12).tolist()
    [0.0, 0.333333333333, 2.666666666667, 9.0, 21.333333333333]
    """
    inside = (values[:-3] + values[3:], values[1:-2] + values[2:-1])
    first = 5 * values[0] + 8 * values[1] - values[2]
    last = 5 * values[-1] + 8 * values[-2] - values[-3]
    pieces = np.concatenate(([2 * first], 13 * inside[1] - inside[0], [2 * last]))
    return np.append(0.0, np.cumsum(pieces) * step / 24)


class Parts(NamedTuple):
    """The samples of the closed chamber and its blow-down (`where`), and of the exchange (`rest`).

    `angle` from firing, radians; `free` is the share that the pressure of a closed chamber has in
    it, `filled` that of the intake.
    """

    where: NDArray[np.int_]
    angle: Real
    free: Real
    rest: NDArray[np.int_]
    filled: Real


def placed(grid: Grid, events: Events) -> Parts:
    """The samples of a cycle by what happens in them."""
    count = grid.volume.size
    first = ceil(events.closed / grid.step - 1e-9)
    last = ceil(events.emptied / grid.step - 1e-9)
    place = np.arange(first, first + count)
    angle = place * grid.step
    within = place < last
    free = _eased(angle[within], events.opened, events.emptied)
    filled = 1 - _eased(angle[~within], *events.exchange)
    return Parts(place[within] % count, angle[within], free, place[~within] % count, filled)


def _eased(angle: Real, start: float, end: float) -> Real:
    """From 1 before `start` to 0 after `end`, as half a cosine wave."""
    return (1 + np.cos(pi * np.clip((angle - start) / (end - start), 0.0, 1.0))) / 2


def volume_at(grid: Grid, angle: float) -> float:
    """The volume between two samples, by the cubic that has their values and rates."""
    place = angle / grid.step
    before = floor(place)
    share, left = place - before, before + 1 - place
    here, there = before % grid.volume.size, (before + 1) % grid.volume.size
    values = left**2 * (1 + 2 * share) * grid.volume[here]
    values += share**2 * (1 + 2 * left) * grid.volume[there]
    slopes = share * left * (left * grid.rate[here] - share * grid.rate[there])
    return float(values + grid.step * slopes)
