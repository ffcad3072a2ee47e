"""Who does the work: this process, processes of this machine, or whatever an Executor leads to, such as a cluster."""

from __future__ import annotations

import asyncio
import multiprocessing
import os
import signal
import threading
import time
from collections.abc import Iterator
from concurrent.futures import BrokenExecutor, CancelledError, Executor, Future, ProcessPoolExecutor, ThreadPoolExecutor
from contextlib import contextmanager, suppress
from multiprocessing.connection import Connection
from multiprocessing.resource_tracker import ensure_running
from typing import Any

from crankstar.interrupts import held_back
from crankstar.search.stars import SearchError
from crankstar.search.work import Stretch, worked

SCHEDULER_SECONDS = 10.0
"""How long a scheduler may take to answer, and a cluster to have workers."""
LOOK_SECONDS = 2.0
"""How often a cluster is asked whether it is still there, and how long it may take to say so before it is asked again."""


class Hands:
    """An Executor that is given: futures out of it, and how many workers it is thought to have.

    What it was given is its owner's: it is neither mended nor shut down here.
    """

    def __init__(self, executor: Executor, *, workers: int = 8) -> None:
        self.executor = executor
        self.workers = workers

    def submit(self, stretch: Stretch) -> Future[Any]:
        """The harvest of a stretch, some day. Raises SearchError where the executor takes no more."""
        try:
            return self.executor.submit(worked, stretch)
        except BrokenExecutor as error:
            raise SearchError([f"the executor is broken and takes no more work: {error}"]) from error

    def look(self) -> None:
        """Sees whether anybody is still there, when nothing came for a while. Raises SearchError where nobody is."""

    def drop(self) -> None:
        """Ends what is under way, where that can be done here: nobody waits for it any more."""


class Processes(Hands):
    """Processes of this machine; where one of them was lost, all are started anew.

    They end by themselves when this process lets go of them, however it ends.
    """

    def __init__(self, workers: int) -> None:
        ensure_running()
        super().__init__(self._pool(workers), workers=workers)

    def _pool(self, workers: int) -> ProcessPoolExecutor:
        context = multiprocessing.get_context("spawn")
        end, self.lifeline = context.Pipe(duplex=False)
        return ProcessPoolExecutor(workers, mp_context=context, initializer=_tied, initargs=(end,))

    def submit(self, stretch: Stretch) -> Future[Any]:
        """The harvest of a stretch, some day. A pool that is broken, or was dropped, is replaced."""
        with held_back():
            try:
                return self.executor.submit(worked, stretch)
            except RuntimeError:
                self.drop()
                self.executor = self._pool(self.workers)
                return super().submit(stretch)

    def drop(self) -> None:
        """Ends the processes."""
        self.lifeline.close()
        self.executor.shutdown(wait=True, cancel_futures=True)


def _tied(end: Connection) -> None:
    """Makes a worker leave interrupts to its parent, and end as soon as the parent lets go of the other end."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    threading.Thread(target=_ended_with, args=(end,), daemon=True).start()


def _ended_with(end: Connection) -> None:
    with suppress(OSError, EOFError):
        end.recv_bytes()
    os._exit(1)


@contextmanager
def processes(workers: int | None = None) -> Iterator[Processes]:
    """Processes of this machine, as many as it has processors, for a while."""
    hands = Processes(workers or os.cpu_count() or 1)
    try:
        yield hands
    finally:
        hands.drop()


class _Cluster(Hands):
    """The workers of a dask.distributed scheduler, however many there are at a time."""

    def __init__(self, client: Any, address: str) -> None:
        super().__init__(client.get_executor(pure=False), workers=1)
        self.client, self.address = client, address
        self.seen, self.looked = time.monotonic(), -LOOK_SECONDS

    def submit(self, stretch: Stretch) -> Future[Any]:
        """The harvest of a stretch, some day. Raises SearchError where the scheduler is gone."""
        if self.client.status in ("closing", "closed"):
            raise SearchError([f"the scheduler at {self.address} is gone; a checkpoint keeps what was done"])
        return super().submit(stretch)

    def look(self) -> None:
        """Raises SearchError where the scheduler has not answered, or had no workers, for ten seconds."""
        if time.monotonic() - self.looked < LOOK_SECONDS:
            return
        if self._count():
            self.seen = time.monotonic()
        self.looked = time.monotonic()
        if self.looked - self.seen > SCHEDULER_SECONDS:
            message = f"the scheduler at {self.address} has not answered, or had no workers, for {SCHEDULER_SECONDS:.0f} s"
            raise SearchError([f"{message}; a checkpoint keeps what was done"])

    def _count(self) -> int:
        """Threads of the workers there are; 0 where nobody answers."""
        with suppress(Exception):  # of whatever kind: the scheduler does not answer
            threads = self.client.nthreads(callback_timeout=LOOK_SECONDS)
            self.workers = max(1, sum(threads.values()))
            return len(threads)
        return 0


@contextmanager
def cluster(address: str) -> Iterator[Hands]:
    """The workers of a dask.distributed scheduler, for a while.

    Raises SearchError where distributed is not installed, the address is none, or no scheduler with a worker answers in time.
    """
    try:
        from distributed import Client
    except ImportError:
        message = 'a cluster needs dask.distributed, which is not installed; install it with: pip install "crankstar[cluster]"'
        raise SearchError([message]) from None
    try:
        with ThreadPoolExecutor(1) as aside:  # a notebook has a loop of its own in this thread
            aside.submit(asyncio.run, _answer(address)).result()
        client = Client(address, timeout=SCHEDULER_SECONDS, set_as_default=False)
    except (Exception, MemoryError) as error:  # noqa: BLE001  # whatever a foreign server makes of it
        late = isinstance(error, (OSError, TimeoutError))
        why = f"within {SCHEDULER_SECONDS:.0f} s" if late else "in the language of dask"
        message = (
            f"no scheduler answers at {address} {why}; start one with: dask scheduler, and give its address, as in tcp://host:8786"
        )
        raise SearchError([message]) from None
    try:
        try:
            client.wait_for_workers(1, timeout=SCHEDULER_SECONDS)
        except TimeoutError:
            message = f"the scheduler at {address} has no workers; start one with: dask worker {address}"
            raise SearchError([message]) from None
        hands = _Cluster(client, address)
        hands.look()
        yield hands
    finally:
        with suppress(Exception):
            client.close(timeout=2)


async def _answer(address: str) -> None:
    """Waits until a scheduler has answered. A Client would wait for ever for one that takes the call and is silent."""
    from distributed import Security
    from distributed.comm.core import connect

    arguments = Security().get_connection_args("client")
    comm = await asyncio.wait_for(connect(address, timeout=SCHEDULER_SECONDS, **arguments), SCHEDULER_SECONDS)
    await comm.close()


def of_workers(fault: BaseException) -> bool:
    """Whether a fault is one of workers or of the way to them, not of the work."""
    names = {kind.__name__ for kind in type(fault).__mro__}
    known = BrokenExecutor, CancelledError, ConnectionError, TimeoutError, EOFError
    return isinstance(fault, known) or bool(names & {"KilledWorker", "CommClosedError", "FutureCancelledError", "FutureLost"})
