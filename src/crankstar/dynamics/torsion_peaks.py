"""The maximum shear stress of torsion over the speeds, without all peaks over the cycle."""

from __future__ import annotations

import numpy as np

from crankstar import spectra
from crankstar.dynamics.torsion_analysis import TorsionAnalysis, peaked, torsion_on_grid
from crankstar.dynamics.torsion_response import Response
from crankstar.dynamics.torsion_system import TorsionError
from crankstar.engine.engine import Engine
from crankstar.mechanics.maxima import NEAR
from crankstar.spectra import Real

AT_ONCE = 32
"""Peaks over the cycle that are computed together."""


def torsion_peak(engine: Engine, *, point: str = "") -> float:
    """The maximum shear stress of torsion, Pa, of an operating point over the engine's speeds.

    Between the speeds of the grid too, as `torsion` refines it; peaks over the cycle are computed
    where the sum of amplitudes leaves room for the maximum alone. Raises TorsionError, as where
    no shaft has a diameter or nothing excites it, and GasError.
    """
    found = torsion_on_grid(engine, point=point)
    if found.response is None:
        raise TorsionError("the stress needs a speed, and gas or masses: give speed and [gas]")
    stress = PeakOfSections(moduli(found))
    stress(found.response)  # where there is nothing to refine it is all
    peaked(found, curves=stress)
    return stress.maximum


def moduli(found: TorsionAnalysis) -> Real:
    """Torque over stress of each section, m^3, nan without a diameter; raises without any."""
    modulus = np.array([each.modulus or np.nan for each in found.chain.sections])
    if np.all(np.isnan(modulus)):
        raise TorsionError(
            "shear stress of torsion needs the diameter of a shaft: give torsion.diameter"
        )
    return modulus


def maximum_stress(own: Response, modulus: Real) -> float:
    """Of all orders with their phases, Pa, at the speeds of a response.

    `modulus` [section]: torque over stress, m^3.
    """
    stress = PeakOfSections(modulus)
    stress(own)
    return stress.maximum


class PeakOfSections:
    """The maximum stress of any section [speed, 1], zero where it is plainly not the maximum.

    `modulus` [section] is torque over stress, m^3; 1 for the maximum torque, nan for no section.

    No peak over the cycle is above the sum of the amplitudes: sections and speeds with the
    largest sums come first, and those are left out that cannot come near the maximum found so far.
    """

    def __init__(self, modulus: Real) -> None:
        self.modulus = modulus
        self.maximum = 0.0

    def __call__(self, own: Response) -> Real:
        """The stresses at the speeds of a response, Pa."""
        most = np.nan_to_num(own.added / self.modulus)
        order = np.argsort(-most, axis=None)[: np.count_nonzero(most)]
        speeds, sections = np.unravel_index(order, most.shape)
        highest = most[speeds, sections]
        out = np.zeros((len(most), 1))
        for start in range(0, highest.size, AT_ONCE):
            if highest[start] < NEAR * self.maximum:
                break
            rows, some = (each[start : start + AT_ONCE] for each in (speeds, sections))
            waves = spectra.real_signal(own.orders, own.torque[rows, :, some])
            stress = spectra.peaks(waves) / self.modulus[some]
            np.maximum.at(out[:, 0], rows, stress)
            self.maximum = max(self.maximum, float(stress.max()))
        return out
