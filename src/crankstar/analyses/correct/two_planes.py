"""Corrections of a rigid rotor in two planes: from unbalance measured in two others, or trial runs.

An unbalance is a vector U = mass x radius x exp(i angle), of the heavy spot. Two of them in planes
at z_1 and z_2 are equivalent to those at the correction planes z_a and z_b with the same resultant
and the same moment about any point,

    U_a + U_b = U_1 + U_2,    z_a U_a + z_b U_b = z_1 U_1 + z_2 U_2.

The resultant is the static unbalance; the couple unbalance is what is left about a point, here the
middle of the measuring planes, C = (z_1 - z_2)(U_1 - U_2)/2. What is to be added in each correction
plane is -U.

Runs with trial weights need no scale. Vibration at two bearings is V = H U, H the influence
coefficients; of an initial run V_0 and one run each with a trial unbalance T_j in plane j alone,

    H_kj = (V_kj - V_k0) / T_j,    U = H^-1 V_0,    left over after correction: U' = H^-1 V'.

Coefficients that are known from other runs of a machine, or from a rotor of the same type, need the
initial run alone. With H' as they really are, a correction by H leaves

    V' = (1 - H' H^-1) V_0,

so that the share that is left says how far they are off.

Angles of weights and phases of vibration must be counted in the same direction, both with the
rotation or both against it.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from crankstar.remedy.counterweights import RemedyError
from crankstar.spectra import Complex, Real

WORST = 100.0
"""Condition of H from which a small error of a reading is a large one of a correction."""
LEAST_EFFECT = 0.1
"""Share of the vibration before by which a trial weight should change it, at one bearing."""
HOLDS = 0.3
"""Share of the vibration left up to which coefficients hold: a second correction leaves a tenth."""

ROUNDING = 1e-12
"""Share of what is added up below which a sum is nought."""


class Split(NamedTuple):
    """A weight at an allowed position: its angle [rad] and its unbalance [kg m]."""

    angle: float
    unbalance: float


def static_and_couple(unbalance: Complex, *, at: Sequence[float]) -> tuple[complex, complex]:
    """The static unbalance [kg m] and the couple unbalance [kg m^2] about the middle.

    >>> static, couple = static_and_couple(np.array([2 + 0j, -2 + 0j]), at=(0.3, -0.1))
    >>> static, round(couple.real, 9)  # a pair of 2 kg m with an arm of 0.4 m
    (0j, 0.8)
    """
    first, second = (complex(each) for each in unbalance)
    size = abs(first) + abs(second)
    still, twist = (_not_rounding(each, size) for each in (first + second, first - second))
    return still, (at[0] - at[1]) / 2 * twist


def _not_rounding(value: complex, size: float) -> complex:
    return value if abs(value) > ROUNDING * size else 0j


def in_planes(unbalance: Complex, *, at: Sequence[float], planes: Sequence[float]) -> Complex:
    """The unbalance in the correction planes that is equivalent to that measured in two others.

    Raises RemedyError for two planes at one place.

    >>> in_planes(np.array([1.0, 0.0]), at=(0.0, 0.4), planes=(0.1, 0.3)).round(9).tolist()
    [1.5, -0.5]
    """
    if abs(planes[0] - planes[1]) < 1e-9:
        raise RemedyError(
            "the two correction planes are at one place, where no couple can be corrected; give "
            "planes apart"
        )
    found = np.linalg.solve(
        np.array([[1.0, 1.0], [planes[0], planes[1]]]),
        np.array([unbalance[0] + unbalance[1], at[0] * unbalance[0] + at[1] * unbalance[1]]),
    )
    size = float(np.abs(unbalance).sum() + np.abs(found).sum())
    return np.where(np.abs(found) > ROUNDING * size, found, 0)


def influence(initial: Complex, trials: Complex, runs: Complex) -> Complex:
    """H [bearing, plane] of the vibration before, trial unbalances, and runs [plane, bearing].

    Raises RemedyError where the runs do not tell the planes apart.

    >>> true = np.array([[2.0, 0.5j], [0.3, 1.0]])
    >>> before, trials = np.array([1.0, 2.0]), np.array([0.1, 0.2j])
    >>> runs = np.array([before + true[:, j] * trials[j] for j in (0, 1)])
    >>> bool(np.allclose(influence(before, trials, runs), true))
    True
    """
    found = ((runs - initial) / np.asarray(trials)[:, None]).T
    return told_apart(found)


def told_apart(found: Complex) -> Complex:
    """H [bearing, plane], where it tells the planes apart. Raises RemedyError."""
    sizes = np.linalg.norm(found, axis=0)
    if not sizes.all() or np.linalg.cond(found / np.where(sizes, sizes, 1.0)) > WORST:
        raise RemedyError(
            "the influence coefficients do not tell the two planes apart: a weight in one changes "
            "both bearings as one in the other does; take planes farther apart, or another speed"
        )
    return found


def share_left(matrix: Complex, initial: Complex, check: Complex) -> float:
    """The vibration of a check run as a share of that before.

    Each bearing counts by how much an unbalance moves it, whatever its unit.

    >>> share_left(np.array([[2.0, 0], [0, 1.0]]), np.array([2.0, 1.0]), np.array([0.2, 0.1j]))
    0.1
    """
    moves = np.linalg.norm(matrix, axis=1)
    left, before = (float(np.linalg.norm(each / moves)) for each in (check, initial))
    return left / before


def effects(initial: Complex, runs: Complex) -> Real:
    """The share by which each trial weight changes the vibration, where it does most [plane]."""
    size = np.where(np.abs(initial) > 0, np.abs(initial), np.inf)
    return (np.abs(runs - initial) / size).max(axis=1)


def split(correction: complex, positions: Sequence[float]) -> tuple[Split, ...]:
    """A correction [kg m] as weights at the two allowed positions on both sides of its angle.

    Raises RemedyError where no two positions have less than half a turn between them there.

    >>> two = split(1j, [0.0, np.pi / 4, 3 * np.pi / 4])
    >>> [round(each.unbalance, 6) for each in two]
    [0.707107, 0.707107]
    """
    if not correction:
        return ()
    aim = float(np.angle(correction))
    turns = sorted((float(each - aim) % (2 * np.pi), float(each)) for each in positions)
    if turns and min(turns[0][0], 2 * np.pi - turns[-1][0]) < 1e-9:
        at = turns[0][1] if turns[0][0] < 1e-9 else turns[-1][1]
        return (Split(at, abs(correction)),)
    if len(turns) < 2 or turns[0][0] + 2 * np.pi - turns[-1][0] >= np.pi - 1e-9:
        raise RemedyError(
            "the correction at {angle} deg cannot be made at these positions: those on both sides "
            "of it are half a turn apart or more; give more positions",
            angle=f"{np.degrees(aim) % 360:.1f}",
        )
    pair = (turns[-1][1], turns[0][1])
    ways = np.exp(1j * np.array(pair))
    amounts = np.linalg.solve(
        np.array([np.real(ways), np.imag(ways)]), np.array([correction.real, correction.imag])
    )
    return tuple(Split(angle, float(size)) for angle, size in zip(pair, amounts, strict=True))
