"""Uneven angles as an optimisation: a star and its sums as arrays, and its local optima.

Source: sequential least-squares programming, D. Kraft, DFVLR-FB 88-28 (1988), as in scipy.optimize,
with exact gradients.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from math import inf, pi
from typing import Any

import numpy as np
from scipy.optimize import minimize

from crankstar.spectra import Complex, Real
from crankstar.stars.engines import firing_order
from crankstar.stars.faults import error
from crankstar.stars.star import Star, Stars
from crankstar.stars.sums import VectorSum
from crankstar.stars.vector_sums import OrderSum

NOTHING = 1e-9
"""Share of its greatest length by which a sum may exceed its limit: the solver's precision."""
ALIKE = 1e-6
"""Share of the value of the star within which two starts have ended in the same optimum."""


@dataclass(frozen=True)
class Term:
    """A vector sum: order per turn, weight (0 only reports it), greatest length."""

    sum: VectorSum | OrderSum
    order: Fraction
    weight: float = 1.0
    at_most: float = inf


def succession(firing_order: Sequence[int]) -> Real:
    """How each firing interval grows as cylinders come later [firing, cylinder by number]."""
    order = [number - 1 for number in firing_order]
    out = np.zeros((len(order), len(order)))
    for row, (this, then) in enumerate(zip(order, [*order[1:], order[0]], strict=True)):
        out[row, this] -= 1
        out[row, then] += 1
    return out


def _free(stars: Stars) -> Real:
    """How far each cylinder comes later with each place that may move [cylinder, place]."""
    still = {place for place, _ in stars.fixed_places} or {0}
    moving = [members for index, members in enumerate(stars.places) if index not in still]
    out = np.zeros((stars.cylinders, len(moving)))
    for column, members in enumerate(moving):
        out[list(members), column] = 1
    return out


@dataclass(frozen=True)
class Task:
    """Terms as arrays: amplitude and even phase [term, cylinder], the rest [term].

    free: how cylinders follow the places that may move [cylinder, place]; intervals: how firing
    intervals do [firing, place].
    """

    terms: tuple[Term, ...]
    amplitude: Real
    phase: Real
    order: Real
    weight: Real
    free: Real
    intervals: Real

    def vectors(self, places: Real) -> tuple[Complex, Complex]:
        """The sum of each term [term] and its gradient [term, place]; `places` in radians."""
        arms = self.amplitude * np.exp(
            1j * (self.phase + self.order[:, None] * (self.free @ places))
        )
        return arms.sum(axis=1), 1j * self.order[:, None] * (arms @ self.free)

    def square(self, places: Real) -> tuple[float, Real]:
        """The sum of squares that is made least, and its gradient."""
        vectors, slopes = self.vectors(places)
        squared = self.weight**2
        return float(squared @ np.abs(vectors) ** 2), 2 * (
            squared @ np.real(np.conj(vectors)[:, None] * slopes)
        )

    @property
    def reach(self) -> Real:
        """How long each sum could be at most [term]."""
        return np.abs(self.amplitude).sum(axis=1)

    def kept(self, places: Real) -> bool:
        """Whether all sums keep their limits."""
        lengths = np.abs(self.vectors(places)[0])
        return bool(np.all(lengths <= [term.at_most for term in self.terms] + NOTHING * self.reach))


def star_task(stars: Stars, star: Star, wanted: Sequence[Term]) -> Task:
    """The task of a star: all that is asked of its sums."""
    free = _free(stars)
    sums = [term.sum for term in wanted if isinstance(term.sum, VectorSum)]
    return Task(
        tuple(wanted),
        amplitude=np.array([[each.scale * float(w) for w in each.weights] for each in sums]),
        phase=np.array([[2 * pi * float(each.turns[d]) for d in star] for each in sums]),
        order=np.array([float(term.order) for term in wanted]),
        weight=np.array([term.weight for term in wanted]),
        free=free,
        intervals=succession(firing_order(stars, star)) @ free,
    )


def best(task: Task, deviation: float, before: Real, starts: int) -> tuple[Real, int]:
    """The best places from all starts, and the number of starts that ended there.

    Raises SearchError where none keeps the limits.
    """
    ends = [_within(task, end, deviation) for end in _ends(task, deviation, before, starts)]
    values = [task.square(end)[0] ** 0.5 if task.kept(end) else inf for end in ends]
    value = min(values)
    if value == inf:
        limits = ", ".join(
            f"{term.sum.name} <= {term.at_most:g}" for term in task.terms if term.at_most < inf
        )
        raise error("uneven", "no-angles", deviation=f"{np.degrees(deviation):g}", limits=limits)
    near = ALIKE * (task.square(np.zeros_like(before))[0] ** 0.5 or 1.0)
    return ends[values.index(value)], sum(other <= value + near for other in values[-starts:])


def _ends(task: Task, deviation: float, before: Real, starts: int) -> list[Real]:
    """The star, the places found with less freedom and where they lead, then where starts lead."""
    still = np.zeros_like(before)
    if deviation == 0 or not before.size:
        return [still] * starts
    random = np.random.default_rng(1)
    begins = [still]
    for _ in range(starts - 1):
        drawn = np.linalg.lstsq(
            task.intervals, random.uniform(-deviation, deviation, len(task.intervals)), rcond=None
        )[0]
        begins.append(_within(task, drawn, deviation))
    known = [still, before, _descended(task, before, deviation)] if before.any() else [still]
    return [*known, *(_descended(task, begin, deviation) for begin in begins)]


def _within(task: Task, places: Real, deviation: float) -> Real:
    """Places drawn together until all intervals are within the deviation."""
    widest = float(np.abs(task.intervals @ places).max(initial=0.0))
    return places * (deviation / widest) if widest > deviation else places


def _descended(task: Task, begin: Real, deviation: float) -> Real:
    """The local optimum that a start leads to.

    Values are in units of that of the star, places in radians: in the much smaller unit of the
    deviation, sums of little weight would be left before they are least.
    """
    unit = task.square(np.zeros_like(begin))[0] or float(np.sum((task.weight * task.reach) ** 2))
    slope = np.vstack([-task.intervals, task.intervals]) / deviation
    limits = [{"type": "ineq", "fun": lambda x: 1 + slope @ x, "jac": lambda _x: slope}]
    limits += [
        limit
        for row, term in enumerate(task.terms)
        if term.at_most < inf
        for limit in _limits(task, row)
    ]

    def scaled(x: Real) -> tuple[float, Real]:
        value, slope = task.square(x)
        return value / unit, slope / unit

    options = {"ftol": 1e-15, "maxiter": 500}
    optimum: Any = minimize(
        scaled, begin, jac=True, method="SLSQP", constraints=limits, options=options
    )
    return np.asarray(optimum.x)


def _limits(task: Task, row: int) -> list[dict[str, Any]]:
    """The limit of a sum for the solver: of its square, or of both parts where it must vanish."""
    reach, at_most = float(task.reach[row]), task.terms[row].at_most

    def parts(x: Real) -> Real:
        vector = task.vectors(x)[0][row] / reach
        return np.array([vector.real, vector.imag])

    def parts_slope(x: Real) -> Real:
        slope = task.vectors(x)[1][row] / reach
        return np.array([slope.real, slope.imag])

    def room(x: Real) -> float:
        return (at_most / reach) ** 2 - float(parts(x) @ parts(x))

    if at_most == 0:
        return [{"type": "eq", "fun": parts, "jac": parts_slope}]
    return [{"type": "ineq", "fun": room, "jac": lambda x: -2 * parts(x) @ parts_slope(x)}]
