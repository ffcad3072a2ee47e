"""The terms that the page explains where they stand."""

from __future__ import annotations

from dataclasses import asdict

from crankstar.language import glossary
from crankstar.page.unit_records import Shown


class TermShown(Shown):
    """A term of the glossary: its names, its symbol or "", its meaning, other words for it."""

    term: str
    japanese: str
    russian: str
    meaning: str
    symbol: str = ""
    also: tuple[str, ...] = ()


def terms_shown() -> tuple[TermShown, ...]:
    """The whole glossary.

    >>> next(term.symbol for term in terms_shown() if term.term == "order")
    'k'
    """
    return tuple(TermShown(**asdict(term)) for term in glossary.terms())
