"""Positions of webs, ends and main bearings along a crankshaft.

Engine files say where pins are, not where webs and bearings are. Here a crankshaft has a main
bearing half way between two neighbouring throws and one as far beyond the first and the last, and a
web half way between a pin and each bearing beside it. Pins nearer to each other than a third of the
bore pitch (split pins) are one throw, with no bearing between.
"""

from __future__ import annotations

from itertools import pairwise
from typing import NamedTuple

from crankstar.engine.engine import Engine
from crankstar.engine.records import Shaft

SAME_THROW = 0.35
"""Bore pitches: pins closer than this stand between the same two bearings.

Banks of boxers are about half a pitch apart.
"""


class Span(NamedTuple):
    """The throws (from 1) between two main bearings, with z of bearings and webs, front first."""

    throws: tuple[int, ...]
    bearings: tuple[float, float]
    webs: tuple[float, float]


def spans(engine: Engine, shaft: Shaft) -> tuple[Span, ...]:
    """The throws of a crankshaft from front to rear, each with its bearings and webs.

    >>> from crankstar.files.catalog import load
    >>> engine = load("v8-cross-plane")
    >>> [span.webs for span in spans(engine, engine.shafts[0])][0]
    (1.75, 1.25)
    """
    groups = _groups(engine, shaft)
    if not groups:
        return ()
    ends = [
        (max(places), min(places))
        for places in ([shaft.throws[n - 1].z for n in group] for group in groups)
    ]
    gaps = [rear - front for (_, rear), (front, _) in pairwise(ends)]
    room = min(gaps, default=_room(engine)) / 2
    between = [(rear + front) / 2 for (_, rear), (front, _) in pairwise(ends)]
    bearings = [ends[0][0] + room, *between, ends[-1][1] - room]
    return tuple(
        Span(group, (ahead, behind), ((ahead + front) / 2, (behind + rear) / 2))
        for group, (front, rear), (ahead, behind) in zip(
            groups, ends, pairwise(bearings), strict=True
        )
    )


def main_bearings(engine: Engine, shaft: Shaft) -> tuple[float, ...]:
    """Places z of the main bearings of a crankshaft, front first: one more than it has throws."""
    along = spans(engine, shaft)
    return (*(span.bearings[0] for span in along), along[-1].bearings[1]) if along else ()


def webs(engine: Engine, shaft: Shaft) -> tuple[float, ...]:
    """Places z of all webs of a crankshaft, front first, two to a throw."""
    return tuple(web for span in spans(engine, shaft) for web in span.webs)


def end_webs(engine: Engine, shaft: Shaft) -> tuple[float, ...]:
    """Places z of the first and the last web of a crankshaft."""
    places = webs(engine, shaft)
    return (places[0], places[-1]) if places else ()


def end_planes(engine: Engine) -> tuple[float, float]:
    """The usual planes of balance shaft weights, half a bore pitch beyond the end cylinders."""
    places = [cylinder.z for cylinder in engine.cylinders]
    room = _room(engine) / 2
    return max(places) + room, min(places) - room


def _room(engine: Engine) -> float:
    """A bore pitch; without one the stroke, or part of it for cylinders almost in one plane."""
    several = len({cylinder.z for cylinder in engine.cylinders}) > 1
    if "pitch" in engine.relative or "radius" in engine.relative:
        return engine.pitch
    stroke = 2 * engine.throw(engine.first).radius
    if engine.bore_pitch is not None:
        return engine.bore_pitch
    return max(engine.pitch, stroke / 4) if several else stroke


def _groups(engine: Engine, shaft: Shaft) -> list[tuple[int, ...]]:
    """Numbers of the throws that stand between the same bearings, front first."""
    order = sorted(range(1, len(shaft.throws) + 1), key=lambda number: -shaft.throws[number - 1].z)
    groups: list[tuple[int, ...]] = []
    for number in order:
        place = shaft.throws[number - 1].z
        near = groups and shaft.throws[groups[-1][-1] - 1].z - place < SAME_THROW * engine.pitch
        groups = [*groups[:-1], (*groups[-1], number)] if near else [*groups, (number,)]
    return groups
