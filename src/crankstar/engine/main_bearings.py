"""Main bearings and webs of a crankshaft: given, or assumed from its pins; what is wrong with them.

A shaft may give the places of its main bearings (`bearings`), or their number only
(`bearing_count`), and the planes of its webs. Of what it does not give, this is assumed:

* a main bearing half way between two neighbouring throws, and one as far beyond the first and the
  last. Pins nearer to each other than a third of the bore pitch (split pins) are one throw. Fewer
  bearings stand in gaps evenly spread over the throws, an in-line four with three after its
  throws 0, 2 and 4; more than throws plus one stand in the widest gaps between split pins;
* a web half way between a pin and the bearing beside it, and one in the middle of a gap without
  bearing.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import Any, NamedTuple

from crankstar.engine.assembly import Assembly
from crankstar.engine.records import Shaft
from crankstar.language.faults import Fault

SAME_THROW = 0.35
"""Bore pitches: pins closer than this are one throw. Banks of boxers are about half a pitch apart.
"""
OVERLAP = 0.02
"""Bore pitches: bearings and webs nearer to each other than this cannot be built."""
REACH = 2.0
"""Bore pitches, strokes or bores by which bearings and webs may stand beyond the end pins."""


class PinGroup(NamedTuple):
    """Throws (from 1) with no main bearing between them, and z of the webs ahead and behind.

    One throw, or the split pins of one. An overhung throw with one web has it on both sides.
    """

    throws: tuple[int, ...]
    webs: tuple[float, float]


def main_bearings(engine: Assembly, shaft: Shaft) -> tuple[float, ...]:
    """Places z of the main bearings of a shaft, front first.

    A shaft without throws, whose file gives none, has two: at the usual planes of balance shafts
    if it has weights, else none.

    >>> from crankstar.engine.copies import with_values
    >>> from crankstar.files.catalog import load
    >>> four = load("i4")
    >>> [len(main_bearings(four, with_values(four.shafts[0], bearing_count=n))) for n in (2, 3, 5)]
    [2, 3, 5]
    >>> main_bearings(four, with_values(four.shafts[0], bearing_count=3))
    (2.0, 0.0, -2.0)
    """
    if shaft.bearings:
        return shaft.bearings
    if not shaft.throws:
        return end_planes(engine) if shaft.weights else ()
    ends = _ends(shaft, _close_pins(engine, shaft))
    gaps = [(rear, front) for (_, rear), (front, _) in pairwise(ends)]
    beyond = _end_room(engine, ends)
    count = shaft.bearing_count or len(gaps) + 2
    inside = _filled(gaps, shaft, count - 2)
    between = [(ahead + behind) / 2 for ahead, behind in inside]
    return (ends[0][0] + beyond, *between, ends[-1][1] - beyond)


def _filled(
    gaps: Sequence[tuple[float, float]], shaft: Shaft, count: int
) -> list[tuple[float, float]]:
    """The gaps between pins that hold so many bearings, front first."""
    if count <= len(gaps):
        throws = len(gaps) + 1
        return [gaps[round(index * throws / (count + 1)) - 1] for index in range(1, count + 1)]
    pins = pairwise(_pin_places(shaft))
    others = sorted((gap for gap in pins if gap not in gaps), key=lambda gap: gap[1] - gap[0])
    return sorted([*gaps, *others[: count - len(gaps)]], reverse=True)


def pin_groups(engine: Assembly, shaft: Shaft) -> tuple[PinGroup, ...]:
    """The throws of a crankshaft from front to rear, each with its webs.

    >>> from crankstar.files.catalog import load
    >>> engine = load("v8-cross-plane")
    >>> [group.webs for group in pin_groups(engine, engine.shafts[0])][0]
    (1.75, 1.25)
    """
    bearings = main_bearings(engine, shaft)
    groups = _split(_close_pins(engine, shaft), shaft, bearings)
    if not groups:
        return ()
    ends = _ends(shaft, groups)
    beyond = _end_room(engine, _ends(shaft, _close_pins(engine, shaft)))
    out: list[PinGroup] = []
    for index, (group, (front, rear)) in enumerate(zip(groups, ends, strict=True)):
        ahead = ends[index - 1][1] if index else None
        behind = ends[index + 1][0] if index + 1 < len(ends) else None
        if shaft.webs:
            webs = _given_webs(shaft.webs, (ahead, front, rear, behind))
        else:
            webs = (
                front + _web(front, ahead, bearings, beyond, side=1),
                rear - _web(rear, behind, bearings, beyond, side=-1),
            )
        out.append(PinGroup(group, webs))
    return tuple(out)


def _web(
    pin: float, neighbour: float | None, bearings: Sequence[float], beyond: float, *, side: int
) -> float:
    """Distance of a web from its pin, `side` 1 ahead of it, -1 behind."""
    gap = None if neighbour is None else side * (neighbour - pin)
    beside = [side * (z - pin) for z in bearings if side * (z - pin) > 0]
    nearest = min(beside, default=None)
    if nearest is not None and (gap is None or nearest < gap):
        return nearest / 2
    return beyond / 2 if gap is None else gap / 2


def _given_webs(
    webs: Sequence[float], between: tuple[float | None, float, float, float | None]
) -> tuple[float, float]:
    """The webs beside pins from `front` to `rear`, their neighbours `ahead` and `behind`."""
    ahead, front, rear, behind = between
    before = [z for z in webs if z > front and (ahead is None or z < ahead)]
    after = [z for z in webs if z < rear and (behind is None or z > behind)]
    beside = [*before[-1:], *after[:1]]
    return (beside[0], beside[-1]) if beside else (front, rear)


def webs(engine: Assembly, shaft: Shaft) -> tuple[float, ...]:
    """Places z of all webs of a crankshaft, front first; two to a throw unless the file differs."""
    if shaft.webs:
        return shaft.webs
    return tuple(dict.fromkeys(z for group in pin_groups(engine, shaft) for z in group.webs))


def end_webs(engine: Assembly, shaft: Shaft) -> tuple[float, ...]:
    """Places z of the first and the last web of a crankshaft."""
    places = webs(engine, shaft)
    return (places[0], places[-1]) if places else ()


def end_planes(engine: Assembly) -> tuple[float, float]:
    """The usual planes of balance shaft weights, half a bore pitch beyond the end cylinders."""
    places = [cylinder.z for cylinder in engine.cylinders]
    beyond = room(engine) / 2
    return max(places) + beyond, min(places) - beyond


def room(engine: Assembly) -> float:
    """A bore pitch; without one the stroke, or part of it for throws almost in one plane."""
    several = len({throw.z for shaft in engine.shafts for throw in shaft.throws}) > 1
    if "pitch" in engine.relative or "radius" in engine.relative:
        return engine.pitch
    if engine.bore_pitch is not None:
        return engine.bore_pitch
    stroke = _stroke(engine)
    return max(engine.pitch, stroke / 4) if several else stroke


def _stroke(engine: Assembly) -> float:
    """The first cylinder's; 1 m where its throw, in an impossible assembly, is not there."""
    first = engine.first
    throws = next((shaft.throws for shaft in engine.shafts if shaft.name == first.shaft), ())
    return 2 * throws[first.throw - 1].radius if first.throw <= len(throws) else 1.0


def _end_room(engine: Assembly, ends: Sequence[tuple[float, float]]) -> float:
    """From an end pin to the bearing beyond it: half the least gap between throws."""
    gaps = (rear - front for (_, rear), (front, _) in pairwise(ends))
    return min(gaps, default=room(engine)) / 2


def _ends(shaft: Shaft, groups: Sequence[tuple[int, ...]]) -> list[tuple[float, float]]:
    """The front and the rear pin of each group, z."""
    places = [[shaft.throws[number - 1].z for number in group] for group in groups]
    return [(max(group), min(group)) for group in places]


def _pin_places(shaft: Shaft) -> list[float]:
    """Places z of the pins, front first, each once."""
    return sorted({throw.z for throw in shaft.throws}, reverse=True)


def _close_pins(engine: Assembly, shaft: Shaft) -> list[tuple[int, ...]]:
    """Numbers of the throws that are one throw with split pins, front first."""
    order = sorted(range(1, len(shaft.throws) + 1), key=lambda number: -shaft.throws[number - 1].z)
    groups: list[tuple[int, ...]] = []
    for number in order:
        place = shaft.throws[number - 1].z
        near = groups and shaft.throws[groups[-1][-1] - 1].z - place < SAME_THROW * engine.pitch
        groups = [*groups[:-1], (*groups[-1], number)] if near else [*groups, (number,)]
    return groups


def _split(
    groups: Sequence[tuple[int, ...]], shaft: Shaft, bearings: Sequence[float]
) -> list[tuple[int, ...]]:
    """The groups divided where a bearing stands between their pins."""
    out: list[tuple[int, ...]] = []
    for group in groups:
        out.append(group[:1])
        for before, number in pairwise(group):
            ahead, z = shaft.throws[before - 1].z, shaft.throws[number - 1].z
            if any(z < bearing < ahead for bearing in bearings):
                out.append((number,))
            else:
                out[-1] = (*out[-1], number)
    return out


def faults(engine: Assembly) -> Iterator[Fault]:
    """What cannot be of main bearings and webs that are given."""
    for index, shaft in enumerate(engine.shafts):
        yield from _faults(engine, shaft, ("shaft", index))


def _faults(engine: Assembly, shaft: Shaft, here: tuple[str | int, ...]) -> Iterator[Fault]:
    count = shaft.bearing_count
    if count is not None and shaft.bearings:
        yield Fault((*here, "bearing_count"), "bearings.counted-twice")
    elif count is not None:
        most = len(_pin_places(shaft)) + 1
        if not shaft.throws:
            yield Fault((*here, "bearing_count"), "bearings.no-throws", {"value": count})
        elif count > most:
            values = {"value": count, "count": most - 1, "most": most}
            yield Fault((*here, "bearing_count"), "bearings.too-many", values)
    if len(shaft.bearings) == 1:
        yield Fault((*here, "bearings"), "bearings.too-few")
    given = [name for name in ("bending_stiffness", "bearing_stiffness") if getattr(shaft, name)]
    if len(given) == 1:
        other = ({"bending_stiffness", "bearing_stiffness"} - {*given}).pop()
        yield Fault((*here, given[0]), "bearings.one-stiffness", {"other": other})
    misplaced = [
        *_misplaced(engine, shaft, (*here, "bearings"), shaft.bearings),
        *_misplaced(engine, shaft, (*here, "webs"), shaft.webs),
    ]
    yield from misplaced
    if not misplaced:
        yield from _collisions(engine, shaft, here)


def _unit(engine: Assembly) -> str:
    """The unit of places along a crankshaft."""
    return "bore pitches" if "pitch" in engine.relative else "m"


def _reach(engine: Assembly) -> float:
    """How far beyond its end pins a crankshaft may have bearings and webs.

    Cylinders almost in one plane, as of a V twin, are closer than its bearings are to its crankpin:
    there the stroke and the bore count.
    """
    pitch = room(engine)
    if "pitch" in engine.relative or "radius" in engine.relative:
        return REACH * pitch
    return REACH * max(pitch, _stroke(engine), engine.first.bore or 0.0)


def _misplaced(
    engine: Assembly, shaft: Shaft, here: tuple[str | int, ...], places: Sequence[float]
) -> Iterator[Fault]:
    """Places beyond the crankshaft, out of order, or at the same place."""
    kind, pitch = str(here[-1]), room(engine)
    reach, unit = _reach(engine), _unit(engine)
    pins = _pin_places(shaft)
    for index, z in enumerate(places):
        values: dict[str, Any] = {"value": z, "unit": unit}
        if pins and not pins[-1] - reach <= z <= pins[0] + reach:
            values |= {"rear": pins[-1], "front": pins[0], "room": reach}
            yield Fault((*here, index), f"{kind}.outside", values)
        elif index and z > places[index - 1] + OVERLAP * pitch:
            values |= {"before": places[index - 1]}
            yield Fault((*here, index), f"{kind}.out-of-order", values)
        elif index and places[index - 1] - z < OVERLAP * pitch:
            values |= {"before": places[index - 1], "least": OVERLAP * pitch}
            yield Fault((*here, index), f"{kind}.overlap", values)


def _collisions(engine: Assembly, shaft: Shaft, here: tuple[str | int, ...]) -> Iterator[Fault]:
    """Bearings and webs on a pin, webs on a bearing, throws without a web."""
    least = OVERLAP * room(engine)
    for kind, places in (("bearings", shaft.bearings), ("webs", shaft.webs)):
        for index, z in enumerate(places):
            pin = next(
                (n for n, throw in enumerate(shaft.throws, 1) if abs(throw.z - z) < least), 0
            )
            if pin:
                values = {"value": z, "unit": _unit(engine), "throw": pin}
                yield Fault((*here, kind, index), f"{kind}.on-a-pin", values)
    for index, z in enumerate(shaft.webs):
        bearing = next((n for n, b in enumerate(shaft.bearings, 1) if abs(b - z) < least), 0)
        if bearing:
            values = {"value": z, "unit": _unit(engine), "bearing": bearing}
            yield Fault((*here, "webs", index), "webs.on-a-bearing", values)
    beside = {*shaft.webs}
    for group in pin_groups(engine, shaft):
        if beside and not beside.issuperset(group.webs):
            values = {"throw": group.throws[0]}
            yield Fault((*here, "webs"), "webs.missing", values)
