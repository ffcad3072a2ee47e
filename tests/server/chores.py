"""Tasks that worker processes are tried with."""

from __future__ import annotations

import os
import time
from multiprocessing.connection import Connection
from pathlib import Path
from typing import Any

from crankstar.language.messages import _
from crankstar.server.refusal import refused


def say(pipe: Connection) -> None:
    """A process that says a word of the field."""
    pipe.send(_("force"))


def number() -> bytes:
    """Which process does it."""
    return str(os.getpid()).encode()


def sleep(seconds: float) -> bytes:
    """Takes a while."""
    time.sleep(seconds)
    return b"slept"


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


def count(path: str) -> bytes:
    """Adds a line to a file, slowly."""
    time.sleep(0.3)
    with open(path, "a", encoding="utf-8") as file:  # noqa: PTH123
        file.write("once\n")
    return b"counted"


def threads() -> bytes:
    """The numbers of threads that numpy found in the environment of this process."""
    names = ("OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS")
    return " ".join(f"{name}={os.environ.get(name)}" for name in names).encode()
