"""All ways to give each chamber one of its dead centres: at given instants, or any apart.

A chamber whose shaft comes round every P degrees is at top dead centre C/P times in a cycle of C
degrees (a four-stroke cylinder twice), and fires at one of them. Chambers that can fire at no
instant in common do not disturb each other; so the chambers fall into groups, the ways of a group
are found one by one, and those of the engine are their product.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from itertools import islice
from math import gcd, lcm
from typing import NamedTuple

from crankstar.engine.dead_centres import SAME_ANGLE, dead_centres
from crankstar.engine.engine import Engine
from crankstar.language.faults import ValueFaultError

GREATEST_COUNT = 1 << 14
"""Greatest number of ways that are listed; of more only the number is given."""

Reach = Mapping[int, Mapping[int, float]]
"""For each chamber: its possible places in a timetable, each with its crank angle (degrees)."""


class OrderError(ValueFaultError):
    """Firing orders that cannot be listed, and why."""


class Turns(NamedTuple):
    """The dead centres of each chamber in a cycle of `cycle_deg`, counted from the `anchor`.

    The `anchor` is the chamber whose dead centre comes round least often, of several the lowest
    number; `starts` are those of its dead centres that no shift brings onto each other: one, where
    all shafts turn equally fast.
    """

    angles: Mapping[int, tuple[float, ...]]
    cycle_deg: float
    anchor: int
    starts: tuple[float, ...]


def turns(engine: Engine) -> Turns:
    """The dead centres within a cycle; raises OrderError where a shaft's turns do not divide it."""
    centres = dict(sorted(dead_centres(engine).items()))
    cycle = engine.cycle_angle
    angles: dict[int, tuple[float, ...]] = {}
    for number, (first, period) in centres.items():
        times = round(cycle / period)
        if abs(cycle / period - times) > 1e-9:
            raise OrderError("orders.odd-period", number=number, period=period, cycle=cycle)
        angles[number] = tuple(first + turn * period for turn in range(times))
    periods = {
        number: Fraction(centre.period_deg).limit_denominator(1000)
        for number, centre in centres.items()
    }
    anchor = max(periods, key=lambda number: (periods[number], -number))
    common = Fraction(
        lcm(*(p.numerator for p in periods.values())),
        gcd(*(p.denominator for p in periods.values())),
    )
    return Turns(angles, cycle, anchor, angles[anchor][: round(common / periods[anchor])])


def off(angle_deg: float, *, cycle_deg: float) -> float:
    """An angle less whole cycles: in [-cycle/2, cycle/2)."""
    return (angle_deg + cycle_deg / 2) % cycle_deg - cycle_deg / 2


def reach_of(
    centres: Turns, instants_deg: Sequence[float], *, start: float, tolerance_deg: float
) -> Reach:
    """The chambers that can fire at each instant, degrees from `start`; 0 is the anchor's."""
    out: dict[int, dict[int, float]] = {}
    for number, angles in centres.angles.items():
        if number == centres.anchor:
            out[number] = {0: start}
            continue
        gaps: dict[int, float] = {}
        for index, instant in enumerate(instants_deg):
            gaps[index] = min(
                (off(angle - start - instant, cycle_deg=centres.cycle_deg) for angle in angles),
                key=abs,
            )
        out[number] = {
            place: start + instants_deg[place] + gap
            for place, gap in gaps.items()
            if abs(gap) <= tolerance_deg
        }
    return out


def reach_of_all(centres: Turns, *, start: float, together: bool) -> Reach:
    """The chambers that can fire at each dead centre.

    A place for each instant, or, if several may fire `together`, for each chamber.
    """
    out: dict[int, dict[int, float]] = {number: {} for number in centres.angles}
    last, place = -1.0, -1
    wanted = [
        (start + (angle - start) % centres.cycle_deg, number)
        for number, own in centres.angles.items()
        for angle in own
    ]
    wanted = [
        (start if centres.cycle_deg - angle + start < SAME_ANGLE else angle, number)
        for angle, number in wanted
    ]
    for angle, number in sorted(wanted):
        place += together or place < 0 or angle - last > SAME_ANGLE
        last = angle
        out[number][place] = angle
    out[centres.anchor] = {
        place: angle for place, angle in out[centres.anchor].items() if angle == start
    }
    return out


def groups(reach: Reach) -> list[list[int]]:
    """The chambers in groups that have no place in common."""
    parted: list[tuple[set[int], list[int]]] = []
    for number, own in reach.items():
        places, members = set(own), [number]
        apart: list[tuple[set[int], list[int]]] = []
        for other, numbers in parted:
            if other & places:
                places |= other
                members = [*numbers, *members]
            else:
                apart.append((other, numbers))
        parted = [*apart, (places, members)]
    return [members for _, members in parted]


def crowd(reach: Reach) -> list[int]:
    """Chambers with fewer places than chambers; empty if each can have its own (P. Hall)."""
    holder: dict[int, int] = {}

    def placed(number: int, tried: set[int]) -> bool:
        for place in reach[number]:
            if place not in tried:
                tried.add(place)
                if place not in holder or placed(holder[place], tried):
                    holder[place] = number
                    return True
        return False

    for number in reach:
        tried: set[int] = set()
        if not placed(number, tried):
            return sorted({number, *(holder[place] for place in tried)})
    return []


def ways(reach: Reach) -> list[list[dict[int, float]]]:
    """For each group of chambers, all ways to fire them, with the crank angle of each.

    Raises OrderError where they are too many.
    """
    if crowd(reach):
        return [[]]
    out: list[list[dict[int, float]]] = []
    for members in groups(reach):
        listed = list(islice(_ways(reach, members, frozenset()), GREATEST_COUNT + 1))
        if len(listed) > GREATEST_COUNT:
            raise OrderError("orders.more-than", greatest=GREATEST_COUNT)
        out.append(listed)
    return out


def _ways(
    reach: Reach, members: Sequence[int], taken: frozenset[int]
) -> Iterator[dict[int, float]]:
    if not members:
        yield {}
        return
    number, *rest = sorted(members, key=lambda chamber: len(reach[chamber].keys() - taken))
    for place, angle in reach[number].items():
        if place not in taken:
            for way in _ways(reach, rest, taken | {place}):
                yield {number: angle, **way}
