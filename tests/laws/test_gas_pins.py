"""Gas on crank pins, main bearings and walls: equilibrium, torque, the textbook's rod force."""

from __future__ import annotations

from math import pi

import numpy as np
import pytest

import crankstar
from crankstar import spectra
from crankstar.dynamics import wear as wear_module
from crankstar.dynamics.bearings import BearingError, Model, bearing_loads, bending_moment
from crankstar.dynamics.wear import PLACES, SPREAD, wear
from crankstar.engine.engine import Engine
from crankstar.mechanics import gas_pins
from crankstar.mechanics.balance import balance, total
from crankstar.mechanics.gas import cycle
from crankstar.mechanics.gas_pins import gas_pin_loads, head_forces
from crankstar.mechanics.gas_torque import over_cycle
from crankstar.mechanics.kinetic import samples_over
from crankstar.mechanics.side_thrust import gas_push, side_thrust
from crankstar.spectra import Complex, Real, Spectrum

PLAIN = ("audi-25-tfsi", "napier-deltic", "kr250-racer", "bmw-s65", "fiat-twinair", "ducati-900ss")
THETA = np.linspace(0.0, 4 * pi, 181)


def weighty(name: str) -> Engine:
    """The engine with its first reciprocating mass taken as 1 kg where it is not known."""
    engine = crankstar.load(name)
    known = tuple(each for each in engine.relative if each != "mass")
    return engine.model_copy(update={"relative": known})


def summed(*parts: Spectrum) -> Complex:
    """The sum of all rows of all spectra at THETA."""
    return np.sum([spectra.value(part, THETA).sum(axis=0) for part in parts], axis=0)


@pytest.mark.parametrize("name", [*PLAIN, "pratt-whitney-wasp", "jumo-205"])
def test_gas_on_head_wall_and_pin_is_nothing_on_the_engine(name: str) -> None:
    engine = crankstar.load(name)
    found = cycle(engine)
    gas, heads = gas_pin_loads(engine, found), head_forces(engine, found)
    whole = summed(gas.pin, gas.guide, heads)
    assert np.abs(whole).max() < 1e-9 * np.abs(spectra.value(heads, THETA)).max()


@pytest.mark.parametrize("name", [*PLAIN, "honda-b18c", "man-s90mc-c", "yamaha-r1-crossplane"])
def test_gas_on_the_pins_makes_the_gas_torque(name: str) -> None:
    engine = crankstar.load(name)
    found = cycle(engine)
    theta = samples_over(engine, 720)
    loads = spectra.value(gas_pin_loads(engine, found).pin, theta)
    torque = np.zeros(theta.size)
    for load, cylinder in zip(loads, engine.cylinders, strict=True):
        throw, ratio = engine.throw(cylinder), float(engine.shaft(cylinder.shaft).speed_ratio)
        pin = throw.radius * np.exp(1j * (throw.angle + engine.sense * ratio * theta))
        torque += engine.sense * ratio * np.imag(np.conj(pin) * load)
    expected = over_cycle(found, theta.size).sum(axis=0)
    assert torque == pytest.approx(expected, abs=1.5e-3 * np.abs(expected).max())


@pytest.mark.parametrize("model", ["determinate", "continuous"])
@pytest.mark.parametrize(
    "name", ["audi-25-tfsi", "subaru-ej25", "kr250-production", "bmw-f800", "pratt-whitney-wasp"]
)
def test_bearings_walls_and_heads_carry_the_force_on_the_block(name: str, model: Model) -> None:
    engine = weighty(name)
    found = cycle(engine)
    loads = bearing_loads(engine, model=model, cycle=found)
    assert found.speed is not None
    heads = head_forces(engine, found)
    force = total(balance(engine, speed=found.speed)).force
    for order in (0.5, 1.0, 1.5, 2.0, 3.0, 4.0, 6.0):
        if order not in heads.orders:
            continue
        parts = [spectra.selected(each, order) for each in (loads.load, loads.guide, heads)]
        free = spectra.selected(force, order)
        for way in ("forward", "backward"):
            carried = sum(getattr(part, way).sum() for part in parts)
            scale = np.abs(heads.forward).max()
            assert abs(carried - getattr(free, way)[0]) < 1e-9 * scale


def rod_force(name: str, speed: float) -> tuple[Real, Real]:
    """The textbook's force along the rod of a light rod, and that of the program (N, THETA)."""
    engine = crankstar.load(name)
    found = cycle(engine, speed=speed)
    (cylinder,) = engine.cylinders[:1]
    throw = engine.throw(cylinder)
    ratio = throw.radius / cylinder.rod_length
    angle = THETA + throw.angle - cylinder.bearing
    swing = np.arcsin(ratio * np.sin(angle))
    place = throw.radius * np.cos(angle) + cylinder.rod_length * np.cos(swing)
    bend = np.gradient(np.gradient(place, THETA), THETA) * speed**2
    push = gas_push(engine, found, THETA)[0] + cylinder.reciprocating_mass * bend
    loads = bearing_loads(engine, cycle=found)
    turning = throw.rotating_mass * throw.radius * speed**2 * np.exp(1j * (throw.angle + THETA))
    pin = spectra.value(loads.pin, THETA)[0] - turning
    return push / np.cos(swing), np.abs(pin)


def test_the_rod_carries_gas_and_inertia_over_the_cosine_of_its_angle() -> None:
    expected, found = rod_force("audi-25-tfsi", 400.0)
    inner = slice(3, -3)  # differences at the ends are one-sided
    scale = np.abs(expected).max()
    assert found[inner] == pytest.approx(np.abs(expected)[inner], abs=6e-3 * scale)


@pytest.mark.parametrize("name", ["audi-25-tfsi", "honda-b18c"])
def test_guide_forces_with_gas_are_the_side_thrust(name: str) -> None:
    engine = weighty(name)  # upright; the thrust side is the left of one that turns clockwise
    found = cycle(engine, speed=300.0)
    thrust = side_thrust(engine, found)
    guide = spectra.value(bearing_loads(engine, cycle=found).guide, thrust.theta)
    left = -engine.sense * np.imag(guide)
    assert left == pytest.approx(thrust.total, abs=2e-3 * np.abs(thrust.total).max())


def test_the_bending_moment_in_two_bearings_grows_with_the_gas() -> None:
    engine = crankstar.load("audi-25-tfsi")
    quiet = bending_moment(engine, speed=cycle(engine).speed)
    loud = bending_moment(engine, cycle=cycle(engine))
    assert spectra.peaks(loud.moment).max() > 2 * spectra.peaks(quiet.moment).max()


@pytest.mark.parametrize("name", ["bmw-s65", "v8-cross-plane"])
def test_loads_with_gas_need_masses_and_a_speed(name: str) -> None:
    engine = crankstar.load(name)
    with pytest.raises((BearingError, crankstar.EngineError, ValueError), match="need"):
        bearing_loads(engine, cycle=cycle(engine))


def test_a_rod_that_pulls_outward_wears_the_inner_side_of_its_pin() -> None:
    turning = Spectrum(np.array([1.0]), np.array([1.0 + 0j]), np.array([0j]))
    found = wear(turning, speed_ratio=1.0, inward=True)
    assert found.most is not None
    assert abs(found.most) == pytest.approx(pi, abs=0.02)


def test_a_load_that_turns_against_the_journal_wears_it_evenly() -> None:
    backward = Spectrum(np.array([1.0]), np.array([0j]), np.array([1.0 + 0j]))
    found = wear(backward, speed_ratio=1.0)
    assert found.least is None
    assert found.most is None
    assert found.pressed == pytest.approx(np.full(360, 1 / 3), rel=0.01)


def test_wear_turns_with_the_load() -> None:
    engine = crankstar.load("audi-25-tfsi")
    pin = bearing_loads(engine, cycle=cycle(engine)).pin[0]
    found = wear(pin, speed_ratio=1.0)
    turned = wear(spectra.turned(pin, pi / 2), speed_ratio=1.0)
    assert np.roll(found.pressed, 90) == pytest.approx(turned.pressed, rel=1e-9)
    assert found.mean == pytest.approx(turned.mean)


@pytest.mark.parametrize("count", [1, 7, 720, 1440])
def test_wear_is_the_share_of_each_load_within_60_degrees_of_a_direction(count: int) -> None:
    random = np.random.default_rng(count)
    directions = (np.arange(PLACES) - PLACES // 2) * (2 * pi / PLACES)
    for angles in (random.uniform(-pi, pi, count), np.round(random.uniform(-6, 6, count)) / 6 * pi):
        loads = random.exponential(size=count) * np.exp(1j * angles)
        off = np.abs(np.angle(np.exp(1j * (angles[:, None] - directions))))
        share = np.clip((SPREAD - off) / (2 * pi / PLACES) + 0.5, 0.0, 1.0)
        expected = (np.abs(loads)[:, None] * share).mean(axis=0)
        found = wear_module._pressed(loads, directions)
        assert found == pytest.approx(expected, abs=1e-13 * expected.max())
        assert found.min() >= 0.0


@pytest.mark.parametrize("name", ["tests/cases/genset-four.toml", "audi-25-tfsi"])
def test_orders_that_are_left_out_move_no_printed_digit_of_a_peak(
    name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    engine = crankstar.load(name)
    found = cycle(engine)
    assert found.speed is not None

    def peaks() -> list[float]:
        loads = bearing_loads(engine, speed=found.speed, cycle=found)
        return [float(spectra.peaks(own).max()) for own in (loads.pin, loads.load, loads.guide)]

    usual = peaks()
    monkeypatch.setattr(gas_pins, "HIGHEST", 4 * gas_pins.HIGHEST)
    monkeypatch.setattr(gas_pins, "SAMPLES", 8 * gas_pins.SAMPLES)
    assert peaks() == pytest.approx(usual, rel=2e-5)
