"""Masses and moments of inertia that hardly any engine has: slips of unit.

Each is a `Fault`, a place with a sentence, as in `doubts`, which has these too. They need neither
gas nor a speed.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import degrees, pi, radians

import numpy as np

from crankstar.engine.engine import Engine
from crankstar.engine.mount_checks import carried_mass
from crankstar.engine.proportions import STEEL, weighed_bores
from crankstar.engine.valves import timing
from crankstar.language.faults import Fault
from crankstar.language.numbers import RPM
from crankstar.mechanics.balance import default_reference

LEAST_RATIO = 2.5
"""Rod length over crank radius; less have crosshead engines alone."""
CROSSHEAD_RADIUS = 0.5
"""m: of a crank whose piston has a crosshead."""
LONGEST_FOUR, TALLEST_FOUR = 2.0, 0.8
"""Stroke over bore, and stroke (m), that four-stroke engines stay below: 1.6 and 0.64 are built."""
BOTH_OPEN = radians(120.0)
"""Through which intake and exhaust of a four-stroke engine may be open: racing engines have 115."""
LEAST_STROKE, MOST_STROKE = 0.25, 8.0
"""Over the bore: racing engines have 0.4, the longest ship's engines 5."""
LIGHTEST, HEAVIEST = 19.5e3, 250e3
"""Mass of an engine over its displacement, kg/m^3.

Aircraft engines have 20 to 30 kg per litre (a flat four of 5.9 l 117 kg), racing engines of cars 30
and more, a single of 125 cm3 with its gearbox 180, a slow stationary Diesel of one cylinder with
its flywheels 240. A motorcycle with all of its frame has 300 and more, and of old engines for pumps
some have 450: these are asked about. Our judgement, from weights that makers publish.
"""
OF_CARS = (40.0, 130.0)
"""The same of engines of cars, in kg per litre."""
OUTSIDE = 1.25
"""Factor by which a bore may lie beyond those of the engines whose parts were weighed."""
LEAST_SHARE = 0.01
"""Of a body's mass, as if at the farthest of its mounts: the frame that reaches there has more."""


def piston_doubts(engine: Engine) -> Iterator[Fault]:
    """What goes up and down heavier than a solid bar of steel as thick as the bore.

    It is as long as stroke and rod, more than a piston with its rod and crosshead.

    >>> from crankstar.files.catalog import load
    >>> heavy = load("audi-25-tfsi", changes={"cylinder.reciprocating_mass": "600 kg"})
    >>> [fault.code for fault in piston_doubts(heavy)]
    ['doubt.piston-mass']
    """
    if {"mass", "radius"} & set(engine.relative):
        return
    for index, cylinder in enumerate(engine.cylinders):
        if cylinder.bore is None:
            continue
        length = 2 * engine.throw(cylinder).radius + cylinder.rod_length
        solid = STEEL * pi / 4 * cylinder.bore**2 * length
        if cylinder.reciprocating > solid:
            values = {"value": cylinder.reciprocating, "solid": float(f"{solid:.2g}")}
            path = ("cylinders", index, "reciprocating_mass")
            yield Fault(path, "doubt.piston-mass", values, cylinder.number)
            return  # one slip for all


def scale_doubts(engine: Engine) -> Iterator[Fault]:
    """Estimated masses of an engine that is smaller or larger than any that was weighed for them.

    A mass is estimated as a share of the cube of the bore, which need not hold so far away.

    >>> from crankstar.files import engine_of
    >>> from crankstar.files.estimate import estimated
    >>> tree = {"name": "moped", "layout": {"type": "inline", "throws": [0]}}
    >>> tree["cylinder"] = {"bore": "40 mm", "stroke": "39 mm"}
    >>> [fault.code for fault in scale_doubts(engine_of(estimated(tree).tree))]
    ['doubt.estimate-scale']
    """
    if "radius" in engine.relative:
        return
    estimates = [p for p, o in engine.provenance.items() if o.status == "estimated"]
    if not any(path.endswith("mass") and path.startswith("cylinder") for path in estimates):
        return
    low, high = weighed_bores()
    for index, cylinder in enumerate(engine.cylinders):
        bore = cylinder.bore
        if bore is not None and not low / OUTSIDE <= bore <= high * OUTSIDE:
            values = {"value": _mm(bore), "low": _mm(low), "high": _mm(high)}
            alike = {each.bore for each in engine.cylinders} == {bore}
            table = ("cylinder",) if alike else ("cylinders", index)
            number = None if alike else cylinder.number
            yield Fault((*table, "bore"), "doubt.estimate-scale", values, number)
            return  # one for all


FASTEST_PISTON = 32.0
"""Mean, m/s: racing engines have up to 27."""


def size_doubts(engine: Engine) -> Iterator[Fault]:
    """A bore wider than the next cylinder of its bank is away, a stroke or speed of no engine.

    >>> from crankstar.files.catalog import load
    >>> slip = load("audi-25-tfsi", changes={"cylinder.bore": "8 m"})
    >>> [fault.code for fault in size_doubts(slip)]
    ['doubt.bore-pitch', 'doubt.stroke']
    """
    known = [(n, each) for n, each in enumerate(engine.cylinders) if each.bore is not None]
    for index, cylinder in () if {"radius", "pitch"} & {*engine.relative} else known:
        beside = [
            abs(other.z - cylinder.z)
            for _, other in known
            if (other.shaft, other.bearing, other.offset)
            == (cylinder.shaft, cylinder.bearing, cylinder.offset)
            and other.z != cylinder.z
        ]
        bore = cylinder.bore or 0.0
        if beside and bore > min(beside):
            values = {"value": _mm(bore), "pitch": _mm(min(beside))}
            yield Fault(("cylinders", index, "bore"), "doubt.bore-pitch", values, cylinder.number)
            break  # one slip for all
    for index, cylinder in () if "radius" in engine.relative else known:
        stroke, bore = 2 * engine.throw(cylinder).radius, cylinder.bore or 0.0
        if not LEAST_STROKE * bore <= stroke <= MOST_STROKE * bore:
            values = {"value": _mm(bore), "stroke": _mm(stroke)}
            yield Fault(("cylinders", index, "bore"), "doubt.stroke", values, cylinder.number)
            return
    yield from _speed_doubts(engine)


def _speed_doubts(engine: Engine) -> Iterator[Fault]:
    """A mean piston speed, the stroke times twice the turns in a second, that no engine bears."""
    if engine.speed is None or "radius" in engine.relative:
        return
    mean = max(2 * engine.throw(own).radius for own in engine.cylinders) * engine.speed / pi
    if mean > FASTEST_PISTON:
        values = {
            "rpm": float(f"{engine.speed * RPM:.6g}"),
            "value": float(f"{mean:.3g}"),
            "bound": FASTEST_PISTON,
        }
        yield Fault(("speed",), "doubt.piston-speed", values)


def _mm(length: float) -> float:
    return float(f"{length * 1e3:.4g}")


def stroke_doubts(engine: Engine) -> Iterator[Fault]:
    """A four-stroke engine as long in the stroke as two-stroke ones alone, or timed as they are.

    The cycle is four-stroke where the file gives none; the throws are made for it.

    >>> from crankstar.files.catalog import load
    >>> ship = load("man-s50mc-c", changes={"cycle": "four-stroke"})
    >>> [(fault.code, fault.values["ratio"]) for fault in stroke_doubts(ship)]
    [('doubt.cycle', 4.0)]
    """
    if engine.cycle != "four-stroke":
        return
    for cylinder in engine.cylinders:
        stroke = 2 * engine.throw(cylinder).radius
        if cylinder.bore is not None and stroke > LONGEST_FOUR * cylinder.bore:
            values = {"ratio": float(f"{stroke / cylinder.bore:.3g}"), "most": LONGEST_FOUR}
            yield Fault(("cycle",), "doubt.cycle", values)
            return
        if "radius" not in engine.relative and stroke > TALLEST_FOUR:
            values = {"stroke": _mm(stroke), "most": _mm(TALLEST_FOUR)}
            yield Fault(("cycle",), "doubt.cycle-of-stroke", values)
            return
    if engine.valves is not None:
        angles = timing(engine.valves, cycle=engine.cycle)
        both = angles.intake_opens + angles.exhaust_closes
        if both > BOTH_OPEN:
            values = {"value": float(f"{degrees(both):.4g}"), "most": degrees(BOTH_OPEN)}
            yield Fault(("valves",), "doubt.overlap", values)


def rod_doubts(engine: Engine) -> Iterator[Fault]:
    """A rod that is so short that its ratio to the stroke was taken for that to the crank radius.

    Crosshead engines have such rods, of long stroke or of a stroke of a metre; that they are no
    four-stroke engines is another doubt.

    >>> from crankstar.files.catalog import load
    >>> [fault.code for fault in rod_doubts(load("i4", changes={"cylinder.rod_ratio": 1.63}))]
    ['doubt.rod-ratio']
    """
    for index, cylinder in enumerate(engine.cylinders):
        radius = engine.throw(cylinder).radius
        ratio = cylinder.rod_length / radius
        tall = cylinder.bore is not None and radius > cylinder.bore
        long = "radius" not in engine.relative and radius > CROSSHEAD_RADIUS
        if cylinder.articulated is None and ratio < LEAST_RATIO and not (tall or long):
            values = {
                "value": float(f"{ratio:.4g}"),
                "least": LEAST_RATIO,
                "meant": float(f"{2 * ratio:.4g}"),
            }
            alike = {each.rod_length for each in engine.cylinders} == {cylinder.rod_length}
            table = ("cylinder",) if alike else ("cylinders", index)
            number = None if alike else cylinder.number
            yield Fault((*table, "rod_ratio"), "doubt.rod-ratio", values, number)
            return  # one slip for all


def body_doubts(engine: Engine) -> Iterator[Fault]:
    """A foundation lighter than what shakes it, and bodies too slender to reach their mounts.

    The moment of inertia of a body of mass m that reaches a mount at the distance h from an axis
    through its centre is m_h h^2 at least, m_h the part of its mass out there.
    """
    block, below = engine.block, engine.foundation
    if block is not None and block.mass:
        yield from _weight(engine, block.mass)
    if block is not None and block.mass and block.inertia is not None and engine.mounts:
        middle = default_reference(engine).z if block.z is None else block.z
        places = [(mount.up, mount.right, mount.z) for mount in engine.mounts]
        centre = (block.up, block.right, middle)
        yield from _slender("block", block.mass, block.inertia, centre, places)
    if below is None:
        return
    moving = carried_mass(engine)
    if "mass" not in engine.relative and below.mass < moving:
        values = {"value": below.mass, "moving": float(f"{moving:.2g}")}
        yield Fault(("foundation", "mass"), "doubt.foundation-mass", values)
    places = [(mount.up, mount.right, mount.z) for mount in (*engine.mounts, *below.mounts)]
    centre = (below.up, below.right, below.z)
    yield from _slender("foundation", below.mass, below.inertia, centre, places)


def _weight(engine: Engine, mass: float) -> Iterator[Fault]:
    """An engine that is far lighter, or heavier, for its displacement than any other."""
    if {"mass", "radius"} & {*engine.relative}:
        return
    bores = [(cylinder.bore, engine.throw(cylinder).radius) for cylinder in engine.cylinders]
    if not all(bore for bore, _radius in bores):
        return
    volume = sum(pi / 4 * (bore or 0.0) ** 2 * 2 * radius for bore, radius in bores)
    if not LIGHTEST <= mass / volume <= HEAVIEST:
        values = {
            "value": mass,
            "litres": float(f"{1e3 * volume:.3g}"),
            "share": float(f"{1e-3 * mass / volume:.3g}"),
            "low": LIGHTEST * 1e-3,
            "high": HEAVIEST * 1e-3,
            "car_low": OF_CARS[0],
            "car_high": OF_CARS[1],
        }
        yield Fault(("block", "mass"), "doubt.block-mass", values)


def _slender(
    table: str,
    mass: float,
    inertia: Sequence[float],
    centre: Sequence[float],
    places: Sequence[Sequence[float]],
) -> Iterator[Fault]:
    """The first moment of inertia that leaves too little mass at the mounts."""
    arms = np.asarray(places, float) - np.asarray(centre, float)
    for axis, name in enumerate(("up", "right", "z")):
        reach = float(np.hypot(*np.delete(arms, axis, axis=1).T).max())
        least = LEAST_SHARE * mass * reach**2
        if inertia[axis] < least:
            values = {
                "value": inertia[axis],
                "reach": float(f"{reach * 1e3:.3g}"),
                "least": float(f"{least:.2g}"),
            }
            yield Fault((table, f"inertia_{name}"), "doubt.slender", values)
            return  # one slip for all
