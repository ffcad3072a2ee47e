"""The arrays of an engine on its mounts: how it shakes by speed, order and mount."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from crankstar.analysis.record import Grid
from crankstar.dynamics.mount_analysis import MountAnalysis
from crankstar.language.numbers import rpm_of

AXES = ("up", "right", "z")


def grids(result: MountAnalysis) -> Mapping[str, Grid]:
    """`over`: the vibration over the range of speeds, where one is known.

    Of the point that is asked for displacement and velocity, of each mount the force on what it
    stands on; amplitudes c of Re(c exp(i order theta)), SI.
    """
    over = result.over
    if over is None:
        return {}
    point, mount = ("speed_rpm", "order", "axis"), ("speed_rpm", "order", "mount", "mount_axis")
    return {
        "over": Grid(
            {
                "speed_rpm": np.array([*map(rpm_of, over.speeds.tolist())]),
                "order": over.orders,
                "axis": [*AXES],
                "mount": [
                    each.name or str(number)
                    for number, each in enumerate(result.block.mounts, start=1)
                ],
                "mount_axis": [1, 2, 3],
            },
            {
                "displacement": (point, over.displacement(result.point), "m"),
                "velocity": (point, over.velocity(result.point), "m/s"),
                "force": (mount, over.mount_force, "N"),
            },
        )
    }
