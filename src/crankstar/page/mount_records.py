"""How the block stands on its mounts, as records: modes, axes, what shakes it at any speed.

Signals are `Re((real + i imaginary) exp(i k theta))`, as in `records`; SI units. Points and vectors
are (up, right, z); freedoms are up, right, z, yaw, pitch, roll about the centre of mass, those of a
foundation behind those of the block.
"""

from __future__ import annotations

from pydantic import Field

from crankstar.page.cycle_records import Wave
from crankstar.page.unit_records import Pair, Shown, Table, Unit

Place = tuple[float, float, float]
Row = tuple[float, ...]


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


class MountedPoint(Shown):
    """A point of the block or of the foundation, and how it shakes over the range of speeds."""

    name: str
    place: Place
    below: bool = Field(description="whether it is of the foundation")
    displacement: tuple[float, ...] = Field(description="rms, m; empty where no speed is known")
    velocity: tuple[float, ...] = Field(description="rms, m/s")


class MountVibration(Shown):
    """A speed of note, at which the block may be shown."""

    point: str = Field(description="the operating point whose gas drives; empty without a name")
    gas: Wave | None = Field(
        description="of that point on the roll of the block, N m; null: as over the speeds"
    )
    speed_rpm: float
    peak: bool = Field(
        description="whether the block is in resonance here: shakes more than at speeds beside it"
    )


class MountsOverSpeed(Shown):
    """What is passed on over the range of speeds."""

    speeds_rpm: tuple[float, ...]
    force: tuple[float, ...] = Field(description="on what the mounts stand on, rms, N")
    transmissibility: tuple[tuple[float | None, ...], ...] = Field(
        description="of each mount of the block; null where it would bear next to nothing"
    )


class Spring(Shown):
    """A mount as a spring: what the freedoms do along its axes, and what it does against that.

    Angular frequencies in rad/s; straight between those that are given.
    """

    arms: tuple[Row, Row, Row]
    stiffness: Place = Field(description="along each axis under a load that stands still, N/m")
    damping: Place = Field(description="along each axis, N s/m")
    loss: float
    stiffening: tuple[tuple[float, float], ...] = Field(
        description="frequency, and factor of the stiffness; from 1 at 0"
    )
    foot: tuple[tuple[float, Pair, Pair, Pair], ...] = Field(
        description="frequency, and receptance of what it stands on along each axis, m/N"
    )


class Driving(Shown):
    """What shakes the block, and what it has against it: at any speed the answer follows.

    -W^2 M + i W C + K(W) at W = k w, as in `dynamics.mounted_block`; the force of order k is that
    of the moving parts times w^2, and the gas on the roll.
    """

    mass: tuple[Row, ...] = Field(description="M of the freedoms, kg, kg m and kg m^2")
    springs: tuple[Spring, ...]
    inertia: tuple[Wave, ...] = Field(description="on each freedom of the block at 1 rad/s")
    gas_speeds: tuple[float, ...] = Field(
        description="rad/s, rising, at which the gas is known; empty without gas"
    )
    gas: tuple[Wave, ...] = Field(
        description="on the roll of the block at these, N m; straight between, kept beyond"
    )


class Mounts(Shown):
    """The block on its mounts."""

    centres: tuple[Place, ...] = Field(description="of mass, of the block and of a foundation")
    points: tuple[MountedPoint, ...] = Field(
        description="of which motion can be told; the first unless another is chosen"
    )
    mounts: tuple[MountShown, ...]
    modes: tuple[MountedMode, ...]
    torque_roll: MountAxis
    elastic: MountAxis
    over: MountsOverSpeed | None = Field(description="null where no speed is known")
    orders: tuple[float, ...] = Field(description="of what shakes it")
    driving: Driving | None = Field(description="null where no speed is known")
    vibrations: tuple[MountVibration, ...]


class MountNumbers(Shown):
    """The numbers of the mounts as they are printed, in the units of the page."""

    displacement_unit: Unit = Field(description="from m")
    velocity_unit: Unit = Field(description="from m/s")
    acceleration_unit: Unit = Field(description="from m/s^2")
    force_unit: Unit = Field(description="from N")
    heat_unit: Unit = Field(description="from W")
    load_unit: Unit = Field(description="of loads at rest, from N")
    mounts: Table
    modes: Table
    axes: Table
    speeds: Table = Field(description="of the first point")
    notes: tuple[str, ...]
    doubts: tuple[str, ...]
