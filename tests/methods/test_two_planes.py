"""Corrections in two planes: statics, influence coefficients of a rotor on springs, positions."""

from __future__ import annotations

import numpy as np
import pytest

from crankstar.analyses.correct.two_planes import (
    effects,
    in_planes,
    influence,
    share_left,
    split,
    static_and_couple,
)
from crankstar.remedy import RemedyError
from crankstar.spectra import Complex, Real


def moments(unbalance: Complex, at: Real) -> tuple[complex, complex]:
    """The resultant, and the moment about z = 0."""
    return complex(unbalance.sum()), complex((unbalance * at).sum())


def test_unbalance_in_other_planes_has_the_same_force_and_moment() -> None:
    measured = np.array([850e-6 * np.exp(0.3j), 400e-6 * np.exp(3.5j)])
    at, planes = np.array([0.0, 0.4]), np.array([0.07, 0.31])
    found = in_planes(measured, at=at.tolist(), planes=planes.tolist())
    assert moments(found, planes) == pytest.approx(moments(measured, at))


def test_static_and_couple_together_are_what_was_measured() -> None:
    """The static unbalance in the middle and a pair in the measuring planes come to both."""
    measured = np.array([2.0 + 1j, -0.5 + 3j])
    static, couple = static_and_couple(measured, at=(0.3, -0.1))
    pair = couple / 0.4
    assert static / 2 + pair == pytest.approx(measured[0])
    assert static / 2 - pair == pytest.approx(measured[1])


def rotor(unbalance: Complex, planes: Real) -> Complex:
    """Velocity at two bearings of a rigid rotor on damped springs, by its equations of motion."""
    mass, inertia, bearings = 30.0, 0.9, np.array([-0.25, 0.3])
    omega, springs, damping = 90.0, np.array([2e5, 2.6e5]), np.array([40.0, 55.0])
    arms = np.stack([np.ones(2), bearings])  # shift of the centre, tilt
    rate = springs + 1j * omega * damping
    stiff = -(omega**2) * np.diag([mass, inertia]) + (arms * rate) @ arms.T
    force = omega**2 * np.array([unbalance.sum(), (unbalance * planes).sum()])
    return 1j * omega * (arms.T @ np.linalg.solve(stiff, force))


def test_trial_runs_find_the_unbalance_of_a_rotor_on_springs() -> None:
    planes = np.array([-0.1, 0.2])
    true = np.array([300e-6 * np.exp(1j), 500e-6 * np.exp(-2j)])
    trials = np.array([200e-6 * np.exp(0.5j), 150e-6 * np.exp(3j)])
    initial = rotor(true, planes)
    runs = np.array([rotor(true + trials[j] * np.eye(2)[j], planes) for j in (0, 1)])
    matrix = influence(initial, trials, runs)
    found = np.linalg.solve(matrix, initial)
    assert found == pytest.approx(true, rel=1e-9)
    assert (effects(initial, runs) > 0.1).all()
    left = rotor(true - 0.9 * found, planes)
    assert np.linalg.solve(matrix, left) == pytest.approx(0.1 * true, rel=1e-6)


def test_coefficients_of_one_rotor_correct_the_next_as_nearly_as_they_hold() -> None:
    """The next rotor on the same springs, its planes where they were, or a little elsewhere."""
    planes, trials = np.array([-0.1, 0.2]), np.array([200e-6, 150e-6j])
    runs = np.array([rotor(trials[j] * np.eye(2)[j], planes) for j in (0, 1)])
    matrix = influence(np.zeros(2), trials, runs)
    other = np.array([-400e-6 + 0j, 250e-6j])
    for off, least, most in ((0.0, -1.0, 1e-9), (0.01, 0.01, 0.1), (0.15, 0.3, 3.0)):
        initial = rotor(other, planes)
        found = np.linalg.solve(matrix, initial)
        assert found == pytest.approx(other, rel=1e-9)
        check = initial + rotor(-found, planes + off)  # weights are fitted so much aside
        assert least < share_left(matrix, initial, check) < most
        rate = np.linalg.norm(matrix, axis=1)
        again = check + rotor(-np.linalg.solve(matrix, check), planes + off)
        worst = np.linalg.norm(again / rate) / np.linalg.norm(initial / rate)
        assert worst < 1.5 * share_left(matrix, initial, check) ** 2 + 1e-9


def test_trial_runs_that_do_not_tell_planes_apart_are_refused() -> None:
    initial = np.array([1.0 + 0j, 2.0])
    effect = np.array([0.3, 0.1j])
    runs = np.array([initial + effect, initial + 1.0001 * effect])
    with pytest.raises(RemedyError, match="do not tell the two planes apart"):
        influence(initial, np.array([1.0, 1.0]), runs)
    with pytest.raises(RemedyError, match="do not tell"):
        influence(initial, np.array([1.0, 1.0]), np.array([initial, initial + effect]))


@pytest.mark.parametrize("angle", np.linspace(0, 2 * np.pi, 17).tolist())
def test_weights_at_allowed_positions_add_up_to_the_correction(angle: float) -> None:
    positions = [0.0, 1.0, 2.5, 4.0, 5.5]
    aim = 3e-4 * np.exp(1j * angle)
    weights = split(aim, positions)
    assert sum(each.unbalance * np.exp(1j * each.angle) for each in weights) == pytest.approx(aim)
    assert all(each.unbalance > 0 for each in weights)
    assert len(weights) <= 2


def test_positions_half_a_turn_apart_are_refused() -> None:
    with pytest.raises(RemedyError, match="half a turn apart"):
        split(-1 + 0j, [0.0, 0.5, 1.0])
