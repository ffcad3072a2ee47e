"""The oil film: mobility beside the numerical film, Ocvirk's steady journal, laws of scale."""

from __future__ import annotations

from math import atan2, pi, sqrt
from typing import Any

import numpy as np
import pytest
from scipy.optimize import brentq

import crankstar
from crankstar import spectra
from crankstar.dynamics.bearings import bearing_loads
from crankstar.dynamics.oil_film import Orbit, mobility, orbit
from crankstar.mechanics.gas import cycle
from crankstar.mechanics.side_thrust import rod_speeds, rods_over
from crankstar.spectra import Spectrum

DIAMETER, LENGTH, CLEARANCE, VISCOSITY, SPEED = 0.05, 0.025, 25e-6, 0.01, 300.0


def steady(force: complex) -> Spectrum:
    return Spectrum(np.array([0.0]), np.array([force]), np.array([0j]))


def found(load: Spectrum, *, viscosity: float = VISCOSITY, speed: float = SPEED) -> Orbit:
    return orbit(
        load,
        speed=speed,
        mean_speed=speed / 2,
        diameter=DIAMETER,
        length=LENGTH,
        clearance=CLEARANCE,
        viscosity=viscosity,
    )


def film_force(epsilon: complex, velocity: complex) -> complex:
    """The load that squeezes a short ruptured film, of unit mu, R, c and L: its integral."""
    angle = (np.arange(4000) + 0.5) * (2 * pi / 4000)
    way = np.exp(1j * angle)
    thickness = 1 - np.real(np.conj(epsilon) * way)
    rate = np.real(np.conj(velocity) * way)
    return complex((np.where(rate > 0, rate / thickness**3, 0.0) * way).sum() * 2 * pi / 4000)


@pytest.mark.parametrize("size", [0.0, 0.3, 0.6, 0.85])
@pytest.mark.parametrize("bearing", [0.0, 0.8, 1.6, 2.6])
def test_the_closed_mobility_is_that_of_the_numerical_film(size: float, bearing: float) -> None:
    epsilon = size * np.exp(1j * bearing)
    # the direction of the velocity at which the film pushes back along the real axis
    ways = np.linspace(-1.5, 1.5, 61)
    lean = [np.angle(film_force(epsilon, np.exp(1j * way))) for way in ways]
    low = next(n for n in range(60) if lean[n] * lean[n + 1] <= 0 and abs(lean[n]) < 1)
    way: Any = brentq(
        lambda a: float(np.angle(film_force(epsilon, np.exp(1j * a)))), ways[low], ways[low + 1]
    )
    whole = np.exp(1j * way) / abs(film_force(epsilon, np.exp(1j * way)))
    # with D = 2 and L = 1: 1/(mu L D) M, L/D = 1/2
    assert abs(mobility(epsilon, length_ratio=0.5) / 2 - whole) < 0.1 * abs(whole)


@pytest.mark.many(first=1)
@pytest.mark.parametrize("force", [200.0, 2000.0, 8000.0])
def test_under_a_steady_load_the_journal_is_where_ocvirk_has_it(force: float) -> None:
    answer = found(steady(-force + 0j))
    size = float(np.abs(answer.epsilon).mean())
    assert np.ptp(np.abs(answer.epsilon)) < 1e-3
    pressure = force / (DIAMETER * LENGTH)
    number = (DIAMETER / 2 / CLEARANCE) ** 2 * VISCOSITY * (SPEED / 2 / pi) / pressure
    ocvirk = (1 - size**2) ** 2 / (pi * size * sqrt(pi**2 * (1 - size**2) + 16 * size**2))
    assert number * (LENGTH / DIAMETER) ** 2 == pytest.approx(ocvirk, rel=0.06)
    # it lags behind the load in the sense of rotation by the attitude angle
    attitude = float(np.angle(answer.epsilon.mean() / -1.0))
    assert attitude == pytest.approx(atan2(pi / 4 * sqrt(1 - size**2), size), abs=0.06)


def test_a_journal_that_turns_the_other_way_is_the_mirror_image() -> None:
    load = steady(-2000.0 + 0j)
    sizes = {"diameter": DIAMETER, "length": LENGTH, "clearance": CLEARANCE, "viscosity": 0.01}
    one, other = (orbit(load, speed=SPEED, mean_speed=w, **sizes) for w in (150.0, -150.0))
    assert np.conj(one.epsilon) == pytest.approx(other.epsilon, abs=1e-4)


def test_load_viscosity_and_speed_count_as_one_number() -> None:
    engine = crankstar.load("audi-25-tfsi")
    load = bearing_loads(engine, cycle=cycle(engine)).load[1]
    one = found(load, viscosity=0.01)
    other = found(spectra.scaled(load, 2.0), viscosity=0.02)
    assert one.epsilon == pytest.approx(other.epsilon, abs=1e-5)


def test_thinner_oil_makes_a_thinner_film() -> None:
    engine = crankstar.load("audi-25-tfsi")
    load = bearing_loads(engine, cycle=cycle(engine)).load[1]
    films = [found(load, viscosity=mu).least for mu in (0.004, 0.008, 0.016)]
    assert films[0] < films[1] < films[2]
    assert films[0] > 0
    assert films[2] < CLEARANCE


def vee(**changes: Any) -> Any:
    """A V8 with two rods on each pin, masses and a cycle known."""
    masses = {"cylinder.reciprocating_mass": "600 g", "cylinder.rotating_mass": "450 g"}
    length = {"layout.bore_pitch": "100 mm"}
    return crankstar.load("ford-46-sohc", changes={**masses, **length, **changes})


@pytest.mark.parametrize("sense", ["clockwise", "counter-clockwise"])
def test_a_rod_swings_as_its_direction_turns(sense: str) -> None:
    engine = vee(rotation=sense, firing_order=[])
    theta = np.linspace(0.3, 4.0, 7)
    step = 1e-5
    ahead, behind = (
        np.angle(rods_over(engine, theta + by).direction.place) for by in (step, -step)
    )
    assert rod_speeds(engine, theta) == pytest.approx((ahead - behind) / (2 * step), abs=1e-8)


def test_a_mean_speed_that_does_not_change_may_be_given_step_by_step() -> None:
    load = steady(-2000.0 + 0j)
    sizes = {"diameter": DIAMETER, "length": LENGTH, "clearance": CLEARANCE, "viscosity": 0.01}
    one = orbit(load, speed=SPEED, mean_speed=150.0, **sizes)
    other = orbit(load, speed=SPEED, mean_speed=np.full(12, 150.0), **sizes)
    assert other.epsilon == pytest.approx(one.epsilon, abs=1e-9)


def test_a_big_end_film_is_the_same_seen_from_the_rod() -> None:
    """On the rod the bearing stands still, and the pin turns by as much less."""
    engine = vee()
    loads = bearing_loads(engine, cycle=cycle(engine))
    assert loads.speed is not None
    theta = np.arange(1440) * (4 * pi / 1440)
    swing = rod_speeds(engine, theta)[0]
    lean = np.angle(rods_over(engine, theta).direction.place[0])
    load = loads.big_end[0]
    lines = np.fft.fft(spectra.value(load, theta) * np.exp(-1j * lean)) / theta.size
    number = np.arange(1, 300)
    on_rod = Spectrum(
        np.append(0.0, number / 2), lines[[0, *number]], np.append(0.0, lines[-number])
    )
    assert spectra.value(on_rod, theta[:9]) == pytest.approx(
        spectra.value(load, theta[:9]) * np.exp(-1j * lean[:9]), rel=1e-6
    )
    sizes = {"diameter": 0.053, "length": 0.02, "clearance": 25e-6, "viscosity": 0.008}
    speed = loads.speed
    whole = orbit(load, speed=speed, mean_speed=speed * (1 + swing) / 2, **sizes)
    seen = orbit(on_rod, speed=speed, mean_speed=speed * (1 - swing) / 2, **sizes)
    assert seen.epsilon * np.exp(1j * lean) == pytest.approx(whole.epsilon, abs=2e-4)
    still = orbit(load, speed=speed, mean_speed=speed / 2, **sizes)
    assert abs(still.epsilon - whole.epsilon).max() > 0.01  # the swing counts


def test_the_rods_of_a_pin_share_its_load() -> None:
    engine = vee()
    loads = bearing_loads(engine, cycle=cycle(engine))
    assert [(end.throw, end.cylinder) for end in loads.big_ends[:2]] == [
        (1, number) for number in loads.pins[0].cylinders
    ]
    theta = np.linspace(0, 12, 50)
    both = spectra.value(loads.big_end, theta)[:2].sum(axis=0)
    assert both == pytest.approx(spectra.value(loads.pin, theta)[0], rel=1e-9)
