"""Friction between two operating points: a correlation is that of the speed, not a chord of it."""

from __future__ import annotations

import tomllib
from math import pi

import pytest

from crankstar.dynamics.uneven import friction_apart
from crankstar.engine.engine import Engine
from crankstar.files import engine_of
from crankstar.mechanics.gas import Cycle, cycle
from crankstar.tables.torque import notes

RPM = pi / 30
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
[[gas.point]]
name = "idle"
speed = "800 rpm"
imep = "1.9 bar"
intake_pressure = "0.38 bar"
"""
GIVEN = 'friction_pressure = "1.3 bar"\n'
SHARE = (2600 - 800) / (5500 - 800)
SWEPT = 4 * pi / 4 * 0.086**2 * 0.086


def four(text: str = FOUR) -> Engine:
    return engine_of(tomllib.loads(text))


def correlation(rpm: float) -> float:
    """Heywood's line for motored spark-ignition engines, Pa."""
    n = rpm / 1000
    return (0.97 + 0.15 * n + 0.05 * n * n) * 1e5


def at(engine: Engine, rpm: float, bmep: float | None = None) -> Cycle:
    return cycle(engine, speed=rpm * RPM, bmep=bmep)


def test_a_correlation_is_that_of_the_speed_and_the_indicated_load_goes_straight() -> None:
    found = at(four(), 2600)
    indicated = (1 - SHARE) * 1.9e5 + SHARE * (11e5 + correlation(5500))
    assert found.friction == pytest.approx(correlation(2600), rel=1e-12)
    assert found.imep == pytest.approx(indicated, rel=1e-9)
    assert found.bmep is not None
    assert found.bmep * SWEPT / (4 * pi) == pytest.approx(78.772, abs=5e-4)


def test_a_friction_of_one_point_goes_to_the_correlation_at_the_other() -> None:
    engine = four(FOUR + GIVEN)
    found = at(engine, 2600)
    right = (1 - SHARE) * 1.3e5 + SHARE * correlation(2600)
    assert found.friction == pytest.approx(right, rel=1e-12)
    assert "Friction as of motored spark-ignition engines." in notes(engine, found)


def test_frictions_of_both_points_are_straight_between_them() -> None:
    both = FOUR.replace('bmep = "11 bar"', 'bmep = "11 bar"\nfriction_pressure = "3 bar"') + GIVEN
    assert at(four(both), 2600).friction == pytest.approx((1 - SHARE) * 1.3e5 + SHARE * 3e5)


def test_a_brake_load_that_is_asked_for_comes_out_with_the_friction_of_the_speed() -> None:
    found = at(four(), 2600, bmep=5e5)
    assert found.imep == pytest.approx(5e5 + correlation(2600), rel=1e-9)
    assert found.values["bmep"] == 5e5


def test_friction_stays_apart_between_two_brake_loads() -> None:
    engine = four(FOUR.replace('imep = "1.9 bar"', 'bmep = "1 bar"'))
    for rpm in (800, 2600, 5500):
        right = correlation(rpm) * SWEPT / (4 * pi)
        assert friction_apart(at(engine, rpm)) == pytest.approx(right, rel=1e-12)
    assert friction_apart(at(four(), 2600)) == 0.0  # of the one it is not known
