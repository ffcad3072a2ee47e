"""A search kept in a file, stretch by stretch, so that it can go on after it was stopped.

Lines of JSON: first what search it is, then one line for each stretch that is done. A line that broke off (the machine
went down while it was written) is passed over: its stretch is done again.
"""

from __future__ import annotations

import json
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from crankstar.search import harvest
from crankstar.search.harvest import Harvest
from crankstar.search.question import Question
from crankstar.search.stars import SearchError

FORMAT = 1


@dataclass
class Checkpoint:
    """The file of a search, and what it holds: harvests by attempt and stretch."""

    path: Path
    question: Question
    done: dict[int, dict[tuple[int, int], Harvest]] = field(default_factory=dict)

    def add(self, attempt: int, stretch: tuple[int, int], found: Harvest) -> None:
        """Writes a stretch that is done. Raises SearchError where the file cannot be written."""
        self.done.setdefault(attempt, {})[stretch] = found
        self.append({"attempt": attempt, "blocks": list(stretch), **harvest.as_json(found)})

    def append(self, line: dict[str, Any]) -> None:
        """Writes one line. Raises SearchError where the file cannot be written."""
        try:
            with self.path.open("a", encoding="utf-8") as file:
                file.write(json.dumps(line, separators=(",", ":")) + "\n")
        except OSError as error:
            raise SearchError([f"the checkpoint {self.path} cannot be written: {error.strerror or error}"]) from None


def opened(path: Path, question: Question) -> Checkpoint:
    """The checkpoint of a search: made if there is none, else read. Raises SearchError if it is of another search."""
    out = Checkpoint(path, question)
    try:
        text = path.read_text(encoding="utf-8") if path.exists() else ""
    except (OSError, UnicodeDecodeError) as error:
        raise SearchError([f"the checkpoint {path} cannot be read: {error}"]) from None
    lines = text.splitlines()
    if not lines:
        out.append({"crankstar_search": FORMAT, "digest": question.digest})
        return out
    first = _tree(lines[0])
    if first.get("crankstar_search") != FORMAT:
        raise SearchError([f"{path} is no checkpoint of a search; name a file that does not exist yet, or one of this search"])
    if first.get("digest") != question.digest:
        message = "is the checkpoint of another search; name another file, or ask what was asked then"
        raise SearchError([f"{path} {message}"])
    for line in lines[1:]:
        _read(out, _tree(line))
    if not text.endswith("\n"):
        path.write_text(text + "\n", encoding="utf-8")  # what broke off becomes a line of its own
    return out


def _tree(line: str) -> dict[str, Any]:
    """A line as a tree; an empty one where it is none."""
    try:
        tree = json.loads(line)
    except ValueError:
        return {}
    return tree if isinstance(tree, dict) else {}


def _read(out: Checkpoint, tree: dict[str, Any]) -> None:
    """Takes up a stretch; what is no whole stretch is passed over."""
    try:
        start, stop = (int(number) for number in tree["blocks"])
        found = harvest.from_json(tree, len(out.question.objectives), len(out.question.stars.places))
        out.done.setdefault(int(tree["attempt"]), {})[start, stop] = found
    except (KeyError, TypeError, ValueError):
        return


def left(blocks: int, done: dict[tuple[int, int], Harvest], size: int) -> list[tuple[int, int]]:
    """Stretches of at most `size` blocks that are still to do."""
    out: list[tuple[int, int]] = []
    at = 0
    for start, stop in [*sorted(done), (blocks, blocks)]:
        while at < start:
            out.append((at, min(at + size, start)))
            at = out[-1][1]
        at = max(at, stop)
    return out
