"""Gears between crankshafts: the torque that each mesh passes on over a cycle, and its reversals.

Each crankshaft i is a body: gas gives it T_g, its own pistons and rods change their energy, and it
shares the speed w of all. What it does not keep goes through its gears,

    M_i = T_g,i - d/dtheta (J_i w^2/2)                  N m, positive where i drives

with J_i the inertia of all that it turns. A mesh passes on the sum over the crankshafts beyond it,
seen from the load. Where no inertia is known, the same to first order in the unevenness: with
T_i = T_g,i + inertia torque at the mean speed, T their sum, T_L the load,

    M_i = T_i - s_i (T - T_L)

s_i being the share of i in the whole inertia: what is missing or in excess at the load is taken
from, or kept by, all that turns, each body by its share. So the flywheel decides: with all of it at
the load (s_i = 0), M_i = T_i, whatever the other crankshafts do.

Gears are rigid and without friction, which counts with the load; their backlash is small.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from crankstar import spectra
from crankstar.dynamics.uneven import SAMPLES, Running, friction_apart, load_course
from crankstar.engine.drive import Drive
from crankstar.engine.engine import Engine
from crankstar.mechanics.gas import Cycle
from crankstar.mechanics.gas_torque import crankshaft_torque
from crankstar.mechanics.gear_wheels import Wheel, crankshafts, wheels
from crankstar.mechanics.kinetic import inertias, samples_over, shaft_torque
from crankstar.mechanics.mechanism import mechanism
from crankstar.spectra import Real

NOTHING = 1e-9
"""Share of the torque of the crankshafts beyond a mesh below which it passes on nothing."""
LIGHT = 0.01
"""The same share, below which the teeth are hardly pressed to either side."""


@dataclass(frozen=True)
class Mesh:
    """A mesh over a cycle: `torque` [angle] in N m on the crankshaft of its wheel.

    Positive where that crankshaft drives; `theta` [angle] from 0, radians; `share` of the inertia
    beyond it; `work_share`, the share of its torque in that of the engine, mean by mean; `scale`,
    the greatest torque (N m) of the crankshafts beyond.
    """

    wheel: Wheel
    share: float
    theta: Real
    torque: Real
    work_share: float | None
    scale: float

    @property
    def mean(self) -> float:
        """The mean torque, N m."""
        return float(self.torque.mean())

    @property
    def least(self) -> tuple[float, float]:
        """The least torque (N m) and its crank angle (radians)."""
        place = int(np.argmin(self.torque))
        return float(self.torque[place]), float(self.theta[place])

    @property
    def greatest(self) -> tuple[float, float]:
        """The greatest torque (N m) and its crank angle (radians)."""
        place = int(np.argmax(self.torque))
        return float(self.torque[place]), float(self.theta[place])

    @property
    def force(self) -> float | None:
        """The greatest tangential force on the teeth, N; None where the pitch radius is unknown."""
        radius = self.wheel.pitch_radius
        return None if radius is None else float(np.abs(self.torque).max()) / radius

    @property
    def work(self) -> float:
        """What passes through the teeth in both directions, J per cycle: integral of |M|.

        The faces in contact slide alike every turn, so that it is a measure of wear.
        """
        step = float(self.theta[1] - self.theta[0])
        return float(np.abs(self.torque).sum()) * step

    @property
    def driving(self) -> float:
        """The share of the cycle in which the crankshaft drives what it is geared to."""
        return float((self.torque > NOTHING * self.scale).mean())

    @cached_property
    def reversals(self) -> tuple[float, ...]:
        """The crank angles (radians) at which contact goes to the other flanks of the teeth.

        Those after which the torque stays within LIGHT are not counted.
        """
        sign = np.sign(np.where(np.abs(self.torque) > LIGHT * self.scale, self.torque, 0.0))
        place = np.flatnonzero(sign)
        after = np.roll(place, -1)
        changes = sign[place] != sign[after]
        return tuple(
            sorted(self._nought(a, b) for a, b in zip(place[changes], after[changes], strict=True))
        )

    def _nought(self, before: int, after: int) -> float:
        """The last crank angle (radians) between two samples at which the torque is nought."""
        count, step = self.theta.size, float(self.theta[1] - self.theta[0])
        way = np.arange(before, before + (after - before) % count + 1)
        torque = self.torque[way % count]
        last = int(np.flatnonzero(torque * torque[-1] <= 0)[-1])
        part = torque[last] / (torque[last] - torque[last + 1])
        return float((way[last] + part) % count) * step


def shares(engine: Engine, *, with_load: bool = False) -> tuple[float, ...]:
    """The share of each crankshaft in the inertia: as the file says, else alike.

    Or none at all, where it is all `with_load`.
    """
    cranks, drive = crankshafts(engine), engine.drive or Drive()
    if with_load:
        return (0.0,) * len(cranks)
    return drive.inertia_shares or (1 / len(cranks),) * len(cranks)


def meshes(
    engine: Engine,
    cycle: Cycle,
    *,
    running: Running | None = None,
    inertia_shares: Sequence[float] | None = None,
) -> tuple[Mesh, ...]:
    """Every mesh over a cycle, N m; exact where the varying speed is given as `running`.

    `inertia_shares` stand before those of the file. Empty for an engine with one crankshaft.

    >>> from crankstar.files.catalog import load
    >>> from crankstar.mechanics.gas import cycle
    >>> engine = load("kr250-racer-simultaneous")
    >>> (mesh,) = meshes(engine, cycle(engine))

    Crankshafts that are alike in all speed up and slow down together: half of the load goes through
    the gears, all the time.

    >>> bool(np.ptp(mesh.torque) < 1e-9 * mesh.mean), round(mesh.work_share, 9)
    (True, 0.5)
    """
    links = wheels(engine)
    if not links:
        return ()
    cranks = crankshafts(engine)
    parts = shares(engine) if inertia_shares is None else tuple(inertia_shares)
    theta = samples_over(engine, SAMPLES)
    gas = crankshaft_torque(engine, cycle, SAMPLES)[_rows(engine)]
    own = gas + _inertia_torque(engine, cycle)
    passed = (
        _passed_on(own, gas, load_course(engine, cycle), parts, friction_apart(cycle))
        if running is None
        else gas - _kept(engine, running, parts)
    )
    place = {shaft.name: index for index, shaft in enumerate(cranks)}
    whole = float(own.mean(axis=-1).sum())
    found: list[Mesh] = []
    for wheel in links:
        rows = [place[name] for name in wheel.beyond]
        torque = passed[rows].sum(axis=0)
        found.append(
            Mesh(
                wheel=wheel,
                share=sum(parts[row] for row in rows),
                theta=theta,
                torque=torque,
                work_share=float(torque.mean()) / whole if whole else None,
                scale=float(np.abs(own[rows]).max()),
            )
        )
    return tuple(found)


def _inertia_torque(engine: Engine, cycle: Cycle) -> Real:
    """Of each crankshaft at the mean speed, N m; 0 where speed or masses are not known."""
    if cycle.speed is None or not {"mass", "radius"}.isdisjoint(engine.relative):
        return np.zeros(SAMPLES)
    own = shaft_torque(mechanism(engine))
    moving = np.real(spectra.value(own, samples_over(engine, SAMPLES)))
    return moving[_rows(engine)] * cycle.speed**2


def _rows(engine: Engine) -> list[int]:
    """The places of the crankshafts among the shafts."""
    return [index for index, shaft in enumerate(engine.shafts) if shaft.throws]


def _passed_on(
    own: Real, gas: Real, course: Real | None, parts: Sequence[float], friction: float
) -> Real:
    """T_i - s_i (T - T_L) [crankshaft, angle]."""
    shape = np.ones(SAMPLES) if course is None else course / course.mean()
    driven = gas.sum(axis=0).mean() - friction
    excess = own.sum(axis=0) - friction - shape * driven
    return own - np.array(parts)[:, None] * excess


def _kept(engine: Engine, running: Running, parts: Sequence[float]) -> Real:
    """d/dtheta (J_i w^2/2), what each crankshaft keeps of its gas torque [crankshaft, angle]."""
    whole = inertias(engine, running.theta)[_rows(engine)]
    whole = whole + np.array(parts)[:, None] * running.flywheel
    return _slope(whole * running.speed**2 / 2, float(running.theta[1]))


def _slope(energy: Real, step: float) -> Real:
    """The derivative by the angle of periodic samples [row, sample]."""
    count = energy.shape[-1]
    numbers = np.fft.rfftfreq(count, 1 / count)
    wave = np.fft.rfft(energy, axis=-1) * (2j * np.pi / (count * step)) * numbers
    wave[..., -1] = 0
    return np.fft.irfft(wave, n=count, axis=-1)
