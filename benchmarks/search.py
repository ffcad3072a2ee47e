"""What a search costs, and what a second worker brings."""

from __future__ import annotations

from fractions import Fraction
from statistics import median
from time import perf_counter
from typing import Any

from crankstar.search.hands import cluster
from crankstar.search.question import Question
from crankstar.search.run import searched
from crankstar.search.stars import Stars
from crankstar.search.sums import couple, of

CLUSTER_CYLINDERS = 16
CLUSTER_RUNS = 3


def front(cylinders: int) -> Question:
    """The front of the first and second couples of a two-stroke engine at equal pitch."""
    stars = Stars(cylinders, "two-stroke", tuple(Fraction(cylinders - 1, 2) - j for j in range(cylinders)))
    return Question(stars, (of(couple(stars, 1)), of(couple(stars, 2))))


def by_cluster() -> list[tuple[str, str, str]]:
    """One dask worker against two: whole searches, by turns, so that what else the machine does disturbs both alike."""
    from distributed import LocalCluster

    question = front(CLUSTER_CYLINDERS)
    times: dict[int, list[float]] = {1: [], 2: []}
    options: dict[str, Any] = {"threads_per_worker": 1, "dashboard_address": ":0", "silence_logs": 50}
    one: Any = LocalCluster(n_workers=1, **options)
    two: Any = LocalCluster(n_workers=2, **options)
    with one, two:
        for _ in range(CLUSTER_RUNS + 1):
            for workers, found in ((1, one), (2, two)):
                with cluster(found.scheduler_address) as hands:
                    began = perf_counter()
                    searched(question, hands=hands, stretch=100)
                    times[workers].append(perf_counter() - began)
    # the first of each loads the compiled loops
    single, double = (median(times[workers][1:]) for workers in (1, 2))
    what = f"front of {CLUSTER_CYLINDERS} cylinders, two-stroke"
    return [
        (f"{what}, one dask worker", f"{single:.1f} s", ""),
        (f"{what}, two dask workers", f"{double:.1f} s ({single / double:.2f} times as fast)", "1.7 times"),
    ]


def rows() -> list[tuple[str, str, str]]:
    """What is measured, the figure, and the budget where there is one."""
    return by_cluster()
