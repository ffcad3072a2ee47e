"""Values of a sweep at which hardly any engine runs, or for which something else is assumed.

The doubts of one engine (`mechanics.doubts`), tried at values over the whole range: a charge that
cannot burn its fuel. How an engine ignites that does not say so goes by its sizes, its compression
ratio and its speed: it may be another at another value.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from contextlib import suppress
from itertools import groupby, pairwise, product
from typing import NamedTuple

import numpy as np

from crankstar.dynamics.mount_doubts import mount_doubts
from crankstar.engine.engine import Engine
from crankstar.language.faults import Fault, where
from crankstar.language.messages import MessageError
from crankstar.mechanics.doubts import doubts_of
from crankstar.mechanics.gas import cycle
from crankstar.mechanics.operating_points import ASSUMED, operating_state, resolved
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


class Ignited(NamedTuple):
    """How the engines of a sweep ignite, which their file does not say and which is not one.

    `runs` are the places of the first and the last value that follow each other with what is
    assumed of them, `also` what is assumed with it.
    """

    runs: tuple[tuple[tuple[int, ...], tuple[int, ...], str], ...]
    also: tuple[str, ...]


def ignited(sweep: Sweep, curves: Sequence[Curve]) -> Ignited | None:
    """How the engines of a sweep with gas ignite, where it is assumed and changes in the range.

    The place where it changes is found to a value, between two that are tried.

    >>> from crankstar.studies.sweep import sweep, watched
    >>> found = sweep("audi-25-tfsi", "gas.compression_ratio=8..20/25")
    >>> own = ignited(found, [watched(found, "mean_torque")])
    >>> [(*found.values[[*first, *last]].tolist(), fires) for first, last, fires in own.runs]
    [(8.0, 14.0, 'spark'), (14.5, 20.0, 'compression')]
    """
    if "gas" not in judged(sweep, curves).answer.uses:
        return None
    most = TRIED[min(len(sweep.axes), len(TRIED)) - 1]
    known: dict[tuple[int, ...], str] = {}
    names: set[str] = set()

    def fires(place: tuple[int, ...]) -> str:
        with suppress(MessageError):
            engine, speed = sweep.case(place)
            state = operating_state(engine, speed=speed)
            values, assumed = resolved(engine, point=state.point, speed=state.speed)
            if "ignition" in assumed:
                names.update(assumed)
                known[place] = values["ignition"]
        return known.get(place, "")

    places = [*product(*(_spread(axis.values.size, most) for axis in sweep.axes))]
    for place in places:
        fires(place)
    if len(sweep.axes) == 1:
        for (before,), (after,) in pairwise(sorted(known)):
            low, high = before, after
            while known[before,] != known[after,] and high - low > 1:
                middle = (low + high) // 2
                low, high = (middle, high) if fires((middle,)) == known[before,] else (low, middle)
    rows = [[*own] for _fires, own in groupby(sorted(known), known.__getitem__)]
    if len({*known.values()}) == 1 or not rows:
        return None
    differ = {name for name in names if len({ASSUMED[own].get(name) for own in ASSUMED}) > 1}
    runs = tuple((own[0], own[-1], known[own[0]]) for own in rows)
    return Ignited(runs, tuple(sorted(differ)))


def _runs(tried: Sequence[int], doubtful: Collection[int]) -> tuple[tuple[int, int], ...]:
    """The first and the last of each row of neighbours that are doubtful.

    >>> _runs([0, 1, 3, 5, 7], {0, 1, 7})
    ((0, 1), (7, 7))
    """
    rows = [[*own] for bad, own in groupby(tried, lambda place: place in doubtful) if bad]
    return tuple((own[0], own[-1]) for own in rows)


def _at(engine: Engine, speed: float | None, uses: Collection[str]) -> tuple[Fault, ...]:
    burns = "gas" in uses and engine.gas is not None
    found = doubts_of(engine, uses, cycle(engine, speed=speed) if burns else None)
    return (*found, *mount_doubts(engine)) if "mounts" in uses else found


def _spread(count: int, most: int) -> list[int]:
    """Places spread over all, both ends among them."""
    return sorted({round(each) for each in np.linspace(0, count - 1, min(count, most)).tolist()})
