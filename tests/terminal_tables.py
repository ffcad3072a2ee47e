"""Tables of the terminal read back: what stands under each heading, and in which unit."""

from __future__ import annotations

import re
from itertools import groupby
from typing import NamedTuple

RULE = re.compile("\u2500{6,}")


class Read(NamedTuple):
    """A column as it is printed: its heading, its unit or "", and the text of each row."""

    heading: str
    unit: str
    cells: tuple[str, ...]


def blocks(text: str) -> dict[str, list[list[Read]]]:
    """The tables under each title; one that is split has several blocks."""
    lines = text.splitlines()
    found: dict[str, list[list[Read]]] = {}
    title = ""
    for place, line in enumerate(lines):
        if not RULE.fullmatch(line.strip()):
            continue
        first = place
        while first and lines[first - 1].strip():
            first -= 1
        last = place + 1
        while last < len(lines) and lines[last].strip():
            last += 1
        if not lines[first].startswith(" ") and "  " not in lines[first].strip():
            title, first = lines[first].strip(), first + 1
        found.setdefault(title, []).append(_columns(lines[first:place], lines[place + 1 : last]))
    return found


def _columns(head: list[str], rows: list[str]) -> list[Read]:
    width = max(map(len, (*head, *rows)))
    padded = [line.ljust(width) for line in (*head, *rows)]
    blank = [all(line[at] == " " for line in padded) for at in range(width)]
    spans: list[tuple[int, int]] = []
    for empty, group in groupby(range(width), key=lambda at: blank[at]):
        places = list(group)
        if empty:
            continue
        start, end = places[0], places[-1] + 1
        if spans and start - spans[-1][1] < 2:
            start = spans.pop()[0]
        spans.append((start, end))
    return [_column([line[a:b].strip() for line in padded], len(head)) for a, b in spans]


def _column(texts: list[str], head: int) -> Read:
    heading = " ".join(filter(None, texts[:head]))
    unit = re.search(r"\[(.+)\]$", heading)
    words = heading[: unit.start()].strip() if unit else heading
    return Read(words, unit[1] if unit else "", tuple(texts[head:]))
