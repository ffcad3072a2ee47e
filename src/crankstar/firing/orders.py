"""Firing orders on a given crank: even ones, those at given intervals, all that are possible.

A firing order is a choice of one dead centre in the cycle for each chamber; a cycle begins
anywhere, so that of one chamber is fixed. In a four-stroke engine of n cylinders whose dead centres
fall together in pairs, which even firing needs where n is even, one of each pair fires in the first
turn and the other in the second: 2^(n/2 - 1) even orders. Where n is odd each cylinder has one
place only, and in a two-stroke engine as well: one order.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise, product
from math import fsum, prod, sqrt
from typing import Any

from crankstar.engine.dead_centres import SAME_ANGLE
from crankstar.engine.engine import Engine
from crankstar.firing.intervals import Firing, firing
from crankstar.firing.succession import Follower, followers, in_succession, neighbours, partners
from crankstar.firing.timetable import (
    GREATEST_COUNT,
    OrderError,
    Reach,
    Turns,
    crowd,
    reach_of,
    reach_of_all,
    turns,
    ways,
)
from crankstar.language.faults import Fault

SAME_PLACE = 1e-4
"""Degrees by which a firing may miss its place in the cycle and be in it all the same."""


@dataclass(frozen=True)
class Order:
    """A firing order with its facts.

    `banks`: for each bank the intervals from one of its firings to the next, which make its exhaust
    note (degrees; none of an engine with one bank). `neighbours`, `partners`: successive firings in
    chambers that stand side by side, or whose rods share a throw.
    """

    firing: Firing
    banks: Mapping[str, tuple[float, ...]]
    neighbours: tuple[Follower, ...]
    partners: tuple[Follower, ...]

    @property
    def unevenness_deg(self) -> float:
        """Root mean square of what the intervals differ from their mean by, degrees."""
        return _spread([self.firing.intervals_deg])

    @property
    def bank_unevenness_deg(self) -> float:
        """The same for the intervals of the banks, all taken together."""
        return _spread(list(self.banks.values()))


def _spread(rows: Sequence[Sequence[float]]) -> float:
    squares = [(interval - fsum(row) / len(row)) ** 2 for row in rows for interval in row]
    return round(sqrt(fsum(squares) / len(squares)), 6) if squares else 0.0


def even_orders(engine: Engine, *, tolerance_deg: float = SAME_PLACE) -> tuple[Order, ...]:
    """All firing orders that fire evenly, best first.

    Best is: fewest neighbours in succession, then most even banks, then fewest partners on a throw
    in succession, then the lowest numbers. An order begins with the lowest number. `tolerance_deg`:
    how far (degrees) a firing may be from its place in an even cycle. Raises OrderError as
    `orders_at` does.

    >>> from crankstar.files.catalog import load
    >>> ["-".join(map(str, order.firing.order)) for order in even_orders(load("i4"))]
    ['1-2-4-3', '1-3-4-2']
    >>> len(even_orders(load("v8-cross-plane")))
    8
    """
    count = len(engine.chambers)
    return orders_at(
        engine, intervals_deg=(engine.cycle_angle / count,) * count, tolerance_deg=tolerance_deg
    )


def orders_at(
    engine: Engine, *, intervals_deg: Sequence[float], tolerance_deg: float = SAME_PLACE
) -> tuple[Order, ...]:
    """All firing orders with these intervals one after the other, best first.

    The cycle may begin at any of them.

    `intervals_deg`: one for each chamber, together the cycle; 0 for chambers that fire together.
    `tolerance_deg`: how far a firing may be from its place, counted from that of the chamber that
    is taken first. Raises OrderError where the intervals cannot be meant, and where there are more
    than GREATEST_COUNT orders.

    >>> from crankstar.files.catalog import load
    >>> found = orders_at(load("harley-45"), intervals_deg=(315, 405))
    >>> [order.firing.intervals_deg for order in found]
    [(315.0, 405.0)]
    """
    check_intervals(engine, intervals_deg, tolerance_deg)
    centres = turns(engine)
    return _ranked(engine, _fired(centres, _reaches(centres, intervals_deg, tolerance_deg)))


def possible_orders(engine: Engine, *, together: bool = False) -> tuple[Order, ...]:
    """All firing orders that the dead centres allow, the most even first, then as `even_orders`.

    No two chambers fire at once unless they may fire `together`. Raises OrderError where there are
    more than GREATEST_COUNT.

    >>> from crankstar.files.catalog import load
    >>> [order.firing.intervals_deg for order in possible_orders(load("harley-45"))]
    [(315.0, 405.0), (675.0, 45.0)]
    """
    centres = turns(engine)
    reaches = [reach_of_all(centres, start=start, together=together) for start in centres.starts]
    return tuple(
        sorted(
            _ranked(engine, _fired(centres, reaches)),
            key=lambda order: round(order.unevenness_deg, 3),
        )
    )


def most_even_orders(engine: Engine) -> tuple[Order, ...]:
    """The orders that fire evenly, or if none does, all possible ones, most even first.

    If these are too many, only those nearest to even.

    >>> from crankstar.files.catalog import load
    >>> len(most_even_orders(load("i4"))), len(most_even_orders(load("i2-270")))
    (2, 2)
    """
    even = even_orders(engine)
    if even:
        return even
    try:
        return possible_orders(engine)
    except OrderError:
        least = unevenness(engine) + SAME_PLACE
        if least >= engine.cycle_angle / len(engine.chambers) / 2:
            raise
        return even_orders(engine, tolerance_deg=least)


def unevenness(engine: Engine) -> float:
    """The greatest deviation (degrees) from an even cycle of the most even order.

    This is the least tolerance that gives an order.

    >>> from crankstar.files.catalog import load
    >>> unevenness(load("harley-45"))
    45.0
    """
    centres, count = turns(engine), len(engine.chambers)
    instants = [index * centres.cycle_deg / count for index in range(count)]
    best = centres.cycle_deg
    for start in centres.starts:
        whole = reach_of(centres, instants, start=start, tolerance_deg=centres.cycle_deg)
        gaps = {
            number: {place: abs(angle - start - instants[place]) for place, angle in own.items()}
            for number, own in whole.items()
        }
        steps = sorted({round(gap, 9) for own in gaps.values() for gap in own.values()})
        low, high = 0, len(steps) - 1
        while low < high:
            middle = (low + high) // 2
            within = {
                n: {place: gap for place, gap in own.items() if gap <= steps[middle] + 1e-9}
                for n, own in gaps.items()
            }
            low, high = (low, middle) if not crowd(within) else (middle + 1, high)
        best = min(best, steps[low])
    return 0.0 if best <= SAME_PLACE else best


def why_uneven(engine: Engine) -> list[Fault]:
    """Why nothing fires evenly; empty where an order does.

    >>> from crankstar.files.catalog import load
    >>> fault, = why_uneven(load("harley-45"))
    >>> fault.values["numbers"], fault.values["angles"]
    ([2], [315.0, 675.0])
    """
    centres, interval = turns(engine), engine.cycle_angle / len(engine.chambers)
    instants = [index * interval for index in range(len(engine.chambers))]
    if any(
        not crowd(reach_of(centres, instants, start=start, tolerance_deg=SAME_PLACE))
        for start in centres.starts
    ):
        return []
    start = centres.starts[0]
    unbound = centres._replace(anchor=0)  # which is no chamber's number
    reach = reach_of(unbound, instants, start=start, tolerance_deg=SAME_PLACE)
    astray = [number for number, own in reach.items() if not own]
    values: dict[str, Any] = {"interval": interval, "anchor": centres.anchor}
    if astray:
        return [
            Fault(
                (),
                "orders.uneven",
                values | {"numbers": numbers, "count": len(numbers), "angles": list(angles)},
            )
            for angles, numbers in _by_angles(centres, astray).items()
        ]
    crowded = crowd(reach)
    places = {
        round((angle - start) % centres.cycle_deg, 6)
        for number in crowded
        for angle in reach[number].values()
    }
    values |= {"numbers": crowded, "angles": sorted(places)}
    return [Fault((), "orders.crowded", values)]


def _by_angles(centres: Turns, numbers: Sequence[int]) -> dict[tuple[float, ...], list[int]]:
    """Chambers by their dead centres in the cycle."""
    by_angles: dict[tuple[float, ...], list[int]] = {}
    for number in numbers:
        by_angles.setdefault(tuple(round(a, 6) for a in centres.angles[number]), []).append(number)
    return by_angles


def check_intervals(engine: Engine, intervals_deg: Sequence[float], tolerance_deg: float) -> None:
    """Refuse intervals that are not a cycle, and a tolerance that could change who fires first."""
    count, cycle = len(engine.chambers), engine.cycle_angle
    if len(intervals_deg) != count:
        raise OrderError("orders.intervals-count", count=len(intervals_deg), firings=count)
    if min(intervals_deg) < 0 or abs(fsum(intervals_deg) - cycle) > 1e-6 * cycle:
        raise OrderError("orders.intervals-sum", values=list(intervals_deg), cycle=cycle)
    least = min(interval for interval in intervals_deg if interval > 0)
    if not 0 <= tolerance_deg < least / 2:
        raise OrderError("orders.tolerance", value=tolerance_deg, most=least / 2)


def _reaches(centres: Turns, intervals_deg: Sequence[float], tolerance_deg: float) -> list[Reach]:
    """Who can fire when, for each start of the cycle and each interval that can be the first."""
    count = len(intervals_deg)
    turned = {tuple(intervals_deg[first:]) + tuple(intervals_deg[:first]) for first in range(count)}
    out: list[Reach] = []
    for row, start in product(sorted(turned), centres.starts):
        instants = [fsum(row[:index]) for index in range(count)]
        out.append(reach_of(centres, instants, start=start, tolerance_deg=tolerance_deg))
    return out


def _fired(centres: Turns, reaches: Sequence[Reach]) -> list[Firing]:
    """The firings of all ways of all timetables, each once."""
    listed = [ways(reach) for reach in reaches]
    count = sum(prod(len(group) for group in groups) for groups in listed)
    if count > GREATEST_COUNT:
        raise OrderError("orders.too-many", total=count if count < 1e12 else float(count))
    fired: dict[tuple[tuple[float, int], ...], Firing] = {}
    for groups in listed:
        for way in product(*groups):
            angles = {number: angle for part in way for number, angle in part.items()}
            cycle = _from_lowest(angles, centres.cycle_deg)
            fired.setdefault(
                tuple((round(angle, 6), number) for number, angle in cycle),
                _firing(cycle, centres.cycle_deg),
            )
    return list(fired.values())


def _from_lowest(angles: Mapping[int, float], cycle_deg: float) -> list[tuple[int, float]]:
    """The chambers in firing order from the lowest number, with ascending crank angles."""
    lowest = min(angles)
    start = angles[lowest] % cycle_deg
    after = {number: (angle - angles[lowest]) % cycle_deg for number, angle in angles.items()}
    after = {number: 0.0 if cycle_deg - gap < SAME_ANGLE else gap for number, gap in after.items()}
    return [
        (number, start + gap)
        for number, gap in sorted(after.items(), key=lambda item: (round(item[1], 6), item[0]))
    ]


def _firing(cycle: Sequence[tuple[int, float]], cycle_deg: float) -> Firing:
    angles = [angle for _, angle in cycle]
    intervals = (round(b - a, 9) + 0.0 for a, b in pairwise([*angles, angles[0] + cycle_deg]))
    return Firing(tuple(number for number, _ in cycle), tuple(angles), tuple(intervals), cycle_deg)


def _ranked(engine: Engine, fired: Sequence[Firing]) -> tuple[Order, ...]:
    side_by_side, on_a_pin = neighbours(engine), partners(engine)
    banks = _exhausts(engine)
    orders = [
        Order(
            cycle,
            {
                name: tuple(step.interval_deg for step in followers(cycle, group))
                for name, group in banks.items()
            },
            in_succession(cycle, side_by_side),
            in_succession(cycle, on_a_pin),
        )
        for cycle in fired
    ]
    return tuple(sorted(orders, key=_merit))


def _merit(order: Order) -> tuple[object, ...]:
    return (
        len(order.neighbours),
        order.bank_unevenness_deg,
        len(order.partners),
        order.firing.order,
        order.firing.angles_deg,
    )


def _exhausts(engine: Engine) -> dict[str, tuple[int, ...]]:
    """The chambers of each bank, where there is more than one that has not all of them."""
    chamber = {
        cylinder.number: cylinder.chamber or cylinder.number for cylinder in engine.cylinders
    }
    banks = {
        name: tuple(dict.fromkeys(chamber[number] for number in numbers))
        for name, numbers in engine.banks.items()
    }
    return {name: group for name, group in banks.items() if len(group) < len(engine.chambers)}


def place_of(engine: Engine, orders: Sequence[Order]) -> int | None:
    """The index of the engine's order among these; None if absent or without an order."""
    own = firing(engine)
    if not own.order:
        return None
    centres = dict(zip(own.order, own.angles_deg, strict=True))
    ours = _firing(_from_lowest(centres, own.cycle_deg), own.cycle_deg)
    for index, order in enumerate(orders):
        same = all(
            abs(a - b) < 1e-3
            for a, b in zip(order.firing.intervals_deg, ours.intervals_deg, strict=True)
        )
        if order.firing.order == ours.order and same:
            return index
    return None
