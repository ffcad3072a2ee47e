"""Pistons that face each other on one crankshaft, and dead centres that no sample meets."""

from __future__ import annotations

import tomllib
from math import asin, cos, pi, radians, sqrt

import numpy as np
import pytest

from crankstar import load, spectra
from crankstar.engine.volumes import volumes
from crankstar.files import engine_of
from crankstar.mechanics.charge_air import events
from crankstar.mechanics.gas import cycle
from crankstar.mechanics.gas_pins import gas_pin_loads, head_forces
from crankstar.mechanics.gas_torque import gas_torque
from crankstar.mechanics.pressures import volumes_of
from crankstar.mechanics.side_thrust import greatest_side_thrust, side_thrust

OPPOSED = """
format = 1
name = "opposed pistons on one crank, upper one by side rods and crosshead"
cycle = "four-stroke"
firing_order = [1]
speed = "2000 rpm"

[gas]
compression_ratio = 8
imep = "5 bar"

[[shaft]]
name = "crank"
[[shaft.throw]]
angle = "0 deg"
radius = "12 mm"
rotating_mass = "40 g"
[[shaft.throw]]
angle = "180 deg"
radius = "12 mm"
rotating_mass = "40 g"

[[cylinders]]
number = 1
shaft = "crank"
throw = 1
bore = "24 mm"
rod_length = "50 mm"
reciprocating_mass = "60 g"
chamber = 1

[[cylinders]]
number = 2
shaft = "crank"
throw = 2
bore = "24 mm"
rod_length = "50 mm"
reciprocating_mass = "60 g"
chamber = 1
"""


def test_two_pistons_that_face_each_other_on_one_crank_compress_between_them() -> None:
    """Their distance goes by 4 r cos(theta): the secondary parts of both travels cancel."""
    engine = engine_of(tomllib.loads(OPPOSED))
    found = cycle(engine)
    area = pi / 4 * 0.024**2
    assert found.volumes.swept[0] == pytest.approx(area * 4 * 0.012, rel=1e-12)
    theta = np.arange(720) * radians(1.0)
    between = area * 2 * 0.012 * (1 - np.cos(theta))
    assert volumes(engine, 720).above[0] == pytest.approx(between, abs=1e-15)
    torque = gas_torque(found)
    assert torque.mean == pytest.approx(5e5 * area * 0.048 / (4 * pi), rel=1e-4)
    assert torque.mean == pytest.approx(0.864, abs=5e-5)


def test_the_forces_on_the_crank_pins_of_facing_pistons_give_their_torque() -> None:
    """By statics: the gas pulls the second pin up while it pushes the first one down."""
    engine = engine_of(tomllib.loads(OPPOSED))
    found = cycle(engine)
    loads = gas_pin_loads(engine, found)
    count = 1440
    theta = np.arange(count) * (4 * pi / count)
    pins = 0.012 * np.exp(1j * (theta + np.array([[0.0], [pi]])))
    force = spectra.value(loads.pin, theta)
    by_pins = np.imag(np.conj(pins) * force).sum(axis=0)
    assert by_pins.mean() == pytest.approx(gas_torque(found).mean, rel=1e-4)
    wave = np.real(spectra.value(gas_torque(found).total, theta))
    assert by_pins - by_pins.mean() == pytest.approx(wave, abs=2e-3 * np.abs(wave).max())
    heads = spectra.value(head_forces(engine, found), theta).sum(axis=0)
    assert np.abs(heads).max() < 1e-9 * np.abs(force).max()  # the chamber has no head


@pytest.mark.parametrize("apart", [0, 20, 80])
def test_two_pistons_side_by_side_in_one_chamber_compress_together(apart: int) -> None:
    text = OPPOSED.replace('angle = "180 deg"', f'angle = "{apart} deg"')
    swept = cycle(engine_of(tomllib.loads(text))).volumes.swept[0]
    assert swept == pytest.approx(
        pi / 4 * 0.024**2 * 4 * 0.012 * cos(radians(apart / 2)), rel=0.03 if apart else 1e-12
    )


def test_the_bottom_dead_centre_of_an_offset_cylinder_is_not_rounded() -> None:
    """At 180 deg + asin(e/(l - r)), e/(l + r) being the top; the valves count from it."""
    offset, radius, rod = 0.01, 0.04, 0.12
    changes = {
        "cylinder.stroke": f"{2 * radius} m",
        "cylinder.rod_length": f"{rod} m",
        "cylinder.offset": f"{offset} m",
        "gas.imep": "8 bar",
    }
    engine = load("honda-b18c", changes=changes)
    later = asin(offset / (rod - radius)) - asin(offset / (rod + radius))
    bottom = pi + engine.sense * later
    places = volumes_of(engine)
    assert places.bottom[0] == pytest.approx(bottom, abs=1e-12)
    stroke = sqrt((rod + radius) ** 2 - offset**2) - sqrt((rod - radius) ** 2 - offset**2)
    bore = engine.first.bore or 0.0
    assert places.swept[0] == pytest.approx(pi / 4 * bore**2 * stroke, rel=1e-12)
    found, straight = events(engine, bottom), events(engine, pi)
    assert found.opened - straight.opened == pytest.approx(bottom - pi, abs=1e-12)
    assert found.closed - straight.closed == pytest.approx(bottom - pi, abs=1e-12)


@pytest.mark.release
def test_the_greatest_side_thrust_is_not_that_of_the_nearest_degree() -> None:
    engine = load("audi-25-tfsi")
    found = cycle(engine)
    fine = greatest_side_thrust(engine, found).total
    dense = side_thrust(engine, found, samples=72000).total
    rough = side_thrust(engine, found).total
    assert fine.max(axis=1) == pytest.approx(dense.max(axis=1), rel=1e-6)
    assert fine.min(axis=1) == pytest.approx(dense.min(axis=1), rel=1e-6)
    assert np.all(fine.max(axis=1) >= rough.max(axis=1))
