"""How the block stands on its mounts, as records: modes, axes, the vibration at a speed.

Signals are `Re((real + i imaginary) exp(i k theta))`, as in `records`; SI units. Points and vectors
are (up, right, z); freedoms are up, right, z, yaw, pitch, roll about the centre of mass, those of a
foundation behind those of the block.
"""

from __future__ import annotations

from pydantic import Field

from crankstar.page.cycle_records import Wave
from crankstar.page.unit_records import Shown, Table, Unit

Place = tuple[float, float, float]


class MountShown(Shown):
    """A mount of the block, or one below the foundation."""

    name: str
    place: Place
    axes: tuple[Place, Place, Place] = Field(description="the directions of its three axes")
    below: bool = Field(description="whether it is between the foundation and the ground")
    load: Place = Field(description="what it bears at rest: force on what is below it, N")


class MountedMode(Shown):
    """A natural mode of the block on its mounts."""

    number: int
    frequency_hz: float
    damping: float
    energy: tuple[float, ...] = Field(description="the share of each freedom in the kinetic energy")
    shape: tuple[float, ...] = Field(description="how far each freedom goes, m and rad, no size")
    forces: tuple[Place, ...] = Field(
        description="of each mount on what is below it, N at that shape, without damping"
    )


class MountAxis(Shown):
    """A line in the block."""

    point: Place
    direction: Place


class MountVibration(Shown):
    """The forced vibration in all orders at a speed."""

    point: str = Field(description="the operating point whose gas drives; empty without a name")
    gas: bool = Field(description="whether there is gas, or the moving parts alone")
    speed_rpm: float
    peak: bool = Field(description="whether the block shakes more here than at speeds beside it")
    motion: tuple[Wave, ...] = Field(description="of each freedom, m and rad")
    forces: tuple[tuple[Wave, Wave, Wave], ...] = Field(
        description="of each mount on what is below it, N: up, right, z"
    )


class MountsOverSpeed(Shown):
    """What is shaken and passed on over the range of speeds."""

    speeds_rpm: tuple[float, ...]
    displacement: tuple[float, ...] = Field(description="of the point of the block, rms, m")
    velocity: tuple[float, ...] = Field(description="of the point of the block, rms, m/s")
    force: tuple[float, ...] = Field(description="on what the mounts stand on, rms, N")
    transmissibility: tuple[tuple[float | None, ...], ...] = Field(
        description="of each mount of the block; null where nothing pushes"
    )


class Mounts(Shown):
    """The block on its mounts."""

    centres: tuple[Place, ...] = Field(description="of mass, of the block and of a foundation")
    point: Place = Field(description="the point of the block of which motion is told")
    mounts: tuple[MountShown, ...]
    modes: tuple[MountedMode, ...]
    torque_roll: MountAxis
    elastic: MountAxis
    over: MountsOverSpeed | None = Field(description="null where no speed is known")
    orders: tuple[float, ...] = Field(description="of the vibrations")
    vibrations: tuple[MountVibration, ...]


class MountNumbers(Shown):
    """The numbers of the mounts as they are printed, in the units of the page."""

    displacement_unit: Unit = Field(description="from m")
    velocity_unit: Unit = Field(description="from m/s")
    force_unit: Unit = Field(description="from N")
    load_unit: Unit = Field(description="of loads at rest, from N")
    mounts: Table
    modes: Table
    axes: Table
    speeds: Table
    vibrations: tuple[tuple[Table, ...], ...] = Field(
        description="of each vibration: by order, and the forces in the mounts"
    )
    notes: tuple[str, ...]
    doubts: tuple[str, ...]
