"""A hole that is drilled, or the slug in it, as it is asked for."""

from __future__ import annotations

from dataclasses import dataclass
from math import pi, radians
from typing import Annotated

from crankstar.analysis.reader import Reader, is_given
from crankstar.engine.quantities import DENSITY, LENGTH
from crankstar.options import readers
from crankstar.options import values as request
from crankstar.options.refusals import RequestError, refusal
from crankstar.remedy.drilling import STEEL, TIP, TUNGSTEN, Drill

LEAST_TIP = 30.0
"""Degrees."""


def _tip(text: str) -> float:
    tip = radians(request.degrees("--tip", text)[0])
    if not radians(LEAST_TIP) <= tip <= pi + 1e-9:
        raise refusal("--tip", text, "give an angle from 30 to 180 deg (flat)")
    return tip


def _slug(text: str) -> float:
    """The density of slugs; tungsten is that of its usual alloys."""
    word = text.strip().lower()
    if word and not any(letter.isdigit() for letter in word):
        if word in ("tungsten", "heavy metal", "heavy-metal", "mallory"):
            return TUNGSTEN
        raise refusal("--slug", text, 'give a density, such as "17 g/cm^3", or tungsten')
    return request.size("--slug", text, quantity=DENSITY)


@dataclass(frozen=True)
class Hole:
    """Diameter, radius at which it is drilled, depth (m), tip (rad), densities (kg/m^3)."""

    diameter: Annotated[float | None, readers.size("--diameter", LENGTH)] = None
    at_radius: Annotated[float | None, readers.size("--at-radius", LENGTH)] = None
    greatest_depth: Annotated[float | None, readers.size("--greatest-depth", LENGTH)] = None
    tip: Annotated[float | None, Reader("--tip", _tip)] = None
    density: Annotated[float | None, readers.size("--density", DENSITY)] = None
    slug: Annotated[float | None, Reader("--slug", _slug)] = None
    axial: Annotated[bool, readers.flag("--axial")] = False


def refuse_lacking(hole: Hole) -> None:
    """Refuse a hole that lacks a size. Raises RequestError."""
    needed = {"--diameter": "diameter", "--at-radius": "at_radius"}
    if hole.axial:
        needed["--greatest-depth"] = "greatest_depth"
    missing = [option for option, name in needed.items() if not is_given(hole, name)]
    if missing:
        raise RequestError(
            'give {options}, as in --diameter "12.7 mm" --at-radius "80 mm"{more}',
            options=", ".join(missing),
            more=' --greatest-depth "22 mm"' if hole.axial else "",
        )


def drill_of(hole: Hole) -> Drill:
    """The drill of a hole that lacks nothing: no deeper than half the radius unless given."""
    assert hole.diameter is not None and hole.at_radius is not None  # noqa: S101, PT018
    return Drill(
        hole.diameter,
        hole.at_radius,
        hole.at_radius / 2 if hole.greatest_depth is None else hole.greatest_depth,
        hole.tip if hole.tip is not None else TIP if hole.slug is None else pi,
        STEEL if hole.density is None else hole.density,
        hole.slug,
        hole.axial,
    )
