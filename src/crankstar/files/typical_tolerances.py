"""Tolerances that an engine file does not give, as makers of car engines publish them.

They are limits for the weights of pistons and rods of one engine; nothing is known of other
values, which get none.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from types import MappingProxyType
from typing import Any, NamedTuple

from crankstar.engine.cylinder_parts import ENDS, RECIPROCATING
from crankstar.engine.engine import Engine
from crankstar.engine.quantities import MASS
from crankstar.engine.records import Cylinder
from crankstar.files.forms import is_explicit
from crankstar.files.mistakes import Path
from crankstar.files.tolerances import Tolerance
from crankstar.language.messages import MessageError

PISTON = (0.0025, "lada2107")
"""Of a piston, kg. Source: service manual VAZ-2107, section 3.8.7: pistons of one engine within
2.5 g either way."""
ROD = (0.0025, "fiat-elearn")
"""Of a connecting rod, kg. Source: Fiat eLearn, operation 1028H60, permitted difference in weight
between connecting rods."""
NONE: Mapping[str, Tolerance] = MappingProxyType({})
HEAVIEST = 2.0
"""Kilograms that go up and down in a cylinder: those of car engines are lighter."""


class Assumed(NamedTuple):
    """A tolerance that is assumed, and the reference of its source."""

    tolerance: Tolerance
    source: str


class TypicalError(MessageError):
    """An engine for which no such tolerances are published."""


def typical(
    tree: Mapping[str, Any], engine: Engine, given: Mapping[str, Tolerance] = NONE
) -> dict[str, Assumed]:
    """Tolerances of pistons and rods by key path; of rods at the pin, unless they are bodies.

    None of a piston or a rod of which a mass is among the tolerances that are `given`.

    Raises TypicalError where masses are not known or are not those of a car engine.

    >>> from crankstar.files.catalog import load, tree_of
    >>> own = typical(tree_of("audi-25-tfsi")[1], load("audi-25-tfsi"))
    >>> [(path, each.tolerance.bound) for path, each in own.items()]
    [('cylinder.reciprocating_mass', 0.0025), ('cylinder.rotating_mass', 0.0025)]
    """
    if "mass" in engine.relative:
        raise TypicalError(
            "{engine} has no masses, for which typical tolerances are in grams; give {key}",
            engine=engine.name,
            key="cylinder.reciprocating_mass",
        )
    heaviest = max(cylinder.reciprocating for cylinder in engine.cylinders)
    if heaviest > HEAVIEST:
        raise TypicalError(
            "{mass} kg go up and down in a cylinder of {engine}; typical tolerances are those of "
            "car engines, up to {most} kg: give its own",
            engine=engine.name,
            mass=f"{heaviest:.4g}",
            most=f"{HEAVIEST:g}",
        )
    out: dict[str, Assumed] = {}
    told = [own.keys for own in given.values()]
    for keys, value, (bound, source), others in _values(tree, engine):
        if any(own[: len(other)] == other for own in told for other in others):
            continue
        own = Tolerance(keys, value, bound, MASS)
        out[own.path] = Assumed(own, source)
    return out


def _values(
    tree: Mapping[str, Any], engine: Engine
) -> Iterator[tuple[Path, float, tuple[float, str], list[Path]]]:
    """The masses of pistons and rods, the tolerance of each, and the keys that say it as well."""
    explicit = is_explicit(tree)
    cylinders = engine.cylinders if explicit else engine.cylinders[:1]
    for index, cylinder in enumerate(cylinders):
        here: Path = ("cylinders", index) if explicit else ("cylinder",)
        parts: Path = (*here, "parts")
        piston: Path = (*here, "reciprocating_mass")
        same = [piston, *((*parts, name) for name in RECIPROCATING if name not in ENDS)]
        yield piston, cylinder.reciprocating_mass, PISTON, same
        rod: Path = (*here, "rotating_mass")
        value = _turning(engine, cylinder)
        if cylinder.rod is not None:
            rod, value = (*here, "rod", "mass"), cylinder.rod.mass
        elif explicit:  # where what hangs on a pin is said of its throw
            rod = (*here, "big_end_mass")
        yield rod, value, ROD, [rod, (*here, "rod"), *((*parts, name) for name in ENDS)]


def _turning(engine: Engine, cylinder: Cylinder) -> float:
    """The mass that a cylinder hangs on its pin, kg; an even share where the throw has the sum."""
    if cylinder.articulated is not None or cylinder.rod is not None or cylinder.big_end_mass:
        return cylinder.big_end_mass
    if cylinder.parts is not None and cylinder.parts.rotating:
        return cylinder.parts.rotating
    same = [
        each
        for each in engine.cylinders
        if (each.shaft, each.throw) == (cylinder.shaft, cylinder.throw)
        and each.articulated is None
        and each.rod is None
    ]
    return engine.throw(cylinder).rotating_mass / len(same)
