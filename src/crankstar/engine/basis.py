"""What a short engine file says of the engine and its cylinders, all but the layout."""

from __future__ import annotations

from typing import Annotated

from pydantic import Field

from crankstar.engine.quantities import (
    Angle,
    Length,
    Line,
    Mass,
    Number,
    Ordinal,
    Position,
    Size,
    Unknown,
)
from crankstar.engine.records import GREATEST_CYLINDERS, Articulation, Identity, Record, Rod

ASSUMED_ROD_RATIO = 4.0
"""Rod length over crank radius where a file gives neither; the output says so."""


class Sizes(Record):
    """The sizes of a cylinder, in crank radii without a stroke, in its own mass without a mass."""

    bore: Size | None = Field(default=None, description="cylinder diameter")
    stroke: Size | None = Field(default=None, description="twice the crank radius")
    rod_length: Size | None = Field(default=None, description="connecting rod between centres")
    rod_ratio: Annotated[Number, Field(gt=1)] | None = Field(
        default=None,
        description="rod length over crank radius, l/r, instead of rod_length; 4 without either",
    )
    offset: Length = Field(
        default=0.0, description="the cylinder axis passes this far clockwise of the shaft axis"
    )
    reciprocating_mass: Mass | None = Field(
        default=None, description="piston, pin, rings, rod small end"
    )
    rotating_mass: Mass = Field(
        default=0.0,
        description=(
            "rod big end and unbalanced crank pin, at crank radius, per cylinder (at the "
            "knuckle pin of a slave rod)"
        ),
    )
    rod: Rod | None = Field(
        default=None, description="the rod as a rigid body, instead of shares in the two masses"
    )


class Override(Sizes):
    """What is different about one cylinder: anything of [cylinder], and its place."""

    number: Ordinal = Field(description="of the cylinder that differs")
    offset: Length | None = Field(default=None, description="as in [cylinder]")  # pyright: ignore[reportIncompatibleVariableOverride]
    rotating_mass: Mass | None = Field(default=None, description="as in [cylinder]")  # pyright: ignore[reportIncompatibleVariableOverride]
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
            "a counterweight opposite each pin: all of its rotating mass and this share of "
            "its reciprocating mass"
        ),
    )
