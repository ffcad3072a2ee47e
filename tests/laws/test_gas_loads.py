"""Laws of side thrust, of gas at many loads and of forces at uneven speed, on second roads."""

from __future__ import annotations

from dataclasses import replace
from math import pi
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from tests.laws.test_gas_torque import gas_engines
from tests.strategies import number

import crankstar
from crankstar import spectra
from crankstar.dynamics.uneven import Running, running
from crankstar.dynamics.uneven_forces import changes, uneven_spectrum, worth_telling
from crankstar.engine.dead_centres import pistons
from crankstar.engine.engine import Engine
from crankstar.engine.gas import Gas
from crankstar.mechanics.balance import balance, total
from crankstar.mechanics.gas import Cycle, cycle
from crankstar.mechanics.gas_loads import gas_over_speeds, is_linear, torques_at_loads
from crankstar.mechanics.gas_torque import gas_torque, over_cycle
from crankstar.mechanics.operating_points import GasError
from crankstar.mechanics.side_thrust import rods_over, side_thrust
from crankstar.spectra import Complex, Real

SMALL = {
    "cylinder.stroke": "80 mm",
    "cylinder.bore": "80 mm",
    "cylinder.rod_ratio": 3.5,
    "cylinder.reciprocating_mass": "0.5 kg",
}


# Side thrust


def piston_places(engine: Engine, theta: Real) -> tuple[Complex, Complex]:
    """Piston pins and cylinder axes of plain rods, from the geometry, frame of the engine."""
    places, axes = [], []
    for cylinder in engine.cylinders:
        throw = engine.throw(cylinder)
        sense = engine.sense * float(engine.shaft(cylinder.shaft).speed_ratio)
        axis = np.exp(1j * cylinder.bearing)
        pin = throw.radius * np.exp(1j * (sense * theta + throw.angle)) / axis
        height = np.sqrt(cylinder.rod_length**2 - (pin.imag - cylinder.offset) ** 2)
        places.append(axis * (pin.real + height + 1j * cylinder.offset))
        axes.append(axis)
    return np.array(places), np.array(axes)[:, None]


@given(gas_engines())
def test_side_thrust_and_head_together_roll_the_block_by_minus_the_torque(engine: Engine) -> None:
    """Of any engine with plain rods: the moment of wall and head about the crank axis."""
    if any(cylinder.articulated for cylinder in engine.cylinders):
        return
    if any(len(pistons) > 1 for pistons in engine.chambers.values()):  # they have no head
        return
    found = cycle(engine)
    thrust = side_thrust(engine, found)
    places, axes = piston_places(engine, thrust.theta)
    sense = np.sign(pistons(engine).ratio)[:, None]
    wall = -1j * axes * thrust.gas * sense
    push = np.array([pressure_of(found, number, thrust.theta) for number in thrust.numbers])
    area = np.array([pi / 4 * (c.bore or 0.0) ** 2 for c in engine.cylinders])[:, None]
    head = push * area * axes
    moment = np.imag(np.conj(places) * (wall + head)).sum(axis=0)
    torque = over_cycle(found, thrust.theta.size).sum(axis=0)
    scale = np.abs(head).max() * np.abs(places).max()
    assert np.abs(moment + engine.sense * torque).max() < 2e-3 * scale  # pressure between samples


def pressure_of(found: Cycle, number: int, theta: Real) -> Real:
    """The gauge pressure of a chamber at crank angles, by its own interpolation."""
    places = found.volumes
    row = places.numbers.index(number)
    samples = found.pressure[row]
    own = (theta - places.fires[row]) % places.cycle / places.cycle * samples.size
    low = np.floor(own).astype(int)
    share = own - low
    value = (1 - share) * samples[low % samples.size] + share * samples[(low + 1) % samples.size]
    return value - found.crankcase


def test_side_thrust_of_a_plain_cylinder_is_the_force_times_the_tangent_of_the_rod() -> None:
    """Gas and d'Alembert forces of piston and rod small end on the piston pin, by hand."""
    engine = crankstar.load("single", changes={**SMALL, "speed": "4000 rpm"})
    found = cycle(engine, imep=8e5)
    thrust = side_thrust(engine, found)
    radius, length, mass = 0.04, 0.14, 0.5
    theta, speed = thrust.theta, engine.speed or 0.0
    lam = radius / length
    sine = lam * np.sin(theta)
    root = np.sqrt(1 - sine**2)
    slope = -radius * np.sin(theta) - length * sine * lam * np.cos(theta) / root
    step = 1e-5
    after = -radius * np.sin(theta + step) - length * (
        lam * np.sin(theta + step) * lam * np.cos(theta + step)
    ) / np.sqrt(1 - (lam * np.sin(theta + step)) ** 2)
    acceleration = (after - slope) / step * speed**2
    push = pressure_of(found, 1, theta) * pi / 4 * 0.08**2 + mass * acceleration
    wanted = push * sine / root
    assert np.abs(thrust.total[0] - wanted).max() < 2e-3 * np.abs(wanted).max()


def test_side_thrust_of_master_and_slaves_rolls_as_much_as_the_gas_torque() -> None:
    engine = crankstar.load("pratt-whitney-wasp")
    found = cycle(engine)
    thrust = side_thrust(engine, found)
    # a radial's cylinders all point at the crank axis, so the head has no moment
    height = np.abs(rods_over(engine, thrust.theta).piston.place)
    moment = (thrust.gas * height).sum(axis=0)
    torque = over_cycle(found, thrust.theta.size).sum(axis=0)
    assert np.abs(moment - torque).max() < 1e-3 * np.abs(torque).max()


# Many loads


@given(gas_engines(), number(3e5, 6e5), number(7e5, 10e5))
def test_torque_at_many_loads_is_that_of_each_load(engine: Engine, low: float, high: float) -> None:
    middle = 0.37 * low + 0.63 * high
    try:
        found = torques_at_loads(engine, imep=[low, middle, high])
        each = gas_torque(cycle(engine, imep=middle))
    except GasError:  # a Diesel cycle that cannot do so much
        return
    wanted = spectra.amplitude(each.torque)
    difference = spectra.amplitude(found.torque)[1] - wanted
    assert np.abs(difference).max() < 1e-9 * np.abs(wanted).max()
    assert found.mean[1] == pytest.approx(each.mean, rel=1e-9)


def test_ideal_cycles_with_a_limit_and_real_gases_are_not_linear_in_the_load() -> None:
    single = crankstar.load("single", changes=SMALL)

    def of(**values: Any) -> bool:
        return is_linear(single.model_copy(update={"gas": Gas(**values)}))

    assert of()
    assert of(process="otto")
    assert not of(process="diesel")
    assert not of(process="limited-pressure")
    assert not of(variable_gamma=True)


def test_the_tangential_pressure_depends_on_the_cycle_and_not_on_the_size() -> None:
    small = crankstar.load("single", changes=SMALL)
    large = crankstar.load(
        "single",
        changes={
            **SMALL,
            "cylinder.stroke": "800 mm",
            "cylinder.bore": "500 mm",
            "gas.ignition": "spark",
        },
    )
    loads = [4e5, 8e5, 16e5]
    one, other = (torques_at_loads(engine, imep=loads).tangential for engine in (small, large))
    assert np.abs(one - other).max() < 1e-9 * np.abs(one).max()


def test_the_tangential_pressure_has_the_mean_of_the_textbooks() -> None:
    """Work of a cycle over the way of the crank pin: imep/(2 pi) of a four-stroke cylinder."""
    engine = crankstar.load("single", changes=SMALL)
    found = torques_at_loads(engine, imep=[8e5])
    area, radius = pi / 4 * 0.08**2, 0.04
    assert found.mean[0, 0] / (area * radius) == pytest.approx(8e5 / (2 * pi), rel=1e-9)


def test_between_operating_points_the_gas_is_interpolated_over_the_speed() -> None:
    from crankstar.engine.gas import OperatingPoint

    points = (
        OperatingPoint(name="idle", speed=80.0, imep=2e5),
        OperatingPoint(name="full", speed=500.0, imep=11e5),
    )
    engine = crankstar.load("single", changes=SMALL).model_copy(update={"gas": Gas(points=points)})
    found = spectra.amplitude(gas_over_speeds(engine, [10.0, 80.0, 290.0, 500.0, 900.0]))
    idle, full = (
        spectra.amplitude(gas_torque(cycle(engine, point=name)).total) for name in ("idle", "full")
    )
    for row, wanted in enumerate((idle, idle, (idle + full) / 2, full, full)):
        assert np.allclose(found[row], wanted, rtol=1e-12, atol=1e-12 * np.abs(wanted).max())
    named = spectra.amplitude(gas_over_speeds(engine, [10.0, 900.0], point="full"))
    assert np.allclose(named, full)


# Forces at uneven speed


def uneven(theta: Real, speed: Real) -> Running:
    mean = 1 / float(np.mean(1 / speed))
    nothing = np.zeros_like(theta)
    return Running(theta, speed, nothing, nothing, mean, 0.0, 0.0, 0.0, 0.0, 0.0)


def test_forces_at_uneven_speed_are_those_of_a_body_followed_in_time() -> None:
    """The piston's place over time by inverting t(theta), differentiated twice in time."""
    engine = crankstar.load("single", changes={**SMALL, "balance_factor": 0.0})
    count = 1440
    theta = np.arange(count) * (4 * pi / count)
    speed = 100.0 * (1 + 0.08 * np.cos(theta / 2 + 0.3) + 0.05 * np.sin(2 * theta))
    run = uneven(theta, speed)
    steady = total(balance(engine, speed=run.mean_speed)).force
    found = uneven_spectrum(steady, run)
    # time by Simpson's rule on a fine grid, then theta at equal times
    fine = np.linspace(0.0, 4 * pi, 200_001)
    slowness = 1 / (100.0 * (1 + 0.08 * np.cos(fine / 2 + 0.3) + 0.05 * np.sin(2 * fine)))
    time = np.append(0.0, np.cumsum((slowness[1:] + slowness[:-1]) / 2 * np.diff(fine)))
    period = time[-1]
    at = np.linspace(0.0, period, 20_001)
    angle = np.interp(at, time, fine)
    radius, length = 0.04, 0.14
    place = radius * np.cos(angle) + np.sqrt(length**2 - (radius * np.sin(angle)) ** 2)
    lines = np.fft.rfft(place[:-1]) / (place.size - 1)
    numbers = np.arange(1, 17)
    # the force on the block is minus mass times acceleration
    waves = 2 * 0.5 * (2 * pi * numbers / period) ** 2 * lines[1:17]
    wanted = np.abs(waves)
    own = np.abs(spectra.vertical(found))
    assert found.orders == pytest.approx(numbers / 2)
    assert np.abs(own - wanted).max() < 2e-3 * wanted.max()
    assert own[0] > 1e-3 * wanted.max()  # an order which even speed does not have
    assert 2 * own[0] < own[1]


def test_an_even_speed_changes_no_order_and_a_small_one_little() -> None:
    engine = crankstar.load("audi-25-tfsi")
    found = cycle(engine, speed=200.0)
    heavy = running(engine, found, flywheel=1e5)
    assert worth_telling(changes(engine, heavy)) == []
    light = running(engine, found, flywheel=0.15)
    told = worth_telling(changes(engine, light))
    assert told
    half = replace(light, speed=light.mean_speed + (light.speed - light.mean_speed) / 2)
    whole = {(c.quantity, c.order): c.uneven - c.even for c in changes(engine, light)}
    less = {(c.quantity, c.order): c.uneven - c.even for c in changes(engine, half)}
    order = max(told, key=lambda key: abs(whole[key]))
    assert less[order] == pytest.approx(whole[order] / 2, rel=0.25)
