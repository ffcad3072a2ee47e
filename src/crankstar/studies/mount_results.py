"""An engine on its mounts in each variant of a sweep: modes, force on the ground, shake of a point.

Force and velocity are rms values, all orders together or those of one order: the greatest over the
speeds of the engine's file or, where the speed is swept, those at each speed.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from crankstar.engine.engine import Engine
from crankstar.spectra import Real
from crankstar.studies.gas_results import Case, one_by_one
from crankstar.studies.variants import SweepError

MODES = tuple(f"mount_mode_{number}" for number in range(1, 7))
UNITS = {
    **dict.fromkeys(MODES, "Hz"),
    "mount_roll_mode": "Hz",
    "mount_roll_share": "",
    "mount_force": "N",
    "mount_velocity": "mm/s",
}
MOUNT_WATCHABLE = (*UNITS,)
MM = 1e3


def mount_values(
    cases: Callable[[], Sequence[Case]],
    what: str,
    *,
    order: float | None,
    shape: tuple[int, ...],
    speed_swept: bool,
) -> tuple[Real, str]:
    """One of MOUNT_WATCHABLE for every case, and its unit. Raises SweepError."""
    if order is not None and what not in ("mount_force", "mount_velocity"):
        raise SweepError("{what} has no orders; leave --orders out", what=what)

    def value(engine: Engine, speed: float | None) -> float:
        return mount_value(engine, what, speed=speed, order=order, alone=speed_swept)

    return one_by_one(cases, value, what, shape=shape), UNITS[what]


def mount_value(
    engine: Engine,
    what: str,
    *,
    speed: float | None = None,
    order: float | None = None,
    alone: bool = False,
) -> float:
    """One of MOUNT_WATCHABLE, in its unit, over the speeds of the file and `speed` (rad/s).

    `alone`: at this speed only. Raises SweepError, MountError.
    """
    from crankstar.dynamics.mount_analysis import mounts
    from crankstar.dynamics.mount_modes import mount_modes
    from crankstar.dynamics.mount_response import rms
    from crankstar.dynamics.mount_worst import ROLL, roll_mode
    from crankstar.dynamics.mounted_block import mounted_block

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
        raise SweepError("{what} needs a speed: give speed in the engine file", what=what)
    if what == "mount_force":
        return float(np.max(rms(found.over.ground_force[..., :3])))
    return MM * float(np.max(rms(found.over.velocity(found.point))))
