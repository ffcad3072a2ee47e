"""vl-convert, here or in a process beside this one.

It takes a third of a second to start, and holds Python while it draws. Beside it a command loads
its libraries meanwhile, and works on; where it was not begun, or has gone, it draws here.
"""

from __future__ import annotations

import json
import os
import sys
from concurrent.futures import Future, ThreadPoolExecutor
from contextlib import suppress
from subprocess import DEVNULL, PIPE, Popen
from typing import IO, Any, NamedTuple

PROGRAM = """
import json, signal, sys
signal.signal(signal.SIGINT, signal.SIG_IGN)
from vl_convert import vegalite_to_svg
vegalite_to_svg({"mark": "point", "data": {"values": []}})
for line in sys.stdin.buffer:
    drawing = vegalite_to_svg(json.loads(line)).encode()
    sys.stdout.buffer.write(b"%d\\n%b" % (len(drawing), drawing))
    sys.stdout.buffer.flush()
"""
"""Draws a figure, so that all is loaded, then that of each line of JSON: its length, the SVG."""


_begun: list[_Beside] = []


class _Beside(NamedTuple):
    """A process that draws, and the thread that waits for it."""

    process: Popen[bytes]
    into: IO[bytes]
    out: IO[bytes]
    waiting: ThreadPoolExecutor

    def draw(self, figure: dict[str, Any]) -> str:
        """The drawing of the process; where that has gone, of this one."""
        with suppress(OSError):
            self.into.write(f"{json.dumps(figure)}\n".encode())
            self.into.flush()
            if length := self.out.readline():
                return self.out.read(int(length)).decode()
        return _drawn_here(figure) if _begun else ""  # after `end` nobody waits for it


def begin() -> None:
    """Begin a process that draws what comes, until `end`; not on a lone processor."""
    if (os.cpu_count() or 1) < 2:
        return
    with suppress(OSError):
        command = [sys.executable, "-c", PROGRAM]
        process = Popen(command, stdin=PIPE, stdout=PIPE, stderr=DEVNULL)  # noqa: S603
        into, out = process.stdin, process.stdout
        if into is not None and out is not None:
            _begun.append(_Beside(process, into, out, ThreadPoolExecutor(1)))


def end() -> None:
    """End the process, whatever it does."""
    while _begun:
        beside = _begun.pop()
        beside.process.kill()
        beside.waiting.shutdown(cancel_futures=True)
        with suppress(OSError), beside.process:
            pass


def drawn(figure: dict[str, Any]) -> Future[str]:
    """The SVG of a figure in Vega-Lite, as soon as it is drawn."""
    if _begun:
        return _begun[-1].waiting.submit(_begun[-1].draw, figure)
    ready: Future[str] = Future()
    ready.set_result(_drawn_here(figure))
    return ready


def _drawn_here(figure: dict[str, Any]) -> str:
    import vl_convert

    return vl_convert.vegalite_to_svg(figure)
