"""The whole engine as one rigid body, and the points of it that are asked about."""

from __future__ import annotations

from typing import Annotated

from pydantic import Field

from crankstar.engine.cylinder_parts import Record
from crankstar.engine.quantities import BodyInertia, Length, Line, MovingMass, Position, Product

MOST_POINTS = 64


class BlockPoint(Record):
    """A point of the block, or of what is bolted to it: a grip, a seat, the end of a gearbox.

    >>> BlockPoint(name="left grip", up=0.6, right=-0.35, z=-0.2).place
    (0.6, -0.35, -0.2)
    """

    name: Line = Field(description="by which results name it")
    up: Length = Field(default=0.0, description="height over the reference shaft")
    right: Length = Field(
        default=0.0, description="to the right of the reference shaft, seen from the front"
    )
    z: Position = Field(default=0.0, description="along the crankshaft, positive to the front")

    @property
    def place(self) -> tuple[float, float, float]:
        """Up, right, z."""
        return self.up, self.right, self.z


BlockPoints = Annotated[tuple[BlockPoint, ...], Field(max_length=MOST_POINTS)]


class Block(Record):
    """The whole engine as one rigid body: mass, centre of mass, moments of inertia.

    All of it, as it hangs on its mounts, moving parts included; about z without crankshaft and
    flywheel, which turn on whatever the block does. What is left out is estimated where it is
    needed, and marked so.
    """

    mass: MovingMass = Field(
        description="of the whole engine, moving parts included", examples=["165 kg"]
    )
    up: Length = Field(
        default=0.0, description="height of its centre of mass over the reference shaft"
    )
    right: Length = Field(
        default=0.0,
        description="its centre of mass to the right of the reference shaft, seen from the front",
    )
    z: Position | None = Field(
        default=None,
        description=(
            "its centre of mass, positive to the front; the middle of the cylinders if left out"
        ),
    )
    inertia_up: BodyInertia | None = Field(
        default=None,
        description="about the upward axis through its centre of mass (yaw); all three or none",
    )
    inertia_right: BodyInertia | None = Field(
        default=None, description="about the axis to the right through its centre of mass (pitch)"
    )
    inertia_z: BodyInertia | None = Field(
        default=None,
        description=(
            "about the axis along z through its centre of mass (roll), without crankshaft and "
            "flywheel"
        ),
    )
    product_up_right: Product = Field(
        default=0.0,
        description=(
            "product of inertia: the integral of up times right over the mass, about its centre; "
            "for mounts, the free response is without"
        ),
    )
    product_up_z: Product = Field(default=0.0, description="the same of up times z")
    product_right_z: Product = Field(default=0.0, description="the same of right times z")

    points: BlockPoints = Field(
        default=(), description="whose vibration is told for an engine on its mounts"
    )

    @property
    def products(self) -> tuple[float, float, float]:
        """The products of inertia: up and right, up and z, right and z."""
        return self.product_up_right, self.product_up_z, self.product_right_z

    @property
    def inertia(self) -> tuple[float, float, float] | None:
        """The three moments of inertia: up, right, z; None where they are not given."""
        if self.inertia_up is None or self.inertia_right is None or self.inertia_z is None:
            return None
        return self.inertia_up, self.inertia_right, self.inertia_z
