"""The two assignments whose sum of vectors is least, found with proof where there are not too many.

Items of a kind go to places: item i at place c adds a vector, so that an assignment adds one of a
set of points, and two kinds add one of each. The least |x + u + v| over all u and v is the least
distance of the points x + u from the points -v, which a k-d tree finds among all pairs without
trying them: 40 320 assignments of pistons to eight cylinders with as many of the rods are 1.6e9
pairs. Places that cannot be told apart are filled in one order only. A kind alone that has too many
assignments is split: which items go to the first half of the places, and for each such choice the
nearest pair of points of the two halves. What is larger still is improved by exchanges from many
beginnings, and is not proved.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import combinations, permutations
from math import comb, factorial, perm
from typing import NamedTuple

import numpy as np
from scipy.spatial import KDTree

from crankstar.spectra import Real

MOST = 400_000
"""Assignments of a kind that are listed."""
MOST_SPLIT = 40_000_000
"""Points that are looked up where a kind is split in two halves."""
AT_ONCE = 4096
BEGINNINGS = 2000
"""From which exchanges begin where nothing is proved."""
SAME = 1e-12
Watch = Callable[[int, int], bool]
"""Told how much is done and of how much; false ends the work."""


class Kind(NamedTuple):
    """What each item adds at each place [item, place, row]; an item goes to one place at most."""

    vectors: Real

    @property
    def items(self) -> int:
        """How many there are."""
        return self.vectors.shape[0]

    @property
    def places(self) -> int:
        """How many are filled."""
        return self.vectors.shape[1]


class Least(NamedTuple):
    """For each kind the item at each place; the length of the sum; whether it is proved least."""

    items: tuple[tuple[int, ...], ...]
    length: float
    proved: bool


def least(fixed: Real, kinds: Sequence[Kind], *, watch: Watch | None = None) -> Least:
    """The assignments of one or two kinds whose vectors with `fixed` [row] add up to least.

    Interrupted by `watch`, it gives the best so far, not proved.

    >>> weights = np.array([3.0, 1.0, 2.0])
    >>> signs = np.array([1.0, -2.0, 1.0])  # at three places along a line
    >>> found = least(np.zeros(1), [Kind(weights[:, None, None] * signs[None, :, None])])
    >>> found.items[0][1], found.length, found.proved  # 3 + 1 - 2 times 2
    (2, 0.0, True)
    """
    told = watch or (lambda _done, _of: True)
    if all(_count(kind) <= MOST for kind in kinds):
        return _of_all(fixed, kinds, told)
    if len(kinds) == 1 and _splits(kinds[0]):
        return _halved(fixed, kinds[0], told)
    return _exchanged(fixed, kinds, told)


def _groups(kind: Kind) -> list[list[int]]:
    """Places at which every item adds the same."""
    scale = float(np.abs(kind.vectors).max()) or 1.0
    groups: list[list[int]] = []
    for index in range(kind.places):
        own = kind.vectors[:, index]
        for group in groups:
            if np.allclose(kind.vectors[:, group[0]], own, rtol=0, atol=SAME * scale):
                group.append(index)
                break
        else:
            groups.append([index])
    return groups


def _count(kind: Kind) -> int:
    alike = 1
    for group in _groups(kind):
        alike *= factorial(len(group))
    return perm(kind.items, kind.places) // alike


def _splits(kind: Kind) -> bool:
    half = kind.places // 2
    points = comb(kind.items, half) * factorial(kind.places - half)
    return kind.items == kind.places and points <= MOST_SPLIT


def _listed(kind: Kind) -> np.ndarray:
    """Every assignment [assignment, place], one of those that differ in like places only."""
    groups = [group for group in _groups(kind) if len(group) > 1]
    if perm(kind.items, kind.places) <= MOST:
        everything = np.array(list(permutations(range(kind.items), kind.places)), np.int16)
        kept = np.ones(len(everything), bool)
        for group in groups:
            kept &= (np.diff(everything[:, group], axis=1) > 0).all(axis=1)
        return everything[kept]
    return np.array(_grouped(kind), np.int16)


def _grouped(kind: Kind) -> list[list[int]]:
    """The same group by group, where most of the orders are alike."""
    done: list[tuple[list[int], frozenset[int]]] = [([0] * kind.places, frozenset())]
    for group in _groups(kind):
        longer: list[tuple[list[int], frozenset[int]]] = []
        for filled, used in done:
            free = [item for item in range(kind.items) if item not in used]
            for chosen in combinations(free, len(group)):
                own = filled.copy()
                for place, item in zip(group, chosen, strict=True):
                    own[place] = item
                longer.append((own, used | {*chosen}))
        done = longer
    return [filled for filled, _used in done]


def _points(kind: Kind, assigned: np.ndarray) -> Real:
    """What assignments add [assignment, row]."""
    out = np.zeros((len(assigned), kind.vectors.shape[2]))
    for index in range(kind.places):
        out += kind.vectors[assigned[:, index], index]
    return out


def _of_all(fixed: Real, kinds: Sequence[Kind], watch: Watch) -> Least:
    """The least of all pairs of listed assignments."""
    lists = [_listed(kind) for kind in kinds]
    first = fixed + _points(kinds[0], lists[0])
    if len(kinds) == 1:
        at = int((first**2).sum(axis=1).argmin())
        return Least((tuple(lists[0][at].tolist()),), float(np.linalg.norm(first[at])), True)
    second = -_points(kinds[1], lists[1])
    best, pair, ended = _nearest(first, second, watch)
    chosen = tuple(tuple(lists[which][pair[which]].tolist()) for which in (0, 1))
    return Least(chosen, best, ended)


def _nearest(first: Real, second: Real, watch: Watch) -> tuple[float, tuple[int, int], bool]:
    """The least distance between two sets of points, the pair, whether all were looked at."""
    axes = _axes(first, second)
    one, other = first @ axes, second @ axes
    beside = first[0] - one[0] @ axes.T - (second[0] - other[0] @ axes.T)
    aside = float(beside @ beside)  # the part of the distance that all pairs have
    turned = len(one) > len(other)
    asked, tree = (other, KDTree(one)) if turned else (one, KDTree(other))
    best, pair = np.inf, (0, 0)
    for begin in range(0, len(asked), AT_ONCE):
        near, index = map(np.asarray, tree.query(asked[begin : begin + AT_ONCE]))
        at = int(near.argmin())
        if near[at] < best:
            own, found = begin + at, int(index[at])
            best, pair = float(near[at]), (found, own) if turned else (own, found)
        if not watch(min(begin + AT_ONCE, len(asked)), len(asked)):
            return float(np.hypot(best, aside**0.5)), pair, begin + AT_ONCE >= len(asked)
    return float(np.hypot(best, aside**0.5)), pair, True


def _axes(first: Real, second: Real) -> Real:
    """Axes [row, axis] of the space in which the points of both sets differ."""
    spread = np.concatenate([first - first[0], second - second[0]])
    values, axes = np.linalg.eigh(spread.T @ spread)
    kept = values > SAME**1.5 * max(float(values[-1]), 1e-300)
    return axes[:, kept] if kept.any() else axes[:, -1:]


def _halved(fixed: Real, kind: Kind, watch: Watch) -> Least:
    """The least assignment of one kind by halves of the places."""
    half = kind.places // 2
    early, late = kind.vectors[:, :half], kind.vectors[:, half:]
    orders = [np.array(list(permutations(range(n))), np.int16) for n in (half, kind.places - half)]
    best, chosen = np.inf, tuple(range(kind.places))
    count = comb(kind.items, half)
    for done, some in enumerate(combinations(range(kind.items), half), 1):
        others = [item for item in range(kind.items) if item not in some]
        lists = [np.array(some)[orders[0]], np.array(others)[orders[1]]]
        first = fixed + _points(Kind(early), lists[0])
        second = -_points(Kind(late), lists[1])
        length, pair, _all = _nearest(first, second, lambda _done, _of: True)
        if length < best:
            best = length
            chosen = (*lists[0][pair[0]].tolist(), *lists[1][pair[1]].tolist())
        if not watch(done, count):
            return Least((chosen,), best, done == count)
    return Least((chosen,), best, True)


def _exchanged(fixed: Real, kinds: Sequence[Kind], watch: Watch) -> Least:
    """The best that exchanges of two items lead to from many beginnings."""
    chance = np.random.default_rng(0)
    best, kept = np.inf, tuple(tuple(range(kind.places)) for kind in kinds)
    for done in range(1, BEGINNINGS + 1):
        now = [list(chance.permutation(kind.items)) for kind in kinds]
        length = _improved(fixed, kinds, now)
        if length < best:
            best = length
            kept = tuple(
                tuple(int(item) for item in own[: kind.places])
                for own, kind in zip(now, kinds, strict=True)
            )
        if not watch(done, BEGINNINGS):
            break
    return Least(kept, best, False)


def _improved(fixed: Real, kinds: Sequence[Kind], now: list[list[int]]) -> float:
    """Exchange two items of a kind as long as one exchange shortens the sum; its length.

    Items behind the last place are spare.
    """
    total = fixed + sum(
        kind.vectors[own[index], index]
        for kind, own in zip(kinds, now, strict=True)
        for index in range(kind.places)
    )
    length = float(total @ total)
    while True:
        step, least_length = None, length * (1 - 1e-12)
        for kind, own in zip(kinds, now, strict=True):
            pairs, changes = _exchanges(kind, own)
            lengths = ((total + changes) ** 2).sum(axis=1)
            at = int(lengths.argmin())
            if lengths[at] < least_length:
                step, least_length = (own, pairs[at], changes[at]), float(lengths[at])
        if step is None:
            return length**0.5
        own, (one, other), change = step
        own[one], own[other] = own[other], own[one]
        total, length = total + change, least_length


def _exchanges(kind: Kind, own: list[int]) -> tuple[list[tuple[int, int]], Real]:
    """Every exchange of two items, and what it adds to the sum [exchange, row]."""
    pairs = [(a, b) for a in range(kind.places) for b in range(a + 1, kind.items)]
    vectors, at = kind.vectors, np.array(own)
    one, other = (np.array(side) for side in zip(*pairs, strict=True)) if pairs else ([], [])
    changes = vectors[at[other], one] - vectors[at[one], one]
    inside = np.array(other) < kind.places
    back = np.where(inside, other, 0)
    changes += np.where(inside[:, None], vectors[at[one], back] - vectors[at[other], back], 0.0)
    return pairs, changes
