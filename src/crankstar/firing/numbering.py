"""An engine with another firing order, or with its cylinders numbered otherwise.

A firing order says nothing without the numbering: makers count along one bank and then the other,
or from side to side, from the front or from the flywheel. 1-3-7-2-6-5-4-8 and 1-8-7-2-6-5-4-3 are
one order in two numberings.
"""

from __future__ import annotations

from collections.abc import Mapping
from contextlib import suppress
from math import pi, radians

from crankstar.engine.copies import with_values
from crankstar.engine.engine import Engine
from crankstar.engine.records import Cylinder, Provenance
from crankstar.firing.intervals import Firing, firing
from crankstar.language.faults import EngineError, Fault


def with_order(engine: Engine, fired: Firing) -> Engine:
    """The engine that fires so; with `firing_angles` where the order alone would leave a choice.

    Raises ValueError where the geometry cannot fire so.

    >>> from crankstar.files.catalog import load
    >>> from crankstar.firing.orders import even_orders
    >>> four = load("i4")
    >>> with_order(four, even_orders(four)[0].firing).firing_order
    (1, 2, 4, 3)
    """
    changed = {
        **engine.provenance,
        "firing_order": Provenance(
            status="computed", source="one of the orders this crank can fire"
        ),
    }
    new = {"firing_order": fired.order, "provenance": changed}
    with suppress(EngineError):
        plain = with_values(engine, firing_angles=None, **new)
        if _alike(firing(plain).intervals_deg, fired.intervals_deg):
            return plain
    return with_values(engine, firing_angles=tuple(map(radians, fired.angles_deg)), **new)


def _alike(ours: tuple[float, ...], theirs: tuple[float, ...]) -> bool:
    return all(abs(a - b) < 1e-3 for a, b in zip(ours, theirs, strict=True))


def renumbered(engine: Engine, *, numbers: Mapping[int, int]) -> Engine:
    """The same engine with other numbers on its cylinders and combustion chambers.

    `numbers[old]` is the new one.

    Cylinders not named keep theirs. The firing order begins with the lowest number, as before with
    the crank at the same angle. Raises ValueError where two would have one number, or where there
    is no such cylinder.

    >>> from crankstar.files.catalog import load
    >>> other = renumbered(load("v8-cross-plane"), numbers={2: 8, 8: 2})
    >>> other.firing_order
    (1, 2, 4, 3, 6, 5, 7, 8)
    """
    there = {cylinder.number for cylinder in engine.cylinders}
    foreign = sorted(set(numbers) - there)
    if foreign:
        values = {"number": foreign[0], "numbers": sorted(there)}
        raise EngineError([Fault(("cylinders",), "numbering.no-such-cylinder", values)])
    cylinders = tuple(_renumbered(cylinder, numbers) for cylinder in engine.cylinders)
    if len({c.chamber or c.number for c in cylinders}) != len(engine.chambers):
        raise EngineError([Fault(("cylinders",), "numbering.chambers-collide")])
    order = tuple(numbers.get(number, number) for number in engine.firing_order)
    angles = engine.firing_angles
    if order:
        first = order.index(min(order))
        order = (*order[first:], *order[:first])
        if angles is not None:
            cycle = engine.cycle_angle / 180 * pi
            angles = (*angles[first:], *(angle + cycle for angle in angles[:first]))
            angles = tuple(angle - cycle * (angles[0] // cycle) for angle in angles)
    valves = engine.valves
    if valves is not None and valves.manifolds:
        groups = tuple(
            tuple(numbers.get(number, number) for number in group) for group in valves.manifolds
        )
        valves = with_values(valves, manifolds=groups)
    return with_values(
        engine, cylinders=cylinders, firing_order=order, firing_angles=angles, valves=valves
    )


def _renumbered(cylinder: Cylinder, numbers: Mapping[int, int]) -> Cylinder:
    def new(number: int) -> int:
        return numbers.get(number, number)

    link, chamber = cylinder.articulated, cylinder.chamber
    return with_values(
        cylinder,
        number=new(cylinder.number),
        chamber=None if chamber is None else new(chamber),
        articulated=link and with_values(link, master=new(link.master)),
    )
