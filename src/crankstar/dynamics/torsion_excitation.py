"""What twists a crankshaft: the torque of gas and moving parts on each throw, order by order.

    T(theta) = sum Re((gas_k + w^2 inertia_k) exp(i k theta))            N m, each throw

positive in the direction of rotation, theta the angle of the crankshaft that turns evenly at w. On
a crankshaft of another speed ratio i the torque of its cylinders is 1/i of what reaches the first.
Slave rods act on the throw of their master. The gas is that of one cycle, or against speed as
`gas_loads.gas_course` has it: between the operating points of the file that have speeds. The mean
torque, which twists the shaft steadily and does not vibrate, is left out.

The vector sum of an order says how the cylinders join in it, whatever they are:

    S_k = |sum a_j exp(i k phi_j)|

with a_j the shape of a mode at the throw of cylinder j, phi_j the crank angle at which it fires;
of a straight shape, a_j = 1, that of the engine's torque.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from crankstar import spectra
from crankstar.dynamics.torsion_system import TorsionChain
from crankstar.engine.dead_centres import dead_centres
from crankstar.engine.engine import Engine
from crankstar.engine.firing_angles import firing_angles
from crankstar.mechanics.excitation import part_spectra
from crankstar.mechanics.gas import Cycle
from crankstar.mechanics.gas_loads import GasCourse, gas_course
from crankstar.mechanics.gas_torque import HIGHEST, piston_torque
from crankstar.mechanics.mechanism import mechanism
from crankstar.spectra import Complex, Real, Spectrum


@dataclass(frozen=True)
class Excitation:
    """The torque on the masses [node, order]: of the gas (N m), of moving parts at 1 rad/s.

    `inertia` is None where masses are not known; `course` is the gas against speed, None where it
    is that of one cycle at all speeds.
    """

    orders: Real
    gas: Complex
    inertia: Complex | None
    course: GasCourse | None = None

    def torque(self, speed: float | Real) -> Complex:
        """The torque at crank speeds (rad/s), N m [speed, node, order]; without that axis of one.

        >>> own = Excitation(np.array([1.0]), np.array([[2.0 + 0j]]), np.array([[-0.5j]]))
        >>> own.torque(2.0).tolist()
        [[(2-2j)]]
        """
        gas = self.gas if self.course is None else self.course.at(speed)
        if self.inertia is None:
            return np.broadcast_to(gas, (*np.shape(speed), *self.gas.shape))
        return gas + np.asarray(speed)[..., None, None] ** 2 * self.inertia


def excitation(
    chain: TorsionChain,
    engine: Engine,
    cycle: Cycle | None,
    *,
    orders: Sequence[float] | Real | None = None,
    ends: tuple[float, float] | None = None,
    point: str = "",
) -> Excitation:
    """The torque of gas and moving parts on the masses of an engine's chain.

    Without a `cycle` of the moving parts alone; the orders are all up to 24 that a cycle has. The
    gas is that of the cycle, or between two speeds (rad/s), the `ends`, that of a named point or of
    the points of the file, with the cylinders off and weaker that the cycle has so.

    >>> from crankstar.dynamics.torsion_chain import torsion_chain
    >>> from crankstar.files.catalog import load
    >>> torsion = {"torsion": {"inertia": "0.01 kg*m^2", "stiffness": "0.5 MN*m/rad"}}
    >>> engine = load("audi-25-tfsi", changes=torsion)
    >>> found = excitation(torsion_chain(engine), engine, None, orders=[2.0])
    >>> bool(np.allclose(found.inertia, found.inertia[0]))  # a five: not all throws alike
    False
    """
    whole = 1.0 if engine.cycle == "two-stroke" else 0.5
    every = np.arange(1, round(HIGHEST / whole) + 1) * whole
    wanted = every if orders is None else np.array(sorted({*map(float, orders)}))

    def on_masses(pistons: Spectrum) -> Complex:
        out = np.zeros((len(chain.names), wanted.size), complex)
        of_each = spectra.amplitude(spectra.selected(pistons, wanted))
        own = 1 / chain.ratio[list(chain.cylinders), None]
        np.add.at(out, list(chain.cylinders), own * of_each)
        return out

    def burnt(found: Cycle) -> Complex:
        return on_masses(piston_torque(engine, found))

    none = np.zeros((len(chain.names), wanted.size), complex)
    course = None
    if cycle is not None and ends is not None:
        load = {"off": cycle.off, "weaker": dict(cycle.weaker)}
        course = gas_course(engine, burnt, ends=ends, point=point, **load)
    gas = none if cycle is None else burnt(cycle)
    if not {"mass", "radius"}.isdisjoint(engine.relative):
        return Excitation(wanted, gas, None, course)
    return Excitation(wanted, gas, on_masses(piston_inertia_torque(engine)), course)


def piston_inertia_torque(engine: Engine) -> Spectrum:
    """The torque of piston, rod and big end of each cylinder at 1 rad/s [cylinder, order]."""
    machine = mechanism(engine)
    parts = part_spectra(machine).torque
    count = len(engine.cylinders)
    bodies = (len(parts.forward) - len(machine.rotor_shaft)) // count
    rows = spectra.amplitude(parts)[: bodies * count].reshape(bodies, count, -1)
    return spectra.real_signal(parts.orders, rows.sum(axis=0))


def firing_phases(engine: Engine) -> Real | None:
    """The crank angle (radians) at which each cylinder fires [cylinder]; None without an order.

    >>> from crankstar.files.catalog import load
    >>> np.degrees(firing_phases(load("i4"))).round(6).tolist()
    [0.0, 540.0, 180.0, 360.0]
    """
    fires = dict(zip(engine.firing_order, firing_angles(engine), strict=True))
    if len(engine.chambers) == 1 and not fires:
        fires = {number: centre.angle_deg for number, centre in dead_centres(engine).items()}
    if not fires:
        return None
    return np.radians([fires[each.chamber or each.number] for each in engine.cylinders])
