"""Who does the reckoning: a few processes that are kept, each with one task at a time, and ended when it takes too long.

The process that talks to browsers must not reckon, or all would wait for one. A task that is still waiting when its asker
leaves is dropped; one that is at work is finished for nobody. A process that takes too long, or is lost, is replaced when the
next task comes.
"""

from __future__ import annotations

import asyncio
import logging
import multiprocessing
import os
import signal
import threading
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from contextlib import suppress
from functools import partial
from multiprocessing.connection import Connection
from typing import Any, Protocol

from crankstar.interrupts import held_back
from crankstar.server.refusal import Refused, refused

GREATEST_WAITING = 500
"""Tasks that may wait for a process."""
WAITING_SECONDS = 30.0
"""How long a task may wait for a process, which may have to be started."""
STARTING_SECONDS = 60.0
"""How long a process may take to be ready."""
READY = "ready"
IDLE_SECONDS = 0.3
"""When nobody asks anything for so long, a new process makes ready for figures."""
TOO_LONG = "this takes longer than {seconds:g} s and was given up; ask for less, or use the command line, which waits"
BUSY = "too much is asked at once; wait a moment and ask again"
LOST = "the process that reckoned this was lost, perhaps for want of memory; ask for less, or ask again"
FAILED = "crankstar has failed at this, which is a mistake of crankstar; what it said stands where the server was started"

Task = Callable[..., bytes]
log = logging.getLogger("crankstar.server")


class Crew(Protocol):
    """Whoever does the tasks."""

    async def do(self, task: Task, *arguments: Any) -> bytes:
        """What a task gives. Raises Refused."""
        ...

    def begin(self) -> None:
        """Gets ready, without waiting for it."""
        ...

    def end(self) -> None:
        """Ends all that was begun."""
        ...


class Alone:
    """Does every task in a thread of this process: for tests, and where one asker is all there is."""

    async def do(self, task: Task, *arguments: Any) -> bytes:
        """What a task gives. Raises Refused."""
        return _opened(await asyncio.to_thread(_done, task, arguments))

    def begin(self) -> None:
        """Nothing has to be made ready."""

    def end(self) -> None:
        """Nothing has to be ended."""


class Processes:
    """Processes of this machine; the one that worked last, and has the engine still at hand, is asked first."""

    def __init__(self, count: int, *, seconds: float) -> None:
        self.seconds = seconds
        self.workers = [_Worker() for _ in range(count)]
        self.threads = ThreadPoolExecutor(count, thread_name_prefix="crew")
        self.idle: asyncio.LifoQueue[_Worker] = asyncio.LifoQueue()
        self.waiting = 0

    def begin(self) -> None:
        """Starts the processes, without waiting for them; called in the loop in which tasks will be given."""
        loop = asyncio.get_running_loop()
        for worker in self.workers:
            loop.run_in_executor(self.threads, worker.ready).add_done_callback(partial(self._free, worker))

    def end(self) -> None:
        """Ends the processes, whatever they are doing."""
        for worker in self.workers:
            worker.end()
        self.threads.shutdown(wait=False, cancel_futures=True)

    async def do(self, task: Task, *arguments: Any) -> bytes:
        """What a task gives. Raises Refused where the task does, where it takes too long and where too many wait."""
        if self.waiting >= GREATEST_WAITING:
            raise refused(503, BUSY)
        self.waiting += 1
        try:
            async with asyncio.timeout(WAITING_SECONDS):
                worker = await self.idle.get()
        except TimeoutError:
            raise refused(503, BUSY) from None
        finally:
            self.waiting -= 1
        work = asyncio.get_running_loop().run_in_executor(self.threads, worker.do, task, arguments, self.seconds)
        work.add_done_callback(partial(self._free, worker))
        try:
            return _opened(await asyncio.shield(work))
        except TimeoutError:
            raise refused(503, TOO_LONG.format(seconds=self.seconds)) from None
        except (EOFError, OSError):
            raise refused(503, LOST) from None

    def _free(self, worker: _Worker, work: asyncio.Future[Any]) -> None:
        if not work.cancelled():
            work.exception()  # looked at, even if nobody waits for it any more
        self.idle.put_nowait(worker)


def _opened(answer: Any) -> bytes:
    """The answer of a worker. Raises what it says is to be raised."""
    if isinstance(answer, bytes):
        return answer
    raise answer


def _done(task: Task, arguments: tuple[Any, ...]) -> bytes | Refused:
    """What a task gives, or the refusal; whatever else goes wrong is logged, and told without the words of the machine."""
    try:
        return task(*arguments)
    except Refused as refusal:
        return refusal
    except MemoryError:
        return refused(503, LOST)
    except Exception:
        log.exception("a task failed")
        return refused(500, FAILED)


class _Worker:
    """A process, started when there is something to do and it is not there."""

    def __init__(self) -> None:
        self.process: Any = None
        self.way: Connection | None = None
        self.ended = False
        self.changing = threading.Lock()
        """Held by whoever starts or ends the process: it may be ended while another thread is about to start it."""

    def ready(self) -> None:
        """Starts the process if it is not there, and waits until it can work."""
        with self.changing:
            if self.ended or (self.process is not None and self.process.is_alive()):
                return
            context = multiprocessing.get_context("spawn")
            self.way, far = context.Pipe()
            self.process = context.Process(target=_work, args=(far,), daemon=True)
            with held_back():
                self.process.start()
            far.close()
        with suppress(EOFError, OSError):  # it is lost, which the next task will notice
            if self.way.poll(STARTING_SECONDS):
                self.way.recv()

    def do(self, task: Task, arguments: tuple[Any, ...], seconds: float) -> bytes | Refused:
        """What the process answers; one that is lost is replaced once, for it may be for what it did before.

        Raises TimeoutError and ends the process where it takes too long, EOFError or OSError if it is lost again.
        """
        try:
            return self._answer(task, arguments, seconds)
        except TimeoutError:
            raise
        except (EOFError, OSError):
            return self._answer(task, arguments, seconds)

    def _answer(self, task: Task, arguments: tuple[Any, ...], seconds: float) -> bytes | Refused:
        self.ready()
        if self.way is None or self.ended:
            raise EOFError
        try:
            self.way.send((task, arguments))
            if not self.way.poll(seconds):
                raise TimeoutError
            return self.way.recv()
        except (EOFError, OSError, TimeoutError):
            self._drop()
            raise

    def end(self) -> None:
        """Ends the process for good."""
        self.ended = True
        self._drop()

    def _drop(self) -> None:
        with self.changing:
            process, self.process = self.process, None
            if process is None:
                return
            with suppress(OSError):
                process.kill()
            process.join(2)


def _work(way: Connection) -> None:
    """A process at work: task after task, until its parent lets go of the other end of the way."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    # a process whose stack is used up, which Python does not always give back, cannot even say what it found
    with suppress(EOFError, OSError, ImportError, RecursionError):
        from crankstar.server import tasks  # the first asker need not wait for it

        way.send(READY)
        if not way.poll(IDLE_SECONDS):
            tasks.drawing_made_ready()
        while True:
            task, arguments = way.recv()
            way.send(_done(task, arguments))
    os._exit(0)
