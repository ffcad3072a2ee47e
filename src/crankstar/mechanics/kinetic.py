"""The inertia of the moving parts as the crankshaft feels it, over the crank angle.

With T the kinetic energy of all moving parts at w = 1 rad/s,

    J(theta) = 2 T(theta) = sum ratio^2 (m |P'|^2 + I b'^2)      kg m^2

over pistons, rods and big ends, and m r^2 of what hangs on the pins. The crankshaft itself, its
crankpins and webs (`throw_mass`) with it, is in none of this: its inertia is a value of the file.
The mean is taken over the motion of each part, its change from the torque that the parts ask for,
J' = -2 torque at 1 rad/s: the two halves of one law on two roads.
"""

from __future__ import annotations

from math import pi

import numpy as np

from crankstar import spectra
from crankstar.engine import motion
from crankstar.engine.engine import Engine
from crankstar.engine.records import Shaft
from crankstar.mechanics.excitation import part_spectra
from crankstar.mechanics.mechanism import Mechanism, mechanism
from crankstar.spectra import Real, Spectrum


def mean_inertia(machine: Mechanism) -> float:
    """The mean of J over a turn of each shaft, kg m^2, without flywheel and bare crankshaft.

    Without what hangs on the pins as well (`throw_inertia`).

    A light rod: half the reciprocating mass, and a little more, at the crank radius.

    >>> from crankstar.files.catalog import load
    >>> engine = load("audi-25-tfsi")
    >>> whole = 5 * engine.first.reciprocating_mass * 0.0464**2
    >>> round(mean_inertia(mechanism(engine)) / whole, 3)
    0.514
    """
    return float(_mean_inertias(machine).sum())


def moving_inertias(engine: Engine) -> Real:
    """The mean inertia of piston, rod and own big end of each cylinder, kg m^2 [cylinder].

    >>> from crankstar.files.catalog import load
    >>> engine = load("audi-25-tfsi")
    >>> bool(np.isclose(moving_inertias(engine).sum(), mean_inertia(mechanism(engine))))
    True
    """
    return _mean_inertias(mechanism(engine))


def throws_from_front(crank: Shaft) -> list[int]:
    """The numbers of the throws of a crankshaft, front first."""
    numbers = range(1, len(crank.throws) + 1)
    return sorted(numbers, key=lambda number: -crank.throws[number - 1].z)


def carried_inertias(engine: Engine) -> Real:
    """What rods and pistons add to the throws, kg m^2 of their own crankshafts, front first.

    Crankshaft by crankshaft; the mean over a turn, and what hangs on the pins. The crankshaft's own
    unbalance is its own.

    >>> from crankstar.files.catalog import load
    >>> len(carried_inertias(load("audi-25-tfsi"))), len(carried_inertias(load("jumo-205")))
    (5, 12)
    """
    moving = moving_inertias(engine)
    out: list[float] = []
    for crank in engine.shafts:
        for number in throws_from_front(crank):
            throw = crank.throws[number - 1]
            own = [
                float(value) / float(crank.speed_ratio) ** 2
                for cylinder, value in zip(engine.cylinders, moving, strict=True)
                if (cylinder.shaft, cylinder.throw) == (crank.name, number)
            ]
            out.append(throw.rotating_mass * throw.radius**2 + sum(own))
    return np.array(out)


def _mean_inertias(machine: Mechanism) -> Real:
    """The mean of J of the parts of each cylinder, kg m^2 [cylinder]."""
    moved = motion.resolved(machine.links)
    ratio = np.array([above / below for above, below in machine.ratios])
    squared = ratio[[*machine.cylinder_shaft]] ** 2

    def mean(path: motion.Path) -> Real:
        return (np.abs(path.first) ** 2).mean(axis=-1)

    share = (machine.rod_centre / machine.links.rod_length)[..., None]
    centre = motion.Path(
        *(q + share * (p - q) for p, q in zip(moved.piston, moved.big_end, strict=True))
    )
    own = (
        machine.reciprocating_mass * mean(moved.piston)
        + machine.rod_mass * mean(centre)
        + machine.rod_inertia * mean(moved.direction)
        + machine.big_end_mass * mean(moved.big_end)
    )
    return squared * own


def throw_inertia(engine: Engine) -> float:
    """M r^2 of what hangs on the pins (`rotating_mass`), kg m^2; the crankshaft has its own."""
    return float(_throw_inertias(engine).sum())


def _throw_inertias(engine: Engine) -> Real:
    """The same of each shaft, kg m^2 [shaft]."""
    return np.array(
        [
            float(shaft.speed_ratio) ** 2
            * sum(throw.rotating_mass * throw.radius**2 for throw in shaft.throws)
            for shaft in engine.shafts
        ]
    )


def inertia(engine: Engine, theta: Real) -> Real:
    """J at crank angles theta (radians), kg m^2 [angle], without flywheel and bare crankshaft."""
    return inertias(engine, theta).sum(axis=0)


def inertias(engine: Engine, theta: Real) -> Real:
    """The share of each shaft in J, kg m^2 [shaft, angle]: that of the parts it moves.

    >>> from crankstar.files.catalog import load
    >>> inertias(load("kr250-racer"), np.array([0.0, 1.0])).shape
    (2, 2)
    """
    machine = mechanism(engine)
    torque = shaft_torque(machine)
    # J' = -2 torque, term by term
    wave = -2 * spectra.amplitude(torque) / (1j * torque.orders)
    change = np.real(spectra.value(spectra.real_signal(torque.orders, wave), theta))
    mean = _throw_inertias(engine)
    np.add.at(mean, np.array(machine.cylinder_shaft), _mean_inertias(machine))
    return mean[:, None] + change


def shaft_torque(machine: Mechanism) -> Spectrum:
    """The inertia torque on each shaft at 1 rad/s, N m [shaft, order]."""
    parts = part_spectra(machine).torque
    bodies = (len(parts.forward) - len(machine.rotor_shaft)) // len(machine.cylinder_shaft)
    owner = np.array([*machine.cylinder_shaft] * bodies + [*machine.rotor_shaft])
    return spectra.stacked(
        [spectra.total(parts[owner == index]) for index in range(len(machine.ratios))]
    )


def samples_over(engine: Engine, count: int) -> Real:
    """Equal steps of the reference crankshaft over a working cycle, radians [count]."""
    return np.arange(count) * (engine.cycle_angle / 180 * pi / count)
