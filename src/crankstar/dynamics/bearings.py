"""Loads on main bearings and crank pins, guide forces, and the bending moment along a crankshaft.

On a shaft act the pin loads S of its cylinders, from inertia (`mechanics.pin_loads`) and where a
cycle is given from gas (`mechanics.gas_pins`), and the centrifugal forces of its throws and
weights. The main bearings carry them: with the shares of
`beams`, force by force,

    L_b = sum over forces f of share[b, f] F_f           N, what the journal pushes on its bearing,

so that all bearing loads and guide forces, with gas also the forces on the heads, add up to force
and couple on the block. Forces at the
teeth of gears and the weight of the parts are left out.

The bending moment at z is the moment of all that acts on the shaft in front of it,

    M(z) = sum over z_f > z of (z_f - z) F_f  -  sum over z_b > z of (z_b - z) L_b,

a vector in the clock plane, in the plane in which it bends, as couples are. In its two end bearings
alone (`model=None`) it is the *internal* moment: what the crankshaft bears, or hands to its inner
bearings, even where force and couple on the block cancel. Where those of the shaft cancel too, the
end bearings carry nothing, and it is the moment of the free shaft. Its length is the same in the
frame that turns with the crankshaft.

The law is statics; the shares are those of `beams`.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import Literal, NamedTuple, get_args

import numpy as np

from crankstar import spectra
from crankstar.dynamics.beams import continuous_shares, cut_shares
from crankstar.engine import motion
from crankstar.engine.engine import Engine
from crankstar.engine.main_bearings import main_bearings
from crankstar.engine.records import Shaft
from crankstar.language.messages import MessageError, _
from crankstar.language.quoting import given, seen
from crankstar.mechanics.balance import scales
from crankstar.mechanics.excitation import columns_of, rotors
from crankstar.mechanics.gas import Cycle
from crankstar.mechanics.gas_pins import gas_pin_loads, with_gas
from crankstar.mechanics.lacking import lacking_keys
from crankstar.mechanics.mechanism import Mechanism, mechanism
from crankstar.mechanics.pin_loads import PinLoads, pin_loads
from crankstar.spectra import Complex, Real, Spectrum

Model = Literal["determinate", "continuous"]
"""The crankshaft hinged at each main bearing, or one uniform beam on all of them."""
STEPS = 8
"""Places between two forces or bearings at which a bending moment is given."""


class BearingError(MessageError):
    """Loads that cannot be computed, and why."""


class Bearing(NamedTuple):
    """A main bearing: its shaft, its number from the front, its place; whether that is assumed."""

    shaft: str
    number: int
    z: float
    assumed: bool


class CrankPin(NamedTuple):
    """A crank pin: its shaft, the number of its throw, its place, the cylinders that work on it."""

    shaft: str
    throw: int
    z: float
    cylinders: tuple[int, ...]


class BigEnd(NamedTuple):
    """The bearing of a rod on its crank pin: its shaft, the number of the throw, its cylinder."""

    shaft: str
    throw: int
    cylinder: int


@dataclass(frozen=True)
class BearingLoads:
    """Spectra [part, order] in `unit`, order 0 (steady) first, each of the parts beside it.

    `load` of `bearings`; `pin` of `pins`: what its rods put on each crank pin, with the rotating
    mass of its throw, which hangs on it; `big_end` of `big_ends`: what one rod puts on its pin,
    with its slave rods and an equal part of that mass; `guide` of each of `cylinders`: what its
    piston puts on the wall.

    >>> from crankstar.files.catalog import load
    >>> loads = bearing_loads(load("v2-90"))
    >>> [pin.cylinders for pin in loads.pins], len(loads.bearings), loads.unit
    ([(1, 2)], 2, 'm*r*w^2')
    >>> together = spectra.vertical(loads.big_end).sum(axis=0)
    >>> bool(np.allclose(together, spectra.vertical(loads.pin)[0]))
    True
    """

    bearings: tuple[Bearing, ...]
    load: Spectrum
    pins: tuple[CrankPin, ...]
    pin: Spectrum
    big_ends: tuple[BigEnd, ...]
    big_end: Spectrum
    cylinders: tuple[int, ...]
    guide: Spectrum
    model: Model
    unit: str
    speed: float | None


@dataclass(frozen=True)
class Bending:
    """The bending moment of a shaft: spectrum [place, order] in `unit`, front `z` first.

    >>> from crankstar.files.catalog import load
    >>> bending = bending_moment(load("v2-90"), model="determinate")
    >>> float(spectra.peaks(bending.moment)[0]), bending.unit
    (0.0, 'm*r*w^2*a')
    """

    shaft: str
    z: tuple[float, ...]
    moment: Spectrum
    unit: str
    speed: float | None


def bearing_loads(
    engine: Engine,
    *,
    speed: float | None = None,
    model: Model = "determinate",
    cycle: Cycle | None = None,
) -> BearingLoads:
    """Loads on all main bearings, crank pins and cylinder walls by crank order.

    In N at `speed` (rad/s), without one in m r w^2. A `continuous` shaft rests on rigid bearings,
    or on those of the stiffness that the engine file gives with the shaft's bending stiffness.
    With a `cycle` those of its gas as well, at its speed unless another is given; raises
    BearingError where speed or masses are not known.

    >>> from crankstar.files.catalog import load
    >>> loads = bearing_loads(load("i4"))
    >>> first = spectra.selected(loads.load, 1)

    The first-order forces of an in-line four cancel on the block; the middle bearing, between two
    throws that point the same way, carries half of each piston's, 1 in all:

    >>> abs(spectra.vertical(first)[:, 0]).round(3).tolist()
    [0.5, 0.0, 1.0, 0.0, 0.5]
    """
    machine = mechanism(engine)
    speed = cycle.speed if speed is None and cycle is not None else speed
    loads = all_pin_loads(engine, machine, speed, cycle)
    scale, units = scales(engine, speed)
    bearings: list[Bearing] = []
    pins: list[CrankPin] = []
    big_ends: list[BigEnd] = []
    parts: list[Spectrum] = []
    on_pins: list[Spectrum] = []
    of_rods: list[Spectrum] = []
    hanging = _turning(_with_hanging_masses(machine, engine), loads)
    for index, shaft in enumerate(engine.shafts):
        places, forces = shaft_forces(machine, loads, index)
        own = main_bearings(engine, shaft)
        if own:
            parts.append(_shared(bearing_shares(engine, shaft, places, model=model), forces))
        bearings += [Bearing(shaft.name, n, z, not shaft.bearings) for n, z in enumerate(own, 1)]
        for number, throw in enumerate(shaft.throws, 1):
            rods = [
                row
                for row, c in enumerate(engine.cylinders)
                if (c.shaft, c.throw) == (shaft.name, number)
            ]
            cylinders = tuple(engine.cylinders[row].number for row in rods)
            pins.append(CrankPin(shaft.name, number, throw.z, cylinders))
            own = _stacked([loads.pin[rods], hanging[[len(on_pins)]]])
            on_pins.append(_shared(np.ones((1, len(rods) + 1)), own))
            held = [row for row in rods if engine.cylinders[row].articulated is None]
            big_ends += [BigEnd(shaft.name, number, engine.cylinders[row].number) for row in held]
            of_rods.append(_shared(_of_big_ends(machine.links.master, rods, held), own))
    return BearingLoads(
        tuple(bearings),
        spectra.scaled(_stacked(parts), scale.force),
        tuple(pins),
        spectra.scaled(_stacked(on_pins), scale.force),
        tuple(big_ends),
        spectra.scaled(_stacked(of_rods), scale.force),
        tuple(cylinder.number for cylinder in engine.cylinders),
        spectra.scaled(loads.guide, scale.force),
        model,
        units.force,
        speed if units.force == "N" else None,
    )


def bending_moment(
    engine: Engine,
    *,
    shaft: str | None = None,
    speed: float | None = None,
    model: Model | None = None,
    cycle: Cycle | None = None,
) -> Bending:
    """The bending moment along a crankshaft, by default the first.

    `model=None`: in its two end bearings alone, so that no inner bearing helps. In N m at `speed`
    (rad/s), without one in m r w^2 a. With the gas of a `cycle` as in `bearing_loads`.

    >>> from crankstar.files.catalog import load
    >>> bending = bending_moment(load("i4"))
    >>> first = abs(spectra.vertical(spectra.selected(bending.moment, 1))[:, 0])
    >>> [round(float(first[bending.z.index(z)]), 9) for z in (1.5, 1.0, 0.5, 0.0)]
    [0.0, 0.5, 1.0, 1.0]
    """
    machine = mechanism(engine)
    names = [each.name for each in engine.shafts]
    name = names[0] if shaft is None else shaft
    if name not in names:
        raise ValueError(
            _(
                "there is no shaft {name}; the shafts are {names}",
                name=given(name),
                names=", ".join(map(seen, names)),
            )
        )
    index = names.index(name)
    own = engine.shafts[index]
    speed = cycle.speed if speed is None and cycle is not None else speed
    places, forces = shaft_forces(machine, all_pin_loads(engine, machine, speed, cycle), index)
    bearings = main_bearings(engine, own)
    z = _along([*places, *bearings])
    if model is None:
        bearings = (bearings[0], bearings[-1])
        shares = cut_shares(bearings, places)
    else:
        shares = bearing_shares(engine, own, places, model=model)
    ahead, held = (np.maximum(np.asarray(each) - z[:, None], 0.0) for each in (places, bearings))
    levers = ahead - held @ shares
    scale, units = scales(engine, speed)
    moment = spectra.scaled(_shared(levers, forces), scale.couple)
    known = speed if units.force == "N" else None
    return Bending(name, tuple(z.tolist()), moment, units.couple, known)


def _of_big_ends(masters: tuple[int, ...], rods: Sequence[int], held: Sequence[int]) -> Real:
    """Shares [rod on its pin, force]: its own load, those of its slave rods, what hangs on the pin.

    What hangs on a pin is the last force, after those of all its `rods`; its rods share it equally.
    """
    carried = [motion.chain(masters, row) for row in rods]
    own = np.array([[row in chain for chain in carried] for row in held], float)
    own = own.reshape(len(held), len(rods))
    return np.hstack([own, np.full((len(held), 1), 1 / max(len(held), 1))])


def all_pin_loads(
    engine: Engine, machine: Mechanism, speed: float | None, cycle: Cycle | None
) -> PinLoads:
    """The pin loads of inertia, and of gas where there is a cycle, at 1 rad/s; right at `speed`."""
    inertia = pin_loads(machine)
    if cycle is None:
        return inertia
    lacking = lacking_keys(engine, speed)
    if speed is None or lacking:
        raise BearingError(
            "bearing loads with gas need more than the file has: give {keys}",
            keys=", ".join(lacking),
        )
    return with_gas(inertia, gas_pin_loads(engine, cycle), speed=speed)


def bearing_shares(
    engine: Engine, shaft: Shaft, places: Sequence[float], *, model: Model = "determinate"
) -> Real:
    """Shares [bearing, force] of forces at `places` on the main bearings of a shaft."""
    if model not in get_args(Model):
        raise ValueError(
            _(
                "{model} is no model of a crankshaft; give one of {models}",
                model=given(model),
                models=", ".join(get_args(Model)),
            )
        )
    bearings = main_bearings(engine, shaft)
    if model == "determinate":
        return cut_shares(bearings, places)
    compliance = 0.0
    if shaft.bending_stiffness and shaft.bearing_stiffness:
        length = bearings[0] - bearings[-1]
        compliance = shaft.bending_stiffness / (shaft.bearing_stiffness * length**3)
    return continuous_shares(bearings, places, compliance=compliance)


def shaft_forces(machine: Mechanism, loads: PinLoads, index: int) -> tuple[list[float], Spectrum]:
    """Places and forces of the rods, throws and weights of a shaft, at 1 rad/s.

    Those of the rods are what the pins carry, the side thrust of the pistons with it.
    """
    rows = [row for row, on in enumerate(machine.cylinder_shaft) if on == index]
    turning = [row for row, on in enumerate(machine.rotor_shaft) if on == index]
    places = [*np.asarray(machine.z)[rows], *np.asarray(machine.unbalance_z)[turning]]
    forces = _stacked([loads.pin[rows], _turning(machine, loads)[turning]])
    return [float(z) for z in places], forces


def _turning(machine: Mechanism, loads: PinLoads) -> Spectrum:
    """The forces of throws and weights [rotor, order], by the orders of the pin loads."""
    vectors = rotors(machine, columns_of(machine, 1, loads.pin.orders[1:].tolist()))
    still = np.zeros((len(machine.rotor_shaft), 1))
    return replace(
        loads.pin,
        forward=np.concatenate([still, vectors.forward], axis=-1),
        backward=np.concatenate([still, vectors.backward], axis=-1),
    )


def _with_hanging_masses(machine: Mechanism, engine: Engine) -> Mechanism:
    """The machine with what hangs on its crank pins alone: rotating masses, not the throws' own."""
    hanging = [throw.rotating_mass * throw.radius for s in engine.shafts for throw in s.throws]
    weights = [0.0] * (len(machine.rotor_shaft) - len(hanging))
    return replace(machine, unbalance=np.array([*hanging, *weights]))


def _shared(shares: Real, forces: Spectrum) -> Spectrum:
    """Sums of forces, each times its share, what is only rounding set to zero."""

    def added(values: Complex) -> Complex:
        noise = spectra.ROUNDING * (np.abs(shares) @ size)
        out: Complex = shares @ values
        real, imaginary = (
            np.where(np.abs(x) <= noise, 0.0, x) for x in (np.real(out), np.imag(out))
        )
        return real + 1j * imaginary

    size = np.abs(forces.forward) + np.abs(forces.backward)
    return replace(forces, forward=added(forces.forward), backward=added(forces.backward))


def _stacked(parts: Sequence[Spectrum]) -> Spectrum:
    """Spectra of the same orders, their parts one after the other."""
    return replace(
        parts[0],
        forward=np.concatenate([part.forward for part in parts]),
        backward=np.concatenate([part.backward for part in parts]),
    )


def _along(places: Sequence[float]) -> Real:
    """The places, front first, and steps between them."""
    kinks = sorted({round(z, 12) for z in places}, reverse=True)
    steps = [np.linspace(a, b, STEPS, endpoint=False) for a, b in pairwise(kinks)]
    return np.concatenate([*steps, kinks[-1:]])
