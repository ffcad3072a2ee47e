"""Worker processes: each keeps one task at a time, and is ended when the task takes too long.

The process that talks to browsers must not compute, or all would wait for one. A task that is still
waiting when its asker leaves is dropped; one that is under way is finished for nobody. A process
that takes too long, or is lost, is replaced when the next task comes. The limit is one of processor
time, which the system watches, so that a task is not refused because the machine is busy; by the
clock there is a far larger one.
"""

from __future__ import annotations

import asyncio
import logging
import os
import signal
import threading
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from contextlib import suppress
from functools import partial
from importlib import import_module
from multiprocessing.connection import Connection
from typing import Any

from crankstar.language.messages import language, speak
from crankstar.language.shown_units import Choice, choice, show_in
from crankstar.server.processes import PROCESSOR_TIMED, Child, messages, processor_limit
from crankstar.server.refusal import Refused, refused

GREATEST_WAITING = 500
"""Tasks that may wait for a process."""
WAITING_SECONDS = 30.0
"""How long a task may wait for a process, which may have to be started."""
STARTING_SECONDS = 60.0
"""How long a process may take to be ready."""
GREATEST_SLOWNESS = 12.0
"""How many times its processor time a task may take by the clock: it may also wait or sleep."""
READY = "ready"

Task = Callable[..., bytes]
log = logging.getLogger("crankstar.server")


class Workers:
    """Processes of this machine; the one that worked last, with the engine at hand, goes first."""

    def __init__(self, count: int, *, seconds: float) -> None:
        """`seconds` of processor time for each task."""
        self.seconds = seconds
        self.workers = [_Worker() for _ in range(count)]
        self.threads = ThreadPoolExecutor(
            count,
            thread_name_prefix="worker",
            initializer=_prepare,
            initargs=(language(), choice()),
        )
        self.idle: asyncio.LifoQueue[_Worker] = asyncio.LifoQueue()
        self.waiting = 0

    def begin(self) -> None:
        """Start the processes, without waiting; called in the loop in which tasks will be given."""
        loop = asyncio.get_running_loop()
        for worker in self.workers:
            loop.run_in_executor(self.threads, worker.ready).add_done_callback(
                partial(self._free, worker)
            )

    def end(self) -> None:
        """End the processes, whatever they are doing."""
        for worker in self.workers:
            worker.end()
        self.threads.shutdown(wait=False, cancel_futures=True)

    async def do(self, task: Task, *arguments: Any) -> bytes:
        """The result of a task. Raises Refused, also where it takes too long or too many wait."""
        if self.waiting >= GREATEST_WAITING:
            raise refused(503, "question.busy")
        self.waiting += 1
        try:
            async with asyncio.timeout(WAITING_SECONDS):
                worker = await self.idle.get()
        except TimeoutError:
            raise refused(503, "question.busy") from None
        finally:
            self.waiting -= 1
        work = asyncio.get_running_loop().run_in_executor(
            self.threads, worker.do, task, arguments, self.seconds
        )
        work.add_done_callback(partial(self._free, worker))
        try:
            return _opened(await asyncio.shield(work))
        except TimeoutError:
            raise refused(503, "question.too-long", seconds=self.seconds) from None
        except (EOFError, OSError):
            raise refused(503, "question.lost") from None

    def _free(self, worker: _Worker, work: asyncio.Future[Any]) -> None:
        if not work.cancelled():
            work.exception()  # retrieved, even if nobody waits for it any more
        self.idle.put_nowait(worker)


def _opened(answer: bytes | Refused) -> bytes:
    """The result that a worker sent. Raises the refusal that it sent."""
    if isinstance(answer, Refused):
        raise answer
    return answer


def _done(task: Task, arguments: tuple[Any, ...]) -> bytes | Refused:
    """The result of a task, or its refusal; any other failure is logged, and not shown."""
    try:
        return task(*arguments)
    except Refused as refusal:
        return refusal
    except MemoryError:
        return refused(503, "question.lost")
    except Exception:
        log.exception("a task failed")
        return refused(500, "question.failed")


def _prepare(language: str, units: Choice) -> None:
    """Have a thread speak this language and show these units."""
    speak(language)
    show_in(units)


class _Worker:
    """A process, started when there is something to do and it is not there."""

    def __init__(self) -> None:
        self.child: Child | None = None
        self.ended = False
        self.changing = threading.Lock()
        """Held while the process is started or ended, each of which another thread may do."""

    def ready(self) -> None:
        """Start the process if it is not there, and wait until it can work."""
        with self.changing:
            if self.ended or (self.child is not None and self.child.alive):
                return
            child = self.child = Child(_work)  # which another thread may drop at any moment
        with suppress(EOFError, OSError, TimeoutError):  # lost: the next task will notice
            child.receive(STARTING_SECONDS)

    def do(self, task: Task, arguments: tuple[Any, ...], seconds: float) -> bytes | Refused:
        """The process's answer; one that is lost, perhaps for earlier work, is replaced once.

        Raises TimeoutError and ends the process where it takes too long, EOFError or OSError if it
        is lost again.
        """
        try:
            return self._answer(task, arguments, seconds)
        except TimeoutError:
            raise
        except (EOFError, OSError):
            return self._answer(task, arguments, seconds)

    def _answer(self, task: Task, arguments: tuple[Any, ...], seconds: float) -> bytes | Refused:
        self.ready()
        child = self.child
        if child is None or self.ended:
            raise EOFError
        try:
            child.pipe.send((task, arguments, seconds))
            return child.receive(seconds * (GREATEST_SLOWNESS if PROCESSOR_TIMED else 1))
        except TimeoutError:
            self._drop()
            raise
        except (EOFError, OSError):
            exhausted = child.exhausted
            self._drop()
            if exhausted:
                raise TimeoutError from None
            raise

    def end(self) -> None:
        """End the process for good."""
        self.ended = True
        self._drop()

    def _drop(self) -> None:
        with self.changing:
            child, self.child = self.child, None
            if child is not None:
                child.kill()


def _work(pipe: Connection) -> None:
    """A process at work: task after task, until its parent closes the pipe."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    # a process whose stack is used up, which Python does not always restore, cannot even answer
    with suppress(EOFError, OSError, ImportError, RecursionError):
        import_module("crankstar.server.tasks")  # the first asker need not wait for it
        pipe.send(READY)
        for task, arguments, seconds in messages(pipe):
            with processor_limit(seconds):
                answer = _done(task, arguments)
            pipe.send(answer)
    os._exit(0)
