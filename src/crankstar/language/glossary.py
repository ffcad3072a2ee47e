"""The terms of the field with their symbols and their Japanese and Russian names."""

from __future__ import annotations

import tomllib
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path


@dataclass(frozen=True)
class Term:
    """A term: its symbol where it has one, its names, what it means, and other words for it."""

    term: str
    japanese: str
    russian: str
    meaning: str
    symbol: str = ""
    also: tuple[str, ...] = ()


@lru_cache
def terms() -> tuple[Term, ...]:
    """All terms, in the order of the glossary.

    >>> next(term.japanese for term in terms() if term.term == "balance shaft")
    'バランサーシャフト'
    """
    path = Path(__file__).with_name("glossary.toml")
    listed = tomllib.loads(path.read_text(encoding="utf-8"))["term"]
    return tuple(Term(**{**term, "also": tuple(term.get("also", ()))}) for term in listed)
