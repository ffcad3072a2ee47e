"""Whether a crankshaft bears its bending and its twist for ever: the fillets of each throw.

Each throw is a beam on the middles of the two main bearings beside it. The radial component of what
its rods push its pin with, in the plane of the throw, bends the web in its middle, at L_1 from the
bearing, by M = A L_1 with A the force in the bearing, which also presses or pulls the web. What
counts is half the range over a cycle; means are left out:

    sigma_B = K_e (max M - min M)/2 / (B W^2/6)     nominal bending of the web
    sigma_Q = K_e (max A - min A)/2 / (B W)         nominal compression
    tau     = (max T - min T)/2 / W_p               nominal torsion of pin or journal

K_e is 1, of two-stroke engines 0.8. T is the torque of torsional vibration in any section that a
throw ends, those at both ends of the crankshaft among them, over all speeds of the range but the
barred ones, the greatest for all throws. In a fillet the
equivalent alternating stress, with the additional stress sigma_a, is

    pin       sqrt((alpha_B sigma_B + sigma_a)^2 + 3 (alpha_T tau)^2)
    journal   sqrt((beta_B sigma_B + beta_Q sigma_Q + sigma_a)^2 + 3 (beta_T tau)^2)

taking all to be greatest at once. The fatigue strength over that is the acceptability factor Q; a
crankshaft is accepted from 1.15 on.

Source: Korean Register, Rules for the Classification of Steel Ships (2025), Part 5, Guidance,
Annex 5-3, 2, 4 and 5, with the text of IACS, Unified Requirement M53; the limit of Q is that of
section 7 there.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise
from math import pi
from typing import Literal, NamedTuple

import numpy as np

from crankstar import spectra
from crankstar.dynamics import crank_fillets
from crankstar.dynamics.bearings import all_pin_loads
from crankstar.dynamics.crank_stiffness import polar
from crankstar.dynamics.torsion_analysis import TorsionAnalysis, peaked
from crankstar.dynamics.torsion_response import Response
from crankstar.engine.engine import Engine
from crankstar.engine.fillets import fillet_ratios
from crankstar.engine.main_bearings import main_bearings, pin_groups
from crankstar.engine.records import Shaft
from crankstar.engine.torsion import FACTORS, CrankDimensions, CrankFatigue
from crankstar.language.messages import MessageError
from crankstar.mechanics.gas import Cycle
from crankstar.mechanics.kinetic import throws_from_front
from crankstar.mechanics.lacking import KEYS, lacking_keys
from crankstar.mechanics.mechanism import mechanism
from crankstar.spectra import Real

Place = Literal["pin", "journal"]
ACCEPTED = 1.15
"""The acceptability factor from which on a crankshaft is accepted."""
SAMPLES = 720
"""Crank angles in a turn."""
TWO_STROKE = 0.8
"""K_e of two-stroke engines: neighbouring cranks and bearings hold the throw."""


class FatigueError(MessageError):
    """Fatigue that cannot be computed, and why."""


class Torsional(NamedTuple):
    """The greatest alternating torque, N m, the index of its section, its speed, rad/s."""

    torque: float
    section: int
    speed: float


class Bent(NamedTuple):
    """The web of a throw that bends most: alternating moment, N m, and radial force, N."""

    moment: float
    force: float


class FilletStress(NamedTuple):
    """One fillet, all stresses alternating, Pa: nominal ones, those in the fillet, what it bears.

    `throw` counts from 1 at the front; `compression` is 0 in the fillet of a pin.
    """

    throw: int
    place: Place
    bending: float
    compression: float
    torsion: float
    fillet_bending: float
    fillet_torsion: float
    equivalent: float
    strength: float

    @property
    def acceptability(self) -> float:
        """The fatigue strength over the equivalent stress, Q."""
        return self.strength / self.equivalent


@dataclass(frozen=True)
class Fatigue:
    """Both fillets of each throw from the front, and what the stresses rest on.

    `factors` are the stress concentration factors of each throw, by the names of the engine file;
    `speed` (rad/s) is that of the bending.
    """

    fillets: tuple[FilletStress, ...]
    factors: tuple[dict[str, float], ...]
    torsional: Torsional
    speed: float

    @property
    def weakest(self) -> FilletStress:
        """The fillet with the least acceptability factor."""
        return min(self.fillets, key=lambda each: each.acceptability)

    @property
    def accepted(self) -> bool:
        """Whether all fillets reach the acceptability factor asked for."""
        return self.weakest.acceptability >= ACCEPTED


def crank_fatigue(engine: Engine, found: TorsionAnalysis) -> Fatigue:
    """The fatigue of the first crankshaft of an engine with a table [torsion.fatigue].

    Bending at the operating point of the analysis, torsion over its speeds in all orders. Raises
    FatigueError.

    >>> from crankstar.dynamics.torsion_analysis import torsion
    >>> from crankstar.files.catalog import load
    >>> sizes = {"journal_diameter": "58 mm", "journal_length": "24 mm", "pin_diameter": "48 mm",
    ...     "pin_length": "26 mm", "web_width": "78 mm", "web_thickness": "19 mm"}
    >>> steel = {"pin_fillet": "3 mm", "journal_fillet": "3 mm", "tensile_strength": "800 MPa"}
    >>> disc = {"name": "flywheel", "inertia": "0.2 kg*m^2", "to": "rear",
    ...     "stiffness": "1 MN*m/rad"}
    >>> own = {"inertia": "0.02 kg*m^2", "disc": [disc], "dimensions": sizes, "fatigue": steel}
    >>> five = load("audi-25-tfsi", changes={"torsion": own})
    >>> fatigue = crank_fatigue(five, torsion(five))
    >>> len(fatigue.fillets), fatigue.weakest.place, bool(fatigue.weakest.acceptability > 0)
    (10, 'pin', True)
    """
    own = engine.torsion
    if own is None or own.fatigue is None or own.dimensions is None:
        raise FatigueError("fatigue needs fillets and material: give the table [torsion.fatigue]")
    unknown = ", ".join(lacking_keys(engine, 0.0, sizes=KEYS))
    if unknown:
        raise FatigueError(
            "fatigue needs the forces on the crankshaft in N: give {keys}", keys=unknown
        )
    if found.response is None or found.cycle is None or engine.gas is None:
        raise _without_gas()
    crank = engine.shafts[0]
    torsional = alternating_torque(engine, found)
    strengths = _strengths(own.dimensions, own.fatigue)
    fillets: list[FilletStress] = []
    factors: list[dict[str, float]] = []
    order = throws_from_front(crank)
    bent = _bent(engine, crank, order, own.dimensions, radial_forces(engine, found.cycle))
    for index, (number, web) in enumerate(zip(order, bent, strict=True), 1):
        used = concentrations(own.dimensions, own.fatigue, radius=crank.throws[number - 1].radius)
        factors.append(used)
        nominal = _nominal(own.dimensions, web, two_stroke=engine.cycle == "two-stroke")
        extra = own.fatigue.additional_stress
        fillets += _fillets(index, own.dimensions, nominal, torsional, used, strengths, extra)
    return Fatigue(tuple(fillets), tuple(factors), torsional, _speed(found.cycle))


def concentrations(
    dimensions: CrankDimensions, fatigue: CrankFatigue, *, radius: float
) -> dict[str, float]:
    """The stress concentration factors of a throw: as given, else by its dimensions."""
    given = fatigue.factors
    ratios = fillet_ratios(dimensions, fatigue, radius=radius)
    return {
        name: given[name] if name in given else getattr(crank_fillets, name)(ratios)
        for name in FACTORS
    }


def alternating_torque(engine: Engine, found: TorsionAnalysis) -> Torsional:
    """The greatest alternating torque of the crankshaft over all speeds that are not barred."""
    chain = found.chain
    throws = {*chain.throws}
    sections = [
        index
        for index, each in enumerate(chain.sections)
        if each.ratio == 1 and (each.before in throws or each.after in throws)
    ]
    if not sections:
        raise FatigueError("fatigue needs a crankshaft that twists: all masses are rigidly coupled")
    turns = 1 if engine.cycle == "two-stroke" else 2
    theta = np.arange(SAMPLES * turns) * (2 * pi / SAMPLES)

    def ranges(response: Response) -> Real:
        return np.column_stack([np.ptp(response.course(n, theta), axis=1) / 2 for n in sections])

    whole = peaked(found, curves=ranges)
    if whole.response is None:
        raise _without_gas()
    barred = np.zeros(len(whole.speeds), bool)
    for each in found.barred:
        barred |= (whole.speeds > each.low) & (whole.speeds < each.high)
    allowed = np.flatnonzero(~barred) if not barred.all() else np.arange(len(whole.speeds))
    values = ranges(whole.response)[allowed]
    row, column = np.unravel_index(int(np.argmax(values)), values.shape)
    speed = float(whole.speeds[allowed[row]])
    return Torsional(float(values[row, column]), sections[int(column)], speed)


def radial_forces(engine: Engine, cycle: Cycle) -> Real:
    """What each rod pushes its pin outward with, N [cylinder, angle], of gas and inertia.

    Along its throw, at crank angles from 0, SAMPLES a turn, over a cycle.

    A piston at the top dead centre of its power stroke pushes its throw inward:

    >>> from crankstar.files.catalog import load
    >>> from crankstar.mechanics.gas import cycle
    >>> five = load("audi-25-tfsi")
    >>> bool(radial_forces(five, cycle(five))[0].min() < -20e3)
    True
    """
    machine = mechanism(engine)
    speed = _speed(cycle)
    loads = all_pin_loads(engine, machine, speed, cycle).pin
    theta = np.arange(SAMPLES * spectra.period(loads)) * (2 * pi / SAMPLES)
    ratio = np.array([float(engine.shaft(each.shaft).speed_ratio) for each in engine.cylinders])
    turned = np.exp(-1j * (loads.sense * np.multiply.outer(ratio, theta)))
    pins = np.exp(-1j * np.array([engine.throw(each).angle for each in engine.cylinders]))
    return np.real(spectra.value(loads, theta) * turned * pins[:, None]) * speed**2


def _speed(cycle: Cycle) -> float:
    if cycle.speed is None:
        raise _without_gas()
    return cycle.speed


def _without_gas() -> FatigueError:
    return FatigueError("fatigue needs gas and speed: give the table [gas] and speed")


def _bent(
    engine: Engine, crank: Shaft, order: list[int], dimensions: CrankDimensions, forces: Real
) -> list[Bent]:
    """The web of each throw, front first, that bends most."""
    bearings = main_bearings(engine, crank)
    spans = list(pairwise(bearings))
    webs = {number: group for group in pin_groups(engine, crank) for number in group.throws}
    out: list[Bent] = []
    for number in order:
        z = crank.throws[number - 1].z
        span = next((each for each in spans if each[0] > z > each[1]), None)
        inside = [n for n in order if span and span[0] > crank.throws[n - 1].z > span[1]]
        if span is None or len(inside) != 1:
            raise FatigueError(
                "fatigue is reckoned for one crank throw between two main bearings; throw "
                "{number} has not one on each side to itself",
                number=number,
            )
        front, rear = span
        half = (dimensions.journal_length + dimensions.web_thickness) / 2
        ahead, behind = webs[number].webs if crank.webs else (front - half, rear + half)
        rods = [
            row
            for row, each in enumerate(engine.cylinders)
            if (each.shaft, each.throw) == (crank.name, number)
        ]
        places = np.array([engine.cylinders[row].z for row in rods])
        if not (ahead > places.max(initial=rear) and behind < places.min(initial=front)):
            raise FatigueError(
                "the webs of throw {number} do not fit between its rods and the main bearings; "
                "see torsion.dimensions and layout.bore_pitch",
                number=number,
            )
        on_front = ((places - rear) / (front - rear)) @ forces[rods]
        on_rear = ((front - places) / (front - rear)) @ forces[rods]
        each = [
            Bent(float(np.ptp(force)) / 2 * arm, float(np.ptp(force)) / 2)
            for force, arm in ((on_front, front - ahead), (on_rear, behind - rear))
        ]
        out.append(max(each))
    return out


class _Nominal(NamedTuple):
    bending: float
    compression: float


def _nominal(own: CrankDimensions, web: Bent, *, two_stroke: bool) -> _Nominal:
    """The nominal alternating stresses of the web, Pa."""
    held = TWO_STROKE if two_stroke else 1.0
    area = own.web_width * own.web_thickness
    return _Nominal(held * web.moment / (area * own.web_thickness / 6), held * web.force / area)


def _strengths(own: CrankDimensions, fatigue: CrankFatigue) -> tuple[float, float]:
    """What the fillets of pin and journal bear, Pa."""
    pin, journal = (
        crank_fillets.fatigue_strength(
            tensile_strength=fatigue.tensile_strength,
            diameter=diameter,
            fillet=fillet,
            factor=fatigue.strength_factor,
        )
        for diameter, fillet in (
            (own.pin_diameter, fatigue.pin_fillet),
            (own.journal_diameter, fatigue.journal_fillet),
        )
    )
    return pin, journal


def _fillets(
    throw: int,
    own: CrankDimensions,
    nominal: _Nominal,
    torsional: Torsional,
    used: dict[str, float],
    strengths: tuple[float, float],
    extra: float,
) -> list[FilletStress]:
    """The fillets of pin and journal of one throw."""
    pin, journal = (
        torsional.torque / (polar(diameter, bore) / (diameter / 2))
        for diameter, bore in (
            (own.pin_diameter, own.pin_bore),
            (own.journal_diameter, own.journal_bore),
        )
    )
    at_pin = used["pin_bending"] * nominal.bending
    at_journal = (
        used["journal_bending"] * nominal.bending
        + used["journal_compression"] * nominal.compression
    )
    cases: tuple[tuple[Place, float, float, float, float, float], ...] = (
        ("pin", 0.0, pin, at_pin, used["pin_torsion"], strengths[0]),
        (
            "journal",
            nominal.compression,
            journal,
            at_journal,
            used["journal_torsion"],
            strengths[1],
        ),
    )
    return [
        FilletStress(
            throw=throw,
            place=place,
            bending=nominal.bending,
            compression=compression,
            torsion=tau,
            fillet_bending=bending,
            fillet_torsion=factor * tau,
            equivalent=crank_fillets.equivalent_stress(
                bending=bending, torsion=factor * tau, additional=extra
            ),
            strength=strength,
        )
        for place, compression, tau, bending, factor, strength in cases
    ]
