"""A second-order cone programme of weights, solved, and the lower bound that proves it.

    minimise t    over x [n] and t    with    c + |A x + b| <= t    for the cones of the aim,
                                              c + |A x + b| <= L    for those of a limit L,
                                              |x_j| <= B            for the pair of every plane.

For any l_i >= |v_i| with sum l_i = 1 over the cones of the aim, and any m_i >= |w_i| over those of
limits, every feasible x has

    t >= sum l_i c_i + v_i b_i + sum m_i (c_i - L_i) + w_i b_i - B sum_j |g_j|,
    g = sum A_i' v_i + sum A_i' w_i,

which is the lower bound; the multipliers may come from anywhere. They come from Clarabel, which
solves the programme.

Source: P. J. Goulart, Y. Chen, Clarabel, arXiv:2405.12762.
"""

from __future__ import annotations

from collections.abc import Sequence
from importlib import import_module
from typing import Any, NamedTuple

import numpy as np

from crankstar.spectra import Real

ROUNDING = 1e-10
"""Share of the greatest unbalance below which what is to be balanced is rounding."""
PRECISION = 1e-11


class Cone(NamedTuple):
    """One norm, `offset + |matrix x + shift|`; x has up and right of each unbalance in turn."""

    matrix: Real
    shift: Real
    offset: float = 0.0

    def at(self, x: Real) -> float:
        """The norm for these x."""
        return self.offset + float(np.linalg.norm(self.matrix @ x + self.shift))


class Ceiling(NamedTuple):
    """Cones with an upper limit."""

    cones: Sequence[Cone]
    limit: float


class Solution(NamedTuple):
    """The best x, or None where no x is within the limits, and a lower bound of t."""

    x: Real | None
    bound: float


class MissingSolverError(ImportError):
    """Clarabel is not installed."""


def solved(aim: Sequence[Cone], ceilings: Sequence[Ceiling], *, greatest: float) -> Solution:
    """The least t, with its lower bound. `greatest` is B. Raises MissingSolverError."""
    count = aim[0].matrix.shape[1]
    scale = max(float(np.linalg.norm(cone.shift)) for cone in aim) or 1.0
    x = _least_squares(aim)
    within = all(cone.at(x) <= ceiling.limit for ceiling in ceilings for cone in ceiling.cones)
    if within and np.abs(x.reshape(-1, 2) @ [1, 1j]).max(initial=0.0) <= greatest:
        if max(cone.at(x) for cone in aim) <= 1e-14 * scale:
            return Solution(x, 0.0)
        if len(aim) == 1:
            residual = aim[0].matrix @ x + aim[0].shift
            multipliers = [np.append(1.0, residual / np.linalg.norm(residual))]
            return Solution(x, lower_bound(aim, [], multipliers, greatest=greatest))
    optimum = _interior_point(aim, ceilings, greatest, count)
    if optimum is None:
        return Solution(None, 0.0)
    x, multipliers = optimum
    bounds = [
        lower_bound(aim, ceilings, feasible, greatest=greatest)
        for feasible in (multipliers, _closed(aim, ceilings, x, multipliers, greatest))
    ]
    return Solution(x, max(bounds))


def _closed(
    aim: Sequence[Cone],
    ceilings: Sequence[Ceiling],
    x: Real,
    multipliers: Sequence[Real],
    greatest: float,
) -> list[Real]:
    """The solver's multipliers, corrected so that g is zero but for planes at their limit."""
    every = [*aim, *(cone for ceiling in ceilings for cone in ceiling.cones)]
    free = np.repeat(np.abs(x.reshape(-1, 2) @ [1, 1j]) < greatest * (1 - 1e-6), 2)
    slope = sum(
        (
            cone.matrix.T @ multiplier[1:]
            for cone, multiplier in zip(every, multipliers, strict=True)
        ),
        np.zeros(free.size),
    )
    sizes = [abs(float(multiplier[0])) for multiplier in multipliers]
    normal = sum(
        (size * cone.matrix.T @ cone.matrix for cone, size in zip(every, sizes, strict=True)),
        np.zeros((free.size, free.size)),
    )
    step = np.zeros(free.size)
    step[free] = np.linalg.lstsq(normal[np.ix_(free, free)], -slope[free], rcond=1e-14)[0]
    return [
        np.append(multiplier[0], multiplier[1:] + size * (cone.matrix @ step))
        for cone, multiplier, size in zip(every, multipliers, sizes, strict=True)
    ]


def _least_squares(aim: Sequence[Cone]) -> Real:
    """The shortest x that makes the sum of squares of all norms least."""
    matrix = np.concatenate([cone.matrix for cone in aim])
    shift = np.concatenate([cone.shift for cone in aim])
    return np.linalg.lstsq(matrix, -shift, rcond=1e-12)[0]


def lower_bound(
    aim: Sequence[Cone],
    ceilings: Sequence[Ceiling],
    multipliers: Sequence[Real],
    *,
    greatest: float,
) -> float:
    """A lower bound of t from any multipliers (l, v) of the cones, those of the aim first."""
    limited = [(cone, ceiling.limit) for ceiling in ceilings for cone in ceiling.cones]
    total = sum(
        float(max(multiplier[0], np.linalg.norm(multiplier[1:])))
        for multiplier in multipliers[: len(aim)]
    )
    if not total > 0:
        return 0.0
    constant, slope = 0.0, np.zeros(aim[0].matrix.shape[1])
    for (cone, limit), multiplier in zip(
        [*((cone, 0.0) for cone in aim), *limited], multipliers, strict=True
    ):
        vector = multiplier[1:] / total
        constant += float(max(multiplier[0] / total, np.linalg.norm(vector))) * (
            cone.offset - limit
        ) + float(vector @ cone.shift)
        slope += cone.matrix.T @ vector
    return constant - greatest * float(np.abs(slope.reshape(-1, 2) @ [1, 1j]).sum())


def _interior_point(
    aim: Sequence[Cone], ceilings: Sequence[Ceiling], greatest: float, count: int
) -> tuple[Real, list[Real]] | None:
    """The best x and the multipliers of all cones but the planes'; None if nothing is feasible."""
    try:
        solver: Any = import_module("clarabel")
        sparse: Any = import_module("scipy.sparse")
    except ImportError as error:
        raise MissingSolverError(str(error)) from None
    # The solver sees numbers of order one, whatever the masses are.
    every = [*aim, *(cone for ceiling in ceilings for cone in ceiling.cones)]
    unit = max(float(np.linalg.norm(cone.shift)) for cone in every)
    if unit < ROUNDING * greatest:  # what there was has balanced it: only rounding is left
        unit = 1.0
    rows: list[Real] = []
    right: list[Real] = []
    sizes: list[int] = []

    def add(matrix: Real, shift: Real, head: Real, room: float) -> None:
        """The cone |matrix x + shift| <= room - head (x, t), as right - rows (x, t)."""
        rows.append(np.vstack([head, np.column_stack([-matrix, np.zeros(len(matrix))])]))
        right.append(np.append(room, shift) / unit)
        sizes.append(len(matrix) + 1)

    with_t = np.append(np.zeros(count), -1.0)
    for cone in aim:
        add(cone.matrix, cone.shift, with_t, -cone.offset)
    for ceiling in ceilings:
        for cone in ceiling.cones:
            add(cone.matrix, cone.shift, 0 * with_t, ceiling.limit - cone.offset)
    weighed = len(sizes)
    for index in range(0, count, 2):
        add(np.eye(count)[index : index + 2], np.zeros(2), 0 * with_t, greatest)
    settings = solver.DefaultSettings()
    settings.verbose = False
    settings.tol_gap_abs = settings.tol_gap_rel = settings.tol_feas = PRECISION
    cost = np.append(np.zeros(count), 1.0)
    shape = [solver.SecondOrderConeT(size) for size in sizes]
    linear = sparse.csc_matrix((count + 1, count + 1))
    answer = solver.DefaultSolver(
        linear, cost, sparse.csc_matrix(np.vstack(rows)), np.concatenate(right), shape, settings
    ).solve()
    if str(answer.status) in ("PrimalInfeasible", "AlmostPrimalInfeasible"):
        return None
    parts = np.split(np.array(answer.z), np.cumsum(sizes)[:-1])[:weighed]
    return unit * np.array(answer.x)[:count], [np.append(part[0], -part[1:]) for part in parts]
