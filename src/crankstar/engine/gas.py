"""The gas in the cylinders as data: a cycle by few numbers or a measured trace, and loads.

Crank angles of combustion and of a trace are those of the chamber's own crank, in its direction of
rotation, from the dead centre at which the chamber fires: negative before it.
"""

from __future__ import annotations

from typing import Annotated, Any, Literal

from pydantic import BeforeValidator, Field

from crankstar.engine.cylinder_parts import Record
from crankstar.engine.quantities import Angle, Line, Number, Ordinal, Pressure, Speed, Temperature

Process = Literal["otto", "diesel", "limited-pressure", "heat-release"]
Ignition = Literal["spark", "compression"]
GREATEST_POINTS = 50
"""Operating points of one engine."""
GREATEST_TRACE = 20_000
"""Samples of a measured trace: a tenth of a degree over four turns is fewer."""
LOADS = ("imep", "bmep", "peak_pressure")
"""The keys of which one says how much work a cycle does."""


class Load(Record):
    """How much the engine does: one of three pressures, and what of the cycle goes with it."""

    speed: Speed | None = Field(
        default=None, description="of this operating point; that of the engine if left out"
    )
    imep: Pressure | None = Field(
        default=None,
        description="indicated mean effective pressure of the whole cycle, gas exchange included",
        examples=["10 bar"],
    )
    bmep: Pressure | None = Field(
        default=None,
        description="brake mean effective pressure; friction comes from `friction`",
        examples=["8.5 bar"],
    )
    peak_pressure: Pressure | None = Field(
        default=None, description="greatest pressure of the cycle", examples=["75 bar"]
    )
    intake_pressure: Pressure | None = Field(
        default=None,
        description=(
            "absolute, in the cylinder when compression begins: when the intake closes, in two "
            "strokes the later of intake and exhaust"
        ),
        examples=["0.98 bar"],
    )
    exhaust_pressure: Pressure | None = Field(
        default=None, description="absolute, in the cylinder while it is emptied"
    )
    combustion_start: Angle | None = Field(
        default=None,
        description="from the dead centre at which it fires, negative before it",
        examples=["-12 deg"],
    )
    combustion_duration: Angle | None = Field(
        default=None, description="of the whole heat release", examples=["55 deg"]
    )
    friction_pressure: Pressure | None = Field(
        default=None,
        description="friction mean effective pressure where it is known, instead of `friction`",
        examples=["1.6 bar"],
    )


class OperatingPoint(Load):
    """A named load: idle, part load, full load.

    >>> OperatingPoint(name="idle", imep=2.0e5).peak_pressure is None
    True
    """

    name: Line = Field(description="by which it is asked for", examples=["idle"])


def _in_lists(value: Any) -> Any:
    """Pressures as lists of pressures: one list, of one chamber for all, may stand alone."""
    flat = isinstance(value, list | tuple) and value
    return [value] if flat and not any(isinstance(each, list | tuple) for each in value) else value


class Trace(Record):
    """A measured pressure over one whole cycle, of one chamber for all or of each.

    >>> trace = Trace(angle=(0.0, 3.1, 6.2, 9.3), pressure=((6e6, 2e5, 1e5, 1e5),))
    >>> len(trace.pressure)
    1
    """

    angle: tuple[Angle, ...] = Field(
        max_length=GREATEST_TRACE,
        description="crank angles from the dead centre at which the chamber fires, ascending",
    )
    pressure: Annotated[tuple[tuple[Pressure, ...], ...], BeforeValidator(_in_lists)] = Field(
        max_length=256,
        description="absolute pressures, one list for all chambers or one for each of `chambers`",
    )
    chambers: tuple[Ordinal, ...] = Field(
        default=(), max_length=256, description="whose the lists are, where there are several"
    )


Exponent = Annotated[Number, Field(gt=1, le=2)]
Ratio = Annotated[Number, Field(gt=1, le=60)]


class Gas(Load):
    """What the gas in every chamber does; each value left out is assumed, and said to be.

    >>> Gas(process="otto", compression_ratio=9.0, imep=1.0e6).gamma is None
    True
    """

    process: Process | None = Field(
        default=None, description="ideal cycle, or a finite heat release; heat-release if left out"
    )
    ignition: Ignition | None = Field(
        default=None,
        description=(
            "spark or compression: what is assumed of combustion and friction; if left out, "
            "compression where the process is diesel or limited-pressure, the compression ratio "
            "is above 14 or, without one, size and speed are those of engines that do"
        ),
    )
    compression_ratio: Ratio | None = Field(
        default=None, description="greatest over least volume", examples=[10.5]
    )
    gamma: Exponent | None = Field(
        default=None, description="ratio of specific heats", examples=[1.33]
    )
    variable_gamma: bool = Field(
        default=False,
        description="whether gamma of a heat release follows the temperature of the gas",
    )
    intake_temperature: Temperature | None = Field(
        default=None, description="of the charge when compression begins", examples=["340 K"]
    )
    wall_temperature: Temperature | None = Field(
        default=None,
        description="mean of piston, head and liner; heat goes to the walls if it is given",
        examples=["430 K"],
    )
    wiebe_a: Annotated[Number, Field(gt=0, le=20)] | None = Field(
        default=None, description="a of the Wiebe function: exp(-a) is left unburnt"
    )
    wiebe_m: Annotated[Number, Field(ge=0, le=10)] | None = Field(
        default=None, description="m of the Wiebe function: the later the greater"
    )
    crankcase_pressure: Pressure | None = Field(
        default=None,
        description="absolute, behind the pistons: it changes whole orders, never half orders",
    )
    friction: Literal["spark-ignition", "diesel", "none"] | None = Field(
        default=None, description="published correlation of the friction mean effective pressure"
    )
    trace: Trace | None = Field(default=None, description="measured pressure instead of a process")
    points: tuple[OperatingPoint, ...] = Field(
        default=(),
        validation_alias="point",
        serialization_alias="point",
        max_length=GREATEST_POINTS,
        description="named loads, each with what differs in it",
    )


SPARK_RATIO = 14.0
"""Greatest compression ratio of an engine that is taken for one with spark ignition."""


def said_ignition(gas: Gas | None) -> tuple[Ignition | None, bool]:
    """How a file says that its engine ignites, and whether in words or by its compression ratio.

    >>> said_ignition(Gas(process="diesel")), said_ignition(Gas(compression_ratio=10))
    (('compression', True), ('spark', False))
    >>> said_ignition(Gas(process="otto", friction="diesel"))  # the process decides first
    ('spark', True)
    >>> said_ignition(None), said_ignition(Gas(imep=1e6))
    ((None, False), (None, False))
    """
    if gas is None:
        return None, False
    if gas.ignition is not None:
        return gas.ignition, True
    if gas.process is not None and gas.process != "heat-release":
        return ("spark" if gas.process == "otto" else "compression"), True
    if gas.friction is not None and gas.friction != "none":
        return ("compression" if gas.friction == "diesel" else "spark"), True
    if gas.compression_ratio is None:
        return None, False
    return ("compression" if gas.compression_ratio > SPARK_RATIO else "spark"), False
