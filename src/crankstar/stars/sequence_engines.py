"""A star with its firing sequence as an Engine, and the shaft of an Engine.

A throw of class c comes to top dead centre c steps of crank angle after throw 1. The shaft turns
clockwise seen from the front, so that its pin stands at the bearing -c step from that of throw 1.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from math import radians

from crankstar.engine.basis import ASSUMED_ROD_RATIO, Basis, Sizes
from crankstar.engine.copies import with_throws_turned, with_values
from crankstar.engine.dead_centres import dead_centres
from crankstar.engine.engine import Engine
from crankstar.engine.layouts import Bank, inline, vee
from crankstar.engine.records import Cylinder
from crankstar.firing.intervals import Firing, firing
from crankstar.firing.numbering import with_order
from crankstar.stars.faults import SearchError, error, fault
from crankstar.stars.shafts import Fired, Shaft

SOURCE = "a crank star with its firing sequence, found by search"
DECIMALS = 9
"""Of degrees to which dead centres are the same."""


def _firing(shaft: Shaft, fired: Fired, later_deg: Sequence[float] = ()) -> Firing:
    angles = shaft.angles_deg(fired)
    order = shaft.firing_order(fired)
    even = shaft.cycle_deg / shaft.cylinders
    start = float(angles[order[0]]) % shaft.cycle_deg
    later = [later_deg[number - 1] if later_deg else 0.0 for number in order]
    places = tuple(start + index * even + by for index, by in enumerate(later))
    following = (*places[1:], places[0] + shaft.cycle_deg)
    gaps = tuple(then - this for this, then in zip(places, following, strict=True))
    return Firing(order, places, gaps, float(shaft.cycle_deg))


def _throw_angles(shaft: Shaft, fired: Fired, later_deg: Sequence[float] = ()) -> list[float]:
    """By how much crank angle each throw comes later than that of cylinder 1, radians."""
    own = [later_deg[pin[0] - 1] if later_deg else 0.0 for pin in shaft.numbers]
    even = [float(place * shaft.step_deg) for place in fired.star]
    return [radians(angle + by) for angle, by in zip(even, own, strict=True)]


def engine_of(shaft: Shaft, fired: Fired, later_deg: Sequence[float] = ()) -> Engine:
    """The engine of a star and its sequence: radius and masses of one, places in pitches.

    `later_deg`: by how many degrees each cylinder, by number, comes later than in the star.

    >>> from crankstar.stars.shafts import shaft_of
    >>> cross = shaft_of(8, bank_angle_deg=90)
    >>> engine_of(cross, cross.fired_in((1, 8, 4, 3, 6, 5, 7, 2))).firing_order
    (1, 8, 4, 3, 6, 5, 7, 2)
    """
    order = "-".join(map(str, shaft.firing_order(fired)))
    angle = f"V{shaft.cylinders}, {float(shaft.bank_angle_deg):g} deg"
    kind = angle if shaft.rods == 2 else f"{shaft.cylinders} cylinders"
    basis = Basis(
        name=f"{kind}, {shaft.cycle}, {order}",
        cycle=shaft.cycle,
        cylinder=Sizes(rod_ratio=ASSUMED_ROD_RATIO),
        relative=("pitch",),
        source=SOURCE,
    )
    throws = tuple(-angle for angle in _throw_angles(shaft, fired, later_deg))
    behind = tuple(float(shaft.places[0] - place) for place in shaft.places)
    if shaft.rods == 1:
        built = inline(basis, throws=throws, positions=behind)
    else:
        half = radians(float(shaft.bank_angle_deg)) / 2
        banks = tuple(
            Bank(bearing=sign * half, cylinders=tuple(pin[bank] for pin in shaft.numbers))
            for bank, sign in enumerate((1, -1))
        )
        built = vee(basis, banks=banks, throws=throws, positions=behind)
    return with_order(with_values(built, bore_pitch=1.0), _firing(shaft, fired, later_deg))


def shaft_of_engine(engine: Engine) -> Shaft:
    """The shaft of an engine in line or with two rods on each throw. Raises SearchError.

    >>> from crankstar.files.catalog import load
    >>> shaft_of_engine(load("merlin")).numbers[0]
    (1, 7)
    """
    faults = []
    if len(engine.shafts) != 1 or engine.shaft(engine.first.shaft).speed_ratio != 1:
        faults.append(fault("", "several-shafts", engine=engine.name))
    if any(cylinder.articulated or cylinder.chamber for cylinder in engine.cylinders):
        faults.append(fault("", "slave-rods", engine=engine.name))
    if faults:
        raise SearchError(faults)
    on: dict[int, list[Cylinder]] = {}
    for cylinder in sorted(engine.cylinders, key=lambda each: each.number):
        on.setdefault(cylinder.throw, []).append(cylinder)
    first = engine.cylinders[0].bearing
    pins = [sorted(own, key=lambda each: abs(each.bearing - first) > 1e-9) for own in on.values()]
    pins.sort(key=lambda own: -sum(each.z for each in own) / len(own))
    bearings = {tuple(round(each.bearing, 9) for each in own) for own in pins}
    if len(bearings) != 1 or len(pins) < 2 or len(pins[0]) > 2:
        raise error("", "not-shared", engine=engine.name)
    centres = dead_centres(engine)
    angle = 0.0
    if len(pins[0]) == 2:
        one, other = (centres[each.number].angle_deg for each in pins[0])
        angle = round(180 - (180 - one + other) % 360, DECIMALS)
    z = [sum(each.z for each in own) / len(own) for own in pins]
    pitch = (z[0] - z[-1]) / (len(z) - 1)
    places = [Fraction(each / pitch).limit_denominator(10_000) for each in z]
    middle = (places[0] + places[-1]) / 2
    return Shaft(
        engine.cycle,
        tuple(place - middle for place in places),
        tuple(tuple(each.number for each in own) for own in pins),
        Fraction(angle).limit_denominator(10_000),
    )


def fired_of_engine(engine: Engine, shaft: Shaft) -> Fired | None:
    """The star and sequence that an engine has now; None where it fires otherwise.

    >>> from crankstar.files.catalog import load
    >>> engine = load("i6")
    >>> fired_of_engine(engine, shaft_of_engine(engine)).star
    (0, 1, 2, 2, 1, 0)
    """
    own = firing(engine)
    if not own.order:
        return None
    try:
        return shaft.fired_of(dict(zip(own.order, own.angles_deg, strict=True)))
    except SearchError:
        return None


def with_fired(
    engine: Engine, shaft: Shaft, fired: Fired, later_deg: Sequence[float] = ()
) -> Engine:
    """An engine with its throws turned to a star, weights with them, and a firing sequence.

    `later_deg`: by how many degrees each cylinder, by number, comes later than in the star.
    """
    of = {cylinder.number: cylinder for cylinder in engine.cylinders}
    home = of[shaft.numbers[0][0]]
    zero = engine.throw(home).angle
    turns: dict[tuple[str, int], float] = {}
    behind = _throw_angles(shaft, fired, later_deg)
    for pin, own in zip(shaft.numbers, behind, strict=True):
        cylinder = of[pin[0]]
        angle = zero - engine.sense * own
        turns[cylinder.shaft, cylinder.throw] = angle - engine.throw(cylinder).angle
    known = {
        key: value
        for key, value in engine.provenance.items()
        if "throw" not in key and not key.startswith("firing")
    }
    order = shaft.firing_order(fired)
    words = f"{engine.name}, throws turned: fires {'-'.join(map(str, order))}"
    start = dead_centres(engine)[shaft.numbers[0][0]].angle_deg
    values = {"name": words, "firing_order": order, "provenance": known}
    angles = tuple(radians(angle + start) for angle in _firing(shaft, fired, later_deg).angles_deg)
    return with_throws_turned(engine, turns, **values, firing_angles=angles)
