"""Programs held at a point that a test names, instead of raced; how long a hang is waited for."""

from __future__ import annotations

import os
import time
from collections.abc import Callable
from pathlib import Path
from typing import IO, TypeVar

T = TypeVar("T")
PATIENCE = 600.0
"""Seconds after which what has not come never will: they end a hang, and measure no speed."""
LOOK_SECONDS = 0.02
"""How often a state is looked at that nobody reports."""


def awaited(state: Callable[[], T | None]) -> T:
    """A state as soon as it is true; a test whose state never comes fails."""
    until = time.monotonic() + PATIENCE
    while not (found := state()):
        assert time.monotonic() < until, f"it has not come in {PATIENCE:g} s"
        time.sleep(LOOK_SECONDS)
    return found


def reached(pipe: Path) -> IO[bytes]:
    """The writing end of a named pipe, once a program reads the other: it waits for what comes."""
    return os.fdopen(awaited(lambda: _opened(pipe)), "wb", buffering=0)


def _opened(pipe: Path) -> int | None:
    """The pipe, open for writing; None while nobody reads it."""
    try:
        return os.open(pipe, os.O_WRONLY | os.O_NONBLOCK)
    except OSError:
        return None
