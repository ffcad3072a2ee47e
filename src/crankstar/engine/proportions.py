"""Masses and lengths that an engine of a type usually has, with their range, from its bore.

Parts of engines of one type are alike, so that a mass is a coefficient times the cube of the bore
and a length a coefficient times the bore or the crank radius:

    piston group  m_p = k D^3      rod  m_r = k D^3      crank pin  m_c = rho pi d^2 l / 4 = k D^3
    rod length  l = k r            bore pitch  a = k D   stroke  S = k D

The coefficient k of a part is the geometric mean over the engines of `weighed` that give the part,
its range reaches from the least of them to the greatest, and at least by the factor SPREAD up and
down from the mean. Where fewer than FEW engines of the type give it, the factor is the greater
LONE, and engines with spark ignition stand for one another, and for a type of which there is none.

A bare piston counts as DRESSED times itself, with pin, rings and locks. The centre of mass of a rod
of length l lies (small end / rod) l from the big end; its moment of inertia is that of two masses
at its ends divided by TWO_MASSES, whose mean and range over 19 rods are published (`mass2002`).
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from itertools import pairwise
from math import exp, log, pi
from typing import NamedTuple

from crankstar.engine.assembly import Assembly
from crankstar.engine.gas import Gas, Ignition, said_ignition
from crankstar.engine.weighed import ENGINES, EngineType, Weighed

STEEL = 7850.0
"""Density of a crank pin, kg/m^3."""
SPREAD = {"mass": 1.25, "length": 1.1}
"""Least factor of a range up and down, of masses and of lengths."""
LONE = {"mass": 1.5, "length": 1.2}
"""The same where fewer than three engines of the type give the part."""
TWO_MASSES = (0.9735, 1.0965, 1.22)
"""Inertia of two masses at the ends of a rod over its own: least, mean, greatest of 19 rods."""
PISTON_SPEEDS: dict[EngineType, float] = {
    "petrol": 16.0,
    "diesel-car": 14.0,
    "diesel": 11.0,
    "motorcycle": 22.0,
    "aero": 14.3,
    "crosshead": 8.5,
}
"""Mean piston speed at rated speed, m/s (`piston-speeds`; aero: Jumo 211 at 2600 rpm)."""
SPARK = ("petrol", "motorcycle", "aero")
"""Types with spark ignition and light-alloy pistons."""
PITCH_OVER_BORE = (1.05, 1.35)
"""Distance of neighbouring cylinders of a row over their bore: the walls need the first."""
FEW = 3
SPEED_SPREAD = 1.2
"""Factor of the range of the piston speed up and down: the source says "about"."""


class Proportion(NamedTuple):
    """A coefficient: typical, lowest, highest; the engines it comes from; whether they are few."""

    typical: float
    low: float
    high: float
    engines: tuple[str, ...]
    scarce: bool = False
    """Whether fewer than FEW engines of the type give the part."""

    @property
    def sizes(self) -> tuple[float, float, float]:
        """Lowest, typical, highest."""
        return self.low, self.typical, self.high


def _mean(values: list[float]) -> float:
    return exp(sum(map(log, values)) / len(values))


@cache
def dressed() -> float:
    """Mass of a piston with pin, rings and locks over that of the bare piston.

    >>> round(dressed(), 2)
    1.42
    """
    return _mean([e.piston_group / e.piston for e in ENGINES if e.piston and e.piston_group])


def _piston_group(e: Weighed) -> float | None:
    mass = e.piston_group or (e.piston and e.piston * dressed())
    return mass / e.bore**3 if mass and e.bore else None


def _crank_pin(e: Weighed) -> float | None:
    if e.crank_pin is None or not e.bore:
        return None
    diameter, length = e.crank_pin
    return STEEL * pi / 4 * diameter**2 * length / e.bore**3


PARTS: dict[str, tuple[str, Callable[[Weighed], float | None]]] = {
    "piston group": ("mass", _piston_group),
    "rod": ("mass", lambda e: e.rod / e.bore**3 if e.rod and e.bore else None),
    "reciprocating": (
        "mass",
        lambda e: e.reciprocating / e.bore**3 if e.reciprocating and e.bore else None,
    ),
    "crank pin": ("mass", _crank_pin),
    "small end": ("length", lambda e: e.small_end / e.rod if e.small_end and e.rod else None),
    "rod over piston group": (
        "mass",
        lambda e: (
            e.rod / (_piston_group(e) or 1) / e.bore**3
            if e.rod and e.bore and _piston_group(e)
            else None
        ),
    ),
    "rod length": (
        "length",
        lambda e: e.rod_length / (e.stroke / 2) if e.rod_length and e.stroke else None,
    ),
    "bore pitch": ("length", lambda e: e.bore_pitch / e.bore if e.bore_pitch and e.bore else None),
    "stroke": ("length", lambda e: e.stroke / e.bore if e.stroke and e.bore else None),
}
"""What is estimated: whether its range is that of a mass or a length; its coefficient."""
SHARED = ("small end", "rod over piston group")
"""Coefficients that all types share."""


@cache
def weighed_bores() -> tuple[float, float]:
    """The least and the greatest bore of the engines whose pistons or rods were weighed, m.

    >>> weighed_bores()
    (0.06985, 0.15)
    """
    bores = [e.bore for e in ENGINES if e.bore and (e.piston or e.piston_group or e.rod)]
    return min(bores), max(bores)


@cache
def proportion(part: str, kind: EngineType, *, without: str = "") -> Proportion:
    """The coefficient of a part in engines of a type. Raises KeyError for a mass of a crosshead.

    `without` leaves an engine out, to compare it with what the others predict.

    >>> coefficient = proportion("piston group", "petrol")
    >>> round(coefficient.low), round(coefficient.typical), round(coefficient.high)
    (589, 736, 962)
    """
    measure, coefficient = PARTS[part]
    every = {e: k for e in ENGINES if e.name != without and (k := coefficient(e)) is not None}
    own = {e: k for e, k in every.items() if part in SHARED or e.kind == kind}
    if kind == "crosshead" and part != "stroke":
        raise KeyError(part)
    if not own and part in ("piston group", "rod") and kind in ("diesel", "diesel-car"):
        return _shared_out(part)
    scarce = len(own) < FEW
    if scarce and (kind in SPARK or not own):
        own |= {e: k for e, k in every.items() if e.kind in SPARK}
    wide = (LONE if scarce else SPREAD)[measure]
    typical = _mean([*own.values()])
    low, high = min(typical / wide, *own.values()), max(typical * wide, *own.values())
    if part == "bore pitch":
        low = max(low, 1.0)  # cylinders of a row do not overlap
    return Proportion(typical, low, high, tuple(e.name for e in own), scarce)


def _shared_out(part: str) -> Proportion:
    """Piston group or rod of a diesel from what reciprocates: m_p + c m_r = k D^3, m_r = q m_p."""
    whole = proportion("reciprocating", "diesel")
    share = proportion("small end", "diesel").typical
    rods = proportion("rod over piston group", "diesel").typical
    own = (rods if part == "rod" else 1.0) / (1 + share * rods)
    numbers = (own * number for number in whole[:3])
    return Proportion(*numbers, engines=whole.engines, scarce=True)


def piston_speed(kind: EngineType) -> tuple[float, float, float]:
    """Mean piston speed at rated speed, m/s: lowest, typical, highest.

    >>> piston_speed("petrol")[1]
    16.0
    """
    typical = PISTON_SPEEDS[kind]
    return typical / SPEED_SPREAD, typical, typical * SPEED_SPREAD


def pins_of_cylinder(engine: Assembly) -> float:
    """The crankpins of an engine over its cylinders: what each has of the mass of one pin.

    1 of an in-line engine, 1/2 of a V whose rods share pins, 1/9 of a radial of nine cylinders.
    """
    pins = {(cylinder.shaft, cylinder.throw) for cylinder in engine.cylinders}
    return len(pins) / len(engine.cylinders)


def rod_inertia(*, mass: float, rod_length: float, small_end: float) -> tuple[float, float, float]:
    """Moment of inertia about the centre of mass, kg m^2: lowest, typical, highest.

    That of two masses at the ends, m c (1 - c) l^2, over TWO_MASSES; c the share of the small end.
    """
    two = mass * small_end * (1 - small_end) * rod_length**2
    least, mean, greatest = TWO_MASSES
    return two / greatest, two / mean, two / least


class Look(NamedTuple):
    """What of an engine tells its type; lengths in m, speed in rad/s, None where not known."""

    bore: float
    stroke: float
    cycle: str
    cylinders: int
    radial: bool = False
    opposed: bool = False
    speed: float | None = None
    ignition: Ignition | None = None


def look_of(engine: Assembly, gas: Gas | None) -> Look | None:
    """What of an engine and its gas tells its type; None where its size is not known."""
    if "radius" in engine.relative:
        return None
    first = engine.first
    stroke = 2 * engine.throw(first).radius
    return Look(
        bore=first.bore or stroke,
        stroke=stroke,
        cycle=engine.cycle,
        cylinders=len(engine.chambers),
        radial=is_radial(engine),
        opposed=len(engine.chambers) < len(engine.cylinders),
        speed=fastest(engine, gas),
        ignition=said_ignition(gas)[0],
    )


def row_pitch(engine: Assembly) -> float | None:
    """The least distance of neighbours of a row along the shaft, m; None where nothing says it.

    A row are cylinders of one shaft that point the same way from the same offset; two pistons in
    one cylinder, or one behind the other, stand at one place. So cylinders across a V or of one
    star do not limit each other.

    >>> from crankstar.files.catalog import load
    >>> round(row_pitch(load("audi-25-tfsi")) or 0, 4)
    0.088
    """
    if "pitch" in engine.relative:
        return None
    rows: dict[tuple[str, float, float], list[float]] = {}
    for each in engine.cylinders:
        row = each.shaft, round(each.bearing, 6), round(each.offset, 6)
        rows.setdefault(row, []).append(each.z)
    gaps = [b - a for row in rows.values() for a, b in pairwise(sorted(row)) if b - a > 1e-6]
    return min(gaps, default=None)


def bores_in(
    bores: tuple[float, float, float], pitch: float | None, kind: EngineType
) -> tuple[float, float, float]:
    """Lowest, typical and highest bore, m, as far as neighbours in a row leave room for them.

    None is greater than pitch / 1.05. Where that of usual stroke to bore would be, the pitch says
    more than the stroke: the typical one is that of its usual ratio, the lowest pitch / 1.35.

    >>> [round(1e3 * each, 1) for each in bores_in((0.0828, 0.0994, 0.12), 0.088, "diesel-car")]
    [65.2, 81.2, 83.8]
    >>> bores_in((0.08, 0.09, 0.1), None, "petrol")
    (0.08, 0.09, 0.1)
    """
    low, typical, high = bores
    if pitch is None:
        return bores
    narrow, wide = PITCH_OVER_BORE
    most = pitch / narrow
    if typical > most:
        usual = proportion("bore pitch", "diesel" if kind == "crosshead" else kind).typical
        low, typical = min(low, pitch / wide), pitch / usual
    return low, typical, min(high, most)


def is_radial(engine: Assembly) -> bool:
    """Whether rods are articulated, or the cylinders of a crankpin stand all round it.

    Four that do are an X, whose type its size tells.

    >>> from crankstar.files.catalog import load
    >>> [is_radial(load(name)) for name in ("radial-9", "v8-cross-plane")]
    [True, False]
    """
    on: dict[tuple[str, int], list[float]] = {}
    for own in engine.cylinders:
        on.setdefault((own.shaft, own.throw), []).append(own.bearing % (2 * pi))
    for bearings in on.values():
        ordered = sorted(bearings)
        gaps = [after - before for before, after in pairwise([*ordered, ordered[0] + 2 * pi])]
        if len(bearings) > FEW_ROUND and len(bearings) != X and max(gaps) < pi * (1 - 1e-9):
            return True
    return any(own.articulated for own in engine.cylinders)


def fastest(engine: Assembly, gas: Gas | None) -> float | None:
    """The highest speed that a file has for its engine, rad/s."""
    known = [engine.speed]
    if gas is not None:
        known += [gas.speed, *(point.speed for point in gas.points)]
    return max((speed for speed in known if speed is not None), default=None)


FEW_ROUND, X = 2, 4
"""Cylinders of a crankpin that are no star: two, and four, which are an X."""
GREATEST_TRUNK = 0.65
"""Bore (m) above which no trunk-piston engine is built."""
SLOW = 2.0
"""Stroke over bore from which a two-stroke engine has a crosshead."""
CAR = 0.115
"""Greatest bore of car engines, m."""
HIGH_SPEED = 900.0
"""Speed, rad/s (8600 rpm), above that of road cars."""
FEW_CYLINDERS = 2
"""Cylinders of which cars have more, of motorcycles with a slow piston speed or a fast one."""
SLOW_CAR = 490.0
"""Speed, rad/s (4700 rpm), below the rated speed of petrol cars."""


def inferred(look: Look) -> tuple[EngineType, str]:
    """The type of an engine and what tells it, as the key of a sentence in `tables`.

    >>> inferred(Look(bore=0.5, stroke=2.0, cycle="two-stroke", cylinders=6))
    ('crosshead', 'long-stroke')
    """
    mean_speed = None if look.speed is None else look.stroke * look.speed / pi
    if look.bore > GREATEST_TRUNK:
        return "crosshead", "large-bore"
    if look.cycle == "two-stroke" and look.stroke > SLOW * look.bore and look.bore > CAR:
        return "crosshead", "long-stroke"
    if look.opposed and look.ignition != "spark":
        return "diesel", "opposed"
    if look.radial:
        return "aero", "radial"
    if look.bore > CAR:
        if mean_speed is None:
            return "diesel", "large"
        if mean_speed <= (PISTON_SPEEDS["diesel"] + PISTON_SPEEDS["aero"]) / 2:
            return "diesel", "large-slow"
        compressed = look.ignition == "compression"
        return ("diesel", "large-compression") if compressed else ("aero", "large-fast")
    return _small(look, mean_speed)


def _small(look: Look, mean_speed: float | None) -> tuple[EngineType, str]:
    """The same of an engine with the bore of cars, at a mean piston speed in m/s."""
    slow = look.speed is not None and look.speed < SLOW_CAR
    heavy = slow and mean_speed is not None and mean_speed < PISTON_SPEEDS["diesel"]
    if look.ignition == "compression":
        if look.cycle == "two-stroke":
            return "diesel", "compression-two-stroke"
        if mean_speed is None:
            return "diesel-car", "compression"
        if heavy:
            return "diesel", "compression-slow"
        return "diesel-car", "compression-piston-speed" if slow else "compression-fast"
    if look.cycle == "two-stroke":
        return "motorcycle", "small-two-stroke"
    if look.speed is not None and look.speed > HIGH_SPEED:
        return "motorcycle", "high-speed"
    few = look.cylinders <= FEW_CYLINDERS
    if few and (mean_speed is None or mean_speed > PISTON_SPEEDS["petrol"]):
        return "motorcycle", "few-cylinders" if mean_speed is None else "few-fast-cylinders"
    if slow and look.ignition != "spark":
        if few and not heavy:
            return "motorcycle", "few-slow-cylinders"
        return ("diesel", "slow") if heavy else ("diesel-car", "slow-piston-speed")
    if slow:
        return "petrol", "spark"
    return "petrol", "car-bore" if mean_speed is None else "car"
