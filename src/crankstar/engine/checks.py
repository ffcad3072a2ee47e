"""What must hold of shafts and cylinders that stand still: sizes, numbers, references.

What only the moving engine shows is found by `motion` (a slave rod that cannot reach) and
`firing_angles` (a firing order that does not fit).
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence, Set
from math import lcm
from typing import Any

from crankstar.engine import gas_checks, main_bearings, mount_checks, torsion_checks, valves
from crankstar.engine.assembly import Assembly
from crankstar.engine.quantities import GREATEST_LENGTH, GREATEST_RELATIVE
from crankstar.engine.records import Cylinder, Oil, Shaft
from crankstar.language.faults import Fault
from crankstar.language.quoting import seen

MINIMUM_CLEARANCE = 1.001
"""Least rod length over (crank radius + |offset|).

Nearer to locking forces grow without limit; no real engine is there.
"""
GREATEST_CLEARANCE, GREATEST_LENGTH_RATIO = 0.01, 2.0
"""Greatest radial clearance and length of a plain bearing, in diameters."""
GREATEST_CHAIN = 8
"""Greatest number of rods in a chain; real engines have one slave rod on a master."""
GREATEST_TURNS = 2000
"""Turns of the reference shaft after which all geared shafts must be back at the start."""


def faults(engine: Assembly) -> Iterator[Fault]:
    """Everything wrong with it that shows while it stands still."""
    yield from _shaft_faults(engine)
    yield from _cylinder_faults(engine)
    yield from _chamber_faults(engine)
    yield from _firing_faults(engine)
    yield from valves.faults(engine.valves, cycle=engine.cycle, chambers=engine.chambers)
    yield from gas_checks.faults(engine.gas, cycle=engine.cycle, chambers=engine.chambers)
    yield from gas_checks.drive_faults(
        engine.drive,
        cycle=engine.cycle,
        crankshafts=[shaft.name for shaft in engine.shafts if shaft.throws],
    )
    yield from torsion_checks.faults(engine)
    yield from main_bearings.faults(engine)
    yield from _oil_faults(engine.oil)
    yield from mount_checks.faults(engine)
    if len(set(engine.relative)) != len(engine.relative):
        yield Fault(("relative",), "relative.repeated")


def _oil_faults(oil: Oil | None) -> Iterator[Fault]:
    """Bearings that no engine has: a clearance, a length out of all proportion."""
    for kind in ("main", "pin"):
        bearing = None if oil is None else getattr(oil, kind)
        if bearing is None:
            continue
        values = {"diameter": bearing.diameter * 1e3}
        if (
            bearing.clearance is not None
            and bearing.clearance > GREATEST_CLEARANCE * bearing.diameter
        ):
            more = {"value": bearing.clearance * 1e6, "usual": bearing.diameter * 500}
            yield Fault(("oil", kind, "clearance"), "oil.clearance", values | more)
        if bearing.length > GREATEST_LENGTH_RATIO * bearing.diameter:
            more = {"value": bearing.length * 1e3}
            yield Fault(("oil", kind, "length"), "oil.length", values | more)


def _shaft_faults(engine: Assembly) -> Iterator[Fault]:
    names = Counter(shaft.name for shaft in engine.shafts)
    for index, shaft in enumerate(engine.shafts):
        if names[shaft.name] > 1:
            values: dict[str, Any] = {"value": seen(shaft.name), "times": names[shaft.name]}
            yield Fault(("shaft", index, "name"), "shaft.name-repeated", values)
        yield from _weight_faults(("shaft", index), shaft)
    first = engine.shafts[0]
    if first.speed_ratio != 1:
        values = {"value": str(first.speed_ratio)}
        yield Fault(("shaft", 0, "speed_ratio"), "shaft.reference-ratio", values)
    if first.up or first.right:
        yield Fault(("shaft", 0), "shaft.reference-place")
    turns = lcm(*(shaft.speed_ratio.denominator for shaft in engine.shafts))
    if turns > GREATEST_TURNS:
        values = {"turns": turns, "greatest": GREATEST_TURNS}
        yield Fault(("shaft",), "shaft.period-too-long", values)


def _weight_faults(here: tuple[str | int, ...], shaft: Shaft) -> Iterator[Fault]:
    count = len(shaft.throws)
    for index, weight in enumerate(shaft.weights):
        if weight.throw is not None and weight.throw > count:
            code = "weight.no-such-throw" if count else "weight.no-throws"
            values = {"value": weight.throw, "count": count}
            yield Fault((*here, "weight", index, "throw"), code, values)


def _cylinder_faults(engine: Assembly) -> Iterator[Fault]:
    shafts = {shaft.name: shaft for shaft in engine.shafts}
    numbers = Counter(cylinder.number for cylinder in engine.cylinders)
    by_number = {cylinder.number: cylinder for cylinder in engine.cylinders}
    if "mass" not in engine.relative and not any(
        c.reciprocating_mass or c.rod for c in engine.cylinders
    ):
        place = ("cylinders", 0, "reciprocating_mass")
        yield Fault(place, "cylinder.no-mass", cylinder=engine.cylinders[0].number)
    for index, cylinder in enumerate(engine.cylinders):
        here = ("cylinders", index)
        if numbers[cylinder.number] > 1:
            values = {"value": cylinder.number, "times": numbers[cylinder.number]}
            yield Fault((*here, "number"), "cylinder.number-repeated", values)
        shaft = shafts.get(cylinder.shaft)
        if shaft is None:
            values = {"value": seen(cylinder.shaft), "shafts": list(shafts)}
            yield Fault((*here, "shaft"), "cylinder.no-such-shaft", values)
        elif cylinder.throw > len(shaft.throws):
            code = "cylinder.no-such-throw" if shaft.throws else "cylinder.no-throws"
            values = {
                "value": cylinder.throw,
                "shaft": seen(shaft.name),
                "count": len(shaft.throws),
            }
            yield Fault((*here, "throw"), code, values)
        elif cylinder.articulated is None:
            radius = shaft.throws[cylinder.throw - 1].radius
            yield from _reach_faults(here, cylinder, radius, engine.across)
        if cylinder.articulated is not None:
            yield from _articulation_faults(here, cylinder, by_number)


def _chamber_faults(engine: Assembly) -> Iterator[Fault]:
    ratios = {shaft.name: abs(shaft.speed_ratio) for shaft in engine.shafts}
    for number, pistons in engine.chambers.items():
        speeds = {ratios[piston.shaft] for piston in pistons if piston.shaft in ratios}
        if len(pistons) > 2:
            values = {"chamber": number, "count": len(pistons)}
            yield Fault(("cylinders",), "chamber.too-many-pistons", values)
        elif len(speeds) > 1:
            yield Fault(("cylinders",), "chamber.different-speeds", {"chamber": number})


def _reach_faults(
    here: tuple[str | int, ...], cylinder: Cylinder, radius: float, unit: str
) -> Iterator[Fault]:
    path, number = (*here, "rod_length"), cylinder.number
    least = MINIMUM_CLEARANCE * (radius + abs(cylinder.offset))
    values = {"value": cylinder.rod_length, "unit": unit}
    if cylinder.rod_length < least:
        code = "rod.too-short-with-offset" if cylinder.offset else "rod.too-short"
        values |= {"radius": radius, "offset": abs(cylinder.offset), "least": least}
        yield Fault(path, code, values, number)
    greatest = GREATEST_RELATIVE if unit != "m" else GREATEST_LENGTH
    if cylinder.rod_length > greatest:
        yield Fault(path, "rod.too-long", values | {"greatest": greatest}, number)


def _articulation_faults(
    here: tuple[str | int, ...], cylinder: Cylinder, by_number: Mapping[int, Cylinder]
) -> Iterator[Fault]:
    path, number = (*here, "articulated", "master"), cylinder.number
    passed = [number]
    link: Cylinder | None = cylinder
    while link is not None and link.articulated is not None:
        master = link.articulated.master
        if master not in by_number:
            if link is cylinder:
                values = {"value": master, "numbers": sorted(by_number)}
                yield Fault(path, "rod.no-such-master", values, number)
            return
        if master in passed:
            if master == number == min(passed):  # a loop is one fault, at its lowest number
                alone = len(passed) == 1
                code = "rod.articulated-on-itself" if alone else "rod.articulated-in-loop"
                values = {"value": link.articulated.master, "numbers": [*passed, number]}
                yield Fault(path, code, values, number)
            return
        passed.append(master)
        link = by_number[master]
    if len(passed) > GREATEST_CHAIN:
        values = {"rods": len(passed), "greatest": GREATEST_CHAIN}
        yield Fault(path, "rod.chain-too-long", values, number)
    root = by_number[passed[-1]]
    if (root.shaft, root.throw) != (cylinder.shaft, cylinder.throw):
        values = {
            "shaft": seen(cylinder.shaft),
            "throw": cylinder.throw,
            "master_shaft": seen(root.shaft),
            "master_throw": root.throw,
        }
        yield Fault(here, "rod.other-throw", values, number)


def _firing_faults(engine: Assembly) -> Iterator[Fault]:
    order, chambers = engine.firing_order, set(engine.chambers)
    angles = engine.firing_angles
    if angles is not None and len(angles) != len(order):
        values: dict[str, Any] = {"count": len(angles), "firings": len(order)}
        yield Fault(("firing_angles",), "firing_angles.count", values)
    if order:
        yield from order_faults(order, chambers)


def order_faults(order: Sequence[int], chambers: Set[int]) -> Iterator[Fault]:
    """What keeps a firing order from being one of these cylinders.

    >>> [fault.code for fault in order_faults([1, 3, 3, 5], {1, 2, 3})]
    ['firing_order.repeated', 'firing_order.no-such-cylinder', 'firing_order.incomplete']
    """
    repeated = sorted(number for number, times in Counter(order).items() if times > 1)
    foreign, missing = sorted(set(order) - chambers), sorted(chambers - set(order))
    for code, numbers in (
        ("repeated", repeated),
        ("no-such-cylinder", foreign),
        ("incomplete", missing),
    ):
        if numbers:
            values = {"numbers": numbers, "count": len(numbers), "chambers": sorted(chambers)}
            yield Fault(("firing_order",), f"firing_order.{code}", values)
