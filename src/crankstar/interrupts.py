"""Interrupts from the keyboard kept from what cannot bear them: processes that are started, compilers at work."""

from __future__ import annotations

import signal
import threading
from collections.abc import Callable, Iterator
from concurrent.futures import Future, wait
from contextlib import contextmanager
from multiprocessing import resource_tracker
from typing import TypeVar

T = TypeVar("T")
LOOK_SECONDS = 0.2
"""How often who waits looks whether there was an interrupt."""


@contextmanager
def held_back() -> Iterator[None]:
    """Keeps interrupts from the keyboard back for a moment: processes that are started in it never get any."""
    if not hasattr(signal, "pthread_sigmask"):
        yield
        return
    resource_tracker.ensure_running()  # the first process starts it, and it lets interrupts through again afterwards
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


def aside(work: Callable[[], T]) -> T:
    """What work gives, or raises, done in a thread beside: an interrupt ends the waiting; what was begun is left to itself.

    A compiler calls back into Python where an exception cannot be passed on, so that an interrupt in it may be lost, or leave it
    half done; interrupts come to the main thread only.
    """
    ended: Future[T] = Future()

    def run() -> None:
        try:
            ended.set_result(work())
        except BaseException as error:  # noqa: BLE001  # whatever it is, the one who waits gets it
            ended.set_exception(error)

    threading.Thread(target=run, daemon=True).start()
    while not wait([ended], timeout=LOOK_SECONDS).done:  # an interrupt that comes just before the waiting begins does not end it
        pass
    return ended.result()
