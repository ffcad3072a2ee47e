"""One moving part: the rows of a Balance it accounts for, and its push as signals."""

from __future__ import annotations

from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Literal

from crankstar.derive.algebra.wave import Form, Wave, scaled
from crankstar.engine.engine import Engine
from crankstar.engine.records import Cylinder


@dataclass(frozen=True)
class Body:
    """One moving part, with its push on the block upwards and to the right.

    `along` is the push of a piston along its cylinder; None for what turns. `lag` is delta in
    turns, None where it is not a rational part of one; `dead_centre` is where the piston is
    farthest out, in turns of the reference crankshaft. `cylinder` is None for throws and weights;
    `place` counts the throws, or the weights, of a shaft. `sharing` is how many bodies the rows
    stand for together: a rod's crank end, the big end, is a body of its own.
    """

    kind: Literal["piston", "throw", "weight", "big end"]
    shaft: str
    place: int
    up: Wave
    right: Wave
    rows: tuple[int, ...] = ()
    cylinder: int | None = None
    bank: str = ""
    along: Wave | None = None
    bearing: Fraction | None = None
    bearing_deg: float = 0.0
    lag: Fraction | None = None
    dead_centre: Fraction | None = None
    sharing: int = 1

    @property
    def turning(self) -> bool:
        """Whether the part turns with its shaft."""
        return self.kind != "piston"


def armed(body: Body, arm: Form) -> Body:
    """What a part does to the couple: its push times its arm."""
    along = None if body.along is None else scaled(body.along, arm)
    return replace(body, up=scaled(body.up, arm), right=scaled(body.right, arm), along=along)


def speed_ratio(engine: Engine, shaft: str) -> Fraction:
    """The signed speed of a shaft over that of the reference crankshaft."""
    return Fraction(engine.shaft(shaft).speed_ratio)


def on_pin(engine: Engine, cylinder: Cylinder) -> float:
    """The mass moment of a plain rod's crank end, given apart from the throw."""
    mass = cylinder.big_end_mass
    if cylinder.rod is not None:
        mass += cylinder.rod.mass * (1 - cylinder.rod.centre / cylinder.rod_length)
    return mass * engine.throw(cylinder).radius


def base_angle(engine: Engine) -> float:
    """The angle of the first cylinder's throw.

    Others are often rational parts of a turn from it even where it is not one itself.
    """
    return engine.throw(engine.first).angle
