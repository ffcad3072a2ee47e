"""Analyses of several engines that are laid upon each other, for tables and sentences with ranges.

They must say the same things: what one of them leaves out or calls the greatest, another may not.
So they ask what the engine as given decides (`as_given`), or which things there are in any of them
(`of_any`). `tables.laid` lays what they say upon each other.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Hashable, Iterable, Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from typing import Any, TypeVar

from crankstar.language.messages import _
from crankstar.language.written import numbers

Item = TypeVar("Item")


class Common:
    """What analyses have in common: decisions of the first, things found in any, how many told."""

    def __init__(self) -> None:
        self.given: dict[Hashable, Any] = {}
        self.found: dict[Hashable, dict[Any, None]] = {}
        self.told: list[tuple[Hashable, int]] = []
        self.asked: Counter[Hashable] = Counter()


_COMMON: ContextVar[Common | None] = ContextVar("common", default=None)


@contextmanager
def refusals_marked() -> Iterator[None]:
    """Have numbers in errors that are raised within marked as estimated."""
    try:
        yield
    except ValueError as error:
        error.args = tuple(_refusal(each) if isinstance(each, str) else each for each in error.args)
        raise


def _refusal(text: str) -> str:
    """What an error says of an engine with estimated values, marked where it has numbers."""
    return _("{sentence} (estimated)", sentence=text) if numbers(text) else text


@contextmanager
def _laid() -> Iterator[Common]:
    """Have the analyses that are made within say the same things."""
    common = Common()
    token = _COMMON.set(common)
    try:
        with refusals_marked():
            yield common
    finally:
        _COMMON.reset(token)


def are_laid() -> bool:
    """Whether what is made now is laid upon what is made of other engines."""
    return _COMMON.get() is not None


def alike(build: Callable[[Item], Any], engines: Iterable[Item]) -> list[Any]:
    """The analyses of engines, that of the engine as given first, which say the same things.

    They are made again where one of them has told less than another has found.
    """
    subjects = [*engines]
    with _laid() as common:
        while True:
            common.given.clear()
            common.told.clear()
            made = []
            for each in subjects:
                common.asked.clear()
                made.append(build(each))
            if all(len(common.found[name]) == count for name, count in common.told):
                return made


def as_given(name: Hashable, own: Item) -> Item:
    """What the engine as given decides under this name; its `own` where analyses are not alike."""
    common = _COMMON.get()
    return own if common is None else common.given.setdefault(name, own)


def in_turn(name: Hashable, own: Item) -> Item:
    """What the engine as given decides when it asks under this name for the same time."""
    common = _COMMON.get()
    if common is None:
        return own
    common.asked[name] += 1
    return as_given((name, common.asked[name]), own)


def of_any(name: Hashable, own: Iterable[Item]) -> tuple[Item, ...]:
    """What any of the analyses has found under this name; its `own` where they are not alike."""
    common = _COMMON.get()
    if common is None:
        return tuple(own)
    found = common.found.setdefault(name, {})
    found.update(dict.fromkeys(own))
    common.told.append((name, len(found)))
    return tuple(found)
