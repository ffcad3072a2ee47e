"""Uneven running: how the speed of the crankshaft goes over a cycle, and the flywheel it needs.

With E = J w^2/2 the kinetic energy of all that turns and moves, J(theta) the inertia that the
crankshaft feels, flywheel included, and the torque of the load T_L,

    dE/dtheta = T_gas(theta) - T_L(theta, w)

exactly: that J changes with the angle is the inertia torque. In steady running E comes back after a
cycle, and the mean of the speed over time is what was asked for. The load is

    T_L = T_f + c g(theta) (w/w_m)^k

with T_f the mean torque that friction takes, steady, g the course of what is driven (1 where it is
steady) and c such that over a cycle it takes what gas and friction leave. Where the file asks for
an indicated load and says nothing of friction, T_f is 0: friction counts with the load. An engine
that is driven has no such load: c is negative, the torque of a motor of which a file says nothing,
taken as steady (g = 1, k = 0). The degree of irregularity is (w_max - w_min)/w_m.

The linear estimate takes J at its mean: with the fluctuation of energy dE = max - min of the
integral of T_gas + T_inertia - T_L at the mean speed, delta = dE/(J w_m^2).

Source: any textbook on flywheels; J. E. Shigley, J. J. Uicker, Theory of Machines and Mechanisms.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from crankstar import spectra
from crankstar.engine.drive import Drive
from crankstar.engine.engine import Engine
from crankstar.language.messages import MessageError
from crankstar.language.numbers import RPM
from crankstar.mechanics.chain_inertia import turning_inertia
from crankstar.mechanics.excitation import part_spectra
from crankstar.mechanics.gas import Cycle
from crankstar.mechanics.gas_torque import chamber_torque, friction_torque, over_cycle
from crankstar.mechanics.kinetic import inertia, mean_inertia, samples_over, throw_inertia
from crankstar.mechanics.maxima import Extremes, extremes
from crankstar.mechanics.mechanism import mechanism
from crankstar.mechanics.roots import root
from crankstar.spectra import Real

SAMPLES = 1440
MOST_ROUNDS = 200
CONVERGED = 1e-13
SLOWEST = 0.2
"""Share of the mean speed below which, or as far above, an engine cannot run."""
LEAST_SHARE = 1e-6
"""Inertia at a crank angle, as a share of the greatest, below which nothing holds the speed: that
of pistons without a flywheel at their dead centres."""


LEAST_WORK = 1e-9
"""Brake torque over that of friction below which it is a rounding error."""


class UnevenError(MessageError):
    """A speed that cannot be computed, and why."""


@dataclass(frozen=True)
class Running:
    """A cycle of steady running [angle]: crank angle (rad), speed (rad/s), torques (N m).

    `irregularity` is (max - min)/mean of the speed, `linear` its estimate; `fluctuation` the
    greatest change of kinetic energy (J); `inertia` the mean J with `flywheel`, kg m^2.

    >>> from crankstar import cycle, load
    >>> five = load("audi-25-tfsi")
    >>> found = driven(five, cycle(five, speed="1000 rpm", imep="9 bar"), flywheel=0.5)
    >>> slow, _angle, fast, _other = found.extremes
    >>> bool((fast - slow) / found.mean_speed == found.irregularity)
    True
    """

    theta: Real
    speed: Real
    gas: Real
    load: Real
    mean_speed: float
    irregularity: float
    linear: float
    fluctuation: float
    inertia: float
    flywheel: float

    @property
    def extremes(self) -> Extremes:
        """The least and the greatest speed (rad/s), each with its crank angle (rad)."""
        return extremes(self.speed, float(self.theta[1]) * self.theta.size)


def running(
    engine: Engine,
    cycle: Cycle,
    *,
    flywheel: float,
    exponent: float = 0.0,
    course: Real | None = None,
) -> Running:
    """The speed over a cycle. `flywheel`: inertia of crankshaft, flywheel and coupled parts.

    `exponent` and `course` [angle] are k and g of the load. Raises UnevenError where the engine
    would stop within the cycle.
    """
    return _WithoutFlywheel.of(engine, cycle, exponent=exponent, course=course).with_(flywheel)


@dataclass(frozen=True)
class _WithoutFlywheel:
    """An engine in its cycle but for the flywheel, on which none of these depends.

    `own` [angle] is the inertia that the crankshaft feels of what moves, `mean` its mean with what
    hangs on the pins (kg m^2); `fluctuation` as in `Running`.
    """

    theta: Real
    speed: float
    gas: Real
    own: Real
    mean: float
    fluctuation: float
    shape: Real
    exponent: float
    friction: float

    @classmethod
    def of(
        cls, engine: Engine, cycle: Cycle, *, exponent: float, course: Real | None
    ) -> _WithoutFlywheel:
        speed = cycle.speed
        if speed is None:
            raise UnevenError("uneven running needs a speed: give speed")
        theta = samples_over(engine, SAMPLES)
        gas = over_cycle(cycle, SAMPLES).sum(axis=0)
        shape = np.ones_like(theta) if course is None else course / course.mean()
        torque = spectra.total(part_spectra(mechanism(engine)).torque)
        moving = np.real(spectra.value(torque, theta)) * speed**2
        lost = friction_apart(cycle)
        load = lost + (gas.mean() - lost) * shape
        change = periodic_integral(gas + moving - load, theta[1] - theta[0])
        swing = extremes(change, cycle.volumes.cycle)
        return cls(
            theta=theta,
            speed=speed,
            gas=gas,
            own=inertia(engine, theta),
            mean=mean_inertia(mechanism(engine)) + throw_inertia(engine),
            fluctuation=swing.greatest - swing.least,
            shape=shape,
            exponent=exponent,
            friction=lost,
        )

    def with_(self, flywheel: float) -> Running:
        """Steady running with a flywheel; raises UnevenError where the engine would stop."""
        whole, speed = flywheel + self.own, self.speed
        if float(whole.min()) < LEAST_SHARE * float(whole.max()):
            raise _stopped(speed)
        now, load = self._settled(whole)
        if float(now.min()) < SLOWEST * speed or float(now.max()) > speed / SLOWEST:
            raise _stopped(speed)
        mean = flywheel + self.mean
        ends = extremes(now, float(self.theta[1]) * self.theta.size)
        return Running(
            theta=self.theta,
            speed=now,
            gas=self.gas,
            load=load,
            mean_speed=speed,
            irregularity=(ends.greatest - ends.least) / speed,
            linear=self.fluctuation / (mean * speed**2),
            fluctuation=self.fluctuation,
            inertia=mean,
            flywheel=flywheel,
        )

    def _settled(self, whole: Real) -> tuple[Real, Real]:
        """Speed and load over the cycle, whose load depends on the speed."""
        gas, speed = self.gas, self.speed
        span = self.theta[1] - self.theta[0]
        now = np.full_like(self.theta, speed)
        for _ in range(MOST_ROUNDS):
            load = self.shape * (now / speed) ** self.exponent
            load = self.friction + load * ((gas.mean() - self.friction) / load.mean())
            energy = _energy(periodic_integral(gas - load, span), whole, speed)
            after = np.sqrt(2 * energy / whole)
            moved = float(np.abs(after - now).max()) / speed
            now = after
            if moved < CONVERGED:
                return now, load
        raise UnevenError("the speed does not settle: give drive.load_exponent nearer 0")


def _stopped(speed: float) -> UnevenError:
    return UnevenError(
        "at {rpm} rpm the engine would stop within a cycle: give it more flywheel, more speed or "
        "less load",
        rpm=f"{speed * RPM:.4g}",
    )


def periodic_integral(torque: Real, span: float) -> Real:
    """The integral over the angle of a periodic torque without its mean, of mean nought."""
    count = torque.size
    numbers = np.fft.rfftfreq(count, 1 / count)
    wave = np.fft.rfft(torque)
    wave[0] = 0
    per_radian = numbers * (2 * np.pi / (count * span))
    wave[1:] /= 1j * per_radian[1:]
    if count % 2 == 0:
        wave[-1] = 0
    return np.fft.irfft(wave, n=count)


def _energy(change: Real, whole: Real, speed: float) -> Real:
    """The energy over the cycle whose speed has this mean over time.

    Raises UnevenError where it is faster on the whole even if it all but stops once.
    """
    least = -float(change.min())

    def slow(mean: float) -> float:
        # time of a cycle over that at the mean speed
        return float(np.mean(np.sqrt(whole / (2 * (mean + change))))) * speed - 1.0

    high = least + float(whole.max()) * speed**2 * 2 + float(np.ptp(change))
    low = least * (1 + 1e-12) + 1e-12 * high
    if slow(low) < 0:
        raise _stopped(speed)
    return root(slow, low=low, high=high) + change


def flywheel_for(engine: Engine, cycle: Cycle, *, irregularity: float) -> float:
    """The inertia of flywheel and crankshaft for a degree of irregularity, kg m^2.

    With the load of the engine file, as `driven` has it. Zero where the moving parts alone are
    enough. Twice as even takes about twice the inertia:

    >>> from crankstar import cycle, load
    >>> five = load("audi-25-tfsi")
    >>> idle = cycle(five, speed="800 rpm", imep="2 bar")
    >>> one, half = (flywheel_for(five, idle, irregularity=each) for each in (0.02, 0.01))
    >>> round(half / one, 2)
    2.0
    """
    bare = _driven_by(engine, cycle)

    def over(flywheel: float) -> float:
        try:
            return bare.with_(flywheel).irregularity - irregularity
        except UnevenError:
            return 10.0

    if over(0.0) <= 0:
        return 0.0
    high = 4 * bare.fluctuation / (irregularity * bare.speed**2)
    while over(high) > 0:
        high *= 2
    return root(over, low=0.0, high=high)


def driven(engine: Engine, cycle: Cycle, *, flywheel: float | None = None) -> Running | None:
    """Steady running with the inertia of the engine file, or another `flywheel` (kg m^2).

    None where inertia, speed or masses are not known.

    >>> from crankstar import cycle, load
    >>> five = load("audi-25-tfsi")
    >>> idle = cycle(five, speed="800 rpm", imep="2 bar")
    >>> driven(five, idle) is None, driven(five, idle, flywheel=0.3).mean_speed == idle.speed
    (True, True)
    """
    own = turning_inertia(engine) if flywheel is None else flywheel
    if own is None or cycle.speed is None or not {"mass", "radius"}.isdisjoint(engine.relative):
        return None
    return _driven_by(engine, cycle).with_(own)


def fluctuation(engine: Engine, cycle: Cycle) -> tuple[float, float]:
    """The greatest change of kinetic energy (J) and the mean inertia of what moves (kg m^2).

    Of an engine with the load of its file; neither depends on its flywheel.

    >>> from crankstar import cycle, load
    >>> five = load("audi-25-tfsi")
    >>> idle = cycle(five, speed="800 rpm", imep="2 bar")
    >>> fluctuation(five, idle)[0] == driven(five, idle, flywheel=0.3).fluctuation
    True
    """
    bare = _driven_by(engine, cycle)
    return bare.fluctuation, bare.mean


def _driven_by(engine: Engine, cycle: Cycle) -> _WithoutFlywheel:
    """The engine with the load of its file, or with the steady torque of what drives it."""
    exponent = (engine.drive or Drive()).load_exponent if takes_work(cycle) else 0.0
    return _WithoutFlywheel.of(engine, cycle, exponent=exponent, course=load_course(engine, cycle))


def friction_apart(cycle: Cycle) -> float:
    """The mean torque of friction that does not go with the load, N m: what the file says of it.

    Known with a brake mean effective pressure, a friction pressure or its correlation; between two
    operating points with one of them at both. A load in indicated pressure alone leaves it unknown,
    as a correlation without a speed does: 0.

    >>> from crankstar import cycle, load
    >>> five = load("audi-25-tfsi")
    >>> indicated = cycle(five, speed="800 rpm", imep="2 bar")
    >>> brake = cycle(five, speed="800 rpm", bmep="2 bar")
    >>> [round(friction_apart(each), 1) for each in (indicated, brake)]
    [0.0, 22.1]
    """
    return (friction_torque(cycle) or 0.0) if cycle.friction_said else 0.0


def takes_work(cycle: Cycle) -> bool:
    """Whether a load could take work: not where gas and friction leave none: the engine is driven.

    >>> from crankstar import cycle, load
    >>> five = load("audi-25-tfsi", changes={"gas.friction_pressure": "2 bar"})
    >>> [takes_work(cycle(five, imep=load)) for load in ("1 bar", "3 bar")]
    [False, True]
    """
    if cycle.motored:
        return False
    mean = float(chamber_torque(cycle).mean(axis=-1).sum())
    lost = friction_torque(cycle) or 0.0
    return mean - lost > LEAST_WORK * abs(lost)


def load_taken(engine: Engine, cycle: Cycle) -> Drive | None:
    """The drive of the engine file with the course of its load; None of a steady load.

    None too where the engine is driven: the course is that of a load which takes work
    (`takes_work`), and does not turn round.

    >>> from crankstar import cycle, load
    >>> course = {"load_torque": [2, 0], "load_angle": ["0 deg", "360 deg"]}
    >>> own = {"drive": course, "gas.friction_pressure": "2 bar"}
    >>> five = load("audi-25-tfsi", changes=own)
    >>> [load_taken(five, cycle(five, imep=load)) is None for load in ("1 bar", "3 bar")]
    [True, False]
    """
    if engine.drive is None or not engine.drive.load_torque:
        return None
    return engine.drive if takes_work(cycle) else None


def load_course(engine: Engine, cycle: Cycle) -> Real | None:
    """How the load goes over the cycle [angle], None where it has no course (`load_taken`).

    Over its greatest value, and at each angle the mean over the step around it, so that the mean of
    all is that of its integral however short a piece of it is.
    """
    drive = load_taken(engine, cycle)
    if drive is None:
        return None
    theta = samples_over(engine, SAMPLES)
    step = float(theta[1] - theta[0])
    period = SAMPLES * step
    angle = np.array([*drive.load_angle, drive.load_angle[0] + period])
    load = np.array([*drive.load_torque, drive.load_torque[0]]) / max(map(abs, drive.load_torque))
    width = np.diff(angle)
    until = np.concatenate([[0.0], np.cumsum(width * (load[:-1] + load[1:]) / 2)])
    turns, place = np.divmod(step * (np.arange(SAMPLES + 1) - 0.5) - angle[0], period)
    place += angle[0]
    piece = np.clip(np.searchsorted(angle, place, side="right") - 1, 0, width.size - 1)
    into = place - angle[piece]
    share = np.divide(into, width[piece], out=np.zeros_like(into), where=width[piece] > 0)
    reached = load[piece] + share * np.diff(load)[piece] / 2
    return np.diff(until[piece] + into * reached + turns * until[-1]) / step
