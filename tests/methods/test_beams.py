"""Shares of main bearings: the beam against finite elements, the three-moment equation, statics."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray

from crankstar.dynamics.beams import continuous_shares, cut_shares

GAPS = st.lists(st.floats(0.2, 1.0), min_size=1, max_size=7)
ALONG = st.lists(st.floats(-0.3, 1.3), min_size=1, max_size=6)


def by_elements(bearings: list[float], places: list[float], compliance: float) -> NDArray[Any]:
    """Shares [bearing, force] by beam elements with springs at the bearings, EI = 1."""
    nodes = sorted({*bearings, *places}, reverse=True)
    at = {z: 2 * index for index, z in enumerate(nodes)}
    stiffness = np.zeros((2 * len(nodes), 2 * len(nodes)))
    for index, length in enumerate(-np.diff(nodes)):
        s = length
        stiffness[2 * index : 2 * index + 4, 2 * index : 2 * index + 4] += (
            np.array(
                [
                    [12, 6 * s, -12, 6 * s],
                    [6 * s, 4 * s * s, -6 * s, 2 * s * s],
                    [-12, -6 * s, 12, -6 * s],
                    [6 * s, 2 * s * s, -6 * s, 4 * s * s],
                ]
            )
            / s**3
        )
    spring = 1 / (compliance * (bearings[0] - bearings[-1]) ** 3)
    for z in bearings:
        stiffness[at[z], at[z]] += spring
    loads = np.zeros((2 * len(nodes), len(places)))
    for column, z in enumerate(places):
        loads[at[z], column] = 1
    moved = np.linalg.solve(stiffness, loads)
    return spring * moved[[at[z] for z in bearings]]


def placed(gaps: list[float], along: list[float]) -> tuple[list[float], list[float]]:
    """Bearings, front first, and places of forces, in hundredths: none almost at another."""
    bearings = [0.0, *np.cumsum(np.round(gaps, 2)).round(2).tolist()][::-1]
    return bearings, [round(share * bearings[0], 2) for share in along]


@given(GAPS, ALONG, st.floats(1e-3, 1.0))
def test_a_continuous_beam_shares_forces_as_finite_elements_do(
    gaps: list[float], along: list[float], compliance: float
) -> None:
    bearings, places = placed(gaps, along)
    shares = continuous_shares(bearings, places, compliance=compliance)
    assert shares == pytest.approx(by_elements(bearings, places, compliance), abs=1e-6)


@given(GAPS, ALONG, st.sampled_from([0.0, 0.01]))
def test_bearings_carry_the_force_and_its_moment(
    gaps: list[float], along: list[float], compliance: float
) -> None:
    bearings, places = placed(gaps, along)
    for shares in (
        cut_shares(bearings, places),
        continuous_shares(bearings, places, compliance=compliance),
    ):
        assert shares.sum(axis=0) == pytest.approx(np.ones(len(places)), abs=1e-9)
        assert np.array(bearings) @ shares == pytest.approx(places, abs=1e-8)


@given(GAPS.filter(lambda gaps: len(gaps) >= 2), st.floats(0.05, 0.95))
def test_the_moments_over_rigid_bearings_meet_the_three_moment_equation(
    gaps: list[float], share: float
) -> None:
    """Clapeyron: M1 l1 + 2 M2 (l1 + l2) + M3 l2 = -F a b (l1 + a)/l1 for a force in span 1 only."""
    bearings, _ = placed(gaps, [])
    first, second = bearings[0] - bearings[1], bearings[1] - bearings[2]
    a = share * first
    reaction = continuous_shares(bearings, [bearings[0] - a])[:, 0]

    def moment(z: float) -> float:
        ahead = np.maximum(np.array(bearings) - z, 0.0)
        carried, force = float(reaction @ ahead), bearings[0] - a
        return carried - (force - z if force > z else 0.0)

    one, two, three = (moment(z) for z in bearings[:3])
    left = one * first + 2 * two * (first + second) + three * second
    assert left == pytest.approx(-a * (first - a) * (first + a) / first, abs=1e-8)


def test_three_bearings_carry_a_load_between_the_first_two() -> None:
    """Any handbook: 13/32, 11/16 and -3/32 of a force in the middle of one of two equal spans."""
    assert continuous_shares([2, 1, 0], [1.5])[:, 0] * 32 == pytest.approx([13, 22, -3], abs=1e-9)
