"""The arrays of torsional vibration: what the shaft does by speed, order and place."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from crankstar.analysis.record import Grid
from crankstar.dynamics.torsion_analysis import TorsionAnalysis
from crankstar.language.numbers import rpm_of


def grids(result: TorsionAnalysis) -> Mapping[str, Grid]:
    """`response` over speed, order and place, where it vibrates; `shapes` of the free modes.

    Angles in radians, torques in N m; amplitudes c of Re(c exp(i order theta)).
    """
    chain = result.chain
    found = {
        "shapes": Grid(
            {
                "mode": [mode.number for mode in result.modes],
                "mass": [*chain.names],
                "frequency_hz": ("mode", [mode.frequency for mode in result.modes]),
            },
            {
                "shape": (
                    ("mode", "mass"),
                    np.array([mode.shape for mode in result.modes]).reshape(
                        len(result.modes), len(chain.names)
                    ),
                    "",
                )
            },
        )
    }
    response = result.response
    if response is None:
        return found
    angle, section = ("speed_rpm", "order", "mass"), ("speed_rpm", "order", "section")
    return {
        "response": Grid(
            {
                "speed_rpm": np.array([*map(rpm_of, response.speeds.tolist())]),
                "order": response.orders,
                "mass": [*chain.names],
                "section": [
                    f"{chain.names[each.before]} - {chain.names[each.after]}"
                    for each in chain.sections
                ],
            },
            {
                "turn": (angle, response.turns, "rad"),
                "twist": (section, response.twist, "rad"),
                "torque": (section, response.torque, "N*m"),
                "driving": (angle, response.driving, "N*m"),
            },
        ),
        **found,
    }
