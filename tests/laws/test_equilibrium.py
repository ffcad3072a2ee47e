"""Rods with gas, inertia and slave rods: statics of every rod at once, by a road of its own.

At a crank angle each rod with its piston has three unknowns: the push g of its wall along the
wall's normal, and the two components of the force S on its pin. Three equations a rod,

    sum of forces = 0,    sum of moments about the crank axis = 0,

with -(p - p_0) A a on the piston, the inertia of its bodies from their momentum (`tests/newton`),
and -S on the pin, +S of its slave rods at their knuckle pins, form one linear system of all rods.
"""

from __future__ import annotations

from math import pi, radians
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import Phase, assume, given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray
from tests.newton import direction, placed, road
from tests.strategies import engines, fired, number

import crankstar
from crankstar import spectra
from crankstar.dynamics.bearings import bearing_loads
from crankstar.engine.copies import with_values
from crankstar.engine.dead_centres import dead_centres
from crankstar.engine.engine import Engine
from crankstar.engine.gas import Gas, Trace
from crankstar.language.faults import EngineError
from crankstar.mechanics.excitation import Reference
from crankstar.mechanics.gas import Cycle, cycle
from crankstar.mechanics.gas_pins import head_forces
from crankstar.mechanics.operating_points import GasError
from crankstar.mechanics.side_thrust import pressure_at

Array = NDArray[Any]
CASES = Path(__file__).parents[1] / "cases"
ANGLES = 48
TOLERANCE = 3e-3
"""Of the greatest force: gas is a sum of 48 orders, and its pressure stands at 3600 samples."""


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
        rows = {each.number: row for row, each in enumerate(engine.cylinders)}
        size = len(rows)
        pressure = pressure_at(found, theta)
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
            self.push[row] = (pressure[chamber] - found.crankcase) * area
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
    size *= TOLERANCE
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


@st.composite
def loaded_engines(draw: Any) -> tuple[Engine, Cycle]:
    """Any engine with rods of every kind, its gas at any load or traced, some cylinders off."""
    drawn = draw(engines(max_shafts=2, known=True))
    cylinders = tuple(with_values(c, bore=draw(number(0.04, 0.2))) for c in drawn.cylinders)
    shafts = tuple(
        with_values(each, speed_ratio=1 if each.speed_ratio > 0 else -1) for each in drawn.shafts
    )
    changed = {"cylinders": cylinders, "shafts": shafts, "valves": None}
    try:
        engine = with_values(
            drawn, **changed, firing_order=(), firing_angles=None, torsion=None, bore_pitch=None
        )
        engine = fired(engine, with_angles=False)
    except EngineError:
        assume(False)
        raise
    turn = 360.0
    assume(all(abs(top.period_deg - turn) < 1e-6 for top in dead_centres(engine).values()))
    whole = radians(engine.cycle_angle)
    angle = np.arange(0, 180) * (whole / 180)
    pressure = 1e5 + 3e6 * np.exp(-9 * (1 - np.cos(angle * 2 * pi / whole)))
    trace = Trace(angle=tuple(angle.tolist()), pressure=(tuple(pressure.tolist()),))
    gas = draw(
        st.builds(Gas, imep=number(3e5, 15e5), compression_ratio=number(8.0, 12.0))
        | st.just(Gas(trace=trace))
    )
    engine = with_values(engine, gas=gas)
    off = draw(st.sets(st.sampled_from([each.number for each in engine.cylinders]), max_size=2))
    try:
        return engine, cycle(engine, speed=draw(number(30.0, 600.0)), off=off)
    except GasError:
        assume(False)
        raise


def test_every_rod_of_any_engine_with_gas_is_in_equilibrium() -> None:
    @settings(max_examples=12, deadline=None, phases=[Phase.explicit, Phase.generate])
    @given(loaded=loaded_engines())
    def holds(loaded: tuple[Engine, Cycle]) -> None:
        assert_statics(*loaded)

    holds()


def test_bearings_guides_and_heads_of_a_radial_carry_its_inertia() -> None:
    engine = crankstar.load(CASES / "radial-clockwise.toml")
    assert_statics(engine, cycle(engine))


def test_the_slave_rods_of_a_radial_push_their_pin_once() -> None:
    engine = crankstar.load(CASES / "radial-clockwise.toml")
    loads = bearing_loads(engine, cycle=cycle(engine))
    assert float(spectra.peaks(loads.pin)[0]) == pytest.approx(25_502, rel=1e-4)
    assert spectra.peaks(loads.load).tolist() == pytest.approx([12_751, 12_751], rel=1e-4)
    assert float(spectra.peaks(loads.big_end)[0]) == pytest.approx(25_502, rel=1e-4)


@pytest.mark.parametrize("name", ["pratt-whitney-wasp", "radial-9"])
def test_a_master_rod_carries_its_slaves_on_its_big_end(name: str) -> None:
    loads = bearing_loads(crankstar.load(name))
    assert spectra.peaks(loads.big_end) == pytest.approx(spectra.peaks(loads.pin), rel=1e-9)
