"""The names of options: the field that one sets, the option that an unknown name stands for."""

from __future__ import annotations

from collections.abc import Iterator
from difflib import get_close_matches

from crankstar.options.vocabulary import OPTIONS

ELSEWHERE = {"--rpm": "--speed"}
"""Options of one command, and what they stand for in those that have it not."""


def field_name(name: str) -> str:
    """The field of a record that an option sets: `--mode-shape` sets `mode_shape`."""
    return name.removeprefix("--").replace("-", "_")


def meant(word: str, offered: list[str]) -> str | None:
    """The option among those `offered` that an unknown word stands for; None if none is near.

    >>> meant("--order", ["--orders", "--speed"]), meant("--rpm", ["--orders", "--speed"])
    ('--orders', '--speed')
    """
    names = dict(_names(offered))
    if word in names:
        return names[word]
    letters = {name.lstrip("-"): option for name, option in names.items()}
    near = get_close_matches(word.lstrip("-"), letters, 1)
    return letters[near[0]] if near else None


def _names(offered: list[str]) -> Iterator[tuple[str, str]]:
    """Each name under which an offered option is looked for; its own come last, and win."""
    yield from (
        (name, option) for option in offered if option in OPTIONS for name in OPTIONS[option].also
    )
    yield from (pair for pair in ELSEWHERE.items() if pair[1] in offered)
    yield from ((option, option) for option in offered)
