"""The pressure between its samples: greatest forces of gas are those of the curve, to 1e-6."""

from __future__ import annotations

from math import pi

import numpy as np
import pytest
from tests.traced_single import BORE, MASS, RADIUS, ROD, SPEED, pressure, single

import crankstar
from crankstar import spectra
from crankstar.dynamics.bearings import bearing_loads
from crankstar.mechanics.gas import cycle
from crankstar.mechanics.side_thrust import greatest_side_thrust, pressure_at
from crankstar.spectra import Real


def forces(theta: Real) -> tuple[Real, Real]:
    """Side thrust and force on the crank pin of a textbook's slider-crank, N."""
    lean = np.arcsin(RADIUS / ROD * np.sin(theta))
    swing = RADIUS * np.cos(theta) / (ROD * np.cos(lean))
    second = (-RADIUS * np.sin(theta) + ROD * np.sin(lean) * swing**2) / (ROD * np.cos(lean))
    up = -RADIUS * np.cos(theta) - ROD * (np.cos(lean) * swing**2 + np.sin(lean) * second)
    push = (pressure(theta) * 1e5 - 101_325.0) * pi / 4 * BORE**2 + MASS * up * SPEED**2
    return push * np.tan(lean), np.abs(push / np.cos(lean))


def test_side_thrust_and_pin_load_are_greatest_where_the_curve_of_the_trace_has_them() -> None:
    engine = single()
    found = cycle(engine)
    dense = np.linspace(0.0, 4 * pi, 200_001)
    thrust, pin = forces(dense)
    most = int(np.argmax(np.abs(thrust)))
    one = greatest_side_thrust(engine, found)
    place = int(np.argmax(np.abs(one.total[0])))
    loads = bearing_loads(engine, cycle=found)
    assert abs(one.total[0, place]) == pytest.approx(abs(thrust[most]), rel=1e-6)
    assert one.theta[place] == pytest.approx(dense[most], abs=1e-3)
    assert spectra.peaks(loads.guide)[0] == pytest.approx(abs(thrust[most]), rel=1e-6)
    assert spectra.peaks(loads.pin)[0] == pytest.approx(pin.max(), rel=1e-6)


def test_the_peak_pressure_is_that_of_the_curve() -> None:
    dense = np.linspace(0.0, 4 * pi, 2_000_001)
    whole = float(pressure(dense).max()) * 1e5
    found = cycle(single())
    assert found.peak == pytest.approx(whole, rel=1e-6)
    assert found.pressure.max() < whole * (1 - 1e-6)


def test_a_jump_of_an_ideal_cycle_is_not_overshot() -> None:
    found = cycle(crankstar.load("audi-25-tfsi", changes={"gas.process": "otto"}))
    between = pressure_at(found, np.linspace(0.0, 4 * pi, 50_000))
    assert between.max() <= found.peak * (1 + 1e-4)
    assert between.min() >= found.pressure.min() * (1 - 1e-4)
