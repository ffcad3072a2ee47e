"""What belongs to one cylinder: its rod, and the parts that a balancing shop weighs."""

from __future__ import annotations

from typing import Any

from pydantic import BaseModel, ConfigDict, Field

from crankstar.engine.quantities import Angle, Inertia, Length, Mass, MovingMass, Ordinal, Size


class Record(BaseModel):
    """What all records share: frozen, no unknown keys, names or file keys accepted."""

    model_config = ConfigDict(
        frozen=True, extra="forbid", validate_by_name=True, validate_by_alias=True, defer_build=True
    )


def without_required(*names: str) -> Any:
    """A change of a JSON Schema: what a file may leave out since its parts say it."""

    def changed(schema: dict[str, Any]) -> None:
        schema["required"] = [name for name in schema.get("required", []) if name not in names]

    return changed


def required_without_parts(*names: str) -> Any:
    """A change of the JSON Schema of a cylinder: it needs these where it has no parts.

    A rod needs its mass and its centre where the parts lack one of its ends.
    """
    ends = {"parts": {"required": [*ENDS]}}

    def changed(schema: dict[str, Any]) -> None:
        without_required(*names)(schema)
        whole = {"properties": {"rod": {"required": ["mass", "centre"]}}}
        schema["allOf"] = [
            {"if": {"not": {"required": ["parts"]}}, "then": {"required": [*names]}},
            {"if": {"not": {"required": ["parts"], "properties": ends}}, "then": whole},
        ]

    return changed


class Rod(Record):
    """A connecting rod as a rigid body.

    Its mass, the distance of its centre of mass from the big end, its inertia about that centre.
    Without an inertia mass and centre imply two masses at its ends.

    >>> Rod(mass=0.6, centre=0.04, inertia=0.002).mass
    0.6
    """

    model_config = ConfigDict(json_schema_extra=without_required("mass", "centre"))

    mass: MovingMass = Field(
        description="mass of the whole rod; both ends together where parts give them"
    )
    centre: Length = Field(
        description=(
            "from the big end to the centre of mass, along the rod; by the two ends where parts "
            "give them"
        )
    )
    inertia: Inertia | None = Field(
        default=None,
        examples=["2 g*m^2"],
        description=(
            "moment of inertia about the centre of mass; that of two masses at its ends if left out"
        ),
    )

    def shares(self, rod_length: float) -> tuple[float, float]:
        """Its mass divided between crank pin and piston pin as its centre of mass divides it.

        >>> [round(share, 3) for share in Rod(mass=0.6, centre=0.05).shares(0.15)]
        [0.4, 0.2]
        """
        share = self.centre / rod_length
        return self.mass * (1 - share), self.mass * share

    def turning_inertia(self, rod_length: float) -> float:
        """Its moment of inertia about its centre of mass, kg m^2: as given, else m c (l - c).

        That of its mass divided between its ends; none where the centre is not between them.

        >>> round(Rod(mass=0.6, centre=0.05).turning_inertia(0.15), 6)
        0.003
        """
        if self.inertia is not None:
            return self.inertia
        return max(0.0, self.mass * self.centre * (rod_length - self.centre))


class Articulation(Record):
    """A knuckle pin on another cylinder's rod; an articulated (slave) rod's big end sits on it."""

    master: Ordinal = Field(description="number of the cylinder whose rod carries the knuckle pin")
    radius: Size = Field(description="from the crank pin to the knuckle pin")
    angle: Angle = Field(
        description="from the master rod to the knuckle pin, about the crank pin, clockwise"
    )


class Parts(Record):
    """The parts of one cylinder as a balancing shop weighs them.

    Piston, pin, locks, rings and the small end of the rod go up and down; the big end of the rod,
    its bearing shells and the oil in them turn with the crank pin. What a crank pin with two rods
    has of oil is divided between its cylinders.

    >>> parts = Parts(piston=0.51, pin=0.142, locks=0.002, rings=0.046, small_end=0.178)
    >>> round(parts.reciprocating, 9), parts.rotating
    (0.878, 0.0)
    """

    piston: Mass = Field(default=0.0, description="bare piston; goes up and down")
    pin: Mass = Field(default=0.0, description="piston pin; goes up and down")
    locks: Mass = Field(default=0.0, description="locks of the piston pin, both; go up and down")
    rings: Mass = Field(default=0.0, description="all rings of the piston; go up and down")
    small_end: Mass = Field(
        default=0.0, description="small end of the rod as it hangs on a scale; goes up and down"
    )
    big_end: Mass = Field(
        default=0.0,
        description="big end of the rod as it hangs on a scale, bolts included; turns with the pin",
    )
    bearing_shells: Mass = Field(
        default=0.0, description="both shells of the rod bearing; turn with the pin"
    )
    oil: Mass = Field(
        default=0.0, description="oil in this cylinder's rod bearing; turns with the pin"
    )

    @property
    def reciprocating(self) -> float:
        """The mass that goes up and down."""
        return sum(getattr(self, name) for name in RECIPROCATING)

    @property
    def rotating(self) -> float:
        """The mass that turns with the crank pin."""
        return sum(getattr(self, name) for name in ROTATING)


RECIPROCATING = ("piston", "pin", "locks", "rings", "small_end")
ROTATING = ("big_end", "bearing_shells", "oil")
ENDS = ("small_end", "big_end")
"""Parts that are the rod."""
