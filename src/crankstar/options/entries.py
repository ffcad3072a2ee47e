"""An entry of the vocabulary of options."""

from __future__ import annotations

from typing import Literal, NamedTuple

Takes = Literal["nothing", "text", "several texts", "whole number", "number"]
"""What follows an option. `several texts`: it may be repeated."""


class Option(NamedTuple):
    """What an option takes, what it means, and other names under which people look for it."""

    takes: Takes
    meaning: str
    also: tuple[str, ...] = ()
