"""Unbalances as a balancing machine shows them, read from text."""

from __future__ import annotations

import re
from math import radians
from typing import NamedTuple

from crankstar.engine.quantities import ANGLE, MASS, UNBALANCE, Quantity
from crankstar.files import units
from crankstar.language.faults import ValueFaultError
from crankstar.language.messages import _
from crankstar.options import values as request
from crankstar.options.refusals import refusal


class Measured(NamedTuple):
    """What a balancing machine shows in a plane: unbalance [kg m], its direction [rad] if given."""

    unbalance: float
    angle: float | None
    at_usual_radius: bool = False


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
