"""Parts of a search handed out to workers, those of lost workers once more."""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterator
from concurrent.futures import FIRST_COMPLETED, CancelledError, Future, wait
from dataclasses import dataclass
from typing import Any

from crankstar.stars.checkpoint import Span
from crankstar.stars.executors import Part, Workers, of_workers
from crankstar.stars.faults import error

AHEAD = 3
"""Parts under way for each worker: none waits for the next."""
RETRIES = 3
"""How often a part is given out again when its worker was lost."""
WAIT_SECONDS = 0.5
"""How long to wait for a part before interrupts and the cluster are checked."""


@dataclass(frozen=True)
class Handout:
    """What is handed out, and what becomes of it.

    part: the part of a span; take: receives its results; waiting: called when nothing came for a
    while.
    """

    part: Callable[[Span], Part]
    take: Callable[[Span, Any], None]
    waiting: Callable[[], None]

    def done(self, todo: Iterator[Span], workers: Workers, stop: threading.Event) -> bool:
        """Whether all spans were done, or `stop` was set before.

        Then parts that had ended by that time, or were halted, are taken as well. Raises what the
        work raised, and SearchError where workers are lost again and again.
        """
        again: list[Span] = []
        lost: dict[Span, int] = {}
        under_way: dict[Future[Any], Span] = {}
        over = False
        try:
            while not stop.is_set():
                while len(under_way) < AHEAD * workers.count and (
                    span := again.pop() if again else next(todo, None)
                ):
                    under_way[workers.submit(self.part(span))] = span
                if not under_way:
                    over = True
                    return True
                ended, _ = wait(under_way, timeout=WAIT_SECONDS, return_when=FIRST_COMPLETED)
                again += self._received({future: under_way.pop(future) for future in ended}, lost)
                if not ended and not stop.is_set():
                    workers.look()
                    self.waiting()
        finally:
            if not over:
                workers.drop(under_way)
        for future, span in under_way.items():
            if future.done() and _fault(future) is None:
                self.take(span, future.result())
        return False

    def _received(self, ended: dict[Future[Any], Span], lost: dict[Span, int]) -> list[Span]:
        """Spans lost with their workers. Raises what the work raised."""
        faults: dict[Span, BaseException] = {}
        for future, span in ended.items():
            fault = _fault(future)
            if fault is None:
                self.take(span, future.result())
            else:
                faults[span] = fault
        for span, fault in faults.items():
            lost[span] = lost.get(span, 0) + 1
            _bear(fault, lost[span])
        return list(faults)


def _fault(future: Future[Any]) -> BaseException | None:
    """What went wrong with a part, cancellation by a cluster included."""
    try:
        return future.exception()
    except CancelledError as error:
        return error


def _bear(fault: BaseException, times: int) -> None:
    """Raise a fault of the work as it is, and the loss of workers where it has gone on too long."""
    if isinstance(fault, ImportError):
        raise error("", "worker-import", error=str(fault)) from fault
    if not of_workers(fault):
        raise fault
    if times > RETRIES:
        raise error("", "worker-lost", times=times, error=type(fault).__name__)
