"""Orders of a load course are those of the straight pieces between its values."""

from __future__ import annotations

from math import pi, radians

import numpy as np
import pytest

import crankstar
from crankstar import spectra
from crankstar.dynamics.load_reaction import load_reaction
from crankstar.dynamics.uneven import SAMPLES, load_course
from crankstar.files import EngineFileError
from crankstar.mechanics.doubts import doubts
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


def course_of(angle: list[float], load: list[float]) -> crankstar.Engine:
    course = {"load_torque": load, "load_angle": [f"{each:.9f} deg" for each in angle]}
    return crankstar.load("audi-25-tfsi", changes={"drive": course})


def load_over_cycle(angle: list[float], load: list[float]) -> Real | None:
    engine = course_of(angle, load)
    return load_course(engine, cycle(engine, speed=80.0, imep=9e5))


def mean(angle: list[float], load: list[float]) -> float:
    """Of a course over 720 deg: its trapezia by hand."""
    closed = [*angle, angle[0] + 720], [*load, load[0]]
    return float(np.trapezoid(closed[1], closed[0])) / 720


NEAR = [0.0, 1.0, 2.0, 3.0, 720.0]


@pytest.mark.parametrize(
    ("load", "right"), [([3, 3, 3, -4, 3], -0.49), ([-1, -1, -1, 2, -1], 0.49)]
)
def test_a_course_takes_work_by_its_integral_and_not_by_its_samples(
    load: list[float], right: float
) -> None:
    assert mean(NEAR, load) == pytest.approx(right, abs=0.02)
    if right > 0:
        found = load_over_cycle(NEAR, load)
        assert found is not None
        assert found.mean() == pytest.approx(right / 2, abs=0.01)
        return
    with pytest.raises(EngineFileError) as caught:
        course_of(NEAR, load)
    assert [(fault.code, fault.path) for fault in caught.value.faults] == [
        ("drive.no-load", ("drive", "load_torque"))
    ]
    assert "it must be above 0" in str(caught.value)


@pytest.mark.parametrize(("last", "doubted"), [(-0.1, True), (5.0, False)])
def test_a_course_whose_mean_is_next_to_nothing_is_doubted(last: float, doubted: bool) -> None:
    angle, load = [0.0, 240.0, 480.0], [10.0, -9.8, last]
    assert mean(angle, load) / 10 > 0
    assert (mean(angle, load) / 10 < 0.01) == doubted
    codes = [fault.code for fault in doubts(course_of(angle, load))]
    assert ("doubt.load-course" in codes) == doubted


def test_the_unit_of_a_course_does_not_matter_however_small() -> None:
    (_, one), (orders, other) = (
        reaction([0, 180, 360, 540], [size * each for each in (1, 3, 1, 3)])
        for size in (1.0, 1e-320)
    )
    assert one[orders == 1] > 0.1
    assert other == pytest.approx(one, rel=1e-2, abs=1e-3)  # so small a number has three digits


def test_a_course_shorter_than_a_step_keeps_its_work() -> None:
    found = load_over_cycle([0.1, 0.2, 0.3], [0.0, 7.0, 0.0])
    assert found is not None
    assert found.mean() == pytest.approx(0.1 / 720, rel=1e-9)
    assert np.count_nonzero(found > 1e-9) == 2  # it lies on both sides of an end of a step
    at = np.arange(SAMPLES) * radians(720) / SAMPLES
    even = load_over_cycle([0.0, 360.0], [1.0, 3.0])
    assert even == pytest.approx((1 + tri(at)) / 3, abs=1e-3)


def tri(at: Real) -> Real:
    """From 0 up to 2 in the middle of the cycle, and back."""
    return 2 * (1 - np.abs(at / (2 * pi) - 1))
