"""How the crankshaft twists, as records: modes, critical speeds, the forced vibration at a speed.

Signals are `Re((real + i imaginary) exp(i k theta))`, as in `records`; SI units. A turn is positive
the way the crankshaft turns.
"""

from __future__ import annotations

from pydantic import Field

from crankstar.page.cycle_records import Wave
from crankstar.page.unit_records import Shown, Table, Unit


class Piece(Shown):
    """A shaft of the crank that is seen: between two throws, or at one of its ends."""

    name: str
    modulus: float | None = Field(description="torque over shear stress, m^3; null if not known")


class ModeShown(Shown):
    """A way in which the crankshaft vibrates freely."""

    number: int
    frequency_hz: float
    shape: tuple[float, ...] = Field(description="the turn of each mass, 1 at the first")
    torque: tuple[float, ...] = Field(
        description="in each piece, N m for each radian that a mass with a shape of 1 turns; 0 "
        "where there is no piece"
    )


class CriticalShown(Shown):
    """An order that meets a mode within the range of speeds."""

    mode: int
    order: float
    speed_rpm: float
    strength: float = Field(description="by how much it counts beside others")


class Vibration(Shown):
    """The forced vibration in all orders at the speed of an operating point, or a critical one."""

    point: str = Field(description="the operating points whose gas drives; empty without a name")
    gas: bool = Field(description="whether there is gas, or the moving parts alone")
    speed_rpm: float
    critical: tuple[int, float] | None = Field(
        description="mode and order that meet there; null at the speed of an operating point"
    )
    turns: tuple[Wave, ...] = Field(
        description="of each throw, front first: how far it is ahead, radians"
    )
    torque: tuple[Wave, ...] = Field(description="in each piece, N m; empty where there is none")
    peak: tuple[float, ...] = Field(description="the greatest of it over a cycle, N m")


class Torsion(Shown):
    """The twist of the first crankshaft, front first.

    `throws` are the throws of the scene from front to rear, `masses_of_throws` their masses; none
    of several crankshafts, which are not seen to twist. `pieces` are the shafts ahead of the first
    throw, between the throws and behind the last; null where what hangs there turns with the throw.
    """

    masses: tuple[str, ...]
    throws: tuple[int, ...]
    masses_of_throws: tuple[int, ...]
    pieces: tuple[Piece | None, ...]
    estimated: bool = Field(description="whether stiffnesses are estimated from dimensions")
    modes: tuple[ModeShown, ...]
    criticals: tuple[CriticalShown, ...]
    orders: tuple[float, ...] = Field(description="of the vibrations")
    vibrations: tuple[Vibration, ...]


class TorsionNumbers(Shown):
    """The numbers of `Torsion` in the units that are shown, as the command prints them.

    The units lead from Pa and N m; `criticals` are those that count.
    """

    stress_unit: Unit
    torque_unit: Unit
    frequencies: Table
    criticals: Table
    every_critical: Table
    chain: tuple[Table, ...] = Field(description="masses, shafts and shapes")
    over_speeds: tuple[Table, ...] = Field(description="greatest vibration, barred speeds")
    vibrations: tuple[tuple[Table, ...], ...] = Field(description="of each vibration")
    notes: tuple[str, ...]
    doubts: tuple[str, ...]
