"""A search kept in a file, stretch by stretch, so that it can go on after it was stopped.

Lines of JSON: first what search it is, then one line for each stretch that is done, with the strips in which it was searched and a
checksum. A line that broke off (the machine went down while it was written) or that is damaged is passed over: its stretch is done
again. So is one that overlaps an earlier one: no block is ever counted twice, even if two processes write to the file at once.
"""

from __future__ import annotations

import json
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any
from zlib import crc32

from crankstar.search import harvest
from crankstar.search.harvest import Harvest
from crankstar.search.question import Question
from crankstar.search.stars import SearchError
from crankstar.search.strips import Strips

FORMAT = 1
TOGETHER = 64
"""Stretches that are read before they are gathered."""

Span = tuple[int, int]
"""Blocks from the first up to the second."""


@dataclass(frozen=True)
class Checkpoint:
    """The file of a search."""

    path: Path
    question: Question

    def add(self, attempt: int, tried: Strips, span: Span, found: Harvest) -> None:
        """Writes a stretch that is done. Raises SearchError where the file cannot be written."""
        body = {"attempt": attempt, "strips": _shape(tried), "blocks": list(span), **harvest.as_json(found)}
        _append(self.path, _text({"done": body, "sum": crc32(_text(body))}) + b"\n")

    def kept(self, attempt: int, tried: Strips, asked: Question, blocks: int) -> tuple[list[Span], Harvest]:
        """Stretches of an attempt that are done, none over another, and what they brought in.

        asked: what the blocks were asked; blocks: how many there are. Raises SearchError where the file cannot be read or the
        attempt looked into other strips.
        """
        spans: list[Span] = []
        found = harvest.nothing(len(asked.objectives), len(asked.stars.places))
        waiting: list[Harvest] = []
        for body in _bodies(self.path):
            if body["attempt"] != attempt:
                continue
            if body["strips"] != _shape(tried):
                message = "was written by another version of crankstar, which looked elsewhere; name another file"
                raise SearchError([f"the checkpoint {self.path} {message}"])
            start, stop = body["blocks"]
            if not 0 <= start < stop <= blocks or any(start < other_stop and other < stop for other, other_stop in spans):
                continue
            spans.append((start, stop))
            waiting.append(harvest.from_json(body, len(asked.objectives), len(asked.stars.places)))
            if len(waiting) == TOGETHER:
                found, waiting = harvest.gathered([found, *waiting], asked.ask), []
        return sorted(spans), harvest.gathered([found, *waiting], asked.ask)


def opened(path: Path, question: Question) -> Checkpoint:
    """The checkpoint of a search: made if there is none, else looked into.

    Raises SearchError if it is of another search, is none, or can be neither read nor written.
    """
    header = _text({"crankstar_search": FORMAT, "digest": question.digest}) + b"\n"
    with _told(path, "read"):
        if path.exists() and not path.is_file():
            raise SearchError([f"the checkpoint {path} is no file; name one, or one that does not exist yet"])
        written = path.read_bytes() if path.exists() else b""
    first, _, _ = written.partition(b"\n")
    if header.startswith(written):
        _append(path, header[len(written) :])
        return Checkpoint(path, question)
    tree = _tree(first)
    if tree.get("crankstar_search") != FORMAT:
        raise SearchError([f"{path} is no checkpoint of a search; name a file that does not exist yet, or one of this search"])
    if tree.get("digest") != question.digest:
        message = "is the checkpoint of another search; name another file, or ask what was asked then"
        raise SearchError([f"{path} {message}"])
    # what broke off becomes a line of its own
    _append(path, b"" if written.endswith(b"\n") else b"\n")
    return Checkpoint(path, question)


def left(blocks: int, done: list[Span], size: int) -> Iterator[Span]:
    """Stretches of at most `size` blocks that are still to do. `done` is sorted."""
    at = 0
    for start, stop in [*done, (blocks, blocks)]:
        while at < start:
            yield at, min(at + size, start)
            at = min(at + size, start)
        at = stop


INSTEAD = {
    "read": "name a file that you may read, or one that does not exist yet",
    "written": "name a file in a place where you may write and where there is room",
}


@contextmanager
def _told(path: Path, verb: str) -> Iterator[None]:
    """Tells an error of the file as a sentence."""
    try:
        yield
    except OSError as error:
        raise SearchError([f"the checkpoint {path} cannot be {verb} ({error.strerror or error}); {INSTEAD[verb]}"]) from None


def _append(path: Path, line: bytes) -> None:
    """Writes bytes at the end, at once: so lines of two processes do not mix."""
    with _told(path, "written"), path.open("ab", buffering=0) as file:
        if file.write(line) != len(line):
            raise OSError("the disk is full")


def _text(tree: dict[str, Any]) -> bytes:
    return json.dumps(tree, separators=(",", ":")).encode("ascii")


def _shape(tried: Strips) -> list[Any]:
    """What two attempts must have in common for their stretches to be parts of one."""
    return [tried.whole, *([place, radius] for place, radius in tried.radii)]


def _bodies(path: Path) -> Iterator[dict[str, Any]]:
    """The stretches of a file that are as they were written."""
    with _told(path, "read"), path.open("rb") as file:
        file.readline()
        for line in file:
            tree = _tree(line)
            body = tree.get("done")
            if isinstance(body, dict) and tree.get("sum") == crc32(_text(body)):
                yield body


def _tree(line: bytes) -> dict[str, Any]:
    """A line as a tree; an empty one where it is none."""
    try:
        tree = json.loads(line)
    except (ValueError, RecursionError):
        return {}
    return tree if isinstance(tree, dict) else {}
