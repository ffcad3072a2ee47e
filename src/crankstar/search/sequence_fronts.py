"""The front over all stars of a shaft and all firing sequences on each, proved complete.

The stars are divided by the classes of their first throws, and the parts are handed out to threads
(the compiled loops hold no lock). All stars are visited; the sequences of one are left out only
where a bound shows that a point found is better. So the front is complete, whatever the order in
which the parts are done, and so is the number of orders at each point.
"""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterator
from concurrent.futures import FIRST_COMPLETED, Future, ThreadPoolExecutor, wait
from contextlib import contextmanager
from dataclasses import dataclass
from fractions import Fraction
from math import inf
from typing import Any, NamedTuple

import numpy as np

from crankstar.search import sequence_kernels, sign_kernels
from crankstar.search.faults import error
from crankstar.search.interrupts import signals_noted
from crankstar.search.sequence_arrays import (
    FORMED,
    FOUND,
    KNOWN,
    STARS,
    SequenceOutput,
    ShaftTables,
    Walk,
)
from crankstar.search.shafts import Fired, Shaft
from crankstar.search.sums import SAME
from crankstar.search.vector_sums import NEIGHBOURS, OrderSum, SequenceQuestion, straight, torsion

BUFFER = 1 << 13
"""Rows that are collected before they are merged, beside those that one star can bring."""
GREATEST_FRONT = 1 << 15
"""Points of a front."""
PARTS = 64
"""Parts into which the stars are divided, at least, where there are so many."""
OF_A_PART = 10_000
"""Stars that a part has at least; to begin one takes as long as to visit a thousand."""
MOST_STARS = 4_000_000_000
"""Stars that are visited; more take hours."""
WAIT_SECONDS = 0.5


@dataclass(frozen=True)
class Point:
    """A point of the front: values of the goals, one order that has them, and how many do.

    like: other orders with these values, as many as were kept; orders: all of them, stars and
    sequences counted that are mirror images, too.
    """

    values: tuple[float, ...]
    fired: Fired
    orders: int
    like: tuple[Fired, ...] = ()


@dataclass(frozen=True)
class SequenceFront:
    """The points by their first value, and what was done to find them.

    stars: visited; formed: sequences that were looked at, which depends on the order of the parts;
    complete: all parts were done, so that no point is missing.
    """

    question: SequenceQuestion
    points: tuple[Point, ...]
    stars: int
    formed: int
    complete: bool = True


Watch = Callable[[int, int], None]
"""Receives how many parts are done, of how many."""


def sequence_front(
    question: SequenceQuestion, *, workers: int = 1, watch: Watch | None = None
) -> SequenceFront:
    """The front of a question. An interrupt from the keyboard ends it early, not complete.

    Raises SearchError where there are too many stars.

    >>> from crankstar.search.shafts import shaft_of
    >>> from crankstar.search.vector_sums import Goal, couple, straight, torsion
    >>> six = shaft_of(6)
    >>> goals = [couple(six, 1), torsion(six, Fraction(3, 2), straight(six))]
    >>> front = sequence_front(SequenceQuestion(six, tuple(Goal(k.name, (k,)) for k in goals)))
    >>> # free of couples, order 1.5 can be 2 (1 - 3/5 - 1/5)
    >>> [tuple(round(value, 4) for value in point.values) for point in front.points][0]
    (0.0, 0.4)
    """
    shaft = question.shaft
    if shaft.count > MOST_STARS:
        raise error("", "too-many-stars", stars=f"{shaft.count:,}", most=f"{MOST_STARS:,}")
    parts = list(_prefixes(question))
    tables, unit = _tables(question)
    found, counts, done = Rows.nothing(len(unit), shaft), np.zeros(5, np.int64), 0
    with signals_noted() as stop, _threads(workers) as (pool, halt):
        todo, under_way = iter(parts), set[Future[Any]]()
        while True:
            while len(under_way) < 2 * workers and not stop.is_set():
                part = next(todo, None)
                if part is None:
                    break
                known = found.points
                under_way.add(pool.submit(_of_part, tables, question, part, known, halt))
            if not under_way:
                break
            ended, under_way = wait(under_way, timeout=WAIT_SECONDS, return_when=FIRST_COMPLETED)
            if stop.is_set():
                halt.set()
            for future in ended:
                new, state, whole = future.result()
                found = found.merged(new, question.size)
                counts += state
                done += whole
            if watch and ended:
                watch(done, len(parts))
    return SequenceFront(
        question,
        _answer(question, found),
        int(counts[STARS]),
        int(counts[FORMED]),
        done == len(parts),
    )


@contextmanager
def _threads(workers: int) -> Iterator[tuple[ThreadPoolExecutor, threading.Event]]:
    """Threads, and what halts them between two calls of the loops, as any fault does."""
    halt = threading.Event()
    with ThreadPoolExecutor(workers) as pool:
        try:
            yield pool, halt
        finally:
            halt.set()


def _width(shaft: Shaft) -> int:
    return shaft.throws + (shaft.classes if shaft.room == 2 else 0)


def mirrored(question: SequenceQuestion) -> bool:
    """Whether mirror images have the same values: both rods of each pin have one amplitude."""
    rods = question.shaft.rods
    return all(
        len(set(one.weights[place : place + rods])) == 1
        for goal in question.goals
        for one in goal.sums
        if one.kind == "T"
        for place in range(0, len(one.weights), rods)
    )


def _prefixes(question: SequenceQuestion) -> Iterator[np.ndarray]:
    """The classes of the first throws, enough to make so many parts; of mirror images the first."""
    shaft, once = question.shaft, mirrored(question)
    listed: list[tuple[int, ...]] = [(0,)]
    wanted = min(PARTS, shaft.count // OF_A_PART + 1)
    while len(listed) < wanted and len(listed[0]) < shaft.throws:
        listed = [(*row, own) for row in listed for own in range(shaft.classes)]
        if once:
            listed = [row for row in listed if _first(row, shaft.classes)]
    # those in between are begun first: their couples are small sooner than those of the ends
    for row in sorted(listed, key=lambda row: abs(row[-1] - shaft.classes / 2)):
        yield np.array(row, np.int64)


def _first(row: tuple[int, ...], classes: int) -> bool:
    return row <= tuple((classes - own) % classes for own in row)


def _tables(question: SequenceQuestion) -> tuple[ShaftTables, np.ndarray]:
    """The question as arrays, and the unit of each goal in them."""
    shaft = question.shaft
    stars, signs = question.star_sums, question.sequence_sums
    if question.counts and shaft.room == 2 and not signs:  # so that sequences are gone through
        signs = (torsion(shaft, Fraction(1, 2), straight(shaft)),)
    step = 2 * np.pi * np.arange(shaft.classes) / shaft.classes
    columns = [_column(shaft, one, step) for one in stars]
    turns = [part for one in signs for part in _parts(np.exp(-1j * float(one.order) * step))]
    amplitudes = np.array(signs[0].weights if signs else (0,) * shaft.cylinders, float)
    reach = [sum(map(abs, map(float, one.weights))) * one.scale for one in (*stars, *signs)]
    at = {one: place for place, one in enumerate((*stars, *signs))}
    sizes = [max((reach[at[one]] for one in goal.sums), default=1.0) for goal in question.goals]
    unit = np.where(np.array(sizes) > 0, sizes, 1.0)
    unit = np.maximum(unit / shaft.throws, 1e-9)
    weights = np.zeros((len(unit), len(at)))
    for row, goal, size in zip(weights, question.goals, unit, strict=True):
        for one in goal.sums:
            row[at[one]] = one.scale / size
    caps = np.full(len(stars), inf)
    for cap in question.caps:
        place = at[cap.sum]
        least = cap.greatest / cap.sum.scale if cap.sum.scale > 1e-12 else inf
        caps[place] = min(caps[place], least)
    most = question.neighbours_at_most
    alone = np.flatnonzero(weights[:, len(stars) :].any(axis=1))
    counted = question.goals.index(NEIGHBOURS) if NEIGHBOURS in question.goals else -1
    tables = ShaftTables(
        star=np.ascontiguousarray(
            np.stack([part for column in columns for part in _parts(column)], axis=-1)
            if columns
            else np.zeros((shaft.throws, shaft.classes, 0))
        ),
        amplitudes=amplitudes.reshape(shaft.throws, shaft.rods),
        turns=np.ascontiguousarray(
            np.stack(turns, axis=-1) if turns else np.zeros((shaft.classes, 0))
        ),
        star_weights=np.ascontiguousarray(weights[:, : len(stars)]),
        sequence_weights=np.ascontiguousarray(weights[:, len(stars) :]),
        caps=caps,
        shift=shaft.shift if shaft.rods == 2 else 0,
        room=shaft.room,
        mirrored=mirrored(question),
        goal=int(alone[0]) if len(alone) == 1 and counted < 0 else -1,
        counts=question.counts,
        counted=counted,
        size=float(unit[counted]),
        at_most=shaft.cylinders if most is None else most,
        step=2 % shaft.classes if shaft.room == 1 and shaft.cycle_deg == 720 else 1,
    )
    return tables, unit


def _parts(column: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    return np.real(column), np.imag(column)


def _column(shaft: Shaft, one: OrderSum, step: np.ndarray) -> np.ndarray:
    """What each throw adds to a sum of the star in each class [n, K]."""
    weights = np.array(one.weights, float)
    if one.kind != "T":
        return np.outer(weights, np.exp(-1j * float(one.order) * step))
    own = np.arange(shaft.classes)
    out = np.zeros((shaft.throws, shaft.classes), complex)
    for bank, of_bank in enumerate(weights.reshape(shaft.throws, shaft.rods).T):
        at = (own + bank * shaft.shift) % shaft.classes
        angle = step[at] + 2 * np.pi * (at % 2) * (shaft.room == 1 and shaft.cycle_deg == 720)
        out += np.outer(of_bank, np.exp(-1j * float(one.order) * angle))
    return out


class Rows(NamedTuple):
    """Orders found: values [f, q], classes and signs [f, n + K], and how many there are [f].

    The first row of a point stands for all orders with its values, the others for none. points: the
    distinct values, those first that turn most others away [p, q].
    """

    values: np.ndarray
    lines: np.ndarray
    times: np.ndarray
    points: np.ndarray

    @classmethod
    def nothing(cls, goals: int, shaft: Shaft) -> Rows:
        """No orders."""
        none = np.zeros((0, goals))
        return cls(none, np.zeros((0, _width(shaft)), np.int8), np.zeros(0, np.int64), none)

    def merged(self, other: Rows, size: int) -> Rows:
        """The rows of both that are on the front of both; of each point the first ones."""
        values, lines, times = map(np.concatenate, zip(self[:3], other[:3], strict=True))
        points = np.empty((GREATEST_FRONT, values.shape[1]))
        points[: len(self.points)] = self.points
        known = sign_kernels.joined(points, len(self.points), other.points)
        if known >= GREATEST_FRONT:
            raise error("minimise", "front-too-large", most=f"{GREATEST_FRONT:,}")
        points = points[:known][np.argsort(points[:known].sum(axis=1), kind="stable")]
        order = np.lexsort(lines.T[::-1])
        values, lines, times = values[order], lines[order], times[order]
        home = np.empty(len(values), np.int64)
        sign_kernels.sifted(values, times, points, size, home)
        kept = home >= 0
        return Rows(values[kept], lines[kept], times[kept], points)


def _of_part(
    tables: ShaftTables,
    question: SequenceQuestion,
    prefix: np.ndarray,
    known: np.ndarray,
    halt: threading.Event,
) -> tuple[Rows, np.ndarray, bool]:
    """What is found with a prefix, how much was done, and whether that was all."""
    shaft, goals = question.shaft, len(question.goals)
    walk, most = _walk(shaft, tables), shaft.sequences
    rows = BUFFER + most
    output = SequenceOutput(
        np.empty((rows, goals)), np.empty((rows, _width(shaft)), np.int8), np.empty(rows, np.int64)
    )
    front = np.empty((GREATEST_FRONT, goals))
    state = np.zeros(5, np.int64)
    state[KNOWN] = min(len(known), GREATEST_FRONT)
    front[: state[KNOWN]] = known[: state[KNOWN]]
    found, ended = Rows.nothing(goals, shaft), False
    while not ended and not halt.is_set():
        ended = sequence_kernels.visited(tables, prefix, walk, output, front, most, state)
        values, lines, times = (array[: state[FOUND]].copy() for array in output)
        state[FOUND] = 0
        new = Rows(values, lines, times, front[: state[KNOWN]].copy())
        found = found.merged(new, question.size)
    return found, state, ended


def _walk(shaft: Shaft, tables: ShaftTables) -> Walk:
    throws, classes = shaft.throws, shaft.classes
    goals, width = len(tables.star_weights), tables.turns.shape[1]
    middle = (classes + 1) // 2
    few = width > 0
    return Walk(
        choice=np.zeros(throws, np.int64),
        sums=np.zeros((throws + 1, tables.star.shape[2])),
        hits=np.zeros(classes, np.int64),
        values=np.zeros(goals),
        bounds=np.zeros(goals),
        whole=np.zeros(goals),
        seen=np.zeros(classes, np.int64),
        seat=np.zeros((classes, 2), np.int64),
        delta=np.zeros(classes),
        front_half=np.zeros((width, 2 ** (middle - 1) if few else 1)),
        rear_half=np.zeros((width, 2 ** (classes - middle) if few else 1)),
    )


def _answer(question: SequenceQuestion, found: Rows) -> tuple[Point, ...]:
    """The points of rows, with exact zeros."""
    throws = question.shaft.throws
    points: list[Point] = []
    first = np.flatnonzero(found.times)
    if not len(first):
        return ()
    apart = (np.abs(found.values[first] - own).max(axis=1) for own in found.values)
    near = np.array([gaps.argmin() for gaps in apart])
    for place, row in enumerate(first):
        lines = found.lines[near == place].tolist()
        every = [Fired(tuple(line[:throws]), tuple(map(bool, line[throws:]))) for line in lines]
        every.sort(key=question.shaft.firing_order)
        if not all(map(question.within, every)):
            raise error("zero", "near-zero")
        times = int(found.times[row])
        points.append(Point(question.values(every[0]), every[0], times, tuple(every[1:])))
    return tuple(sorted(points, key=lambda point: tuple(round(v, 9) for v in point.values)))


def beaten(
    front: SequenceFront, fired: Fired
) -> tuple[tuple[float, ...], list[tuple[int, tuple[int, ...]]]]:
    """The values of an order, and which points beat it, each with the goals that are better there.

    Points from 0, goals from 0; a point with equal values beats it in none.
    """
    values = question_values(front.question, fired)
    out: list[tuple[int, tuple[int, ...]]] = []
    for place, point in enumerate(front.points):
        near = [_near(goal) for goal in values]
        pairs = list(zip(point.values, values, near, strict=True))
        if all(own <= other + slack for own, other, slack in pairs):
            better = [q for q, (own, other, slack) in enumerate(pairs) if own < other - slack]
            out.append((place, tuple(better)))
    return values, out


def _near(value: float) -> float:
    return SAME * max(1.0, value)


def question_values(question: SequenceQuestion, fired: Fired) -> tuple[float, ...]:
    """The values of the goals for an order. Raises SearchError where it breaks a cap."""
    if not question.within(fired):
        raise error(
            "why", "order-capped", given="-".join(map(str, question.shaft.firing_order(fired)))
        )
    return question.values(fired)
