"""What a search costs, and what a second worker brings."""

from __future__ import annotations

from fractions import Fraction
from math import perm
from statistics import median
from time import perf_counter
from typing import Any

import numpy as np

import exhaustive
from crankstar.stars.executors import cluster
from crankstar.stars.halves import halves
from crankstar.stars.question import Question
from crankstar.stars.results import groups
from crankstar.stars.run import Outcome, searched
from crankstar.stars.star import Stars
from crankstar.stars.sums import couple, of

BUDGETS = {12: 0.05, 13: 0.1, 14: 1, 15: None, 16: 60}
"""Cylinders, and the seconds that a front may take."""
SAME = 1e-5
"""Relative difference allowed between two sums of lengths, one by a rounded root."""
CLUSTER_CYLINDERS = 16
CLUSTER_RUNS = 3


def front(cylinders: int) -> Question:
    """The front of the first and second couples of a two-stroke engine at equal pitch."""
    stars = Stars(
        cylinders, "two-stroke", tuple(Fraction(cylinders - 1, 2) - j for j in range(cylinders))
    )
    return Question(stars, (of(couple(stars, 1)), of(couple(stars, 2))))


def by_cluster() -> list[tuple[str, str, str]]:
    """One dask worker against two: whole searches in turn, so that disturbances are shared."""
    from distributed import LocalCluster

    question = front(CLUSTER_CYLINDERS)
    times: dict[int, list[float]] = {1: [], 2: []}
    options: dict[str, Any] = {
        "threads_per_worker": 1,
        "dashboard_address": ":0",
        "silence_logs": 50,
    }
    one: Any = LocalCluster(n_workers=1, **options)
    two: Any = LocalCluster(n_workers=2, **options)
    with one, two:
        for _ in range(CLUSTER_RUNS + 1):
            for count, local in ((1, one), (2, two)):
                with cluster(local.scheduler_address) as workers:
                    began = perf_counter()
                    searched(question, workers=workers, range_size=100)
                    times[count].append(perf_counter() - began)
    # the first of each loads the compiled loops
    single, double = (median(times[count][1:]) for count in (1, 2))
    what = f"front of {CLUSTER_CYLINDERS} cylinders, two-stroke"
    return [
        (f"{what}, one dask worker", f"{single:.1f} s", ""),
        (
            f"{what}, two dask workers",
            f"{double:.1f} s ({single / double:.2f} times as fast)",
            "1.7 times",
        ),
    ]


def timed(cylinders: int, *, runs: int) -> tuple[Outcome, float]:
    """The search of a front, and the median of its times."""
    found: list[Outcome] = []
    times: list[float] = []
    for _ in range(runs):
        began = perf_counter()
        found.append(searched(front(cylinders)))
        times.append(perf_counter() - began)
    return found[-1], median(times)


def fronts() -> list[tuple[str, str, str]]:
    """Proven fronts by number of cylinders, in one process, warm."""
    searched(front(5))
    out: list[tuple[str, str, str]] = []
    for cylinders, budget in BUDGETS.items():
        found, seconds = timed(cylinders, runs=9 if cylinders < 15 else 1)
        what = (
            f"proven front (M1, M2) of {cylinders} cylinders, {len(groups(found.results))} "
            "points, one process, warm"
        )
        out.append((what, f"{seconds:.3g} s", f"{budget:g} s" if budget else ""))
    return out


def against_exhaustive() -> list[tuple[str, str, str]]:
    """The search against a compiled enumeration of all stars; both give the same front."""
    exhaustive.front(5)
    out: list[tuple[str, str, str]] = []
    for cylinders, budget in ((11, ""), (12, ""), (13, "100 times")):
        found, seconds = timed(cylinders, runs=5)
        began = perf_counter()
        plain = exhaustive.front(cylinders)
        slow = perf_counter() - began
        ours = [
            found.results.values[group[0]] * halves(found.question).unit
            for group in groups(found.results)
        ]
        if any(min(np.abs(np.array(point) - one).max() for one in ours) > SAME for point in plain):
            raise AssertionError(f"the fronts of {cylinders} cylinders differ")
        what = (
            f"all {perm(cylinders - 1):,} stars of {cylinders} cylinders one by one, and how "
            "much faster the search is"
        )
        out.append((what, f"{slow:.3g} s, {slow / seconds:.0f} times", budget))
    return out


def rows() -> list[tuple[str, str, str]]:
    """What is measured, the figure, and the budget where there is one."""
    return [*fronts(), *against_exhaustive(), *by_cluster()]
