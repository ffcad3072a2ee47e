"""What gas does in each engine of a sweep: torque, roll, peak pressure, irregularity.

Each is computed engine by engine, at the load of its file.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from math import prod
from typing import NamedTuple

import numpy as np

from crankstar import spectra
from crankstar.dynamics.mounted_block import MountError
from crankstar.dynamics.torsion_system import TorsionError
from crankstar.dynamics.uneven import UnevenError, driven
from crankstar.engine.engine import Engine
from crankstar.mechanics.balance import balance, total
from crankstar.mechanics.gas import Cycle, cycle
from crankstar.mechanics.gas_torque import ALL, HIGHEST, added, gas_roll, gas_torque, roll_with_gas
from crankstar.mechanics.lacking import lacking_keys
from crankstar.mechanics.operating_points import GasError
from crankstar.spectra import Real, Spectrum
from crankstar.studies.variants import SweepError

MOST_CASES = 2000
"""Engines of one sweep: some ten seconds."""
Case = tuple[Engine, float | None]
"""An engine and the speed at which it turns, rad/s."""


class Gap(NamedTuple):
    """A value of a sweep that has no result: its place among all, and why."""

    place: int
    reason: str


def _mean_torque(engine: Engine, found: Cycle) -> float:  # noqa: ARG001 - all are made alike
    return float(gas_torque(found).mean.sum())


def _peak_pressure(engine: Engine, found: Cycle) -> float:  # noqa: ARG001
    return found.peak


def _irregularity(engine: Engine, found: Cycle) -> float:
    running = driven(engine, found)
    if running is None:
        raise SweepError(
            "the degree of irregularity needs more than the file has: give {keys}",
            keys=", ".join(lacking_keys(engine, found.speed, flywheel=True)),
        )
    return running.irregularity


def torque_of(engine: Engine, found: Cycle, *, highest: float = HIGHEST) -> Spectrum:
    """The torque of gas, and of inertia where speed and masses are known, N m."""
    gas = gas_torque(found, highest=highest).total
    result = balance(engine, speed=found.speed)
    if found.speed is None or result.speed is None:
        return gas
    return added(total(result).torque, gas)


def roll_of(engine: Engine, found: Cycle, *, highest: float = HIGHEST) -> Spectrum:
    """The alternating rolling moment on the block, N m."""
    gas = gas_torque(found, highest=highest).total
    result = balance(engine, speed=found.speed)
    if found.speed is None or result.speed is None:
        return gas_roll(gas, engine.sense)
    return roll_with_gas(total(result), gas)


_NUMBERS: dict[str, tuple[Callable[[Engine, Cycle], float], str]] = {
    "mean_torque": (_mean_torque, "N*m"),
    "peak_pressure": (_peak_pressure, "Pa"),
    "irregularity": (_irregularity, ""),
}
_SPECTRA: dict[str, Callable[..., Spectrum]] = {
    "torque_with_gas": torque_of,
    "roll_with_gas": roll_of,
}
GAS_WATCHABLE = (*_SPECTRA, *_NUMBERS)
"""Torque and roll of gas and inertia together, by order or their peak; the rest have no orders."""


def _value(engine: Engine, found: Cycle, what: str, order: float | None) -> float:
    """One of GAS_WATCHABLE for one engine."""
    if what in _NUMBERS:
        return _NUMBERS[what][0](engine, found)
    if order is None:
        return spectra.peak(_SPECTRA[what](engine, found, highest=ALL)).value
    spectrum = _SPECTRA[what](engine, found)
    return float(np.abs(spectra.amplitude(spectra.selected(spectrum, [order])))[0])


def gas_values(
    cases: Callable[[], Sequence[Case | SweepError]],
    what: str,
    *,
    order: float | None,
    shape: tuple[int, ...],
) -> tuple[Real, str, tuple[Gap, ...]]:
    """One of GAS_WATCHABLE for every case, its unit, and what has none. Raises SweepError."""
    if order is not None and what in _NUMBERS:
        raise SweepError("{what} has no orders; leave --orders out", what=what)

    def value(engine: Engine, speed: float | None) -> float:
        return _value(engine, cycle(engine, speed=speed), what, order)

    unit = _NUMBERS[what][1] if what in _NUMBERS else "N*m"
    values, gaps = one_by_one(cases, value, what, shape=shape)
    return values, unit, gaps


def one_by_one(
    cases: Callable[[], Sequence[Case | SweepError]],
    value: Callable[[Engine, float | None], float],
    what: str,
    *,
    shape: tuple[int, ...],
) -> tuple[Real, tuple[Gap, ...]]:
    """The value of every case, engine by engine, nan where there is none, and why there is none.

    Raises SweepError where no case has a value.
    """
    if prod(shape) > MOST_CASES:
        raise SweepError(
            "{count} values are too many for {what}, which is computed engine by engine; give at "
            "most {most}",
            count=prod(shape),
            what=what,
            most=MOST_CASES,
        )
    out = np.full(prod(shape), np.nan)
    gaps: list[Gap] = []
    for index, case in enumerate(cases()):
        try:
            if isinstance(case, SweepError):
                raise case  # one way for all that has no result
            out[index] = value(*case)
        except (GasError, MountError, SweepError, TorsionError, UnevenError) as error:
            gaps.append(Gap(index, str(error)))
    if len(gaps) == out.size:
        raise SweepError(
            "value {place} of {count}: {reason}", place=1, count=out.size, reason=gaps[0].reason
        )
    return out.reshape(shape), tuple(gaps)
