"""Statics of every rod of an engine at once, with gas, inertia and slave rods: a road of its own.

At a crank angle each rod with its piston has three unknowns: the push g of its wall along the
wall's normal, and the two components of the force S on its pin. Three equations a rod,

    sum of forces = 0,    sum of moments about the crank axis = 0,

with -(p - p_0) A a on the piston, the inertia of its bodies from their momentum (`tests/newton`),
and -S on the pin, +S of its slave rods at their knuckle pins, form one linear system of all rods.
"""

from __future__ import annotations

from math import pi
from typing import Any

import numpy as np
from numpy.typing import NDArray
from tests.newton import direction, placed, road

from crankstar import spectra
from crankstar.dynamics.bearings import bearing_loads
from crankstar.engine.dead_centres import pistons
from crankstar.engine.engine import Engine
from crankstar.mechanics.excitation import Reference
from crankstar.mechanics.gas import Cycle
from crankstar.mechanics.gas_pins import head_forces
from crankstar.mechanics.gas_torque import HIGHEST
from crankstar.mechanics.side_thrust import pressure_at

Array = NDArray[Any]
ANGLES = 48
TOLERANCE = 1e-3
"""Of the greatest force: the pressure stands at 3600 samples."""


class Statics:
    """Wall and pin forces of every rod [cylinder, angle], N, from one linear system an angle."""

    def __init__(self, engine: Engine, found: Cycle) -> None:
        speed = found.speed or 0.0
        walked = road(engine, reference=Reference(0.0), speed=speed)
        cycles = found.volumes.cycle / (2 * pi)
        count = len(walked.theta)
        few = np.unique(np.linspace(0, count - 1, ANGLES // 2).astype(int))
        base = walked.theta[few].astype(float)
        period = count * float(walked.theta[1])
        theta = np.concatenate([base, base + period]) if cycles == 2 else base
        few = np.concatenate([few, few]) if cycles == 2 else few
        self.theta, self.engine = theta, engine
        self.left_out = _beyond(found) * max((own.bore or 0.0) ** 2 for own in engine.cylinders)
        rows = {each.number: row for row, each in enumerate(engine.cylinders)}
        size = len(rows)
        pressure = pressure_at(found, theta)
        facing = pistons(engine).crown
        self.push = np.zeros((size, theta.size))
        matrix = np.zeros((theta.size, 3 * size, 3 * size))
        right = np.zeros((theta.size, 3 * size))
        for row, own in enumerate(engine.cylinders):
            shaft = engine.shaft(own.shaft)
            axis = np.array([shaft.right, shaft.up])
            pin, piston, _ = (np.asarray(each, float) for each in placed(engine, own, base))
            if cycles == 2:
                pin, piston = np.tile(pin, (2, 1)), np.tile(piston, (2, 1))
            along = direction(np.array(own.bearing))
            normal = np.array([along[1], -along[0]])
            chamber = found.volumes.numbers.index(own.chamber or own.number)
            area = pi / 4 * (own.bore or 0.0) ** 2
            self.push[row] = facing[row] * (pressure[chamber] - found.crankcase) * area
            force = -self.push[row][:, None] * along
            moment = _cross(piston + axis, force)
            for body, push in zip(walked.bodies, walked.pushes, strict=True):
                if body.cylinder == own.number:
                    force = force + np.asarray(push.force[few, :2], float)
                    moment = moment + np.asarray(push.moment[few, 2], float)
            right[:, 3 * row : 3 * row + 2], right[:, 3 * row + 2] = -force, -moment
            matrix[:, 3 * row : 3 * row + 2, 3 * row] = -normal
            matrix[:, 3 * row + 2, 3 * row] = -_cross(piston + axis, normal)
            for unit, column in (((1.0, 0.0), 3 * row + 1), ((0.0, 1.0), 3 * row + 2)):
                arm = _cross(pin + axis, np.array(unit))
                matrix[:, 3 * row : 3 * row + 2, column] = -np.array(unit)
                matrix[:, 3 * row + 2, column] = -arm
                if own.articulated:
                    below = 3 * rows[own.articulated.master]
                    matrix[:, below : below + 2, column] += np.array(unit)
                    matrix[:, below + 2, column] += arm
        found_forces = np.linalg.solve(matrix, right[..., None])[..., 0]
        self.guide = np.zeros((size, theta.size), complex)
        self.pin = np.zeros((size, theta.size), complex)
        for row, own in enumerate(engine.cylinders):
            along = direction(np.array(own.bearing))
            across = np.array([along[1], -along[0]])
            wall = found_forces[:, 3 * row]
            self.guide[row] = wall * (across[1] + 1j * across[0])
            self.pin[row] = found_forces[:, 3 * row + 2] + 1j * found_forces[:, 3 * row + 1]

    @property
    def masters(self) -> list[int]:
        """The rows of rods on crank pins."""
        return [row for row, own in enumerate(self.engine.cylinders) if own.articulated is None]


def _beyond(found: Cycle) -> float:
    """The greatest pressure, Pa, that a cycle has in orders above those that loads are sums of."""
    waves = np.fft.rfft(found.pressure, axis=-1)
    waves[:, : int(HIGHEST * found.volumes.cycle / (2 * pi)) + 1] = 0
    return float(np.abs(np.fft.irfft(waves, axis=-1)).max())


def _cross(arm: Array, force: Array) -> Array:
    return arm[..., 0] * force[..., 1] - arm[..., 1] * force[..., 0]


def hanging(engine: Engine, shaft: str, throw: int, theta: Array, speed: float) -> Array:
    """The centrifugal force of the rotating mass on a crank pin, N [angle]."""
    on = engine.shaft(shaft)
    own = on.throws[throw - 1]
    turned = np.exp(1j * (own.angle + engine.sense * float(on.speed_ratio) * theta))
    return own.rotating_mass * own.radius * (speed * float(on.speed_ratio)) ** 2 * turned


def assert_statics(engine: Engine, found: Cycle) -> None:
    """Walls, rods, pins and the whole of an engine carry what statics of every rod says."""
    statics = Statics(engine, found)
    theta, speed = statics.theta, found.speed or 0.0
    loads = bearing_loads(engine, cycle=found)
    size = max(np.abs(statics.pin).max(), np.abs(statics.push).max(), np.abs(statics.guide).max())
    size = TOLERANCE * size + 2 * statics.left_out
    assert np.abs(spectra.value(loads.guide, theta) - statics.guide).max() < size
    rods = {(own.shaft, own.throw): 0 for own in engine.cylinders}
    for row in statics.masters:
        own = engine.cylinders[row]
        rods[own.shaft, own.throw] += 1
    for row in statics.masters:
        own = engine.cylinders[row]
        index = [each.cylinder for each in loads.big_ends].index(own.number)
        turning = hanging(engine, own.shaft, own.throw, theta, speed)
        carried = spectra.value(loads.big_end[index], theta)
        share = turning / rods[own.shaft, own.throw]
        assert np.abs(carried - share - statics.pin[row]).max() < size
    for index, pin in enumerate(loads.pins):
        on = [
            row
            for row in statics.masters
            if (engine.cylinders[row].shaft, engine.cylinders[row].throw) == (pin.shaft, pin.throw)
        ]
        turning = hanging(engine, pin.shaft, pin.throw, theta, speed)
        carried = spectra.value(loads.pin[index], theta) - turning
        assert np.abs(carried - statics.pin[on].sum(axis=0)).max() < size
    assert_whole(engine, found)


def assert_whole(engine: Engine, found: Cycle) -> None:
    """Bearings, walls and heads together carry the inertia force, from the momentum of it all."""
    assert found.speed is not None
    loads = bearing_loads(engine, cycle=found)
    walked = road(engine, reference=Reference(0.0), speed=found.speed)
    few = np.linspace(0, len(walked.theta) - 1, ANGLES).astype(int)
    theta = walked.theta[few].astype(float)
    moving = np.sum([push.force[few] for push in walked.pushes], axis=0).astype(float)
    heads = head_forces(engine, found)
    carried = sum(
        spectra.value(each, theta).sum(axis=0) for each in (loads.load, loads.guide, heads)
    )
    size = max(np.abs(spectra.value(each, theta)).max() for each in (loads.load, heads))
    assert np.abs(carried - (moving[:, 1] + 1j * moving[:, 0])).max() < 1e-8 * size
