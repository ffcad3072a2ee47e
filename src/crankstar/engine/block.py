"""The whole engine as one rigid body, and the points of it that are asked about."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Annotated, NamedTuple

from pydantic import Field

from crankstar.engine.cylinder_parts import Record
from crankstar.engine.quantities import (
    BodyInertia,
    Length,
    Line,
    MovingMass,
    Pitch,
    Position,
    Product,
    Size,
)

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

    mass: MovingMass | None = Field(
        default=None,
        description="of the whole engine, moving parts included; estimated if left out",
        examples=["165 kg"],
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

    length: Pitch | None = Field(
        default=None,
        description="outer size along the crankshaft, from which moments of inertia are estimated",
    )
    width: Size | None = Field(default=None, description="outer size to the right; all three")
    height: Size | None = Field(default=None, description="outer size upward; all three")
    points: BlockPoints = Field(
        default=(), description="whose vibration is told for an engine on its mounts"
    )

    @property
    def products(self) -> tuple[float, float, float]:
        """The products of inertia: up and right, up and z, right and z."""
        return self.product_up_right, self.product_up_z, self.product_right_z

    @property
    def sides(self) -> tuple[float, float, float] | None:
        """The outer size: up, right, z; None where it is not given."""
        if self.length is None or self.width is None or self.height is None:
            return None
        return self.height, self.width, self.length

    @property
    def inertia(self) -> tuple[float, float, float] | None:
        """The three moments of inertia: up, right, z; None where they are not given."""
        if self.inertia_up is None or self.inertia_right is None or self.inertia_z is None:
            return None
        return self.inertia_up, self.inertia_right, self.inertia_z


class BodyEstimate(NamedTuple):
    """Moments of inertia (up, right, z) of a body of a mass in a box: lowest, typical, highest."""

    low: tuple[float, float, float]
    typical: tuple[float, float, float]
    high: tuple[float, float, float]


def inertia_in_box(mass: float, *, sides: Sequence[float]) -> BodyEstimate:
    """About the middle of a box of `sides` a, b, c (up, right, z), of a mass spread in it.

    Typical is the full box, I_z = m (a^2 + b^2)/12; the lowest an ellipsoid that touches it,
    m (a^2 + b^2)/20; the highest its walls alone, thin and even.

    >>> cube = inertia_in_box(12.0, sides=(1.0, 1.0, 1.0))
    >>> cube.low[2], cube.typical[2], round(cube.high[2], 9)  # 12/10, 12/6, 12 * 5/18
    (1.2, 2.0, 3.333333333)
    """
    squares = [side**2 for side in sides]
    others = [sum(squares) - own for own in squares]
    a, b, c = sides
    areas = (b * c, c * a, a * b)  # of a wall square to up, right, z
    walls: list[float] = []
    for axis in range(3):
        inertia = areas[axis] * others[axis] / 12
        for wall in {0, 1, 2} - {axis}:
            rest = others[axis] - squares[wall]
            inertia += areas[wall] * (rest / 12 + squares[wall] / 4)
        walls.append(mass * inertia / sum(areas))
    low, typical = ([mass * each / part for each in others] for part in (20, 12))
    return BodyEstimate(_three(low), _three(typical), _three(walls))


def _three(values: Sequence[float]) -> tuple[float, float, float]:
    up, right, along = values
    return up, right, along
