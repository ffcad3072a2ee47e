"""A question as arrays for the kernels.

The two halves of the shaft, blocks of stars, regions, and how much work they are.

The places are sorted by how far they reach (the greatest |weight|), so that the outer half is the
hard one to cancel. The outermost place has direction 0: that counts turned stars once. A block is a
choice of the directions that the outer half gets; of two blocks that are mirror images one stands
for both. How many blocks there are, and how many arrangements a half has, is counted without making
them.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache
from math import factorial, inf, pi, sqrt

import numpy as np

from crankstar.stars.arrays import Tables
from crankstar.stars.faults import error
from crankstar.stars.question import Question
from crankstar.stars.star import Stars
from crankstar.stars.sums import VectorSum

GREATEST_ROWS = 4_000_000
"""Arrangements of both halves that are held at once: 9! + 10! of 20 cylinders.

A worker then takes 500 MB (`work.memory`).
"""
CACHED_ROWS = 100_000
"""Arrangements of the inner half, searched again and again, that fit in a processor's cache."""
BUFFER = 1 << 14
"""Least number of stars that are collected before the compiled loop returns them."""


@dataclass(frozen=True)
class Halves:
    """A question made ready: tables for the kernels.

    Greatest numbers of arrangements of the two halves, scales.

    counts: how many free places each direction has; mirrored: whether of two mirror images of a
    block one stands for both.
    """

    tables: Tables
    counts: tuple[int, ...]
    mirrored: bool
    outer_rows: int
    inner_rows: int
    size: tuple[float, ...]
    """By what each sum was divided for the kernels."""
    spread: tuple[float, ...]
    """Root mean square of each sum over all stars, in the kernels' unit."""
    reach: tuple[float, ...]
    """Greatest length each sum can have, in the kernels' unit."""
    unit: tuple[float, ...]
    """By what the value of each objective was divided for the kernels."""

    @property
    def rows(self) -> float:
        """Arrangements that are formed in all blocks."""
        return float(self.block_count) * (self.outer_rows + self.inner_rows)

    @cached_property
    def block_count(self) -> int:
        """How many blocks there are."""
        wanted = len(self.tables.outer)
        every = _ways([(1, count) for count in self.counts], wanted)
        if not self.mirrored:
            return every
        pairs = list(zip(self.counts, self.counts[:1] + self.counts[:0:-1], strict=True))
        half = len(pairs) // 2
        alone = [0, half] if len(pairs) % 2 == 0 else [0]
        still = [(1, self.counts[d]) for d in alone] + [
            (2, min(pairs[d])) for d in range(1, (len(pairs) + 1) // 2)
        ]
        return (every + _ways(still, wanted)) // 2

    @cached_property
    def blocks(self) -> np.ndarray:
        """All shares of the outer half and the inner one, and what each stands for [b, 2 n + 1]."""
        shares = _shares(self.counts, len(self.tables.outer))
        times = np.ones(len(shares), np.int64)
        if self.mirrored:
            apart = shares - np.roll(shares[:, ::-1], 1, axis=1)
            first = apart[np.arange(len(apart)), (apart != 0).argmax(axis=1)]
            times += first < 0
            shares, times = shares[first <= 0], times[first <= 0]
        return np.column_stack([shares, np.array(self.counts) - shares, times])


def check(question: Question) -> None:
    """Raises SearchError where the halves of a question have more arrangements than can be held."""
    ready = halves(question)
    rows = ready.outer_rows + ready.inner_rows
    if rows <= GREATEST_ROWS:
        return
    free = len(ready.tables.outer) + len(ready.tables.inner)
    enough = next(k for k in range(free, 0, -1) if _rows(ready.counts, k) <= GREATEST_ROWS)
    wider = question.stars.sharing == 2 and not question.stars.symmetric
    raise error(
        "fix",
        "too-large-symmetric" if wider else "too-large",
        free=free,
        rows=f"{rows:,}",
        most=f"{GREATEST_ROWS:,}",
        fixed=len(question.stars.places) - enough,
    )


def _rows(counts: Sequence[int], free: int) -> int:
    """Arrangements of both halves of so many free places, at most."""
    return _most_rows(counts, free // 2) + _most_rows(counts, free - free // 2)


@lru_cache(maxsize=8)
def halves(question: Question) -> Halves:
    """The question as arrays."""
    columns = tuple(_column(question.stars, vector) for vector in question.sums) or (
        _nothing(question.stars),
    )
    whole = np.ascontiguousarray(
        np.stack([part for column in columns for part in column.parts], axis=-1)
    )
    size = tuple(column.size for column in columns)
    fixed, outer, inner, counts = _parted(question, whole)
    constant = sum(
        (whole[place, direction] for place, direction in fixed), np.zeros(whole.shape[2])
    )
    least, greatest = _limits(question, size)
    tables = Tables(
        outer=np.ascontiguousarray(whole[outer]),
        inner=np.ascontiguousarray(whole[inner]),
        constant=constant,
        places=np.array([*outer, *inner, *(place for place, _ in fixed)], np.int64),
        fixed=np.array([direction for _, direction in fixed], np.int64),
        whole=whole,
        members=np.array([(*members, -1)[:2] for members in question.stars.places], np.int64),
        symmetries=np.array(question.symmetries, np.int64),
        counts=question.counts,
        anchored=not question.stars.fixed,
        step=question.stars.step,
        weights=_weights(question, size),
        limits=np.append(greatest, question.neighbours_at_most),
        floors=least,
    )
    return Halves(
        tables,
        tuple(counts),
        len(question.symmetries) > 1,
        _most_rows(counts, len(outer)),
        _most_rows(counts, len(inner)),
        size,
        tuple(column.spread for column in columns),
        tuple(float(np.abs(column.weights).sum()) for column in columns),
        units(question, size),
    )


@dataclass(frozen=True)
class _Column:
    """A sum as numbers: the weight of each place, divided by the greatest.

    The unit vector of each direction.
    """

    weights: np.ndarray
    turns: np.ndarray
    size: float

    @property
    def parts(self) -> tuple[np.ndarray, np.ndarray]:
        return np.outer(self.weights, np.real(self.turns)), np.outer(
            self.weights, np.imag(self.turns)
        )

    @property
    def spread(self) -> float:
        """Root mean square over all stars: exact for directions drawn without putting back."""
        number, mean = len(self.weights), self.turns.mean()
        varied = 0.0
        if number > 1:
            scatter = ((self.weights - self.weights.mean()) ** 2).sum() * number / (number - 1)
            varied = float(scatter * (np.abs(self.turns - mean) ** 2).mean())
        return sqrt(varied + abs(mean * self.weights.sum()) ** 2)


def _column(stars: Stars, vector: VectorSum) -> _Column:
    weights = np.array([float(sum(vector.weights[c] for c in members)) for members in stars.places])
    size = float(np.abs(weights).max()) or 1.0
    turns = np.exp(2j * pi * np.array([float(turn) for turn in vector.turns]))
    return _Column(weights / size, turns, size)


def _nothing(stars: Stars) -> _Column:
    """A sum that is zero for all stars, where none is asked for."""
    return _Column(np.zeros(len(stars.places)), np.ones(stars.directions, complex), 1.0)


def _parted(
    question: Question, whole: np.ndarray
) -> tuple[list[tuple[int, int]], list[int], list[int], list[int]]:
    """Fixed places with their directions; free ones, outer half and inner half.

    How many each direction has left.
    """
    stars = question.stars
    reach = np.abs(whole[:, 0, 0::2] + 1j * whole[:, 0, 1::2]).max(axis=1)
    order = sorted(range(len(stars.places)), key=lambda place: (-reach[place], place))
    fixed = list(stars.fixed_places) or [(order[0], 0)]
    held = {place for place, _ in fixed}
    free = [place for place in order if place not in held]
    counts = [stars.each] * stars.directions
    for _, direction in fixed:
        counts[direction] -= 1
    split = len(free) // 2
    if _most_rows(counts, len(free) - split) > CACHED_ROWS:
        split = len(free) - split
    return fixed, free[:split], free[split:], counts


def _shares(counts: Sequence[int], wanted: int) -> np.ndarray:
    """All ways to take so many from the counts of all directions, in lexical order [ways, n]."""
    shares, filled = np.zeros((1, 0), np.int64), np.zeros(1, np.int64)
    for d, count in enumerate(counts):
        least = np.maximum(0, wanted - filled - sum(counts[d + 1 :]))
        ways = np.minimum(count, wanted - filled) - least + 1
        before = np.repeat(np.arange(len(shares)), ways)
        here = least[before] + np.arange(len(before)) - np.repeat(np.cumsum(ways) - ways, ways)
        shares, filled = np.column_stack([shares[before], here]), filled[before] + here
    return shares


def _ways(choices: Sequence[tuple[int, int]], wanted: int) -> int:
    """The number of ways to take so many, of each choice up to a count, each of a given size."""
    ways = [1] + [0] * wanted
    for step, count in choices:
        ways = [
            sum(ways[total - step * k] for k in range(count + 1) if total >= step * k)
            for total in range(wanted + 1)
        ]
    return ways[wanted]


def _most_rows(counts: Sequence[int], places: int) -> int:
    """The greatest number of arrangements over the blocks: that of the most even shares."""
    share = [0] * len(counts)
    for _ in range(places):
        share[
            min((d for d in range(len(counts)) if share[d] < counts[d]), key=share.__getitem__)
        ] += 1
    rows = factorial(places)
    for count in share:
        rows //= factorial(count)
    return rows


def _weights(question: Question, size: tuple[float, ...]) -> np.ndarray:
    """Squares of the weights of the sums in the objectives, in the kernels' units [q, m + 1]."""
    out = np.zeros((max(1, len(question.objectives)), len(size) + 1))
    place = {vector: o for o, vector in enumerate(question.sums)}
    for row, objective, unit in zip(out, question.objectives, units(question, size), strict=False):
        for weight, vector in objective.terms:
            row[place[vector]] += (weight * vector.scale * size[place[vector]] / unit) ** 2
        row[-1] = objective.neighbours / unit
    return out


def units(question: Question, size: tuple[float, ...]) -> tuple[float, ...]:
    """By what the value of each objective is divided for the kernels: the greatest weight in it."""
    place = {vector: o for o, vector in enumerate(question.sums)}
    return tuple(
        max(
            (
                abs(weight * vector.scale) * size[place[vector]]
                for weight, vector in objective.terms
            ),
            default=0.0,
        )
        or 1.0
        for objective in question.objectives
    )


def _limits(question: Question, size: tuple[float, ...]) -> tuple[np.ndarray, np.ndarray]:
    """Least and greatest lengths of the sums, in the kernels' units."""
    least, greatest = np.zeros(len(size)), np.full(len(size), inf)
    for limit in question.limits:
        o = question.sums.index(limit.sum)
        unit = limit.sum.scale * size[o]
        least[o] = max(least[o], limit.least / unit)
        greatest[o] = min(greatest[o], limit.greatest / unit)
    return least, greatest
