"""From cylinder places to an Engine: common sizes filled in, cylinders put on pins.

A layout (module `layouts`) only says where each cylinder stands and on which pin its rod works;
here sizes and their overrides are looked up, the crankshafts are turned so that the first cylinder
is at top dead centre at theta = 0, z is counted from the middle of the cylinders' span, and what is
not known is named.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from fractions import Fraction
from math import pi, radians
from typing import Any

from crankstar.engine import motion
from crankstar.engine.basis import ASSUMED_ROD_RATIO, BALANCE_FACTOR, ROD_SOURCE, Basis, Sizes
from crankstar.engine.copies import checked, turned_on, with_values, wrapped
from crankstar.engine.crankshafts import equipped
from crankstar.engine.dead_centres import dead_centres
from crankstar.engine.engine import Engine
from crankstar.engine.quantities import Unknown
from crankstar.engine.records import (
    Articulation,
    Cylinder,
    Identity,
    Parts,
    Provenance,
    Rod,
    Shaft,
    Throw,
    Weight,
)
from crankstar.language.faults import EngineError, Fault


@dataclass(frozen=True)
class Place:
    """A cylinder's place: shaft, pin (a key and an angle from the shaft's pin 1), bearing, z."""

    number: int
    shaft: int
    pin: int
    pin_angle: float
    bearing: float
    z: float
    bank: str | None = None
    offset: float | None = None
    chamber: int | None = None
    articulated: Articulation | None = None
    slave_rod_length: float | None = None


@dataclass(frozen=True)
class ShaftPlace:
    """A crankshaft's place (m or crank radii), speed ratio, lag of its first cylinder (radians)."""

    name: str = "crank"
    up: float = 0.0
    right: float = 0.0
    speed_ratio: Fraction = Fraction(1)
    lag: float = 0.0


@dataclass(frozen=True)
class _Known:
    """The sizes of one cylinder, complete."""

    bore: float | None
    radius: float
    rod_length: float
    offset: float
    mass: float
    rotating_mass: float
    throw_mass: float
    rod: Rod | None
    parts: Parts | None

    def balanced(self, factor: float) -> float:
        """All that turns at the crank radius, and this share of the reciprocating mass."""
        turning, moving = self.rod.shares(self.rod_length) if self.rod else (0.0, 0.0)
        return self.rotating_mass + self.throw_mass + turning + factor * (self.mass + moving)


OF_FACTOR = Provenance(status="computed", source="a counterweight opposite each crankpin")
"""Where the weights of a balance factor come from."""


def assembled(
    basis: Basis,
    places: list[Place],
    shafts: list[ShaftPlace],
    *,
    pitch: float | None,
    pitch_needed: bool = True,
) -> Engine:
    """Cylinders and throws from their places.

    Sizes, dead centres, z about the middle, counterweights.

    `pitch` is the bore pitch; without one, where it was needed, z is counted in it. Raises
    EngineError.
    """
    faults = list(_misplaced(basis, places))
    if faults:
        raise EngineError(faults)
    middle = (min(place.z for place in places) + max(place.z for place in places)) / 2
    placed = [_overridden(basis, replace(place, z=place.z - middle)) for place in places]
    sizes = {place.number: _sizes(basis, place) for place in places}
    unknown = _relative(
        basis,
        pitch_unknown=pitch is None and (pitch_needed or basis.cylinder.stroke is None),
        places=places,
    )
    cylinders: list[Cylinder] = []
    turning: list[Shaft] = []
    for index, shaft in enumerate(shafts):
        pins = _pins([place for place in placed if place.shaft == index])
        throws = _throws(basis, pins, sizes, shaft)
        turning.append(
            Shaft(
                name=shaft.name,
                speed_ratio=shaft.speed_ratio,
                up=shaft.up,
                right=shaft.right,
                throws=throws,
                weights=_weights(basis, pins, sizes, throws),
            )
        )
        cylinders += [
            _cylinder(
                basis,
                place,
                sizes[place.number],
                (shaft.name, slot),
                alone=place.articulated is not None or _differ(pin, sizes),
            )
            for slot, pin in enumerate(pins, 1)
            for place in pin
        ]
    identity: dict[str, Any] = {key: getattr(basis, key) for key in Identity.model_fields}
    identity["provenance"] = _assumed(basis) | basis.provenance
    engine = checked(
        Engine,
        {
            **identity,
            "relative": unknown,
            "bore_pitch": 1.0 if "pitch" in unknown and pitch is None else pitch,
            "shafts": tuple(turning),
            "cylinders": tuple(sorted(cylinders, key=lambda cylinder: cylinder.number)),
        },
    )
    return equipped(_timed(engine) if engine.first.articulated else engine, basis)


def _timed(engine: Engine) -> Engine:
    """The engine turned to the first cylinder's true dead centre, which a slave rod shifts."""
    ahead = engine.sense * radians(
        dead_centres(engine)[engine.first.chamber or engine.first.number].angle_deg
    )

    return turned_on(engine, ahead)


def _overridden(basis: Basis, place: Place) -> Place:
    """A place where its override says that it is; the throw goes with its cylinders."""
    own = next((other for other in basis.cylinders if other.number == place.number), None)
    keys = ("bearing", "z", "bank")
    given = {key: getattr(own, key) for key in keys if getattr(own, key, None) is not None}
    return replace(place, **given)


def _misplaced(basis: Basis, places: list[Place]) -> Iterator[Fault]:
    tables: list[tuple[tuple[str | int, ...], Sizes]] = [(("cylinder",), basis.cylinder)]
    tables += [(("cylinders", index), other) for index, other in enumerate(basis.cylinders)]
    for path, sizes in tables:
        if sizes.rod_length is not None and sizes.rod_ratio is not None:
            yield Fault((*path, "rod_ratio"), "rod_ratio.beside-length")
    counts = Counter(place.number for place in places)
    yield from repeated_numbers(counts.elements())
    overridden = Counter(other.number for other in basis.cylinders)
    for index, other in enumerate(basis.cylinders):
        here = ("cylinders", index, "number")
        if other.number not in counts:
            values = {"value": other.number, "numbers": sorted(counts)}
            yield Fault(here, "override.no-such-cylinder", values)
        elif overridden[other.number] > 1:
            yield Fault(here, "override.repeated", {"value": other.number})


def repeated_numbers(numbers: Iterable[int]) -> list[Fault]:
    """The cylinders of a layout that it has more than once."""
    counts = Counter(numbers)
    return [
        Fault(("layout",), "layout.number-repeated", {"number": number, "times": times})
        for number, times in sorted(counts.items())
        if times > 1
    ]


def _assumed(basis: Basis) -> dict[str, Provenance]:
    """What the layout had to assume or to compute, said where a reader looks for provenance."""
    out: dict[str, Provenance] = {}
    if basis.balance_factor is not None:
        out[BALANCE_FACTOR] = OF_FACTOR
    if basis.cylinder.rod_length is None and basis.cylinder.rod_ratio is None:
        out["cylinder.rod_length"] = Provenance(
            status="placeholder", source=f"neither rod_length nor rod_ratio given: {ROD_SOURCE}"
        )
    return out


def _sizes(basis: Basis, place: Place) -> _Known:
    given = {key: getattr(basis.cylinder, key) for key in Sizes.model_fields}
    if place.offset is not None:
        given["offset"] = place.offset
    own = next((other for other in basis.cylinders if other.number == place.number), None)
    different = (
        {}
        if own is None
        else {k: getattr(own, k) for k in Sizes.model_fields if getattr(own, k) is not None}
    )
    if own is not None and own.parts is not None and given["parts"] is not None:
        weighed = {key: getattr(own.parts, key) for key in own.parts.model_fields_set}
        different["parts"] = with_values(given["parts"], **weighed)
    if "rod_ratio" in different and "rod_length" not in different:
        given["rod_length"] = None
    given |= different
    radius = 1.0 if given["stroke"] is None else given["stroke"] / 2
    ratio = ASSUMED_ROD_RATIO if given["rod_ratio"] is None else given["rod_ratio"]
    length = ratio * radius if given["rod_length"] is None else given["rod_length"]
    if place.articulated is not None and (own is None or own.rod_length is None):
        length = (
            length - place.articulated.radius
            if place.slave_rod_length is None
            else place.slave_rod_length
        )
        if length <= 0:
            raise EngineError([Fault(("layout", "knuckle_radius"), "layout.knuckle-too-far")])
    return _Known(
        bore=given["bore"],
        radius=radius,
        rod_length=length,
        offset=given["offset"],
        mass=1.0 if given["reciprocating_mass"] is None else given["reciprocating_mass"],
        rotating_mass=given["rotating_mass"],
        throw_mass=given["throw_mass"],
        rod=given["rod"],
        parts=given["parts"],
    )


def _relative(basis: Basis, *, pitch_unknown: bool, places: list[Place]) -> tuple[Unknown, ...]:
    spread = len({place.z for place in places}) > 1
    unknown: list[tuple[Unknown, bool]] = [
        ("mass", basis.cylinder.reciprocating_mass is None or "mass" in basis.relative),
        ("radius", basis.cylinder.stroke is None or "radius" in basis.relative),
        ("pitch", spread and (pitch_unknown or "pitch" in basis.relative)),
    ]
    return tuple(name for name, missing in unknown if missing)


def _pins(places: list[Place]) -> list[list[Place]]:
    """The cylinders of each crank pin, pins from front to rear."""
    pins: dict[int, list[Place]] = {}
    for place in places:
        pins.setdefault(place.pin, []).append(place)
    return sorted(pins.values(), key=lambda sharing: -_middle(sharing))


def _middle(sharing: list[Place]) -> float:
    return sum(place.z for place in sharing) / len(sharing)


def _throws(
    basis: Basis, pins: list[list[Place]], sizes: dict[int, _Known], shaft: ShaftPlace
) -> tuple[Throw, ...]:
    """The shaft's throws, turned so that its first cylinder is at top dead centre after `lag`."""
    first = min((place for pin in pins for place in pin), key=lambda place: place.number)
    size = sizes[first.number]
    sense = 1 if basis.rotation == "clockwise" else -1
    reaches = abs(size.offset) < size.radius + size.rod_length
    advance = (
        motion.dead_centre(crank_radius=size.radius, rod_length=size.rod_length, offset=size.offset)
        if reaches
        else 0.0
    )
    base = first.bearing + advance - first.pin_angle - sense * float(shaft.speed_ratio) * shaft.lag
    throws: list[Throw] = []
    for sharing in pins:
        radii = {sizes[place.number].radius for place in sharing}
        if len(radii) > 1:
            values = {"numbers": [place.number for place in sharing]}
            raise EngineError([Fault(("cylinders",), "layout.strokes-on-a-pin", values)])
        throws.append(
            Throw(
                angle=wrapped(base + sharing[0].pin_angle),
                radius=radii.pop(),
                z=_middle(sharing),
                rotating_mass=sum(
                    sizes[place.number].rotating_mass
                    for place in sharing
                    if place.articulated is None and not _differ(sharing, sizes)
                ),
                throw_mass=sum(sizes[place.number].throw_mass for place in sharing),
            )
        )
    return tuple(throws)


def _differ(sharing: list[Place], sizes: dict[int, _Known]) -> bool:
    """Whether big ends side by side on a pin are of unequal mass: each has its own place then.

    Of equal ones the middle of the pin is the place of their sum.
    """
    return len({sizes[each.number].rotating_mass for each in sharing if not each.articulated}) > 1


def _weights(
    basis: Basis, pins: list[list[Place]], sizes: dict[int, _Known], throws: tuple[Throw, ...]
) -> tuple[Weight, ...]:
    """A counterweight opposite each pin, at crank radius.

    It balances the rotating mass and the share `balance_factor` of the reciprocating mass.
    """
    if basis.balance_factor is None:
        return ()
    weights: list[Weight] = []
    for number, (sharing, throw) in enumerate(zip(pins, throws, strict=True), 1):
        mass = sum(sizes[place.number].balanced(basis.balance_factor) for place in sharing)
        if mass > 0:
            weights.append(
                Weight(
                    unbalance=mass * throw.radius,
                    angle=wrapped(throw.angle + pi),
                    z=throw.z,
                    throw=number,
                )
            )
    return tuple(weights)


def _cylinder(
    basis: Basis, place: Place, size: _Known, seat: tuple[str, int], *, alone: bool
) -> Cylinder:
    """A cylinder in its place.

    `seat`: its shaft and throw. `alone`: its big end is not in the mass of that throw.
    """
    shaft, throw = seat
    own = next((other for other in basis.cylinders if other.number == place.number), None)
    values: dict[str, Any] = {
        "number": place.number,
        "shaft": shaft,
        "throw": throw,
        "bearing": wrapped(place.bearing),
        "z": place.z,
        "offset": size.offset,
        "bore": size.bore,
        "rod_length": size.rod_length,
        "reciprocating_mass": size.mass,
        "big_end_mass": size.rotating_mass if alone else 0.0,
        "rod": size.rod,
        "parts": size.parts,
        "articulated": place.articulated,
        "chamber": place.chamber,
        "bank": place.bank,
    }
    if own is not None and own.articulated is not None:
        values["articulated"] = own.articulated
    return Cylinder(**values)
