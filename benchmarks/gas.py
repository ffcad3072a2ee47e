"""Speed of gas: `make bench` prints it, --write puts it in the docs.

A V12's torque over a cycle, ten thousand loads, the speed over a cycle; warm, medians.
"""

from __future__ import annotations

from collections.abc import Callable
from statistics import median
from time import perf_counter

import numpy as np

import tables
from crankstar import cycle, driven, gas_torque, load, side_thrust
from crankstar.mechanics.gas_loads import torques_at_loads

TIMES = 30
LOADS = 10_000


def seconds(work: Callable[[], object], *, times: int = TIMES) -> float:
    """The median of several runs after a first one."""
    work()
    out: list[float] = []
    for _ in range(times):
        start = perf_counter()
        work()
        out.append(perf_counter() - start)
    return median(out)


def main() -> None:
    """Print the table."""
    twelve, five = load("merlin"), load("audi-25-tfsi")
    idle = cycle(five, speed=83.8, imep=2e5)
    loads = np.linspace(2e5, 12e5, LOADS)
    rows = [
        (
            "cycle and gas torque of a V12, warm",
            lambda: gas_torque(cycle(twelve, imep=10e5)),
            "2 ms",
        ),
        (
            f"gas torque of a V12 at {LOADS:,} loads",
            lambda: torques_at_loads(twelve, imep=loads).total,
            "1 s",
        ),
        (
            "speed over a cycle of a five, nonlinear",
            lambda: driven(five, idle, flywheel=0.2),
            "100 ms",
        ),
        ("side thrust of a V12", lambda: side_thrust(twelve, cycle(twelve, imep=10e5)), "-"),
    ]
    shown: list[tables.Row] = []
    for what, work, budget in rows:
        took = seconds(work, times=TIMES if budget != "1 s" else 5)
        shown.append((what, f"{1000 * took:.3g} ms", budget))
    tables.show("gas", shown)


if __name__ == "__main__":
    main()
