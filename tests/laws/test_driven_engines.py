"""An engine that is driven has no load: its course and exponent are left out, and said to be."""

from __future__ import annotations

from math import pi
from typing import Any

import numpy as np
import pytest

from crankstar.analysis.assumptions import Assumption
from crankstar.dynamics.uneven import driven, flywheel_for
from crankstar.engine.engine import Engine
from crankstar.files import engine_of
from crankstar.mechanics.gas import Cycle, cycle
from crankstar.spectra import Real
from crankstar.studies.answer_parts import narrowed
from crankstar.studies.answers import outlook, rests_on, torques
from crankstar.studies.fault_kinds import Fault
from crankstar.studies.response_answers import felt

RADIUS, ROD, BORE, MASS, WHEEL = 0.045, 0.145, 0.082, 0.48, 0.14
FIRES = {1: 0.0, 3: pi, 4: 2 * pi, 2: 3 * pi}
COUNT = 1440
FOUR: dict[str, Any] = {
    "name": "four, heat release",
    "firing_order": [1, 3, 4, 2],
    "speed": "2500 rpm",
    "cylinder": {
        "bore": "82 mm",
        "stroke": "90 mm",
        "rod_length": "145 mm",
        "reciprocating_mass": "480 g",
    },
    "valves": {
        "intake_opens": "12 deg",
        "intake_closes": "48 deg",
        "exhaust_opens": "52 deg",
        "exhaust_closes": "18 deg",
    },
    "layout": {"type": "inline", "bore_pitch": "91 mm"},
}
GAS = {
    "compression_ratio": 10.8,
    "gamma": 1.31,
    "intake_pressure": "0.95 bar",
    "exhaust_pressure": "1.08 bar",
    "crankcase_pressure": "1.0 bar",
    "combustion_start": "-18 deg",
    "combustion_duration": "58 deg",
    "wiebe_a": 5,
    "wiebe_m": 2,
    "imep": "11.5 bar",
    "friction": "spark-ignition",
}
COURSE = {
    "load_angle": ["0 deg", "180 deg", "360 deg", "540 deg"],
    "load_torque": [1.0, 2.0, 1.0, 2.0],
}
MOTORING = {"imep": "0.6 bar", "intake_pressure": "0.3 bar"}
"""Less than friction takes."""


def tree(gas: dict[str, Any] | None = None, **drive: Any) -> dict[str, Any]:
    """The four with other values of gas, and a drive."""
    own = {key: each for key, each in {**GAS, **(gas or {})}.items() if each is not None}
    return {**FOUR, "gas": own, "drive": {"inertia": "0.14 kg*m^2", **drive}}


def of_paths(found: tuple[Assumption, ...], begun: str) -> dict[str, Assumption]:
    return {each.path: each for each in found if each.path.startswith(begun)}


def slope(theta: Real) -> Real:
    """The way of a piston toward its head per angle after its dead centre, m."""
    side = RADIUS * np.sin(theta)
    return -side - side * RADIUS * np.cos(theta) / np.sqrt(ROD**2 - side**2)


def gas_over(found: Cycle) -> Real:
    """The torque of the pressures over a cycle [angle], by the way of the pistons."""
    steps = found.pressure.shape[-1]
    theta = np.arange(steps) * (4 * pi / steps)
    push = (found.pressure - 1e5) * (pi * BORE**2 / 4) * -slope(theta)
    out = np.zeros(steps)
    for row, number in zip(push, found.volumes.numbers, strict=True):
        out += np.roll(row, round(FIRES[number] / (4 * pi) * steps))
    return out


def test_the_reaction_of_a_load_is_that_of_the_cycle_with_the_fault() -> None:
    engine, order = engine_of(tree(load_exponent=2, **COURSE), name="four"), 1.0
    fault = [Fault("combustion", 2)]
    [rest] = of_paths(rests_on(engine, felt(engine, fault)), "drive").values()
    found = cycle(engine, off=[2])
    torque = gas_over(found)
    wave = 2 * np.fft.rfft(torque)[2] / torque.size
    course = -8 / (3 * pi**2) * _brake(found)  # a triangle from 1 to 2, least at the dead centre
    assert rest.moved is not None
    assert (rest.moved.quantity, rest.moved.order) == ("roll", order)
    assert rest.moved.now == pytest.approx(abs(wave), rel=1e-4)
    assert rest.moved.now == pytest.approx(75.1413, rel=1e-4)
    assert rest.moved.high == pytest.approx(abs(course - wave), rel=1e-4)
    assert rest.moved.high == pytest.approx(94.7975, rel=1e-4)


def test_the_reaction_stands_beside_the_roll_of_the_parts_that_are_heavier() -> None:
    engine = engine_of(tree(**COURSE), name="four")
    fault = [Fault("piston", 2, 0.2)]
    [rest] = of_paths(rests_on(engine, felt(engine, fault)), "drive").values()
    assert rest.moved is not None
    theta = np.arange(COUNT) * (2 * pi / COUNT)
    way = slope(theta)
    bend = np.fft.ifft(1j * np.fft.fftfreq(COUNT, 1 / COUNT) * np.fft.fft(way)).real
    speed = 2500 * pi / 30
    own = 2 * np.fft.fft(0.2 * speed**2 * way * bend)[1] / COUNT * np.exp(-1j * FIRES[2])
    course = -8 / (3 * pi**2) * _brake(cycle(engine))
    assert (rest.moved.order, rest.moved.now) == (1.0, pytest.approx(abs(own), rel=1e-6))
    assert rest.moved.high == pytest.approx(abs(course + own), rel=1e-4)


def _brake(found: Cycle) -> float:
    """The mean torque that is left of the gas by friction, N m."""
    assert found.friction is not None
    return gas_over(found).mean() - found.friction * BORE**2 / 4 * 2 * RADIUS


DRIVEN = [
    pytest.param(tree(MOTORING, load_exponent=2, **COURSE), False, id="less than friction"),
    pytest.param(tree(load_exponent=2, **COURSE), True, id="motored"),
]


@pytest.mark.parametrize(("given", "motored"), DRIVEN)
def test_what_has_a_roll_or_uneven_running_says_that_the_load_is_left_out(
    given: dict[str, Any], motored: bool
) -> None:
    engine = engine_of(given, name="four")

    def make(each: Engine) -> Cycle:
        return cycle(each, motored=motored)

    both = ["drive.load_exponent", "drive.load_torque"]
    for answer, paths in (
        (torques(engine, make), both),
        (torques(engine, make, sums=True), both),
        (torques(engine, make, running=False), both[1:]),
        *([] if motored else [(outlook(engine), both[1:]), (felt(engine, ()), both[1:])]),
    ):
        rests = of_paths(rests_on(engine, answer), "drive.load")
        assert sorted(rests) == paths
        for each in rests.values():
            assert (each.status, each.moved, each.explained) == ("left out", None, True)


def test_a_running_engine_leaves_no_course_and_no_exponent_out() -> None:
    engine = engine_of(tree(load_exponent=2, **COURSE), name="four")
    assert not of_paths(rests_on(engine, torques(engine, cycle, sums=True)), "drive.load")
    without = engine_of(tree(MOTORING), name="four")
    assert not of_paths(rests_on(without, torques(without, cycle)), "drive.load")


@pytest.mark.parametrize("course", [{}, COURSE, {"load_exponent": 2}])
@pytest.mark.parametrize("changed", [MOTORING, {}])
def test_the_brake_torque_rests_on_an_assumed_friction_with_a_course_or_without(
    course: dict[str, Any], changed: dict[str, str]
) -> None:
    """By the correlations of the documents: their mean pressures over the volume swept."""
    engine = engine_of(tree({"friction": None, "ignition": "spark", **changed}, **course), name="")
    found = rests_on(engine, torques(engine, cycle, running=False))
    rests = [each for each in found if each.path == "gas.friction"]
    others = {dict(each.values)["other"]: each.moved for each in rests}
    moved = others["diesel"]
    assert moved is not None
    now, then = (
        gas_over(cycle(engine)).mean() - lost * 1e5 * pi * BORE**2 / 4 * 2 * RADIUS / pi
        for lost in (0.97 + 0.15 * 2.5 + 0.05 * 2.5**2, 0.75 + 0.48 * 2.5 + 0.004 * 7.5**2)
    )
    assert moved.quantity == "brake torque"
    assert (moved.now, moved.high) == pytest.approx((now, then), rel=1e-3)


def integrated(found: Cycle, flywheel: float) -> float:
    """The irregularity by w dw/dtheta = (T - T_m - J' w^2/2)/J, in steps of the crank, by RK4.

    T_m is steady; the first speed such that a cycle takes as long as at the mean speed.
    """
    fine = np.arange(2 * COUNT) * (2 * pi / COUNT)
    torque = gas_over(found)
    torque = np.interp(fine, np.arange(torque.size) * (4 * pi / torque.size), torque, period=4 * pi)
    moving = flywheel + MASS * np.sum([slope(fine - each) ** 2 for each in FIRES.values()], axis=0)
    bend = np.gradient(np.concatenate([moving[-1:], moving, moving[:1]]), fine[1])[1:-1]
    net = (torque - torque.mean()).tolist()
    inertia, bend = moving.tolist(), bend.tolist()
    step, count = 2 * fine[1], fine.size

    def speeds(first: float) -> Real:
        out = [first]
        for place in range(0, count - 2, 2):
            one, two, three = place, place + 1, place + 2
            w = out[-1]

            def pull(at: int, speed: float) -> float:
                return (net[at] - bend[at] * speed**2 / 2) / (inertia[at] * speed)

            a = pull(one, w)
            b = pull(two, w + step / 2 * a)
            c = pull(two, w + step / 2 * b)
            d = pull(three, w + step * c)
            out.append(w + step / 6 * (a + 2 * b + 2 * c + d))
        return np.array(out)

    assert found.speed is not None
    first = found.speed
    for _ in range(9):
        now = speeds(first)
        first *= found.speed * float(np.mean(1 / now))
    return float(np.ptp(speeds(first))) / found.speed


@pytest.mark.parametrize("motored", [False, True])
@pytest.mark.parametrize("exponent", [0.0, 2.0])
def test_a_motor_turns_an_engine_with_a_steady_torque_whatever_its_load_would_be(
    motored: bool, exponent: float
) -> None:
    given = tree({} if motored else MOTORING, load_exponent=exponent, **COURSE)
    engine = engine_of(given, name="four")
    found = cycle(engine, speed=600 * pi / 30, motored=motored)
    running = driven(engine, found)
    assert running is not None
    assert running.irregularity == pytest.approx(integrated(found, WHEEL), rel=1e-4)
    wheel = flywheel_for(engine, found, irregularity=running.irregularity)
    assert wheel == pytest.approx(WHEEL, rel=1e-6)
    assert np.ptp(running.load) < 1e-9 * abs(running.load.mean())


@pytest.mark.parametrize(("quantity", "times"), [("roll", 1), ("peak pressure", 0)])
def test_a_figure_that_is_no_rolling_moment_does_not_speak_of_its_reaction(
    quantity: str, times: int
) -> None:
    engine = engine_of(tree(**COURSE), name="four")
    answer = narrowed(torques(engine, cycle, running=False), [quantity])
    assert len(of_paths(rests_on(engine, answer), "drive.load")) == times
