"""A report read as a reader does: its sections, tables, texts, and what its policy allows."""

from __future__ import annotations

import re
from base64 import b64encode
from collections.abc import Iterator
from hashlib import sha256
from html.parser import HTMLParser
from typing import NamedTuple

POWER = re.compile(r"·10([⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+)")
EMPTY = {"meta", "br", "link", "input", "img", "hr"}


def plain(words: str) -> str:
    """Numbers as programs write them."""
    lowered = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789")
    return POWER.sub(
        lambda found: f"e{int(found.group(1).translate(lowered)):+03d}", words
    ).replace("−", "-")


class Tag(NamedTuple):
    """An element as it begins."""

    name: str
    attributes: dict[str, str]


class Reader(HTMLParser):
    """All elements and texts of a page; refuses elements that are not closed in order."""

    def __init__(self, page: str) -> None:
        super().__init__(convert_charrefs=True)
        self.tags: list[Tag] = []
        self.texts: list[tuple[tuple[str, ...], str]] = []
        self.tables: dict[str, list[list[str]]] = {}
        self._open: list[str] = []
        self._label = ""
        self.feed(page)
        self.close()
        assert self._open == [], "elements that are not closed"

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        found = Tag(tag, {key: value or "" for key, value in attrs})
        self.tags.append(found)
        if tag not in EMPTY:
            self._open.append(tag)
        if found.attributes.get("class", "").startswith("table"):
            self._label = found.attributes["aria-label"]
            self.tables[self._label] = []
        if tag == "tr":
            self.tables[self._label].append([])
        if tag in ("td", "th"):
            self.tables[self._label][-1].append("")

    def handle_startendtag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.tags.append(Tag(tag, {key: value or "" for key, value in attrs}))

    def handle_endtag(self, tag: str) -> None:
        assert self._open.pop() == tag

    def handle_data(self, data: str) -> None:
        self.texts.append((tuple(self._open), data))
        if {"td", "th"} & set(self._open):
            self.tables[self._label][-1][-1] += plain(data)

    def text(self) -> str:
        """All that is shown."""
        return " ".join(data for path, data in self.texts if "style" not in path)

    def table(self, beginning: str) -> list[list[str]]:
        """The rows of the table whose title begins so, its heads first."""
        return next(rows for label, rows in self.tables.items() if label.startswith(beginning))

    def styles(self) -> Iterator[str]:
        """The style sheets."""
        return (data for path, data in self.texts if path and path[-1] == "style")

    def policy(self) -> str:
        """The Content-Security-Policy."""
        return next(
            t.attributes["content"]
            for t in self.tags
            if t.attributes.get("http-equiv") == "Content-Security-Policy"
        )


def vouched(style: str) -> str:
    """How a policy vouches for a style sheet."""
    return f"'sha256-{b64encode(sha256(style.encode()).digest()).decode()}'"


def amplitude(cell: str) -> complex:
    """An amplitude `a ∠ p°` of a table as a complex number."""
    if cell == "0":
        return 0j
    size, phase = re.fullmatch(r"(\S+) ∠ (\S+)°", cell).groups()  # pyright: ignore[reportOptionalMemberAccess]
    from cmath import rect
    from math import radians

    return rect(float(size), radians(float(phase)))
