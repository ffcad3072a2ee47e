"""The arrays of a torque: by order, of each chamber and of the engine; pressures over a cycle."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from crankstar import spectra
from crankstar.analyses.torque.answer import Torque
from crankstar.analysis.record import Grid
from crankstar.mechanics.gas_torque import gas_torque
from crankstar.tables.torque_orders import by_order


def grids(result: Torque) -> Mapping[str, Grid]:
    """`gas_torque` [chamber, order], N m, complex amplitudes; `pressure` [chamber, theta], Pa.

    `spectra` [order], N m, complex amplitudes: `gas` of all chambers, `inertia` where speed and
    masses are known, both `together`, and `roll`, the rolling moment on the block.

    The angles of the pressures (deg) run from the dead centre at which the chamber fires, those of
    the torque from the zero of the crank angle.
    """
    cycle, torque = result.cycle, gas_torque(result.cycle)
    chambers, samples = [*torque.numbers], cycle.pressure.shape[-1]
    waves = by_order(result.engine, cycle, torque)
    each = {
        "gas": (waves.gas, "gas torque"),
        "inertia": (waves.inertia, "inertia torque"),
        "together": (waves.total, "gas and inertia torque"),
        "roll": (waves.roll, "rolling moment on the block"),
    }
    return {
        "gas_torque": Grid(
            {"chamber": chambers, "order": torque.torque.orders},
            {
                "torque": (("chamber", "order"), spectra.amplitude(torque.torque), "N*m"),
                "mean": (("chamber",), torque.mean, "N*m"),
            },
            {"torque": "gas torque", "mean": "mean gas torque"},
        ),
        "spectra": Grid(
            {"order": waves.orders},
            {
                name: (("order",), wave, "N*m")
                for name, (wave, _words) in each.items()
                if wave is not None
            },
            {name: words for name, (_wave, words) in each.items()},
        ),
        "pressure": Grid(
            {
                "chamber": chambers,
                "theta_deg": np.degrees(cycle.volumes.cycle) * np.arange(samples) / samples,
            },
            {"pressure": (("chamber", "theta_deg"), cycle.pressure, "Pa")},
        ),
    }
