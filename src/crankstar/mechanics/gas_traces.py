"""When valves and ports of a chamber act, and what a measured pressure says of its charge.

A cylinder that does not burn compresses the charge that it draws. Where the others were measured,
that is the pressure that their trace has as compression begins, and what it pushes out stands
against the mean that the trace has after the blow-down.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping
from math import radians

import numpy as np

from crankstar.engine.engine import Engine
from crankstar.engine.gas_checks import repeats
from crankstar.engine.volumes import Volumes
from crankstar.mechanics.charge_air import events
from crankstar.spectra import Real

CHARGE_WINDOW = radians(10.0)
"""Radians before compression begins over which the charge pressure of a trace is a mean: a mean of
several samples, so that noise of one does not move all of a compression."""


def charges_of_trace(
    engine: Engine, places: Volumes, lost: Mapping[int, float], assumed: Collection[str]
) -> dict[int, dict[str, float]]:
    """Pressures of charge and exhaust, Pa, of each chamber that lacks combustion, by row.

    Those that the file does not give are read off its own trace: what it draws as compression
    begins, and the mean of what it pushes the charge out against. None without a trace.
    """
    if engine.gas is None or engine.gas.trace is None or not any(lost.values()):
        return {}
    measured = traced(engine, places)
    count = measured.shape[-1]
    own = np.arange(count) * (places.cycle / count)

    def mean(row: int, *, start: float, end: float) -> float:
        angle = np.linspace(start, end, 41)
        return float(np.interp(angle, own, measured[row], period=places.cycle).mean())

    charges: dict[int, dict[str, float]] = {}
    for row, number in enumerate(places.numbers):
        if not lost[number]:
            continue
        happens = events(engine, float(places.bottom[places.kind[row]]))
        pushed = max(happens.exchange[0], happens.emptied + CHARGE_WINDOW)
        read = {
            "intake_pressure": mean(row, start=happens.closed - CHARGE_WINDOW, end=happens.closed),
            "exhaust_pressure": mean(row, start=happens.emptied, end=pushed),
        }
        charges[row] = {name: value for name, value in read.items() if name in assumed}
    return charges


def traced(engine: Engine, places: Volumes) -> Real:
    """The measured pressure of every chamber at the samples, by a periodic cubic spline."""
    from scipy.interpolate import CubicSpline

    assert engine.gas is not None  # noqa: S101  # asked before
    assert engine.gas.trace is not None  # noqa: S101
    trace = engine.gas.trace
    end = -1 if repeats(trace, places.cycle) else None
    angle = np.array([*trace.angle[:end], trace.angle[0] + places.cycle])
    count = places.rate.shape[-1]
    step = np.arange(count) * places.cycle / count
    rows = [
        CubicSpline(angle, [*pressure[:end], pressure[0]], bc_type="periodic")(
            angle[0] + (step - angle[0]) % places.cycle
        )
        for pressure in trace.pressure
    ]
    if len(rows) == 1:
        return np.array(rows * len(places.numbers))
    by_number = dict(zip(trace.chambers or places.numbers, rows, strict=True))
    return np.array([by_number[number] for number in places.numbers])
