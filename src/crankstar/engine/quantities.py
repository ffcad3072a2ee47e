"""Types of values: physical quantities with their example units, and printable text.

A `Quantity` marks a number as having a dimension. The file reader asks it which unit to expect, the
JSON Schema says it, and in an engine whose masses or sizes are not known `relative_to` tells what
the number is counted in instead.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Annotated, Any, Literal

from pydantic import AfterValidator, BeforeValidator, Field, PlainSerializer, WithJsonSchema
from pydantic_core import core_schema

from crankstar.language.faults import ValueFaultError
from crankstar.language.quoting import CONTROL, seen

GRAVITY = 9.80665
"""Standard acceleration of free fall, m/s^2."""
GREATEST_TEETH = 1000
"""Greatest numerator and denominator of a speed ratio: teeth of a gear."""
GREATEST_LENGTH = 100.0
"""Metres: greater than any part of any engine."""
GREATEST_RELATIVE = 1e6
"""Greatest bare number where lengths or masses are counted in units of themselves."""
GREATEST_RATIO = 50
"""Greatest speed ratio, up or down: many times that of any shaft in an engine."""


@dataclass(frozen=True)
class Quantity:
    """Marks a number as a physical quantity of a dimension.

    `relative_to` names the unit that replaces it where it is not known.

    What is smaller than `least` without being nought is a mistake; a place may be as near to nought
    as rounding brings it. A validation context `{"reader": f}` lets f(value, quantity) turn text
    such as "82.5 mm" into the SI number.
    """

    dimension: str
    example: str
    relative_to: frozenset[str] = frozenset()
    least: float = 0.0

    def __get_pydantic_core_schema__(self, source: Any, handler: Any) -> core_schema.CoreSchema:
        """Put the reader of the validation context, if any, before the check of the number."""

        def read(value: Any, info: core_schema.ValidationInfo) -> Any:
            reader = (info.context or {}).get("reader")
            return value if reader is None else reader(value, self)

        return core_schema.with_info_before_validator_function(read, handler(source))

    def __get_pydantic_json_schema__(self, schema: Any, handler: Any) -> dict[str, Any]:
        """In a file the quantity is text with a unit, or a bare SI number."""
        number = handler(schema)
        text = {
            "type": "string",
            "description": f"a number with a unit of {self.dimension}; a tolerance behind +-",
            "examples": [self.example],
            "x-dimension": self.dimension,
            "x-relative-to": sorted(self.relative_to),
        }
        return {"anyOf": [text, number]}


LEAST = 1e-7
"""Metres, kilograms, rad/s or relative units: smaller than any size of any engine."""
_ACROSS = frozenset({"radius"})
_ALONG = frozenset({"pitch"})
_MASS = frozenset({"mass"})
Number = Annotated[float, Field(strict=True, allow_inf_nan=False)]
ANGLE = Quantity("angle", "90 deg")
LENGTH = Quantity("length", "82.5 mm", _ACROSS)
POSITION = Quantity("length along the crankshaft", "105.5 mm", _ALONG)
SPEED = Quantity("rotational speed", "6000 rpm", least=LEAST)
FORCE = Quantity("force", "500 N", least=1e-9)
COUPLE = Quantity("couple", "120 N m", least=1e-9)
DENSITY = Quantity("density", "7.85 g/cm^3", least=1e-3)
UNBALANCE = Quantity("unbalance", "0.02 kg*m", _MASS | _ACROSS, least=1e-12)
Angle = Annotated[Number, ANGLE]
Length = Annotated[Number, LENGTH]
Size = Annotated[Number, Field(gt=0), replace(LENGTH, least=LEAST)]
Position = Annotated[Number, POSITION]
Pitch = Annotated[Number, Field(gt=0), replace(POSITION, least=LEAST)]
MASS = Quantity("mass", "650 g", _MASS, least=LEAST)
Mass = Annotated[Number, Field(ge=0), MASS]
MovingMass = Annotated[Number, Field(gt=0), MASS]
INERTIA = Quantity("moment of inertia", "0.002 kg*m^2", _MASS | _ACROSS, least=1e-12)
Inertia = Annotated[Number, Field(ge=0), INERTIA]
BodyInertia = Annotated[Number, Field(gt=0), replace(INERTIA, example="9.5 kg*m^2")]
Unbalance = Annotated[Number, Field(ge=0), UNBALANCE]
BendingStiffness = Annotated[
    Number, Field(gt=0), Quantity("bending stiffness", "400 kN*m^2", _ALONG, least=1e-6)
]
STIFFNESS = Quantity("stiffness", "200 N/mm", least=1e-3)
BearingStiffness = Annotated[
    Number, Field(gt=0), replace(STIFFNESS, example="500 kN/mm", relative_to=_ALONG)
]
Speed = Annotated[Number, Field(gt=0), SPEED]
PRESSURE = Quantity("pressure", "60 bar", least=LEAST)
Pressure = Annotated[Number, Field(gt=0), PRESSURE]
Temperature = Annotated[Number, Field(gt=0), Quantity("temperature", "350 K", least=1.0)]
TURNING_INERTIA = Quantity("moment of inertia", "0.035 kg*m^2", least=1e-12)
"""Of what twists: known in kg m^2, whatever else of an engine is not."""
TURNING_STIFFNESS = Quantity("torsional stiffness", "1.2 MN*m/rad", least=1e-6)
TURNING_DAMPING = Quantity("torsional damping", "25 N*m*s/rad", least=1e-9)
TurningInertia = Annotated[Number, Field(gt=0), TURNING_INERTIA]
TurningStiffness = Annotated[Number, Field(gt=0), TURNING_STIFFNESS]
TurningDamping = Annotated[Number, Field(ge=0), TURNING_DAMPING]
MountStiffness = Annotated[Number, Field(ge=0), STIFFNESS]
LinearDamping = Annotated[Number, Field(ge=0), Quantity("damping", "150 N*s/m", least=1e-6)]
"""Of a mount: known in N/m and N s/m."""
PointReceptance = Annotated[Number, Field(gt=0), Quantity("receptance", "0.02 um/N", least=1e-15)]
"""Of what a mount stands on: displacement of a point per force on it."""
Product = Annotated[Number, Quantity("moment of inertia", "0.4 kg*m^2", _MASS | _ACROSS)]
"""A product of inertia, of either sign."""
ShearModulus = Annotated[Number, Field(gt=0), Quantity("elastic modulus", "80 GPa", least=1e3)]
TurningMass = Annotated[Number, Field(gt=0), Quantity("mass", "0.4 kg", least=LEAST)]
Diameter = Annotated[Number, Field(gt=0), Quantity("length", "60 mm", least=LEAST)]
"""Of a shaft that twists: known in metres."""
FilmThickness = Annotated[Number, Field(gt=0), Quantity("length", "25 um", least=LEAST)]
Viscosity = Annotated[Number, Field(gt=0), Quantity("viscosity", "8 mPa*s", least=1e-6)]
POWER = Quantity("power", "12 MW", least=1e-3)
VOLUME = Quantity("volume", "1998 cm^3", least=1e-9)
ShareOfValue = Annotated[Number, Field(gt=0, le=100)]
"""A multiple of a value."""
Ordinal = Annotated[int, Field(strict=True, ge=1, le=10_000)]


def _printable(text: str) -> str:
    control = CONTROL.search(text)
    if control:
        raise ValueFaultError("text.control", character=f"U+{ord(control.group()):04X}")
    return text


def _line(text: str) -> str:
    if not text.strip():
        raise ValueFaultError("text.empty")
    if "\n" in text or "\t" in text:
        raise ValueFaultError("text.lines")
    return text


def _ratio(value: Any) -> Any:
    """A speed ratio from a whole number, a fraction as text ("-29/31") or a decimal that is one."""
    fault = ValueFaultError("ratio.none", value=seen(value))
    if isinstance(value, bool) or not isinstance(value, int | float | str | Fraction):
        raise fault
    if isinstance(value, str) and (
        len(value) > 20 or not re.fullmatch(r"\s*[-+]?\d+(\.\d+|\s*[/:]\s*\d+)?\s*", value)
    ):
        raise fault
    try:
        exact = (
            Fraction(re.sub(r"\s", "", value).replace(":", "/"))
            if isinstance(value, str)
            else Fraction(value)
        )
    except (ValueError, ZeroDivisionError, OverflowError):
        raise fault from None
    if exact == 0:
        raise ValueFaultError("ratio.zero")
    ratio = exact.limit_denominator(GREATEST_TEETH)
    if abs(ratio - exact) > Fraction(1, 10**9) or not 0 < abs(ratio.numerator) <= GREATEST_TEETH:
        raise ValueFaultError("ratio.teeth", value=seen(value), greatest=GREATEST_TEETH)
    if not Fraction(1, GREATEST_RATIO) <= abs(ratio) <= GREATEST_RATIO:
        raise ValueFaultError("ratio.range", value=seen(value), greatest=GREATEST_RATIO)
    return ratio


Text = Annotated[str, Field(max_length=10_000), AfterValidator(_printable)]
Line = Annotated[str, Field(max_length=200), AfterValidator(_printable), AfterValidator(_line)]
SpeedRatio = Annotated[
    Fraction,
    BeforeValidator(_ratio),
    PlainSerializer(str, when_used="json"),
    WithJsonSchema(
        {
            "anyOf": [
                {"type": "number"},
                {"type": "string", "pattern": r"^\s*[-+]?\d+(\.\d+|\s*[/:]\s*\d+)?\s*$"},
            ]
        }
    ),
]
Cycle = Literal["two-stroke", "four-stroke"]
Rotation = Literal["clockwise", "counter-clockwise"]
Unknown = Literal["mass", "radius", "pitch"]
Status = Literal["published", "computed", "unverified", "placeholder", "estimated"]
