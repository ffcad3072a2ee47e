"""What turns with the crankshaft, and what the engine drives, as data."""

from __future__ import annotations

from typing import Annotated

from pydantic import Field

from crankstar.engine.cylinder_parts import Record
from crankstar.engine.quantities import Angle, Inertia, Number

Exponent = Annotated[Number, Field(ge=-2, le=4)]
GREATEST_LOAD = 20_000


class Drive(Record):
    """Flywheel and load: how evenly an engine runs.

    >>> Drive(inertia=0.25).load_exponent
    0.0
    """

    inertia: Inertia | None = Field(
        default=None,
        description=(
            "of crankshaft, flywheel and all that is rigidly coupled to them, about the crank "
            "axis, without pistons, rods and what turns with the pins; of shafts at other speeds "
            "times their speed ratios squared"
        ),
        examples=["2 kg*m^2"],
    )
    load_exponent: Exponent = Field(
        default=0.0,
        description=(
            "k of a load torque that goes with speed^k: 0 steady, 2 propeller or fan, -1 generator "
            "at constant power"
        ),
        examples=[2],
    )
    load_angle: tuple[Angle, ...] = Field(
        default=(),
        max_length=GREATEST_LOAD,
        description="crank angles of `load_torque` over a cycle, ascending",
    )
    load_torque: tuple[Number, ...] = Field(
        default=(),
        max_length=GREATEST_LOAD,
        description="how the load goes over the cycle, in any unit: a pump, a press",
    )
