"""Stars and firing sequences together, against plain enumeration of both in the same run.

The plain road is compiled as the search is: every star, and on each every sequence, one sign
changed at a time (Gray code), the values of every order compared with the front so far.
"""

from __future__ import annotations

from fractions import Fraction
from os import cpu_count
from time import perf_counter, process_time
from typing import Any

import numpy as np
from numba import njit

import tables
from crankstar.stars.executors import threads
from crankstar.stars.sequence_fronts import SequenceFront, sequence_front
from crankstar.stars.shafts import Shaft, shaft_of
from crankstar.stars.vector_sums import Goal, SequenceQuestion, couple, straight, torsion

BUDGETS = {(16, 45): 10, (16, 90): 10, (20, 108): 180, (20, 72): 180}
"""Cylinders and bank angle of a V engine, and the seconds that its front may take."""
OTHERS = ((11, None), (12, None), (13, None), (14, None), (24, 30))
"""Cylinders and bank angle, None in line, of fronts that are only timed."""
SAME = 1e-9


def asked(cylinders: int, bank_angle_deg: float | None) -> SequenceQuestion:
    """The front of both couples and the largest of three half orders in a straight shape."""
    shaft = shaft_of(cylinders, bank_angle_deg=bank_angle_deg)
    twist = tuple(torsion(shaft, Fraction(k, 2), straight(shaft)) for k in (1, 3, 5))
    couples = (Goal(f"M{order}", (couple(shaft, order),)) for order in (1, 2))
    return SequenceQuestion(shaft, (*couples, Goal("twist", twist)))


@njit(cache=True)
def _weighed(star: Any, shift: int, places: Any, shape: Any, roots: Any, front: Any, known: int):
    """Go through all sequences of a star; the number of points of the front after that."""
    classes, m = roots.shape[0], 3
    couples = np.zeros(4)
    delta = np.zeros(classes)
    seen = np.zeros(classes, np.int64)
    for p in range(star.shape[0]):
        for k in range(2):
            turn = roots[star[p] * (k + 1) % classes, 3]
            couples[2 * k] += places[p] * turn.real
            couples[2 * k + 1] += places[p] * turn.imag
        for own in (star[p], (star[p] + shift) % classes):
            delta[own] += shape[p] if seen[own] == 0 else -shape[p]
            seen[own] += 1
    point = np.zeros(3)
    for k in range(2):
        point[k] = np.sqrt(couples[2 * k] ** 2 + couples[2 * k + 1] ** 2)
    sums = np.zeros(m, np.complex128)
    sign = np.ones(classes)
    for own in range(classes):
        for o in range(m):
            sums[o] += delta[own] * roots[own, o]
    for step in range(1 << (classes - 1)):
        if step > 0:
            own = 1
            while not (step >> (own - 1)) & 1:
                own += 1
            sign[own] = -sign[own]
            for o in range(m):
                sums[o] += 2 * sign[own] * delta[own] * roots[own, o]
        most = 0.0
        for o in range(m):
            most = max(most, sums[o].real ** 2 + sums[o].imag ** 2)
        point[2] = np.sqrt(most)
        needed = True
        for f in range(known):
            if (
                front[f, 0] <= point[0] + SAME
                and front[f, 1] <= point[1] + SAME
                and front[f, 2] <= point[2] + SAME
            ):
                needed = False
                break
        if not needed:
            continue
        kept = 0
        for f in range(known):
            if not (
                point[0] <= front[f, 0] + SAME
                and point[1] <= front[f, 1] + SAME
                and point[2] <= front[f, 2] + SAME
            ):
                if kept < f:
                    front[kept] = front[f]
                kept += 1
        front[kept] = point
        known = kept + 1
    return known


@njit(cache=True)
def _plain(shift: int, places: Any, shape: Any, roots: Any, front: Any) -> int:
    """Go depth first through all stars of a four-stroke V engine; the points of its front."""
    n, classes = places.shape[0], roots.shape[0]
    star = np.full(n, -1)
    hits = np.zeros(classes, np.int64)
    star[0] = 0
    hits[0] += 1
    hits[shift] += 1
    depth, known = 1, 0
    while depth > 0:
        own = star[depth]
        if own >= 0:
            hits[own] -= 1
            hits[(own + shift) % classes] -= 1
        own += 1
        while own < classes and (hits[own] > 1 or hits[(own + shift) % classes] > 1):
            own += 1
        if own == classes:
            star[depth] = -1
            depth -= 1
            continue
        star[depth] = own
        hits[own] += 1
        hits[(own + shift) % classes] += 1
        if depth < n - 1:
            depth += 1
            continue
        known = _weighed(star, shift, places, shape, roots, front, known)
    return known


def plain(shaft: Shaft) -> np.ndarray:
    """The front by every star and every sequence, couples in the unit of the star [points, 3]."""
    step = 2 * np.pi * np.arange(shaft.classes) / shaft.classes
    roots = np.stack([np.exp(-1j * order * step) for order in (0.5, 1.5, 2.5, 1)], axis=1)
    places = np.array(shaft.places, float)
    front = np.empty((1 << 15, 3))
    known = _plain(shaft.shift, places, places / places.max(), roots, front)
    return front[:known]


def agreed(front: SequenceFront, other: np.ndarray) -> None:
    """Raises AssertionError where two fronts differ."""
    scales = [goal.sums[0].scale for goal in front.question.goals]
    ours = np.array([point.values for point in front.points]) / scales
    apart = np.abs(ours[:, None] - other).max(axis=2)
    if len(ours) != len(other) or apart.min(axis=0).max() > 1e-6:
        raise AssertionError(f"the fronts of {front.question.shaft.cylinders} cylinders differ")


def timed(question: SequenceQuestion, *, workers: int) -> tuple[SequenceFront, float, float]:
    """The front, the seconds it took, and the processor time of all threads."""
    began, worked = perf_counter(), process_time()
    with threads(workers) as pool:
        front = sequence_front(question, workers=pool)
    return front, perf_counter() - began, process_time() - worked


def written(seconds: float) -> str:
    """Two digits, none after the point from ten up."""
    return f"{seconds:.0f}" if seconds >= 10 else f"{seconds:.2g}"


def rows(*, others: bool = True) -> list[tuple[str, str, str]]:
    """What is measured, the figure, and the budget where there is one."""
    sequence_front(asked(8, 90))
    plain(shaft_of(8, bank_angle_deg=90))
    out: list[tuple[str, str, str]] = []
    for (cylinders, bank), budget in BUDGETS.items():
        question = asked(cylinders, bank)
        front, seconds, worked = timed(question, workers=cpu_count() or 1)
        began = perf_counter()
        slow = plain(question.shaft)
        whole = perf_counter() - began
        agreed(front, slow)
        orders = question.shaft.count * question.shaft.sequences
        what = f"V{cylinders} at {bank} deg, {len(front.points)} points"
        plainly = f"all {orders:,} orders one by one {written(whole)} s"
        figure = f"{written(seconds)} s ({written(worked)} s); {plainly}"
        out.append((what, figure, f"{budget} s"))
    for cylinders, bank in OTHERS if others else ():
        front, seconds, worked = timed(asked(cylinders, bank), workers=cpu_count() or 1)
        kind = f"{cylinders} in line" if bank is None else f"V{cylinders} at {bank} deg"
        figure = f"{written(seconds)} s ({written(worked)} s)"
        out.append((f"{kind}, {len(front.points):,} points", figure, ""))
    return out


if __name__ == "__main__":
    tables.show("sequences", rows())
