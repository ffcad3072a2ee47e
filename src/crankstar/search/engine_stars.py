"""The stars of a real engine: its cylinders' places, and vector sums in newtons and newton metres.

The inertia force of a cylinder of an in-line engine is, of each order, a wave along its axis, of
amplitude a_k (newtons at a speed, else in m r w^2): it holds reciprocating mass, crank radius,
speed and the harmonic A_k of its rod ratio. The same waves on other throws make the sums

    F_k = a_k |sum of q_j exp(i k phi_j)|,  M_k = a_k |sum of q_j z_j exp(i k phi_j)|,

the amplitudes of force and couple in the plane of the cylinders; q_j is the force of cylinder j
over that of the first. What turns with the crank (pins, big ends) is left out: counterweights take
it away.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction
from math import pi, radians, sqrt
from typing import NamedTuple

import numpy as np

from crankstar import spectra
from crankstar.derive.algebra import rational as meant
from crankstar.engine.copies import throws_of_weights, with_throws_turned
from crankstar.engine.engine import Engine
from crankstar.mechanics.balance import Balance, Units, balance, of_parts
from crankstar.search.engines import firing_order
from crankstar.search.faults import SearchError, fault
from crankstar.search.stars import Star, Stars
from crankstar.search.sums import Objective, VectorSum, couple, force

ORDERS = (1, 2, 4, 6)
"""Of the couple of all orders together: those that a piston makes, but for the small."""
ALIKE = 1e-9


def stars_of(
    engine: Engine, *, symmetric: bool = False, fixed: tuple[tuple[int, int], ...] = ()
) -> Stars:
    """All stars of the cylinders of an in-line engine, at their places (in m, or in pitches).

    Raises SearchError where the engine is not in line with a throw for each cylinder.
    """
    cylinders = sorted(engine.cylinders, key=lambda cylinder: -cylinder.z)
    bearings = {round(cylinder.bearing, 9) for cylinder in cylinders}
    throws = {cylinder.throw for cylinder in cylinders}
    name = engine.name
    faults = [fault("", "one-cylinder", engine=name)] if len(cylinders) < 2 else []
    in_line = len({cylinder.shaft for cylinder in cylinders}) == len(bearings) == 1
    if not in_line or len(throws) < len(cylinders):
        faults.append(fault("", "not-in-line", engine=name))
    if any(cylinder.articulated or cylinder.chamber for cylinder in cylinders):
        faults.append(fault("", "slave-rods", engine=name))
    if [cylinder.number for cylinder in cylinders] != list(range(1, len(cylinders) + 1)):
        faults.append(fault("", "numbering", engine=name))
    if faults:
        raise SearchError(faults)
    places = [meant.ratio(cylinder.z) for cylinder in cylinders]
    middle = (places[0] + places[-1]) / 2
    return Stars(
        len(cylinders), engine.cycle, tuple(place - middle for place in places), symmetric, fixed
    )


def star_of(engine: Engine, stars: Stars) -> Star | None:
    """The star that an engine has now; None where its throws stand elsewhere.

    >>> from crankstar.files.catalog import load
    >>> engine = load("i6")
    >>> star_of(engine, stars_of(engine))
    (0, 1, 2, 2, 1, 0)
    """
    angles = [
        engine.throw(cylinder).angle
        for cylinder in sorted(engine.cylinders, key=lambda cylinder: cylinder.number)
    ]
    places = [(angles[0] - angle) * engine.sense * stars.directions / (2 * pi) for angle in angles]
    if any(abs(place - round(place)) > ALIKE for place in places):
        return None
    star = tuple(round(place) % stars.directions for place in places)
    return None if stars.misfit(star) else star


PISTONS_ONLY = "{name} (pistons)"
"""Name of a sum in which the rotating parts are left out."""


def force_of(engine: Engine, stars: Stars, order: int, *, speed: float | None = None) -> VectorSum:
    """F_k of an engine: the largest value over a turn of its force of an order, for a star.

    N at a speed or m r w^2. See `_waves` for what is counted.
    """
    waves = _waves(engine, order, speed)
    plain = force(stars, order)
    return replace(
        plain,
        name=plain.name if waves.force else PISTONS_ONLY.format(name=plain.name),
        weights=waves.shares,
        scale=waves.size * (waves.force or 1.0),
        unit=waves.units.force,
    )


def couple_of(engine: Engine, stars: Stars, order: int, *, speed: float | None = None) -> VectorSum:
    """M_k of an engine: the largest value over a turn of its couple of an order, for a star.

    About the middle, N m at a speed or m r w^2 a. See `_waves` for what is counted.

    >>> from crankstar.files.catalog import load
    >>> engine = load("sinitsyn-7-first")
    >>> round(couple_of(engine, stars_of(engine), 1).length((0, 4, 2, 5, 1, 3, 6)), 4)
    0.8516
    """
    waves = _waves(engine, order, speed)
    plain = couple(stars, order)
    places = zip(waves.shares, plain.weights, strict=True)
    per = engine.pitch if waves.units.couple.endswith("*a") else 1.0
    return replace(
        plain,
        name=plain.name if waves.couple else PISTONS_ONLY.format(name=plain.name),
        weights=tuple(share * place for share, place in places),
        scale=waves.size * (waves.couple or 1.0) / per,
        unit=waves.units.couple,
    )


def rms_couple(engine: Engine, stars: Stars, *, speed: float | None = None) -> Objective:
    """The root mean square, over a turn, of the couple of orders 1, 2, 4 and 6.

    A vector f with and b against the crank has the root of |f|^2 + |b|^2; with |f| = q |b| that is
    the root of 1 + q^2 over 1 + q of the largest value.
    """
    terms: list[tuple[float, VectorSum]] = []
    for order in ORDERS:
        q = 2 * (_waves(engine, order, speed).couple or 1.0) - 1
        term = couple_of(engine, stars, order, speed=speed)
        terms.append((sqrt(1 + q * q) / (1 + q), term))
    return Objective(
        "couple", tuple(term for term in terms if term[1].scale > 0), unit=terms[0][1].unit
    )


def with_star(
    engine: Engine, stars: Stars, star: Star, *, later_deg: Sequence[float] | None = None
) -> Engine:
    """The engine with its throws turned to a star, weights with them, and its firing order.

    `later_deg`: by how many degrees of crank angle each cylinder comes later to top dead centre
    than the star says.
    """
    later = later_deg or (0.0,) * stars.cylinders
    first = engine.throw(engine.first).angle
    turn = -engine.sense * 2 * pi / stars.directions
    turns: dict[tuple[str, int], float] = {}
    for cylinder in engine.cylinders:
        place = cylinder.number - 1
        behind = -engine.sense * radians(later[place] - later[0])
        angle = first + turn * (star[place] - star[0]) + behind
        turns[cylinder.shaft, cylinder.throw] = angle - engine.throw(cylinder).angle
    order = firing_order(stars, star)
    words = f"{engine.name}, throws turned: fires {'-'.join(map(str, order))}"
    known = {
        key: value
        for key, value in engine.provenance.items()
        if "throw" not in key and not key.startswith("firing")
    }
    return with_throws_turned(
        engine, turns, name=words, firing_order=order, firing_angles=None, provenance=known
    )


class _Waves(NamedTuple):
    """The pistons' waves of one order, and by how much all parts together are larger.

    `size`: amplitude of the first piston's force; `shares`: of each over it; `force`, `couple`: the
    largest value of all parts over that of the pistons, the same for every star, or None.
    """

    size: float
    shares: tuple[Fraction, ...]
    force: float | None
    couple: float | None
    units: Units


def _waves(engine: Engine, order: int, speed: float | None) -> _Waves:
    """The pistons push along the cylinders; throws and weights turn with the crankshaft.

    A throw with its weights adds to the vector that turns with the crank. Where it does so in the
    same ratio q for every throw, a sum of all parts is (1 + |q|)/2 times that of the pistons, for
    every star. Where the throws differ, or other shafts push in this order, there is no such number
    and only the pistons are counted.
    """
    result = balance(engine, speed=speed)
    numbers = [
        cylinder.number for cylinder in sorted(engine.cylinders, key=lambda cylinder: -cylinder.z)
    ]
    parts = [of_parts(result, cylinder=number) for number in numbers]
    waves = [spectra.selected(part.force, order) for part in parts]
    sizes = [2 * abs(complex(wave.backward[0])) for wave in waves]
    if sizes[0] <= ALIKE * max(abs(complex(wave.forward[0])) for wave in waves) or sizes[0] == 0:
        return _Waves(0.0, (Fraction(1),) * len(sizes), 1.0, 1.0, result.units)
    shares = tuple(meant.ratio(size / sizes[0], rounding=ALIKE) for size in sizes)
    of_force = _ratio(engine, result, numbers, order, "force")
    of_couple = _ratio(engine, result, numbers, order, "couple")
    return _Waves(sizes[0], shares, of_force, of_couple, result.units)


def _ratio(
    engine: Engine, result: Balance, numbers: Sequence[int], order: int, quantity: str
) -> float | None:
    """The largest value of all parts over that of the pistons; None where it hangs on the star."""
    vectors = spectra.selected(getattr(result, quantity), order)
    forward, backward = vectors.forward[:, 0], vectors.backward[:, 0]
    cylinder_of = {(c.shaft, c.throw): c.number for c in engine.cylinders}
    homes: list[int | None] = [part.cylinder for part in result.parts if part.cylinder]
    homes += [
        cylinder_of.get((shaft.name, throw))
        for shaft in engine.shafts
        for throw in range(1, len(shaft.throws) + 1)
    ]
    homes += [
        None if throw is None else cylinder_of.get((shaft.name, throw))
        for shaft in engine.shafts
        for throw in throws_of_weights(shaft)
    ]
    home = np.array([number or 0 for number in homes])
    with_crank = np.array([forward[home == number].sum() for number in numbers])
    against = np.array([backward[home == number].sum() for number in numbers])
    negligible = ALIKE * float(np.abs([with_crank, against]).max())
    if np.abs([forward[home == 0], backward[home == 0]]).max(initial=0.0) > negligible:
        return None
    there = np.abs(against) > negligible
    if np.any(np.abs(with_crank[~there]) > negligible):
        return None
    ratios = with_crank[there] / np.conj(against[there])
    if ratios.size and np.abs(ratios - ratios[0]).max() > ALIKE * max(1.0, abs(ratios[0])):
        return None
    return (1 + abs(complex(ratios[0]))) / 2 if ratios.size else 1.0
