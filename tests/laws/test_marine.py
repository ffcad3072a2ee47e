"""Marine moments: sums of exact pistons, side thrusts in time, compensators as they are written."""

from __future__ import annotations

from math import isclose, pi, sin

import numpy as np
import pytest
from tests.marine import WEIGHTED, marine_engine

import crankstar
from crankstar import spectra
from crankstar.analyses.marine.compensators import compensators, with_compensators
from crankstar.analyses.marine.marine_analysis import marine
from crankstar.engine.engine import Engine
from crankstar.files import engine_of, explicit
from crankstar.mechanics.balance import balance, total
from crankstar.mechanics.external_moments import external_moments, unbalance_class
from crankstar.mechanics.gas import cycle
from crankstar.mechanics.gas_torque import gas_torque, roll_with_gas
from crankstar.mechanics.guide_moments import MarineError, guide_moments
from crankstar.mechanics.side_thrust import side_thrust
from crankstar.remedy.counterweights import RemedyError
from crankstar.remedy.end_weights import with_end_weights
from crankstar.spectra import Complex

SPEED = 104 * pi / 30


def piston_harmonics(*, radius: float, rod: float, highest: int) -> Complex:
    """A_k r w^2 of a piston, from its way over a turn: orders 0 to `highest`, at 1 rad/s."""
    theta = np.arange(4096) * (2 * pi / 4096)
    way = radius * np.cos(theta) + np.sqrt(rod**2 - (radius * np.sin(theta)) ** 2)
    lines = 2 * np.fft.rfft(way)[: highest + 1] / theta.size
    return np.arange(highest + 1) ** 2 * lines


def summed(engine: Engine, order: int, *, about: float = 0.0) -> complex:
    """The vertical moment of an order at 1 rad/s: pistons one by one, as they fire."""
    first = engine.cylinders[0]
    radius = engine.throw(first).radius
    harmonic = piston_harmonics(radius=radius, rod=first.rod_length, highest=order)[order]
    moment = 0j
    for place, number in enumerate(engine.firing_order):
        cylinder = next(each for each in engine.cylinders if each.number == number)
        angle = place * 2 * pi / len(engine.firing_order)
        force = cylinder.reciprocating_mass * harmonic * np.exp(-1j * order * angle)
        moment += (cylinder.z - about) * force
    return moment


@pytest.mark.parametrize("order", [1, 2, 4, 6])
def test_external_moments_are_sums_of_exact_pistons(order: int) -> None:
    engine = marine_engine()
    found = external_moments(engine, speed=SPEED)
    wanted = summed(engine, order) * SPEED**2
    [own] = found.vertical[found.orders == order]
    assert own == pytest.approx(wanted, rel=1e-9)
    assert found.moment(order, "H") == pytest.approx(0, abs=1e-9 * abs(wanted))


def test_free_moments_are_the_same_about_every_point() -> None:
    near, far = (external_moments(marine_engine(), speed=SPEED, about=z) for z in (0.0, -37.0))
    assert far.orders.tolist() == near.orders.tolist() == [1, 2, 4, 6]
    assert not far.pushing
    scale = np.abs(near.vertical).max()
    assert far.vertical == pytest.approx(near.vertical, abs=1e-9 * scale)
    single = marine_engine(firing_order=[1, 2])
    assert 2 in external_moments(single).pushing
    moved = external_moments(single, speed=SPEED, about=-3.0)
    at_middle = external_moments(single, speed=SPEED)
    wanted = at_middle.vertical + 3.0 * at_middle.force_vertical
    assert moved.vertical == pytest.approx(wanted, rel=1e-9)
    assert moved.vertical[moved.orders == 2] == pytest.approx(
        summed(single, 2, about=-3.0) * SPEED**2, rel=1e-9
    )


def test_moments_go_with_the_speed_squared() -> None:
    slow = external_moments(marine_engine(), speed=SPEED)
    fast = external_moments(marine_engine(), speed=1.3 * SPEED)
    assert slow.vertical * slow.at(1.3 * SPEED) == pytest.approx(fast.vertical)


def test_the_classes_of_unbalance_meet_at_their_bounds() -> None:
    bounds = (0, 60, 60.01, 120, 120.01, 220, 220.01)
    words = ("not relevant",) * 2 + ("unlikely",) * 2 + ("likely",) * 2 + ("most likely",)
    assert tuple(map(unbalance_class, bounds)) == words


@pytest.mark.parametrize("share", [0.0, 0.3, 0.5, 1.0])
@pytest.mark.parametrize("more", [{}, WEIGHTED])
def test_end_weights_share_the_moment_of_the_pistons(share: float, more: dict[str, str]) -> None:
    engine = marine_engine(**more)
    pistons = abs(summed(engine, 1)) * SPEED**2
    found = external_moments(with_end_weights(engine, share=share), speed=SPEED)
    assert found.moment(1, "H") == pytest.approx(share * pistons, abs=1e-9 * pistons)
    assert found.moment(1) == pytest.approx((1 - share) * pistons, abs=1e-9 * pistons)
    without = external_moments(engine, speed=SPEED)
    assert found.moment(2) == pytest.approx(without.moment(2))
    assert abs(found.force_vertical[0]) == pytest.approx(0, abs=1e-9 * pistons)


def test_end_weights_are_refused_where_they_could_do_nothing() -> None:
    six = marine_engine(firing_order=[1, 5, 3, 4, 2, 6])
    with pytest.raises(RemedyError, match="no first-order moment"):
        with_end_weights(six, share=0.5)
    with pytest.raises(RemedyError, match="from 0 to 1"):
        with_end_weights(six, share=1.5)


@pytest.mark.parametrize("rotation", ["clockwise", "counter-clockwise"])
@pytest.mark.parametrize("order", [1, 2, 4])
def test_one_compensator_cancels_the_moment_at_the_node(order: int, rotation: str) -> None:
    engine = marine_engine(rotation=rotation)
    node, place = -28.0, 4.5
    [one] = compensators(engine, order=order, places=[place], node=node)
    written = engine_of(explicit(with_compensators(engine, [one])))
    scale = abs(summed(engine, order)) * SPEED**2
    at_node = external_moments(written, speed=SPEED, about=node)
    assert at_node.moment(order) == pytest.approx(0, abs=1e-9 * scale)
    assert at_node.moment(order, "H") == pytest.approx(0, abs=1e-9 * scale)
    # about the middle, the arm from there to the compensator of a force that there was not
    force = scale / (place - node)
    middle = external_moments(written, speed=SPEED)
    assert abs(middle.force_vertical[middle.orders == order][0]) == pytest.approx(force)
    assert middle.moment(order) == pytest.approx(scale - force * place)
    assert 2 * one.unbalance * (order * SPEED) ** 2 == pytest.approx(force)


def test_two_compensators_cancel_it_about_every_point() -> None:
    engine = marine_engine()
    pair = compensators(engine, order=2, places=[5.0, -4.0])
    quiet = with_compensators(engine, pair)
    for about in (0.0, -30.0, 12.0):
        found = external_moments(quiet, speed=SPEED, about=about)
        assert found.moment(2) == pytest.approx(0, abs=1e-3)
        assert found.moment(4) == pytest.approx(external_moments(engine, speed=SPEED).moment(4))


def test_turning_masses_push_as_a_compensator_is_said_to() -> None:
    engine = marine_engine()
    [one] = compensators(engine, order=2, places=[4.5], node=-28.0)
    theta = np.linspace(0, 2 * pi, 50)
    pair = with_compensators(engine, [one]).shafts[-2:]
    push = sum(
        shaft.weights[0].unbalance
        * float(shaft.speed_ratio) ** 2
        * np.exp(1j * (shaft.weights[0].angle + engine.sense * float(shaft.speed_ratio) * theta))
        for shaft in pair
    )
    assert push.real == pytest.approx(np.real(one.force * np.exp(2j * theta)))
    assert push.imag == pytest.approx(np.zeros(50), abs=1e-9)


@pytest.mark.parametrize("late", [0.0, 0.1, -0.3, pi])
def test_a_compensator_out_of_phase_leaves_its_chord(late: float) -> None:
    engine = marine_engine()
    plain = external_moments(engine, speed=SPEED).moment(2)
    asked = {2: (5.0, -4.0)}
    found = marine(engine, speed=SPEED, compensate=asked, phase_error=late)
    assert found.after.moment(2) == pytest.approx(2 * sin(abs(late) / 2) * plain, abs=1e-6)


@pytest.mark.parametrize("late", [0.1, -0.3])
def test_a_compensator_out_of_phase_pushes_late(late: float) -> None:
    engine = marine_engine()
    own = compensators(engine, order=2, places=[5.0, -4.0])
    delayed = compensators(engine, order=2, places=[5.0, -4.0], phase_error=late)
    for one, other in zip(own, delayed, strict=True):
        assert np.angle(other.force / one.force) == pytest.approx(-late)


def test_compensators_that_cannot_be_are_refused() -> None:
    engine = marine_engine()
    with pytest.raises(RemedyError, match="has no arm"):
        compensators(engine, order=2, places=[-28.0], node=-28.0)
    with pytest.raises(RemedyError, match="one place or two"):
        compensators(engine, order=2, places=[1.0, 1.0])
    with pytest.raises(RemedyError, match="no vertical moment of order 3"):
        compensators(engine, order=3, places=[1.0, -1.0])
    with pytest.raises(RemedyError, match="from 1 to 8"):
        compensators(engine, order=9, places=[1.0, -1.0])
    many = compensators(engine, order=2, places=[5.0, -4.0])
    with pytest.raises(RemedyError, match="greatest number is 16"):
        with_compensators(engine, [*many] * 4)


@pytest.mark.parametrize("rotation", ["clockwise", "counter-clockwise"])
def test_guide_moments_are_side_thrusts_at_their_heights(rotation: str) -> None:
    engine = marine_engine(rotation=rotation)
    burning = cycle(engine)
    found = guide_moments(engine, burning)
    thrust = side_thrust(engine, burning, samples=4320)
    radius, rod = engine.throw(engine.first).radius, engine.first.rod_length
    fires = {number: place for place, number in enumerate(engine.firing_order)}
    rolling = []
    for cylinder, push in zip(engine.cylinders, thrust.total, strict=True):
        angle = thrust.theta - fires[cylinder.number] * 2 * pi / 7
        height = radius * np.cos(angle) + np.sqrt(rod**2 - (radius * np.sin(angle)) ** 2)
        # to the thrust side: against the rotation, seen from the front
        rolling.append(-engine.sense * push * height)
    lines = 2 * np.fft.rfft(rolling)[:, 1:25] / thrust.theta.size
    scale = np.abs(lines).max()
    assert found.orders.tolist() == list(range(1, 25))
    assert found.rolling == pytest.approx(lines, abs=2e-4 * scale)
    assert found.h == pytest.approx(lines.sum(axis=0), abs=1e-3 * scale)
    places = np.array([cylinder.z for cylinder in engine.cylinders])
    assert found.bimoment == pytest.approx(places @ lines, abs=5e-3 * scale)


def test_the_couples_sum_to_minus_the_fluctuation_of_the_torque() -> None:
    engine = marine_engine()
    burning = cycle(engine)
    found = guide_moments(engine, burning)
    gas = spectra.amplitude(spectra.selected(gas_torque(burning).total, found.orders))
    turning = spectra.selected(total(balance(engine, speed=burning.speed)).torque, found.orders)
    torque = gas + spectra.amplitude(turning)
    assert found.h == pytest.approx(-engine.sense * torque, abs=1e-9 * np.abs(torque).max())


def test_even_firing_leaves_h_of_one_cylinder_times_their_number() -> None:
    found = guide_moments(marine_engine(), cycle(marine_engine()))
    one, h = np.abs(found.rolling[0]), np.abs(found.h)
    main = found.orders % 7 == 0
    assert h[main] == pytest.approx(7 * one[main])
    assert not h[~main].any()


def test_x_is_one_cylinder_times_the_star_of_couples() -> None:
    engine = marine_engine()
    found = guide_moments(engine, cycle(engine))
    fires = {number: place for place, number in enumerate(engine.firing_order)}
    angles = np.array([fires[each.number] for each in engine.cylinders]) * 2 * pi / 7
    star = np.abs((found.arms * np.exp(-1j * np.outer(found.orders, angles))).sum(axis=1))
    wanted = star * np.abs(found.rolling[0]) / engine.first.rod_length
    assert np.abs(found.x) == pytest.approx(wanted, abs=1e-9 * wanted.max())


def test_several_crankshafts_have_no_guide_moments() -> None:
    two = crankstar.load("jumo-205")
    with pytest.raises(MarineError, match="those of one crankshaft"):
        guide_moments(two, cycle(two))
    found = marine(two)
    assert found.guide is None
    assert "has several" in found.without_guide


def test_power_is_what_the_cycle_leaves_at_the_shaft() -> None:
    engine = marine_engine()
    found = marine(engine)
    assert found.power is not None
    swept = 7 * pi / 4 * 0.6**2 * 2.4
    assert isclose(found.power, 19e5 * swept * SPEED / (2 * pi), rel_tol=1e-3)
    moment = found.after.moment(2)
    assert found.unbalance(moment) == pytest.approx(1e3 * moment / found.power)


def burning_on_one_crankshaft() -> list[str]:
    found: list[str] = []
    for name in crankstar.names():
        engine = crankstar.load(name)
        if engine.gas is not None and len({each.shaft for each in engine.cylinders}) == 1:
            found.append(name)
    return found


@pytest.mark.many(first=17)
@pytest.mark.parametrize("name", burning_on_one_crankshaft())
def test_the_couples_of_any_layout_sum_to_the_roll_of_the_block(name: str) -> None:
    engine = crankstar.load(name)
    burning = cycle(engine)
    found = guide_moments(engine, burning)
    gas = gas_torque(burning).total
    wanted = -engine.sense * spectra.amplitude(spectra.selected(gas, found.orders))
    if found.with_inertia:
        sums = total(balance(engine, speed=burning.speed))
        roll = spectra.selected(roll_with_gas(sums, gas), found.orders)
        wanted = spectra.amplitude(roll)
    assert found.h == pytest.approx(wanted, abs=1e-9 * np.abs(found.rolling).max())
