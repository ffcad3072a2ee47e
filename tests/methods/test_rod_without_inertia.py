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
from crankstar.studies.answers import amplitudes, rests_on
from crankstar.studies.load_answers import bearing_peaks
from crankstar.tables.assumptions import assumption_facts
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


def signed_roll(inertia: float) -> float:
    """Rolling moment of order 1, its sine part, N m, the flywheel taking the inertia torque.

    -w^2 dH/dtheta less the torque -dE/dtheta: H = m (x y' - y x') - I b' of the rod about the crank
    axis, through which the piston passes; E = (m_p x_p'^2 + m (x'^2 + y'^2) + I b'^2) w^2/2.
    """
    radius, rod, speed, mass, centre = 0.0315, 0.1067, 6000 * np.pi / 30, 0.33, 0.033
    theta = np.arange(4096) * (2 * np.pi / 4096)
    lean = np.arcsin(radius / rod * np.sin(theta))
    rate = radius / rod * np.cos(theta) / np.cos(lean)
    up = radius * np.cos(theta) + centre * np.cos(lean)
    right = radius * np.sin(theta) - centre * np.sin(lean)
    rising = -radius * np.sin(theta) - centre * np.sin(lean) * rate
    crossing = radius * np.cos(theta) - centre * np.cos(lean) * rate
    piston = -radius * np.sin(theta) - rod * np.sin(lean) * rate
    momentum = mass * (up * crossing - right * rising) - inertia * rate
    energy = 0.38 * piston**2 + mass * (rising**2 + crossing**2) + inertia * rate**2
    return float(np.mean((momentum - energy / 2) * np.cos(theta)) * 2) * speed**2


@pytest.mark.quick
def test_the_record_has_value_range_and_effect_through_zero() -> None:
    """Between the ends of the range the roll of order 1 changes its sign: its least is zero."""
    engine = engine_of(tomllib.loads(SINGLE))
    [found] = [each for each in rests_on(engine, amplitudes(engine)) if each.status == "doubtful"]
    two = 0.33 * 0.033 * (0.1067 - 0.033)
    row = assumption_facts([found])["rests_on"][0]
    assert row["path"] == "cylinders[1].rod.inertia"
    assert row["unit"] == "kg*m^2"
    ends = [row[key] for key in ("value", "low", "high")]
    assert ends == pytest.approx([two, two / 1.22, two / 0.9735])
    moves = row["moves"]
    assert (moves["quantity"], moves["order"], moves["unit"]) == ("roll", 1.0, "N*m")
    now, low, high = (signed_roll(inertia) for inertia in ends)
    assert low * high < 0
    assert moves["now"] == pytest.approx(abs(now), rel=1e-6)
    assert (low, high) == (pytest.approx(2.8, abs=0.02), pytest.approx(-16.8, abs=0.1))
    assert moves["high"] == pytest.approx(max(abs(low), abs(high)), rel=1e-6)
    assert moves["low"] == pytest.approx(0.0, abs=0.02)


@pytest.mark.quick
def test_rods_alike_are_one_record() -> None:
    """Four rods alike vary together: loads too, and a given inertia that is doubted."""
    four = spoilt(
        SINGLE, layout__throws=["0 deg", "180 deg", "180 deg", "0 deg"], firing_order=[1, 3, 4, 2]
    )
    four["layout"]["bore_pitch"] = "80 mm"
    engine = engine_of(four)
    for answer in (amplitudes(engine), bearing_peaks(engine, lambda _each: None)):
        found = [each for each in rests_on(engine, answer) if each.status == "doubtful"]
        assert [each.path for each in found] == ["cylinder.rod.inertia"]
        assert found[0].moved is not None
    four["cylinder"]["rod"]["inertia"] = "0.003 kg*m^2"
    engine = engine_of(four)
    [found] = [each for each in rests_on(engine, amplitudes(engine)) if each.status == "doubtful"]
    assert found.value == 0.003
    assert found.low == found.high == pytest.approx(8.0265e-4 / 1.0965, rel=1e-4)
    assert found.moved is not None
