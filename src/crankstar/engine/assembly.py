"""Shafts and cylinders put together, and what follows from them without any motion.

An Assembly may be impossible; an `Engine` is an Assembly that passed every check.
"""

from __future__ import annotations

from itertools import count, pairwise
from typing import Any

from pydantic import Field

from crankstar.engine.quantities import Pitch, Unknown
from crankstar.engine.records import GREATEST_CYLINDERS, Cylinder, Identity, Shaft, Throw

GREATEST_SHAFTS = 16


class Assembly(Identity):
    """Shafts with throws and weights, cylinders on them; not checked as a whole."""

    relative: tuple[Unknown, ...] = Field(
        default=(), description="what is not known, and so given as bare numbers in units of itself"
    )
    bore_pitch: Pitch | None = Field(
        default=None, description="the length a in which couples are counted when normalised"
    )
    shafts: tuple[Shaft, ...] = Field(
        validation_alias="shaft",
        serialization_alias="shaft",
        min_length=1,
        max_length=GREATEST_SHAFTS,
        description="the shafts, the reference crankshaft first",
    )
    cylinders: tuple[Cylinder, ...] = Field(
        min_length=1, max_length=GREATEST_CYLINDERS, description="pistons, rods and where they work"
    )

    @property
    def sense(self) -> int:
        """+1 if the reference crankshaft turns clockwise seen from the front, else -1."""
        return 1 if self.rotation == "clockwise" else -1

    @property
    def across(self) -> str:
        """What lengths across the crankshaft are counted in: m, or crank radii."""
        return "crank radii" if "radius" in self.relative else "m"

    @property
    def cycle_angle(self) -> float:
        """Degrees of the reference crankshaft in one working cycle: 360 or 720."""
        return 360.0 if self.cycle == "two-stroke" else 720.0

    @property
    def chambers(self) -> dict[int, tuple[Cylinder, ...]]:
        """The cylinders of each combustion chamber, by its number, in order of first mention."""
        groups: dict[int, tuple[Cylinder, ...]] = {}
        for cylinder in self.cylinders:
            number = cylinder.chamber or cylinder.number
            groups[number] = (*groups.get(number, ()), cylinder)
        return groups

    @property
    def banks(self) -> dict[str, tuple[int, ...]]:
        """The cylinder numbers of each bank; without bank names, by shaft and bearing."""
        groups: dict[Any, list[int]] = {}
        for cylinder in self.cylinders:
            key = cylinder.bank or (cylinder.shaft, round(cylinder.bearing, 9))
            groups.setdefault(key, []).append(cylinder.number)
        free = (name for name in (f"bank {place}" for place in count(1)) if name not in groups)
        names = {key: key if isinstance(key, str) else next(free) for key in groups}
        return {names[key]: tuple(numbers) for key, numbers in groups.items()}

    def shaft(self, name: str) -> Shaft:
        """The shaft of that name."""
        return next(shaft for shaft in self.shafts if shaft.name == name)

    def throw(self, cylinder: Cylinder) -> Throw:
        """The throw on which a cylinder's rod, or its master's, works."""
        return self.shaft(cylinder.shaft).throws[cylinder.throw - 1]

    @property
    def first(self) -> Cylinder:
        """The lowest-numbered cylinder: its mass, crank radius and harmonics are the units."""
        return min(self.cylinders, key=lambda cylinder: cylinder.number)

    @property
    def pitch(self) -> float:
        """The length a in which normalised couples are counted, m.

        `bore_pitch`; where none is given the closest spacing within a bank, else of any two
        cylinders, else 1 m.
        """
        if self.bore_pitch is not None:
            return self.bore_pitch
        places = {cylinder.number: cylinder.z for cylinder in self.cylinders}
        for groups in (self.banks.values(), [tuple(places)]):
            gaps = [
                gap for numbers in groups for gap in _gaps([places[number] for number in numbers])
            ]
            if gaps:
                return min(gaps)
        return 1.0


def _gaps(places: list[float]) -> list[float]:
    ordered = sorted(places)
    return [b - a for a, b in pairwise(ordered) if b - a > 1e-9]
