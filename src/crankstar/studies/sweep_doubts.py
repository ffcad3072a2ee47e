"""Values of a sweep at which hardly any engine runs: a charge that cannot burn its fuel.

The doubts of one engine (`mechanics.doubts`), tried at values over the whole range.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from contextlib import suppress
from itertools import groupby, product
from typing import NamedTuple

import numpy as np

from crankstar.engine.engine import Engine
from crankstar.language.faults import Fault, where
from crankstar.language.messages import MessageError
from crankstar.mechanics.doubts import doubts_of
from crankstar.mechanics.gas import cycle
from crankstar.studies.sweep import Curve, Sweep
from crankstar.studies.sweep_answers import judged

TRIED = (31, 6)
"""Values of one number, and of each of two, that are tried."""


class Doubted(NamedTuple):
    """One kind of doubt: the `places` of the values tried at which it is, and what it says.

    `fault` is that of `at`, an end of the range where it is one. `everywhere`: at all tried. `runs`
    are the first and the last of those of one number that follow each other.
    """

    fault: Fault
    at: tuple[int, ...]
    places: tuple[tuple[int, ...], ...]
    everywhere: bool
    runs: tuple[tuple[int, int], ...]


def doubted(sweep: Sweep, curves: Sequence[Curve]) -> tuple[Doubted, ...]:
    """What is hardly right of the engines of a sweep, each kind once.

    Without what is so at every value and of another number: the record of an answer has it.

    >>> from crankstar.studies.sweep import sweep, watched
    >>> found = sweep("honda-b18c", "gas.intake_pressure=0.3..0.9 bar/4")
    >>> [one] = doubted(found, [watched(found, "mean_torque")])
    >>> one.fault.code, found.values[[place for place, in one.places]].tolist(), one.everywhere
    ('doubt.charge', [0.3, 0.5], False)
    """
    uses = judged(sweep, curves).answer.uses
    most = TRIED[min(len(sweep.axes), len(TRIED)) - 1]
    tried = [_spread(axis.values.size, most) for axis in sweep.axes]
    found: dict[str, dict[tuple[int, ...], Fault]] = {}
    places = [*product(*tried)]
    for place in places:
        with suppress(MessageError):
            for fault in _at(*sweep.case(place), uses):
                if fault.code == "doubt.friction" and "running" not in uses:
                    continue  # no result has it
                found.setdefault(fault.code, {})[place] = fault
    last = tuple(axis.values.size - 1 for axis in sweep.axes)
    varied = {axis.path for axis in sweep.axes}
    out: list[Doubted] = []
    for faults in found.values():
        everywhere = len(faults) == len(places)
        if everywhere and where(next(iter(faults.values())).path) not in varied:
            continue
        at = last if last in faults else next(iter(faults))
        runs = _runs(tried[0], {place for place, *_others in faults})
        out.append(Doubted(faults[at], at, tuple(faults), everywhere, runs))
    return tuple(out)


def _runs(tried: Sequence[int], doubtful: Collection[int]) -> tuple[tuple[int, int], ...]:
    """The first and the last of each row of neighbours that are doubtful.

    >>> _runs([0, 1, 3, 5, 7], {0, 1, 7})
    ((0, 1), (7, 7))
    """
    rows = [[*own] for bad, own in groupby(tried, lambda place: place in doubtful) if bad]
    return tuple((own[0], own[-1]) for own in rows)


def _at(engine: Engine, speed: float | None, uses: Collection[str]) -> tuple[Fault, ...]:
    burns = "gas" in uses and engine.gas is not None
    return doubts_of(engine, uses, cycle(engine, speed=speed) if burns else None)


def _spread(count: int, most: int) -> list[int]:
    """Places spread over all, both ends among them."""
    return sorted({round(each) for each in np.linspace(0, count - 1, min(count, most)).tolist()})
