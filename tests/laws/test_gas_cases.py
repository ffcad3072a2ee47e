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
from crankstar.analyses.diagnose.diagnosis import Reading, diagnosed, expected
from crankstar.analyses.genset.generating_set import generating_set
from crankstar.dynamics.uneven import driven, flywheel_for
from crankstar.engine.block import Block
from crankstar.engine.copies import with_values
from crankstar.engine.engine import Engine
from crankstar.mechanics.charge_air import events
from crankstar.mechanics.gas import Cycle, cycle
from crankstar.mechanics.gas_torque import gas_torque, over_cycle
from crankstar.studies.answers import rests_on, summary, torques
from crankstar.studies.assumed_values import assumed_values
from crankstar.studies.fault_kinds import Fault
from crankstar.studies.response_answers import felt
from crankstar.tables.torque_orders import by_order

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
    """dw/dtheta = (T_gas - T_L - J' w^2/2)/(J w), integrated until a cycle returns to its speed.

    Of the mean torque of the gas `friction` (N m) is taken steadily, the rest by the course.
    """

    def __init__(
        self, engine: Engine, found: Cycle, flywheel: float, course: Array, friction: float = 0.0
    ) -> None:
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
                load = friction + (mean - friction) * shape(at) / course[:COUNT].mean()
                push = torque(at) - load - rise(at) * state[0] ** 2 / 2
                return np.array([push / (felt(at) * state[0])])

            return solve_ivp(
                slope, (0, 4 * pi), [start], t_eval=self.theta, rtol=1e-9, atol=1e-9
            ).y[0]

        # a constant load in the mean comes back from any speed: the mean over time chooses it
        start: Any = brentq(
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


@pytest.mark.release
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


@pytest.mark.release
@pytest.mark.parametrize("known", [{"gas.friction_pressure": "2 bar"}, {"gas.bmep": "6 bar"}])
def test_the_load_has_the_brake_torque_where_friction_is_known(known: dict[str, str]) -> None:
    """Both are 8 bar less 2: 0.75 of the course, and a quarter that is steady."""
    own = {"gas.bmep": "6 bar", "gas.imep": None, "gas.friction_pressure": "2 bar"}
    engine = crankstar.load(CASES / "four-pump.toml", changes=own if "gas.bmep" in known else known)
    found = cycle(engine)
    wheel = flywheel_for(engine, found, irregularity=0.02)
    course = np.interp(np.linspace(0, 4 * pi, COUNT + 1), ANGLES, COURSE, period=4 * pi)
    lost = 2e5 * 4 * pi / 4 * 0.1**2 * 0.12 / (4 * pi)
    shot = Shot(engine, found, wheel, course, lost)
    assert shot.irregularity == pytest.approx(0.02, rel=1e-3)
    assert Shot(engine, found, wheel, course).irregularity > 0.021


def of_order(samples: Array, order: float) -> float:
    """The amplitude of an order in samples over a four-stroke cycle."""
    count = samples.size
    angle = np.arange(count) * (4 * pi / count)
    return float(abs(2 / count * (samples * np.exp(-1j * order * angle)).sum()))


@pytest.mark.release
def test_the_frame_of_a_generating_set_gets_what_the_rotor_takes() -> None:
    """J_r dw/dt of rotor and crank, integrated with a steady torque of the stator.

    The angular momentum of rotor and frame together changes by nothing but the stator's mean, so
    the frame gets -J_r dw/dt; pistons that go straight to the axis have no part in it. With a
    heavier rotor the speed is even, and the orders are those of the program.
    """
    engine = crankstar.load(CASES / "genset-four.toml")
    found = cycle(engine)
    rotor = 120.0
    shot = Shot(engine, found, rotor, np.ones(COUNT + 1))
    speed = shot.speed[:COUNT]
    wave = np.fft.rfft(speed)
    slope = np.fft.irfft(wave * 1j * np.fft.rfftfreq(COUNT, 1 / COUNT) / 2, COUNT)
    turning = rotor + sum(t.rotating_mass * t.radius**2 for t in engine.shafts[0].throws)
    frame = -turning * speed * slope
    sums = {each.order: each.one for each in generating_set(engine).sums if each.quantity == "roll"}
    for order, right in ((2.0, 207.69), (4.0, 293.13), (6.0, 127.99)):
        assert of_order(frame, order) == pytest.approx(right, rel=2e-3)
        assert sums[order] == pytest.approx(right, rel=1e-4)


ANGLES = np.arange(8) * (pi / 2)
COURSE = np.array([1.0, 2.0, 1.0, 0.2, 1.0, 2.0, 1.0, 0.2])
"""The load of the pump over its cycle."""


def of_course(order: float) -> float:
    """The amplitude of an order of a load of straight lines, N m, by the changes of its slope.

    f'' is a row of impulses, so that k^2 a_k = |sum of the changes times exp(-i k theta)|/(2 pi).
    """
    slope = (np.roll(COURSE, -1) - COURSE) / (pi / 2)
    steps = slope - np.roll(slope, 1)
    swept = 4 * pi / 4 * 0.1**2 * 0.12
    mean = 8e5 * swept / (4 * pi)  # imep V/(4 pi)
    wave = abs((steps * np.exp(-1j * order * ANGLES)).sum()) / (2 * pi * order**2)
    return float(mean * wave / COURSE.mean())


def test_the_frame_of_a_set_feels_the_course_of_its_load() -> None:
    engine = crankstar.load(CASES / "four-pump.toml")
    sums = {each.order: each.one for each in generating_set(engine).sums if each.quantity == "roll"}
    assert (sums[1.0], sums[3.0]) == pytest.approx((166.75, 18.528), rel=1e-4)
    for order in (1.0, 3.0, 5.0):  # a four has none of these by itself
        assert sums[order] == pytest.approx(of_course(order), rel=3e-4)
    found = cycle(engine)
    waves = by_order(engine, found, gas_torque(found))
    roll, framed = (
        dict(zip(waves.orders, np.abs(wave), strict=True)) for wave in (waves.roll, waves.framed)
    )
    assert roll[1.0] == 0
    assert framed[1.0] == pytest.approx(sums[1.0])


@pytest.mark.parametrize(
    ("changes", "share"),
    [
        ({}, 1.0),  # 8 bar indicated, nothing of friction: the load takes it all
        ({"gas.friction": "none"}, 1.0),
        ({"gas.friction_pressure": "2 bar"}, 0.75),
        ({"gas.friction": "spark-ignition"}, 1 - (0.97 + 0.15 * 1.5 + 0.05 * 1.5**2) / 8),
        ({"gas.imep": None, "gas.bmep": "8 bar"}, 1.0),
        ({"gas.imep": None, "gas.bmep": "4 bar", "gas.friction_pressure": "4 bar"}, 0.5),
    ],
)
def test_the_course_of_a_load_has_the_brake_torque(
    changes: dict[str, str | None], share: float
) -> None:
    engine = crankstar.load(CASES / "four-pump.toml", changes=changes)
    sums = {each.order: each.one for each in generating_set(engine).sums if each.quantity == "roll"}
    for order in (1.0, 3.0):
        assert sums[order] == pytest.approx(share * of_course(order), rel=3e-4)


@pytest.mark.release
def test_friction_that_nobody_gave_counts_with_the_load_and_the_record_says_so() -> None:
    engine = crankstar.load(CASES / "four-pump.toml")
    apart = crankstar.load(CASES / "four-pump.toml", changes={"gas.friction": "spark-ignition"})
    wheel = flywheel_for(apart, cycle(apart), irregularity=0.02)
    answer = torques(engine, cycle, irregularity=0.02)
    rests = [each for each in rests_on(engine, answer) if each.path == "gas.friction"]
    (rest,) = (each for each in rests if dict(each.values)["other"] == each.value)
    assert rest.moved is not None
    assert (rest.moved.quantity, rest.moved.now) == ("flywheel", pytest.approx(0.9608, rel=1e-4))
    assert rest.moved.high == pytest.approx(wheel)
    assert not any(
        each.path == "gas.friction"
        for each in rests_on(apart, torques(apart, cycle, irregularity=0.02))
    )


def test_what_leaves_the_reaction_of_a_load_out_records_it() -> None:
    engine = crankstar.load(CASES / "four-pump.toml")
    weighed = with_values(engine, block=Block(mass=200.0))
    whole = felt(weighed, [], orders=[1.0, 2.0])
    for answer, times in ((summary(engine), 1), (torques(engine, cycle, sums=True), 0), (whole, 1)):
        values = assumed_values(engine, answer)
        rests = [each for each in values if each.path == "drive.load_torque"]
        assert [each.status for each in rests] == ["left out"] * times
        for each in rests:
            assert each.moved is not None
            assert each.moved.order == 1.0
            assert (each.moved.now, each.moved.high) == pytest.approx((0, 166.75), rel=1e-4)


@pytest.mark.release
def test_the_rotor_of_a_set_takes_what_its_frame_feels_of_a_course() -> None:
    """-J dw/dt, integrated with the load; a rotor so heavy that the speed is all but even."""
    engine = crankstar.load(CASES / "four-pump.toml")
    found = cycle(engine)
    rotor = 120.0
    period = np.linspace(0, 4 * pi, COUNT + 1)
    course = np.interp(period, ANGLES, COURSE, period=4 * pi)
    speed = Shot(engine, found, rotor, course).speed[:COUNT]
    wave = np.fft.rfft(speed)
    slope = np.fft.irfft(wave * 1j * np.fft.rfftfreq(COUNT, 1 / COUNT) / 2, COUNT)
    frame = -rotor * speed * slope
    sums = {each.order: each.one for each in generating_set(engine).sums if each.quantity == "roll"}
    most = max(sums.values())
    for order in (1.0, 2.0, 3.0, 4.0):  # the error of the integration is a share of the greatest
        assert of_order(frame, order) == pytest.approx(sums[order], abs=2e-3 * most)


def test_a_misfire_compresses_the_charge_of_the_trace_by_its_own_polytrope() -> None:
    """p V^gamma from 0.4 bar as the intake closes: own volumes, no table of the program."""
    engine = crankstar.load(CASES / "v6-idle-trace.toml")
    found = cycle(engine, speed=700 * pi / 30, off=[3])
    row = found.volumes.numbers.index(3)
    radius, rod, bore, ratio = 0.0795 / 2, 0.146, 0.089, 10.5
    angle = np.arange(found.pressure.shape[1]) * (4 * pi / found.pressure.shape[1])
    height = radius * np.cos(angle) + np.sqrt(rod**2 - (radius * np.sin(angle)) ** 2)
    area = pi / 4 * bore**2
    volume = area * (radius + rod - height) + area * 2 * radius / (ratio - 1)
    own = found.pressure[row] * volume ** found.values["gamma"]
    closed = int(np.argmin(np.abs(angle - 4 * pi + 1.0)))  # 57 degrees before the dead centre
    assert own[closed] == pytest.approx(own[0], rel=1e-9)
    timing = events(engine, float(found.volumes.bottom[found.volumes.kind[row]])).closed
    start = np.interp(timing % (4 * pi), angle, volume)
    expected = 0.4e5 * (start / volume[0]) ** found.values["gamma"]
    assert found.pressure[row, 0] == pytest.approx(expected, rel=1e-3)
    assert found.pressure[row].max() < found.pressure[found.volumes.numbers.index(1)].max()
    assert "intake_pressure" not in found.assumed
    motored = cycle(engine, speed=700 * pi / 30, motored=True)
    assert motored.pressure == pytest.approx(
        np.tile(found.pressure[row], (6, 1)), rel=1e-9, abs=1e-3
    )


def test_the_diagnosis_of_a_misfire_on_a_trace_names_its_cylinder() -> None:
    engine = crankstar.load(CASES / "v6-idle-trace.toml")
    speed = 700 * pi / 30
    places = [(0.2, 0.1, 0.3), (-0.1, -0.2, -0.3)]
    lines = [
        Reading(order, place, axis, 0j, speed, 0)
        for order in (0.5, 1.0, 1.5)
        for place in places
        for axis in (0, 1)
    ]
    heard = expected(engine, lines, [Fault("combustion", 3)])
    lines = [each._replace(velocity=v) for each, v in zip(lines, heard, strict=True)]
    first = diagnosed(engine, lines).suspects[0]
    assert first.faults[0].number == 3
    assert first.faults[0].size == pytest.approx(1.0, rel=1e-6)


def test_weak_pistons_that_leave_their_chamber_nothing_to_burn_are_off() -> None:
    """Two pistons of one chamber that lack 60 and 50 % of it are a misfire, and named as one."""
    engine = crankstar.load("jumo-205")
    key, (upper, lower) = next((key, own) for key, own in engine.chambers.items() if len(own) == 2)
    weak = cycle(engine, weaker={upper.number: 0.6, lower.number: 0.5})
    still = cycle(engine, off=[upper.number])
    assert weak.off == still.off == (key,)
    assert weak.pressure == pytest.approx(still.pressure, rel=1e-12)
