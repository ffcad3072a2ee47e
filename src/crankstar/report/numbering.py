"""Sections, figures and tables with their numbers, and the lines that refer to them."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from typing import NamedTuple

from crankstar.language.messages import N_, _, _n
from crankstar.language.written import HOLE, capitalised
from crankstar.tables.html import text

SECTION = re.compile(r'<section id="([\w-]+)"><h2>(.*?)</h2>(.*?)(?=<section id=|\Z)', re.DOTALL)
CAPTION = re.compile(r"<figcaption>")
TITLE = re.compile(r'<h3>((?:(?!</h3>).)*)</h3>(?=<div class="table)')
FIGURE = re.compile(r"<figure[ >]")


class Section(NamedTuple):
    """A numbered section: its number, address and title (HTML), its body with numbers."""

    number: str
    address: str
    title: str
    body: str

    @property
    def html(self) -> str:
        """The section."""
        heading = f'<h2><span class="number">{self.number}</span> {self.title}</h2>'
        return f'<section id="{self.address}">{heading}{self.body}'


def numbered(page: str, *, figures: int = 0) -> tuple[Section, ...]:
    """The sections of a page; figures and tables are counted through, `figures` stand before."""
    counts = {"figure": figures, "table": 0}

    def counted(kind: str, name: str) -> tuple[str, str]:
        counts[kind] += 1
        return f"{kind}-{counts[kind]}", text(_(name, number=counts[kind]))

    def caption(_match: re.Match[str]) -> str:
        address, name = counted("figure", N_("Figure {number}."))
        return f'<figcaption id="{address}"><b>{name}</b> '

    def title(match: re.Match[str]) -> str:
        address, name = counted("table", N_("Table {number}."))
        return f'<h3 id="{address}"><b>{name}</b> {match.group(1)}</h3>'

    out = []
    for number, match in enumerate(SECTION.finditer(page), 1):
        address, heading, body = match.groups()
        before = dict(counts)
        body = TITLE.sub(title, CAPTION.sub(caption, body))
        shown = "".join(_references(before, counts))
        lead = f'<p class="refs">{shown}</p>' if shown else ""
        out.append(Section(str(number), address, heading, lead + body))
    return tuple(out)


def _references(before: dict[str, int], after: dict[str, int]) -> Iterator[str]:
    """The sentence that names the figures and tables of a section, with links to them."""
    parts = []
    for kind, name in (("figure", _figures), ("table", _tables)):
        first, last = before[kind] + 1, after[kind]
        if first > last:
            continue
        ends = dict.fromkeys((first, last))
        links = "–".join(f'<a href="#{kind}-{end}">{end}</a>' for end in ends)
        parts.append(text(name(len(ends))).replace(LINKS, links))
    if parts:
        joined = ", ".join(parts)
        yield _("{text}.", text=capitalised(joined))


LINKS = HOLE
"""Stands for numbers with links in a sentence."""


def _figures(count: int) -> str:
    return _n("Figure {numbers}", "Figures {numbers}", count, numbers=LINKS)


def _tables(count: int) -> str:
    return _n("table {numbers}", "tables {numbers}", count, numbers=LINKS)


def entries(sections: Sequence[Section]) -> list[tuple[str, str, str]]:
    """The sections for the contents: number, address, title."""
    return [(section.number, section.address, section.title) for section in sections]
