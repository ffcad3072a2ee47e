"""A rod that is given as mass and centre alone: two masses at its ends, and marked."""

from __future__ import annotations

import tomllib

import numpy as np
import pytest
from tests.texts import spoilt

from crankstar import spectra
from crankstar.files import engine_of
from crankstar.mechanics.balance import balance, total
from crankstar.mechanics.doubts import doubts
from crankstar.tables.conditions import assumed_sentence

SINGLE = """
name = "single, student project"
firing_order = [1]
speed = "6000 rpm"

[cylinder]
stroke = "63 mm"
rod_length = "106.7 mm"
reciprocating_mass = "380 g"
throw_mass = "534.81 g"

[cylinder.rod]
mass = "330 g"
centre = "33 mm"

[layout]
type = "inline"
throws = ["0 deg"]
"""


def roll(text: str, **changes: object) -> spectra.Spectrum:
    engine = engine_of(spoilt(text, **changes))
    return total(balance(engine, speed=engine.speed)).torque


def test_mass_and_centre_of_a_rod_imply_two_masses_at_its_ends() -> None:
    """By the energy of the two masses: T = -d/dtheta of m x'^2/2 w^2, order by order."""
    found = roll(SINGLE)
    radius, rod, speed = 0.0315, 0.1067, 6000 * np.pi / 30
    small = 0.38 + 0.33 * 33 / 106.7
    theta = np.arange(4096) * (2 * np.pi / 4096)
    root = np.sqrt(rod**2 - (radius * np.sin(theta)) ** 2)
    rate = -radius * np.sin(theta) - radius**2 * np.sin(theta) * np.cos(theta) / root
    energy = np.fft.fft(small * rate**2 / 2 * speed**2) / theta.size
    for order, right in ((1.0, 14.26), (2.0, 94.47)):
        by_energy = abs(2 * order * energy[int(order)])
        size = abs(complex(spectra.amplitude(spectra.selected(found, [order]))[0]))
        assert size == pytest.approx(by_energy, rel=1e-9)
        assert size == pytest.approx(right, abs=0.01)


def test_the_implied_inertia_is_that_which_a_file_could_give() -> None:
    implied = 0.33 * 0.033 * (0.1067 - 0.033)
    assert implied == pytest.approx(8.026e-4, rel=1e-4)
    one = roll(SINGLE)
    other = roll(SINGLE, cylinder__rod__inertia=f"{implied!r} kg*m^2")
    assert spectra.amplitude(one) == pytest.approx(spectra.amplitude(other))
    point = roll(SINGLE, cylinder__rod__inertia="0 kg*m^2")
    second = abs(complex(spectra.amplitude(spectra.selected(point, [2.0]))[0]))
    assert second == pytest.approx(108.27, abs=0.01)  # a point, if somebody means one


def test_an_implied_inertia_is_marked_with_its_range() -> None:
    engine = engine_of(tomllib.loads(SINGLE))
    [doubt] = [each for each in doubts(engine) if each.code == "doubt.rod-without-inertia"]
    assert doubt.path == ("cylinders", 0, "rod", "inertia")
    assert doubt.values == {"value": 0.0008026, "low": 0.000658, "high": 0.000824}
    assert "0.82 to 1.03" in assumed_sentence(engine)
    given = engine_of(spoilt(SINGLE, cylinder__rod__inertia="0.00075 kg*m^2"))
    assert assumed_sentence(given) == ""
    assert [each.code for each in doubts(given)] == []
