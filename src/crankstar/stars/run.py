"""A search from beginning to end.

Block ranges handed out to processes or a cluster, merged, proved complete.

The answer depends neither on who did which block range, nor on how long these are, nor on the order
in which they come back, nor on whether the search was stopped in between and resumed.
"""

from __future__ import annotations

import threading
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field, replace

from crankstar.stars import checkpoint as checkpoints
from crankstar.stars import results
from crankstar.stars.checkpoint import Checkpoint, Span
from crankstar.stars.distribution import Handout
from crankstar.stars.estimates import range_size as usual_size
from crankstar.stars.executors import Workers
from crankstar.stars.faults import error
from crankstar.stars.halves import Halves, check, halves
from crankstar.stars.interrupts import signals_noted
from crankstar.stars.progress import Progress
from crankstar.stars.question import Question
from crankstar.stars.regions import Regions, complete, regions
from crankstar.stars.results import Results
from crankstar.stars.work import BlockRange, asked, results_of


@dataclass(frozen=True)
class Outcome:
    """The stars a search found, in which regions, and whether these are proved to be all."""

    question: Question
    asked: Question
    """What the blocks were asked.

    The question, but for all stars where Python functions are to judge them.
    """
    results: Results
    regions: Regions
    attempts: int
    blocks: int
    complete: bool
    interrupted: bool = False


Watch = Callable[[Progress], None]


def searched(
    question: Question,
    *,
    workers: Workers | None = None,
    range_size: int | None = None,
    checkpoint: Checkpoint | None = None,
    watch: Watch | None = None,
) -> Outcome:
    """The answer to a question, with its proof.

    workers: who does the work (`processes`, `cluster`, or any Executor in `Workers`); None works in
    this process. range_size: blocks that are handed out together (by default a second's work).
    checkpoint: where block ranges are kept. watch: receives the progress. An interrupt from the
    keyboard ends the search early: the outcome is then marked interrupted, and is not complete.
    Raises SearchError where the halves are beyond memory, the checkpoint is of another search or
    cannot be written, workers are lost again and again, or a cluster is gone. What the work itself
    raises comes through as it is.
    """
    if checkpoint and checkpoint.question.digest != question.digest:
        raise error("checkpoint", "checkpoint-other", file=str(checkpoint.path))
    check(question)
    if range_size is not None and range_size < 1:
        raise error("", "range-size", given=range_size)
    plain = asked(question)
    ready = halves(plain)
    with signals_noted() as stop:
        means = _Means(workers, range_size, checkpoint, watch, stop)
        best, attempt = results.nothing(len(plain.objectives), len(plain.stars.places)), 0
        while True:
            tried = regions(plain, ready, attempt=attempt)
            effort = _Effort(plain, tried, attempt, ready, means)
            effort.run()
            ended = Outcome(
                question,
                plain,
                effort.results,
                tried,
                attempt + 1,
                ready.block_count,
                complete=False,
            )
            if effort.stopped:
                return replace(
                    ended,
                    results=results.best_so_far(best, effort.results, plain.ask),
                    interrupted=True,
                )
            if complete(plain, effort.results, tried):
                return replace(ended, complete=True)
            best, attempt = effort.results, attempt + 1


@dataclass(frozen=True)
class _Means:
    """With what a search is done, whether it is to stop, and when it began."""

    workers: Workers | None
    range_size: int | None
    checkpoint: Checkpoint | None
    watch: Watch | None
    stop: threading.Event
    began: float = field(default_factory=time.monotonic)


class _Effort:
    """One attempt: what is done, what is found, and whether it was stopped before the end."""

    def __init__(
        self, question: Question, tried: Regions, attempt: int, ready: Halves, means: _Means
    ) -> None:
        self.question, self.tried, self.attempt, self.means = question, tried, attempt, means
        self.blocks = ready.block_count
        self.size = means.range_size or usual_size(question, ready, tried)
        self.began = time.monotonic()
        self.results = results.nothing(len(question.objectives), len(question.stars.places))
        self.done = self.kept = 0
        self.stopped = False

    def run(self) -> None:
        """Does all block ranges that are not done yet."""
        spans: list[Span] = []
        if self.means.checkpoint:
            spans, self.results = self.means.checkpoint.kept(
                self.attempt, self.tried, self.question, self.blocks
            )
        self.done = self.kept = sum(stop - start for start, stop in spans)
        todo = checkpoints.left(self.blocks, spans, self.size)
        try:
            if self.means.workers is None:
                self._alone(todo)
            else:
                self._shared(todo, self.means.workers)
        except KeyboardInterrupt:
            self.stopped = True

    def _block_range(self, span: Span) -> BlockRange:
        return BlockRange(self.question, self.tried, *span)

    def _take(self, span: Span, new: Results) -> None:
        self.results = results.merged([self.results, new], self.question.ask)
        self.done += span[1] - span[0]
        if self.means.checkpoint:
            self.means.checkpoint.add(self.attempt, self.tried, span, new)
        self._tell()

    def _tell(self) -> None:
        if not self.means.watch:
            return
        now = time.monotonic()
        rate = (self.done - self.kept) / max(now - self.began, 1e-9)
        left = (self.blocks - self.done) / rate if rate else None
        self.means.watch(
            Progress(
                self.attempt,
                self.done,
                self.blocks,
                self.results.met,
                now - self.means.began,
                rate,
                left,
            )
        )

    def _alone(self, todo: Iterator[Span]) -> None:
        """Does one block range after the other."""
        for span in todo:
            if self.means.stop.is_set():
                self.stopped = True
                return
            self._take(span, results_of(self._block_range(span)))

    def _shared(self, todo: Iterator[Span], workers: Workers) -> None:
        """Hand block ranges out, a few at a time; repeat those whose worker was lost."""
        handout = Handout(self._block_range, self._take, self._tell)
        self.stopped = not handout.done(todo, workers, self.means.stop)
