"""Changed copies of records: the one place where they are made, each checked again.

Weights belong to their throws and turn with them: a counterweight is cast or bolted to the webs of
a throw, so it goes where the crank pin goes. A weight says which throw is its own (`throw`); one
that does not say belongs to the throw nearest along the shaft, of two as near to the first listed.
Weights of a shaft without throws stay where they are.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from math import pi, radians
from typing import Any, TypeVar

from pydantic import BaseModel, ValidationError

from crankstar.engine.assembly import Assembly
from crankstar.engine.records import Cylinder, Shaft, Throw, Weight
from crankstar.language.faults import EngineError, Fault
from crankstar.language.quoting import seen

R = TypeVar("R", bound=BaseModel)
A = TypeVar("A", bound=Assembly)
SAME_DISTANCE = 1e-9
"""Share of the greatest distance by which two throws may differ and be equally near to a weight."""


def with_values(record: R, **values: Any) -> R:
    """The record with other values of some fields, checked as a new one is.

    What was left out stays so, since a check may ask whether a default was written. Raises
    EngineError where a value, or the engine, would be impossible.

    >>> from crankstar.engine.records import Throw
    >>> with_values(Throw(radius=0.04, angle=0.0), angle=1.0)
    Throw(angle=1.0, radius=0.04, z=0.0, rotating_mass=0.0, throw_mass=0.0)
    """
    own = {name: getattr(record, name) for name in record.model_fields_set}
    return checked(type(record), own | values)


def checked(kind: type[R], values: Mapping[str, Any]) -> R:
    """A record of these values by field. Raises EngineError where it would be impossible."""
    try:
        return kind.model_validate(dict(values), by_name=True)
    except ValidationError as error:
        raise EngineError(_faults(error)) from None


def _faults(error: ValidationError) -> list[Fault]:
    faults: list[Fault] = []
    for mistake in error.errors(include_url=False):
        cause = mistake.get("ctx", {}).get("error")
        if isinstance(cause, EngineError):
            faults += cause.faults
        else:
            faults.append(_fault(mistake))
    return faults


def _fault(mistake: Any) -> Fault:
    if mistake["type"] == "too_long":
        values = {"size": len(mistake["input"]), "bound": mistake["ctx"]["max_length"]}
        return Fault(mistake["loc"], "too-many", values)
    values = {"value": seen(mistake["input"]), "message": mistake["msg"]}
    return Fault(mistake["loc"], "invalid", values)


def throws_of_weights(shaft: Shaft) -> tuple[int | None, ...]:
    """For each weight of a shaft the number of the throw it turns with; None without throws.

    >>> throws = (Throw(radius=1, angle=0, z=1), Throw(radius=1, angle=0, z=-1))
    >>> webs = [Weight(unbalance=1, angle=0, z=z) for z in (1.4, 0.0, -0.6)]
    >>> throws_of_weights(Shaft(name="crank", throws=throws, weights=webs))
    (1, 1, 2)
    """
    return tuple(weight.throw or _nearest(weight, shaft.throws) for weight in shaft.weights)


def _nearest(weight: Weight, throws: tuple[Throw, ...]) -> int | None:
    if not throws:
        return None
    distances = [abs(throw.z - weight.z) for throw in throws]
    reach = min(distances) + SAME_DISTANCE * max(distances)
    return next(number for number, distance in enumerate(distances, 1) if distance <= reach)


def with_throws_turned(engine: A, turns: Mapping[tuple[str, int], float], **values: Any) -> A:
    """The engine with some throws turned clockwise, their weights with them.

    `turns`: radians by name of the shaft and number of the throw; `values`: other fields of the
    engine that change with the throws, such as its firing order.

    >>> from crankstar.engine.basis import Basis
    >>> from crankstar.engine.layouts import inline
    >>> twin = inline(Basis(name="twin", balance_factor=1), throws=(0.0, pi))
    >>> turned = with_throws_turned(twin, {("crank", 2): pi}).shafts[0]
    >>> [round(part.angle, 6) + 0.0 for part in (*turned.throws, *turned.weights)]
    [0.0, 0.0, 3.141593, 3.141593]
    """

    def turned(shaft: Shaft) -> Shaft:
        by = {number: turn for (name, number), turn in turns.items() if name == shaft.name}
        if not by:
            return shaft
        homes = throws_of_weights(shaft)
        throws = tuple(
            _at(throw, throw.angle + by[number]) if number in by else throw
            for number, throw in enumerate(shaft.throws, 1)
        )
        weights = tuple(
            _at(weight, weight.angle + by[home]) if home in by else weight
            for weight, home in zip(shaft.weights, homes, strict=True)
        )
        return with_values(shaft, throws=throws, weights=weights)

    return with_values(engine, shafts=tuple(map(turned, engine.shafts)), **values)


P = TypeVar("P", Throw, Weight)


def _at(part: P, angle: float) -> P:
    return with_values(part, angle=wrapped(angle))


def wrapped(angle: float) -> float:
    """The same bearing in (-pi, pi]."""
    return pi - (pi - angle) % (2 * pi)


def turned_on(engine: A, angle: float, **values: Any) -> A:
    """The engine as it stands when the reference crankshaft has turned clockwise by `angle`.

    All throws and weights of every shaft turn, each by its speed ratio; its firings come earlier by
    as much. `values`: other fields.
    """
    if engine.firing_angles is not None:
        earlier = tuple(fired - engine.sense * angle for fired in engine.firing_angles)
        values = {"firing_angles": earlier, **values}

    def turned(shaft: Shaft) -> Shaft:
        by = angle * float(shaft.speed_ratio)
        throws = tuple(_at(throw, throw.angle + by) for throw in shaft.throws)
        weights = tuple(_at(weight, weight.angle + by) for weight in shaft.weights)
        return with_values(shaft, throws=throws, weights=weights)

    return with_values(engine, shafts=tuple(map(turned, engine.shafts)), **values)


def with_banks_mirrored(engine: A, **values: Any) -> A:
    """The engine with every bank on the other side, the first cylinder at the same dead centre.

    The crankshafts keep their throws and weights relative to each other; `values`: other fields.
    """
    cylinders = tuple(_mirrored(cylinder) for cylinder in engine.cylinders)
    return turned_on(engine, -2 * engine.first.bearing, cylinders=cylinders, **values)


def _mirrored(cylinder: Cylinder) -> Cylinder:
    """A cylinder on the other side, its offset and its knuckle pin with it."""
    link = cylinder.articulated
    knuckle = None if link is None else with_values(link, angle=-link.angle)
    return with_values(
        cylinder, bearing=-cylinder.bearing, offset=-cylinder.offset, articulated=knuckle
    )


def with_rotation_reversed(engine: A, **values: Any) -> A:
    """The same engine turning the other way, and so firing backwards; `values`: other fields.

    >>> from crankstar.files.catalog import load
    >>> with_rotation_reversed(load("i4")).firing_order
    (1, 2, 4, 3)
    """
    other = "counter-clockwise" if engine.rotation == "clockwise" else "clockwise"
    order, angles = engine.firing_order, engine.firing_angles
    if angles:
        cycle = radians(engine.cycle_angle)
        angles = tuple((angles[0] - angle) % cycle - angles[0] for angle in _backwards(angles))
    backwards = {"rotation": other, "firing_order": _backwards(order), "firing_angles": angles}
    return with_values(engine, **(backwards | values))


def _backwards(listed: tuple[Any, ...]) -> tuple[Any, ...]:
    return (*listed[:1], *reversed(listed[1:]))


def with_weights(engine: A, weights: Mapping[str, Sequence[Weight]]) -> A:
    """The engine with these weights on the shafts of these names, instead of those they had."""
    shafts = tuple(
        with_values(shaft, weights=tuple(weights[shaft.name])) if shaft.name in weights else shaft
        for shaft in engine.shafts
    )
    return with_values(engine, shafts=shafts)


def with_shaft(engine: A, shaft: Shaft) -> A:
    """The engine with one more shaft, the last."""
    return with_values(engine, shafts=(*engine.shafts, shaft))
