"""Torsional vibration of each engine of a sweep: first frequency, greatest stress, free end.

Stress and amplitude are the greatest over the cycle, orders with their phases, or those of one
order; over the speeds of the engine's file, or, where the speed is swept, at each speed.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from crankstar.engine.engine import Engine
from crankstar.spectra import Real
from crankstar.studies.gas_results import Case, one_by_one
from crankstar.studies.variants import SweepError

if TYPE_CHECKING:
    from crankstar.dynamics.torsion_analysis import TorsionAnalysis
    from crankstar.dynamics.torsion_response import Response

UNITS = {"torsion_frequency": "Hz", "torsion_stress": "MPa", "torsion_amplitude": "deg"}
AT_ONCE = 8
"""Speeds whose stresses are computed together."""
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
        size = _value(engine, speed if speed_swept else None, what, order)
        return size / 1e6 if what == "torsion_stress" else size

    return one_by_one(cases, value, what, shape=shape), UNITS[what]


def _value(engine: Engine, speed: float | None, what: str, order: float | None) -> float:
    """At a speed (rad/s), or the greatest over the range of the engine's own."""
    from crankstar.dynamics.torsion_analysis import torsion
    from crankstar.dynamics.torsion_chain import torsion_chain
    from crankstar.dynamics.torsion_modes import torsion_modes

    if what == "torsion_frequency":
        modes = torsion_modes(torsion_chain(engine))
        if not modes:
            raise SweepError("nothing twists: all masses are rigidly coupled")
        return modes[0].frequency
    found = torsion(engine, speeds=[] if speed is None else [speed])
    if found.response is None:
        raise SweepError(
            "{what} needs a speed, and gas or masses: give speed in the engine file", what=what
        )
    return _greatest(found, found.response, what, order)


def torsion_peak(engine: Engine, *, point: str = "") -> float:
    """The greatest shear stress of torsion, Pa, of an operating point over the engine's speeds.

    Raises SweepError where no shaft has a diameter or nothing excites it; TorsionError, GasError.
    """
    from crankstar.dynamics.torsion_analysis import torsion

    found = torsion(engine, point=point)
    if found.response is None:
        raise SweepError("the stress needs a speed, and gas or masses: give speed and [gas]")
    return _greatest(found, found.response, "torsion_stress", None)


def _greatest(found: TorsionAnalysis, own: Response, what: str, order: float | None) -> float:
    """Over the speeds."""
    place = None if order is None else _place(own, order)
    if what == "torsion_amplitude":
        node = found.free_end
        peak = own.peak_turn(node) if place is None else np.abs(own.turns[:, place, node])
        return float(np.degrees(peak.max()))
    modulus = np.array([each.modulus or np.nan for each in found.chain.sections])
    if np.all(np.isnan(modulus)):
        raise SweepError(
            "shear stress of torsion needs the diameter of a shaft: give torsion.diameter"
        )
    if place is not None:
        return float(np.nanmax(np.abs(own.torque[:, place]) / modulus))
    return greatest_stress(own, modulus)


def greatest_stress(own: Response, modulus: Real) -> float:
    """Of all orders with their phases, Pa, over the speeds of a response.

    No peak is above the sum of the amplitudes: the speeds with the greatest sums come first, and
    the others are left out once none can have more. `modulus` [section]: torque over stress, m^3.
    """
    most = np.nanmax(own.added / modulus, axis=1)
    order = np.argsort(-most)
    best = 0.0
    for start in range(0, order.size, AT_ONCE):
        rows = order[start : start + AT_ONCE]
        if most[rows[0]] <= best:
            break
        names = ("speeds", "turns", "twist", "torque", "driving")
        some = replace(own, **{name: getattr(own, name)[rows] for name in names})
        best = max(best, float(np.nanmax(some.peak / modulus)))
    return best


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
