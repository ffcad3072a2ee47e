"""Torsional vibration as textbooks have it: closed forms, Holzer's table, dampers, firing stars."""

from __future__ import annotations

from math import pi, sqrt

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.optimize import minimize_scalar
from tests.strategies import number
from tests.twisting import row

from crankstar import load
from crankstar.dynamics.crank_stiffness import FORMULAS, throw_stiffness
from crankstar.dynamics.torsion_chain import torsion_chain
from crankstar.dynamics.torsion_excitation import Excitation, firing_phases
from crankstar.dynamics.torsion_modes import holzer, torsion_modes
from crankstar.dynamics.torsion_response import response
from crankstar.engine.torsion import Chain, CrankDimensions, Disc
from crankstar.firing.weighing import vector_sums

MASSES = number(0.05, 30.0)
SPRINGS = number(1e3, 1e7)


@given(MASSES, MASSES, SPRINGS)
def test_two_masses_swing_at_the_root_of_stiffness_over_reduced_inertia(
    one: float, other: float, stiffness: float
) -> None:
    [mode] = torsion_modes(row([one, other], [stiffness]))
    assert mode.speed**2 == pytest.approx(stiffness * (1 / one + 1 / other), rel=1e-9)
    assert mode.shape == pytest.approx([1.0, -one / other], rel=1e-9)


@given(MASSES, MASSES, MASSES, SPRINGS, SPRINGS)
def test_three_masses_swing_as_the_quadratic_says(
    a: float, b: float, c: float, k: float, m: float
) -> None:
    """w^4 - w^2 (k/a + (k + m)/b + m/c) + k m (a + b + c)/(a b c) = 0."""
    sum_, product = k / a + (k + m) / b + m / c, k * m * (a + b + c) / (a * b * c)
    root = sqrt(sum_**2 - 4 * product)
    found = [mode.speed**2 for mode in torsion_modes(row([a, b, c], [k, m]))]
    assert found[1] == pytest.approx((sum_ + root) / 2, rel=1e-9)
    assert found[0] == pytest.approx(2 * product / (sum_ + root), rel=1e-7)


@given(st.integers(2, 30), MASSES, SPRINGS)
def test_equal_masses_in_a_row_have_the_closed_form(
    count: int, inertia: float, stiffness: float
) -> None:
    modes = torsion_modes(row([inertia] * count, [stiffness] * (count - 1)))
    places = np.arange(1, count)
    wanted = 2 * sqrt(stiffness / inertia) * np.sin(pi * places / (2 * count))
    assert [mode.speed for mode in modes] == pytest.approx(wanted, rel=1e-7)
    for mode in modes:
        wave = np.cos(pi * mode.number * (np.arange(count) + 0.5) / count)
        assert mode.shape == pytest.approx(wave / wave[0], abs=1e-6 / abs(wave[0]))


@given(st.integers(2, 6), MASSES, MASSES, SPRINGS)
def test_branches_alike_swing_against_the_hub_or_among_themselves(
    count: int, hub: float, inertia: float, stiffness: float
) -> None:
    """Among themselves as on a hub that stands still, one way fewer than there are branches."""
    discs = [{"name": "hub", "inertia": hub}] + [
        {"name": f"{n}", "inertia": inertia, "to": "hub", "stiffness": stiffness}
        for n in range(count)
    ]
    modes = torsion_modes(torsion_chain(Chain.model_validate({"name": "star", "disc": discs})))
    still = stiffness / inertia
    wanted = [still] * (count - 1) + [still * (1 + count * inertia / hub)]
    assert [mode.speed**2 for mode in modes] == pytest.approx(wanted, rel=1e-7)


@given(MASSES, MASSES, SPRINGS, st.sampled_from(["2", "-3", "5/2", "3/7"]))
def test_two_geared_masses_count_as_their_inertia_times_the_square_of_the_ratio(
    motor: float, fan: float, stiffness: float, ratio: str
) -> None:
    """The fan on its shaft of stiffness k behind a gear without inertia of its own."""
    discs = [
        {"name": "motor", "inertia": motor},
        {
            "name": "fan",
            "inertia": fan,
            "to": "motor",
            "stiffness": stiffness,
            "speed_ratio": ratio,
        },
    ]
    [mode] = torsion_modes(torsion_chain(Chain.model_validate({"name": "pair", "disc": discs})))
    above, _slash, below = ratio.partition("/")
    n = float(above) / float(below or 1)
    wanted = n**2 * stiffness * (1 / motor + 1 / (fan * n**2))
    assert mode.speed**2 == pytest.approx(wanted, rel=1e-9)


def test_holzers_table_of_three_equal_masses_is_as_worked_by_hand() -> None:
    """J = k = 1: w^2 = 1 and 3, the torques 1, 1, 0 and 3, -3, 0."""
    first, second = torsion_modes(row([1.0] * 3, [1.0] * 2))
    for mode, speed, shapes, sums in (
        (first, 1.0, [1, 0, -1], [1, 1, 0]),
        (second, sqrt(3), [1, -2, 1], [3, -3, 0]),
    ):
        assert mode.speed == pytest.approx(speed)
        rows = holzer(row([1.0] * 3, [1.0] * 2), speed=mode.speed)
        assert [each.amplitude for each in rows] == pytest.approx(shapes, abs=1e-9)
        assert [each.sum for each in rows] == pytest.approx(sums, abs=1e-9)
    assert [node.before for node in first.nodes] == [1]  # the middle mass stands still
    assert [node[:2] for node in second.nodes] == [(0, 1), (1, 2)]


def held(ring: float, damping: float) -> float:
    """The greatest turn, over the static one, of a hub with a damper ring; a huge mass holds it."""
    discs = (
        Disc(name="ground", inertia=1e9),
        Disc(name="hub", inertia=1.0, to="ground", stiffness=1.0, loss_factor=0.0),
        Disc(name="ring", inertia=ring, to="hub", damping=damping),
    )
    chain = torsion_chain(Chain(name="viscous damper", discs=discs))
    push = Excitation(np.array([1.0]), np.array([[0j], [1.0 + 0j], [0j]]), None)
    speeds = np.linspace(0.3, 2.0, 4001)
    return float(np.abs(response(chain, push, speeds=speeds).turns[:, 0, 1]).max())


@pytest.mark.parametrize("ring", [0.1, 0.25, 0.5, 1.0])
def test_the_best_untuned_viscous_damper_is_den_hartogs(ring: float) -> None:
    """The least peak is 1 + 2/mu, at a damping of 1/sqrt(2 (1 + mu)(2 + mu)) times 2 mu w.

    J. P. Den Hartog, Mechanical Vibrations, section on the untuned viscous (Houdaille) damper.
    """
    best = 2 * ring / sqrt(2 * (1 + ring) * (2 + ring))
    assert held(ring, best) == pytest.approx(1 + 2 / ring, rel=1e-4)
    found = minimize_scalar(
        lambda damping: held(ring, damping), bounds=(best / 3, best * 3), method="bounded"
    )
    assert found.x == pytest.approx(best, rel=2e-2)
    assert found.fun >= (1 + 2 / ring) * (1 - 1e-4)


def test_a_ring_is_free_in_the_natural_frequencies_and_stands_still() -> None:
    plain = row([1.0, 2.0, 3.0], [1e4, 2e4])
    discs = [Disc(name="0", inertia=1.0), Disc(name="ring", inertia=5.0, to="0", damping=7.0)]
    discs += [
        Disc(name="1", inertia=2.0, to="0", stiffness=1e4),
        Disc(name="2", inertia=3.0, to="1", stiffness=2e4),
    ]
    chain = torsion_chain(Chain(name="with a ring", discs=tuple(discs)))
    for one, other in zip(torsion_modes(plain), torsion_modes(chain), strict=True):
        assert other.speed == pytest.approx(one.speed, rel=1e-9)
        assert other.shape[[0, 2, 3]] == pytest.approx(one.shape, rel=1e-9)
        assert abs(other.shape[1]) < 1e-9


def test_an_eight_that_fires_four_times_a_turn_is_driven_in_order_three() -> None:
    """The shape decides, not the count: a straight shaft would feel multiples of 4 alone."""
    engine = load("v8-cross-plane")
    phases = firing_phases(engine)
    assert phases is not None
    shape = np.cos(pi / 2 * (np.arange(4) + 0.5) / 4.5)
    cylinders = [shape[each.throw - 1] for each in engine.cylinders]
    orders = np.arange(0.5, 8.5, 0.5)
    straight = vector_sums(np.ones(8), phases, orders)
    twisted = vector_sums(cylinders, phases, orders)
    assert orders[straight > 0].tolist() == [4.0, 8.0]
    # throws at 0, 90, 270 and 180 deg: order 3 sees them mirrored, each pin's pair 90 deg apart
    star = shape @ np.exp(3j * np.radians([0, 90, 270, 180]))
    assert twisted[5] == pytest.approx(abs(star) * sqrt(2), rel=1e-9)
    assert twisted[5] > 0.9


@pytest.mark.parametrize("order", [0.5, 1.0, 1.5, 3.0, 5.0, 7.0])
def test_odd_orders_vanish_of_two_rods_on_a_pin_in_opposite_banks(order: float) -> None:
    """Which fire half a turn apart, or one and a half."""
    for gap in (pi, 3 * pi):
        sums = vector_sums([1.0, 1.0], np.array([0.0, gap]), [order])
        assert sums[0] == pytest.approx(2 * abs(np.cos(order * gap / 2)), abs=1e-12)
        assert (sums[0] == 0.0) == (order % 2 == 1)


PLAIN = {
    "journal_diameter": 0.06,
    "journal_length": 0.03,
    "pin_diameter": 0.05,
    "pin_length": 0.025,
    "web_width": 0.08,
    "web_thickness": 0.018,
}


def test_estimated_stiffnesses_are_those_of_the_equivalent_lengths_in_print() -> None:
    """L of diameter D, as handbooks write them: D^4 times lengths over diameters, k = G I/L."""
    radius, modulus = 0.045, 80e9
    journal, pin, web = 0.06**4, 0.05**4, 0.018 * 0.08**3
    lengths = {
        "ker-wilson": (0.03 + 0.4 * 0.06) / journal
        + (0.025 + 0.4 * 0.05) / pin
        + (radius - 0.2 * (0.06 + 0.05)) / web,
        "carter": (0.03 + 0.8 * 0.018) / journal + 0.75 * 0.025 / pin + 1.5 * radius / web,
    }
    for formula, length in lengths.items():
        own = CrankDimensions.model_validate({**PLAIN, "formula": formula})
        wanted = pi * modulus / 32 / length
        assert throw_stiffness(own, radius=radius) == pytest.approx(wanted, rel=1e-12)


def test_timoshenkos_webs_bend_as_beams_of_the_crank_radius() -> None:
    """2 r/B with B = E t w^3/12 and E = 2.6 G; journal and pin as shafts a little longer."""
    own = CrankDimensions.model_validate({**PLAIN, "formula": "timoshenko"})
    modulus, radius = 80e9, 0.045
    bending = 2.6 * modulus * 0.018 * 0.08**3 / 12
    twist = (0.03 + 0.9 * 0.018) / (modulus * pi / 32 * 0.06**4)
    twist += (0.025 + 0.9 * 0.018) / (modulus * pi / 32 * 0.05**4) + 2 * radius / bending
    assert throw_stiffness(own, radius=radius) == pytest.approx(1 / twist, rel=1e-12)


@pytest.mark.parametrize("formula", FORMULAS)
def test_a_stiffness_goes_with_size_and_with_the_shear_modulus(formula: str) -> None:
    own = CrankDimensions.model_validate({**PLAIN, "formula": formula})
    large = CrankDimensions.model_validate(
        {key: 2 * value for key, value in PLAIN.items()} | {"formula": formula}
    )
    small = throw_stiffness(own, radius=0.045)
    assert throw_stiffness(large, radius=0.09) == pytest.approx(8 * small, rel=1e-12)
    iron = own.model_copy(update={"shear_modulus": 65e9})
    assert throw_stiffness(iron, radius=0.045) == pytest.approx(65 / 80 * small, rel=1e-12)
    bored = own.model_copy(update={"journal_bore": 0.03, "pin_bore": 0.02})
    assert throw_stiffness(bored, radius=0.045) < small
