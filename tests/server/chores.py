"""Tasks that worker processes are tried with."""

from __future__ import annotations

import os
import threading
from multiprocessing.connection import Connection
from pathlib import Path
from typing import Any

from crankstar.language.messages import _
from crankstar.server import search_process
from crankstar.server.refusal import refused
from crankstar.stars.progress import Progress, note


def say(pipe: Connection) -> None:
    """A process that says a word of the field."""
    pipe.send(_("force"))


def number() -> bytes:
    """Which process does it."""
    return str(os.getpid()).encode()


def other(number: int) -> bytes:
    """One of many different questions with the same answer."""
    del number
    return b"other"


def held(pipe: str) -> bytes:
    """Is held until who has opened a named pipe for writing closes it."""
    return Path(pipe).read_bytes() or b"held"


def for_ever() -> bytes:
    """Never ends."""
    threading.Event().wait()
    return b""


def computes_for_ever() -> bytes:
    """Never ends, and uses processor time."""
    while True:
        pass


def naps(seconds: float) -> bytes:
    """Uses no processor time, but takes so long by the clock."""
    threading.Event().wait(seconds)
    return b"rested"


def compile_for_ever(pipe: Connection, asked: dict[str, Any]) -> None:
    """A search that says when it compiles a loop, and never comes out of the compiler."""
    from numba.core.dispatcher import Dispatcher

    def compiling(*_: Any) -> None:
        pipe.send(search_process.Progressed(0, 1, "compiling"))
        threading.Event().wait()

    setattr(Dispatcher, "compile", compiling)  # noqa: B010 - of another signature
    search_process.work(pipe, asked)


def search_until_stopped(pipe: Connection, asked: dict[str, Any]) -> None:
    """A search that says how far it is, and goes on only once it is stopped."""

    class Held(search_process._Reporter):
        def progress(self, now: Progress) -> None:
            pipe.send(search_process.Progressed(now.done, now.blocks, note(now)))
            self.stopping.wait()
            super().progress(now)

    search_process._Reporter = Held
    search_process.work(pipe, asked)


def choke_once(path: str) -> Any:
    """Answers the first time with what cannot be sent, for it is nested too deeply."""
    answer: Any = b"breathes"
    if not Path(path).exists():
        Path(path).touch()
        for _depth in range(100_000):
            answer = [answer]
    return answer


def die() -> bytes:
    """Loses its process."""
    os._exit(3)


def fail() -> bytes:
    """Goes wrong."""
    raise RuntimeError("/home/somebody/secret.py")


def refuse() -> bytes:
    """Refuses."""
    raise refused(418, "request", sentence="this is a teapot")


def count(path: str, pipe: str = "") -> bytes:
    """Adds a line to a file, held by a pipe before if there is one."""
    if pipe:
        held(pipe)
    with open(path, "a", encoding="utf-8") as file:  # noqa: PTH123
        file.write("once\n")
    return b"counted"


def threads() -> bytes:
    """The numbers of threads that numpy found in the environment of this process."""
    names = ("OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS")
    return " ".join(f"{name}={os.environ.get(name)}" for name in names).encode()
