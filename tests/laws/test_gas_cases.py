"""Gas where features meet: load course and sizing, frame of a set, misfire on a measured trace."""

from __future__ import annotations

from math import pi
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.integrate import solve_ivp
from scipy.interpolate import CubicSpline
from scipy.optimize import brentq

import crankstar
from crankstar.dynamics.uneven import driven, flywheel_for
from crankstar.engine.engine import Engine
from crankstar.mechanics.gas import Cycle, cycle
from crankstar.mechanics.gas_torque import over_cycle

Array = NDArray[Any]
CASES = Path(__file__).parents[1] / "cases"
COUNT = 1440


def felt_inertia(engine: Engine, theta: Array) -> Array:
    """The inertia that the crank of an in-line engine with centred rods feels, by v^2 = J w^2."""
    out = np.zeros_like(theta)
    for cylinder in engine.cylinders:
        throw = engine.throw(cylinder)
        radius, rod, angle = throw.radius, cylinder.rod_length, theta + throw.angle
        root = np.sqrt(rod**2 - (radius * np.sin(angle)) ** 2)
        slope = -radius * np.sin(angle) * (1 + radius * np.cos(angle) / root)
        out = out + cylinder.reciprocating_mass * slope**2
    turning = {(c.shaft, c.throw) for c in engine.cylinders}
    return out + sum(
        engine.shaft(s).throws[t - 1].rotating_mass * engine.shaft(s).throws[t - 1].radius ** 2
        for s, t in turning
    )


class Shot:
    """dw/dtheta = (T_gas - T_L - J' w^2/2)/(J w), integrated until a cycle returns to its speed."""

    def __init__(self, engine: Engine, found: Cycle, flywheel: float, course: Array) -> None:
        self.theta = np.linspace(0.0, 4 * pi, COUNT + 1)
        gas = over_cycle(found, COUNT).sum(axis=0)
        self.inertia = flywheel + felt_inertia(engine, self.theta)
        self.mean = float(found.speed or 0.0)

        def periodic(values: Array) -> CubicSpline:
            closed = np.append(values[:COUNT], values[0])
            return CubicSpline(self.theta, closed, bc_type="periodic")

        torque, felt, shape = map(periodic, (gas, self.inertia, course))
        rise = felt.derivative()
        mean = float(gas.mean())

        def run(start: float) -> Array:
            def slope(at: float, state: Array) -> Array:
                load = mean * shape(at) / course[:COUNT].mean()
                push = torque(at) - load - rise(at) * state[0] ** 2 / 2
                return np.array([push / (felt(at) * state[0])])

            return solve_ivp(
                slope, (0, 4 * pi), [start], t_eval=self.theta, rtol=1e-9, atol=1e-9
            ).y[0]

        # a constant load in the mean comes back from any speed: the mean over time chooses it
        start = brentq(
            lambda one: 1 / (1 / run(one)[:COUNT]).mean() - self.mean,
            0.5 * self.mean,
            1.5 * self.mean,
            xtol=1e-8,
        )
        self.speed = run(start)

    @property
    def irregularity(self) -> float:
        """(max - min)/mean."""
        return float(np.ptp(self.speed)) / self.mean


@pytest.mark.long
def test_a_flywheel_is_sized_for_the_course_of_its_load() -> None:
    engine = crankstar.load(CASES / "four-pump.toml")
    found = cycle(engine)
    wheel = flywheel_for(engine, found, irregularity=0.02)
    assert wheel == pytest.approx(0.9608, rel=1e-4)
    again = driven(engine, found, flywheel=wheel)
    assert again is not None
    assert again.irregularity == pytest.approx(0.02, rel=1e-9)
    course = np.interp(
        np.linspace(0, 720, COUNT, endpoint=False),
        np.arange(0, 720, 90),
        [1.0, 2.0, 1.0, 0.2, 1.0, 2.0, 1.0, 0.2],
        period=720,
    )
    assert Shot(engine, found, wheel, course).irregularity == pytest.approx(0.02, rel=1e-3)
