"""Sentences in the reader's language, from gettext catalogs.

English stands where it is used and is the key: `_("The primary force is {size} N.", size="4.2")`.
Only whole sentences are passed, numbers and units are placed by name, already formatted.
"""

from __future__ import annotations

import gettext
import re
from collections.abc import Iterable, Iterator, Mapping
from contextlib import contextmanager
from contextvars import ContextVar
from functools import cache
from pathlib import Path
from typing import NamedTuple

from crankstar.language.written import filled, joined

CATALOGS = Path(__file__).with_name("catalogs")
DOMAIN = "crankstar"
LANGUAGES = ("en", "ja", "ru")
"""Languages with a catalog, English, the language of the keys, first."""

NAMES = {"en": "English", "ja": "日本語", "ru": "Русский"}
"""What those who speak a language call it."""
WIDE = re.compile("[\u3000-\u9fff\uf900-\ufaff\uff00-\uffef]")
"""A sign of Japanese print, beside which there is no space."""

_language: ContextVar[str] = ContextVar("language", default="en")
_named: ContextVar[bool] = ContextVar("named", default=False)


@contextmanager
def spoken(language: str) -> Iterator[None]:
    """Have sentences in this language, one of LANGUAGES, while the context lasts."""
    token = _language.set(language)
    try:
        yield
    finally:
        _language.reset(token)


def speak(language: str, *, named: bool = False) -> None:
    """Have sentences in this language from now on, in a process or thread that begins.

    `named`: the reader asked for it, no system was asked.
    """
    _language.set(language)
    _named.set(named)


def is_named() -> bool:
    """Whether the reader asked for the language of the context."""
    return _named.get()


def language() -> str:
    """The language of the context, as HTML names it."""
    return _language.get()


@cache
def _catalog(language: str) -> gettext.NullTranslations:
    """The catalog of a language; English, and what a catalog lacks, is the key itself."""
    if language == "en":
        return gettext.NullTranslations()
    return gettext.translation(DOMAIN, CATALOGS, [language], fallback=True)


def _(message: str, /, **values: object) -> str:
    """A sentence in the language of the context, its placeholders filled.

    >>> _("The shaft turns at {speed} rpm.", speed=3000)
    'The shaft turns at 3000 rpm.'
    """
    return _filled(_catalog(_language.get()).gettext(message), values)


def _n(one: str, several: str, count: int, /, **values: object) -> str:
    """The form of a sentence that fits a count, its placeholders filled.

    >>> _n("{count} cylinder", "{count} cylinders", 8, count=8)
    '8 cylinders'
    """
    return _filled(_catalog(_language.get()).ngettext(one, several, count), values)


def _filled(sentence: str, values: Mapping[str, object]) -> str:
    """The sentence with its values; Japanese print has no space between its own signs."""
    if _language.get() == "ja":
        for name, text in ((name, str(value)) for name, value in values.items()):
            place = f"{{{name}}}"
            if WIDE.match(text[:1]):
                sentence = re.sub(f"(?<={WIDE.pattern}) (?={place})", "", sentence)
            if WIDE.match(text[-1:]):
                sentence = re.sub(f"(?<={place}) (?={WIDE.pattern})", "", sentence)
    return filled(sentence, values)


def passage(sentences: Iterable[str]) -> str:
    """Sentences one after the other, without those that are empty; no space follows a Japanese one.

    >>> passage(["No primary force.", "", "No couple of any order."])
    'No primary force. No couple of any order.'
    """
    texts: list[str] = []
    for each in filter(None, sentences):
        texts += [" ", each] if texts and not texts[-1].endswith("。") else [each]
    return joined("", texts)


class MessageError(ValueError):
    """An error whose text is for the reader, which every host shows as it is.

    A sentence is translated as `_` does; without values it stands as it is.

    >>> raise MessageError("give the mass, such as {example}", example="500 g")
    Traceback (most recent call last):
    crankstar.language.messages.MessageError: give the mass, such as 500 g
    """

    def __init__(self, sentence: str, /, **values: object) -> None:
        translated = _catalog(_language.get()).gettext(sentence)
        super().__init__(_filled(translated, values) if values else translated)


class Plural(NamedTuple):
    """A sentence that is kept now, in its two English forms, and translated with `_n`."""

    one: str
    several: str


def N_(message: str) -> str:  # noqa: N802 - the name that gettext's tools look for
    """Mark a sentence that is kept now and translated with `_` where it is shown."""
    return message
