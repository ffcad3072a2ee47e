"""A search in a process of its own: it reports progress, stops when asked, ends with its parent."""

from __future__ import annotations

import os
import signal
import threading
import time
from contextlib import suppress
from multiprocessing.connection import Connection
from typing import Any, NamedTuple

from crankstar import files
from crankstar.engine.engine import Engine
from crankstar.language.messages import N_, _
from crankstar.language.numbers import duration
from crankstar.options import search as options
from crankstar.options.words import SearchWords
from crankstar.server.processes import messages
from crankstar.server.refusal import Refused, refused, said
from crankstar.server.tasks import engine_of, mistakes_refused
from crankstar.stars import engine_stars, engines, equivalence, halves
from crankstar.stars.options import Search
from crankstar.stars.progress import Progress, note

LONGEST_SECONDS = 600.0
"""A search expected to take longer on one processor is not begun."""
REPORT_SECONDS = 0.2
"""How often progress is reported."""
ROWS = 60
"""Rows of an answer that are sent."""
OTHERS = N_("`crankstar search` with -o FILE.csv has all of them")
RESUME = N_("`crankstar search` with --checkpoint FILE can be stopped and resumed")


class Progressed(NamedTuple):
    """A message of the process: how far the search has come."""

    done: int
    blocks: int
    note: str


class Failed(NamedTuple):
    """The last message of a search that failed."""

    sentence: str


class Ended(NamedTuple):
    """The last message of a search: rows of cells, each with the engine file that it makes."""

    interrupted: bool
    heads: list[str]
    rows: list[tuple[list[str], dict[str, Any]]]
    sentences: list[str]


def search_of(asked: dict[str, Any]) -> Search:
    """The search that a question asks for. Raises Refused with every fault in it."""
    engine, cylinders = asked["engine"], asked["cylinders"]
    if (engine is None) == (cylinders is None):
        raise refused(422, "question.subject")
    words = {key: asked[key] for key in SearchWords.model_fields}
    with mistakes_refused():
        about = cylinders if engine is None else engine_of(engine)[0]
        speed = about.speed if isinstance(about, Engine) else None
        return options.search_of(about, SearchWords(**words), speed=speed)


def checked(asked: dict[str, Any]) -> bytes:
    """Nothing, once the options of a search are valid. Raises Refused."""
    search_of(asked)
    return b""


def work(pipe: Connection, asked: dict[str, Any]) -> None:
    """The whole life of the process: messages of progress, then Ended or Failed."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    reporter = _Reporter(pipe)
    threading.Thread(target=reporter.listen, daemon=True).start()
    try:
        last = ended(asked, reporter)
    except Refused as refusal:
        last = Failed("; ".join(map(said, refusal.faults)))
    except Exception:  # noqa: BLE001  # the asker must hear of any failure
        last = Failed(_("The search failed because of a bug in crankstar."))
    with suppress(OSError):
        pipe.send(last)
    os._exit(0)


class _Reporter:
    """Sends messages to the parent, and stops the search when the parent asks for it."""

    def __init__(self, pipe: Connection) -> None:
        self._pipe = pipe
        self.stopping = threading.Event()
        self._latest = 0.0

    def listen(self) -> None:
        """Wait for the parent to stop the search; end the process when the parent is gone."""
        for _stop in messages(self._pipe):
            self.stopping.set()
        os._exit(1)

    def progress(self, now: Progress) -> None:
        """Report progress. Raises KeyboardInterrupt, which ends a search, once it is to stop."""
        if time.monotonic() - self._latest > REPORT_SECONDS:
            self._latest = time.monotonic()
            self._pipe.send(Progressed(now.done, now.blocks, note(now)))
        if self.stopping.is_set():
            raise KeyboardInterrupt


def ended(asked: dict[str, Any], reporter: _Reporter) -> Ended:
    """The last message. Raises Refused, also for a search that would take too long."""
    # compiled loops are loaded here, not where questions are checked
    from crankstar.stars import estimates
    from crankstar.stars.answer import answer_to

    search = search_of(asked)
    with mistakes_refused():
        halves.check(search.question)
        seconds = estimates.estimate(search.question)
        if seconds > LONGEST_SECONDS:
            raise refused(422, "question.long-search", duration=duration(seconds))
        answer = answer_to(search.question, watch=reporter.progress)
        if search.equivalence:
            answer = equivalence.equivalent(answer, search.equivalence)
    return Ended(answer.certificate.interrupted, *_shown(answer, search.engine))


def _shown(
    answer: Any, engine: Engine | None
) -> tuple[list[str], list[tuple[list[str], dict[str, Any]]], list[str]]:
    """Heads, rows with the engine files that they make, and sentences."""
    from crankstar.analysis.document import Table
    from crankstar.tables import search_stars
    from crankstar.tables.cells import cells, head

    stars, rows = answer.question.stars, answer.rows[:ROWS]
    made = [
        engines.engine(stars, row.star)
        if engine is None
        else engine_stars.with_star(engine, stars, row.star)
        for row in rows
    ]
    hints = search_stars.Hints(others=OTHERS, stopped=RESUME)
    document = search_stars.search_stars(answer, engine=engine, limit=ROWS, hints=hints)
    table = next(document.tables).readable
    sentences = [
        line for part in document.parts if not isinstance(part, Table) for line in part.lines
    ]
    heads = [head(column) for column in table.columns]
    trees = map(files.explicit, made)
    return heads, list(zip(cells(table), trees, strict=True)), [document.title, *sentences]
