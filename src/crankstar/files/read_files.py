"""The files that a command has read, so that it overwrites none of them.

An engine file names others (`gas.trace`), and lists, readings and coefficients are read by options:
whatever was opened while a command runs is known here, by device and number, not by its name.
"""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from pathlib import Path
from typing import IO

STANDARD_INPUT = "/dev/stdin"
"""What `-` stands for where a file is read."""
Identity = tuple[int, int]
_read: ContextVar[set[Identity] | None] = ContextVar("files that were read", default=None)


@contextmanager
def files_noted() -> Iterator[None]:
    """Know what is read inside the context."""
    token = _read.set(set())
    try:
        yield
    finally:
        _read.reset(token)


def note(opened: IO[bytes]) -> None:
    """Know that an open file is read, if anybody wants to know."""
    known = _read.get()
    if known is not None:
        state = os.fstat(opened.fileno())
        known.add((state.st_dev, state.st_ino))


def was_read(path: str | os.PathLike[str]) -> bool:
    """Whether the file of this name was read in the context; raises OSError without such a file."""
    state = Path(path).stat()
    return (state.st_dev, state.st_ino) in (_read.get() or ())
