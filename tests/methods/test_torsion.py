"""Torsional vibration on other roads: integration in time, other formulas, other programs."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from importlib import import_module
from math import pi
from typing import Any

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from scipy.integrate import solve_ivp
from scipy.linalg import eigh
from tests.strategies import number
from tests.texts import SHORT, spoilt
from tests.twisting import chains, pendulums, pushes, row

from crankstar import load, spectra
from crankstar.analyses.torsion.document import document
from crankstar.analyses.torsion.facts import sentences
from crankstar.analyses.torsion.question import Question
from crankstar.analysis.document import Remarks
from crankstar.dynamics.torsion_analysis import torsion
from crankstar.dynamics.torsion_chain import torsion_chain
from crankstar.dynamics.torsion_criticals import Critical, of_note, strength, stresses
from crankstar.dynamics.torsion_excitation import Excitation, excitation, firing_phases
from crankstar.dynamics.torsion_modes import torsion_modes
from crankstar.dynamics.torsion_response import Response, response
from crankstar.dynamics.torsion_system import TorsionChain
from crankstar.dynamics.torsion_variable import inertia_waves, variable_response
from crankstar.engine.engine import Engine
from crankstar.engine.torsion import Chain, Disc, Pendulum
from crankstar.files import engine_of
from crankstar.firing.weighing import vector_sums
from crankstar.mechanics.balance import balance, total
from crankstar.mechanics.gas import cycle
from crankstar.mechanics.gas_torque import gas_torque
from crankstar.mechanics.kinetic import inertia, mean_inertia, throw_inertia
from crankstar.mechanics.mechanism import mechanism
from crankstar.spectra import Real

SPEED = 150.0
TORSION: dict[str, Any] = {
    "bare_inertia": "0.01 kg*m^2",
    "stiffness": "0.6 MN*m/rad",
    "damping": "2 N*m*s/rad",
    "loss_factor": 0.0,
    "diameter": "60 mm",
    "disc": [
        {"name": "hub", "inertia": "0.01 kg*m^2", "to": "front", "stiffness": "0.4 MN*m/rad"},
        {"name": "ring", "inertia": "0.05 kg*m^2", "to": "hub", "damping": "8 N*m*s/rad"},
        {"name": "flywheel", "inertia": "0.3 kg*m^2", "to": "rear", "stiffness": "0.9 MN*m/rad"},
    ],
}
GAS = {"imep": "10 bar", "compression_ratio": 10, "point": [{"name": "full", "speed": "5000 rpm"}]}


def eight(**more: Any) -> Engine:
    return engine_of(spoilt(SHORT, torsion={**TORSION, **more}, gas=GAS))


def driven(engine: Engine) -> tuple[TorsionChain, Excitation]:
    chain = torsion_chain(engine)
    return chain, excitation(chain, engine, cycle(engine))


def at(found: Response, theta: float) -> tuple[Real, Real]:
    """Turns of the freedoms and their rates by time at a crank angle."""
    chain = found.chain
    first = [chain.freedom.index(freedom) for freedom in range(chain.freedoms)]
    wave = found.turns[0][:, first] / chain.ratio[first]
    phase = np.exp(1j * found.orders * theta)[:, None]
    rate = 1j * (found.orders * found.speeds[0])[:, None]
    return np.real(wave * phase).sum(axis=0), np.real(rate * wave * phase).sum(axis=0)


def returned(
    chain: TorsionChain, found: Response, push: Any, changes: Any = None, tolerance: float = 1e-10
) -> tuple[Real, Real]:
    """The state after a cycle by integration in time, and what it was at its beginning."""
    mass, stiffness, damping = chain.matrices()
    speed = float(found.speeds[0])
    begin = np.concatenate(at(found, 0.0))
    count = chain.freedoms

    def rate(t: float, state: Real) -> Real:
        turns, speeds = state[:count], state[count:]
        torque = push(speed * t) - stiffness @ turns - damping @ speeds
        inertia = np.diag(mass)
        if changes is not None:
            value, slope, bend = changes(speed * t)
            inertia = inertia + value
            torque = torque - speed * slope * speeds - speed**2 * bend * turns / 2
        return np.concatenate([speeds, torque / inertia])

    end = solve_ivp(rate, (0.0, 4 * pi / speed), begin, method="DOP853", rtol=tolerance, atol=1e-15)
    return end.y[:, -1], begin


@pytest.mark.release
def test_a_damped_chain_integrated_in_time_comes_back_to_the_harmonic_answer() -> None:
    chain, push = driven(eight())
    found = response(chain, push, speeds=np.array([SPEED]))
    torque = push.torque(SPEED)

    def pushed(theta: float) -> Real:
        waves = np.real(torque * np.exp(1j * push.orders * theta)).sum(axis=-1)
        return chain.transform.T @ waves

    after, before = returned(chain, found, pushed)
    count = chain.freedoms
    for part in (slice(0, count), slice(count, None)):
        assert after[part] == pytest.approx(before[part], abs=1e-7 * np.abs(before[part]).max())


@pytest.mark.release
def test_the_inertia_of_each_angle_integrated_in_time_comes_back_to_the_harmonic_answer() -> None:
    """Steady torques are added that hold the mean twist, which the harmonic answer leaves out."""
    chain, push = driven(eight())
    found = variable_response(chain, push, speed=SPEED)
    waves, torque = inertia_waves(chain, push), push.torque(SPEED)

    def changes(theta: float) -> tuple[Real, Real, Real]:
        phase = waves * np.exp(1j * push.orders * theta)
        each = (phase, 1j * push.orders * phase, -(push.orders**2) * phase)
        value, slope, bend = (np.real(part).sum(axis=-1) for part in each)
        return value, slope, bend

    steps = np.arange(4096) * (4 * pi / 4096)
    bend_turns = np.mean([changes(x)[2] * at(found, x)[0] for x in steps], axis=0)
    held = SPEED**2 * bend_turns / 2

    def pushed(theta: float) -> Real:
        waves = np.real(torque * np.exp(1j * push.orders * theta)).sum(axis=-1)
        return chain.transform.T @ waves + held

    after, before = returned(chain, found, pushed, changes)
    scale = np.abs(before).max()
    assert after == pytest.approx(before, abs=1e-4 * scale)
    without = response(chain, push, speeds=np.array([SPEED]))
    off = np.concatenate(at(without, 0.0))
    assert np.abs(off - before).max() > 1e-3 * scale  # the models differ by more than that


@given(st.integers(0, 1000), number(50.0, 400.0), number(0.0, 0.5))
def test_the_second_model_fulfils_its_equation_at_every_angle(
    seed: int, speed: float, loss: float
) -> None:
    """Products over the angle, derivatives by order; structural damping as of each order."""
    chain = row([1.0, 0.4, 2.0], [1e5, 2e5], loss_factor=loss)
    push = pushes(chain, seed, orders=(1.0, 2.0, 3.0, 8.0))
    push = replace(push, inertia=30 * (push.inertia if push.inertia is not None else 0))
    found = variable_response(chain, push, speed=speed, lowest=1.0)
    steps = 256
    theta = np.arange(steps) * (2 * pi / steps)

    def over(orders: Real, waves: Any) -> Real:
        return np.real(np.exp(1j * np.outer(theta, orders)) @ waves)

    k = found.orders
    turns, orders = found.turns[0], push.orders
    change = inertia_waves(chain, push).T
    whole = np.diag(chain.matrices()[0]) + over(orders, change)
    bend = over(orders, -(orders[:, None] ** 2) * change)
    momentum = np.fft.rfft(whole * over(k, 1j * k[:, None] * turns), axis=0)[1:9] * 2 / steps
    tilt = np.fft.rfft(bend * over(k, turns), axis=0)[1:9] * 2 / steps
    left = speed**2 * (1j * k[:, None] * momentum + tilt / 2)
    left = left + turns @ chain.complex_stiffness().T
    right = np.zeros_like(left)
    right[orders.astype(int) - 1] = push.torque(speed).T
    assert np.abs(change).max() > 1e-3
    assert left == pytest.approx(right, abs=1e-9 * np.abs(left).max() + 1e-9 * np.abs(right).max())


@given(st.integers(0, 1000), number(50.0, 400.0))
def test_the_second_model_is_the_first_where_the_inertia_hardly_changes(
    seed: int, speed: float
) -> None:
    chain = row([1.0, 0.4, 2.0], [1e5, 2e5], loss_factor=0.1)
    push = pushes(chain, seed, orders=(1.0, 2.0, 3.0))
    assert push.inertia is not None
    apart: list[float] = []
    for share in (1e-3, 1e-4):
        small = replace(push, inertia=(push.inertia * share))
        one = response(chain, small, speeds=np.array([speed])).turns
        other = variable_response(chain, small, speed=speed, lowest=1.0).turns
        apart.append(float(np.abs(other - one).max() / np.abs(one).max()))
    assert apart[0] < 0.1
    assert apart[1] == pytest.approx(apart[0] / 10, rel=0.1)


def test_the_torques_of_all_throws_are_that_of_the_engine() -> None:
    engine = eight()
    _chain, push = driven(engine)
    gas = spectra.amplitude(spectra.selected(gas_torque(cycle(engine)).total, push.orders))
    assert push.gas.sum(axis=0) == pytest.approx(gas, abs=1e-9 * np.abs(push.gas).max())
    whole = total(balance(engine, speed=SPEED)).torque
    moving = spectra.amplitude(spectra.selected(whole, push.orders))
    assert push.inertia is not None
    own = SPEED**2 * push.inertia
    assert own.sum(axis=0) == pytest.approx(moving, abs=1e-9 * np.abs(own).max())
    both = push.torque(np.array([SPEED, 3 * SPEED])).sum(axis=1)
    assert both == pytest.approx(np.array([gas + moving, gas + 9 * moving]), rel=1e-9, abs=1e-6)


def test_bare_throws_with_their_pistons_have_the_inertia_of_the_engine() -> None:
    """Mean and change over the angle, by the kinetic energy of the whole engine."""
    engine = eight()
    chain, push = driven(engine)
    throws = chain.inertia[list(chain.throws)].sum()
    moving = mean_inertia(mechanism(engine)) + throw_inertia(engine)
    assert throws == pytest.approx(4 * 0.01 + moving, rel=1e-12)
    theta = np.linspace(0.0, 6.0, 7)
    waves = inertia_waves(chain, push).sum(axis=0)
    change = np.real(np.exp(1j * np.outer(theta, push.orders)) @ waves)
    assert change == pytest.approx(inertia(engine, theta) - moving, abs=1e-9 * moving)


def test_throws_are_counted_from_the_front_whatever_their_numbers_are() -> None:
    engine = eight(bare_inertia=[f"{n} kg*m^2" for n in (1, 2, 3, 4)])
    shaft = engine.shafts[0]
    numbers = (4, 3, 2, 1)
    turned = shaft.model_copy(update={"throws": tuple(shaft.throws[n - 1] for n in numbers)})
    cylinders = tuple(
        each.model_copy(update={"throw": numbers[each.throw - 1]}) for each in engine.cylinders
    )
    other = engine.model_copy(update={"shafts": (turned,), "cylinders": cylinders})
    one, two = torsion_chain(engine), torsion_chain(other)
    assert one.inertia == pytest.approx(two.inertia, rel=1e-12)
    assert one.cylinders == two.cylinders
    assert one.names[1:3] == ("hub", "throw 1")
    assert one.cylinders[0] == 2


def test_a_slave_rod_works_on_the_throw_of_its_master() -> None:
    own = {"inertia": "1 kg*m^2", "disc": [TORSION["disc"][2]]}
    engine = load("pratt-whitney-wasp", changes={"torsion": own})
    chain = torsion_chain(engine)
    assert set(chain.cylinders) == {0}
    found = excitation(chain, engine, cycle(engine))
    whole = spectra.amplitude(gas_torque(cycle(engine)).total)
    assert found.gas[0] == pytest.approx(whole, abs=1e-9 * np.abs(found.gas).max())


@given(st.data(), st.sampled_from([0.5, 1.0, 2.0, 4.5]))
def test_a_pendulum_is_the_inertia_that_its_own_equation_gives(
    data: st.DataObject, order: float
) -> None:
    """Of hub and swing as two freedoms, the pull of the pendulum's centrifugal force included."""
    own = data.draw(pendulums(("0",)))
    speed, hub = 100.0, 0.7
    w = order * speed
    mass, radius, length = own.count * own.mass, own.radius, own.length
    reach = radius + length
    inertia = np.array([[hub + mass * reach**2, mass * length * reach], [0, mass * length**2]])
    inertia[1, 0] = inertia[0, 1]
    pull = np.array([[0.0, 0.0], [0.0, mass * radius * length * speed**2]])
    assume(abs(1 - order**2 * length / radius) > 1e-3)
    turns = np.linalg.solve(pull - w**2 * inertia, [1.0, 0.0])
    chain = torsion_chain(Chain(name="hub", discs=(Disc(name="0", inertia=hub),), pendulums=(own,)))
    effective = chain.inertias([order])[0, 0]
    assert turns[0] == pytest.approx(-1 / (w**2 * effective), rel=1e-9)


@given(chains(rings=False, damped=False, most=4), st.data())
def test_modes_with_pendulums_are_those_of_hub_and_swing_at_the_critical_speed(
    tree: Chain, data: st.DataObject
) -> None:
    own = data.draw(pendulums(("1",)))
    order = data.draw(st.sampled_from([1.0, 2.0, 3.0]))
    plain = torsion_chain(tree)
    chain = torsion_chain(tree.model_copy(update={"pendulums": (own,)}))
    ratio = float(abs(plain.ratio[1]))
    assume(abs(1 - (order / ratio) ** 2 * own.length / own.radius) > 1e-2)
    for mode in torsion_modes(chain, order=order):
        speed = mode.speed / order * ratio  # of the disc on which the pendulum swings
        mass, stiffness, _damping = plain.matrices()
        count, place = plain.freedoms, plain.freedom[1]
        reach, swung = own.radius + own.length, own.count * own.mass
        whole = np.zeros((count + 1, count + 1))
        whole[:count, :count] = mass
        whole[place, place] += swung * reach**2 * plain.ratio[1] ** 2
        cross = swung * own.length * reach * plain.ratio[1]
        whole[place, count] = whole[count, place] = cross
        whole[count, count] = swung * own.length**2
        held = np.zeros_like(whole)
        held[:count, :count] = stiffness
        held[count, count] = swung * own.radius * own.length * speed**2
        found = np.sqrt(np.abs(eigh(held, whole, eigvals_only=True)))
        assert np.abs(found / mode.speed - 1).min() < 1e-7


@pytest.mark.parametrize("order", [2.0, 2.6, 3.0, 4.0, 6.0])
def test_a_light_disc_with_a_heavy_pendulum_has_the_modes_of_disc_and_swing(order: float) -> None:
    """Above its tuning, at order 2.5, the disc with it is less than nothing: M is not positive."""
    discs = (
        Disc(name="0", inertia=1.0),
        Disc(name="1", inertia=1e-3, to="0", stiffness=4e4),
        Disc(name="2", inertia=2.0, to="1", stiffness=9e4),
    )
    own = Pendulum(on="1", mass=5.0, radius=0.1, length=0.1 / 2.5**2)
    chain = torsion_chain(Chain(name="light", discs=discs, pendulums=(own,)))
    total = chain.inertias([order])[0]
    assert (total[1] < 0) == (order > 2.5)
    w = np.linspace(1.0, 3000.0, 200_001)
    # the twist that the masses before leave, mass by mass: its sign changes are the frequencies
    turn, torque = np.ones_like(w), total[0] * w**2
    for stiffness, own_inertia in ((4e4, total[1]), (9e4, total[2])):
        turn = turn - torque / stiffness
        torque = torque + own_inertia * w**2 * turn
    crossings = w[1:][np.sign(torque[1:]) != np.sign(torque[:-1])]
    found = [mode.speed for mode in torsion_modes(chain, order=order) if mode.speed < 3000]
    assert found == pytest.approx(crossings.tolist(), abs=0.02)


def test_a_pendulum_holds_its_disc_still_at_its_order_and_at_every_speed() -> None:
    own = Pendulum(on="1", mass=0.4, radius=0.09, length=0.09 / 2.5**2)
    discs = (Disc(name="0", inertia=1.0), Disc(name="1", inertia=1.0, to="0", stiffness=1e5))
    chain = torsion_chain(Chain(name="pair", discs=discs, pendulums=(own,)))
    push = Excitation(np.array([2.5, 3.0]), np.array([[0, 0], [5.0 + 0j, 5.0]]), None)
    found = np.abs(response(chain, push, speeds=np.array([20.0, 80.0, 200.0])).turns[..., 1])
    assert (found[:, 0] < 1e-8 * found[:, 1]).all()


def test_a_resonance_of_two_masses_is_the_equilibrium_amplitude_over_the_loss_factor() -> None:
    loss = 0.01
    chain = row([2.0, 3.0], [6e4], loss_factor=loss)
    push = Excitation(np.array([3.0]), np.array([[7.0 + 0j], [0j]]), None)
    [mode] = torsion_modes(chain)
    found = response(chain, push, speeds=np.array([mode.speed / 3]))
    elastic = found.twist[0, 0, 0]
    wanted = 7.0 / (mode.speed**2 * (2 + 3 * (2 / 3) ** 2)) / loss * (1 + 2 / 3)
    assert abs(elastic) == pytest.approx(wanted, rel=1e-9)


def test_stress_is_torque_over_the_modulus_of_a_round_section() -> None:
    found = torsion(eight(), speeds=[SPEED, 2 * SPEED])
    assert found.response is not None
    peak, added = stresses(found.response)
    torque = found.response.peak[0, 0]
    assert peak[0, 0] == pytest.approx(16 * torque / (pi * 0.06**3), rel=1e-9)
    assert np.isnan(peak[0, -1])
    assert (added[:, :3] >= peak[:, :3]).all()


def test_two_banks_on_one_pin_are_a_bank_times_twice_a_cosine() -> None:
    """Of the angle between the firings of a pin, as of a V12 at 60 deg."""
    engine = load("v12-60")
    phases = firing_phases(engine)
    assert phases is not None
    mode = np.cos(pi * (np.arange(6) + 0.5) / 6)
    orders = np.arange(0.5, 12.5, 0.5)
    bank = vector_sums(mode, phases[:6], orders)
    both = vector_sums([*mode, *mode], phases, orders)
    gap = phases[6] - phases[0]
    assert both == pytest.approx(bank * 2 * np.abs(np.cos(orders * gap / 2)), abs=1e-9)


@given(st.integers(3, 12), st.integers(0, 1000))
def test_a_straight_shape_of_even_firing_leaves_multiples_of_half_the_cylinders(
    count: int, seed: int
) -> None:
    phases = np.random.default_rng(seed).permutation(count) * (4 * pi / count)
    orders = np.arange(0.5, 24.5, 0.5)
    sums = vector_sums(np.ones(count), phases, orders)
    main = np.isclose(orders % (count / 2), 0.0)
    assert sums[main] == pytest.approx(count)
    assert (sums[~main] == 0).all()


@pytest.mark.release
@given(chains(rings=False, most=6), st.integers(0, 1000))
def test_opentorsion_finds_the_same_modes_and_response(tree: Chain, seed: int) -> None:
    opentorsion: Any = import_module("opentorsion")  # it takes floats where it says int

    assume(all(disc.stiffness for disc in tree.discs[1:]))
    tree = tree.model_copy(
        update={
            "discs": tuple(
                disc.model_copy(update={"speed_ratio": 1, "loss_factor": 0.0})
                for disc in tree.discs
            )
        }
    )
    chain = torsion_chain(tree)
    discs = [
        opentorsion.Disk(place, I=float(value), c=float(lost))
        for place, (value, lost) in enumerate(
            zip(chain.inertia, chain.absolute_damping, strict=True)
        )
    ]
    shafts = [
        opentorsion.Shaft(s.before, s.after, k=s.stiffness, I=0.0, c=s.damping)
        for s in chain.sections
    ]
    other = opentorsion.Assembly(shafts, disk_elements=discs)
    speeds, _shapes = other.undamped_modal_analysis()
    found = np.array([mode.speed**2 for mode in torsion_modes(chain)])
    assert np.sort(speeds.real)[1:] == pytest.approx(found, rel=1e-9, abs=1e-9 * found.max())
    push = pushes(chain, seed)
    own = response(chain, push, speeds=np.array([SPEED]))
    waves, _rates = other.ss_response(push.torque(SPEED), push.orders * SPEED)
    scale = np.abs(waves).max(axis=0)
    assert (np.abs(own.turns[0].T - waves) < 1e-9 * scale).all()


def test_opentorsion_finds_the_same_frequencies_of_geared_shafts() -> None:
    opentorsion: Any = import_module("opentorsion")  # it takes floats where it says int

    discs = (
        Disc(name="motor", inertia=2.0),
        Disc(name="gear", inertia=0.5, to="motor", stiffness=2e4),
        Disc(name="pinion", inertia=0.1, to="gear", speed_ratio=Fraction(-5, 2)),
        Disc(name="fan", inertia=0.4, to="pinion", stiffness=8e3),
    )
    gear = opentorsion.Gear(1, 0.5, 5.0)
    pinion = opentorsion.Gear(2, 0.1, 2.0, parent=gear)
    other = opentorsion.Assembly(
        [opentorsion.Shaft(0, 1, k=2e4), opentorsion.Shaft(2, 3, k=8e3)],
        disk_elements=[opentorsion.Disk(0, I=2.0), opentorsion.Disk(3, I=0.4)],
        gear_elements=[gear, pinion],
    )
    speeds, _shapes = other.undamped_modal_analysis()
    modes = torsion_modes(torsion_chain(Chain(name="geared", discs=discs)))
    assert np.sort(speeds.real)[1:] == pytest.approx([m.speed**2 for m in modes], rel=1e-9)


def test_what_counts_of_critical_speeds_does_not_depend_on_the_mass_that_is_1() -> None:
    """A soft ring in front swamps all amplitudes of its own mode, and twists the crank little."""
    found = [
        Critical(mode, order, 300.0, 1.0, torque, torque / (speed**2 * inertia))
        for mode, order, torque, speed, inertia in (
            (1, 2, 2.0, 700.0, 0.02),
            (2, 8, 80.0, 3500, 30),
        )
    ]
    again = [
        each._replace(torque=9 * (each.torque or 0.0), equilibrium=(each.equilibrium or 0.0) / 9)
        for each in found
    ]
    assert [strength(each) for each in again] == pytest.approx([strength(each) for each in found])
    assert strength(found[1]) > 0.1 * strength(found[0])
    soft, crank = (each.equilibrium or 0.0 for each in found)
    assert crank < 0.05 * soft
    assert [each.order for each in of_note(found)] == [2, 8]


def six_that_twists(**changes: Any) -> Engine:
    """A six of the catalog with a chain of its own, and what is changed of its file."""
    disc = {"name": "flywheel", "inertia": "0.3 kg*m^2", "to": "rear", "stiffness": "1 MN*m/rad"}
    own = {"inertia": "0.03 kg*m^2", "stiffness": "0.9 MN*m/rad", "disc": [disc]}
    return load("bmw-m52b28", changes={"torsion": own, **changes})


def test_without_gas_no_critical_speed_is_called_the_strongest() -> None:
    """Sums of several modes do not compare: they are counted at whatever mass a shape is 1."""
    found = torsion(load("rolls-royce-six-1928"))
    assert found.cycle is None
    assert found.strongest is None
    assert {each.mode for each in found.noted} == {1}
    assert max(found.noted, key=lambda each: each.vector_sum or 0).order in (3, 6)
    assert torsion(six_that_twists()).strongest is not None
    said = " ".join(sentences(load("rolls-royce-six-1928")))
    assert "depends on the gas" in said
    assert "strongest critical speed is that" not in said


@pytest.mark.release
def test_one_speed_and_some_orders_change_neither_the_range_nor_the_vibration() -> None:
    engine = six_that_twists()
    whole = torsion(engine)
    for other in (torsion(engine, speed=200.0), torsion(engine, orders=[3.0])):
        assert whole.response is not None
        assert other.response is not None
        assert other.speeds.tolist() == whole.speeds.tolist()
        assert np.abs(other.response.peak - whole.response.peak).max() == 0
    assert {each.order for each in torsion(engine, orders=[3.0]).criticals} <= {3.0}
    assert torsion(engine, speed=200.0).criticals == whole.criticals


def test_an_undamped_chain_is_not_asked_at_its_critical_speeds() -> None:
    disc = {"name": "flywheel", "inertia": "0.3 kg*m^2", "to": "rear", "stiffness": "1 MN*m/rad"}
    own = {"inertia": "0.03 kg*m^2", "stiffness": "0.9 MN*m/rad", "disc": [disc], "loss_factor": 0}
    engine = load("bmw-m52b28", changes={"torsion": own})
    found = torsion(engine)
    assert not found.chain.damped
    assert np.ptp(np.diff(found.speeds)) < 1e-9 * found.speeds[-1]
    assert torsion(six_that_twists()).chain.damped
    told = document(engine, found, Question()).for_readers.parts
    words = " ".join(line for each in told if isinstance(each, Remarks) for line in each.lines)
    assert "Nothing damps" in words
