"""The sizes of what the model leaves out, each by a second road."""

from __future__ import annotations

from math import pi

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from tests.scripts import script

from crankstar import load, spectra, total
from crankstar.dynamics.torsion_analysis import torsion
from crankstar.dynamics.whirl import body
from crankstar.engine.copies import with_values
from crankstar.mechanics.balance import balance
from crankstar.mechanics.gas import cycle
from crankstar.mechanics.gas_torque import over_cycle

page = script("left_out_page")
FIVE = load(page.FIVE)
RADIUS = 0.0464
TURN = np.arange(7200) * (2 * pi / 7200)


def line(values: np.ndarray, order: float, turns: int = 1) -> complex:
    """The amplitude of an order in values over one or two turns."""
    return complex(np.fft.fft(values)[round(order * turns)] * 2 / values.size)


def test_a_rocking_block_with_a_turning_crank_answers_with_j_over_i() -> None:
    """Two rocking motions of a free body, coupled by the spin, integrated in time."""
    engine = load(page.EIGHT)
    spin, fast = float(torsion(engine).chain.inertia.sum()), 300.0
    inertia = min(body(engine).inertia[:2])

    def rates(time: float, rate: np.ndarray) -> list[float]:
        return [
            (np.cos(fast * time) - spin * fast * rate[1]) / inertia,
            spin * fast * rate[0] / inertia,
        ]

    # the forced answer, of rates that begin on it: (I i w, J w; -J w, I i w) rates = (1, 0)
    matrix = fast * np.array([[1j * inertia, spin], [-spin, 1j * inertia]])
    forced = np.linalg.solve(matrix, [1.0, 0.0])
    found = solve_ivp(rates, (0, 2 * pi / fast), np.real(forced), rtol=1e-10, atol=1e-14)
    assert found.y[:, -1] == pytest.approx(np.real(forced), rel=1e-6)
    couple = spin * fast * abs(forced[0])
    assert couple == pytest.approx(page.gyroscopic() / (1 - page.gyroscopic() ** 2), rel=1e-9)


def test_a_spring_between_piston_and_rod_raises_its_force() -> None:
    rod = FIVE.cylinders[0]
    stiffness = page.STEEL * page.SHANK / rod.rod_length
    vibration = 2 * pi * 4 * 6500 / 60
    # k (x - u) = m w^2 x for a base that moves by u
    moved = stiffness / (stiffness - rod.reciprocating_mass * vibration**2)
    assert moved - 1 == pytest.approx(page.rod_compression(4), rel=0.02)


def test_a_valve_accelerates_as_its_lift_bends() -> None:
    width = np.radians(page.OPEN)
    angle = np.linspace(0, width, 20001)
    lift = page.LIFT / 2 * (1 - np.cos(2 * pi * angle / width))
    bend = np.gradient(np.gradient(lift, angle), angle)
    assert page.VALVE * bend[10:-10].max() / (0.492 * RADIUS) == pytest.approx(
        page.valves(), rel=1e-3
    )


def test_unequal_pistons_shake_a_six_as_drawn_at_random() -> None:
    rng = np.random.default_rng(7)
    angles = np.radians([0, 120, 240, 240, 120, 0])
    masses = page.SCATTER * rng.standard_normal((20_000, 6))
    force = np.abs(masses @ np.exp(1j * angles)) * 0.045 * (6000 * pi / 30) ** 2
    # order 1 of pistons in line: m r w^2 cos(theta + phi), whose amplitude this is
    assert np.sqrt((force**2).mean()) == pytest.approx(page.scatter(6000), rel=0.02)
    assert page.scatter(6000) == pytest.approx(43.5, abs=0.05)


def test_a_pressure_that_swings_below_a_piston_has_order_two() -> None:
    ratio = RADIUS / 0.144
    lever = (
        RADIUS
        * np.sin(TURN)
        * (1 + ratio * np.cos(TURN) / np.sqrt(1 - (ratio * np.sin(TURN)) ** 2))
    )
    area = pi / 4 * 0.0825**2
    torque = abs(line(page.CRANKCASE * np.cos(TURN) * area * lever, 2))
    one = over_cycle(cycle(FIVE))[0]
    gas = abs(line(one, 2, 2))
    assert torque / gas == pytest.approx(page.crankcase(), rel=0.02)


def test_one_cylinder_that_is_weaker_has_half_an_order() -> None:
    torque = over_cycle(cycle(FIVE))
    weak = torque.copy()
    weak[1] *= 1 - page.SPREAD
    before, after = (abs(line(each.sum(axis=0), 0.5, 2)) for each in (torque, weak))
    mean = torque.sum(axis=0).mean()
    assert before < 1e-6 * mean
    assert after / mean == pytest.approx(page.spread(), rel=1e-3)


def test_a_twisted_six_has_a_force_again() -> None:
    """The engine itself with its throws turned as far as they swing."""
    order, swing, force = page.twisted()
    engine = load(page.DIESEL)
    found = torsion(engine)
    assert order == found.noted[0].order
    mode = found.modes[0].shape[list(found.chain.throws)]
    crank = engine.shafts[0]
    throws = sorted(range(6), key=lambda index: -crank.throws[index].z)
    turned = {index: swing * mode[n] / abs(mode).max() for n, index in enumerate(throws)}
    bent = with_values(
        engine,
        firing_order=(),
        shafts=(
            with_values(
                crank,
                throws=tuple(
                    with_values(throw, angle=throw.angle + turned[index])
                    for index, throw in enumerate(crank.throws)
                ),
            ),
            *engine.shafts[1:],
        ),
    )
    first = spectra.selected(total(balance(bent)).force, [1.0])
    assert abs(spectra.vertical(first)[0]) == pytest.approx(force, rel=1e-6)
    again = spectra.selected(total(balance(engine)).force, [1.0])
    assert abs(spectra.vertical(again)[0]) < 1e-9


def test_weight_play_and_an_elastic_block_are_what_the_page_says() -> None:
    assert page.weight(750) == pytest.approx(9.80665 / (RADIUS * (25 * pi) ** 2))
    assert page.play() == pytest.approx(50e-6 / RADIUS)
    # half of 50 um as a cosine of order 2: 4 w^2 times its amplitude
    assert page.slap() == pytest.approx(4 * 25e-6 / RADIUS)
    assert page.block_bending(1 / 3) == pytest.approx(1 / 8)
    order, change, swing = page.unevenness()
    assert swing < 0.1
    assert order == 4.5  # 2 and the 2.5 of a five's gas torque
    # a swing of s at order n makes sidebands of about s/2 (1 + n/2)/2 of an order: some per cent
    assert 0.2 * swing < change < 2 * swing


def test_every_number_of_the_tables_is_printed() -> None:
    shown = page.page("table") + page.page("elsewhere")
    for value in (page.weight(750), page.gyroscopic(), page.valves(), page.twisted()[2]):
        assert f"{value * 100:.2g} %" in shown
    assert "nan" not in shown
    assert "inf" not in shown
