"""The stars of a real engine: its cylinders' places, and vector sums in newtons and newton metres.

The inertia force of a cylinder of an in-line engine is, of each order, a wave along its axis, of amplitude a_k (newtons at a
speed, else in m r w^2): it holds reciprocating mass, crank radius, speed and the harmonic A_k of its rod ratio. The same waves
on other throws make the sums

    F_k = a_k |sum of q_j exp(i k phi_j)|,  M_k = a_k |sum of q_j z_j exp(i k phi_j)|,

the amplitudes of force and couple in the plane of the cylinders; q_j is the force of cylinder j over that of the first. What
turns with the crank (pins, big ends) is left out: counterweights take it away.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction
from math import pi, radians, sqrt

from crankstar import phasor
from crankstar.balance import balance, of_parts
from crankstar.derive import meant
from crankstar.engine import Engine
from crankstar.records import Throw
from crankstar.search.engines import firing_order
from crankstar.search.stars import SearchError, Star, Stars
from crankstar.search.sums import Objective, VectorSum, couple, force

ORDERS = (1, 2, 4, 6)
"""Of the couple of all orders together: those that a piston makes, but for the small."""
ALIKE = 1e-9


def stars_of(engine: Engine, *, symmetric: bool = False, fixed: tuple[tuple[int, int], ...] = ()) -> Stars:
    """All stars that the cylinders of an in-line engine can have, at their places along the shaft (in m, or in pitches).

    Raises SearchError where the engine is not in line with a throw for each cylinder.
    """
    cylinders = sorted(engine.cylinders, key=lambda cylinder: -cylinder.z)
    bearings = {round(cylinder.bearing, 9) for cylinder in cylinders}
    throws = {cylinder.throw for cylinder in cylinders}
    faults: list[str] = ["it has one cylinder, and a star needs two"] if len(cylinders) < 2 else []
    if len({cylinder.shaft for cylinder in cylinders}) > 1 or len(bearings) > 1 or len(throws) < len(cylinders):
        faults.append("its cylinders do not stand in line, each on a throw of its own; give the number of throws instead")
    if any(cylinder.articulated or cylinder.chamber for cylinder in cylinders):
        faults.append("it has slave rods or shared chambers; give the number of throws instead")
    if [cylinder.number for cylinder in cylinders] != list(range(1, len(cylinders) + 1)):
        faults.append("its cylinders are not numbered 1, 2, 3 ... from the front; number them so")
    if faults:
        raise SearchError([f"{engine.name}: {fault}" for fault in faults])
    places = [meant.ratio(cylinder.z) for cylinder in cylinders]
    middle = (places[0] + places[-1]) / 2
    return Stars(len(cylinders), engine.cycle, tuple(place - middle for place in places), symmetric, fixed)


def star_of(engine: Engine, stars: Stars) -> Star | None:
    """The star that an engine has now; None where its throws stand elsewhere.

    >>> from crankstar.catalog import load
    >>> engine = load("i6")
    >>> star_of(engine, stars_of(engine))
    (0, 1, 2, 2, 1, 0)
    """
    angles = [engine.throw(cylinder).angle for cylinder in sorted(engine.cylinders, key=lambda cylinder: cylinder.number)]
    places = [(angles[0] - angle) * engine.sense * stars.directions / (2 * pi) for angle in angles]
    if any(abs(place - round(place)) > ALIKE for place in places):
        return None
    star = tuple(round(place) % stars.directions for place in places)
    return None if stars.misfit(star) else star


def force_of(engine: Engine, stars: Stars, order: int, *, speed: float | None = None) -> VectorSum:
    """F_k of an engine: the amplitude of its inertia force of an order, for a star, N at a speed or m r w^2."""
    size, shares, unit, _ = _waves(engine, order, speed)
    return replace(force(stars, order), weights=shares, scale=size, unit=unit)


def couple_of(engine: Engine, stars: Stars, order: int, *, speed: float | None = None) -> VectorSum:
    """M_k of an engine: the amplitude of its couple of an order about the middle, for a star, N m at a speed or m r w^2 a.

    >>> from crankstar.catalog import load
    >>> engine = load("sinitsyn-7-first")
    >>> round(couple_of(engine, stars_of(engine), 1).length((0, 4, 2, 5, 1, 3, 6)), 4)
    0.8516
    """
    size, shares, _, unit = _waves(engine, order, speed)
    plain = couple(stars, order)
    weights = tuple(share * place for share, place in zip(shares, plain.weights, strict=True))
    per = engine.pitch if unit.endswith("*a") else 1.0
    return replace(plain, weights=weights, scale=size / per, unit=unit)


def rms_couple(engine: Engine, stars: Stars, *, speed: float | None = None) -> Objective:
    """The root mean square, over a turn, of the couple of orders 1, 2, 4 and 6 in the plane of the cylinders."""
    terms = tuple((1 / sqrt(2), couple_of(engine, stars, order, speed=speed)) for order in ORDERS)
    return Objective("couple", tuple(term for term in terms if term[1].scale > 0), unit=terms[0][1].unit)


def with_star(engine: Engine, stars: Stars, star: Star, *, later_deg: Sequence[float] | None = None) -> Engine:
    """The engine with its throws turned to a star, and the firing order that goes with it.

    `later_deg`: by how many degrees of crank angle each cylinder comes later to top dead centre than the star says.
    """
    later = later_deg or (0.0,) * stars.cylinders
    number = {cylinder.throw: cylinder.number for cylinder in engine.cylinders}
    (name,) = {cylinder.shaft for cylinder in engine.cylinders}
    first = engine.throw(engine.first).angle
    turn = -engine.sense * 2 * pi / stars.directions

    def turned(throw: Throw, place: int) -> Throw:
        if place not in number:
            return throw
        cylinder = number[place] - 1
        behind = -engine.sense * radians(later[cylinder] - later[0])
        return throw.model_copy(update={"angle": first + turn * (star[cylinder] - star[0]) + behind})

    shafts = tuple(
        shaft.model_copy(update={"throws": tuple(turned(throw, place) for place, throw in enumerate(shaft.throws, 1))})
        if shaft.name == name
        else shaft
        for shaft in engine.shafts
    )
    order = firing_order(stars, star)
    words = f"{engine.name}, throws turned: fires {'-'.join(map(str, order))}"
    known = {key: value for key, value in engine.provenance.items() if "throw" not in key and not key.startswith("firing")}
    changed = {"name": words, "shafts": shafts, "firing_order": order, "firing_angles": None, "provenance": known}
    return Engine.model_validate(engine.model_copy(update=changed).model_dump())


def _waves(engine: Engine, order: int, speed: float | None) -> tuple[float, tuple[Fraction, ...], str, str]:
    """Amplitude of the first cylinder's force of an order, that of each over it, and the units of force and couple."""
    result = balance(engine, speed=speed)
    numbers = [cylinder.number for cylinder in sorted(engine.cylinders, key=lambda cylinder: -cylinder.z)]
    waves = [phasor.selected(of_parts(result, cylinder=number).force, order) for number in numbers]
    sizes = [2 * abs(complex(wave.backward[0])) for wave in waves]
    if sizes[0] <= ALIKE * max(abs(complex(wave.forward[0])) for wave in waves) or sizes[0] == 0:
        return 0.0, (Fraction(1),) * len(sizes), result.units.force, result.units.couple
    return sizes[0], tuple(meant.ratio(size / sizes[0], rounding=ALIKE) for size in sizes), result.units.force, result.units.couple
