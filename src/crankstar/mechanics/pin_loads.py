"""Guide forces: what each piston pushes sideways on its cylinder, and what is left for the crank.

Free of gas pressure, rod and piston of a cylinder are in equilibrium (d'Alembert) under their
inertia forces F_p (piston), F_r (rod), F_b (big end) and -I w^2 b'', the forces S_s that slave rods
put on knuckle pins at K_s, the wall and the crank pin. Moments about the big-end pin Q give the
guide force G, which the piston exerts on the cylinder wall square to the axis a at the piston pin
P:

    Re(conj(P - Q) a) g = Im(conj(P - Q) F_p + conj(C - Q) F_r + sum conj(K_s - Q) S_s) - I w^2 b''
    G = i a g
    S = F_p + F_r + F_b + sum S_s - G

and S is what the rod exerts on its crank pin or knuckle pin. So the block feels the pistons in two
places: G at the cylinder wall, S through the main bearings. The moment of the G about the crank
axis is the rolling moment.

Source: J. E. Shigley, J. J. Uicker, Theory of Machines and Mechanisms, dynamics of the slider-crank
(equilibrium of rod and piston); slave rods by the same equations, from the outermost rod inward.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from crankstar.engine import motion
from crankstar.mechanics.excitation import columns_of, placed
from crankstar.mechanics.harmonics import Harmonics, bodies, highest, vector
from crankstar.mechanics.mechanism import Mechanism
from crankstar.spectra import Complex, Real, Spectrum


class PinLoads(NamedTuple):
    """Spectra [..., cylinder, order]: the guide force of each piston, and what reaches the crank.

    `pin` is what piston and rod of a cylinder put on the crankshaft; of a slave rod, what it adds
    to the pin of its master. Guide force and pin load of a cylinder add up to its inertia force,
    which has no steady part; theirs, order 0, are opposite (cylinders with offset, slave rods).
    """

    guide: Spectrum
    pin: Spectrum


def pin_loads(machine: Mechanism, *, orders: Sequence[float] | None = None) -> PinLoads:
    """Guide forces and pin loads at 1 rad/s, N; or of a batch. `orders` keeps only those.

    >>> from crankstar import load, spectra
    >>> from crankstar.mechanics.mechanism import mechanism
    >>> loads = pin_loads(mechanism(load("single")))

    The pistons of a centred crank push on the wall sideways, and on the pin as much the other way:

    >>> float(abs(spectra.vertical(spectra.selected(loads.guide, 2))[0, 0]))
    0.0
    """
    moved = motion.resolved(machine.links)
    guide = guide_samples(machine, moved)
    size = np.abs(guide).max(axis=-1, keepdims=True)
    none = np.zeros((*guide.shape[:-1], guide.shape[-1] // 2 - 1), complex)
    sideways = Harmonics(*vector(guide, size), none, none)
    moving = [pair for body in bodies(machine) for pair in body]
    columns = columns_of(
        machine, max(highest(unit) for unit, _ in [*moving, (sideways, 0)]), orders
    )

    wall = placed(machine, columns, sideways, np.ones(guide.shape[:-1]))
    inertia = [placed(machine, columns, unit, amount) for unit, amount in moving]
    speed = np.array([above / below for above, below in machine.ratios])[[*machine.cylinder_shaft]]
    steady = guide.mean(axis=-1)
    steady = np.where(np.abs(steady) > motion.TAIL * size[..., 0], steady, 0.0)
    steady = steady * np.exp(1j * machine.bearing) * speed**2

    def spectrum(mean: Complex, forward: Complex, backward: Complex) -> Spectrum:
        still = np.broadcast_to(mean[..., None], (*forward.shape[:-1], 1))
        return Spectrum(
            np.append(0.0, columns.orders),
            np.concatenate([still, forward], axis=-1),
            np.concatenate([np.zeros_like(still), backward], axis=-1),
            machine.sense,
            complete=orders is None,
        )

    forward, backward = (sum(one[way] for one in inertia) - wall[way] for way in (0, 1))
    return PinLoads(
        spectrum(steady, wall.forward, wall.backward), spectrum(-steady, forward, backward)
    )


class Applied(NamedTuple):
    """What acts on the parts of each cylinder [..., cylinder, sample], the wall and pins aside.

    Forces, N, on piston, centre of the rod and big end, in the frame of the group; `spin` is the
    moment on the rod, N m clockwise.
    """

    piston: Complex
    rod: Complex
    big_end: Complex
    spin: Real


def guide_samples(machine: Mechanism, moved: motion.Rods) -> Complex:
    """G of every cylinder at 1 rad/s, N [..., cylinder, sample], in the frame of its group.

    That is the frame of `motion`: the axis of the group's root cylinder up, its crank turned
    clockwise.
    """
    centre = np.asarray(machine.rod_centre)[..., None]
    inertia = Applied(
        piston=-np.asarray(machine.reciprocating_mass)[..., None] * moved.piston.second,
        rod=-np.asarray(machine.rod_mass)[..., None]
        * (moved.big_end.second + centre * moved.direction.second),
        big_end=-np.asarray(machine.big_end_mass)[..., None] * moved.big_end.second,
        spin=-np.asarray(machine.rod_inertia)[..., None] * _turning(moved.direction),
    )
    return guides(machine, moved, inertia)


def guides(machine: Mechanism, moved: motion.Rods, forces: Applied) -> Complex:
    """Guide forces [..., cylinder, sample] of parts on which these forces act, outermost rod first.

    In N, in the frame of the group.
    """
    links = machine.links
    axis = np.exp(1j * np.asarray(links.bearing))[..., None]
    rod = moved.direction.place * np.asarray(links.rod_length)[..., None]
    centre = np.asarray(machine.rod_centre)[..., None]
    moment = (
        np.imag(np.conj(rod) * forces.piston + np.conj(centre * moved.direction.place) * forces.rod)
        + forces.spin
    )
    own = forces.piston + forces.rod + forces.big_end
    shape = np.broadcast_shapes(own.shape, moment.shape)  # of a batch of big ends alone, too
    moment = np.array(np.broadcast_to(moment, shape))
    pin = np.array(np.broadcast_to(own, shape), complex)
    guide = np.zeros(shape, complex)
    height = np.real(np.conj(rod) * axis)
    for index in sorted(
        range(len(links.master)), key=lambda i: -len(motion.chain(links.master, i))
    ):
        push = 1j * axis[..., index, :] * moment[..., index, :] / height[..., index, :]
        guide[..., index, :] = push
        pin[..., index, :] -= push
        master = links.master[index]
        if master >= 0:
            arm = moved.big_end.place[..., index, :] - moved.big_end.place[..., master, :]
            moment[..., master, :] += np.imag(np.conj(arm) * pin[..., index, :])
            pin[..., master, :] += pin[..., index, :]
    return guide


def _turning(direction: motion.Path) -> Complex:
    """B'' of a rod of bearing b: Im(conj(d) d''), d its unit vector."""
    return np.imag(np.conj(direction.place) * direction.second)
