"""Values that are out of all proportion to the engine they are of: slips of unit or of a digit.

Each is a `Fault`, a place with a sentence, as in `doubts`, which has these too. The measure is the
engine itself: a solid bar of steel as thick as a bore and as long as stroke and rod, a length that
the whole reaches. Engines that count in units of their own are not measured.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import count
from math import hypot, pi

from crankstar.engine.engine import Engine
from crankstar.engine.proportions import STEEL
from crankstar.engine.records import Cylinder, Shaft
from crankstar.language.faults import Fault

LIGHTEST_PISTON = 50.0
"""Reciprocating mass over the cube of the bore, kg/m^3; racing engines have 300 and more."""
LONGEST_ROD = 20.0
"""Rod length over crank radius: the longest that are built have 7 or so."""
FAR = 30.0
"""Distance over the size of the engine, beyond which no place of it is."""

Path = tuple[str | int, ...]


def magnitude_doubts(engine: Engine) -> Iterator[Fault]:
    """All of them; of a kind only the first, as one slip often is for all.

    >>> from crankstar.files.catalog import load
    >>> odd = {"cylinder.reciprocating_mass": "0.65 g", "cylinder.rotating_mass": "600 kg"}
    >>> [fault.code for fault in magnitude_doubts(load("audi-25-tfsi", changes=odd))]
    ['doubt.piston-light', 'doubt.turning-mass']
    """
    if {"mass", "radius"} & set(engine.relative):
        return
    for kind in (_pistons, _turning, _rods, _together, _unbalances, _far):
        yield from _first(kind(engine))


def _first(found: Iterator[Fault]) -> Iterator[Fault]:
    for fault in found:
        yield fault
        return


def _solid(engine: Engine, cylinder: Cylinder) -> float:
    """The mass (kg) of a bar of steel as thick as the bore, as long as stroke and rod."""
    stroke = 2 * engine.throw(cylinder).radius
    return STEEL * pi / 4 * (cylinder.bore or stroke) ** 2 * (stroke + cylinder.rod_length)


def _pistons(engine: Engine) -> Iterator[Fault]:
    for index, cylinder in enumerate(engine.cylinders):
        mass, bore = cylinder.reciprocating_mass, cylinder.bore
        if bore is not None and 0 < mass < LIGHTEST_PISTON * bore**3:
            values = {"value": float(f"{mass * 1e3:.3g}"), "bore": float(f"{bore * 1e3:.4g}")}
            path = ("cylinders", index, "reciprocating_mass")
            yield Fault(path, "doubt.piston-light", values, cylinder.number)


def _turning(engine: Engine) -> Iterator[Fault]:
    for index, cylinder in enumerate(engine.cylinders):
        throw, solid = engine.throw(cylinder), _solid(engine, cylinder)
        given = {"rotating_mass": throw.rotating_mass, "throw_mass": throw.throw_mass}
        for key, mass in given.items():
            if mass > solid:
                values = {"value": float(f"{mass:.4g}"), "solid": float(f"{solid:.2g}")}
                path = ("cylinders", index, key)
                yield Fault(path, "doubt.turning-mass", values, cylinder.number)


def _rods(engine: Engine) -> Iterator[Fault]:
    for index, cylinder in enumerate(engine.cylinders):
        ratio, rod = cylinder.rod_length / engine.throw(cylinder).radius, cylinder.rod
        if ratio > LONGEST_ROD:
            values = {"value": float(f"{ratio:.3g}"), "most": LONGEST_ROD}
            yield Fault(
                ("cylinders", index, "rod_length"), "doubt.rod-long", values, cylinder.number
            )
        elif rod is not None and not 0 <= rod.centre <= cylinder.rod_length:
            values = {
                "value": float(f"{rod.centre * 1e3:.4g}"),
                "length": float(f"{cylinder.rod_length * 1e3:.4g}"),
            }
            path = ("cylinders", index, "rod", "centre")
            yield Fault(path, "doubt.rod-centre", values, cylinder.number)


def _together(engine: Engine) -> Iterator[Fault]:
    """Cylinders of a bank in one place; not those of one chamber."""
    known: dict[tuple[object, ...], Cylinder] = {}
    for index, cylinder in enumerate(engine.cylinders):
        shaft = engine.shaft(cylinder.shaft)
        place = (shaft.up, shaft.right, cylinder.bearing, cylinder.offset, cylinder.z)
        other = known.setdefault(place, cylinder)
        if other is not cylinder and cylinder.chamber is None and other.throw != cylinder.throw:
            values = {"first": other.number, "second": cylinder.number}
            yield Fault(("cylinders", index, "z"), "doubt.same-place", values)


def _unbalances(engine: Engine) -> Iterator[Fault]:
    most = sum(_solid(engine, each) * engine.throw(each).radius for each in engine.cylinders)
    for path, own in _shafts(engine):
        for index, weight in enumerate(own.weights):
            if weight.unbalance > most:
                values = {"value": float(f"{weight.unbalance:.4g}"), "solid": float(f"{most:.2g}")}
                yield Fault((*path, "weight", index, "unbalance"), "doubt.unbalance", values)


def _shafts(engine: Engine) -> Iterator[tuple[Path, Shaft]]:
    """Crankshafts and balance shafts, each with its key path."""
    numbers = {True: count(), False: count()}
    for each in engine.shafts:
        turns = bool(each.throws)
        yield ("crankshaft" if turns else "balance_shaft", next(numbers[turns])), each


def _far(engine: Engine) -> Iterator[Fault]:
    """Places of which one cannot be on this engine."""
    along = [each.z for each in engine.cylinders]
    middle = (max(along) + min(along)) / 2
    across = max(2 * engine.throw(own).radius + own.rod_length for own in engine.cylinders)
    across += max(
        hypot(engine.shaft(own.shaft).up, engine.shaft(own.shaft).right) for own in engine.cylinders
    )
    size = max(max(along) - min(along), across)
    for path, key, distance in _distances(engine, middle):
        if abs(distance) > FAR * size:
            values = {"value": float(f"{distance:.4g}"), "size": float(f"{size:.2g}")}
            yield Fault((*path, key), "doubt.far", values)


def _distances(engine: Engine, middle: float) -> Iterator[tuple[Path, str, float]]:
    """Key paths of places, and how far each is from the middle of the cylinders, m."""
    block, below = engine.block, engine.foundation
    moving: list[tuple[Path, object]] = []
    if block is not None:
        moving += [(("block",), block)]
        moving += [(("block", "points", n), each) for n, each in enumerate(block.points)]
    if below is not None:
        moving += [(("foundation",), below)]
        moving += [(("foundation", "points", n), each) for n, each in enumerate(below.points)]
    moving += [(("mounts", n), each) for n, each in enumerate(engine.mounts)]
    for path, own in _shafts(engine):
        if not own.throws:
            moving += [(path, own)]
            moving += [((*path, "weight", n), each) for n, each in enumerate(own.weights)]
    for path, each in moving:
        for key, start in (("up", 0.0), ("right", 0.0), ("z", middle)):
            value = getattr(each, key, None)
            if value is not None:
                yield path, key, value - start
