"""The files of one engine on a site: its page, its miniatures."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any, NamedTuple
from urllib.parse import quote

from crankstar.engine.engine import Engine
from crankstar.files import engine_of
from crankstar.page.library import held
from crankstar.page.standalone import Shared, document
from crankstar.site.gallery import Card
from crankstar.site.miniatures import LOOKS, Look, miniature

ENGINES, PICTURES = "engines", "pictures"
"""Folders of a site."""


class Scripts(NamedTuple):
    """The places on a site of the script of its pages, and of that of their figures."""

    page: str
    figures: str


class Subject(NamedTuple):
    """An engine of a site: the name of its files, its engine file as a tree, how it was called."""

    name: str
    tree: Mapping[str, Any]
    source: str


def card_of(subject: Subject) -> Card:
    """What the gallery says of an engine. Raises EngineFileError where it is none."""
    engine = engine_of(dict(subject.tree), name=subject.source)
    return Card(
        subject.name,
        engine.name,
        str(subject.tree.get("layout", {}).get("type", "explicit")),
        len(engine.chambers),
        "two-stroke" if engine.cycle_angle == 360 else "four-stroke",
        quote(page_of(subject.name)),
    )


def page_of(name: str) -> str:
    """The place of an engine's page in a site."""
    return f"{ENGINES}/{name}.html"


def picture_of(name: str, look: Look) -> str:
    """The place of a miniature in a site."""
    return f"{PICTURES}/{name}{look.suffix}"


def files_of(subject: Subject, *, scripts: Scripts) -> Iterator[tuple[str, bytes]]:
    """The files of an engine: place and contents. `scripts` are those that all pages share."""
    engine: Engine = engine_of(dict(subject.tree), name=subject.source)
    for look in LOOKS:
        yield picture_of(subject.name, look), miniature(engine, look)
    contents = held(
        [engine],
        files_given=[subject.tree],
        sources=[subject.source],
        command=f"crankstar page {subject.source}",
    )
    shared = Shared(f"../{scripts.page}", f"../{scripts.figures}", up="../index.html")
    yield page_of(subject.name), document(contents, shared=shared).encode()


def write(folder: Path, place: str, contents: bytes) -> None:
    """Write a file of a site, its folder too."""
    path = folder / place
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(contents)
