"""Torsional vibration of each engine of a sweep: first frequency, greatest stress, free end.

Stress and amplitude are the greatest over the cycle, orders with their phases, or those of one
order; over the speeds of the engine's file, or, where the speed is swept, at each speed.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

import numpy as np

from crankstar import spectra
from crankstar.engine.engine import Engine
from crankstar.mechanics.maxima import NEAR
from crankstar.spectra import Real
from crankstar.studies.gas_results import Case, one_by_one
from crankstar.studies.variants import SweepError

if TYPE_CHECKING:
    from crankstar.dynamics.torsion_analysis import TorsionAnalysis
    from crankstar.dynamics.torsion_response import Response

UNITS = {"torsion_frequency": "Hz", "torsion_stress": "MPa", "torsion_amplitude": "deg"}
AT_ONCE = 16
"""Peaks over the cycle that are computed together."""
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
    if what == "torsion_stress" and speed is None and order is None:
        return torsion_peak(engine)
    found = torsion(engine, speeds=[] if speed is None else [speed])
    if found.response is None:
        raise SweepError(
            "{what} needs a speed, and gas or masses: give speed in the engine file", what=what
        )
    return _greatest(found, found.response, what, order)


def torsion_peak(engine: Engine, *, point: str = "") -> float:
    """The greatest shear stress of torsion, Pa, of an operating point over the engine's speeds.

    Between the speeds of the grid too, as `torsion` refines it; peaks over the cycle are computed
    where the sum of amplitudes leaves room for the greatest alone. Raises SweepError where no shaft
    has a diameter or nothing excites it; TorsionError, GasError.
    """
    from crankstar.dynamics.torsion_analysis import peaked, torsion_on_grid

    found = torsion_on_grid(engine, point=point)
    if found.response is None:
        raise SweepError("the stress needs a speed, and gas or masses: give speed and [gas]")
    stress = PeakOfSections(_moduli(found))
    stress(found.response)  # where there is nothing to refine it is all
    peaked(found, curves=stress)
    return stress.greatest


def _greatest(found: TorsionAnalysis, own: Response, what: str, order: float | None) -> float:
    """Over the speeds."""
    place = None if order is None else _place(own, order)
    if what == "torsion_amplitude":
        node = found.free_end
        peak = own.peak_turn(node) if place is None else np.abs(own.turns[:, place, node])
        return float(np.degrees(peak.max()))
    modulus = _moduli(found)
    if place is not None:
        return float(np.nanmax(np.abs(own.torque[:, place]) / modulus))
    return greatest_stress(own, modulus)


def _moduli(found: TorsionAnalysis) -> Real:
    """Torque over stress of each section, m^3, nan without a diameter; raises without any."""
    modulus = np.array([each.modulus or np.nan for each in found.chain.sections])
    if np.all(np.isnan(modulus)):
        raise SweepError(
            "shear stress of torsion needs the diameter of a shaft: give torsion.diameter"
        )
    return modulus


def greatest_stress(own: Response, modulus: Real) -> float:
    """Of all orders with their phases, Pa, at the speeds of a response.

    `modulus` [section]: torque over stress, m^3.
    """
    stress = PeakOfSections(modulus)
    stress(own)
    return stress.greatest


class PeakOfSections:
    """The greatest stress of any section [speed, 1], zero where it is plainly not the greatest.

    `modulus` [section] is torque over stress, m^3; 1 for the greatest torque, nan for no section.

    No peak over the cycle is above the sum of the amplitudes: sections and speeds with the greatest
    sums come first, and those are left out that cannot come near the greatest found so far.
    """

    def __init__(self, modulus: Real) -> None:
        self.modulus = modulus
        self.greatest = 0.0

    def __call__(self, own: Response) -> Real:
        """The stresses at the speeds of a response, Pa."""
        most = np.nan_to_num(own.added / self.modulus)
        order = np.argsort(-most, axis=None)[: np.count_nonzero(most)]
        speeds, sections = np.unravel_index(order, most.shape)
        highest = most[speeds, sections]
        out = np.zeros((len(most), 1))
        for start in range(0, highest.size, AT_ONCE):
            if highest[start] < NEAR * self.greatest:
                break
            rows, some = (each[start : start + AT_ONCE] for each in (speeds, sections))
            waves = spectra.real_signal(own.orders, own.torque[rows, :, some])
            stress = spectra.peaks(waves) / self.modulus[some]
            np.maximum.at(out[:, 0], rows, stress)
            self.greatest = max(self.greatest, float(stress.max()))
        return out


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
