"""An engine, or a batch of engines, as arrays, and what every moving part of it does to the block, order by order.

Each body pushes on the block with minus the rate of change of its momentum, at constant crank speed w:

    force  = -m P''                        N, in the clock plane, P the place of its centre of mass
    couple = (z - z0) * force              N m, in the plane in which it acts, about the plane z = z0
    roll   = Im(conj(P - P0) force) - I b'' N m, clockwise about the axis through P0, b the turn of the body

and asks of the crankshaft the torque that changes its kinetic energy T; what it gives the crankshaft is

    torque = -dT/dtheta                    N m, positive in the direction of rotation

`roll` is minus the rate of change of the angular momentum of all moving bodies: what block and driveline take together.
A block whose driveline stands on its own foundation, or whose flywheel carries the torque, feels `roll - sense * torque`.

A body's harmonics are worked out once in the frame of its own cylinder, then turned, delayed and weighed into the
engine's: so a batch that varies angles and masses costs no new motion.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import reduce
from math import lcm
from typing import NamedTuple

import numpy as np

from crankstar import motion, phasor
from crankstar.engine import Engine
from crankstar.phasor import Complex, Real, Spectrum


class Reference(NamedTuple):
    """The point about which couple (z) and roll (up, right) are taken, m or relative units."""

    z: float
    up: float = 0.0
    right: float = 0.0


class Totals(NamedTuple):
    """Force, couple, roll and torque of a whole engine or of some of its parts."""

    force: Spectrum
    couple: Spectrum
    roll: Spectrum
    torque: Spectrum


@dataclass(frozen=True)
class Mechanism:
    """An engine as arrays, SI units; any array may have leading axes, which are then a batch of engines.

    Per cylinder [..., C]: `links` (the rods), masses, `throw_angle` and `bearing` of the group's root, `z`, and the index
    of the shaft. Per rotor [..., R], the throws first and then the weights: unbalance (kg m), angle, z, index of the shaft.
    Per shaft [S]: signed speed ratio numerators and denominators; [..., S]: place `up + i*right`.
    """

    links: motion.Linkage
    throw_angle: Real
    bearing: Real
    z: Real
    reciprocating_mass: Real
    big_end_mass: Real
    rod_mass: Real
    rod_centre: Real
    rod_inertia: Real
    cylinder_shaft: tuple[int, ...]
    unbalance: Real
    unbalance_angle: Real
    unbalance_z: Real
    rotor_shaft: tuple[int, ...]
    ratios: tuple[tuple[int, int], ...]
    place: Complex
    sense: int


def mechanism(engine: Engine) -> Mechanism:
    """An engine as arrays."""
    cylinders, shafts = engine.cylinders, engine.shafts
    index = {shaft.name: place for place, shaft in enumerate(shafts)}
    links = motion.linkage(engine)
    root = [cylinders[place] for place in motion.roots(links.master)]
    bodies = [(c.rod.mass, c.rod.centre, c.rod.inertia) if c.rod else (0.0, 0.0, 0.0) for c in cylinders]
    rod_mass, rod_centre, rod_inertia = np.array(bodies).T
    throws = [(t.rotating_mass * t.radius, t.angle, t.z, i) for i, s in enumerate(shafts) for t in s.throws]
    weights = [(w.unbalance, w.angle, w.z, i) for i, s in enumerate(shafts) for w in s.weights]
    unbalance, angle, z, rotor_shaft = zip(*throws + weights, strict=True)
    return Mechanism(
        links=links,
        throw_angle=np.array([engine.throw(c).angle for c in cylinders]),
        bearing=np.array([c.bearing for c in root]),
        z=np.array([c.z for c in cylinders]),
        reciprocating_mass=np.array([c.reciprocating_mass for c in cylinders]),
        big_end_mass=np.array([c.big_end_mass for c in cylinders]),
        rod_mass=rod_mass,
        rod_centre=rod_centre,
        rod_inertia=rod_inertia,
        cylinder_shaft=tuple(index[c.shaft] for c in cylinders),
        unbalance=np.array(unbalance),
        unbalance_angle=np.array(angle),
        unbalance_z=np.array(z),
        rotor_shaft=rotor_shaft,
        ratios=tuple((s.speed_ratio.numerator, s.speed_ratio.denominator) for s in shafts),
        place=np.array([complex(s.up, s.right) for s in shafts]),
        sense=engine.sense,
    )


class _Harmonics(NamedTuple):
    """What a unit mass (or unit inertia) at each rod does in its group's frame: [..., cylinder, k - 1], k = 1, 2, ...

    Force `with_angle` exp(i k psi) + `against_angle` exp(-i k psi); roll about the own shaft axis and dT/dpsi as
    `Re(c exp(i k psi))`.
    """

    with_angle: Complex
    against_angle: Complex
    roll: Complex
    energy: Complex


class _Vectors(NamedTuple):
    """What bodies do in the engine's frame, [..., part, order]: force, roll about the own shaft, dT/dtheta."""

    forward: Complex
    backward: Complex
    roll: Complex
    energy: Complex


class _Columns(NamedTuple):
    """The orders of a result, and for each shaft the columns its harmonics 1, 2, ... go to (-1: not wanted)."""

    orders: Real
    of_shaft: tuple[np.ndarray, ...]


def spectra(machine: Mechanism, *, reference: Reference | None = None, orders: Sequence[float] | None = None) -> Totals:
    """Force, couple, roll and torque [..., part, order] at 1 rad/s, of one engine or of a batch of them.

    Parts: piston, rod and big end of every cylinder, then the rotors. `orders` keeps only those crank orders.
    """
    reference = reference or Reference(0.0)
    bodies = _bodies(machine)
    highest = max(_significant(unit) for body in bodies for unit, _ in body)
    columns = _columns(machine, highest, orders)
    pieces = [_sum([_placed(machine, columns, unit, amount) for unit, amount in body]) for body in bodies]
    pieces.append(_rotors(machine, columns))
    forward, backward, roll, energy = (_stacked([piece[i] for piece in pieces], axis=-2) for i in range(4))
    z = _stacked([machine.z] * len(bodies) + [machine.unbalance_z], axis=-1)[..., None] - reference.z
    shaft = [*machine.cylinder_shaft] * len(bodies) + [*machine.rotor_shaft]
    arm = (machine.place - complex(reference.up, reference.right))[..., shaft][..., None]
    force = Spectrum(columns.orders, forward, backward, machine.sense)
    # Im(conj(P) F): the rightward component of F once everything is turned by conj(P)
    lever = phasor.horizontal(phasor.scaled(force, np.conj(arm)))
    lever = np.where(np.abs(lever) > motion.TAIL * np.abs(arm) * (np.abs(forward) + np.abs(backward)), lever, 0.0)
    return Totals(
        force=force,
        couple=phasor.scaled(force, z),
        roll=phasor.real_signal(columns.orders, roll + lever),
        torque=phasor.real_signal(columns.orders, -energy),
    )


def _bodies(machine: Mechanism) -> list[list[tuple[_Harmonics, Real]]]:
    """For pistons, rods and big ends, if there are any: unit harmonics and the masses (or inertias) that go with them."""
    moved = motion.resolved(machine.links)
    bodies = [[(_of_mass(moved.piston), machine.reciprocating_mass)]]
    if np.any(machine.rod_mass):
        share = (machine.rod_centre / machine.links.rod_length)[..., None]
        centre = motion.Path(*(q + share * (p - q) for p, q in zip(moved.piston, moved.big_end, strict=True)))
        bodies.append([(_of_mass(centre), machine.rod_mass), (_of_inertia(moved.direction), machine.rod_inertia)])
    if np.any(machine.big_end_mass):
        bodies.append([(_of_mass(moved.big_end), machine.big_end_mass)])
    return bodies


def _of_mass(path: motion.Path) -> _Harmonics:
    """Force -P'', roll Im(conj(P) force) and dT/dpsi = Re(conj(P') P'') of a unit mass."""
    roll = -np.imag(np.conj(path.place) * path.second)
    energy = np.real(np.conj(path.first) * path.second)
    place, first, second = (_greatest(part) for part in path)
    return _Harmonics(*_vector(-path.second, second), _signal(roll, place * second), _signal(energy, first * second))


def _of_inertia(direction: motion.Path) -> _Harmonics:
    """Roll -b'' and dT/dpsi = b' b'' of a unit moment of inertia that turns with a rod, b its bearing."""
    rate = np.imag(np.conj(direction.place) * direction.first)
    bend = np.imag(np.conj(direction.place) * direction.second)
    first, second = _greatest(direction.first), _greatest(direction.second)
    none = np.zeros_like(direction.place)
    return _Harmonics(*_vector(none, second), _signal(-bend, second), _signal(rate * bend, first * second))


def _greatest(values: Complex) -> Real:
    return np.abs(values).max(axis=-1, keepdims=True)


def _vector(samples: Complex, scale: Real) -> tuple[Complex, Complex]:
    """Coefficients of exp(i k psi) and exp(-i k psi), k = 1, 2, ...; what is rounding beside `scale` is zero."""
    # Up and right apart, so that a force along an axis stays exactly on it.
    up, right = (_signal(part, scale) / 2 for part in (np.real(samples), np.imag(samples)))
    return up + 1j * right, np.conj(up) + 1j * np.conj(right)


def _signal(samples: Real, scale: Real) -> Complex:
    """Amplitudes c of `Re(c exp(i k psi))`, k = 1, 2, ...; what is rounding beside `scale` is zero."""
    count = samples.shape[-1]
    amplitudes = 2 * np.fft.rfft(samples, axis=-1)[..., 1 : count // 2] / count
    return np.where(np.abs(amplitudes) > motion.TAIL * scale, amplitudes, 0.0)


def _significant(unit: _Harmonics) -> int:
    """The highest harmonic that is not rounding."""
    present = np.any([np.any(values.reshape(-1, values.shape[-1]), axis=0) for values in unit], axis=0)
    return int(np.max(np.nonzero(present)[0], initial=0)) + 1


def _columns(machine: Mechanism, highest: int, wanted: Sequence[float] | None) -> _Columns:
    """Orders as whole multiples of 1/D, D the common denominator of the shafts' speeds."""
    common = lcm(*(below for _, below in machine.ratios))
    steps = [abs(above) * (common // below) for above, below in machine.ratios]
    with_pistons = set(machine.cylinder_shaft)
    keys = [np.arange(1, (highest if i in with_pistons else 1) + 1) * step for i, step in enumerate(steps)]
    present = np.unique(np.concatenate(keys))
    if wanted is not None:
        present = np.unique(np.round(np.asarray(wanted, float) * common, 6))
    places = [np.searchsorted(present, key) for key in keys]
    hits = [np.append(present, -1)[place] == key for place, key in zip(places, keys, strict=True)]
    return _Columns(present / common, tuple(np.where(hit, place, -1) for place, hit in zip(places, hits, strict=True)))


def _placed(machine: Mechanism, columns: _Columns, unit: _Harmonics, amount: Real) -> _Vectors:
    """Unit harmonics turned into the engine's frame, given their phase, speed and mass, in the columns of their orders."""
    lag = machine.throw_angle - machine.bearing
    frame = np.exp(1j * machine.bearing) * amount
    shape = (*np.broadcast_shapes(lag.shape, frame.shape, unit.roll.shape[:-1]), columns.orders.size)
    out = _Vectors(*(np.zeros(shape, complex) for _ in range(4)))
    shafts = np.array(machine.cylinder_shaft)
    for index, (above, below) in enumerate(machine.ratios):
        at = np.nonzero(shafts == index)[0]
        if not at.size:
            continue
        column = columns.of_shaft[index]
        k = np.nonzero(column >= 0)[0]
        speed = above / below
        turn = np.exp(1j * lag[..., at, None] * (k + 1))
        scale = speed**2 * frame[..., at, None]
        weight = speed**2 * amount[..., at, None]
        with_angle = scale * turn * unit.with_angle[..., at, :][..., k]
        against = scale * np.conj(turn) * unit.against_angle[..., at, :][..., k]
        roll = weight * turn * unit.roll[..., at, :][..., k]
        energy = machine.sense * speed * weight * turn * unit.energy[..., at, :][..., k]
        if speed < 0:
            with_angle, against = against, with_angle
        if machine.sense * speed < 0:
            roll, energy = np.conj(roll), np.conj(energy)
        for target, values in zip(out, (with_angle, against, roll, energy), strict=True):
            target[..., at[:, None], column[k]] = values
    return out


def _rotors(machine: Mechanism, columns: _Columns) -> _Vectors:
    """Throws and weights: a vector that turns with its shaft, once a turn of it, and no more."""
    vector = machine.unbalance * np.exp(1j * machine.unbalance_angle)
    forward = np.zeros((*vector.shape, columns.orders.size), complex)
    backward, none = forward.copy(), np.zeros((vector.shape[-1], columns.orders.size), complex)
    for row, shaft in enumerate(machine.rotor_shaft):
        above, below = machine.ratios[shaft]
        column = columns.of_shaft[shaft][0]
        if column >= 0:
            target = forward if above > 0 else backward
            target[..., row, column] = vector[..., row] * (above / below) ** 2
    return _Vectors(forward, backward, none, none)


def _sum(pieces: Sequence[_Vectors]) -> _Vectors:
    return _Vectors(*(reduce(np.add, values) for values in zip(*pieces, strict=True)))


def _stacked(arrays: list, *, axis: int) -> np.ndarray:
    """Arrays one after the other along a trailing axis, their leading axes broadcast to each other."""
    trailing = -axis
    lead = np.broadcast_shapes(*(np.shape(array)[:-trailing] for array in arrays))
    return np.concatenate([np.broadcast_to(array, lead + np.shape(array)[-trailing:]) for array in arrays], axis=axis)


def block_roll(sums: Totals) -> Spectrum:
    """What the block alone feels when a flywheel, or a driveline on its own foundation, takes the torque: roll - sense * torque.

    With one crankshaft and about its axis it is the moment of the pistons' side thrust; clockwise, N m.
    """
    sense = sums.force.sense
    torque = phasor.scaled(sums.torque, -sense)
    return replace(sums.roll, forward=sums.roll.forward + torque.forward, backward=sums.roll.backward + torque.backward)


def total(parts: Totals) -> Totals:
    """The sum of the parts, with what is only rounding error set to zero."""
    return Totals(*(phasor.total(spectrum) for spectrum in parts))


def totals(machine: Mechanism, *, orders: Sequence[float], reference: Reference | None = None, block: int = 2048) -> Totals:
    """The whole-engine sums [variant, order] at 1 rad/s of a batch with one leading axis, worked out in blocks of variants.

    Memory stays that of one block, whatever the length of the batch.
    """
    arrays = {name: values for name, values in vars(machine).items() if isinstance(values, np.ndarray)}
    links = {name: values for name, values in vars(machine.links).items() if isinstance(values, np.ndarray)}
    length = max((len(values) for values in (*arrays.values(), *links.values()) if values.ndim > 1), default=0)
    if length == 0:
        return total(spectra(machine, reference=reference, orders=orders))
    pieces: list[Totals] = []
    for start in range(0, length, block):

        def part(values: np.ndarray, start: int = start) -> np.ndarray:
            return values[start : start + block] if values.ndim > 1 and len(values) > 1 else values

        own = replace(machine.links, **{name: part(values) for name, values in links.items()})
        one = replace(machine, links=own, **{name: part(values) for name, values in arrays.items()})
        sums = total(spectra(one, reference=reference, orders=orders))
        pieces.append(Totals(*(_spread(spectrum, min(block, length - start)) for spectrum in sums)))
    return Totals(*(_joined([getattr(piece, name) for piece in pieces]) for name in Totals._fields))


def _spread(spectrum: Spectrum, count: int) -> Spectrum:
    """The sums of a block with their leading axis, also where nothing that was varied reaches them."""
    shape = (count, spectrum.orders.size)
    forward, backward = (np.broadcast_to(values, shape) for values in (spectrum.forward, spectrum.backward))
    return replace(spectrum, forward=forward, backward=backward)


def _joined(pieces: list[Spectrum]) -> Spectrum:
    forward, backward = (np.concatenate([getattr(piece, name) for piece in pieces]) for name in ("forward", "backward"))
    return replace(pieces[0], forward=forward, backward=backward)
