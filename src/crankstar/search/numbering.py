"""An engine with another firing order, or with its cylinders numbered otherwise.

A firing order says nothing without the numbering: makers count along one bank and then the other, or from side to side, from
the front or from the flywheel. 1-3-7-2-6-5-4-8 and 1-8-7-2-6-5-4-3 are one order in two numberings.
"""

from __future__ import annotations

from collections.abc import Mapping
from math import pi, radians
from typing import Any

from crankstar.engine import Engine
from crankstar.fault import EngineError, Fault
from crankstar.firing import Firing, firing, unfit
from crankstar.records import Cylinder, Provenance


def with_order(engine: Engine, fired: Firing) -> Engine:
    """The engine that fires so; with `firing_angles` where the order alone would leave a choice.

    Raises ValueError where the geometry cannot fire so.

    >>> from crankstar.catalog import load
    >>> from crankstar.search.orders import even_orders
    >>> four = load("i4")
    >>> with_order(four, even_orders(four)[0].firing).firing_order
    (1, 2, 4, 3)
    """
    changed = {**engine.provenance, "firing_order": Provenance(status="computed", source="one of the orders this crank can fire")}
    plain = _with(engine, firing_order=fired.order, firing_angles=None, provenance=changed)
    if not unfit(plain) and _alike(firing(plain).intervals_deg, fired.intervals_deg):
        return plain
    exact = _with(plain, firing_angles=tuple(radians(angle) for angle in fired.angles_deg))
    faults = unfit(exact)
    if faults:
        raise EngineError(faults)
    return exact


def _alike(ours: tuple[float, ...], theirs: tuple[float, ...]) -> bool:
    return all(abs(a - b) < 1e-3 for a, b in zip(ours, theirs, strict=True))


def _with(engine: Engine, **changes: Any) -> Engine:
    """The engine with other values, checked."""
    return Engine.model_validate({**{name: getattr(engine, name) for name in Engine.model_fields}, **changes})


def renumbered(engine: Engine, *, numbers: Mapping[int, int]) -> Engine:
    """The same engine with other numbers on its cylinders and combustion chambers: `numbers[old]` is the new one.

    Cylinders not named keep theirs. The firing order begins with the lowest number, as before with the crank at the same
    angle. Raises ValueError where two would have one number, or where there is no such cylinder.

    >>> from crankstar.catalog import load
    >>> other = renumbered(load("v8-cross-plane"), numbers={2: 8, 8: 2})
    >>> other.firing_order
    (1, 2, 4, 3, 6, 5, 7, 8)
    """
    there = {cylinder.number for cylinder in engine.cylinders}
    foreign = sorted(set(numbers) - there)
    if foreign:
        raise EngineError([Fault(("cylinders",), f"there is no cylinder {foreign[0]} to be renumbered")])
    cylinders = tuple(_renumbered(cylinder, numbers) for cylinder in engine.cylinders)
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
        groups = tuple(tuple(numbers.get(number, number) for number in group) for group in valves.manifolds)
        valves = valves.model_copy(update={"manifolds": groups})
    out = _with(engine, cylinders=cylinders, firing_order=order, firing_angles=angles, valves=valves)
    if len(out.chambers) != len(engine.chambers):
        raise EngineError([Fault(("cylinders",), "two combustion chambers would have one number; number the chambers as well")])
    return out


def _renumbered(cylinder: Cylinder, numbers: Mapping[int, int]) -> Cylinder:
    link = cylinder.articulated
    return cylinder.model_copy(
        update={
            "number": numbers.get(cylinder.number, cylinder.number),
            "chamber": None if cylinder.chamber is None else numbers.get(cylinder.chamber, cylinder.chamber),
            "articulated": link and link.model_copy(update={"master": numbers.get(link.master, link.master)}),
        }
    )
