"""Who does the work: threads or processes of this machine, a cluster, or any other Executor."""

from __future__ import annotations

import multiprocessing
import os
import signal
import threading
import time
import traceback
from collections.abc import Iterable, Iterator
from concurrent.futures import (
    BrokenExecutor,
    CancelledError,
    Executor,
    Future,
    ProcessPoolExecutor,
    ThreadPoolExecutor,
)
from contextlib import contextmanager, suppress
from multiprocessing.connection import Connection
from multiprocessing.resource_tracker import ensure_running
from typing import Any, Protocol

from crankstar.stars.faults import error
from crankstar.stars.interrupts import held_back, terminated_in_order

SCHEDULER_SECONDS = 10.0
"""How long a scheduler may take to answer, and a cluster to have workers."""
LOOK_SECONDS = 2.0
"""How often a cluster is checked, and how long it may take to answer."""


class Part(Protocol):
    """A part of a search, from one of its pieces up to another: what a worker is given."""

    @property
    def start(self) -> int:
        """The first of its pieces."""
        ...

    @property
    def stop(self) -> int:
        """The one after the last."""
        ...

    def results(self) -> Any:
        """What is found in it; the same wherever and whenever it is done."""


def done(part: Part) -> Any:
    """The results of a part: what a worker does."""
    return part.results()


class Workers:
    """An Executor and its assumed number of workers; its owner replaces it and shuts it down.

    halt: what ends the work under way, where the work itself has to look for it.
    """

    halt: threading.Event | None = None

    def __init__(self, executor: Executor, *, count: int = 8) -> None:
        self.executor = executor
        self.count = count

    def submit(self, part: Part) -> Future[Any]:
        """The results of a part, later. Raises SearchError if the executor is broken."""
        try:
            return self.executor.submit(done, part)
        except BrokenExecutor as broken:
            raise error("", "executor", error=str(broken)) from broken

    def look(self) -> None:
        """Check, when nothing came for a while, that workers exist. Raises SearchError if not."""

    def drop(self, under_way: Iterable[Future[Any]]) -> None:
        """End the work under way, where possible: nobody waits for it any more."""
        for future in under_way:
            # of whatever kind an Executor has: it is gone, and so is the work
            with suppress(Exception):
                future.cancel()


class Threads(Workers):
    """Threads of this process, for compiled loops that hold no lock and come up to be halted."""

    def __init__(self, count: int) -> None:
        super().__init__(ThreadPoolExecutor(count), count=count)
        self.halt = threading.Event()

    def drop(self, under_way: Iterable[Future[Any]] = ()) -> None:
        """Halt the work under way and wait for what it has found; others can be given work."""
        super().drop(under_way)
        if self.halt:
            self.halt.set()
        self.executor.shutdown(wait=True, cancel_futures=True)
        self.executor, self.halt = ThreadPoolExecutor(self.count), threading.Event()


@contextmanager
def threads(count: int | None = None) -> Iterator[Threads]:
    """Threads of this process, as many as the machine has processors, for a while."""
    pool = Threads(count or os.cpu_count() or 1)
    try:
        yield pool
    finally:
        pool.drop()


class Processes(Workers):
    """Processes of this machine; if one is lost, all start anew; they end with this process."""

    def __init__(self, count: int) -> None:
        ensure_running()
        super().__init__(self._pool(count), count=count)

    def _pool(self, count: int) -> ProcessPoolExecutor:
        context = multiprocessing.get_context("spawn")
        end, self.lifeline = context.Pipe(duplex=False)
        return ProcessPoolExecutor(count, mp_context=context, initializer=_tied, initargs=(end,))

    def submit(self, part: Part) -> Future[Any]:
        """The results of a part, later; a broken or dropped pool is replaced."""
        with held_back():
            try:
                return self.executor.submit(done, part)
            except RuntimeError:
                self.drop()
                self.executor = self._pool(self.count)
                return super().submit(part)

    def drop(self, under_way: Iterable[Future[Any]] = ()) -> None:  # noqa: ARG002
        """End the processes; their pool alone may cancel its work.

        The thread of a pool that finds its processes gone fails at work that others cancelled.
        """
        self.lifeline.close()
        self.executor.shutdown(wait=True, cancel_futures=True)


def _tied(end: Connection) -> None:
    """Have a worker ignore interrupts, and end when the parent's end of the pipe is closed."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    threading.Thread(target=_ended_with, args=(end,), daemon=True).start()


def _ended_with(end: Connection) -> None:
    with suppress(OSError, EOFError):
        end.recv_bytes()
    os._exit(1)


@contextmanager
def processes(count: int | None = None) -> Iterator[Processes]:
    """Processes of this machine, as many as it has processors, for a while."""
    with terminated_in_order():
        pool = Processes(count or os.cpu_count() or 1)
        try:
            yield pool
        finally:
            pool.drop()


class _Cluster(Workers):
    """The workers of a dask.distributed scheduler, however many there are at a time."""

    def __init__(self, client: Any, address: str) -> None:
        super().__init__(client.get_executor(pure=False), count=1)
        self.client, self.address = client, address
        self.seen, self.looked = time.monotonic(), -LOOK_SECONDS

    def submit(self, part: Part) -> Future[Any]:
        """The results of a part, later. Raises SearchError if the scheduler is gone."""
        if self.client.status in ("closing", "closed"):
            raise error("scheduler", "scheduler-gone", address=self.address)
        return super().submit(part)

    def look(self) -> None:
        """Raises SearchError if the scheduler had no workers or did not answer for ten seconds."""
        if time.monotonic() - self.looked < LOOK_SECONDS:
            return
        if self._count():
            self.seen = time.monotonic()
        self.looked = time.monotonic()
        if self.looked - self.seen > SCHEDULER_SECONDS:
            seconds = f"{SCHEDULER_SECONDS:.0f}"
            raise error("scheduler", "scheduler-silent", address=self.address, seconds=seconds)

    def _count(self) -> int:
        """Number of worker processes; 0 where the scheduler does not answer."""
        with suppress(Exception):  # of whatever kind: the scheduler does not answer
            threads = self.client.nthreads(callback_timeout=LOOK_SECONDS)
            self.count = max(1, sum(threads.values()))
            return len(threads)
        return 0


@contextmanager
def cluster(address: str) -> Iterator[Workers]:
    """The workers of a dask.distributed scheduler, for a while.

    Raises SearchError where distributed is not installed, the address is none, or no scheduler with
    a worker answers in time.
    """
    import asyncio

    try:
        from distributed import Client
    except ImportError:
        raise error("scheduler", "no-distributed") from None
    try:
        with ThreadPoolExecutor(1) as aside:  # a notebook has a loop of its own in this thread
            aside.submit(asyncio.run, _answer(address)).result()
        client = Client(address, timeout=SCHEDULER_SECONDS, set_as_default=False)
    # whatever a foreign server makes of it
    except (Exception, MemoryError):  # noqa: BLE001
        raise error("scheduler", "no-scheduler", address=address) from None
    try:
        try:
            client.wait_for_workers(1, timeout=SCHEDULER_SECONDS)
        except TimeoutError:
            raise error("scheduler", "no-workers", address=address) from None
        workers = _Cluster(client, address)
        workers.look()
        yield workers
    finally:
        with suppress(Exception):
            client.close(timeout=2)


async def _answer(address: str) -> None:
    """Wait until a scheduler has answered; a Client would wait for ever for a silent one."""
    import asyncio

    from distributed import Security
    from distributed.comm.core import connect

    arguments = Security().get_connection_args("client")
    comm = await asyncio.wait_for(
        connect(address, timeout=SCHEDULER_SECONDS, **arguments), SCHEDULER_SECONDS
    )
    await comm.close()


def of_workers(fault: BaseException) -> bool:
    """Whether a fault is one of workers or of the way to them, not of the work.

    Dask's executor raises TypeError where a worker is lost between the end of a part and its
    answer: it takes the result for a traceback.
    """
    names = {kind.__name__ for kind in type(fault).__mro__}
    frames = [frame for frame, _line in traceback.walk_tb(fault.__traceback__)]
    if isinstance(fault, TypeError) and frames:
        return frames[-1].f_globals.get("__name__") == "distributed.cfexecutor"
    known = BrokenExecutor, CancelledError, ConnectionError, TimeoutError, EOFError
    return isinstance(fault, known) or bool(
        names & {"KilledWorker", "CommClosedError", "FutureCancelledError", "FutureLost"}
    )
