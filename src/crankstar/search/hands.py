"""Who does the work: this process, processes of this machine, or whatever an Executor leads to, such as a cluster."""

from __future__ import annotations

import multiprocessing
import os
import signal
from collections.abc import Iterator
from concurrent.futures import BrokenExecutor, CancelledError, Executor, Future, ProcessPoolExecutor
from contextlib import contextmanager, suppress
from typing import Any

from crankstar.search.stars import SearchError
from crankstar.search.work import Stretch, worked

AHEAD = 3
"""Stretches under way for each worker: none waits for the next."""
SCHEDULER_SECONDS = 10.0
"""How long a scheduler may take to answer."""


class Hands:
    """An Executor that is given: futures out of it, and how many workers it is thought to have.

    What it was given is its owner's: it is neither mended nor shut down here.
    """

    def __init__(self, executor: Executor, *, workers: int = 8) -> None:
        self.executor = executor
        self.workers = workers

    def submit(self, stretch: Stretch) -> Future[Any]:
        """The harvest of a stretch, some day."""
        return self.executor.submit(worked, stretch)

    def mend(self) -> None:
        """Makes lost workers good, where that can be done here."""


class Processes(Hands):
    """Processes of this machine, started anew when one of them is lost."""

    def __init__(self, workers: int) -> None:
        super().__init__(_pool(workers), workers=workers)

    def mend(self) -> None:
        """A broken pool is replaced."""
        self.executor.shutdown(wait=False, cancel_futures=True)
        self.executor = _pool(self.workers)


def _pool(workers: int) -> ProcessPoolExecutor:
    return ProcessPoolExecutor(workers, mp_context=multiprocessing.get_context("spawn"), initializer=_deaf)


def _deaf() -> None:
    """An interrupt from the keyboard is the parent's: it decides when its workers end."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)


@contextmanager
def processes(workers: int | None = None) -> Iterator[Processes]:
    """Processes of this machine, as many as it has processors, for a while."""
    hands = Processes(workers or os.cpu_count() or 1)
    try:
        yield hands
    finally:
        hands.executor.shutdown(wait=True, cancel_futures=True)


@contextmanager
def cluster(address: str) -> Iterator[Hands]:
    """The workers of a dask.distributed scheduler, for a while.

    Raises SearchError where distributed is not installed, the address is none, or nothing answers within ten seconds.
    """
    try:
        from distributed import Client
    except ImportError:
        message = 'a cluster needs dask.distributed, which is not installed; install it with: pip install "crankstar[cluster]"'
        raise SearchError([message]) from None
    try:
        client = Client(address, timeout=SCHEDULER_SECONDS, set_as_default=False)
    except (OSError, TimeoutError, ValueError, RuntimeError, TypeError) as error:
        reason = str(error).splitlines()[0] if str(error) else type(error).__name__
        message = f"no scheduler answers at {address} within {SCHEDULER_SECONDS:.0f} s ({reason}); start one with: dask scheduler"
        raise SearchError([message]) from None
    try:
        threads = sum(dict(client.nthreads()).values())  # pyright: ignore[reportArgumentType, reportCallIssue]
        if not threads:
            raise SearchError([f"the scheduler at {address} has no workers; start one with: dask worker {address}"])
        yield Hands(client.get_executor(pure=False), workers=threads)
    finally:
        with suppress(Exception):
            client.close(timeout=2)


def of_workers(fault: BaseException) -> bool:
    """Whether a fault is one of workers or of the way to them, not of the work."""
    names = {kind.__name__ for kind in type(fault).__mro__}
    known = BrokenExecutor, CancelledError, ConnectionError, TimeoutError, EOFError
    return isinstance(fault, known) or bool(names & {"KilledWorker", "CommClosedError", "FutureCancelledError", "FutureLost"})
