"""Signals kept away from code that they would break.

Processes being started, compilers at work, pools whose semaphores must be given back.
"""

from __future__ import annotations

import gc
import signal
import threading
from collections.abc import Callable, Iterator
from concurrent.futures import Future, wait
from contextlib import contextmanager
from multiprocessing import resource_tracker
from typing import TypeVar

T = TypeVar("T")
POLL_SECONDS = 0.2
"""How often a waiting thread checks for an interrupt."""


class Terminated(BaseException):
    """SIGTERM, raised so that every context manager on the stack closes what it opened."""


@contextmanager
def terminated_in_order() -> Iterator[None]:
    """Have SIGTERM close what was opened inside the context, then end the process as usual.

    A process that ends at once leaves its semaphores to the resource tracker, which complains. A
    handler of the program's own is left alone.
    """
    if not _is_default(signal.SIGTERM, signal.SIG_DFL):
        yield
        return

    def unwind(*_: object) -> None:
        raise Terminated

    signal.signal(signal.SIGTERM, unwind)
    with _unwound(lambda: signal.signal(signal.SIGTERM, signal.SIG_DFL)):
        yield


@contextmanager
def _unwound(restore: Callable[[], object]) -> Iterator[None]:
    """What SIGTERM ends inside has tidied up and given back its signals before the process ends."""
    try:
        yield
    except Terminated:
        pass
    else:
        return
    finally:
        restore()
    gc.collect()  # semaphores are given back when they are collected
    signal.raise_signal(signal.SIGTERM)


@contextmanager
def ended_once() -> Iterator[None]:
    """Have the first Ctrl-C or SIGTERM end what is inside; later ones do not break its tidying up.

    Ctrl-C raises KeyboardInterrupt; after SIGTERM the process ends as usual. Dispositions of the
    program's own are left alone. After an interrupt more of them stay ignored: the process ends.
    """
    usual = {signal.SIGINT: signal.default_int_handler, signal.SIGTERM: signal.SIG_DFL}
    before = {number: default for number, default in usual.items() if _is_default(number, default)}

    def end(number: int, _frame: object) -> None:
        for each in before:
            signal.signal(each, signal.SIG_IGN)
        raise Terminated if number == signal.SIGTERM else KeyboardInterrupt

    def restore() -> None:
        for number, handler in before.items():
            if number == signal.SIGTERM or signal.getsignal(number) is end:
                signal.signal(number, handler)

    for number in before:
        signal.signal(number, end)
    with _unwound(restore):
        yield


@contextmanager
def signals_noted() -> Iterator[threading.Event]:
    """An event that is set when the process is to stop, by Ctrl-C or SIGTERM.

    No exception breaks into an executor at work. A second Ctrl-C raises KeyboardInterrupt; SIGTERM
    is passed on when the context ends. A disposition that the program has chosen, to ignore
    interrupts or to handle them itself, is kept; so is everything outside the main thread.
    """
    stop, terminated = threading.Event(), threading.Event()

    def interrupt(*_: object) -> None:
        if stop.is_set():
            raise KeyboardInterrupt
        stop.set()

    def terminate(*_: object) -> None:
        terminated.set()
        stop.set()

    before: dict[int, object] = {}
    if _is_default(signal.SIGINT, signal.default_int_handler):
        before[signal.SIGINT] = signal.signal(signal.SIGINT, interrupt)
    if _is_main() and signal.getsignal(signal.SIGTERM) is not signal.SIG_IGN:
        before[signal.SIGTERM] = signal.signal(signal.SIGTERM, terminate)
    try:
        yield stop
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)  # pyright: ignore[reportArgumentType]
        if terminated.is_set():
            signal.raise_signal(signal.SIGTERM)


def _is_main() -> bool:
    return threading.current_thread() is threading.main_thread()


def _is_default(number: int, default: object) -> bool:
    return _is_main() and signal.getsignal(number) is default


@contextmanager
def held_back() -> Iterator[None]:
    """Block interrupts for a moment: processes started in it never receive any."""
    if not hasattr(signal, "pthread_sigmask"):
        yield
        return
    # the first process starts the tracker, which unblocks interrupts afterwards
    resource_tracker.ensure_running()
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


def aside(work: Callable[[], T]) -> T:
    """The result of work done in a thread; an interrupt ends only the waiting for it.

    A compiler calls back into Python where no exception can pass, so that an interrupt would be
    lost or leave it half done. Interrupts reach the main thread only. Raises what work raises.
    """
    ended: Future[T] = Future()

    def run() -> None:
        try:
            ended.set_result(work())
        except BaseException as error:  # noqa: BLE001  # passed on to the waiting thread
            ended.set_exception(error)

    threading.Thread(target=run, daemon=True).start()
    # an interrupt just before the waiting begins does not end it
    while not wait([ended], timeout=POLL_SECONDS).done:
        pass
    return ended.result()
