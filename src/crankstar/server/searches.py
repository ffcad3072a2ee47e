"""Searches under way and those that ended not long ago: their progress, what they found, how they are stopped."""

from __future__ import annotations

import multiprocessing
import secrets
import threading
import time
from contextlib import suppress
from multiprocessing.connection import Connection
from typing import Any, Literal

from crankstar.interrupts import held_back
from crankstar.server import search_process
from crankstar.server.refusal import refused
from crankstar.server.tasks import answered

GREATEST_RUNNING = 2
"""Searches at the same time."""
KEPT_SECONDS = 900.0
GREATEST_KEPT = 50
"""How long, and how many, searches that ended are kept."""
STOPPED_SECONDS = 3 * search_process.LONGEST_SECONDS
"""A search that takes so much longer than was thought is stopped."""
CROWDED = "{count} searches are under way already, which is as many as may be; wait until one has ended, or stop it"
GONE = "there is no such search; what was found is kept for a quarter of an hour"
LOST = "the process that searched was lost, perhaps for want of memory; narrow the search"

State = Literal["running", "done", "cancelled", "failed"]


class Searches:
    """All searches of a server."""

    def __init__(self) -> None:
        self._searches: dict[str, _Search] = {}

    def begun(self, asked: dict[str, Any]) -> bytes:
        """Begins a search; what is to be said of it. Raises Refused with 429 where too many are under way."""
        self._clear()
        running = sum(search.state == "running" for search in self._searches.values())
        if running >= GREATEST_RUNNING:
            raise refused(429, CROWDED.format(count=running))
        search = _Search(asked)
        self._searches[search.identity] = search
        return search.shown()

    def shown(self, identity: str) -> bytes:
        """How far a search is. Raises Refused with 404."""
        return self._of(identity).shown()

    def stopped(self, identity: str) -> bytes:
        """Stops a search, without waiting for it. Raises Refused with 404."""
        search = self._of(identity)
        search.stop()
        return search.shown()

    def end(self) -> None:
        """Ends all of them."""
        for search in self._searches.values():
            search.end()

    def _of(self, identity: str) -> _Search:
        self._clear()
        if identity not in self._searches:
            raise refused(404, GONE)
        return self._searches[identity]

    def _clear(self) -> None:
        """Forgets those that ended long ago, and the oldest of too many."""
        now = time.monotonic()
        ended = [search for search in self._searches.values() if search.ended is not None]
        old = [search for search in ended if now - (search.ended or now) > KEPT_SECONDS]
        for search in old or ended[: max(len(ended) - GREATEST_KEPT, 0)]:
            del self._searches[search.identity]


class _Search:
    """A search: its process, and what the process said last."""

    def __init__(self, asked: dict[str, Any]) -> None:
        self.identity = secrets.token_urlsafe(12)
        self.state: State = "running"
        self.done = self.blocks = 0
        self.note = "getting ready (the first time loops are compiled, about ten seconds)"
        self.heads: list[str] = []
        self.rows: list[tuple[list[str], dict[str, Any]]] = []
        self.sentences: list[str] = []
        self.ended: float | None = None
        self._stopping = False
        context = multiprocessing.get_context("spawn")
        self._way, far = context.Pipe()
        self._process = context.Process(target=search_process.work, args=(far, asked), daemon=True)
        with held_back():
            self._process.start()
        far.close()
        threading.Thread(target=self._listen, args=(self._way,), daemon=True).start()

    def shown(self) -> bytes:
        """The search as JSON."""
        rows = [{"cells": cells, "tree": tree} for cells, tree in self.rows]
        told = {name: getattr(self, name) for name in ("state", "done", "blocks", "note", "heads", "sentences")}
        return answered({"id": self.identity, **told, "rows": rows})

    def stop(self) -> None:
        """Has the search end soon, with the best so far."""
        if self.state == "running" and not self._stopping:
            self._stopping = True
            self.note = "stopping"
            with suppress(OSError):
                self._way.send("stop")

    def end(self) -> None:
        """Ends the process whatever it is doing."""
        if self._process.is_alive():
            self._process.kill()
            self._process.join(2)

    def _listen(self, way: Connection) -> None:
        """Takes what the process says, to its end."""
        latest = time.monotonic() + STOPPED_SECONDS
        try:
            while self.state == "running":
                if way.poll(5.0):
                    self._take(*way.recv())
                if time.monotonic() > latest:
                    self.stop()
        except (EOFError, OSError):
            self._close("failed", LOST)
        self._process.join(5)
        way.close()

    def _take(self, kind: str, *told: Any) -> None:
        if kind == "progress":
            self.done, self.blocks, note = told
            self.note = self.note if self._stopping else note
        elif kind == "failed":
            self._close("failed", told[0])
        else:
            interrupted, self.heads, self.rows, self.sentences = told
            self.done = self.done if interrupted else self.blocks
            self._close("cancelled" if interrupted else "done", "")

    def _close(self, state: State, note: str) -> None:
        self.note = note
        self.ended = time.monotonic()
        self.state = state
