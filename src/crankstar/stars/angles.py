"""Uneven angles: how far couples shrink if the throws leave their even places, and at what cost.

Cylinder j comes to top dead centre later by the crank angle u_j than its direction d_j says. A
vector sum of order k is then

    V_k(u) = scale * sum of w_j exp(i (2 pi t(d_j) + k u_j)).

The root of the sum of squares of (weight * |V_k|) is minimised, while every firing interval stays
within a given deviation of the even one,

    |u_next - u_this| <= deviation for each firing and the next,

and sums that have a greatest length keep it. The forces F_k of evenly spaced throws vanish (except
for orders that are multiples of their number); uneven ones bring them back, so that they are always
reported, and can be given a weight or a limit. Where there is a free force, couples depend on the
point of reference: it is the zero of the positions. Turning the shaft as a whole changes nothing:
cylinder 1 stays where it is. In a symmetric crank both cylinders of a place move together; fixed
throws stay. Two cylinders that share a direction may part; they fire in the order of
`engines.firing_order`, and keep it.

The problem is not convex. The result is a local optimum, the best of several starts: the star
itself, and others drawn, always the same, from all over the allowed intervals. A better one
elsewhere is not ruled out.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from math import inf, isfinite

import numpy as np

from crankstar.language.faults import Fault
from crankstar.language.messages import _
from crankstar.stars import descent
from crankstar.stars.descent import NOTHING, Task, Term, star_task, succession
from crankstar.stars.engines import dead_centres_deg, firing_order
from crankstar.stars.faults import SearchError, fault
from crankstar.stars.star import Star, Stars
from crankstar.stars.sums import VectorSum, couple, force

STARTS = 24
"""Points from which an optimum is sought, the star itself among them."""


@dataclass(frozen=True)
class UnevenAngles:
    """Uneven angles, and what they bring. Lengths are those of the terms, in their units.

    deviation_deg: how far each firing interval might leave the even one; later_deg: by how many
    degrees of crank angle each cylinder comes later to top dead centre than in the even star;
    before, after: length of the sum of each term, even and uneven; value_before, value: what was
    made least; starts: from how many points it was looked for; agreeing: how many ended here.
    """

    firing_order: tuple[int, ...]
    cycle_deg: float
    terms: tuple[Term, ...]
    deviation_deg: float
    later_deg: tuple[float, ...]
    before: tuple[float, ...]
    after: tuple[float, ...]
    value_before: float
    value: float
    starts: int
    agreeing: int

    @property
    def even_deg(self) -> float:
        """The even firing interval, degrees."""
        return self.cycle_deg / len(self.firing_order)

    @property
    def intervals_deg(self) -> tuple[float, ...]:
        """From each firing to the next, in firing order, degrees."""
        later = np.array(self.later_deg)
        return tuple(float(self.even_deg + by) for by in succession(self.firing_order) @ later)

    @property
    def greatest_deviation_deg(self) -> float:
        """How far the most uneven interval is from the even one, degrees."""
        return max(abs(interval - self.even_deg) for interval in self.intervals_deg)


@dataclass(frozen=True)
class Uneven(UnevenAngles):
    """Those of a star."""

    stars: Stars
    star: Star

    @property
    def dead_centres_deg(self) -> tuple[float, ...]:
        """Angle of each cylinder's top dead centre after that of cylinder 1, 0 to 360 degrees."""
        even = dead_centres_deg(self.stars, self.star)
        return tuple(
            (angle + by - self.later_deg[0]) % 360
            for angle, by in zip(even, self.later_deg, strict=True)
        )


def terms(
    stars: Stars,
    *,
    couples: Mapping[int, float],
    forces: Mapping[int, float] | None = None,
    forces_at_most: Mapping[int, float] | None = None,
) -> tuple[Term, ...]:
    """Couples and forces by order, each with its weight; forces of weight 0 are still reported.

    forces_at_most: greatest length of F_k by order, m r w^2 (times the harmonic A_k of the piston).
    """
    weights, limits = forces or {}, forces_at_most or {}
    out = [
        Term(couple(stars, order), Fraction(order), weight)
        for order, weight in sorted(couples.items())
    ]
    orders = sorted({*couples, *weights, *limits})
    out += [
        Term(force(stars, order), Fraction(order), weights.get(order, 0.0), limits.get(order, inf))
        for order in orders
    ]
    return tuple(out)


def uneven(
    stars: Stars, star: Star, wanted: Sequence[Term], *, deviation_deg: float, starts: int = STARTS
) -> Uneven:
    """The best angles with firing intervals within `deviation_deg` of even: a local optimum.

    Raises SearchError, also where no start leads to angles that keep the limits.

    >>> three = Stars(3, "two-stroke", (Fraction(1), Fraction(0), Fraction(-1)))
    >>> found = uneven(three, (0, 1, 2), terms(three, couples={1: 1.0}), deviation_deg=3.0)
    >>> [round(interval, 2) for interval in found.intervals_deg]  # 1 and 3 come nearer
    [120.0, 123.0, 117.0]
    >>> [round(length, 3) for length in (*found.before, *found.after)]  # M1 and F1, even and uneven
    [1.732, 0.0, 1.705, 0.052]
    """
    return curve(stars, star, wanted, deviations_deg=[deviation_deg], starts=starts)[0]


def curve(
    stars: Stars,
    star: Star,
    wanted: Sequence[Term],
    *,
    deviations_deg: Sequence[float],
    starts: int = STARTS,
) -> tuple[Uneven, ...]:
    """The best angles for each deviation of the intervals, rising: the price of evenness.

    Each begins also from the angles found for the deviation before, so that more freedom never ends
    worse. Raises as `uneven`.
    """
    firing_order(stars, star)  # raises for what is no star
    faults = list(_faults(stars, wanted, deviations_deg, starts))
    if faults:
        raise SearchError(faults)
    order, cycle = firing_order(stars, star), 360.0 if stars.cycle == "two-stroke" else 720.0
    before = tuple(term.sum.length(star) for term in wanted if isinstance(term.sum, VectorSum))
    found = solved(
        star_task(stars, star, wanted), order, cycle, before, deviations_deg=deviations_deg,
        starts=starts,
    )  # fmt: skip
    return tuple(Uneven(**vars(each), stars=stars, star=star) for each in found)


def solved(
    task: Task,
    order: tuple[int, ...],
    cycle_deg: float,
    before: tuple[float, ...],
    *,
    deviations_deg: Sequence[float],
    starts: int,
) -> list[UnevenAngles]:
    """The best angles of a task for each deviation, rising; `before` has exact zeros as zeros."""
    out: list[UnevenAngles] = []
    best = np.zeros(task.free.shape[1])
    for deviation in sorted(set(deviations_deg)):
        best, agreeing = descent.best(task, float(np.radians(deviation)), best, starts)
        lengths = np.abs(task.vectors(best)[0])
        after = tuple(float(x) for x in np.where(lengths < NOTHING * task.reach, 0.0, lengths))
        after = after if best.any() else before
        out.append(
            UnevenAngles(
                order,
                cycle_deg,
                task.terms,
                float(deviation),
                tuple(float(angle) for angle in np.degrees(task.free @ best)),
                before,
                after,
                _rooted(task, before),
                _rooted(task, after),
                starts,
                agreeing,
            )
        )
    return out


def sentence(result: UnevenAngles) -> str:
    """What uneven angles bring and cost, and how far that can be trusted."""
    even = f"{result.even_deg:.5g}"
    lengths = zip(result.terms, result.before, result.after, strict=True)
    if not any(result.later_deg):
        sums = ", ".join(f"{term.sum.name} {length:.4g}" for term, length, _after in lengths)
        return _(
            "Firing intervals of {even} deg, as in the even star: {sums}.", even=even, sums=sums
        )
    sums = ", ".join(
        f"{term.sum.name} {before:.4g} -> {after:.4g}" for term, before, after in lengths
    )
    return _(
        "Firing intervals within {deviation} deg of {even} deg: {sums}. This is a local optimum, "
        "the best from {starts} starting points, {agreeing} of which lead to it; a better one is "
        "not ruled out.",
        deviation=f"{result.greatest_deviation_deg:.4g}",
        even=even,
        sums=sums,
        starts=result.starts,
        agreeing=result.agreeing,
    )


def _faults(
    stars: Stars, wanted: Sequence[Term], deviations_deg: Sequence[float], starts: int
) -> Iterator[Fault]:
    even = (360 if stars.cycle == "two-stroke" else 720) / stars.cylinders
    yield from deviation_faults(deviations_deg, even)
    for term in wanted:
        if not (isfinite(term.weight) and term.weight >= 0):
            yield fault("", "term-weight", sum=term.sum.name, given=f"{term.weight:g}")
        if not term.at_most >= 0:
            yield fault("", "term-limit", sum=term.sum.name, given=f"{term.at_most:g}")
    if not any(term.weight > 0 for term in wanted):
        yield fault("minimise", "no-term")
    if starts < 1:
        yield fault("", "starts", given=starts)


def deviation_faults(deviations_deg: Sequence[float], even: float) -> Iterator[Fault]:
    """What is wrong with deviations from an even interval, degrees."""
    if not deviations_deg:
        yield fault("uneven", "no-deviation")
    for deviation in deviations_deg:
        if not 0 <= deviation < even:
            yield fault("uneven", "deviation", given=f"{deviation:g}", even=f"{even:.5g}")


def _rooted(task: Task, lengths: Sequence[float]) -> float:
    return float(np.sqrt(np.sum((task.weight * np.array(lengths)) ** 2)))
