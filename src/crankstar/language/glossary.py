"""The terms of the field: symbols, names and meanings in every language."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

from crankstar.language.messages import LANGUAGES, _, spoken


@dataclass(frozen=True)
class Term:
    """A term: its names, its meaning in each language, its symbol or "", other words for it."""

    term: str
    japanese: str
    russian: str
    meanings: Mapping[str, str]
    symbol: str = ""
    also: tuple[str, ...] = ()


@lru_cache
def terms() -> tuple[Term, ...]:
    """All terms, in the order of the glossary.

    >>> order = next(term for term in terms() if term.term == "order")
    >>> order.russian, order.meanings["en"][:19]
    ('порядок', 'how often something')
    """
    path = Path(__file__).with_name("glossary.toml")
    listed = tomllib.loads(path.read_text(encoding="utf-8"))["term"]
    return tuple(
        Term(
            term=term["term"],
            japanese=term["japanese"],
            russian=term["russian"],
            meanings={language: _in(language, term["meaning"]) for language in LANGUAGES},
            symbol=term.get("symbol", ""),
            also=tuple(term.get("also", ())),
        )
        for term in listed
    )


def _in(language: str, meaning: str) -> str:
    with spoken(language):
        return _(meaning)
