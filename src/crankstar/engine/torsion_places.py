"""Places of what twists, by name: an end or a throw of a crankshaft, or a disc."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import NamedTuple

FRONT, REAR = "front", "rear"
_PLACE = re.compile(
    r"(?:(?P<end>front|rear)|throw\s*(?P<throw>\d{1,4}))(?:\s+of\s+(?P<crank>.+))?", re.IGNORECASE
)


class Home(NamedTuple):
    """Where a disc or a pendulum hangs: the index of a `throw`, or of a `disc`, from 0.

    Throws count crankshaft by crankshaft, each from its front.
    """

    throw: int | None = None
    disc: int | None = None


Cranks = Sequence[tuple[str, int]]
"""The crankshafts by name, the first one first, with how many throws each has."""


def home(text: str, *, cranks: Cranks, names: tuple[str, ...]) -> Home | None:
    """The place that a text names, `names` being those of the discs; None where there is none.

    >>> home("ring", cranks=[], names=("hub", "ring"))
    Home(throw=None, disc=1)
    >>> two = [("lower", 6), ("upper", 6)]
    >>> [home(text, cranks=two, names=()).throw for text in ("rear", "throw 2 of upper")]
    [5, 7]
    """
    if text in names:
        return Home(disc=names.index(text))
    found = _PLACE.fullmatch(text.strip())
    if found is None:
        return None
    before = 0
    for name, throws in cranks:
        if found["crank"] in (None, name):
            number = _number(found["end"], found["throw"], throws)
            return None if number is None else Home(throw=before + number)
        before += throws
    return None


def _number(end: str | None, throw: str | None, throws: int) -> int | None:
    """The throw from 0 of an end, or of a number; None where there is none."""
    if not throws:
        return None
    if end is not None:
        return 0 if end.lower() == FRONT else throws - 1
    return int(throw or 0) - 1 if 1 <= int(throw or 0) <= throws else None


def is_place(text: str) -> bool:
    """Whether a text stands for an end or a throw of a crankshaft, and so names no disc."""
    return _PLACE.fullmatch(text.strip()) is not None
