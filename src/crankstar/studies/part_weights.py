"""An engine with other weights of its pistons, pins and rods."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from crankstar.engine.copies import with_values
from crankstar.engine.cylinder_parts import RECIPROCATING
from crankstar.engine.engine import Engine
from crankstar.engine.records import Cylinder, Rod
from crankstar.spectra import Real

WEIGHED = ("piston", "pin", "small_end", "big_end")
"""The parts whose weights differ."""


def with_parts(engine: Engine, added: Mapping[str, Sequence[float] | Real]) -> Engine:
    """The engine with other masses of its parts: what is added to each cylinder's own, kg.

    Big ends side by side on a pin turn each in its own place, of articulated rods on a knuckle pin;
    they are the rod's own where it is a rigid body, whose moment of inertia stays. Counterweights
    stay.

    >>> from crankstar.files.catalog import load
    >>> four = with_parts(load("subaru-ej25"), {"piston": [0.001, 0, 0, 0]})
    >>> heavier = four.cylinders[0].reciprocating_mass - four.cylinders[1].reciprocating_mass
    >>> round(heavier, 9)
    0.001
    """
    more = {name: np.asarray(values, float) for name, values in added.items()}
    if "big_end" in more:
        engine = with_own_big_ends(engine)
    none = np.zeros(len(engine.cylinders))
    cylinders = tuple(
        _with_own(cylinder, {name: float(more.get(name, none)[index]) for name in WEIGHED})
        for index, cylinder in enumerate(engine.cylinders)
    )
    return with_values(engine, cylinders=cylinders)


def with_own_big_ends(engine: Engine) -> Engine:
    """The engine with what hangs on its pins at each rod: an even share where several have one.

    What hangs on a pin to which no plain rod belongs stays there.

    >>> from crankstar.files.catalog import load
    >>> four = with_own_big_ends(load("bmw-s65"))
    >>> {throw.rotating_mass for throw in four.shafts[0].throws}
    {0.0}
    """
    on: dict[tuple[str, int], list[int]] = {}
    for cylinder in engine.cylinders:
        if cylinder.rod is None and cylinder.articulated is None:
            on.setdefault((cylinder.shaft, cylinder.throw), []).append(cylinder.number)
    shares = {
        number: engine.shaft(seat[0]).throws[seat[1] - 1].rotating_mass / len(numbers)
        for seat, numbers in on.items()
        for number in numbers
    }
    cylinders = tuple(
        with_values(each, big_end_mass=each.big_end_mass + shares.get(each.number, 0.0))
        for each in engine.cylinders
    )
    shafts = tuple(
        with_values(
            shaft,
            throws=tuple(
                with_values(throw, rotating_mass=0.0) if (shaft.name, number) in on else throw
                for number, throw in enumerate(shaft.throws, 1)
            ),
        )
        for shaft in engine.shafts
    )
    return with_values(engine, cylinders=cylinders, shafts=shafts)


def _with_own(cylinder: Cylinder, added: Mapping[str, float]) -> Cylinder:
    """A cylinder with heavier or lighter parts."""
    values: dict[str, object] = {}
    up = sum(added[name] for name in RECIPROCATING if name in added)
    if cylinder.rod is not None:
        big, small = cylinder.rod.shares(cylinder.rod_length)
        up -= added["small_end"]
        big, small = big + added["big_end"], small + added["small_end"]
        values["rod"] = Rod(
            mass=big + small,
            centre=cylinder.rod_length * small / (big + small),
            inertia=cylinder.rod.inertia,
        )
    else:
        values["big_end_mass"] = cylinder.big_end_mass + added["big_end"]
    values["reciprocating_mass"] = cylinder.reciprocating_mass + up
    if cylinder.parts is not None:
        own = {name: getattr(cylinder.parts, name) + added[name] for name in WEIGHED}
        values["parts"] = with_values(cylinder.parts, **own)
    return with_values(cylinder, **values)
