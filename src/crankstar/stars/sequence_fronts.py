"""The front over all stars of a shaft and all firing sequences on each, proved complete.

The stars are divided by the classes of their first throws, and the parts are handed out as those of
every search. All stars are visited; the sequences of one are left out only where a bound shows that
a point found is better. So the front is complete, whatever the order in which the parts are done,
whoever does them, and whether it was stopped in between and resumed; and so is the number of orders
at each point.

Where a goal is a Python function no bound holds: all orders within the limits are listed and the
function is called for each, in this process.
"""

from __future__ import annotations

import threading
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass

import numpy as np

from crankstar.stars import checkpoint as checkpoints
from crankstar.stars.checkpoint import Checkpoint, Span
from crankstar.stars.distribution import Handout
from crankstar.stars.executors import Workers
from crankstar.stars.faults import error
from crankstar.stars.interrupts import signals_noted
from crankstar.stars.progress import Progress
from crankstar.stars.sequence_rows import GREATEST_LIST, Rows, as_json, from_json
from crankstar.stars.sequence_tables import mirrored
from crankstar.stars.sequence_work import SequencePart, SequenceResults, prefixes
from crankstar.stars.shafts import Fired
from crankstar.stars.sums import SAME
from crankstar.stars.vector_sums import FunctionGoal, SequenceQuestion

MOST_STARS = 4_000_000_000
"""Stars that are visited; more take hours."""


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
    complete: all parts were done, so that no point is missing; evaluated: for how many orders the
    Python functions among the goals were called, mirror images counted.
    """

    question: SequenceQuestion
    points: tuple[Point, ...]
    stars: int
    formed: int
    complete: bool = True
    evaluated: int = 0


def ways(front: SequenceFront, point: Point) -> tuple[Fired, ...]:
    """The orders of a point that were kept, the shown one first, and their mirror images.

    All that the point counts, where the question keeps so many (`size`).

    >>> from crankstar.stars.shafts import shaft_of
    >>> from crankstar.stars.vector_sums import Goal, couple
    >>> five = shaft_of(5)
    >>> front = sequence_front(SequenceQuestion(five, (Goal("M1", (couple(five, 1),)),)))
    >>> [five.firing_order(fired) for fired in ways(front, front.points[0])]
    [(1, 2, 4, 5, 3), (1, 3, 5, 4, 2)]
    """
    every = dict.fromkeys((point.fired, *point.like))
    if mirrored(front.question):
        every |= dict.fromkeys(map(front.question.shaft.mirrored, tuple(every)))
    return tuple(every)


Watch = Callable[[Progress], None]


def sequence_front(
    question: SequenceQuestion,
    *,
    workers: Workers | None = None,
    checkpoint: Checkpoint | None = None,
    watch: Watch | None = None,
) -> SequenceFront:
    """The front of a question.

    workers: who does the work (`threads`, `processes`, `cluster`, or any Executor in `Workers`);
    None works in this thread. checkpoint: where parts are kept. watch: receives the progress. An
    interrupt from the keyboard ends the search early, not complete. Raises SearchError where there
    are too many stars, or too many orders for a Python function; where the checkpoint is of another
    search or cannot be written, workers are lost again and again, or a cluster is gone.

    >>> from fractions import Fraction
    >>> from crankstar.stars.shafts import shaft_of
    >>> from crankstar.stars.vector_sums import Goal, couple, straight, torsion
    >>> six = shaft_of(6)
    >>> goals = [couple(six, 1), torsion(six, Fraction(3, 2), straight(six))]
    >>> front = sequence_front(SequenceQuestion(six, tuple(Goal(k.name, (k,)) for k in goals)))
    >>> # free of couples, order 1.5 can be 2 (1 - 3/5 - 1/5)
    >>> [tuple(round(value, 4) for value in point.values) for point in front.points][0]
    (0.0, 0.4)
    """
    check(question)
    if checkpoint and checkpoint.question.digest != question.digest:
        raise error("checkpoint", "checkpoint-other", file=str(checkpoint.path))
    with signals_noted() as stop:
        effort = _Effort(question, workers, checkpoint, watch, stop)
        effort.run()
    found, whole = effort.found, effort.done == effort.parts
    points, evaluated = _points(question, found.rows)
    return SequenceFront(question, points, found.stars, found.formed, whole, evaluated)


def check(question: SequenceQuestion) -> None:
    """Raises SearchError where there are too many stars, or orders for a Python function."""
    shaft = question.shaft
    if shaft.count > MOST_STARS:
        raise error("", "too-many-stars", stars=f"{shaft.count:,}", most=f"{MOST_STARS:,}")
    free = not question.caps and question.neighbours_at_most is None
    if question.functions and free and shaft.count * shaft.sequences > 2 * GREATEST_LIST:
        raise error("", "function-orders", most=f"{GREATEST_LIST:,}")


class _Effort:
    """What is done and found so far."""

    def __init__(
        self,
        question: SequenceQuestion,
        workers: Workers | None,
        checkpoint: Checkpoint | None,
        watch: Watch | None,
        stop: threading.Event,
    ) -> None:
        self.question = question.sent
        self.workers, self.checkpoint, self.watch, self.stop = workers, checkpoint, watch, stop
        self.prefixes = prefixes(question)
        self.parts = len(self.prefixes)
        self.found = SequenceResults(Rows.nothing(len(question.goals), question.shaft))
        self.done = self.kept = 0
        self.began = time.monotonic()

    def run(self) -> None:
        """Do all parts that are not done yet; a second interrupt ends it at once."""
        spans = list(self._resumed())
        self.kept = self.done
        todo = checkpoints.left(self.parts, sorted(spans), 1)
        try:
            if self.workers:
                Handout(self._part, self._take, self._tell).done(todo, self.workers, self.stop)
                return
            for span in todo:
                if self.stop.is_set():
                    return
                self._take(span, self._part(span).results())
        except KeyboardInterrupt:
            return

    @property
    def _shape(self) -> list[int]:
        """What two runs must have in common for their parts to be parts of one search."""
        return [self.parts, self.prefixes.shape[1]]

    def _resumed(self) -> Iterator[Span]:
        """The spans of a checkpoint, what they brought in found."""
        if not self.checkpoint:
            return
        for body in self.checkpoint.parts(0, self._shape, self.parts):
            rows = from_json(body, self.question)
            new = SequenceResults(rows, int(body["stars"]), int(body["formed"]))
            self.found = self.found.joined(new, self.question)
            start, stop = body["blocks"]
            self.done += stop - start
            yield start, stop

    def _part(self, span: Span) -> SequencePart:
        halt = self.workers.halt if self.workers else self.stop
        own = self.prefixes[slice(*span)]
        return SequencePart(self.question, *span, own, self.found.rows.points, halt)

    def _take(self, span: Span, new: SequenceResults) -> None:
        self.found = self.found.joined(new, self.question)
        if new.whole:
            self.done += span[1] - span[0]
            if self.checkpoint:
                whose = {"attempt": 0, "regions": self._shape, "blocks": list(span)}
                counts = {"stars": new.stars, "formed": new.formed}
                self.checkpoint.write(whose | counts | as_json(new.rows))
        self._tell()

    def _tell(self) -> None:
        if not self.watch:
            return
        seconds = time.monotonic() - self.began
        rate = (self.done - self.kept) / max(seconds, 1e-9)
        left = (self.parts - self.done) / rate if rate else None
        self.watch(Progress(0, self.done, self.parts, self.found.stars, seconds, rate, left))


def _points(question: SequenceQuestion, rows: Rows) -> tuple[tuple[Point, ...], int]:
    """The points of rows, with exact zeros, and how many orders functions were called for."""
    known: dict[tuple[int, ...], tuple[float, ...]] = {}
    count = int(rows.times.sum())
    if question.functions:
        rows, known = _evaluated(question, rows)
    first = np.flatnonzero(rows.times)
    if not len(first):
        return (), count
    apart = (np.abs(rows.values[first] - own).max(axis=1) for own in rows.values)
    near = np.array([gaps.argmin() for gaps in apart])
    points: list[Point] = []
    for index, row in enumerate(first):
        lines = {_fired(question, line): tuple(line) for line in rows.lines[near == index].tolist()}
        every = sorted(lines, key=question.shaft.firing_order)
        if not all(map(question.kept, every)):
            raise error("zero", "near-zero")
        own = iter(known.get(lines[every[0]], ()))
        values = tuple(
            next(own) if isinstance(goal, FunctionGoal) else goal.value(question.shaft, every[0])
            for goal in question.goals
        )
        points.append(Point(values, every[0], int(rows.times[row]), tuple(every[1:])))
    points.sort(key=lambda point: tuple(round(value, 9) for value in point.values))
    return tuple(points), count if question.functions else 0


def _fired(question: SequenceQuestion, line: list[int]) -> Fired:
    throws = question.shaft.throws
    return Fired(tuple(line[:throws]), tuple(map(bool, line[throws:])))


def _evaluated(
    question: SequenceQuestion, rows: Rows
) -> tuple[Rows, dict[tuple[int, ...], tuple[float, ...]]]:
    """The front of listed orders with the values of functions, and these by line.

    Values of a function are the same where they differ by less than 1e-9 of its largest.
    """
    columns, known = rows.values.copy(), {}
    for line in rows.lines.tolist():
        fired = _fired(question, line)
        known[tuple(line)] = tuple(f.value(question.shaft, fired) for f in question.functions)
    found = np.array([*known.values()]).reshape(len(known), len(question.functions))
    good = (found <= [each.greatest for each in question.functions]).all(axis=1)
    places = [q for q, goal in enumerate(question.goals) if isinstance(goal, FunctionGoal)]
    most = np.abs(found).max(axis=0, initial=0.0)
    columns[:, places] = found / np.where(most > 0, most, 1.0)
    new = Rows(columns[good], rows.lines[good], rows.times[good], columns[good])
    nothing = Rows.nothing(len(question.goals), question.shaft)
    return nothing.merged(new, question.size), known


def beaten(
    front: SequenceFront, fired: Fired
) -> tuple[tuple[float, ...], list[tuple[int, tuple[int, ...]]]]:
    """The values of an order, and which points beat it, each with the goals that are better there.

    Points from 0, goals from 0; a point with equal values beats it in none.
    """
    values = question_values(front.question, fired)
    out: list[tuple[int, tuple[int, ...]]] = []
    for index, point in enumerate(front.points):
        near = [_near(goal) for goal in values]
        pairs = list(zip(point.values, values, near, strict=True))
        if all(own <= other + slack for own, other, slack in pairs):
            better = [q for q, (own, other, slack) in enumerate(pairs) if own < other - slack]
            out.append((index, tuple(better)))
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
