"""A search from beginning to end: stretches handed out to processes or a cluster, gathered, proved complete.

The answer hangs neither on who did which stretch, nor on how long the stretches are, nor on the order in which they come back,
nor on whether the search was stopped between and taken up again.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from concurrent.futures import FIRST_COMPLETED, Future, wait
from contextlib import suppress
from dataclasses import dataclass, replace
from math import ceil

from crankstar.search import checkpoint as checkpoints
from crankstar.search import harvest
from crankstar.search.checkpoint import Checkpoint
from crankstar.search.halves import Halves, halves
from crankstar.search.hands import AHEAD, Hands, of_workers
from crankstar.search.harvest import Harvest
from crankstar.search.question import All, Question
from crankstar.search.stars import SearchError
from crankstar.search.strips import Strips, complete, strips
from crankstar.search.work import Stretch, worked

ATTEMPTS = 60
"""Doublings of the radii after which the strips hold everything many times over."""
RETRIES = 3
"""How often a stretch is given out again when its worker was lost."""
STRETCH_SECONDS = 1.0
"""How long a stretch should take: long enough to be worth sending, short enough to lose."""


@dataclass(frozen=True)
class Progress:
    """How far a search has come: blocks done and in all in this attempt, stars weighed, seconds gone and expected to be left."""

    attempt: int
    done: int
    blocks: int
    met: int
    seconds: float
    seconds_left: float | None


@dataclass(frozen=True)
class Outcome:
    """What a search found, in which strips, and whether that is proved to be all."""

    question: Question
    asked: Question
    """What the blocks were asked: the question, but for all stars where Python functions are to judge them."""
    found: Harvest
    strips: Strips
    attempts: int
    blocks: int
    complete: bool
    interrupted: bool = False


Watch = Callable[[Progress], None]


def searched(
    question: Question,
    *,
    hands: Hands | None = None,
    stretch: int | None = None,
    checkpoint: Checkpoint | None = None,
    watch: Watch | None = None,
) -> Outcome:
    """The answer to a question, with its proof.

    hands: who does the work (`processes`, `cluster`, or any Executor in `Hands`); None works in this process. stretch: blocks
    that are handed out together (by default about a second's work). checkpoint: where stretches are kept. watch: is told of the
    progress.
    A KeyboardInterrupt ends the search early: the outcome is then marked interrupted, and is not complete.
    Raises SearchError where the checkpoint cannot be written.
    """
    asked = replace(question, ask=All()) if question.judges else question
    ready = halves(asked)
    blocks = len(ready.blocks)
    found, tried, attempt = harvest.nothing(len(asked.objectives), len(asked.stars.places)), strips(asked, ready), 0
    while True:
        kept = checkpoint.done.setdefault(attempt, {}) if checkpoint else {}
        effort = _Effort(asked, tried, attempt, blocks, stretch or _stretch(ready, tried), hands, checkpoint, watch)
        found, stopped = effort.run(dict(kept))
        if stopped:
            return Outcome(question, asked, found, tried, attempt + 1, blocks, complete=False, interrupted=True)
        if complete(asked, found, tried):
            return Outcome(question, asked, found, tried, attempt + 1, blocks, complete=True)
        attempt += 1
        tried = strips(asked, ready, attempt=attempt)


def _stretch(ready: Halves, tried: Strips) -> int:
    """Blocks of about a second's work, by what arrangements and pairs cost on an ordinary machine."""
    seconds = cost(ready, tried)
    return max(1, ceil(len(ready.blocks) * STRETCH_SECONDS / max(seconds, STRETCH_SECONDS)))


def cost(ready: Halves, tried: Strips) -> float:
    """Seconds on one processor that a search in these strips takes, roughly."""
    return ready.rows * (6e-9 + 18e-9 * len(tried.radii)) + tried.expected * 6e-8


class _Effort:
    """One attempt: stretches to do, stretches under way, what is found."""

    def __init__(
        self,
        question: Question,
        tried: Strips,
        attempt: int,
        blocks: int,
        stretch: int,
        hands: Hands | None,
        checkpoint: Checkpoint | None,
        watch: Watch | None,
    ) -> None:
        self.question, self.tried, self.attempt, self.blocks = question, tried, attempt, blocks
        self.stretch, self.hands, self.checkpoint, self.watch = stretch, hands, checkpoint, watch
        self.began = time.monotonic()
        self.first_done = 0
        self.done = 0
        self.found = harvest.nothing(len(question.objectives), len(question.stars.places))

    def run(self, kept: dict[tuple[int, int], Harvest]) -> tuple[Harvest, bool]:
        """What all stretches bring in, and whether it was stopped before the end."""
        todo = checkpoints.left(self.blocks, kept, self.stretch)
        self.found = harvest.gathered([self.found, *kept.values()], self.question.ask)
        self.done = self.first_done = self.blocks - sum(stop - start for start, stop in todo)
        try:
            if self.hands is None:
                for start, stop in todo:
                    self._take((start, stop), worked(self._stretch(start, stop)))
            else:
                self._shared(todo, self.hands)
        except KeyboardInterrupt:
            return self.found, True
        return self.found, False

    def _stretch(self, start: int, stop: int) -> Stretch:
        return Stretch(self.question, self.tried, start, stop)

    def _take(self, stretch: tuple[int, int], new: Harvest) -> None:
        self.found = harvest.gathered([self.found, new], self.question.ask)
        self.done += stretch[1] - stretch[0]
        if self.checkpoint:
            self.checkpoint.add(self.attempt, stretch, new)
        if self.watch:
            gone = time.monotonic() - self.began
            here = self.done - self.first_done
            left = gone / here * (self.blocks - self.done) if here else None
            self.watch(Progress(self.attempt, self.done, self.blocks, self.found.met, gone, left))

    def _shared(self, todo: list[tuple[int, int]], hands: Hands) -> None:
        """Hands stretches out, a few at a time; one whose worker was lost is handed out again."""
        waiting = list(reversed(todo))
        under_way: dict[Future[Harvest], tuple[int, int]] = {}
        lost: dict[tuple[int, int], int] = {}
        try:
            while waiting or under_way:
                while waiting and len(under_way) < AHEAD * hands.workers:
                    stretch = waiting.pop()
                    under_way[hands.submit(self._stretch(*stretch))] = stretch
                ended, _ = wait(under_way, timeout=0.5, return_when=FIRST_COMPLETED)
                again = [under_way[future] for future in ended if future.cancelled() or future.exception()]
                for stretch in again:
                    lost[stretch] = lost.get(stretch, 0) + 1
                for future in ended:
                    stretch = under_way.pop(future)
                    if stretch not in again:
                        self._take(stretch, future.result())
                    elif not future.cancelled():
                        _bear(future.exception(), lost[stretch])
                if again:
                    hands.mend()
                    waiting += reversed(again)
        finally:
            for future in under_way:
                with suppress(Exception):
                    future.cancel()


def _bear(fault: BaseException | None, times: int) -> None:
    """Raises a fault of the work, and the loss of workers where it has gone on too long."""
    if fault is None or (of_workers(fault) and times <= RETRIES):
        return
    if of_workers(fault):
        message = (
            f"a part of the search has lost its worker {times} times ({type(fault).__name__}); too little memory ends processes so"
        )
        raise SearchError([message])
    raise fault
