"""What happens over a working cycle, as records: strokes, torque, exhaust.

Signals are `Re((real + i imaginary) exp(i k theta))`, as in `records`; SI units.
"""

from __future__ import annotations

from typing import Literal

from pydantic import Field

from crankstar.page.unit_records import Pair, Shown, Table

Wave = tuple[Pair, ...]


class StrokeWindow(Shown):
    """A stroke of a chamber between two crank angles (degrees; it may end in the next cycle)."""

    chamber: int
    stroke: Literal["power", "exhaust", "intake", "compression"]
    from_deg: float
    to_deg: float


class StrokeColours(Shown):
    """The colours of the strokes on the stage and in the stroke chart, `#rrggbb`."""

    intake: str
    compression: str
    power: str
    exhaust: str


class Chamber(Shown):
    """A combustion chamber: when it fires, and which of the waves of a load is its own."""

    number: int
    fires: float = Field(description="the crank angle at which it fires, radians")
    wave: int


class Load(Shown):
    """The gas torque at an operating point, N m: of each wave its amplitudes and its mean.

    The crank angle of a wave is counted from where its chamber fires.
    """

    name: str = Field(description="of the engine file; empty for the load of its table [gas]")
    assumed: bool = Field(description="whether the load is assumed: the file gives none")
    speed: float | None = Field(description="rad/s")
    burning: tuple[Wave, ...]
    burning_mean: tuple[float, ...]
    still: tuple[Wave, ...] = Field(description="the same without combustion")
    still_mean: tuple[float, ...]
    friction: float = Field(description="the torque that friction takes; 0 if not known")
    irregularity: float | None = Field(description="degree of, with every chamber burning")
    inertia: float | None = Field(description="of all that turns, kg m^2; null if not known")
    notes: tuple[str, ...] = Field(description="what is assumed, as sentences")
    doubts: tuple[str, ...] = Field(description="what is hardly so, as sentences")
    tables: tuple[Table, ...] = Field(
        description="side thrust, and gears between crankshafts, with every chamber burning"
    )


class Torque(Shown):
    """Torque on the crankshaft over a working cycle, at the orders of `orders`."""

    orders: tuple[float, ...]
    cycle: float = Field(description="length of a working cycle, radians")
    displacement: float = Field(description="of all chambers, m^3")
    chambers: tuple[Chamber, ...]
    moving: Wave | None = Field(
        description="inertia torque at 1 rad/s, it grows with the square; null without masses"
    )
    axis: Wave = Field(description="moment of the moving parts about the axis at 1 rad/s")
    loads: tuple[Load, ...]


class Pipe(Shown):
    """What shares an exhaust: its name, its chambers, and the crank angles at which they fire."""

    name: str
    chambers: tuple[int, ...]
    fires: tuple[float, ...]


class Exhaust(Shown):
    """The exhaust as a sound: equal pulses at the firings through plain pipes.

    `pulse` are the amplitudes of one pulse at the orders 1, 2, ... of a cycle, of that at order 0;
    what a pipe sends out comes back after `back` seconds, `reflected` times as large, upside down.
    """

    cycle: float = Field(description="length of a working cycle, radians")
    pulse: tuple[float, ...]
    back: float
    reflected: float
    pipes: tuple[Pipe, ...]
