"""A search in a process of its own: it says how far it is, stops when it is told to, and ends with its parent."""

from __future__ import annotations

import os
import re
import threading
import time
from contextlib import suppress
from multiprocessing.connection import Connection
from typing import TYPE_CHECKING, Any, NoReturn

from crankstar import files
from crankstar.engine import Engine
from crankstar.request import RequestError
from crankstar.server.refusal import Refused, Told, refused
from crankstar.server.tasks import engine_of, mistakes_told
from crankstar.wording import duration

if TYPE_CHECKING:
    from crankstar.search import run

LONGEST_SECONDS = 600.0
"""A search that is thought to take longer on one processor is not begun."""
TELLING_SECONDS = 0.2
"""How often progress is told."""
ROWS = 60
"""Rows of an answer that are sent."""
OTHERS = "`crankstar search` with -o FILE.csv has all of them"
GO_ON = "`crankstar search` with --checkpoint FILE can be stopped and go on"
STOPPED: tuple[Any, ...] = ("done", True, [], [], ["Stopped before anything was found."])
NARROWER = "fix throws, take symmetric cranks, let a sum vanish; or use `crankstar search`, which waits as long as you like"


def requested(asked: dict[str, Any]) -> Any:
    """What the words of a question ask for, as a search_request.Request. Raises Refused with every mistake in them."""
    from crankstar import search_request

    engine, cylinders = asked["engine"], asked["cylinders"]
    if (engine is None) == (cylinders is None):
        raise refused(422, "give an engine, or a number of cylinders")
    words = {name: asked[name] for name in ("minimise", "zero", "pitch", "fix", "mode_shape", "all_with")}
    switches = {name: asked[name] for name in ("symmetric", "avoid_adjacent", "front")}
    best = None if asked["best"] is None else str(asked["best"])
    wish = search_request.Wish(limit=tuple(asked["limit"]), best=best, **words, **switches)
    with mistakes_told():
        about = cylinders if engine is None else engine_of(engine)[0]
    speed = about.speed if isinstance(about, Engine) else None
    try:
        return search_request.request(about, asked["cycle"], wish, speed=speed)
    except RequestError as error:
        raise Refused(422, map(by_key, str(error).split("\n"))) from None


def by_key(mistake: str) -> Told:
    """A mistake in the words of the command line, at the key of a question that means its option, and naming keys."""
    option = re.match(r"--([a-z-]+)(?:: | (?!and ))", mistake)
    path = option[1].replace("-", "_") if option else ""
    message = mistake[option.end() :] if option else mistake
    return path, re.sub(r'"[^"]*"|--([a-z][a-z-]*)', _named, message)


def _named(found: re.Match[str]) -> str:
    """An option as the key that means it; what is quoted was said by the one who asks."""
    return f"`{found[1].replace('-', '_')}`" if found[1] else found[0]


def checked(asked: dict[str, Any]) -> bytes:
    """Nothing, once the words of a search are found to ask for something. Raises Refused."""
    requested(asked)
    return b""


def work(way: Connection, asked: dict[str, Any]) -> None:
    """The whole life of the process: it tells ("progress", ...), and in the end ("done", ...) or ("failed", sentence)."""
    told = _Told(way)
    threading.Thread(target=_listen, args=(way, told), daemon=True).start()
    try:
        answer = found(told, asked)
    except Exception as error:  # noqa: BLE001  # whatever it is, the one who asked is told
        answer = ("failed", _sentence(error))
    told.last(answer)


class _Told:
    """What is told to the parent, by the search and by who listens to the parent; nothing after the end."""

    def __init__(self, way: Connection) -> None:
        self._way, self._one_by_one = way, threading.Lock()
        self.stopping = threading.Event()
        self.any_done = False
        self._latest = 0.0

    def progress(self, now: run.Progress, note: str) -> None:
        """How far the search is. Raises KeyboardInterrupt, which has the search end with the best so far, once it is to stop."""
        self.any_done = now.done > 0
        if time.monotonic() - self._latest > TELLING_SECONDS:
            self._latest = time.monotonic()
            with self._one_by_one:
                self._way.send(("progress", now.done, now.blocks, note))
        if self.stopping.is_set():
            raise KeyboardInterrupt

    def last(self, answer: tuple[Any, ...]) -> NoReturn:
        """The last word, with which the process ends."""
        with self._one_by_one:
            with suppress(OSError):
                self._way.send(answer)
            os._exit(0)


def _sentence(error: Exception) -> str:
    from crankstar.search.stars import SearchError

    if isinstance(error, Refused):
        return "; ".join(message for _, message in error.problems)
    known = isinstance(error, (RequestError, SearchError))
    return str(error) if known else "crankstar has failed at this search, which is a mistake of crankstar"


def _listen(way: Connection, told: _Told) -> None:
    """Stops the search when the parent says so, and ends the process when the parent is gone.

    A search with nothing done yet ends at once: it may be compiling its loops, in the middle of which an exception can be lost.
    """
    try:
        while way.recv() == "stop":
            told.stopping.set()
            if not told.any_done:
                told.last(STOPPED)
    except (EOFError, OSError):
        os._exit(1)


def found(told: _Told, asked: dict[str, Any]) -> tuple[Any, ...]:
    """What the process tells in the end. Raises Refused for what would take too long, SearchError for what cannot be searched."""
    from crankstar.search import halves, run
    from crankstar.search.findings import findings
    from crankstar.search_job import note

    wanted = requested(asked)
    halves.check(wanted.question)
    seconds = run.estimate(wanted.question)
    if seconds > LONGEST_SECONDS:
        why = f"this search takes about {duration(seconds)} on one processor, too long for a page"
        raise refused(422, f"{why}. To narrow it: {NARROWER}")
    answer = findings(wanted.question, watch=lambda now: told.progress(now, note(now)))
    return ("done", answer.certificate.interrupted, *_told(answer, wanted))


def _told(answer: Any, wanted: Any) -> tuple[list[str], list[tuple[list[str], dict[str, Any]]], list[str]]:
    """Heads, rows with the engine files that they make, and sentences."""
    from crankstar import search_table
    from crankstar.search import engines, likeness, weighed

    answer = likeness.chosen(answer, wanted.likeness) if wanted.likeness else answer
    shown = answer.rows[:ROWS]
    heads, cells = search_table.cells(answer, shown)
    made = [
        engines.engine(answer.question.stars, row.star)
        if wanted.engine is None
        else weighed.with_star(wanted.engine, answer.question.stars, row.star)
        for row in shown
    ]
    trees = [files.explicit(engine) for engine in made]
    hints = search_table.Hints(others=OTHERS, stopped=GO_ON)
    words = [search_table.heading(answer.question), search_table.census(answer.question.stars)]
    words += [*search_table.as_it_is(answer, wanted.engine), *search_table.sentences(answer, shown=len(shown), hints=hints)]
    return heads, list(zip(cells, trees, strict=True)), words
