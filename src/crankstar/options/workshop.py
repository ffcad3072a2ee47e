"""The options of `crankstar drill` and `crankstar grade` as they are typed, read as values."""

from __future__ import annotations

import re
from dataclasses import replace
from math import pi, radians
from typing import NamedTuple

from pydantic import BaseModel, ConfigDict, Field

from crankstar.engine.quantities import ANGLE, DENSITY, LEAST, LENGTH, MASS, UNBALANCE, Quantity
from crankstar.files import units
from crankstar.language.faults import ValueFaultError
from crankstar.language.messages import _
from crankstar.options import values as request
from crankstar.options.refusals import RequestError, refusal
from crankstar.options.vocabulary import meaning
from crankstar.remedy.drilling import STEEL, TIP, TUNGSTEN, Drill


class DrillOptions(BaseModel):
    """The hole, or the slug in it, as it is typed."""

    model_config = ConfigDict(extra="forbid", frozen=True)

    diameter: str | None = Field(default=None, description=meaning("--diameter"))
    at_radius: str | None = Field(default=None, description=meaning("--at-radius"))
    greatest_depth: str | None = Field(default=None, description=meaning("--greatest-depth"))
    tip: str | None = Field(default=None, description=meaning("--tip"))
    density: str | None = Field(default=None, description=meaning("--density"))
    slug: str | None = Field(default=None, description=meaning("--slug"))
    axial: bool = Field(default=False, description=meaning("--axial"))


class Measured(NamedTuple):
    """What a balancing machine shows in a plane: unbalance [kg m], its direction [rad] if given."""

    unbalance: float
    angle: float | None
    at_usual_radius: bool = False


def size(option: str, text: str, quantity: Quantity) -> float:
    """A value above 0 with its unit. Raises RequestError."""
    if units.is_bare(text):
        raise refusal(
            option, text, 'write it with a unit, such as "{example}"', example=quantity.example
        )
    with request.reading(option):
        value = units.si(text, replace(quantity, least=max(quantity.least, LEAST)))
    if not value > 0:
        raise request.not_positive(option, text, quantity)
    return value


def drill_of(options: DrillOptions) -> Drill:
    """The drill that the options describe. Raises RequestError with every mistake."""
    needed = {"--diameter": options.diameter, "--at-radius": options.at_radius}
    if options.axial:
        needed["--greatest-depth"] = options.greatest_depth
    missing = [name for name, text in needed.items() if text is None]
    if missing:
        raise RequestError(
            'give {options}, as in --diameter "12.7 mm" --at-radius "80 mm"{more}',
            options=", ".join(missing),
            more=' --greatest-depth "22 mm"' if options.axial else "",
        )
    diameter = size("--diameter", options.diameter or "", LENGTH)
    radius = size("--at-radius", options.at_radius or "", LENGTH)
    deepest = radius / 2
    if options.greatest_depth is not None:
        deepest = size("--greatest-depth", options.greatest_depth, LENGTH)
    slug = None if options.slug is None else _slug(options.slug)
    tip = TIP if slug is None else pi
    if options.tip is not None:
        tip = radians(request.degrees("--tip", options.tip)[0])
        if not radians(30) <= tip <= pi + 1e-9:
            raise refusal("--tip", options.tip, "give an angle from 30 to 180 deg (flat)")
    density = STEEL if options.density is None else size("--density", options.density, DENSITY)
    return Drill(diameter, radius, deepest, tip, density, slug, options.axial)


def _slug(text: str) -> float:
    """The density of slugs; tungsten is that of its usual alloys."""
    word = text.strip().lower()
    if word and not any(letter.isdigit() for letter in word):
        if word in ("tungsten", "heavy metal", "heavy-metal", "mallory"):
            return TUNGSTEN
        raise refusal("--slug", text, 'give a density, such as "17 g/cm^3", or tungsten')
    return size("--slug", text, DENSITY)


def measured(text: str, *, radius: float | None = None, most: int = 24) -> list[Measured]:
    """Unbalances plane by plane, each with the direction of the heavy spot where it is given.

    A mass without a radius is one at `radius`, unless another has a radius of its own. Raises
    RequestError.

    >>> first, second = measured("850 g*mm at 20 deg, 10 g at 200 deg", radius=0.08)
    >>> round(first.unbalance * 1e6), round(second.unbalance * 1e6), round(second.angle, 4)
    (850, 800, 3.4907)
    >>> round(measured("38 g at 4 in at 20 deg")[0].unbalance * 1e6, 1)
    3860.8
    """
    parts = request.listed(text)
    if not 1 <= len(parts) <= most:
        raise refusal(
            "--unbalance",
            text,
            "give from 1 to {most} unbalances with commas, {example}",
            most=most,
            example=_('as in "850 g*mm at 20 deg, 38 g at 4 in at 200 deg"'),
        )
    parted = [_parted(part) for part in parts]
    bare = [radius is not None and _reads(amount, MASS) for amount, _direction in parted]
    if any(bare) and any(_has_radius(amount) for amount, _direction in parted):
        raise refusal(
            "--unbalance",
            parts[bare.index(True)],
            "another reading has its radius and this one has none; give each its radius, {example}",
            example=_('as in "38 g at 4 in at 200 deg"'),
        )
    out: list[Measured] = []
    for (amount, direction), usual in zip(parted, bare, strict=True):
        where = radians(request.degrees("--unbalance", direction)[0]) if direction else None
        out.append(Measured(_amount(amount, radius), where, usual))
    return out


def _has_radius(text: str) -> bool:
    """Whether an amount is a mass at a radius of its own."""
    mass, *radius = re.split(r"\s+at\s+|\s*@\s*", text)
    return bool(radius) and _reads(mass, MASS)


def _parted(text: str) -> tuple[str, str]:
    """An unbalance and its direction, which is empty where none is given."""
    *before, last = re.split(r"\s+at\s+|\s*@\s*", text)
    at_radius = len(before) == 1 and _reads(before[0], MASS) and not _is_direction(last)
    return (text, "") if at_radius or not before else (" at ".join(before), last)


def _is_direction(text: str) -> bool:
    return units.is_bare(text) or _reads(text, ANGLE)


def _reads(text: str, quantity: Quantity) -> bool:
    try:
        units.si(text, quantity)
    except ValueFaultError:
        return False
    return True


def _amount(text: str, radius: float | None) -> float:
    """An unbalance, or a mass times the radius."""
    if units.is_bare(text):
        example = "850 g*mm"
        raise refusal(
            "--unbalance", text, 'write it with a unit, such as "{example}"', example=example
        )
    with request.reading("--unbalance"):
        if radius is not None and units.is_of(text, MASS):
            return _not_negative(text, units.si(text, MASS) * radius)
        return _not_negative(text, units.si(text, UNBALANCE))


def _not_negative(text: str, value: float) -> float:
    if value < 0:
        raise refusal(
            "--unbalance", text, "give it without a sign; its direction says where it is heavy"
        )
    return value


def grade(text: str) -> float:
    """A balance quality grade in mm/s: 6.3, G6.3 or G 6.3. Raises RequestError."""
    number = text.strip().lower().removeprefix("g").strip().removesuffix("mm/s").strip()
    try:
        value = float(number)
    except ValueError:
        value = -1.0
    if not 0.01 <= value <= 10_000:
        raise refusal("--grade", text, "give a balance quality grade in mm/s, such as 6.3 or G6.3")
    return value


def distances(text: str | None) -> tuple[float, float]:
    """Distances of the two bearings from the centre of mass, equal if not given."""
    if text is None:
        return 1.0, 1.0
    parts = request.listed(text)
    example = "210 mm, 260 mm"
    if len(parts) != 2:
        raise refusal(
            "--bearing-distances",
            text,
            'give two, front and rear, as in "{example}"',
            example=example,
        )
    front, rear = (size("--bearing-distances", part, LENGTH) for part in parts)
    return front, rear
