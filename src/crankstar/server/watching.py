"""The engine file that the server was started with, watched: read again whenever it is saved.

The page asks for what is new every moment. While the file has mistakes, the last engine that had
none stays; the file may be away for a moment, as when an editor puts a new one in its place.
"""

from __future__ import annotations

import asyncio
import json
import logging
from collections.abc import Callable
from pathlib import Path
from typing import Any

from crankstar.server.refusal import Refused
from crankstar.server.tasks import Tree, mistakes_refused

EVERY = 0.3
"""Seconds between two looks at the file."""
PATIENCE = 5
"""Looks at which a file may be away before that is said."""
Signature = tuple[int, int, int] | None
log = logging.getLogger("crankstar.server")


class Watched:
    """A file: its present engine as a tree, what is wrong with it, and how often that changed.

    `read` gives the tree of the file. Raises EngineFileError where it has mistakes.
    """

    def __init__(self, path: Path, tree: Tree, read: Callable[[], Tree]) -> None:
        self.path, self.tree = path, tree
        self.problems: list[dict[str, Any]] = []
        self.version = 1
        self._read = read
        self._seen = self._signature()
        self._away = 0

    async def watch(self) -> None:
        """Look at the file until cancelled."""
        while True:
            await asyncio.sleep(EVERY)
            try:
                await self.look()
            except Exception:  # whatever is in the file, the next one that is saved is read
                log.exception("the file could not be watched")

    async def look(self) -> None:
        """Read the file again if it was saved since the last look, or has been away for long."""
        now = self._signature()
        self._away = self._away + 1 if now is None else 0
        if now == self._seen and self._away != PATIENCE:
            return
        self._seen = now
        if now is None and self._away != PATIENCE:
            return  # what comes back is new, also where its signature is that of before
        try:
            tree = await asyncio.to_thread(self._tree)
        except Refused as refusal:
            problems = json.loads(refusal.body)["problems"]
            if problems != self.problems:
                self.problems = problems
                self.version += 1
            return
        if tree != self.tree or self.problems:
            self.tree, self.problems = tree, []
            self.version += 1

    def _tree(self) -> Tree:
        with mistakes_refused():
            return self._read()

    def _signature(self) -> Signature:
        """What changes whenever the file is saved; None while it is away."""
        try:
            state = self.path.stat()
        except OSError:
            return None
        return state.st_mtime_ns, state.st_size, state.st_ino
