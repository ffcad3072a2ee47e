"""Uneven angles of a star with its firing sequence: what more torsion and couples give for it.

The throws leave their even places; what hangs on one throw moves with it, and the firing order
stays. With u_j the crank angle by which cylinder j comes later, an order k of torsion is

    T_k(u) = |sum over j of a_j exp(i k (theta_j + u_j))|

with the firing angle theta_j, which tells half orders apart, and forces and couples are the same
sums over the throws. What is made least is as in `angles`, and so is how far it can be trusted: a
local optimum, the best from several starts.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from crankstar.spectra import Real
from crankstar.stars.angles import STARTS, UnevenAngles, deviation_faults, solved
from crankstar.stars.descent import Task, Term, succession
from crankstar.stars.faults import SearchError, error
from crankstar.stars.shafts import Fired, Shaft
from crankstar.stars.vector_sums import OrderSum, SequenceQuestion, force

FREE_FORCE = 1e-3
"""The weight of a free force beside a couple: of angles with equal couples those with the least."""


def uneven_sequences(
    question: SequenceQuestion,
    fired: Fired,
    *,
    deviations_deg: Sequence[float],
    starts: int = STARTS,
) -> tuple[UnevenAngles, ...]:
    """The best angles by all sums of the goals, for each deviation of the firing intervals.

    Raises SearchError where the goals have no sum, or a deviation is not below an interval.

    >>> from fractions import Fraction
    >>> from crankstar.stars.shafts import shaft_of
    >>> from crankstar.stars.vector_sums import Goal, couple, straight, torsion
    >>> six = shaft_of(6)
    >>> sums = couple(six, 1), torsion(six, Fraction(3, 2), straight(six))
    >>> asked = SequenceQuestion(six, tuple(Goal(each.name, (each,)) for each in sums))
    >>> usual = six.fired_in((1, 5, 3, 6, 2, 4))
    >>> [even, found] = uneven_sequences(asked, usual, deviations_deg=[0, 10], starts=4)
    >>> round(even.after[1], 9), found.after[1] < 3.6  # order 1.5, which was 18/5
    (3.6, True)
    """
    shaft = question.shaft
    sums = list(dict.fromkeys(one for goal in question.goals for one in goal.sums))
    if not sums:
        raise error("uneven", "needs-sum")
    faults = list(deviation_faults(deviations_deg, shaft.cycle_deg / shaft.cylinders))
    if faults:
        raise SearchError(faults)
    terms = [Term(one, one.order) for one in sums]
    known = {one.name for one in sums}
    for order in sorted({int(one.order) for one in sums if one.kind == "M"}):
        free_force = force(shaft, order)
        if free_force.name not in known:
            terms.append(Term(free_force, free_force.order, FREE_FORCE))
    return tuple(
        solved(
            _task(shaft, fired, terms),
            shaft.firing_order(fired),
            float(shaft.cycle_deg),
            tuple(_length(term, shaft, fired) for term in terms),
            deviations_deg=[0.0, *deviations_deg],
            starts=starts,
        )
    )


def _length(term: Term, shaft: Shaft, fired: Fired) -> float:
    assert isinstance(term.sum, OrderSum)  # noqa: S101  # made here
    return term.sum.length(shaft, fired)


def _task(shaft: Shaft, fired: Fired, terms: Sequence[Term]) -> Task:
    """The terms as arrays, cylinders by number; throws move, but that of cylinder 1."""
    angles = shaft.angles_deg(fired)
    firing = np.radians([float(angles[number]) for number in sorted(angles)])
    order = np.array([float(term.order) for term in terms])
    moving = [pin for pin in shaft.numbers if 1 not in pin]
    free = np.zeros((shaft.cylinders, len(moving)))
    for column, pin in enumerate(moving):
        free[[number - 1 for number in pin], column] = 1
    return Task(
        tuple(terms),
        amplitude=np.array([_amplitudes(shaft, term) for term in terms]),
        phase=order[:, None] * firing,
        order=order,
        weight=np.array([term.weight for term in terms]),
        free=free,
        intervals=succession(shaft.firing_order(fired)) @ free,
    )


def _amplitudes(shaft: Shaft, term: Term) -> Real:
    """What each cylinder, by number, gives to a sum; a throw gives with its first rod."""
    one = term.sum
    rods = shaft.rods if isinstance(one, OrderSum) and one.kind == "T" else 1
    numbers = [number for pin in shaft.numbers for number in pin[:rods]]
    out = np.zeros(shaft.cylinders)
    for number, weight in zip(numbers, one.weights, strict=True):
        out[number - 1] = one.scale * float(weight)
    return out
