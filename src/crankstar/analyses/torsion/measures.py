"""Torsional vibration of each engine of a sweep: first frequency, maximum stress, free end.

Stress and amplitude are the maximum over the cycle, orders with their phases, or those of one
order; over the speeds of the engine's file, or, where the speed is swept, at each speed.
"""

from __future__ import annotations

import numpy as np

from crankstar.dynamics.torsion_analysis import TorsionAnalysis, torsion
from crankstar.dynamics.torsion_chain import torsion_chain
from crankstar.dynamics.torsion_modes import torsion_modes
from crankstar.dynamics.torsion_peaks import maximum_stress, moduli, torsion_peak
from crankstar.dynamics.torsion_response import Response
from crankstar.dynamics.torsion_system import TorsionError
from crankstar.engine.engine import Engine


def measured(
    engine: Engine,
    what: str,
    *,
    speed: float | None = None,
    order: float | None = None,
    alone: bool = False,
) -> float:
    """One of the measures in its unit, over the range of the engine's own, or `alone` at a speed.

    Raises TorsionError, GasError.
    """
    speed = speed if alone else None
    if what == "torsion_frequency":
        modes = torsion_modes(torsion_chain(engine))
        if not modes:
            raise TorsionError("nothing twists: all masses are rigidly coupled")
        return modes[0].frequency
    if what == "torsion_stress" and speed is None and order is None:
        return torsion_peak(engine) / 1e6
    found = torsion(engine, speeds=[] if speed is None else [speed])
    if found.response is None:
        raise TorsionError(
            "{what} needs a speed, and gas or masses: give speed in the engine file", what=what
        )
    return _maximum(found, found.response, what, order)


def _maximum(found: TorsionAnalysis, own: Response, what: str, order: float | None) -> float:
    """Over the speeds."""
    place = None if order is None else _place(own, order)
    if what == "torsion_amplitude":
        node = found.free_end
        peak = own.peak_turn(node) if place is None else np.abs(own.turns[:, place, node])
        return float(np.degrees(peak.max()))
    modulus = moduli(found)
    if place is not None:
        return float(np.nanmax(np.abs(own.torque[:, place]) / modulus)) / 1e6
    return maximum_stress(own, modulus) / 1e6


def _place(own: Response, order: float) -> int:
    found = np.flatnonzero(np.abs(own.orders - order) < 1e-9)
    if not found.size:
        raise TorsionError(
            "there is no torsional vibration of order {order}; orders go from {first} to {last}",
            order=f"{order:g}",
            first=f"{own.orders[0]:g}",
            last=f"{own.orders[-1]:g}",
        )
    return int(found[0])
