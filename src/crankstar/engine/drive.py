"""What turns with the crankshaft, and what the engine drives, as data."""

from __future__ import annotations

from itertools import pairwise
from math import fsum
from typing import Annotated, Literal

from pydantic import Field

from crankstar.engine.cylinder_parts import Record
from crankstar.engine.quantities import Angle, Inertia, Line, Number, Size

Exponent = Annotated[Number, Field(ge=-2, le=4)]
Share = Annotated[Number, Field(ge=0, le=1)]
Gearing = Literal["crankshafts", "output"]
GREATEST_LOAD = 20_000
GREATEST_CRANKSHAFTS = 16


class Drive(Record):
    """Flywheel and load, how evenly an engine runs; gears between its crankshafts.

    >>> Drive(inertia=0.25).load_exponent
    0.0
    """

    inertia: Inertia | None = Field(
        default=None,
        description=(
            "of crankshaft with its crankpins, flywheel and all that is rigidly coupled to them, "
            "about the crank axis, without pistons, rods and rotating_mass; of shafts at other "
            "speeds times their speed ratios squared; if left out, the sum of the masses of "
            "[torsion]"
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
        description="crank angles of `load_torque` over a whole cycle, ascending",
    )
    load_torque: tuple[Number, ...] = Field(
        default=(),
        max_length=GREATEST_LOAD,
        description=(
            "how the load goes over the cycle, straight between its values, in any unit: a pump, "
            "a press"
        ),
    )
    output: Line | None = Field(
        default=None,
        description="name of the crankshaft that drives the load; the first if left out",
    )
    gearing: Gearing = Field(
        default="crankshafts",
        description=(
            "how several crankshafts are geared: crankshafts, with each other, by an idler where "
            "they turn the same way; output, each with gears of the output, which is none of them"
        ),
    )
    inertia_shares: tuple[Share, ...] = Field(
        default=(),
        max_length=GREATEST_CRANKSHAFTS,
        examples=[[0.5, 0.5]],
        description=(
            "share of `inertia` that turns on each crankshaft, in their order; the rest is with "
            "the load; if left out, alike and none with the load"
        ),
    )
    pitch_radius: Size | None = Field(
        default=None,
        description=(
            "of the gear wheels on the crankshafts; half the distance of two that mesh directly "
            "if left out"
        ),
        examples=["45 mm"],
    )


def mean_share(drive: Drive, period: float) -> float:
    """The mean of the load course over the angle of a cycle, over its greatest value; 0 of none.

    The integral of its straight pieces, the last of which goes on to the first value of the next
    cycle, `period` radians after it. A share, so that the unit of the course does not matter.

    >>> mean_share(Drive(load_angle=(0.0, 1.0), load_torque=(3.0, 1.0)), 4.0)
    0.6666666666666666
    """
    peak = max(map(abs, drive.load_torque), default=0.0)
    if not peak:
        return 0.0
    angle = [*drive.load_angle, drive.load_angle[0] + period]
    load = [each / peak for each in (*drive.load_torque, drive.load_torque[0])]
    ends = zip(pairwise(angle), pairwise(load), strict=True)
    return fsum((b - a) * (first + last) / 2 for (a, b), (first, last) in ends) / period
