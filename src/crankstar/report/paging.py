"""A report on paper: printed once to learn its pages, and again with them in its contents."""

from __future__ import annotations

import re
from collections.abc import Iterator

from crankstar.report.printing import pdf

PLACE = re.compile(r'<span class="page" data-of="([\w-]+)"></span>')


def printed(page: str, *, by: str) -> bytes:
    """A report as a PDF whose contents name pages. Raises PrintingError."""
    numbers = pages_of(pdf(page, by=by))

    def number(match: re.Match[str]) -> str:
        return f'<span class="page">{numbers.get(match.group(1), "")}</span>'

    return pdf(PLACE.sub(number, page), by=by)


def pages_of(content: bytes) -> dict[str, int]:
    """The page, from 1, of each place that a PDF names as a destination."""
    root = re.search(rb"/Type /Catalog.*?/Pages (\d+) 0 R", content, re.DOTALL)
    if root is None:
        return {}
    order = {leaf: index for index, leaf in enumerate(_leaves(content, root[1]), 1)}
    named = re.findall(rb"/([\w-]+) \[(\d+) 0 R /XYZ", content)
    return {name.decode(): order[page] for name, page in named if page in order}


def _leaves(content: bytes, tree: bytes) -> Iterator[bytes]:
    """The numbers of the page objects below an object of the page tree."""
    found = re.search(rb"\n" + tree + rb" 0 obj\s(.*?)endobj", content, re.DOTALL)
    kids = re.search(rb"/Kids \[([^]]*)\]", found[1]) if found else None
    if kids is None:
        yield tree
        return
    for kid in re.findall(rb"(\d+) 0 R", kids[1]):
        yield from _leaves(content, kid)
