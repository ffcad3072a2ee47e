"""Orders of a load course are those of the straight pieces between its values."""

from __future__ import annotations

from math import pi

import numpy as np
import pytest

import crankstar
from crankstar import spectra
from crankstar.dynamics.load_reaction import load_reaction
from crankstar.mechanics.gas import cycle
from crankstar.spectra import Real


def reaction(angle: list[float], load: list[float]) -> tuple[Real, Real]:
    """Orders and amplitudes of the reaction, over the mean torque of the load."""
    course = {"load_torque": load, "load_angle": [f"{each:.9f} deg" for each in angle]}
    engine = crankstar.load("audi-25-tfsi", changes={"drive": course})
    burnt = cycle(engine, speed=80.0, imep=2e5)
    found = load_reaction(engine, burnt)
    assert found is not None
    swept = sum(
        pi * (c.bore or 0.0) ** 2 / 4 * 2 * engine.throw(c).radius for c in engine.cylinders
    )
    return found.orders, np.abs(spectra.amplitude(found)) / (burnt.imep * swept / (4 * pi))


def test_orders_of_an_even_course_are_its_own_dft_times_the_square_of_a_sinc() -> None:
    count = 7  # no step of it is a whole number of samples
    load = np.array([3.0, 1.0, 4.0, 1.0, 5.0, 9.0, 2.0])
    orders, found = reaction([720 / count * i for i in range(count)], load.tolist())
    lines = np.round(2 * orders).astype(int)
    right = 2 * np.abs(np.fft.fft(load))[lines % count] / load.sum() * np.sinc(lines / count) ** 2
    assert found == pytest.approx(right, rel=1e-9, abs=1e-12)


def test_orders_of_a_course_that_jumps_are_those_of_a_sawtooth() -> None:
    orders, found = reaction([0.0, 720.0 - 1e-7], [0.0, 2.0])
    assert found == pytest.approx(1 / (pi * orders), rel=1e-7)
