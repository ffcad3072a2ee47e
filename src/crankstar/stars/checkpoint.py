"""A search kept in a file, one block range at a time, so that it can be resumed after a stop.

Lines of JSON: first which search it is, then a line for each block range that is done, with the
regions in which it was searched and a checksum. A line that broke off (the machine went down while
it was written) or is damaged is skipped and counted: its range is done again. So is one that
overlaps an earlier one: no block is counted twice, even if two processes write to the file at once.
SQLite would be shorter, but cannot read what is left of a truncated file, and its locks fail on
network disks.
"""

from __future__ import annotations

import json
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Protocol
from zlib import crc32

from crankstar.stars import results
from crankstar.stars.faults import error
from crankstar.stars.question import Question
from crankstar.stars.regions import Regions
from crankstar.stars.results import Results

FORMAT = 1
TOGETHER = 64
"""Block ranges that are read before they are merged."""

Span = tuple[int, int]
"""Blocks from the first up to the second."""


class Asked(Protocol):
    """A question that a checkpoint can be of."""

    @property
    def digest(self) -> str:
        """The same for equal questions only."""
        ...


@dataclass(frozen=True)
class Checkpoint:
    """The file of a search.

    `damaged`: how many of its lines were passed over; None of a file that was there and had no
    whole line.
    """

    path: Path
    question: Asked
    damaged: int | None = 0

    def write(self, body: dict[str, Any]) -> None:
        """Write a part that is done, its span under `blocks`, with a checksum.

        Raises SearchError if the file cannot be written.
        """
        _append(self.path, _text({"done": body, "sum": crc32(_text(body))}) + b"\n")

    def parts(self, attempt: int, shape: list[Any], blocks: int) -> Iterator[dict[str, Any]]:
        """The parts of an attempt that are done, none over another.

        shape: what its parts have in common, under `regions`; blocks: how many there are. Raises
        SearchError where the file cannot be read or the attempt was one of another shape.
        """
        spans: list[Span] = []
        for body in _bodies(self.path):
            if body["attempt"] != attempt:
                continue
            if body["regions"] != shape:
                raise error("checkpoint", "checkpoint-version", file=str(self.path))
            start, stop = body["blocks"]
            if not 0 <= start < stop <= blocks or any(
                start < other_stop and other < stop for other, other_stop in spans
            ):
                continue
            spans.append((start, stop))
            yield body

    def add(self, attempt: int, tried: Regions, span: Span, listed: Results) -> None:
        """Write a block range that is done. Raises SearchError if the file cannot be written."""
        whose = {"attempt": attempt, "regions": _shape(tried), "blocks": list(span)}
        self.write(whose | results.as_json(listed))

    def kept(
        self, attempt: int, tried: Regions, asked: Question, blocks: int
    ) -> tuple[list[Span], Results]:
        """Block ranges of an attempt that are done, none over another, and what they brought in.

        asked: what the blocks were asked; blocks: how many there are. Raises SearchError where the
        file cannot be read or the attempt looked into other regions.
        """
        spans: list[Span] = []
        listed = results.nothing(len(asked.objectives), len(asked.stars.places))
        waiting: list[Results] = []
        for body in self.parts(attempt, _shape(tried), blocks):
            spans.append(tuple(body["blocks"]))
            waiting.append(results.from_json(body, len(asked.objectives), len(asked.stars.places)))
            if len(waiting) == TOGETHER:
                listed, waiting = results.merged([listed, *waiting], asked.ask), []
        return sorted(spans), results.merged([listed, *waiting], asked.ask)


def opened(path: Path, question: Asked) -> Checkpoint:
    """The checkpoint of a search: made if there is none, else looked into.

    Raises SearchError if it is of another search, is none, or can be neither read nor written.
    """
    header = _text({"crankstar_search": FORMAT, "digest": question.digest}) + b"\n"
    with _refused(path, "checkpoint-unreadable"):
        if path.exists() and not path.is_file():
            raise error("checkpoint", "checkpoint-directory", file=str(path))
        there = path.exists()
        written = path.read_bytes() if there else b""
    first, *lines = written.removesuffix(b"\n").split(b"\n")
    if header.startswith(written):
        _append(path, header[len(written) :])
        return Checkpoint(path, question, None if there and written != header else 0)
    tree = _tree(first)
    if tree.get("crankstar_search") != FORMAT:
        raise error("checkpoint", "checkpoint-foreign", file=str(path))
    if tree.get("digest") != question.digest:
        raise error("checkpoint", "checkpoint-other", file=str(path))
    # what broke off becomes a line of its own
    _append(path, b"" if written.endswith(b"\n") else b"\n")
    return Checkpoint(path, question, sum(not _body(line) for line in lines))


def left(blocks: int, done: list[Span], size: int) -> Iterator[Span]:
    """Block ranges of at most `size` blocks that are still to do. `done` is sorted."""
    at = 0
    for start, stop in [*done, (blocks, blocks)]:
        while at < start:
            yield at, min(at + size, start)
            at = min(at + size, start)
        at = stop


@contextmanager
def _refused(path: Path, code: str) -> Iterator[None]:
    """Turn an error of the file into a fault of the search."""
    try:
        yield
    except OSError as raised:
        why = raised.strerror or str(raised)
        raise error("checkpoint", code, file=str(path), error=why) from None


def _append(path: Path, line: bytes) -> None:
    """Writes bytes at the end, at once: so lines of two processes do not mix."""
    with _refused(path, "checkpoint-unwritable"), path.open("ab", buffering=0) as file:
        if file.write(line) != len(line):
            raise OSError("the disk is full")


def _text(tree: dict[str, Any]) -> bytes:
    return json.dumps(tree, separators=(",", ":")).encode("ascii")


def _shape(tried: Regions) -> list[Any]:
    """What two attempts must have in common for their block ranges to be parts of one."""
    return [tried.whole, *([place, radius] for place, radius in tried.radii)]


def _bodies(path: Path) -> Iterator[dict[str, Any]]:
    """The block ranges of a file that are as they were written."""
    with _refused(path, "checkpoint-unreadable"), path.open("rb") as file:
        file.readline()
        yield from filter(None, map(_body, file))


def _body(line: bytes) -> dict[str, Any]:
    """A block range as it was written; an empty one where the line is damaged."""
    tree = _tree(line)
    body = tree.get("done")
    return body if isinstance(body, dict) and tree.get("sum") == crc32(_text(body)) else {}


def _tree(line: bytes) -> dict[str, Any]:
    """A line as a tree; an empty one where it is none."""
    try:
        tree = json.loads(line)
    except (ValueError, RecursionError):
        return {}
    return tree if isinstance(tree, dict) else {}
