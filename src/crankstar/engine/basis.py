"""What a short engine file says of the engine and its cylinders, all but the layout."""

from __future__ import annotations

from fractions import Fraction
from math import pi
from typing import Annotated

from pydantic import ConfigDict, Field

from crankstar.engine.cylinder_parts import required_without_parts
from crankstar.engine.quantities import (
    GREATEST_RELATIVE,
    Angle,
    Length,
    Line,
    Mass,
    Number,
    Ordinal,
    Position,
    Size,
    SpeedRatio,
    Unbalance,
    Unknown,
)
from crankstar.engine.records import (
    GREATEST_CYLINDERS,
    GREATEST_WEIGHTS,
    Articulation,
    BearingCount,
    Bearings,
    BearingSupport,
    CrankBending,
    Identity,
    Parts,
    Record,
    Rod,
    Webs,
    Weight,
)

ASSUMED_ROD_RATIO = 4.0
"""Rod length over crank radius where a file gives neither; the output says so."""
ROD_SOURCE = f"rod ratio l/r = {ASSUMED_ROD_RATIO:g} assumed"
"""The end of the source of a rod length that is assumed."""
BALANCE_FACTOR = "balance_factor"
"""The key path under which an engine remembers that its file gives counterweights by a factor."""


class Sizes(Record):
    """The sizes of a cylinder, in crank radii without a stroke, in its own mass without a mass."""

    model_config = ConfigDict(json_schema_extra=required_without_parts())

    bore: Size | None = Field(default=None, description="cylinder diameter")
    stroke: Size | None = Field(default=None, description="twice the crank radius")
    rod_length: Size | None = Field(default=None, description="connecting rod between centres")
    rod_ratio: Annotated[Number, Field(gt=1, le=GREATEST_RELATIVE)] | None = Field(
        default=None,
        description="rod length over crank radius, l/r, instead of rod_length; 4 without either",
    )
    offset: Length = Field(
        default=0.0, description="the cylinder axis passes this far clockwise of the shaft axis"
    )
    reciprocating_mass: Mass | None = Field(
        default=None, description="piston, pin, locks, rings, rod small end"
    )
    rotating_mass: Mass = Field(
        default=0.0,
        description=(
            "what hangs on the crank pin, at crank radius, per cylinder: rod big end, bearing "
            "shells, oil (at the knuckle pin of a slave rod); in the bobweight"
        ),
    )
    throw_mass: Mass = Field(
        default=0.0,
        description=(
            "the crankshaft's own unbalance, as a mass at crank radius, per cylinder: crank pin "
            "and webs without counterweights; never in the bobweight"
        ),
    )
    rod: Rod | None = Field(
        default=None, description="the rod as a rigid body, instead of shares in the two masses"
    )
    parts: Parts | None = Field(
        default=None, description="the parts as weighed, instead of the two masses"
    )


class Override(Sizes):
    """What is different about one cylinder: anything of [cylinder], and its place."""

    model_config = ConfigDict(json_schema_extra=None)  # its parts may be those of [cylinder]

    number: Ordinal = Field(description="of the cylinder that differs")
    offset: Length | None = Field(default=None, description="as in [cylinder]")  # pyright: ignore[reportIncompatibleVariableOverride]
    rotating_mass: Mass | None = Field(default=None, description="as in [cylinder]")  # pyright: ignore[reportIncompatibleVariableOverride]
    throw_mass: Mass | None = Field(default=None, description="as in [cylinder]")  # pyright: ignore[reportIncompatibleVariableOverride]
    parts: Parts | None = Field(
        default=None, description="the parts that differ; the others as in [cylinder]"
    )
    bearing: Angle | None = Field(
        default=None, description="where the cylinder points, clockwise from up"
    )
    z: Position | None = Field(
        default=None, description="middle of the cylinder, positive to the front"
    )
    bank: Line | None = Field(default=None, description="name of the bank it belongs to")
    articulated: Articulation | None = Field(
        default=None, description="the rod sits on a knuckle pin of another rod"
    )


class CrankWeight(Record):
    """A weight of a crankshaft in a short file: it is placed from the pin it turns with."""

    unbalance: Unbalance = Field(description="mass times radius of its centre")
    angle: Angle = Field(
        default=pi, description="from the pin of its throw, clockwise; opposite it if left out"
    )
    z: Position | None = Field(
        default=None,
        description="place along the shaft, positive to the front; at its throw's pin if left out",
    )
    throw: Ordinal | None = Field(
        default=None,
        description=(
            "number of the throw it turns with, from front to rear; the nearest along the shaft if "
            "left out"
        ),
    )


class Crankshaft(Record):
    """What a short file says of a crankshaft besides its throws."""

    bearings: Bearings = ()
    bearing_count: BearingCount = None
    webs: Webs = ()
    bending_stiffness: CrankBending = None
    bearing_stiffness: BearingSupport = None
    weights: tuple[CrankWeight, ...] = Field(
        default=(),
        validation_alias="weight",
        serialization_alias="weight",
        max_length=GREATEST_WEIGHTS,
        description="its counterweights, besides those of balance_factor",
    )


class BalanceShaft(Record):
    """A shaft without throws, geared to the first crankshaft."""

    name: Line = Field(default="balance shaft", description="by which results name it")
    speed_ratio: SpeedRatio = Field(
        default=Fraction(-1),
        description="turns per turn of the first crankshaft; negative turns the other way",
    )
    up: Length = Field(default=0.0, description="height of its axis over the first crankshaft")
    right: Length = Field(
        default=0.0,
        description="its axis to the right of the first crankshaft, seen from the front",
    )
    weights: tuple[Weight, ...] = Field(
        default=(),
        validation_alias="weight",
        serialization_alias="weight",
        max_length=GREATEST_WEIGHTS,
        description="its weights",
    )
    phase: Angle = Field(
        default=0.0,
        description=(
            "how far its gear or chain turns it clockwise from the angles of its weights, which "
            "all turn with it"
        ),
    )
    bearings: Bearings = ()


class Basis(Identity):
    """Everything of a short engine file but its layout."""

    cylinder: Sizes = Field(default=Sizes(), description="all cylinders alike")
    cylinders: tuple[Override, ...] = Field(
        default=(), max_length=GREATEST_CYLINDERS, description="what is different, one by one"
    )
    relative: tuple[Unknown, ...] = Field(
        default=(),
        description=(
            "what is not known, and so given as bare numbers in units of itself; added to "
            "what is left out"
        ),
    )
    balance_factor: Annotated[Number, Field(ge=0, le=2)] | None = Field(
        default=None,
        description=(
            "a counterweight opposite each pin: all of its rotating mass and throw mass, and this "
            "share of its reciprocating mass"
        ),
    )
    crankshafts: tuple[Crankshaft, ...] = Field(
        default=(),
        validation_alias="crankshaft",
        serialization_alias="crankshaft",
        max_length=16,
        description="main bearings, webs and weights of each crankshaft, the first one first",
    )
    balance_shafts: tuple[BalanceShaft, ...] = Field(
        default=(),
        validation_alias="balance_shaft",
        serialization_alias="balance_shaft",
        max_length=15,
        description="shafts with weights only, geared to the first crankshaft",
    )
