"""The greatest torque and roll with gas over a cycle are those of all orders."""

from __future__ import annotations

import tomllib
from math import pi

import numpy as np
import pytest

from crankstar.files import engine_of
from crankstar.mechanics.gas import cycle
from crankstar.spectra import Real
from crankstar.studies.gas_results import gas_values

FOUR = """
name = "two-litre four"
firing_order = [1, 3, 4, 2]
speed = "5500 rpm"
[cylinder]
bore = "86 mm"
stroke = "86 mm"
rod_length = "143 mm"
reciprocating_mass = "520 g"
[layout]
type = "inline"
bore_pitch = "94 mm"
[gas]
compression_ratio = 10.5
bmep = "11 bar"
"""


def greatest(curve: Real) -> float:
    """Of the parabola through the highest sample of a periodic curve and its neighbours."""
    place = int(np.argmax(np.abs(curve)))
    before, top, after = (abs(float(curve[(place + step) % curve.size])) for step in (-1, 0, 1))
    return top + (after - before) ** 2 / (8 * (2 * top - before - after))


def test_a_peak_of_torque_with_gas_is_that_of_the_curve() -> None:
    engine = engine_of(tomllib.loads(FOUR))
    burnt = cycle(engine)
    theta = np.arange(3600) * (4 * pi / 3600)
    swing, rod = 0.043, 0.143
    height = np.sqrt(rod**2 - (swing * np.sin(theta)) ** 2)
    sine, cosine = np.sin(theta), np.cos(theta)
    rate = swing * sine + swing**2 * sine * cosine / height  # downward, by the angle
    slope = swing * cosine + swing**2 * np.cos(2 * theta) / height
    slope = slope + (swing**2 * sine * cosine) ** 2 / height**3
    inertia = -0.52 * (5500 * pi / 30) ** 2 * rate * slope
    gas = (burnt.pressure[0] - 101_325.0) * pi / 4 * 0.086**2 * rate
    whole = sum(np.roll(gas + inertia, 900 * fires) for fires in range(4))
    assert isinstance(whole, np.ndarray)
    for what in ("torque_with_gas", "roll_with_gas"):
        cases = [(engine, engine.speed)]
        found, unit, _gaps = gas_values(lambda cases=cases: cases, what, order=None, shape=(1,))
        assert unit == "N*m"
        assert found[0] == pytest.approx(greatest(whole - whole.mean()), rel=2e-6)
