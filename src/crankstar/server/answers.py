"""Answers kept for those who ask again; each question computed once, however many ask it."""

from __future__ import annotations

import asyncio
import hashlib
import json
from collections import OrderedDict
from typing import Any

from crankstar.language.messages import language, spoken
from crankstar.server.workers import Task, Workers

GREATEST_KEPT = 64_000_000
"""Bytes of answers that are kept."""


def _spoken(language: str, task: Task, *arguments: Any) -> bytes:
    """The answer of a task in a language."""
    with spoken(language):
        return task(*arguments)


class Answers:
    """What a crew has answered; the answers that were asked for longest ago are forgotten first."""

    def __init__(self, workers: Workers, *, greatest: int = GREATEST_KEPT) -> None:
        self.workers = workers
        self.greatest = greatest
        self.size = 0
        self._kept: OrderedDict[bytes, bytes] = OrderedDict()
        self._under_way: dict[bytes, tuple[asyncio.Task[bytes], list[int]]] = {}

    async def to(self, task: Task, *arguments: Any) -> bytes:
        """The answer of a task to its arguments, which are JSON, in the language of the context.

        Raises Refused.

        A question that nobody waits for any more is dropped, unless it is already at work.
        """
        asked = [language(), task.__name__, *arguments]
        key = hashlib.sha256(json.dumps(asked).encode("ascii")).digest()
        if (kept := self._kept.get(key)) is not None:
            self._kept.move_to_end(key)
            return kept
        if key not in self._under_way:
            made = asyncio.ensure_future(self.workers.do(_spoken, language(), task, *arguments))
            made.add_done_callback(lambda done: self._ended(key, done))
            self._under_way[key] = made, [0]
        work, askers = self._under_way[key]
        askers[0] += 1
        try:
            return await asyncio.shield(work)
        finally:
            askers[0] -= 1
            if askers[0] == 0 and not work.done():
                self._forget(key, work)  # who asks from now on must not get what was given up
                work.cancel()

    def _ended(self, key: bytes, work: asyncio.Task[bytes]) -> None:
        self._forget(key, work)
        if work.cancelled() or work.exception() is not None:
            return
        answer = work.result()
        self._kept[key] = answer
        self.size += len(answer)
        while self.size > self.greatest and self._kept:
            _, oldest = self._kept.popitem(last=False)
            self.size -= len(oldest)

    def _forget(self, key: bytes, work: asyncio.Task[bytes]) -> None:
        if key in self._under_way and self._under_way[key][0] is work:
            del self._under_way[key]
