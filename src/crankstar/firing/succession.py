"""Succession of firings: intervals within a group, neighbours and pin partners in succession.

Two neighbours that fire in succession load the main bearing between them twice and heat one part
of the block; uneven intervals within a bank make its exhaust note uneven.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence
from itertools import pairwise
from typing import NamedTuple

from crankstar.engine.engine import Engine
from crankstar.firing.intervals import Firing


class Follower(NamedTuple):
    """A firing chamber, the next one, and the interval in degrees of the reference shaft."""

    first: int
    then: int
    interval_deg: float


def followers(firing: Firing, group: Collection[int] | None = None) -> tuple[Follower, ...]:
    """Each firing of a group of chambers (default: all) and the next, once round the cycle.

    >>> from crankstar.files.catalog import load
    >>> from crankstar.firing.intervals import firing
    >>> fired = firing(load("v8-cross-plane"))
    >>> [step.interval_deg for step in followers(fired, group=(1, 3, 5, 7))]
    [270.0, 180.0, 90.0, 180.0]
    """
    fired = [
        (n, a)
        for n, a in zip(firing.order, firing.angles_deg, strict=True)
        if group is None or n in group
    ]
    return once_round(fired, cycle_deg=firing.cycle_deg)


def once_round(events: Sequence[tuple[int, float]], *, cycle_deg: float) -> tuple[Follower, ...]:
    """Each event (chamber, ascending angle in degrees) and the next, once round the cycle."""
    if not events:
        return ()
    first, angle = events[0]
    return tuple(
        Follower(n, m, round(b - a, 9))
        for (n, a), (m, b) in pairwise([*events, (first, angle + cycle_deg)])
    )


def neighbours(engine: Engine) -> frozenset[frozenset[int]]:
    """Pairs of chambers that stand next to each other in a bank."""
    places = {cylinder.number: cylinder.z for cylinder in engine.cylinders}
    chamber = {
        cylinder.number: cylinder.chamber or cylinder.number for cylinder in engine.cylinders
    }
    rows = (sorted(numbers, key=places.__getitem__) for numbers in engine.banks.values())
    return _different(
        (chamber[number], chamber[other]) for row in rows for number, other in pairwise(row)
    )


def partners(engine: Engine) -> frozenset[frozenset[int]]:
    """Pairs of chambers with rods on the same throw (the halves of a split pin are two throws)."""
    on: dict[tuple[str, int], list[int]] = {}
    for cylinder in engine.cylinders:
        on.setdefault((cylinder.shaft, cylinder.throw), []).append(
            cylinder.chamber or cylinder.number
        )
    return _different(
        (number, other) for numbers in on.values() for number in numbers for other in numbers
    )


def in_succession(firing: Firing, pairs: Collection[frozenset[int]]) -> tuple[Follower, ...]:
    """The firings of which the one and the next are such a pair, in firing order."""
    return tuple(step for step in followers(firing) if frozenset((step.first, step.then)) in pairs)


def _different(pairs: Iterable[tuple[int, int]]) -> frozenset[frozenset[int]]:
    return frozenset(frozenset(pair) for pair in pairs if pair[0] != pair[1])
