"""Text that keeps the numbers written in it apart from its words.

Sentences are put together from numbers and other sentences by `filled` (which `_` calls) and
`joined`; whoever lays sentences of several engines upon each other (`tables.laid`) finds their
words in `frame` and their values in `numbers`. What f-strings and methods of `str` make of it is
plain text, in which numbers are words.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Mapping
from string import Formatter

HOLE = "\N{OBJECT REPLACEMENT CHARACTER}"
"""Stands for a number where words are looked through."""


class Number(str):
    """A number as it is written, with the value that it writes.

    >>> Number("1.235", 1.2346), Number("1.235", 1.2346).value
    ('1.235', 1.2346)
    """

    value: complex

    def __new__(cls, text: str, value: complex = 0.0) -> Number:
        """The text with its value."""
        number = super().__new__(cls, text)
        number.value = value
        return number


class Text(str):
    """Words and numbers in a row; no two words without a number between them."""

    pieces: tuple[str, ...]

    def __new__(cls, text: str, pieces: tuple[str, ...] = ()) -> Text:
        """The text, put together from these."""
        written = super().__new__(cls, text)
        written.pieces = pieces
        return written


def pieces(text: str) -> tuple[str, ...]:
    """The words and numbers of a text in order; one that keeps no number is a word itself."""
    if isinstance(text, Text):
        return text.pieces
    return (text,) if text else ()


def numbers(text: str) -> list[Number]:
    """The numbers of a text in order."""
    return [piece for piece in pieces(text) if isinstance(piece, Number)]


def frame(text: str) -> tuple[str | None, ...]:
    """The words of a text, with None in place of its numbers: what texts have in common.

    >>> frame(joined(" ", [Number("4", 4), "N"])), frame("4 N")
    ((None, ' N'), ('4 N',))
    """
    return tuple(None if isinstance(piece, Number) else piece for piece in pieces(text))


def joined(separator: str, texts: Iterable[str]) -> str:
    """Texts one after the other, as `str.join` has them, with the numbers they keep."""
    every: list[str] = []
    for index, text in enumerate(texts):
        every += [separator, *pieces(text)] if index else pieces(text)
    whole = "".join(every)
    if not any(isinstance(each, Number) for each in every):
        return whole
    merged: list[str] = []
    for each in filter(None, every):
        if merged and not isinstance(each, Number) and not isinstance(merged[-1], Number):
            merged[-1] += each
        else:
            merged.append(each)
    return Text(whole, tuple(merged))


def filled(template: str, values: Mapping[str, object]) -> str:
    """A template with its fields filled, as `str.format` does, with the numbers of its values.

    >>> numbers(filled("{size} N at order {order}", {"size": Number("4", 4), "order": 2}))
    ['4']
    """
    if not any(isinstance(value, Number | Text) for value in values.values()):
        return template.format(**values)
    texts: list[str] = []
    for words, name, how, _conversion in Formatter().parse(template):
        texts.append(words)
        if name is None:
            continue
        value = values[name]
        texts.append(value if isinstance(value, str) and not how else format(value, how or ""))
    return joined("", texts)


def capitalised(text: str) -> str:
    """The text with a capital letter at its beginning; a number stays as it is.

    >>> capitalised("order 4"), capitalised("")
    ('Order 4', '')
    """
    first, *others = pieces(text) or ("",)
    word = first if isinstance(first, Number) else f"{first[:1].upper()}{first[1:]}"
    return joined("", [word, *others])


def replaced(text: str, write: Callable[[Number], str]) -> str:
    """The text with what `write` gives in place of its numbers."""
    return joined("", [write(each) if isinstance(each, Number) else each for each in pieces(text)])


def divided(pattern: re.Pattern[str], text: str) -> list[str]:
    """The parts of a text that match a pattern, in which a number is a single sign, HOLE.

    >>> divided(re.compile("[^;]+"), filled("a {n}; b", {"n": Number("1;2", 1.2)}))
    ['a 1;2', ' b']
    """
    words = "".join(HOLE if isinstance(each, Number) else each for each in pieces(text))
    return [joined("", _between(text, *found.span())) for found in pattern.finditer(words)]


def _between(text: str, start: int, end: int) -> Iterator[str]:
    """The pieces of a text between two places, counted with a single sign for a number."""
    place = 0
    for each in pieces(text):
        length = 1 if isinstance(each, Number) else len(each)
        if place < end and start < place + length:
            whole = isinstance(each, Number)
            yield each if whole else each[max(start - place, 0) : end - place]
        place += length
