"""Force, couple, moment and torque of every moving part, order by order.

Each body pushes on the block with minus the rate of change of its momentum, at constant crank speed
w:

    force  = -m P''                        N, in the clock plane, P the place of its centre of mass
    couple = (z - z0) * force              N m, in the plane in which it acts, about z = z0
    axis_moment = Im(conj(P - P0) force) - I w^2 b''   N m, clockwise about the axis through P0,
                                                       b the turn of the body

and asks of the crankshaft the torque that changes its kinetic energy T; what it gives the
crankshaft is

    torque = -dT/dtheta                    N m, positive in the direction of rotation

`axis_moment` is minus the rate of change of the angular momentum of all moving bodies; block and
driveline take it together. A block whose driveline stands on its own foundation, or whose flywheel
carries the torque, feels
the rolling moment `axis_moment - sense * torque`.

The harmonics of a unit body are worked out once in the frame of its own cylinder (`harmonics`),
then turned, delayed and weighed: so a batch that varies angles and masses costs no new motion.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import reduce
from math import lcm
from typing import NamedTuple

import numpy as np

from crankstar import spectra
from crankstar.engine import motion
from crankstar.language.messages import MessageError
from crankstar.mechanics.harmonics import Harmonics, bodies, highest
from crankstar.mechanics.mechanism import Mechanism
from crankstar.spectra import Complex, Real, Spectrum


class Reference(NamedTuple):
    """The point about which couple (z) and roll (up, right) are taken, m or relative units.

    >>> Reference(0.05)
    Reference(z=0.05, up=0.0, right=0.0)
    """

    z: float
    up: float = 0.0
    right: float = 0.0


class Totals(NamedTuple):
    """Force, couple, moment about the axis and torque of a whole engine or of some of its parts.

    >>> Totals._fields
    ('force', 'couple', 'axis_moment', 'torque')
    """

    force: Spectrum
    couple: Spectrum
    axis_moment: Spectrum
    torque: Spectrum


class Vectors(NamedTuple):
    """Force, moment about the own shaft and dT/dtheta in the engine's frame, [..., part, order]."""

    forward: Complex
    backward: Complex
    moment: Complex
    energy: Complex


class Columns(NamedTuple):
    """The orders of a result; for each shaft the columns of its harmonics (-1: left out)."""

    orders: Real
    of_shaft: tuple[np.ndarray, ...]


def part_spectra(
    machine: Mechanism, *, reference: Reference | None = None, orders: Sequence[float] | None = None
) -> Totals:
    """Force, couple, axis moment and torque [..., part, order] at 1 rad/s; or of a batch.

    Parts: piston, rod and big end of every cylinder, then the rotors. `orders` keeps only those
    crank orders. Raises ValueError for what is none.
    """
    reference = reference or Reference(0.0)
    if not all(map(np.isfinite, reference)):
        raise MessageError(
            "the reference is {reference}; give z, up and right in metres, each finite",
            reference=", ".join(f"{place:g}" for place in reference),
        )
    moving = bodies(machine)
    harmonics = max(highest(unit) for body in moving for unit, _ in body)
    columns = columns_of(machine, harmonics, orders)
    pieces = [
        _sum([placed(machine, columns, unit, amount) for unit, amount in body]) for body in moving
    ]
    pieces.append(rotors(machine, columns))
    forward, backward, moment, energy = (
        _stacked([piece[i] for piece in pieces], axis=-2) for i in range(4)
    )
    z = (
        _stacked([machine.z] * len(moving) + [machine.unbalance_z], axis=-1)[..., None]
        - reference.z
    )
    shaft = [*machine.cylinder_shaft] * len(moving) + [*machine.rotor_shaft]
    arm = (machine.place - complex(reference.up, reference.right))[..., shaft][..., None]
    force = Spectrum(columns.orders, forward, backward, machine.sense, complete=orders is None)
    # Im(conj(P) F): the rightward component of F once everything is turned by conj(P)
    lever = spectra.horizontal(spectra.scaled(force, np.conj(arm)))
    lever = np.where(
        np.abs(lever) > motion.TAIL * np.abs(arm) * (np.abs(forward) + np.abs(backward)), lever, 0.0
    )
    roll, torque = (
        replace(spectra.real_signal(columns.orders, signal), complete=force.complete)
        for signal in (moment + lever, -energy)
    )
    return Totals(force, spectra.scaled(force, z), axis_moment=roll, torque=torque)


def columns_of(machine: Mechanism, harmonics: int, wanted: Sequence[float] | None) -> Columns:
    """Orders as whole multiples of 1/D, D the common denominator of the shafts' speeds."""
    common = lcm(*(below for _, below in machine.ratios))
    steps = [abs(above) * (common // below) for above, below in machine.ratios]
    with_pistons = set(machine.cylinder_shaft)
    keys = [
        np.arange(1, (harmonics if i in with_pistons else 1) + 1) * step
        for i, step in enumerate(steps)
    ]
    present = spectra.distinct(np.concatenate(keys))
    if wanted is not None:
        asked = spectra.checked(np.asarray(wanted, float))
        present = spectra.distinct(np.round(asked * common, 6))
    places = [np.searchsorted(present, key) for key in keys]
    hits = [np.append(present, -1)[place] == key for place, key in zip(places, keys, strict=True)]
    return Columns(
        present / common,
        tuple(np.where(hit, place, -1) for place, hit in zip(places, hits, strict=True)),
    )


def placed(machine: Mechanism, columns: Columns, unit: Harmonics, amount: Real) -> Vectors:
    """Unit harmonics in the engine's frame with their phase, speed and mass, by order."""
    lag = machine.throw_angle - machine.bearing
    frame = np.exp(1j * machine.bearing) * amount
    shape = (
        *np.broadcast_shapes(lag.shape, frame.shape, unit.moment.shape[:-1]),
        columns.orders.size,
    )
    out = Vectors(*(np.zeros(shape, complex) for _ in range(4)))
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
        moment = weight * turn * unit.moment[..., at, :][..., k]
        energy = machine.sense * speed * weight * turn * unit.energy[..., at, :][..., k]
        if speed < 0:
            with_angle, against = against, with_angle
        if machine.sense * speed < 0:
            moment, energy = np.conj(moment), np.conj(energy)
        for target, values in zip(out, (with_angle, against, moment, energy), strict=True):
            target[..., at[:, None], column[k]] = values
    return out


def rotors(machine: Mechanism, columns: Columns) -> Vectors:
    """Throws and weights: one vector each, turning with its shaft."""
    vector = machine.unbalance * np.exp(1j * machine.unbalance_angle)
    forward = np.zeros((*vector.shape, columns.orders.size), complex)
    backward, none = forward.copy(), np.zeros((vector.shape[-1], columns.orders.size), complex)
    for row, shaft in enumerate(machine.rotor_shaft):
        above, below = machine.ratios[shaft]
        column = columns.of_shaft[shaft][0]
        if column >= 0:
            target = forward if above > 0 else backward
            target[..., row, column] = vector[..., row] * (above / below) ** 2
    return Vectors(forward, backward, none, none)


def _sum(pieces: Sequence[Vectors]) -> Vectors:
    """The sum of the pieces of a body, its moment without rounding errors.

    That of the mass of a rod and that of its inertia cancel where it is two masses at its ends;
    harmonics are known to TAIL of their greatest.
    """
    whole = Vectors(*(reduce(np.add, values) for values in zip(*pieces, strict=True)))
    if len(pieces) == 1:
        return whole
    pushed = reduce(np.add, [np.abs(piece.moment) for piece in pieces])
    least = len(pieces) * motion.TAIL * pushed.max(axis=-1, keepdims=True, initial=0.0)
    noise = np.maximum(spectra.ROUNDING * pushed, least)
    return whole._replace(moment=np.where(np.abs(whole.moment) > noise, whole.moment, 0.0))


def _stacked(arrays: list, *, axis: int) -> np.ndarray:
    """Arrays one after the other along a trailing axis, their leading axes broadcast."""
    trailing = -axis
    lead = np.broadcast_shapes(*(np.shape(array)[:-trailing] for array in arrays))
    return np.concatenate(
        [np.broadcast_to(array, lead + np.shape(array)[-trailing:]) for array in arrays], axis=axis
    )


def rolling_moment(sums: Totals) -> Spectrum:
    """The rolling moment on the block, clockwise, N m: axis_moment - sense * torque.

    A flywheel, or a driveline on its own foundation, takes the torque. With one crankshaft and
    about its axis, this is the moment of the pistons' side thrust.
    """
    sense = sums.force.sense
    torque = spectra.scaled(sums.torque, -sense)
    return replace(
        sums.axis_moment,
        forward=sums.axis_moment.forward + torque.forward,
        backward=sums.axis_moment.backward + torque.backward,
    )


def total(parts: Totals) -> Totals:
    """The sum of the parts, with what is only rounding error set to zero."""
    return Totals(*(spectra.total(spectrum) for spectrum in parts))
