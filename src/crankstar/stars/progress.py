"""How far a search has come, and the line that says so."""

from __future__ import annotations

from typing import NamedTuple

from crankstar.language.messages import _
from crankstar.language.numbers import duration


class Progress(NamedTuple):
    """How far a search has come.

    attempt: from 0; done, blocks: of this attempt, those of a checkpoint included; met: stars
    examined in it; seconds: since the search was begun or resumed; rate: blocks a second in this
    attempt, by what was done here; seconds_left: expected to the end of this attempt, None before
    anything is done.
    """

    attempt: int
    done: int
    blocks: int
    met: int
    seconds: float
    rate: float
    seconds_left: float | None


def note(now: Progress) -> str:
    """How fast a search is, and how long it will still take.

    >>> note(Progress(1, 5, 10, 12_000, 2.0, 2.5, 2.0))
    '6,000 stars/s, 2 s left (attempt 2)'
    """
    parts = []
    if now.seconds > 0:
        parts.append(_("{rate} stars/s", rate=f"{now.met / now.seconds:,.0f}"))
    if now.seconds_left is not None:
        parts.append(_("{duration} left", duration=duration(now.seconds_left)))
    text = ", ".join(parts)
    return (
        _("{text} (attempt {number})", text=text, number=now.attempt + 1) if now.attempt else text
    )
