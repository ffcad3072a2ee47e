"""An engine with other masses on its pistons and crankpins, and what balances them along.

Counterweights stay as a file gives them, but those that follow from a balance factor balance what
turns at its crankpin, and a share of what reciprocates there: they go along with it.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Collection, Mapping
from math import cos, pi

from crankstar.engine.basis import BALANCE_FACTOR
from crankstar.engine.copies import with_values, wrapped
from crankstar.engine.cylinder_parts import RECIPROCATING
from crankstar.engine.engine import Engine
from crankstar.engine.records import Weight

Vary = Callable[[Engine, float], Engine]
"""From an engine and a factor or a value to the changed engine; raises EngineError."""


def by_factor(engine: Engine) -> bool:
    """Whether counterweights of the crankshafts follow from a balance factor of the file."""
    weighted = any(shaft.weights for shaft in engine.shafts if shaft.throws)
    return weighted and BALANCE_FACTOR in engine.provenance


def with_weights_along(before: Engine, after: Engine) -> Engine:
    """The engine after a change of what turns at its crankpins, balanced if by a factor.

    A `balance_factor` balances all of it: opposite each pin as much unbalance is added, or taken.
    """
    if not by_factor(before):
        return after
    shafts = [
        with_values(
            shaft,
            weights=(
                *shaft.weights,
                *(
                    Weight(
                        unbalance=abs(more) * throw.radius,
                        angle=wrapped(throw.angle + (pi if more > 0 else 0.0)),
                        z=throw.z,
                        throw=number,
                    )
                    for number, (throw, own) in enumerate(
                        zip(shaft.throws, old.throws, strict=True), 1
                    )
                    if (more := throw.turning_mass - own.turning_mass)
                ),
            ),
        )
        for old, shaft in zip(before.shafts, after.shafts, strict=True)
    ]
    return with_values(after, shafts=tuple(shafts))


def with_turning_masses(engine: Engine, ends: float | None, pins: float | None) -> Engine:
    """The engine with these masses (kg) per cylinder: big ends, and the crank's own pins.

    What is None stays. Counterweights stay, but those of a balance factor go along. The big end of
    a slave rod is on its knuckle pin.
    """
    on: dict[tuple[str, int], list[bool]] = {}
    for cylinder in engine.cylinders:
        on.setdefault((cylinder.shaft, cylinder.throw), []).append(cylinder.articulated is None)

    def changes(shaft: str, number: int) -> dict[str, float]:
        own = on.get((shaft, number), [])
        out = {} if ends is None else {"rotating_mass": ends * sum(own)}
        return out if pins is None else {**out, "throw_mass": pins * len(own)}

    if ends is not None and any(cylinder.articulated for cylinder in engine.cylinders):
        cylinders = [
            with_values(own, big_end_mass=ends) if own.articulated else own
            for own in engine.cylinders
        ]
        engine = with_values(engine, cylinders=tuple(cylinders))
    shafts = [
        with_values(
            shaft,
            throws=tuple(
                with_values(throw, **changes(shaft.name, number))
                for number, throw in enumerate(shaft.throws, 1)
            ),
        )
        if shaft.throws
        else shaft
        for shaft in engine.shafts
    ]
    return with_weights_along(engine, with_values(engine, shafts=tuple(shafts)))


def with_pistons_balanced(before: Engine, after: Engine) -> Engine:
    """The engine after a change of its reciprocating masses, balanced if by a factor.

    Of each pin what is balanced of its rods stays, and that of its pistons goes along with them.
    """
    if not by_factor(before):
        return after
    shafts = []
    for shaft in after.shafts:
        more = []
        for number, throw in enumerate(shaft.throws, 1):
            own = [weight for weight in shaft.weights if weight.throw == number]
            moved = [
                (old, new)
                for old, new in zip(before.cylinders, after.cylinders, strict=True)
                if (old.shaft, old.throw) == (shaft.name, number)
            ]
            opposite = -sum(each.unbalance * cos(each.angle - throw.angle) for each in own)
            turning = throw.turning_mass + sum(old.rotating for old, _new in moved)
            whole = sum(old.reciprocating for old, _new in moved)
            change = sum(new.reciprocating_mass - old.reciprocating_mass for old, new in moved)
            share = (opposite - turning * throw.radius) * change / whole if whole else 0.0
            angle = wrapped(throw.angle + (pi if share > 0 else 0.0))
            more += [Weight(unbalance=abs(share), angle=angle, z=throw.z, throw=number)]
        kept = [each for each in more if each.unbalance]
        shafts.append(with_values(shaft, weights=(*shaft.weights, *kept)) if kept else shaft)
    return with_values(after, shafts=tuple(shafts))


def with_part(name: str, numbers: Collection[int]) -> Vary:
    """The change of the mass (kg) of one weighed part, from none, of these cylinders.

    Counterweights stay, but those of a balance factor go along.
    """

    def vary(engine: Engine, mass: float) -> Engine:
        field = "reciprocating_mass" if name in RECIPROCATING else "big_end_mass"
        cylinders = [
            with_values(own, **{field: getattr(own, field) + mass})
            if own.number in numbers and (name in RECIPROCATING or own.articulated is not None)
            else own
            for own in engine.cylinders
        ]
        after = with_values(engine, cylinders=tuple(cylinders))
        if name in RECIPROCATING:
            return with_pistons_balanced(engine, after)
        rods = Counter(
            (own.shaft, own.throw)
            for own in engine.cylinders
            if own.number in numbers and own.articulated is None
        )
        return with_more_on_pins(after, {pin: mass * count for pin, count in rods.items()})

    return vary


def with_more_on_pins(engine: Engine, more: Mapping[tuple[str, int], float]) -> Engine:
    """The engine with more rotating mass (kg) on these throws of its shafts."""
    shafts = [
        with_values(
            shaft,
            throws=tuple(
                with_values(
                    throw, rotating_mass=throw.rotating_mass + more.get((shaft.name, number), 0.0)
                )
                for number, throw in enumerate(shaft.throws, 1)
            ),
        )
        if shaft.throws
        else shaft
        for shaft in engine.shafts
    ]
    return with_weights_along(engine, with_values(engine, shafts=tuple(shafts)))
