"""Text from outside as a message can quote it: on one line, cut where long, printable."""

from __future__ import annotations

import re
from numbers import Number
from typing import Any

from crankstar.language.messages import _

CONTROL = re.compile(
    r"[\x00-\x08\x0b-\x1f\x7f-\x9f\u061c\u200b\u200e\u200f\u2028-\u202e\u2060-\u2069\ud800-\uf8ff\ufeff\ufff9-\ufffb\U000e0000-\U000e007f\U000f0000-\U0010ffff]"
)
"""Characters not allowed in an engine file: controls, changes of direction, invisible, private."""


def one_line(text: str, *, longest: int = 200) -> str:
    r"""Text from outside for a message: printable, on one line, cut where it is long.

    Where there is nothing to be seen in it, it stands in quotation marks.

    >>> one_line("red \x1b[31m\n"), one_line(""), one_line(" ")
    ('red ?[31m?', '""', '" "')
    """
    return _flat(text, longest) if text.strip() else f'"{_flat(text, longest)}"'


def _flat(text: str, longest: int) -> str:
    cut = text if len(text) <= longest else text[: longest - 3] + "..."
    return "".join(letter if letter.isprintable() else "?" for letter in cut)


def seen(value: Any) -> str:
    """A value of a file as quoted in a message: text in quotation marks, `a table` or `a list`.

    >>> seen("82.5 mm"), seen([1, 2]), seen(True), seen(7)
    ('"82.5 mm"', 'a list', 'true', '7')
    """
    if value is None:
        return "null"
    if isinstance(value, dict):
        return _("a table")
    if isinstance(value, list | tuple):
        return _("a list")
    if isinstance(value, str):
        return f'"{_flat(value, 60)}"'
    try:
        text = str(value)
    except ValueError:  # Python does not write whole numbers of thousands of digits
        return _("a number of thousands of digits")
    return one_line(text.lower() if isinstance(value, bool) else text, longest=60)


def given(value: Any) -> str:
    """An argument of Python as quoted in a message: None and True as Python writes them.

    >>> given(None), given(True), given("i4"), given([1, 2]), given(object())
    ('None', 'True', '"i4"', 'a list', 'an object')
    """
    if value is None or isinstance(value, bool):
        return str(value)
    if isinstance(value, dict):
        return "a dict"
    if isinstance(value, str | int | float | complex | list | tuple):
        return seen(value)
    if isinstance(value, bytes | Number):
        return one_line(str(value), longest=60)
    name = type(value).__name__
    return f"{'an' if name[0] in 'aeiouAEIO' else 'a'} {name}"
