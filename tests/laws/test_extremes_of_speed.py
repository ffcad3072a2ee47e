"""Least and greatest speed lie between the samples of a cycle: against a fine integration."""

from __future__ import annotations

from math import degrees, pi

import numpy as np
import pytest
from scipy.integrate import cumulative_simpson
from tests.traced_single import BORE, MASS, RADIUS, ROD, SPEED, pressure, single

from crankstar.dynamics.generator_angle import generator_angle
from crankstar.dynamics.uneven import driven
from crankstar.mechanics.gas import cycle
from crankstar.spectra import Real

WHEEL = 0.31


def fine(theta: Real) -> Real:
    """The speed at a fine grid that ends a cycle after its start, rad/s."""
    height = np.sqrt(ROD**2 - (RADIUS * np.sin(theta)) ** 2)
    rate = RADIUS * np.sin(theta) * (1 + RADIUS * np.cos(theta) / height)
    torque = (pressure(theta) * 1e5 - 101_325.0) * pi / 4 * BORE**2 * rate
    step = theta[1]
    torque = torque - torque[:-1].mean()
    change = cumulative_simpson(torque, dx=step, initial=0.0)
    whole = WHEEL + MASS * rate**2

    def late(energy: float) -> float:
        slow = np.sqrt(whole / (2 * (energy + change)))
        return float(slow[:-1].mean()) * SPEED - 1

    low, high = 0.25 * WHEEL * SPEED**2, WHEEL * SPEED**2
    for _ in range(48):
        middle = (low + high) / 2
        low, high = (middle, high) if late(middle) > 0 else (low, middle)
    return np.sqrt(2 * (low + change) / whole)


def test_the_extremes_of_the_speed_are_those_of_a_fine_integration() -> None:
    engine = single(drive={"inertia": f"{WHEEL} kg*m^2"})
    theta = np.linspace(0.0, 4 * pi, 144_001)
    right = fine(theta)
    found = driven(engine, cycle(engine))
    assert found is not None
    least, least_at, greatest, greatest_at = found.extremes
    assert found.irregularity == pytest.approx(float(np.ptp(right)) / SPEED, rel=5e-7)
    assert (least, greatest) == (
        pytest.approx(right.min(), rel=1e-7),
        pytest.approx(right.max(), rel=1e-7),
    )
    slow, fast = (degrees(theta[place]) for place in (np.argmin(right), np.argmax(right)))
    assert degrees(least_at) == pytest.approx(slow, abs=0.006)
    assert degrees(greatest_at) == pytest.approx(fast, abs=0.006)

    time = cumulative_simpson(1 / right, x=theta, initial=0.0)
    ahead = theta - SPEED * time
    ahead = ahead - float((ahead[:-1] / right[:-1]).mean() / (1 / right[:-1]).mean())
    angle = generator_angle(found)
    assert angle.ends == (
        pytest.approx(ahead.min(), rel=1e-6),
        pytest.approx(ahead.max(), rel=1e-6),
    )
