"""The moving parts of an engine at unit mass, so that masses, angles and places vary at no cost.

What a part of mass m at the crank angle tau behind its own does is m times that of a unit of it,
later by tau: with s the sense of the crankshaft and order k' of its own shaft,

    forward  m U_f exp(+i k' tau),    backward  m U_b exp(-i k' tau),

and its couple is its force at its z. Exact for any mass, throw angle, weight and place along the
crankshaft, of many engines at once; the shape of the motion stays that of the engine.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np

from crankstar.analyses.tolerance.error_sources import ErrorSource
from crankstar.analyses.tolerance.linear_law import Vectors
from crankstar.mechanics.balance import Scale
from crankstar.mechanics.excitation import Reference, part_spectra
from crankstar.mechanics.mechanism import Mechanism
from crankstar.spectra import Complex, Real

MASSES = ("reciprocating_mass", "rod_mass", "rod_inertia", "big_end_mass")
"""Bodies of each cylinder: piston, rod as a mass and as an inertia, big end."""
EXACT = frozenset({*MASSES, "unbalance", "unbalance_angle", "unbalance_z", "throw_angle", "z"})
"""Arrays that may change by any amount."""


class Units(NamedTuple):
    """A unit of each part [part, order]: force as turning vectors, rolling moment, torque.

    `amounts`, `z` [part] are those of the engine, `steps` [part, order] the order of its own shaft,
    negative where it turns against the reference shaft.
    """

    forward: Complex
    backward: Complex
    roll: Complex
    torque: Complex
    amounts: Real
    z: Real
    steps: Real


@dataclass(frozen=True)
class Parts:
    """Unit parts, and how their amounts, angles and places go with each error [error, part]."""

    units: Units
    amounts: Real
    angles: Real
    places: Real
    scale: Scale
    sense: int

    def sums(self, sizes: Real) -> dict[str, Vectors]:
        """Force, couple, rolling moment and torque [engine, order] with errors [engine, error]."""
        own = self.units
        moved = np.any(self.amounts, 0) | np.any(self.angles, 0) | np.any(self.places, 0)
        turned = np.any(self.angles[:, moved], 0)
        amounts = own.amounts[moved] + sizes @ self.amounts[:, moved]
        angles = sizes @ self.angles[:, moved][:, turned]
        places = own.z[moved] + sizes @ self.places[:, moved]
        still = own.amounts * ~moved
        orders = own.forward.shape[1]
        # forward, backward, roll, torque, couple forward and backward, each [engine, order]
        out = np.empty((6, len(sizes), orders), complex)
        for k in range(orders):
            unit = _unit(own, k, self.sense)
            rest = still @ unit
            weight = amounts.astype(complex)
            weight[:, turned] *= np.exp(1j * angles * own.steps[moved, k][turned])
            found = weight @ unit[moved] + rest
            couple = (weight * places) @ unit[moved, :2] + (still * own.z) @ unit[:, :2]
            out[:, :, k] = np.concatenate([found, couple], axis=1).T
        force, back, roll, torque, couple, couple_back = out
        if self.sense < 0:
            roll, torque = np.conj(roll), np.conj(torque)
        return {
            "force": _vectors(force, back, self.scale.force),
            "couple": _vectors(couple, couple_back, self.scale.couple),
            "roll": _vectors(roll / 2, roll / 2, self.scale.moment),
            "torque": _vectors(torque / 2, torque / 2, self.scale.moment),
        }


def _unit(own: Units, k: int, sense: int) -> Complex:
    """What goes with exp(+i k' tau) of a part [part, 4]: backward vectors and others conjugated."""
    columns = [own.forward[:, k], np.conj(own.backward[:, k]), own.roll[:, k], own.torque[:, k]]
    if sense < 0:
        columns[2:] = [np.conj(column) for column in columns[2:]]
    return np.stack(columns, axis=1)


def _vectors(forward: Complex, conjugate: Complex, factor: float) -> Vectors:
    return Vectors(forward * factor, np.conj(conjugate) * factor)


def parts_of(
    machine: Mechanism,
    errors: Sequence[ErrorSource],
    *,
    orders: Sequence[float],
    reference: Reference,
    scale: Scale,
) -> Parts:
    """The unit parts of an engine, and what errors of EXACT arrays do to them."""
    units = _units(machine, orders, reference)
    cylinders, rotors = machine.reciprocating_mass.size, machine.unbalance.size
    bodies = len(MASSES) * cylinders
    shape = (len(errors), bodies + rotors)
    amounts, angles, places = np.zeros(shape), np.zeros(shape), np.zeros(shape)
    for row, error in enumerate(errors):
        for name, change in error.moves.items():
            if name in MASSES:
                start = MASSES.index(name) * cylinders
                amounts[row, start : start + cylinders] = change
            elif name == "throw_angle":
                angles[row, :bodies] = np.tile(change, len(MASSES))
            elif name == "z":
                places[row, :bodies] = np.tile(change, len(MASSES))
            else:
                own = {"unbalance": amounts, "unbalance_angle": angles, "unbalance_z": places}
                own[name][row, bodies:] = change
    return Parts(units, amounts, angles, places, scale, machine.sense)


def _units(machine: Mechanism, orders: Sequence[float], reference: Reference) -> Units:
    one = np.ones_like(machine.reciprocating_mass)
    ones = {"reciprocating_mass": one, "rod_mass": one, "big_end_mass": one}
    plain = replace(machine, **ones, rod_inertia=0 * one, unbalance=np.ones_like(machine.unbalance))
    turning = replace(plain, rod_inertia=one)
    first, second = (
        part_spectra(each, reference=reference, orders=orders) for each in (plain, turning)
    )
    cylinders = one.size
    rods = slice(cylinders, 2 * cylinders)

    def unit(values: Complex, others: Complex) -> Complex:
        inertia = others[rods] - values[rods]
        return np.concatenate([values[: rods.stop], inertia, values[rods.stop :]])

    def signal(name: str) -> Complex:
        each = [getattr(raw, name) for raw in (first, second)]
        return unit(*(own.forward + np.conj(own.backward) for own in each))

    torque = signal("torque")
    bodies = len(MASSES)
    shafts = np.array([*machine.cylinder_shaft] * bodies + [*machine.rotor_shaft])
    speeds = np.array([above / below for above, below in machine.ratios])[shafts]
    return Units(
        forward=unit(first.force.forward, second.force.forward),
        backward=unit(first.force.backward, second.force.backward),
        roll=signal("axis_moment") - machine.sense * torque,
        torque=torque,
        amounts=np.concatenate([*(getattr(machine, name) for name in MASSES), machine.unbalance]),
        z=np.concatenate([np.tile(machine.z, bodies), machine.unbalance_z]) - reference.z,
        steps=np.asarray(orders)[None, :] / speeds[:, None],
    )
