"""Searches under way and those that ended recently: progress, answers, how they are stopped."""

from __future__ import annotations

import secrets
import threading
import time
from contextlib import suppress
from contextvars import copy_context
from typing import Any, Literal

from crankstar.language.messages import N_, _
from crankstar.server import search_process
from crankstar.server.processes import Child
from crankstar.server.refusal import refused
from crankstar.server.search_process import Ended, Failed, Progressed
from crankstar.server.tasks import answered

GREATEST_RUNNING = 2
"""Searches at the same time."""
KEPT_SECONDS = 900.0
GREATEST_KEPT = 50
"""How long, and how many, searches that ended are kept."""
STOPPED_SECONDS = 3 * search_process.LONGEST_SECONDS
"""A search that takes so much longer than expected is stopped."""
LOST = N_("The process that searched was lost, perhaps for lack of memory. Narrow the search.")
STARTING = N_("getting ready (the first search is compiled for about ten seconds)")

POLL_SECONDS = 5.0
"""How often a search that is silent is checked for its time."""

State = Literal["running", "done", "cancelled", "failed"]


class Searches:
    """All searches of a server."""

    def __init__(self) -> None:
        self._searches: dict[str, _Search] = {}

    def begun(self, asked: dict[str, Any]) -> bytes:
        """A search that is begun, as JSON. Raises Refused with 429 where too many are running."""
        self._clear()
        running = sum(search.state == "running" for search in self._searches.values())
        if running >= GREATEST_RUNNING:
            raise refused(429, "question.crowded", count=running)
        search = _Search(asked)
        self._searches[search.identity] = search
        return search.shown()

    def shown(self, identity: str) -> bytes:
        """How far a search is, as JSON. Raises Refused with 404."""
        return self._of(identity).shown()

    def stopped(self, identity: str) -> bytes:
        """A search that is being stopped, as JSON. Raises Refused with 404."""
        search = self._of(identity)
        search.stop()
        return search.shown()

    def end(self) -> None:
        """End all of them."""
        for search in self._searches.values():
            search.end()

    def _of(self, identity: str) -> _Search:
        self._clear()
        if identity not in self._searches:
            raise refused(404, "question.no-search")
        return self._searches[identity]

    def _clear(self) -> None:
        """Forget those that ended long ago, and the oldest of too many."""
        now = time.monotonic()
        ended = [search for search in self._searches.values() if search.ended is not None]
        old = [search for search in ended if now - (search.ended or now) > KEPT_SECONDS]
        for search in old or ended[: max(len(ended) - GREATEST_KEPT, 0)]:
            del self._searches[search.identity]


class _Search:
    """A search: its process, and the latest message of it."""

    def __init__(self, asked: dict[str, Any]) -> None:
        self.identity = secrets.token_urlsafe(12)
        self.state: State = "running"
        self.done = self.blocks = 0
        self.note = _(STARTING)
        self.answer = Ended(False, [], [], [])
        self.ended: float | None = None
        self._stopping = False
        self._child = Child(search_process.work, asked)
        threading.Thread(target=copy_context().run, args=(self._listen,), daemon=True).start()

    def shown(self) -> bytes:
        """The search as JSON."""
        return answered(
            {
                "id": self.identity,
                "state": self.state,
                "done": self.done,
                "blocks": self.blocks,
                "note": self.note,
                "heads": self.answer.heads,
                "rows": [{"cells": cells, "tree": tree} for cells, tree in self.answer.rows],
                "sentences": self.answer.sentences,
            }
        )

    def stop(self) -> None:
        """Make the search end soon with the best so far, at once if nothing is done yet.

        While loops compile an exception can be lost.
        """
        if self.state != "running" or self._stopping:
            return
        self._stopping = True
        if not self.done:
            self.answer = Ended(True, [], [], [_("Stopped before anything was found.")])
            self._close("cancelled", "")
            self._child.kill(wait=False)
            return
        self.note = _("stopping")
        with suppress(OSError):
            self._child.pipe.send("stop")

    def end(self) -> None:
        """End the process whatever it is doing."""
        if self._child.alive:
            self._child.kill()

    def _listen(self) -> None:
        """Take the messages of the process, to its end."""
        latest = time.monotonic() + STOPPED_SECONDS
        try:
            while self.state == "running":
                with suppress(TimeoutError):
                    self._take(self._child.receive(POLL_SECONDS))
                if time.monotonic() > latest:
                    self.stop()
        except (EOFError, OSError):
            if self.state == "running":
                self._close("failed", _(LOST))
        self._child.kill()
        self._child.pipe.close()

    def _take(self, message: Progressed | Ended | Failed) -> None:
        if self.state != "running":
            return
        if isinstance(message, Progressed):
            self.done, self.blocks = message.done, message.blocks
            self.note = self.note if self._stopping else message.note
        elif isinstance(message, Failed):
            self._close("failed", message.sentence)
        else:
            self.answer = message
            self.done = self.done if message.interrupted else self.blocks
            self._close("cancelled" if message.interrupted else "done", "")

    def _close(self, state: State, note: str) -> None:
        self.note = note
        self.ended = time.monotonic()
        self.state = state
