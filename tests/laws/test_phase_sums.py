"""Sums of unknown phases, by closed forms and by lot; the angle of a generator, by time."""

from __future__ import annotations

from math import exp, pi, sqrt

import numpy as np
import pytest
from tests.marine import marine_engine

import crankstar
from crankstar import spectra
from crankstar.analyses.genset.generating_set import generating_set
from crankstar.dynamics.generator_angle import generator_angle
from crankstar.dynamics.uneven import running
from crankstar.engine.engine import Engine
from crankstar.mechanics.balance import balance, total
from crankstar.mechanics.gas import cycle
from crankstar.mechanics.gas_torque import gas_torque
from crankstar.mechanics.phase_sums import (
    exceeded,
    sampled_sums,
    share_within,
    typical_sum,
    worst_sum,
)

DRAWN = 200_000
UNEQUAL = [3.0, 2.0, 2.5, 0.4]


@pytest.mark.parametrize("count", [2, 3, 4, 5, 8, 16])
def test_of_n_engines_the_sum_is_less_than_one_in_one_of_n_and_one(count: int) -> None:
    """A theorem of Kluyver."""
    assert share_within([1.0] * count, 1.0) == pytest.approx(1 / (count + 1), abs=2e-5)


@pytest.mark.many(first=3)
@pytest.mark.parametrize("sizes", [[1.0, 1.0], [2.0, 1.0], [1.0] * 3, [1.0] * 6, UNEQUAL])
@pytest.mark.parametrize("share", [0.2, 0.5, 0.9])
def test_the_closed_form_is_what_lots_give(sizes: list[float], share: float) -> None:
    drawn = sampled_sums(sizes, count=DRAWN)
    low = max(0.0, 2 * max(sizes) - sum(sizes))
    limit = low + share * (worst_sum(sizes) - low)
    within = float((drawn < limit).mean())
    assert share_within(sizes, limit) == pytest.approx(within, abs=4 * 0.5 / sqrt(DRAWN))
    assert sqrt(float((drawn**2).mean())) == pytest.approx(typical_sum(sizes), rel=5e-3)
    assert drawn.max() <= worst_sum(sizes) * (1 + 1e-12)


@pytest.mark.many(first=1)
@pytest.mark.parametrize("sizes", [[1.0, 1.0], [1.0] * 3, [1.0] * 12, UNEQUAL])
@pytest.mark.parametrize("share", [0.5, 0.05, 0.01])
def test_what_is_exceeded_so_often_is_the_inverse(sizes: list[float], share: float) -> None:
    limit = exceeded(sizes, share)
    assert share_within(sizes, limit) == pytest.approx(1 - share, abs=1e-6)
    drawn = sampled_sums(sizes, count=DRAWN, seed=2)
    wanted = 4 * sqrt(share * (1 - share) / DRAWN)
    assert float((drawn > limit).mean()) == pytest.approx(share, abs=wanted)


def test_many_engines_follow_rayleigh() -> None:
    for limit in (3.0, 6.0, 10.0):
        wanted = 1 - exp(-(limit**2) / 40)
        assert share_within([1.0] * 40, limit) == pytest.approx(wanted, abs=5e-3)


def test_one_engine_and_none_are_what_they_are() -> None:
    assert share_within([2.0], 1.9) == 0
    assert share_within([2.0], 2.0) == 1
    assert share_within([], 0.1) == share_within([0.0, 0.0], 0.1) == 1
    assert share_within([5.0, 1.0, 1.0], 2.9) == 0
    assert share_within([1.0, 1.0], 0.0) == 0
    assert exceeded([2.0], 0.05) == exceeded([2.0, 0.0], 0.05) == 2


def five(**more: str) -> Engine:
    return crankstar.load("audi-25-tfsi", changes={"cylinder.reciprocating_mass": "0.6 kg", **more})


def test_the_angle_is_what_the_clock_says() -> None:
    found = running(five(), cycle(five(), speed=80.0, imep=5e5), flywheel=0.1)
    ahead = generator_angle(found).ahead
    step = found.theta[1] - found.theta[0]
    slow = 1 / np.append(found.speed, found.speed[0])
    clock = np.append(0.0, np.cumsum((slow[1:] + slow[:-1]) / 2 * step))[:-1]
    wanted = found.theta - found.theta[0] - found.mean_speed * clock
    wanted -= np.average(wanted, weights=1 / found.speed)
    assert ahead == pytest.approx(wanted, abs=1e-4 * np.abs(wanted).max())
    most = 3 * np.abs(ahead).max()  # between the samples it is a little more
    assert most <= generator_angle(found).electrical(3) == pytest.approx(most, rel=1e-4)


def test_with_a_great_flywheel_each_order_turns_it_by_its_torque() -> None:
    engine, speed, wheel = five(), 150.0, 400.0
    burning = cycle(engine, speed=speed, imep=9e5)
    ahead = generator_angle(running(engine, burning, flywheel=wheel)).ahead
    lines = 2 * np.fft.rfft(ahead) / ahead.size
    gas = spectra.selected(gas_torque(burning).total, [2.5, 5.0])
    moving = spectra.selected(total(balance(engine, speed=speed)).torque, [2.5, 5.0])
    torque = spectra.amplitude(gas) + spectra.amplitude(moving)
    for order, push in zip((2.5, 5.0), torque, strict=True):
        wanted = -push / (wheel * (order * speed) ** 2)
        assert lines[round(2 * order)] == pytest.approx(wanted, rel=5e-3)


def test_sets_on_a_foundation_add_up_order_by_order() -> None:
    engine = marine_engine(cycle="four-stroke", firing_order=[1, 2, 4, 6, 7, 5, 3])
    sums = generating_set(engine, engines=3).sums
    whole = total(balance(engine, speed=engine.speed))
    pitch = {each.order: each for each in sums if each.quantity == "pitch"}
    at = whole.couple.orders.tolist()
    wanted = np.abs(spectra.vertical(whole.couple))
    for order in (1.0, 2.0):
        one = pitch[order]
        assert one.one == pytest.approx(wanted[at.index(order)])
        assert (one.worst, one.typical) == pytest.approx((3 * one.one, sqrt(3) * one.one))
        drawn = sampled_sums([one.one] * 3, count=DRAWN)
        assert one.exceeded == pytest.approx(np.quantile(drawn, [0.95, 0.99]), rel=5e-3)
    assert {each.quantity for each in sums} == {"pitch", "roll"}


def test_the_frequency_is_that_of_the_poles() -> None:
    found = generating_set(five(), speed=50 * pi, flywheel=0.5, pole_pairs=2)
    assert found.frequency == pytest.approx(50)
    assert generating_set(five(), speed=50 * pi, flywheel=0.5).frequency is None
