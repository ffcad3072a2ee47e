"""The arrays of a torque: pressures over a cycle, the torque of each chamber by order."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from crankstar import spectra
from crankstar.analyses.torque.answer import Torque
from crankstar.analysis.record import Grid
from crankstar.mechanics.gas_torque import gas_torque


def grids(result: Torque) -> Mapping[str, Grid]:
    """`gas_torque` [chamber, order], N m, complex amplitudes; `pressure` [chamber, theta], Pa.

    The angles of the pressures (deg) run from the dead centre at which the chamber fires, those of
    the torque from the zero of the crank angle.
    """
    cycle, torque = result.cycle, gas_torque(result.cycle)
    chambers, samples = [*torque.numbers], cycle.pressure.shape[-1]
    return {
        "gas_torque": Grid(
            {"chamber": chambers, "order": torque.torque.orders},
            {
                "torque": (("chamber", "order"), spectra.amplitude(torque.torque), "N*m"),
                "mean": (("chamber",), torque.mean, "N*m"),
            },
        ),
        "pressure": Grid(
            {
                "chamber": chambers,
                "theta_deg": np.degrees(cycle.volumes.cycle) * np.arange(samples) / samples,
            },
            {"pressure": (("chamber", "theta_deg"), cycle.pressure, "Pa")},
        ),
    }
