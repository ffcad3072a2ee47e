"""Sets for several engines from one batch, each of parts that are as nearly equal as can be.

What is minimised is linear, the sum over the sets of greatest less least mass: of pistons with
their pins, and, of rods, of the small ends and of the big ends, added. Pistons are one number each:
some best sets are runs of neighbours in the order of their masses (two sets that overlap can be
exchanged until they do not, and no spread grows), so that all of these are compared by dynamic
programming. Rods are two numbers each, and a mixed-integer linear programme (HiGHS) divides them;
it is proved unless the time ends.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import partial
from itertools import combinations
from math import comb
from typing import NamedTuple

import numpy as np
from scipy.optimize import Bounds, LinearConstraint, milp
from scipy.sparse import csr_matrix

from crankstar.analyses.match.assignments import Watch
from crankstar.analyses.match.batch import Batch, MatchingError, paired
from crankstar.analyses.match.law import ORDERS
from crankstar.analyses.match.matching import CLASSES, Matched, Place, matched
from crankstar.analyses.match.question import Minimised
from crankstar.engine.engine import Engine
from crankstar.spectra import Real

SECONDS = 20.0
"""Time for the programme that divides rods."""
MOST_SETS = 20_000
"""Sets of rods that are all looked at: those of 24 for engines of four cylinders."""


class Sets(NamedTuple):
    """The items of each set, the sum of the spreads (kg), and whether it is proved least."""

    items: tuple[tuple[int, ...], ...]
    spread: float
    proved: bool


@dataclass(frozen=True)
class Division:
    """A batch divided: pistons (with pins) and rods into sets, each set matched to its engine."""

    pistons: Sets | None
    rods: Sets | None
    engines: tuple[Matched, ...]


def runs(masses: Sequence[float] | Real, *, sets: int, size: int) -> Sets:
    """Sets of `size` with the least sum of spreads; items that are too many are left out.

    >>> runs([5.0, 1.0, 1.1, 4.9, 9.0], sets=2, size=2)
    Sets(items=((1, 2), (3, 0)), spread=0.2, proved=True)
    """
    own = np.asarray(masses, float)
    order = np.argsort(own, kind="stable")
    row = own[order]
    best = np.full((len(row) + 1, sets + 1), np.inf)
    best[:, 0] = 0.0
    taken = np.zeros(best.shape, bool)
    for end in range(1, len(row) + 1):
        for count in range(1, sets + 1):
            best[end, count] = best[end - 1, count]
            if end >= size:
                spread = row[end - 1] - row[end - size] + best[end - size, count - 1]
                if spread < best[end, count]:
                    best[end, count], taken[end, count] = spread, True
    found: list[tuple[int, ...]] = []
    end, count = len(row), sets
    while count:
        if taken[end, count]:
            found.append(tuple(order[end - size : end].tolist()))
            end, count = end - size, count - 1
        else:
            end -= 1
    return Sets(tuple(reversed(found)), round(float(best[-1, sets]), 15), True)


def divided_rods(masses: Real, *, sets: int, size: int, seconds: float = SECONDS) -> Sets:
    """Sets of rods [item, end] with the least sum of the spreads of both ends.

    Every set that there can be is a column of the programme, with its spread; each rod is in one
    chosen column at most. Where there are more than MOST_SETS, exchanges between sets improve those
    by the whole mass, and nothing is proved.

    >>> ends = np.array([[1.0, 5.0], [1.0, 9.0], [1.1, 5.0], [1.1, 9.0]])
    >>> divided_rods(ends, sets=2, size=2).items  # the big ends differ more
    ((0, 2), (1, 3))
    """
    begun = runs(masses.sum(axis=1), sets=sets, size=size).items
    exchanged = _exchanged(masses, begun)
    best = Sets(exchanged, _spread(masses, exchanged), False)
    if comb(len(masses), size) > MOST_SETS:
        return best
    columns = np.array(list(combinations(range(len(masses)), size)))
    costs = np.ptp(masses[columns], axis=1).sum(axis=1)
    kept = costs <= best.spread * (1 + 1e-9) + 1e-15  # a dearer set is in no better choice
    columns, costs = columns[kept], costs[kept]
    count = len(columns)
    inside = csr_matrix(
        (np.ones(columns.size), (columns.ravel(), np.repeat(np.arange(count), size))),
        shape=(len(masses), count),
    )
    full = len(masses) == sets * size
    found = milp(
        costs / (best.spread or 1.0),
        integrality=np.ones(count),
        bounds=Bounds(0, 1),
        constraints=[
            LinearConstraint(inside, 1.0 if full else -np.inf, 1.0),
            LinearConstraint(np.ones((1, count)), sets, sets),
        ],
        options={"time_limit": seconds, "mip_rel_gap": 0.0},
    )
    if found.x is None:
        return best
    chosen = columns[found.x > 0.5]
    items = tuple(sorted(tuple(some) for some in chosen.tolist()))
    return Sets(items, _spread(masses, items), found.status == 0)


def _spread(masses: Real, items: Sequence[Sequence[int]]) -> float:
    return float(sum(np.ptp(masses[[*some]], axis=0).sum() for some in items))


def _exchanged(masses: Real, items: Sequence[Sequence[int]]) -> tuple[tuple[int, ...], ...]:
    """Sets improved as long as the exchange of two items of two sets makes them closer."""
    now = [list(some) for some in items]
    better = True
    while better:
        better = False
        for one, other in combinations(range(len(now)), 2):
            for a in range(len(now[one])):
                for b in range(len(now[other])):
                    before = _spread(masses, (now[one], now[other]))
                    now[one][a], now[other][b] = now[other][b], now[one][a]
                    if _spread(masses, (now[one], now[other])) < before * (1 - 1e-12):
                        better = True
                    else:
                        now[one][a], now[other][b] = now[other][b], now[one][a]
    return tuple(tuple(some) for some in now)


def divided(
    engine: Engine,
    batch: Batch,
    *,
    engines: int,
    orders: Sequence[float] = ORDERS,
    quantities: Sequence[Minimised] = ("force", "couple"),
    classes: Sequence[float] = CLASSES,
    whole: bool = False,
    watch: Watch | None = None,
) -> Division:
    """A batch divided into sets for so many engines of a kind, each set matched to its cylinders.

    One engine has no sets: it is matched from the whole batch, as by `matched`.

    Raises MatchingError where there are too few parts.

    >>> from crankstar.files.catalog import load
    >>> parts = {"piston": np.array([412, 410, 411, 413, 420, 421, 422, 423]) / 1000}
    >>> found = divided(load("subaru-ej25"), Batch(tuple("abcdefgh"), parts), engines=2)
    >>> round(found.pistons.spread * 1000, 6)  # 413 - 410 and 423 - 420
    6.0
    """
    least = partial(
        matched,
        engine,
        orders=orders,
        quantities=quantities,
        classes=classes,
        whole=whole,
        watch=watch,
    )
    if engines == 1:
        return Division(None, None, (least(batch),))
    size = len(engine.cylinders)
    if batch.size < engines * size:
        raise MatchingError(
            "the list has {items} of each part, and {engines} engines with {count} cylinders need "
            "{needed}",
            items=batch.size,
            engines=engines,
            count=size,
            needed=engines * size,
        )
    pins, sums = paired(batch)
    pistons = runs(sums, sets=engines, size=size) if batch.has_pistons else None
    rods = None
    if batch.has_rods:
        names = [name for name in ("small_end", "big_end") if name in batch.masses]
        ends = np.column_stack([batch.masses[name] for name in names])
        rods = (
            runs(ends[:, 0], sets=engines, size=size)
            if len(names) == 1
            else divided_rods(ends, sets=engines, size=size)
        )
    out: list[Matched] = []
    for at in range(engines):
        some = None if pistons is None else pistons.items[at]
        others = None if rods is None else rods.items[at]
        found = least(_part(batch, pins, some, others))
        out.append(_numbered(found, pins, some, others))
    return Division(pistons, rods, tuple(out))


def _part(
    batch: Batch, pins: Sequence[int], pistons: Sequence[int] | None, rods: Sequence[int] | None
) -> Batch:
    """The batch of one engine, its items in the order of its sets."""
    masses: dict[str, Real] = {}
    for name, own in batch.masses.items():
        if name == "piston" and pistons is not None:
            masses[name] = own[[*pistons]]
        elif name == "pin" and pistons is not None:
            masses[name] = own[[pins[item] for item in pistons]]
        elif rods is not None:
            masses[name] = own[[*rods]]
    size = len(next(iter(masses.values())))
    return Batch(tuple(map(str, range(size))), masses)


def _numbered(
    found: Matched, pins: Sequence[int], pistons: Sequence[int] | None, rods: Sequence[int] | None
) -> Matched:
    """A match of one set with the items numbered as in the whole batch."""

    def whole(items: Sequence[int] | None, item: int | None) -> int | None:
        return None if items is None or item is None else items[item]

    own_pins = None if pistons is None else [pins[item] for item in pistons]
    places = tuple(
        Place(
            place.cylinder,
            whole(pistons, place.piston),
            whole(own_pins, place.pin),
            whole(rods, place.rod),
        )
        for place in found.places
    )
    return replace(found, places=places)
