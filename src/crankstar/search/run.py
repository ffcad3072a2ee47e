"""A search from beginning to end: stretches handed out to processes or a cluster, gathered, proved complete.

The answer hangs neither on who did which stretch, nor on how long the stretches are, nor on the order in which they come back,
nor on whether the search was stopped between and taken up again.
"""

from __future__ import annotations

import signal
import threading
import time
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import FIRST_COMPLETED, CancelledError, Future, wait
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field, replace
from fractions import Fraction
from functools import lru_cache
from math import sqrt

from crankstar.search import checkpoint as checkpoints
from crankstar.search import harvest, work
from crankstar.search.checkpoint import Checkpoint, Span
from crankstar.search.halves import Halves, check, halves
from crankstar.search.hands import Hands, of_workers
from crankstar.search.harvest import Harvest
from crankstar.search.question import All, Question
from crankstar.search.stars import SearchError, Stars
from crankstar.search.strips import Strips, complete, strips
from crankstar.search.sums import couple, of
from crankstar.search.work import Stretch, asked, worked

AHEAD = 3
"""Stretches under way for each worker: none waits for the next."""
RETRIES = 3
"""How often a stretch is given out again when its worker was lost."""
STRETCH_SECONDS = 1.0
"""How long a stretch should take: long enough to be worth sending, short enough to lose."""
WAIT_SECONDS = 0.5
"""How long to wait for a stretch before an interrupt, a lost cluster or the clock is looked at."""


@dataclass(frozen=True)
class Progress:
    """How far a search has come.

    attempt: from 0; done, blocks: of this attempt, those of a checkpoint included; met: stars weighed one by one in it;
    seconds: since the search was begun or taken up again; rate: blocks a second in this attempt, by what was done here;
    seconds_left: expected to the end of this attempt, None as long as nothing is done.
    """

    attempt: int
    done: int
    blocks: int
    met: int
    seconds: float
    rate: float
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
    An interrupt from the keyboard ends the search early: the outcome is then marked interrupted, and is not complete.
    Raises SearchError where the halves are beyond memory, the checkpoint is of another search or cannot be written, workers are
    lost again and again, or a cluster is gone. What the work itself raises comes through as it is.
    """
    if checkpoint and checkpoint.question.digest != question.digest:
        raise SearchError([f"the checkpoint {checkpoint.path} was opened for another search"])
    check(question)
    if stretch is not None and stretch < 1:
        raise SearchError([f"a stretch has at least 1 block, not {stretch}"])
    plain = asked(question)
    ready = halves(plain)
    with _interrupts() as stop:
        means = _Means(hands, stretch, checkpoint, watch, stop)
        best, attempt = harvest.nothing(len(plain.objectives), len(plain.stars.places)), 0
        while True:
            tried = strips(plain, ready, attempt=attempt)
            effort = _Effort(plain, tried, attempt, ready, means)
            effort.run()
            ended = Outcome(question, plain, effort.found, tried, attempt + 1, ready.block_count, complete=False)
            if effort.stopped:
                return replace(ended, found=harvest.best_so_far(best, effort.found, plain.ask), interrupted=True)
            if complete(plain, effort.found, tried):
                return replace(ended, complete=True)
            best, attempt = effort.found, attempt + 1


@contextmanager
def _interrupts() -> Iterator[threading.Event]:
    """Whether an interrupt from the keyboard has come, for a while; a second one is raised where it finds us.

    So no exception breaks into an executor at work. Where the program has a handler of its own, or this is not the main thread,
    nothing is changed.
    """
    stop = threading.Event()
    ours = threading.current_thread() is threading.main_thread() and signal.getsignal(signal.SIGINT) is signal.default_int_handler

    def noted(*_: object) -> None:
        if stop.is_set():
            raise KeyboardInterrupt
        stop.set()

    if ours:
        signal.signal(signal.SIGINT, noted)
    try:
        yield stop
    finally:
        if ours:
            signal.signal(signal.SIGINT, signal.default_int_handler)


@dataclass(frozen=True)
class _Means:
    """With what a search is done, whether it is to stop, and when it began."""

    hands: Hands | None
    stretch: int | None
    checkpoint: Checkpoint | None
    watch: Watch | None
    stop: threading.Event
    began: float = field(default_factory=time.monotonic)


class _Effort:
    """One attempt: what is done, what is found, and whether it was stopped before the end."""

    def __init__(self, question: Question, tried: Strips, attempt: int, ready: Halves, means: _Means) -> None:
        self.question, self.tried, self.attempt, self.means = question, tried, attempt, means
        self.blocks = ready.block_count
        self.size = means.stretch or _stretch(question, ready, tried)
        self.began = time.monotonic()
        self.found = harvest.nothing(len(question.objectives), len(question.stars.places))
        self.done = self.kept = 0
        self.stopped = False

    def run(self) -> None:
        """Does all stretches that are not done yet."""
        spans: list[Span] = []
        if self.means.checkpoint:
            spans, self.found = self.means.checkpoint.kept(self.attempt, self.tried, self.question, self.blocks)
        self.done = self.kept = sum(stop - start for start, stop in spans)
        todo = checkpoints.left(self.blocks, spans, self.size)
        try:
            if self.means.hands is None:
                self._alone(todo)
            else:
                self._shared(todo, self.means.hands)
        except KeyboardInterrupt:
            self.stopped = True

    def _stretch(self, span: Span) -> Stretch:
        return Stretch(self.question, self.tried, *span)

    def _take(self, span: Span, new: Harvest) -> None:
        self.found = harvest.gathered([self.found, new], self.question.ask)
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
        self.means.watch(Progress(self.attempt, self.done, self.blocks, self.found.met, now - self.means.began, rate, left))

    def _alone(self, todo: Iterator[Span]) -> None:
        """Does one stretch after the other."""
        for span in todo:
            if self.means.stop.is_set():
                self.stopped = True
                return
            self._take(span, worked(self._stretch(span)))

    def _shared(self, todo: Iterator[Span], hands: Hands) -> None:
        """Hands stretches out, a few at a time; one whose worker was lost is handed out again."""
        again: list[Span] = []
        lost: dict[Span, int] = {}
        under_way: dict[Future[Harvest], Span] = {}
        over = False
        try:
            while True:
                while len(under_way) < AHEAD * hands.workers and (span := again.pop() if again else next(todo, None)):
                    under_way[hands.submit(self._stretch(span))] = span
                if not under_way:
                    over = True
                    return
                ended, _ = wait(under_way, timeout=WAIT_SECONDS, return_when=FIRST_COMPLETED)
                again += self._received({future: under_way.pop(future) for future in ended}, lost)
                if self.means.stop.is_set():
                    self.stopped = True
                    return
                if not ended:
                    hands.look()
                    self._tell()
        finally:
            if not over:
                _call_back(under_way, hands)

    def _received(self, ended: dict[Future[Harvest], Span], lost: dict[Span, int]) -> list[Span]:
        """Takes what came back; says which stretches were lost with their workers. Raises what the work raised."""
        faults: dict[Span, BaseException] = {}
        for future, span in ended.items():
            fault = _fault(future)
            if fault is None:
                self._take(span, future.result())
            else:
                faults[span] = fault
        for span, fault in faults.items():
            lost[span] = lost.get(span, 0) + 1
            _bear(fault, lost[span])
        return list(faults)


def _fault(future: Future[Harvest]) -> BaseException | None:
    """What went wrong with a stretch; being cancelled (a cluster does that, too) is one of these."""
    try:
        return future.exception()
    except CancelledError as error:
        return error


def _call_back(under_way: Iterable[Future[Harvest]], hands: Hands) -> None:
    """Nobody waits any more for what is under way."""
    for future in under_way:
        with suppress(Exception):  # of whatever kind an Executor has: it is gone, and so is the work
            future.cancel()
    hands.drop()


def _bear(fault: BaseException, times: int) -> None:
    """Raises a fault of the work as it is, and the loss of workers where it has gone on too long."""
    if isinstance(fault, ImportError):
        raise SearchError([f"a worker cannot load crankstar ({fault}); install the same version wherever workers run"]) from fault
    if not of_workers(fault):
        raise fault
    if times > RETRIES:
        message = (
            f"a part of the search has lost its worker {times} times ({type(fault).__name__}); too little memory ends processes so,"
            ' and so does a script that starts processes without: if __name__ == "__main__"'
        )
        raise SearchError([message])


def _stretch(question: Question, ready: Halves, tried: Strips) -> int:
    """Blocks of about a second's work, by what arrangements and pairs cost on an ordinary machine."""
    return max(1, int(STRETCH_SECONDS * ready.block_count / max(cost(question, ready, tried), STRETCH_SECONDS)))


def cost(question: Question, ready: Halves, tried: Strips) -> float:
    """Seconds on one processor that a search takes, roughly: forming arrangements, weighing pairs, listing stars."""
    listed = 4e-6 if isinstance(question.ask, All) else 0.0
    return ready.rows * (6e-9 + 18e-9 * len(tried.radii)) + tried.expected * (6e-8 + listed)


SAMPLE_SECONDS = 0.3
"""How long blocks are timed for an estimate."""
SAMPLE_ROWS = 400_000
"""Arrangements of a half up to which blocks are timed themselves: 60 MB, a tenth of a second."""


def estimate(question: Question) -> float:
    """Seconds that one processor of this machine takes for the first attempt, which mostly is all; within a factor of two or so.

    Blocks spread evenly over the question are timed. Where one block is too much, so are those of the question with more throws
    fixed, and how much more there is to do is counted. Judges in Python are not.
    """
    plain = asked(question)
    _warm()
    narrow, seconds = plain, 0.0
    while not _quick(narrow):
        narrow = _narrower(narrow)
    ready, tried = halves(narrow), strips(narrow, halves(narrow))
    size = max(1, int(SAMPLE_SECONDS / 10 * ready.block_count / cost(narrow, ready, tried)))
    timed, done, step = 0, 0, (sqrt(5) - 1) / 2
    began = time.perf_counter()
    while seconds < SAMPLE_SECONDS and done < ready.block_count:
        start = int(timed * step % 1 * ready.block_count)
        stop = min(start + size, ready.block_count)
        worked(Stretch(narrow, tried, start, stop))
        timed, done, seconds = timed + 1, done + stop - start, time.perf_counter() - began
    whole = halves(plain)
    return seconds / done * ready.block_count * cost(plain, whole, strips(plain, whole)) / cost(narrow, ready, tried)


def _quick(question: Question) -> bool:
    """Whether a block of a question can be timed."""
    ready = halves(question)
    small = max(ready.outer_rows, ready.inner_rows) <= SAMPLE_ROWS
    return small and cost(question, ready, strips(question, ready)) / ready.block_count <= SAMPLE_SECONDS / 2


def _narrower(question: Question) -> Question:
    """The question with one more throw fixed, in a direction that has room for it."""
    stars = question.stars
    held = {place for place, _ in stars.fixed_places}
    free = next(members[0] for place, members in enumerate(stars.places) if place not in held)
    given = [direction for _, direction in stars.fixed_places]
    room = next(direction for direction in range(stars.directions) if given.count(direction) < stars.each)
    return replace(question, stars=replace(stars, fixed=(*stars.fixed, (free + 1, room))))


@lru_cache(maxsize=1)
def _warm() -> None:
    """Loads the compiled loops, so that this is not timed."""
    stars = Stars(4, "two-stroke", tuple(Fraction(3 - 2 * j, 2) for j in range(4)))
    question = Question(stars, (of(couple(stars, 1)),))
    ready = halves(question)
    worked(Stretch(question, strips(question, ready), 0, ready.block_count))  # not `searched`, which would keep an interrupt


def memory(question: Question) -> float:
    """Bytes that each worker may come to use."""
    return work.memory(halves(asked(question)))
