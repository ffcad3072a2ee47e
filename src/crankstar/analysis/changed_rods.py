"""An engine with rods elsewhere: beside one another, on knuckle pins, of another length.

Lengths along the crankshaft are those of the engine: m, or bore pitches where it has none.
"""

from __future__ import annotations

from collections import Counter
from itertools import combinations
from math import cos

from crankstar.analysis.changed_masses import Vary, with_more_on_pins
from crankstar.engine.copies import with_values
from crankstar.engine.cylinder_parts import Articulation
from crankstar.engine.engine import Engine
from crankstar.engine.records import Cylinder
from crankstar.mechanics.central_rods import (
    FORK_AND_BLADE,
    abreast,
    central_rods,
    knuckle_angle,
    middle_rod,
)

OPPOSITE = -1 + 1e-9
"""Cosine of the angle between crankpins below which they are opposite."""


def rods_at_one_place(engine: Engine) -> list[tuple[Cylinder, Cylinder]]:
    """Pairs of cylinders whose rods, none articulated, stand on one crankpin at the same z."""
    pairs = [own for own in abreast(engine) if len(own) == FORK_AND_BLADE]
    return [(one, other) for one, other in pairs]


def with_rods_apart(factor: float) -> Vary:
    """The change that puts the first rod of each such pair in front of the second, by a distance.

    It is given in a unit of `factor` lengths along the crankshaft.
    """

    def vary(engine: Engine, apart: float) -> Engine:
        places: dict[int, float] = {}
        for one, other in rods_at_one_place(engine):
            half = apart * factor / 2
            places |= {one.number: one.z + half, other.number: other.z - half}
        cylinders = [with_values(own, z=places.get(own.number, own.z)) for own in engine.cylinders]
        return with_values(engine, cylinders=tuple(cylinders))

    return vary


def pins_at_one_place(engine: Engine) -> list[tuple[Cylinder, Cylinder]]:
    """Pairs of cylinders, each alone on its crankpin, whose pins are opposite and at the same z."""
    alone = Counter((own.shaft, own.throw) for own in engine.cylinders)
    single = [own for own in engine.cylinders if alone[own.shaft, own.throw] == 1]
    return [
        (one, other)
        for one, other in combinations(single, 2)
        if one.shaft == other.shaft
        and one.z == other.z
        and engine.throw(one).z == engine.throw(other).z
        and cos(engine.throw(one).angle - engine.throw(other).angle) < OPPOSITE
    ]


def with_pins_apart(factor: float) -> Vary:
    """The same of the first pin of each such pair, with the rod on it."""

    def vary(engine: Engine, apart: float) -> Engine:
        moved: dict[int, float] = {}
        half = apart * factor / 2
        for one, other in pins_at_one_place(engine):
            moved |= {one.number: half, other.number: -half}
        at = {(own.shaft, own.throw): moved.get(own.number, 0.0) for own in engine.cylinders}
        shafts = [
            with_values(
                shaft,
                throws=tuple(
                    with_values(throw, z=throw.z + at.get((shaft.name, number), 0.0))
                    for number, throw in enumerate(shaft.throws, 1)
                ),
            )
            for shaft in engine.shafts
        ]
        cylinders = [
            with_values(own, z=own.z + moved.get(own.number, 0.0)) for own in engine.cylinders
        ]
        return with_values(engine, cylinders=tuple(cylinders), shafts=tuple(shafts))

    return vary


def with_rods_of(engine: Engine, ratio: float) -> Engine:
    """The engine with rods of l/r = `ratio` on its throws; slave rods stay."""
    return with_values(
        engine,
        cylinders=tuple(
            cylinder
            if cylinder.articulated
            else with_values(cylinder, rod_length=ratio * engine.throw(cylinder).radius)
            for cylinder in engine.cylinders
        ),
    )


def with_knuckles(factor: float) -> Vary:
    """The change that puts rods that cannot be in one plane on knuckle pins of one of them.

    The knuckle radius is given in a unit of `factor`; slave rods are shorter by it, and what turned
    of them about the crankpin turns about their knuckle pins.
    """

    def vary(engine: Engine, radius: float) -> Engine:
        slaves: dict[int, Cylinder] = {}
        taken: dict[tuple[str, int], float] = {}
        plain = Counter((own.shaft, own.throw) for own in engine.cylinders if not own.articulated)
        for rods in central_rods(engine) if radius else ():
            master = middle_rod(rods)
            pin = master.shaft, master.throw
            end = engine.throw(master).rotating_mass / plain[pin]
            for own in rods:
                if own is master:
                    continue
                link = Articulation(
                    master=master.number, radius=radius * factor, angle=knuckle_angle(master, own)
                )
                slaves[own.number] = with_values(
                    own,
                    articulated=link,
                    rod_length=own.rod_length - radius * factor,
                    big_end_mass=own.big_end_mass + end,
                )
                taken[pin] = taken.get(pin, 0.0) + end
        shafts = [
            with_values(
                shaft,
                throws=tuple(
                    with_values(
                        throw,
                        rotating_mass=throw.rotating_mass - taken.get((shaft.name, number), 0.0),
                    )
                    for number, throw in enumerate(shaft.throws, 1)
                ),
            )
            for shaft in engine.shafts
        ]
        cylinders = [slaves.get(own.number, own) for own in engine.cylinders]
        return with_values(engine, cylinders=tuple(cylinders), shafts=tuple(shafts))

    return vary


def masters(engine: Engine) -> dict[int, list[Cylinder]]:
    """The cylinders with slave rods, by the number of that with their master rod."""
    on: dict[int, list[Cylinder]] = {}
    for own in engine.cylinders:
        if own.articulated is not None:
            on.setdefault(own.articulated.master, []).append(own)
    return on


def with_master_mass(engine: Engine, mass: float) -> Engine:
    """The engine whose master rods have this rotating mass (kg) instead of that of a slave rod.

    Counterweights stay, but those of a balance factor go along.
    """
    more: dict[tuple[str, int], float] = {}
    for own in engine.cylinders:
        slaves = masters(engine).get(own.number)
        if slaves:
            pin = own.shaft, own.throw
            more[pin] = more.get(pin, 0.0) + mass - slaves[0].rotating
    return with_more_on_pins(engine, more)


def with_slave_rods(engine: Engine, ratio: float) -> Engine:
    """The engine with slave rods of l/r = `ratio`."""
    cylinders = [
        with_values(own, rod_length=ratio * engine.throw(own).radius) if own.articulated else own
        for own in engine.cylinders
    ]
    return with_values(engine, cylinders=tuple(cylinders))
