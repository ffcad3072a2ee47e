"""Torsional vibration of each engine of a sweep: first frequency, greatest stress, free end.

Stress and amplitude are the greatest over the cycle, orders with their phases, or those of one
order; over the speeds of the engine's file, or, where the speed is swept, at each speed.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

import numpy as np

from crankstar.engine.engine import Engine
from crankstar.spectra import Real
from crankstar.studies.gas_results import Case, one_by_one
from crankstar.studies.variants import SweepError

if TYPE_CHECKING:
    from crankstar.dynamics.torsion_analysis import TorsionAnalysis
    from crankstar.dynamics.torsion_response import Response

UNITS = {"torsion_frequency": "Hz", "torsion_stress": "Pa", "torsion_amplitude": "deg"}
TORSION_WATCHABLE = (*UNITS,)


def torsion_values(
    cases: Callable[[], Sequence[Case]],
    what: str,
    *,
    order: float | None,
    shape: tuple[int, ...],
    speed_swept: bool,
) -> tuple[Real, str]:
    """One of TORSION_WATCHABLE for every case, and its unit. Raises SweepError."""
    if order is not None and what == "torsion_frequency":
        raise SweepError("{what} has no orders; leave --orders out", what=what)

    def value(engine: Engine, speed: float | None) -> float:
        return _value(engine, speed if speed_swept else None, what, order)

    return one_by_one(cases, value, what, shape=shape), UNITS[what]


def _value(engine: Engine, speed: float | None, what: str, order: float | None) -> float:
    """At a speed (rad/s), or the greatest over the range of the engine's own."""
    from crankstar.dynamics.torsion_analysis import resolved, torsion

    found = torsion(engine, speeds=[] if speed is None else [speed])
    if what == "torsion_frequency":
        if not found.modes:
            raise SweepError("nothing twists: all masses are rigidly coupled")
        return found.modes[0].frequency
    if speed is None:
        found = resolved(engine, found)
    if found.response is None:
        raise SweepError(
            "{what} needs a speed, and gas or masses: give speed in the engine file", what=what
        )
    return float(np.max(_course(found, found.response, what, order)))


def _course(found: TorsionAnalysis, own: Response, what: str, order: float | None) -> Real:
    """Over the speeds."""
    place = None if order is None else _place(own, order)
    if what == "torsion_amplitude":
        node = found.free_end
        peak = own.peak_turn(node) if place is None else np.abs(own.turns[:, place, node])
        return np.degrees(peak)
    modulus = np.array([each.modulus or np.nan for each in found.chain.sections])
    torque = own.peak if place is None else np.abs(own.torque[:, place])
    if np.all(np.isnan(modulus)):
        raise SweepError("torsion_stress needs the diameter of a shaft: give torsion.diameter")
    return np.nanmax(torque / modulus, axis=1)


def _place(own: Response, order: float) -> int:
    found = np.flatnonzero(np.abs(own.orders - order) < 1e-9)
    if not found.size:
        raise SweepError(
            "there is no torsional vibration of order {order}; orders go from {first} to {last}",
            order=f"{order:g}",
            first=f"{own.orders[0]:g}",
            last=f"{own.orders[-1]:g}",
        )
    return int(found[0])
