"""A question as arrays for the kernels: the two halves of the shaft, blocks of stars, strips, and how much work they are.

The places are sorted by how far they reach (the greatest |weight|), so that the outer half is the hard one to cancel. The
outermost place has direction 0: that counts turned stars once. A block is a choice of the directions that the outer half
gets; of two blocks that are mirror images one stands for both.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from math import factorial, inf, pi, sqrt

import numpy as np

from crankstar.search import kernels
from crankstar.search.question import Question
from crankstar.search.stars import Stars
from crankstar.search.sums import VectorSum

GREATEST_ROWS = 4_000_000
"""Arrangements of a half that are held at once: 200 MB."""
BUFFER = 1 << 14
"""Stars found before the compiled loop hands them over, at least."""


@dataclass(frozen=True)
class Halves:
    """A question made ready: tables for the kernels, blocks, greatest numbers of arrangements of the two halves, scales."""

    tables: kernels.Tables
    blocks: np.ndarray
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
        return float(len(self.blocks)) * (self.outer_rows + self.inner_rows)


@lru_cache(maxsize=8)
def halves(question: Question) -> Halves:
    """The question as arrays."""
    columns = tuple(_column(question.stars, vector) for vector in question.sums) or (_nothing(question.stars),)
    whole = np.ascontiguousarray(np.stack([part for column in columns for part in column.parts], axis=-1))
    size = tuple(column.size for column in columns)
    fixed, outer, inner, counts, split = _parted(question, whole)
    directions = question.stars.directions
    constant = sum((whole[place, direction] for place, direction in fixed), np.zeros(whole.shape[2]))
    blocks = _blocks(counts, split, mirrored=len(question.symmetries) > 1)
    limits = np.array([*_limits(question, size), question.neighbours_at_most])
    tables = kernels.Tables(
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
        limits=limits,
    )
    return Halves(
        tables,
        blocks,
        _most_rows(blocks[:, :directions]),
        _most_rows(blocks[:, directions:-1]),
        size,
        tuple(column.spread for column in columns),
        tuple(float(np.abs(column.weights).sum()) for column in columns),
        units(question, size),
    )


@dataclass(frozen=True)
class _Column:
    """A sum as numbers: the weight of each place, divided by the greatest; the unit vector of each direction."""

    weights: np.ndarray
    turns: np.ndarray
    size: float

    @property
    def parts(self) -> tuple[np.ndarray, np.ndarray]:
        return np.outer(self.weights, np.real(self.turns)), np.outer(self.weights, np.imag(self.turns))

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


def _parted(question: Question, whole: np.ndarray) -> tuple[list[tuple[int, int]], list[int], list[int], list[int], int]:
    """Fixed places with their directions; free ones, outer half and inner half; how many each direction has left; outer places."""
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
    return fixed, free[:split], free[split:], counts, split


def _blocks(counts: list[int], split: int, *, mirrored: bool) -> np.ndarray:
    """All shares of the outer half, the rest for the inner one, and how many blocks each stands for [b, 2 n + 1]."""
    directions = len(counts)
    shares: list[tuple[int, ...]] = []
    _share(tuple(counts), split, (), shares)
    rows: list[tuple[int, ...]] = []
    for share in shares:
        image = (share[0], *share[:0:-1]) if mirrored else share
        if share <= image:
            rest = tuple(counts[d] - share[d] for d in range(directions))
            rows.append((*share, *rest, 1 if share == image else 2))
    return np.array(rows, np.int64).reshape(-1, 2 * directions + 1)


def _share(left: tuple[int, ...], wanted: int, before: tuple[int, ...], out: list[tuple[int, ...]]) -> None:
    """All ways to take so many from what is left, in the order of words."""
    if not left:
        out.append(before)
        return
    rest = sum(left[1:])
    for taken in range(max(0, wanted - rest), min(left[0], wanted) + 1):
        _share(left[1:], wanted - taken, (*before, taken), out)


def _most_rows(shares: np.ndarray) -> int:
    """The greatest number of arrangements of a half over the blocks."""
    kinds = {tuple(sorted(int(count) for count in share if count)) for share in shares}
    most = 1
    for kind in kinds:
        rows = factorial(sum(kind))
        for count in kind:
            rows //= factorial(count)
        most = max(most, rows)
    return most


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
        max((abs(weight * vector.scale) * size[place[vector]] for weight, vector in objective.terms), default=0.0) or 1.0
        for objective in question.objectives
    )


def _limits(question: Question, size: tuple[float, ...]) -> list[float]:
    out = [inf] * len(size)
    place = {vector: o for o, vector in enumerate(question.sums)}
    for limit in question.limits:
        o = place[limit.sum]
        out[o] = min(out[o], limit.greatest / (limit.sum.scale * size[o]))
    return out
