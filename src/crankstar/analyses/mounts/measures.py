"""An engine on its mounts in each variant of a sweep: modes, force on the ground, shake of a point.

Force and velocity are rms values, all orders together or those of one order: the maximum over the
speeds of the engine's file or, where the speed is swept, those at each speed.
"""

from __future__ import annotations

import numpy as np

from crankstar.dynamics.mount_analysis import mounts
from crankstar.dynamics.mount_modes import mount_modes
from crankstar.dynamics.mount_response import rms
from crankstar.dynamics.mount_worst import ROLL, roll_mode
from crankstar.dynamics.mounted_block import MountError, mounted_block
from crankstar.engine.engine import Engine

MODES = tuple(f"mount_mode_{number}" for number in range(1, 7))
MM = 1e3


def measured(
    engine: Engine,
    what: str,
    *,
    speed: float | None = None,
    order: float | None = None,
    alone: bool = False,
) -> float:
    """One of the measures in its unit, over the speeds of the file and `speed` (rad/s).

    `alone`: at this speed only. Raises MountError, GasError.
    """
    if what not in ("mount_force", "mount_velocity"):
        modes = mount_modes(mounted_block(engine))
        if what in MODES:
            return modes[MODES.index(what)].frequency
        roll = modes[roll_mode(modes)]
        return roll.frequency if what == "mount_roll_mode" else float(roll.energy[ROLL])
    orders = None if order is None else [order]
    if alone and speed is not None:
        found = mounts(engine, speeds=[speed], orders=orders)
    else:
        found = mounts(engine, speed=speed, orders=orders)
    if found.over is None:
        raise MountError("{what} needs a speed: give speed in the engine file", what=what)
    if what == "mount_force":
        return float(np.max(rms(found.over.ground_force[..., :3])))
    return MM * float(np.max(rms(found.over.velocity(found.point))))
