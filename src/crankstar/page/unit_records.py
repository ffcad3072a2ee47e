"""The units and printed tables of the page as records, and the base of all its records."""

from __future__ import annotations

from pydantic import BaseModel, ConfigDict, Field

Pair = tuple[float, float]


class Shown(BaseModel):
    """The base of these records: frozen, without unknown keys."""

    model_config = ConfigDict(frozen=True, extra="forbid", defer_build=True)


class Unit(Shown):
    """A unit as it is printed, and the factor to it from the number that is sent."""

    label: str
    factor: float


class Units(Shown):
    """The units of the numbers, as they are printed; numbers that are sent stay as they are.

    The factors lead from what is sent (N, N m, or m r ω²) to the unit that is printed.
    """

    chosen: str = Field(description="the choice of units, as --units names it")
    force: str
    couple: str
    roll: str
    length: str
    force_factor: float
    couple_factor: float
    roll_factor: float
    counted: tuple[str, str] = Field(description="in which force and couple are sent")
    lengths: tuple[Unit, ...] = Field(
        description="of lengths of the scene, the smallest first; each from 0.1 of it on"
    )
    mass: Unit
    inertia: Unit
    pressure: Unit = Field(description="from Pa")
    power: Unit = Field(description="from W")


class UnitsOffered(Shown):
    """A choice of units: its name, as --units takes it, and what a reader knows it by."""

    name: str
    label: str


class Table(Shown):
    """A table as it is printed: heads with units, rows, notes under it."""

    title: str
    heads: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]
    notes: tuple[str, ...] = ()
    numeric: tuple[bool, ...] = Field(
        default=(), description="which columns hold numbers, which are aligned to the right"
    )
