"""How long a search takes and how much memory, before it is begun."""

from __future__ import annotations

import time
from dataclasses import replace
from fractions import Fraction
from functools import lru_cache
from math import sqrt

from crankstar.stars import work
from crankstar.stars.halves import Halves, halves
from crankstar.stars.question import All, Question
from crankstar.stars.regions import Regions, regions
from crankstar.stars.star import Stars
from crankstar.stars.sums import couple, of
from crankstar.stars.work import BlockRange, asked, results_of

RANGE_SECONDS = 1.0
"""How long a block range should take: long enough to be worth sending, short enough to lose."""
SAMPLE_SECONDS = 0.3
"""How long blocks are timed for an estimate."""
SAMPLE_ROWS = 400_000
"""Arrangements of a half up to which blocks are timed themselves: 60 MB, a tenth of a second."""


def range_size(question: Question, ready: Halves, tried: Regions) -> int:
    """The blocks of about one second's work on an ordinary machine."""
    return max(
        1, int(RANGE_SECONDS * ready.block_count / max(cost(question, ready, tried), RANGE_SECONDS))
    )


def cost(question: Question, ready: Halves, tried: Regions) -> float:
    """Seconds on one processor, roughly: forming arrangements, comparing pairs, listing stars."""
    listed = 4e-6 if isinstance(question.ask, All) else 0.0
    return ready.rows * (6e-9 + 18e-9 * len(tried.radii)) + tried.expected * (6e-8 + listed)


def estimate(question: Question) -> float:
    """Seconds on one processor of this machine for the first attempt, within a factor of two.

    Mostly the first attempt is all.

    Blocks spread evenly over the question are timed. Where one block is too much, so are those of
    the question with more throws fixed, and how much more there is to do is counted. Objectives in
    Python are not.
    """
    plain = asked(question)
    _warm()
    narrow, seconds = plain, 0.0
    while not _quick(narrow):
        narrow = _narrower(narrow)
    ready, tried = halves(narrow), regions(narrow, halves(narrow))
    size = max(1, int(SAMPLE_SECONDS / 10 * ready.block_count / cost(narrow, ready, tried)))
    timed, done, step = 0, 0, (sqrt(5) - 1) / 2
    began = time.perf_counter()
    while seconds < SAMPLE_SECONDS and done < ready.block_count:
        start = int(timed * step % 1 * ready.block_count)
        stop = min(start + size, ready.block_count)
        results_of(BlockRange(narrow, tried, start, stop))
        timed, done, seconds = timed + 1, done + stop - start, time.perf_counter() - began
    whole = halves(plain)
    return (
        seconds
        / done
        * ready.block_count
        * cost(plain, whole, regions(plain, whole))
        / cost(narrow, ready, tried)
    )


def _quick(question: Question) -> bool:
    """Whether a block of a question can be timed."""
    ready = halves(question)
    small = max(ready.outer_rows, ready.inner_rows) <= SAMPLE_ROWS
    return (
        small
        and cost(question, ready, regions(question, ready)) / ready.block_count
        <= SAMPLE_SECONDS / 2
    )


def _narrower(question: Question) -> Question:
    """The question with one more throw fixed, in a direction that has room for it."""
    stars = question.stars
    held = {place for place, _ in stars.fixed_places}
    free = next(members[0] for index, members in enumerate(stars.places) if index not in held)
    given = [direction for _, direction in stars.fixed_places]
    room = next(
        direction for direction in range(stars.directions) if given.count(direction) < stars.each
    )
    return replace(question, stars=replace(stars, fixed=(*stars.fixed, (free + 1, room))))


@lru_cache(maxsize=1)
def _warm() -> None:
    """Loads the compiled loops, so that this is not timed."""
    stars = Stars(4, "two-stroke", tuple(Fraction(3 - 2 * j, 2) for j in range(4)))
    question = Question(stars, (of(couple(stars, 1)),))
    ready = halves(question)
    results_of(
        BlockRange(question, regions(question, ready), 0, ready.block_count)
    )  # not `searched`, which would keep an interrupt


def memory(question: Question) -> float:
    """Bytes that each worker may come to use."""
    return work.memory(halves(asked(question)))
