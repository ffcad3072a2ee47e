"""What an engine stands on: its mounts, and a foundation that gives way on springs of its own.

A mount has three stiffnesses along axes of its own. By default these point up, right and to the
front; `bearing`, `lean` and `twist` turn them (`engine.rigid_block.mount_axes`).
"""

from __future__ import annotations

from cmath import rect
from typing import Annotated

from pydantic import BeforeValidator, Field

from crankstar.engine.block import BlockPoints
from crankstar.engine.cylinder_parts import Record
from crankstar.engine.quantities import (
    Angle,
    BodyInertia,
    Length,
    Line,
    LinearDamping,
    MountStiffness,
    MovingMass,
    Number,
    PointReceptance,
    Position,
    Speed,
)
from crankstar.engine.torsion import LossFactor, OneOrSeveral, as_list

GREATEST_MOUNTS = 64
RUBBER_LOSS_FACTOR = 0.1
"""Assumed of a mount without damping and loss factor, for which the tables say so."""
ALONG = 3
"""Axes of a mount."""

MountStiffnesses = Annotated[
    tuple[MountStiffness, ...],
    BeforeValidator(as_list),
    OneOrSeveral(),
    Field(min_length=1, max_length=ALONG),
]
Receptances = Annotated[
    tuple[PointReceptance, ...],
    BeforeValidator(as_list),
    OneOrSeveral(),
    Field(min_length=1, max_length=ALONG),
]
Lags = Annotated[
    tuple[Angle, ...],
    BeforeValidator(as_list),
    OneOrSeveral(),
    Field(min_length=1, max_length=ALONG),
]
MountDampings = Annotated[
    tuple[LinearDamping, ...], BeforeValidator(as_list), OneOrSeveral(), Field(max_length=ALONG)
]


class Stiffening(Record):
    """How much stiffer a mount is at a frequency than under a load that stands still.

    >>> Stiffening(frequency=300.0, factor=1.4).factor
    1.4
    """

    frequency: Speed = Field(description="of the vibration", examples=["50 Hz"])
    factor: Annotated[Number, Field(gt=0, le=100)] = Field(
        description="stiffness there over that under a load that stands still", examples=[1.4]
    )


class FootReceptance(Record):
    """How far the place that a mount stands on gives way, per force on it, at a frequency.

    >>> soft = FootReceptance(frequency=300.0, amplitude=[2e-8], lag=[0.5])
    >>> round(abs(soft.along[0]) * 1e9, 9), soft.along[0].imag < 0, len(soft.along)
    (20.0, True, 3)
    """

    frequency: Speed = Field(description="of the vibration", examples=["50 Hz"])
    amplitude: Receptances = Field(
        examples=[["0.02 um/N", "0.005 um/N", "0.005 um/N"]],
        description="displacement per force along the three axes of the mount, or one for all",
    )
    lag: Lags = Field(
        default=(0.0,),
        examples=[["20 deg"]],
        description="of the displacement behind the force, from 0 to 180 deg; one or three",
    )

    @property
    def along(self) -> tuple[complex, ...]:
        """The complex receptance along each axis of the mount, m/N."""
        sizes = self.amplitude * (ALONG if len(self.amplitude) == 1 else 1)
        lags = self.lag * (ALONG if len(self.lag) == 1 else 1)
        return tuple(rect(size, -lag) for size, lag in zip(sizes, lags, strict=True))


class Mount(Record):
    """An elastic mount between the block and what it stands on.

    >>> own = Mount(name="front left", stiffness=[2e5, 1e5, 1e5], loss_factor=0.1)
    >>> own.along, own.viscous, own.loss
    ((200000.0, 100000.0, 100000.0), (0.0, 0.0, 0.0), 0.1)
    """

    name: Line = Field(description="by which results name it")
    up: Length = Field(default=0.0, description="height of its middle over the reference shaft")
    right: Length = Field(
        default=0.0, description="to the right of the reference shaft, seen from the front"
    )
    z: Position = Field(default=0.0, description="along the crankshaft, positive to the front")
    stiffness: MountStiffnesses = Field(
        examples=[["200 N/mm", "80 N/mm", "80 N/mm"]],
        description="along its first, second and third axis, or one for all; 0 where it slides",
    )
    bearing: Angle = Field(
        default=0.0, description="of its first axis in the clock plane, clockwise from up"
    )
    lean: Angle = Field(default=0.0, description="of its first axis to the front")
    twist: Angle = Field(
        default=0.0, description="of its second axis towards its third, about its first"
    )
    damping: MountDampings = Field(
        default=(),
        examples=["150 N*s/m"],
        description="by the speed, along the three axes or one for all",
    )
    loss_factor: LossFactor | None = Field(
        default=None, description="damping by the deflection itself; assumed if both are left out"
    )
    rubber: tuple[Stiffening, ...] = Field(
        default=(),
        max_length=64,
        description=(
            "how it stiffens: factors at rising frequencies, straight between them, from 1 at "
            "rest, and kept beyond the last"
        ),
    )

    foot: tuple[FootReceptance, ...] = Field(
        default=(),
        max_length=1024,
        description=(
            "how what it stands on gives way: receptances at rising frequencies, straight between "
            "them, and kept below the first and beyond the last; still if left out"
        ),
    )

    @property
    def along(self) -> tuple[float, ...]:
        """The stiffness along each of its axes, N/m."""
        return self.stiffness * (ALONG if len(self.stiffness) == 1 else 1)

    @property
    def viscous(self) -> tuple[float, ...]:
        """The damping along each of its axes, N s/m."""
        return (self.damping or (0.0,)) * (ALONG if len(self.damping) < ALONG else 1)

    @property
    def loss(self) -> float:
        """Its loss factor, assumed where no damping is given."""
        if self.loss_factor is not None:
            return self.loss_factor
        return 0.0 if self.damping else RUBBER_LOSS_FACTOR

    @property
    def assumed(self) -> bool:
        """Whether its loss factor is assumed."""
        return self.loss_factor is None and not self.damping


Mounts = Annotated[tuple[Mount, ...], Field(max_length=GREATEST_MOUNTS)]


class Foundation(Record):
    """What the mounts stand on where it gives way: a rigid body on springs of its own.

    >>> spring = Mount(name="ground", stiffness=[1e7])
    >>> Foundation(
    ...     mass=900, inertia_up=80, inertia_right=90, inertia_z=40, mounts=[spring]
    ... ).inertia
    (80.0, 90.0, 40.0)
    """

    mass: MovingMass = Field(description="of the frame or raft", examples=["900 kg"])
    up: Length = Field(
        default=0.0, description="height of its centre of mass over the reference shaft"
    )
    right: Length = Field(
        default=0.0, description="its centre of mass to the right of the reference shaft"
    )
    z: Position = Field(default=0.0, description="its centre of mass, positive to the front")
    inertia_up: BodyInertia = Field(description="about the upward axis through its centre of mass")
    inertia_right: BodyInertia = Field(description="about the axis to the right through it")
    inertia_z: BodyInertia = Field(description="about the axis along z through it")
    mounts: Mounts = Field(description="what it stands on itself; the ground below is rigid")
    points: BlockPoints = Field(
        default=(), description="of the foundation or frame, whose vibration is told too"
    )

    @property
    def inertia(self) -> tuple[float, float, float]:
        """The three moments of inertia: up, right, z."""
        return self.inertia_up, self.inertia_right, self.inertia_z
