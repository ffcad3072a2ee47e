"""Uneven angles: what a star gains in couples if its throws may leave their even places, and what that costs in free forces.

Cylinder j comes to top dead centre later by the crank angle u_j than its direction d_j says. A vector sum of order k is then

    V_k(u) = scale * sum of w_j exp(i (2 pi t(d_j) + k u_j)).

Least is made the root of the sum of squares of (weight * |V_k|), while every firing interval stays within a given
deviation of the even one,

    |u_next - u_this| <= deviation for each firing and the next,

and sums that have a greatest length keep it. The forces F_k of evenly spaced throws vanish (but for orders that are multiples
of their number); uneven ones bring them back, so that they are always told, and can be weighed or limited. Where
there is a free force, couples hang on the point about which they are counted: it is the zero of the positions. Turning the
shaft as a whole changes nothing: cylinder 1 stays where it is. In a symmetric crank both cylinders of a place move
together; fixed throws stay. Where two cylinders share a direction they may part; they fire in the order of
`engines.firing_order`, and keep it.

The problem is not convex. What is found is a local optimum: the best of so many starts, the first of which is the star itself
and the others are drawn, always the same, from all over the intervals allowed. A better one elsewhere is not ruled out.

Source: sequential least-squares programming, D. Kraft, DFVLR-FB 88-28 (1988), as in scipy.optimize, with exact gradients.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from math import inf, isfinite, pi
from typing import Any

import numpy as np
from scipy.optimize import minimize

from crankstar.phasor import Complex, Real
from crankstar.search.engines import dead_centres_deg, firing_order
from crankstar.search.stars import SearchError, Star, Stars
from crankstar.search.sums import VectorSum, couple, force

STARTS = 24
"""Points from which an optimum is looked for, the star itself among them."""
NOTHING = 1e-9
"""Share of its greatest possible length by which a sum may pass its limit, and below which it is the solver's precision."""
ALIKE = 1e-6
"""Share of the value of the star within which two starts have ended in the same optimum."""


@dataclass(frozen=True)
class Term:
    """A vector sum that counts: its order (per turn), its weight in what is made least (0: only told), its greatest length."""

    sum: VectorSum
    order: Fraction
    weight: float = 1.0
    at_most: float = inf


@dataclass(frozen=True)
class Uneven:
    """Uneven angles of a star, and what they bring. Lengths are those of the terms, in their units.

    deviation_deg: how far each firing interval might leave the even one; later_deg: by how many degrees of crank angle each
    cylinder comes later to top dead centre than in the star; before, after: length of the sum of each term, even and uneven;
    value_before, value: what was made least; starts: from how many points it was looked for; agreeing: how many ended here.
    """

    stars: Stars
    star: Star
    terms: tuple[Term, ...]
    deviation_deg: float
    later_deg: tuple[float, ...]
    before: tuple[float, ...]
    after: tuple[float, ...]
    value_before: float
    value: float
    starts: int
    agreeing: int

    @cached_property
    def firing_order(self) -> tuple[int, ...]:
        """The cylinders in the order in which they fire, cylinder 1 first."""
        return firing_order(self.stars, self.star)

    @property
    def dead_centres_deg(self) -> tuple[float, ...]:
        """Crank angle at which each cylinder comes to top dead centre after cylinder 1, degrees from 0 to 360."""
        even = dead_centres_deg(self.stars, self.star)
        return tuple((angle + by - self.later_deg[0]) % 360 for angle, by in zip(even, self.later_deg, strict=True))

    @property
    def even_deg(self) -> float:
        """The even firing interval, degrees."""
        return (360.0 if self.stars.cycle == "two-stroke" else 720.0) / self.stars.cylinders

    @property
    def intervals_deg(self) -> tuple[float, ...]:
        """From each firing to the next, in firing order from cylinder 1, degrees."""
        later = np.array(self.later_deg)
        return tuple(float(self.even_deg + by) for by in _succession(self.stars, self.star) @ later)

    @property
    def greatest_deviation_deg(self) -> float:
        """How far the most uneven interval is from the even one, degrees."""
        return max(abs(interval - self.even_deg) for interval in self.intervals_deg)


def terms(
    stars: Stars,
    *,
    couples: Mapping[int, float],
    forces: Mapping[int, float] | None = None,
    forces_at_most: Mapping[int, float] | None = None,
) -> tuple[Term, ...]:
    """Couples and forces by order, each with its weight; the forces of all orders named are told even if they weigh nothing.

    forces_at_most: greatest length of F_k by order, m r w^2 (times the harmonic A_k of the piston).
    """
    weights, limits = forces or {}, forces_at_most or {}
    out = [Term(couple(stars, order), Fraction(order), weight) for order, weight in sorted(couples.items())]
    orders = sorted({*couples, *weights, *limits})
    out += [Term(force(stars, order), Fraction(order), weights.get(order, 0.0), limits.get(order, inf)) for order in orders]
    return tuple(out)


def uneven(stars: Stars, star: Star, wanted: Sequence[Term], *, deviation_deg: float, starts: int = STARTS) -> Uneven:
    """The best angles of a star's throws with firing intervals within `deviation_deg` of even ones: a local optimum.

    Raises SearchError, also where no start leads to angles that keep the limits.

    >>> three = Stars(3, "two-stroke", (Fraction(1), Fraction(0), Fraction(-1)))
    >>> found = uneven(three, (0, 1, 2), terms(three, couples={1: 1.0}), deviation_deg=3.0)
    >>> [round(interval, 2) for interval in found.intervals_deg]  # cylinders 1 and 3, far apart, come nearer to each other
    [120.0, 123.0, 117.0]
    >>> [round(length, 3) for length in (*found.before, *found.after)]  # M1 and F1, even and uneven
    [1.732, 0.0, 1.705, 0.052]
    """
    return curve(stars, star, wanted, deviations_deg=[deviation_deg], starts=starts)[0]


def curve(
    stars: Stars, star: Star, wanted: Sequence[Term], *, deviations_deg: Sequence[float], starts: int = STARTS
) -> tuple[Uneven, ...]:
    """The best angles over how far intervals may deviate, from the least deviation to the greatest: the price of evenness.

    Each begins also from the angles found for the deviation before, so that more freedom never ends worse. Raises as `uneven`.
    """
    faults = list(_faults(stars, star, wanted, deviations_deg, starts))
    if faults:
        raise SearchError(faults)
    task = Task.of(stars, star, tuple(wanted))
    out: list[Uneven] = []
    best = np.zeros(task.free.shape[1])
    for deviation in sorted(set(deviations_deg)):
        best, agreeing = _best(task, float(np.radians(deviation)), best, starts)
        out.append(_read(task, deviation, best, starts, agreeing))
    return tuple(out)


def sentence(found: Uneven) -> str:
    """What uneven angles bring and cost, and how far that can be trusted."""
    lengths = zip(found.terms, found.before, found.after, strict=True)
    if not any(found.later_deg):
        sums = ", ".join(f"{term.sum.name} {length:.4g}" for term, length, _ in lengths)
        return f"firing intervals of {found.even_deg:.5g} deg: {sums}; the star as it is"
    sums = ", ".join(f"{term.sum.name} from {before:.4g} to {after:.4g}" for term, before, after in lengths)
    return (
        f"firing intervals within {found.greatest_deviation_deg:.4g} deg of {found.even_deg:.5g} deg: {sums}; a local optimum, the "
        f"best of {found.starts} starts, {found.agreeing} of which ended in it: a better one elsewhere is not ruled out"
    )


def _faults(stars: Stars, star: Star, wanted: Sequence[Term], deviations_deg: Sequence[float], starts: int) -> list[str]:
    firing_order(stars, star)
    even = (360 if stars.cycle == "two-stroke" else 720) / stars.cylinders
    out = []
    if not deviations_deg:
        out.append("no deviation of the firing intervals is given; give at least one, in degrees")
    room = f"give one from 0 to less than the even interval, {even:.5g} deg"
    out += [f"a deviation of {one:g} deg cannot be; {room}" for one in deviations_deg if not 0 <= one < even]
    for term in wanted:
        if not (isfinite(term.weight) and term.weight >= 0):
            out.append(f"{term.sum.name}: a weight of {term.weight:g} cannot be; give a number from 0 up")
        if not term.at_most >= 0:
            out.append(f"{term.sum.name}: a length of at most {term.at_most:g} cannot be; give a number from 0 up")
    if not any(term.weight > 0 for term in wanted):
        out.append("nothing is to be made least; give at least one vector sum a weight above 0")
    if starts < 1:
        out.append(f"{starts} starts lead nowhere; give at least 1")
    return out


def _succession(stars: Stars, star: Star) -> Real:
    """How each firing interval grows with the angles by which cylinders come later [firing, cylinder]."""
    order = [number - 1 for number in firing_order(stars, star)]
    out = np.zeros((len(order), stars.cylinders))
    for row, (this, then) in enumerate(zip(order, [*order[1:], order[0]], strict=True)):
        out[row, this] -= 1
        out[row, then] += 1
    return out


def _free(stars: Stars) -> Real:
    """How far each cylinder comes later with each place that may move [cylinder, place]."""
    still = {place for place, _ in stars.fixed_places} or {0}
    moving = [members for place, members in enumerate(stars.places) if place not in still]
    out = np.zeros((stars.cylinders, len(moving)))
    for column, members in enumerate(moving):
        out[list(members), column] = 1
    return out


@dataclass(frozen=True)
class Task:
    """A star and its terms as arrays: amplitude and even phase [term, cylinder], order, weight and limit [term].

    free: how cylinders follow the places that may move [cylinder, place]; intervals: how firing intervals do [firing, place].
    """

    stars: Stars
    star: Star
    terms: tuple[Term, ...]
    amplitude: Real
    phase: Real
    order: Real
    weight: Real
    free: Real
    intervals: Real

    @classmethod
    def of(cls, stars: Stars, star: Star, wanted: tuple[Term, ...]) -> Task:
        """The arrays of a star and its terms."""
        free = _free(stars)
        return cls(
            stars,
            star,
            wanted,
            amplitude=np.array([[term.sum.scale * float(w) for w in term.sum.weights] for term in wanted]),
            phase=np.array([[2 * pi * float(term.sum.turns[d]) for d in star] for term in wanted]),
            order=np.array([float(term.order) for term in wanted]),
            weight=np.array([term.weight for term in wanted]),
            free=free,
            intervals=_succession(stars, star) @ free,
        )

    def vectors(self, places: Real) -> tuple[Complex, Complex]:
        """The sum of each term [term], and how it grows with each place [term, place]; `places` in radians."""
        arms = self.amplitude * np.exp(1j * (self.phase + self.order[:, None] * (self.free @ places)))
        return arms.sum(axis=1), 1j * self.order[:, None] * (arms @ self.free)

    def square(self, places: Real) -> tuple[float, Real]:
        """The sum of squares that is made least, and its gradient."""
        vectors, slopes = self.vectors(places)
        squared = self.weight**2
        return float(squared @ np.abs(vectors) ** 2), 2 * (squared @ np.real(np.conj(vectors)[:, None] * slopes))

    @property
    def reach(self) -> Real:
        """How long each sum could be at most [term]."""
        return np.abs(self.amplitude).sum(axis=1)

    def kept(self, places: Real) -> bool:
        """Whether all sums keep their limits."""
        lengths = np.abs(self.vectors(places)[0])
        return bool(np.all(lengths <= [term.at_most for term in self.terms] + NOTHING * self.reach))


def _best(task: Task, deviation: float, before: Real, starts: int) -> tuple[Real, int]:
    """The best places from all starts, and how many starts ended there. Raises SearchError where none keeps the limits."""
    ends = [_within(task, end, deviation) for end in _ends(task, deviation, before, starts)]
    values = [task.square(end)[0] ** 0.5 if task.kept(end) else inf for end in ends]
    value = min(values)
    if value == inf:
        told = ", ".join(f"{term.sum.name} at most {term.at_most:g}" for term in task.terms if term.at_most < inf)
        degrees = f"{np.degrees(deviation):g} deg"
        raise SearchError([f"with intervals within {degrees} of even ones no angles were found that keep {told}; allow more"])
    near = ALIKE * (task.square(np.zeros_like(before))[0] ** 0.5 or 1.0)
    return ends[values.index(value)], sum(other <= value + near for other in values[-starts:])


def _ends(task: Task, deviation: float, before: Real, starts: int) -> list[Real]:
    """The star, the places found with less freedom and where they lead; then where every start leads."""
    still = np.zeros_like(before)
    if deviation == 0 or not before.size:
        return [still] * starts
    random = np.random.default_rng(1)
    begins = [still]
    for _ in range(starts - 1):
        drawn = np.linalg.lstsq(task.intervals, random.uniform(-deviation, deviation, len(task.intervals)), rcond=None)[0]
        begins.append(_within(task, drawn, deviation))
    known = [still, before, _descended(task, before, deviation)] if before.any() else [still]
    return [*known, *(_descended(task, begin, deviation) for begin in begins)]


def _within(task: Task, places: Real, deviation: float) -> Real:
    """Places drawn together until all intervals are within the deviation."""
    widest = float(np.abs(task.intervals @ places).max(initial=0.0))
    return places * (deviation / widest) if widest > deviation else places


def _descended(task: Task, begin: Real, deviation: float) -> Real:
    """The local optimum that a start leads to; values are counted in that of the star, places in radians.

    In the much smaller unit of the deviation sums that weigh little beside others would be left before they are least.
    """
    unit = task.square(np.zeros_like(begin))[0] or float(np.sum((task.weight * task.reach) ** 2))
    slope = np.vstack([-task.intervals, task.intervals]) / deviation
    limits = [{"type": "ineq", "fun": lambda x: 1 + slope @ x, "jac": lambda _x: slope}]
    limits += [limit for row, term in enumerate(task.terms) if term.at_most < inf for limit in _limits(task, row)]

    def scaled(x: Real) -> tuple[float, Real]:
        value, slope = task.square(x)
        return value / unit, slope / unit

    options = {"ftol": 1e-15, "maxiter": 500}
    found: Any = minimize(scaled, begin, jac=True, method="SLSQP", constraints=limits, options=options)
    return np.asarray(found.x)


def _limits(task: Task, row: int) -> list[dict[str, Any]]:
    """A sum's greatest length for the solver: its square, or, where it is to vanish, its two parts."""
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


def _read(task: Task, deviation_deg: float, places: Real, starts: int, agreeing: int) -> Uneven:
    """Places in degrees for every cylinder, and the lengths they give, exact zeros of the star as zeros."""
    before = tuple(term.sum.length(task.star) for term in task.terms)
    still = not places.any()
    lengths = np.abs(task.vectors(places)[0])
    after = before if still else tuple(float(x) for x in np.where(lengths < NOTHING * task.reach, 0.0, lengths))
    return Uneven(
        task.stars,
        task.star,
        task.terms,
        float(deviation_deg),
        tuple(float(angle) for angle in np.degrees(task.free @ places)),
        before,
        after,
        _rooted(task, before),
        _rooted(task, after),
        starts,
        agreeing,
    )


def _rooted(task: Task, lengths: Sequence[float]) -> float:
    return float(np.sqrt(np.sum((task.weight * np.array(lengths)) ** 2)))
