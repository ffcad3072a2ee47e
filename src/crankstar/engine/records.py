"""The frozen records of an engine, in SI: shafts, throws, cylinders, rods, block, provenance.

Bearings and positions are those of the clock plane: `up` and `right` seen from the front, angles
clockwise from up, z positive to the front. What they must be together is checked by `engine`.
"""

from __future__ import annotations

from fractions import Fraction
from typing import Annotated, Any, Literal

from pydantic import BeforeValidator, ConfigDict, Field
from pydantic_core import PydanticKnownError

from crankstar.engine.block import Block as Block
from crankstar.engine.block import BlockPoint as BlockPoint
from crankstar.engine.cylinder_parts import Articulation as Articulation
from crankstar.engine.cylinder_parts import Parts as Parts
from crankstar.engine.cylinder_parts import Record as Record
from crankstar.engine.cylinder_parts import Rod as Rod
from crankstar.engine.cylinder_parts import required_without_parts
from crankstar.engine.drive import Drive as Drive
from crankstar.engine.gas import Gas as Gas
from crankstar.engine.mounts import Foundation as Foundation
from crankstar.engine.mounts import Mounts
from crankstar.engine.oil import Oil as Oil
from crankstar.engine.provenance import Provenance as Provenance
from crankstar.engine.quantities import (
    Angle,
    BearingStiffness,
    BendingStiffness,
    Cycle,
    Length,
    Line,
    Mass,
    Ordinal,
    Position,
    Rotation,
    Size,
    Speed,
    SpeedRatio,
    Text,
    Unbalance,
)
from crankstar.engine.torsion import Torsion as Torsion

GREATEST_CYLINDERS = 256
GREATEST_THROWS = 256
"""Throws of one shaft; main bearings and webs as well."""
GREATEST_PARTS = 32
"""Parts that a file may name without describing them."""
GREATEST_WEIGHTS = 4 * GREATEST_THROWS
"""Weights of one shaft: on both webs of each throw, and as many of its file."""

Bearings = Annotated[
    tuple[Position, ...],
    Field(
        max_length=GREATEST_THROWS + 1,
        examples=[["0.19 m", "0 m", "-0.19 m"]],
        description=(
            "middles of the main bearings from front to rear, z; assumed beside the throws if left "
            "out"
        ),
    ),
]
BearingCount = Annotated[
    Annotated[int, Field(strict=True, ge=2, le=GREATEST_THROWS + 1)] | None,
    Field(
        description=(
            "number of main bearings, where their places are not known; one more than throws if "
            "left out"
        )
    ),
]
Webs = Annotated[
    tuple[Position, ...],
    Field(
        max_length=2 * GREATEST_THROWS,
        examples=[["0.12 m", "0.07 m"]],
        description=(
            "middles of the crank webs from front to rear, z; between pins and bearings if left out"
        ),
    ),
]
CrankBending = Annotated[
    BendingStiffness | None,
    Field(description="E I of the shaft as a beam, for bearing loads; with bearing_stiffness"),
]
BearingSupport = Annotated[
    BearingStiffness | None,
    Field(description="of each main bearing with its wall; with bending_stiffness; else rigid"),
]


class Throw(Record):
    """A crank throw: pin bearing at theta = 0, crank radius, z, masses at the radius.

    `rotating_mass` hangs on the pin, and a bobweight stands for it on the balancing machine;
    `throw_mass` is the crankshaft's own, and is part of it there too.

    >>> Throw(angle=0.0, radius=0.04, rotating_mass=0.9, throw_mass=0.25).turning_mass
    1.15
    """

    angle: Angle = Field(description="bearing of the pin at theta = 0, clockwise from up")
    radius: Size = Field(description="crank radius, half the stroke")
    z: Position = Field(default=0.0, description="middle of the pin, positive to the front")
    rotating_mass: Mass = Field(
        default=0.0,
        description=(
            "what hangs on the pin, at crank radius: rod big ends, bearing shells, oil; "
            "in the bobweight"
        ),
    )
    throw_mass: Mass = Field(
        default=0.0,
        description=(
            "the crankshaft's own unbalance, as a mass at crank radius: crank pin and webs without "
            "counterweights; never in the bobweight"
        ),
    )

    @property
    def turning_mass(self) -> float:
        """All that turns at the crank radius."""
        return self.rotating_mass + self.throw_mass


class Weight(Record):
    """A counterweight, eccentric or balance weight on a shaft; unbalance is mass times radius.

    >>> Weight(unbalance=0.02, angle=3.14, z=0.1).throw is None
    True
    """

    unbalance: Unbalance = Field(description="mass times radius of its centre")
    angle: Angle = Field(description="bearing at theta = 0, clockwise from up")
    z: Position = Field(default=0.0, description="place along the shaft, positive to the front")
    throw: Ordinal | None = Field(
        default=None,
        description="number of the throw it turns with; the nearest along the shaft if left out",
    )


class Shaft(Record):
    """A shaft parallel to the reference crankshaft, the first of all, and geared to it.

    >>> balancer = Shaft(name="balancer", speed_ratio=-1)
    >>> str(balancer.speed_ratio), len(balancer.throws)
    ('-1', 0)
    """

    name: Line = Field(description="by which cylinders refer to it")
    speed_ratio: SpeedRatio = Field(
        default=Fraction(1),
        description="turns per turn of the reference shaft; negative turns the other way",
    )
    up: Length = Field(default=0.0, description="height of its axis over the reference shaft")
    right: Length = Field(
        default=0.0, description="its axis to the right of the reference shaft, seen from the front"
    )
    throws: tuple[Throw, ...] = Field(
        default=(),
        validation_alias="throw",
        serialization_alias="throw",
        max_length=GREATEST_THROWS,
        description="its crank throws",
    )
    weights: tuple[Weight, ...] = Field(
        default=(),
        validation_alias="weight",
        serialization_alias="weight",
        max_length=GREATEST_WEIGHTS,
        description="its counterweights and balance weights",
    )
    bearings: Bearings = ()
    bearing_count: BearingCount = None
    webs: Webs = ()
    bending_stiffness: CrankBending = None
    bearing_stiffness: BearingSupport = None


class Cylinder(Record):
    """A cylinder with its piston and rod; `throw` counts from one on `shaft`.

    >>> cylinder = Cylinder(
    ...     number=1, shaft="crank", throw=1, rod_length=0.14, reciprocating_mass=0.5
    ... )
    >>> cylinder.bearing, cylinder.offset
    (0.0, 0.0)
    """

    model_config = ConfigDict(json_schema_extra=required_without_parts("reciprocating_mass"))

    number: Ordinal = Field(description="unique; cylinder 1 is the frontmost")
    shaft: Line = Field(description="name of the shaft its rod works on")
    throw: Ordinal = Field(description="which throw of that shaft, counted from 1")
    bearing: Angle = Field(default=0.0, description="where the cylinder points, clockwise from up")
    z: Position = Field(default=0.0, description="middle of the cylinder, positive to the front")
    offset: Length = Field(
        default=0.0, description="its axis passes this far clockwise of the shaft axis"
    )
    bore: Size | None = Field(default=None, description="cylinder diameter")
    rod_length: Size = Field(description="connecting rod between centres")
    reciprocating_mass: Mass = Field(
        description=(
            "piston, pin, locks, rings; and the rod's small end unless `rod` is given; the sum of "
            "its parts where these are given"
        )
    )
    big_end_mass: Mass = Field(
        default=0.0,
        description=(
            "rod mass carried by the pin of its big end, where it is not in the throw's "
            "(slave rods, unequal rods on one pin)"
        ),
    )
    rod: Rod | None = Field(
        default=None, description="the rod as a rigid body, instead of shares in the two masses"
    )
    parts: Parts | None = Field(
        default=None, description="the parts as weighed; the masses are their sums"
    )
    articulated: Articulation | None = Field(
        default=None, description="the rod sits on a knuckle pin of another rod"
    )
    chamber: Ordinal | None = Field(
        default=None,
        description=(
            "combustion chamber; pistons with the same one share it; the cylinder's own "
            "number if left out"
        ),
    )
    bank: Line | None = Field(default=None, description="name of the bank it belongs to")

    @property
    def reciprocating(self) -> float:
        """All that goes up and down, kg: the piston's mass and the share of a rigid rod there.

        >>> rod = Rod(mass=0.6, centre=0.05)
        >>> piston = Cylinder(
        ...     number=1, shaft="crank", throw=1, rod_length=0.15, reciprocating_mass=0.5, rod=rod
        ... )
        >>> round(piston.reciprocating, 9), round(piston.rotating, 9)
        (0.7, 0.4)
        """
        return self.reciprocating_mass + (self.rod.shares(self.rod_length)[1] if self.rod else 0.0)

    @property
    def rotating(self) -> float:
        """What the cylinder hangs on its pin, kg: big end and the share of a rigid rod there."""
        return self.big_end_mass + (self.rod.shares(self.rod_length)[0] if self.rod else 0.0)


class Valves(Record):
    """Opening and closing of valves or ports, degrees about dead centres; exhaust manifolds.

    Four-stroke: about the dead centre at which each of them opens or closes. Two-stroke: all four
    about bottom dead centre, the intake being the transfer or scavenge ports. A negative angle is
    on the other side of the dead centre.
    """

    intake_opens: Angle | None = Field(
        default=None,
        examples=["15 deg"],
        description="before top dead centre; in a two-stroke engine before bottom dead centre",
    )
    intake_closes: Angle | None = Field(
        default=None, examples=["50 deg"], description="after bottom dead centre"
    )
    exhaust_opens: Angle | None = Field(
        default=None, examples=["50 deg"], description="before bottom dead centre"
    )
    exhaust_closes: Angle | None = Field(
        default=None,
        examples=["15 deg"],
        description="after top dead centre; in a two-stroke engine after bottom dead centre",
    )
    manifolds: tuple[tuple[Ordinal, ...], ...] = Field(
        default=(),
        max_length=GREATEST_CYLINDERS,
        examples=[[[1, 4], [2, 3]]],
        description=(
            "the cylinders whose exhausts meet, manifold by manifold; each bank has its own "
            "if left out"
        ),
    )


def _no_switch(value: Any) -> Any:
    """A value that is not true, which Python holds equal to 1. Raises PydanticKnownError."""
    if value is True:
        raise PydanticKnownError("literal_error", {"expected": "1"})
    return value


class Identity(Record):
    """What an engine file says of the engine as a whole, in both forms."""

    format: Annotated[Literal[1], BeforeValidator(_no_switch)] = Field(
        default=1, description="version of the file format"
    )
    name: Line = Field(
        examples=["V8, cross-plane, 90 deg"], description="of the engine, on one line"
    )
    cycle: Cycle = Field(
        default="four-stroke",
        description="two-stroke: one turn of the crankshaft; four-stroke: two",
    )
    rotation: Rotation = Field(
        default="clockwise", description="of the reference crankshaft, seen from the front"
    )
    firing_order: tuple[Ordinal, ...] = Field(
        default=(),
        max_length=GREATEST_CYLINDERS,
        examples=[[1, 3, 4, 2]],
        description="combustion chambers in the order in which they fire",
    )
    firing_angles: tuple[Angle, ...] | None = Field(
        default=None,
        max_length=GREATEST_CYLINDERS,
        description="crank angle of each firing, as listed; only where the order leaves a choice",
    )
    speed: Speed | None = Field(default=None, description="the speed at which to quote forces")
    valves: Valves | None = Field(
        default=None,
        description="when valves or ports are open; typical angles stand for what is left out",
    )
    block: Block | None = Field(
        default=None, description="mass, centre of mass and moments of inertia of the whole engine"
    )
    gas: Gas | None = Field(
        default=None, description="gas in the cylinders: cycle or measured pressure, and loads"
    )
    drive: Drive | None = Field(default=None, description="flywheel, and what the engine drives")
    oil: Oil | None = Field(
        default=None, description="sizes of main bearings and crank pins, and their oil"
    )
    torsion: Torsion | None = Field(
        default=None, description="the crankshaft as it twists, and what turns with it"
    )
    mounts: Mounts = Field(default=(), description="what the block stands on")
    foundation: Foundation | None = Field(
        default=None, description="what the mounts stand on, where it gives way; rigid if left out"
    )
    source: Text = Field(default="", description="where the numbers come from")
    notes: Text = Field(default="", description="anything a reader should know")
    left_out: tuple[Line, ...] = Field(
        default=(),
        max_length=GREATEST_PARTS,
        examples=[["balance shaft"]],
        description="parts that the engine has and that this file does not describe",
    )
    provenance: dict[Line, Provenance] = Field(
        default={}, max_length=1000, description="by key path: where each value comes from"
    )
