"""Sections, figures and the parts of a Document as pieces of a page."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from crankstar.analysis.document import Document, Remarks, Table
from crankstar.tables.html import kind_of, part_html, text, typeset


def parts_html(parts: Iterable[Table | Remarks]) -> str:
    """Tables and remarks one after the other.

    >>> parts_html([Remarks(("none < one",), "Weights")])
    '<h3>Weights</h3><p>none &lt; one</p>'
    """
    return "".join(map(part_html, Document("", tuple(parts)).for_readers.parts))


def section(title: str, body: str, *, name: str) -> str:
    """A section of the report under its title; `name` is the end of its address."""
    return f'<section id="{text(name)}"><h2>{text(title)}</h2>{body}</section>' if body else ""


def figure(drawing: str, caption: str, kind: str = "") -> str:
    """A drawing in the colours of the page with a caption."""
    return f"<figure{kind_of(kind)}>{drawing}<figcaption>{typeset(caption)}</figcaption></figure>"


def figures(drawn: Sequence[str], kind: str = "") -> str:
    """Figures side by side where there is room."""
    name = f"figures {kind}".rstrip()
    return f'<div class="{name}">{"".join(drawn)}</div>' if drawn else ""
