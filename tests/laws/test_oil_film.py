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
