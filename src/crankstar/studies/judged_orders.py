"""Firing orders by what they do to the crankshaft: its shear stress, the load on its bearings.

Vector sums (`firing.weighing`) weigh one order of the crank each. Here every firing order is put
into the engine, and the whole is computed: `stress`, the greatest shear stress of torsion over the
cycle, of all orders with their phases, over the speeds of the engine; `bearings`, the greatest load
on a main bearing over the cycle, gas and inertia, at an operating point.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Literal, NamedTuple

import numpy as np

from crankstar import spectra
from crankstar.dynamics.bearings import BearingError, bearing_loads
from crankstar.dynamics.torsion_peaks import torsion_peak
from crankstar.dynamics.torsion_system import TorsionError
from crankstar.engine.engine import Engine
from crankstar.firing.numbering import with_order
from crankstar.firing.orders import Order
from crankstar.language.messages import MessageError
from crankstar.mechanics.gas import cycle
from crankstar.mechanics.operating_points import GasError
from crankstar.stars.sequence_engines import with_fired
from crankstar.stars.shafts import Fired, Shaft
from crankstar.studies.variants import SweepError

Judge = Literal["stress", "bearings"]
JUDGES: tuple[Judge, ...] = ("stress", "bearings")
UNITS: dict[Judge, str] = {"stress": "MPa", "bearings": "N"}


class JudgingError(MessageError):
    """Firing orders that cannot be judged, and why."""


FAILURES = (BearingError, GasError, JudgingError, SweepError, TorsionError)
"""What is raised where an engine says too little."""
SAME = 1e-9


class Way(NamedTuple):
    """A star with its firing sequence, and what is computed of the engine that has them."""

    fired: Fired
    value: float


class JudgedWays(NamedTuple):
    """The best way of each row of a front, by the order that the row shows, and orders beside it.

    judged: how many ways were; of: how many there are, where not all were kept.
    """

    rows: dict[Fired, Way]
    beside: dict[Fired, float]
    judged: int
    of: int


def _stress(engine: Engine, point: str) -> float:
    return torsion_peak(engine, point=point) / 1e6


def _bearings(engine: Engine, point: str) -> float:
    loads = bearing_loads(engine, cycle=cycle(engine, point=point))
    if not loads.bearings:
        raise JudgingError("the crankshaft has no main bearings")
    return float(spectra.peaks(loads.load).max())


_VALUES: dict[Judge, Callable[[Engine, str], float]] = {"stress": _stress, "bearings": _bearings}


def judgement(engine: Engine, judge: Judge, *, point: str = "") -> float:
    """The greatest shear stress of torsion, or bearing load, of an engine, in the unit of UNITS.

    Raises JudgingError, GasError, SweepError, TorsionError or BearingError where the engine says
    too little.
    """
    return _VALUES[judge](engine, point)


def judged(
    engine: Engine,
    orders: Iterable[Order],
    judge: Judge | Callable[[Engine], float],
    *,
    point: str = "",
) -> tuple[tuple[Order, ...], tuple[float, ...]]:
    """The orders, least first, and of each the value, in the unit of UNITS; equal ones as before.

    `judge`: also any function of the engine that fires so; less is better. Raises what `judgement`
    or the function raises.

    >>> from crankstar.files.catalog import load
    >>> from crankstar.firing.orders import even_orders
    >>> four = load("honda-b18c", changes={"cylinder.reciprocating_mass": "0.5 kg"})
    >>> best, values = judged(four, even_orders(four), "bearings")
    >>> len(best), values[0] <= values[1]
    (2, True)
    """
    every = tuple(orders)
    engines = (with_order(engine, each.firing) for each in every)
    values = [
        float(judge(each)) if callable(judge) else judgement(each, judge, point=point)
        for each in engines
    ]
    scale = max(values, default=0.0) or 1.0
    places = np.argsort(np.rint(np.array(values) / (scale * SAME)), kind="stable")
    return tuple(every[place] for place in places), tuple(values[place] for place in places)


def best_way(
    engine: Engine, shaft: Shaft, ways: Iterable[Fired], judge: Judge, *, point: str = ""
) -> Way:
    """The way with the least stress or bearing load of some; of equal ones the first.

    Vector sums are the same for an order and its mirror image, stress is not: the phases of gas
    and inertia change. Raises what `judgement` raises.

    >>> from crankstar.files.catalog import load
    >>> from crankstar.stars.sequence_engines import shaft_of_engine
    >>> five = load("audi-25-tfsi", changes={"cylinder.reciprocating_mass": "0.6 kg"})
    >>> shaft = shaft_of_engine(five)
    >>> own = shaft.fired_in(five.firing_order)
    >>> best = best_way(five, shaft, (own, shaft.mirrored(own)), "bearings")
    >>> best.value <= best_way(five, shaft, (own,), "bearings").value
    True
    """
    best: Way | None = None
    for fired in ways:
        value = judgement(with_fired(engine, shaft, fired), judge, point=point)
        if best is None or value < best.value * (1 - SAME):
            best = Way(fired, value)
    if best is None:
        raise JudgingError("there is no order to judge")
    return best
