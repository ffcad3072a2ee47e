"""A process of the server: spawned, spoken to over a pipe, gone when its parent is.

pebble's pool is not used: it shares named semaphores, of which the resource tracker complains when
a server is killed, and hands a task to any process, not to the one that has the engine at hand.
"""

from __future__ import annotations

import multiprocessing
import os
import signal
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from multiprocessing.connection import Connection
from typing import Any

from crankstar.language.messages import language, speak
from crankstar.language.shown_units import Choice, choice, show_in
from crankstar.stars.interrupts import held_back

END_SECONDS = 2.0
"""How long a killed process may take to disappear."""
ONE_THREAD = ("OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS", "VECLIB_MAXIMUM_THREADS")
"""Variables that limit the threads of numpy's linear algebra; it reads them when it is loaded."""
PROCESSOR_TIMED = hasattr(signal, "setitimer")
"""Whether the system ends a process whose processor time is used up: not on Windows."""
_starting = threading.Lock()
"""Held while the environment is that of a process to be started."""


class Child:
    """A process and the pipe to it, in the language and the units of its maker.

    It ends itself when it reads the end of the pipe.
    """

    def __init__(self, target: Callable[..., None], *arguments: Any) -> None:
        context = multiprocessing.get_context("spawn")
        self.pipe, far = context.Pipe()
        self._process = context.Process(
            target=_begun, args=(language(), dict(choice()), target, far, *arguments), daemon=True
        )
        with held_back(), _one_thread():
            self._process.start()
        far.close()

    @property
    def alive(self) -> bool:
        """Whether the process runs."""
        return self._process.is_alive()

    @property
    def exhausted(self) -> bool:
        """Whether the system has ended the process because its processor time was used up."""
        self._process.join(END_SECONDS)
        return PROCESSOR_TIMED and self._process.exitcode == -signal.SIGPROF

    def receive(self, seconds: float) -> Any:
        """The next message. Raises TimeoutError, and EOFError or OSError if the process is lost."""
        if not self.pipe.poll(seconds):
            raise TimeoutError
        return self.pipe.recv()

    def kill(self, *, wait: bool = True) -> None:
        """End the process whatever it is doing."""
        with suppress(OSError):
            self._process.kill()
        if wait:
            self._process.join(END_SECONDS)


@contextmanager
def _one_thread() -> Iterator[None]:
    """Have a process started inside multiply its small matrices in one thread.

    As many processes as there are cores, with as many threads each, wait for one another.
    """
    with _starting:
        missing = [name for name in ONE_THREAD if name not in os.environ]
        os.environ.update(dict.fromkeys(missing, "1"))
        try:
            yield
        finally:
            for name in missing:
                os.environ.pop(name, None)


@contextmanager
def processor_limit(seconds: float) -> Iterator[None]:
    """Have the system end this process if what stands inside takes more processor time.

    A machine that is busy with other work takes nothing away from it. Without effect on Windows.
    """
    if not PROCESSOR_TIMED:
        yield
        return
    signal.setitimer(signal.ITIMER_PROF, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0)


def _begun(language: str, units: Choice, target: Callable[..., None], *arguments: Any) -> None:
    speak(language)
    show_in(units)
    target(*arguments)


def messages(pipe: Connection) -> Any:
    """Messages of the parent, until it closes its end."""
    with suppress(EOFError, OSError):
        while True:
            yield pipe.recv()
