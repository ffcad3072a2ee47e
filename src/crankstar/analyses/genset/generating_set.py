"""A generating set: how evenly it runs, and what several of them do to one foundation.

The generator is fixed to the frame of its engine. The rotor takes what is left of the alternating
torque of gas and inertia by that of the load, J dw/dt, and the frame its reaction, -J dw/dt
(`load_reaction`): what reaches the foundation are the inertia force, the external moments, and the
rolling moment of gas, inertia and a load with a course, half orders of a weak cylinder included.
The mean torque alone stays inside.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass

import numpy as np

from crankstar import spectra
from crankstar.dynamics.generator_angle import GeneratorAngle, generator_angle
from crankstar.dynamics.load_reaction import on_one_frame
from crankstar.dynamics.uneven import Running, driven, flywheel_for, takes_work
from crankstar.engine.engine import Engine
from crankstar.language.messages import _
from crankstar.mechanics.balance import balance, total
from crankstar.mechanics.excitation import Totals, rolling_moment
from crankstar.mechanics.gas import Cycle, cycle_or_reason
from crankstar.mechanics.gas_torque import gas_torque, roll_with_gas
from crankstar.mechanics.lacking import KEYS, lacking_keys, lacking_words, without_running
from crankstar.mechanics.operating_points import operating_state
from crankstar.mechanics.phase_sums import exceeded, typical_sum, worst_sum

NOTED = 1e-4
"""Share of the greatest of a part from which an order of the sum is told."""
HIGHEST = 12.0
"""The highest order that is told."""
SHARES = (0.05, 0.01)
"""Of the time, in which a sum is exceeded."""
QUANTITIES = ("force_vertical", "force_horizontal", "pitch", "yaw", "roll")


@dataclass(frozen=True)
class OrderSum:
    """An order of a quantity: of one engine, and of all with unknown phases, N or N m.

    `exceeded` in the shares SHARES of the time; the rolling moment is that of gas, inertia and the
    course of the load.
    """

    quantity: str
    order: float
    one: float
    worst: float
    typical: float
    exceeded: tuple[float, ...]


@dataclass(frozen=True)
class GeneratingSet:
    """A set at its speed: uneven running (None where not known), and sums of several engines.

    `wanted` is the inertia (kg m^2) for the degree of irregularity that was asked for, known
    without a flywheel too;
    `without_running` and `without_sums` say what is missing; `speed` (rad/s) is that of the sums.
    """

    engine: Engine
    cycle: Cycle | None
    running: Running | None
    angle: GeneratorAngle | None
    pole_pairs: int | None
    engines: int
    wanted: float | None
    sums: tuple[OrderSum, ...]
    without_running: str
    without_sums: str
    speed: float | None

    @property
    def steady_drive(self) -> bool:
        """Whether the engine is driven: by a torque that is taken as steady."""
        return self.cycle is not None and not takes_work(self.cycle)

    @property
    def frequency(self) -> float | None:
        """The frequency of the voltage, Hz."""
        if self.running is None or self.pole_pairs is None:
            return None
        return self.pole_pairs * self.running.mean_speed / (2 * np.pi)


def generating_set(
    engine: Engine,
    *,
    point: str = "",
    speed: float | None = None,
    flywheel: float | None = None,
    pole_pairs: int | None = None,
    engines: int = 1,
    irregularity: float | None = None,
    off: Collection[int] = (),
    weaker: Mapping[int, float] | None = None,
) -> GeneratingSet:
    """A set at an operating point and speed (rad/s), and so many of them on one foundation.

    `flywheel` is the inertia of crankshaft, flywheel, coupling and rotor, kg m^2, else that of the
    file; `irregularity` a degree of irregularity for which it is sized. Cylinders are `off` or
    `weaker` as in `cycle`. Raises GasError for a point that the engine has not, or without gas for
    such cylinders, UnevenError where it would stop within a cycle.

    >>> from crankstar.files.catalog import load
    >>> changes = {"cylinder.reciprocating_mass": "0.6 kg"}
    >>> five = load("audi-25-tfsi", changes=changes)
    >>> found = generating_set(five, speed=157.08, flywheel=0.6, pole_pairs=2, engines=4)
    >>> round(found.frequency, 2), found.sums[0].worst == 4 * found.sums[0].one
    (50.0, True)
    """
    burning, why = cycle_or_reason(engine, point=point, speed=speed, off=off, weaker=weaker)
    running = None if burning is None else driven(engine, burning, flywheel=flywheel)
    if burning is not None and running is None:
        why = without_running(engine, burning.speed, flywheel)
    turning = operating_state(engine, point=point, speed=speed).speed
    wanted = None
    if irregularity is not None and burning is not None and not lacking_keys(engine, burning.speed):
        wanted = flywheel_for(engine, burning, irregularity=irregularity)
    sums, lacking = _sums(engine, turning, engines, burning)
    return GeneratingSet(
        engine=engine,
        cycle=burning,
        running=running,
        angle=None if running is None else generator_angle(running),
        pole_pairs=pole_pairs,
        engines=engines,
        wanted=wanted,
        sums=sums,
        without_running=why,
        without_sums=lacking,
        speed=turning,
    )


def _sums(
    engine: Engine, speed: float | None, engines: int, burning: Cycle | None
) -> tuple[tuple[OrderSum, ...], str]:
    """The orders of force and moment of one engine and of all."""
    result = balance(engine, speed=speed)
    if result.speed is None or result.units.couple != "N*m":
        missing = lacking_words(engine, speed, KEYS)
        return (), _("not known: {missing}", missing=", ".join(missing))
    whole = total(result)
    parts = Totals(*(getattr(result, name) for name in Totals._fields))
    alike = tuple(exceeded([1.0] * engines, share) for share in SHARES)
    out: list[OrderSum] = []
    for name in QUANTITIES:
        if name == "roll":
            roll = _roll(whole, engine, burning)
            orders, values = roll.orders, np.abs(spectra.amplitude(roll))
            most = float(values.max(initial=0.0))
        else:
            orders, values = whole.force.orders, _amplitudes(whole, name)
            most = float(_amplitudes(parts, name).max(initial=0.0))
        for order, one in zip(orders.tolist(), values.tolist(), strict=True):
            if one > NOTED * most and order <= HIGHEST:
                every = [one] * engines
                beyond = tuple(one * each for each in alike)
                out.append(OrderSum(name, order, one, worst_sum(every), typical_sum(every), beyond))
    return tuple(out), ""


def _roll(sums: Totals, engine: Engine, burning: Cycle | None) -> spectra.Spectrum:
    """The rolling moment on the frame, of inertia alone where the gas is not known."""
    if burning is None:
        return rolling_moment(sums)
    return on_one_frame(roll_with_gas(sums, gas_torque(burning).total), engine, burning)


def _amplitudes(sums: Totals, name: str) -> np.ndarray:
    """The amplitudes of a quantity by order, of the sum or of the parts."""
    found = {
        "force_vertical": lambda: spectra.vertical(sums.force),
        "force_horizontal": lambda: spectra.horizontal(sums.force),
        "pitch": lambda: spectra.vertical(sums.couple),
        "yaw": lambda: spectra.horizontal(sums.couple),
    }
    return np.abs(found[name]())
