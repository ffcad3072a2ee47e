"""Analyses that are laid upon each other, for tables and sentences that give ranges of numbers.

While `values_kept`, a number in a sentence carries its value, and a size, which alone does not tell
how low it can come, the amplitudes that bound it (`Size`). `tables.ranges` reads them.

The analyses must say the same things: what one of them leaves out or calls the greatest, another
may not. So they ask what the engine as given decides (`as_given`), or which things there are in any
of them (`of_any`).
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable, Hashable, Iterable, Iterator, Sequence
from contextlib import contextmanager
from contextvars import ContextVar
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from crankstar.language.messages import _

Item = TypeVar("Item")


class Common:
    """What analyses have in common: decisions of the first, things found in any, how many told."""

    def __init__(self) -> None:
        self.given: dict[Hashable, Any] = {}
        self.found: dict[Hashable, dict[Any, None]] = {}
        self.told: list[tuple[Hashable, int]] = []
        self.asked: Counter[Hashable] = Counter()


_KEPT: ContextVar[Common | None] = ContextVar("values kept", default=None)
OPENING, MIDDLE, CLOSING = "\ue000", "\ue001", "\ue002"
"""Around the value and the writing of a number whose value is kept; no text of a file has them."""
BESIDE = ";"
"""Between a size and its bounds."""
NUMBER = re.compile(f"{OPENING}([^{MIDDLE}]*){MIDDLE}([^{CLOSING}]*){CLOSING}")
"""A number with its value: the value, the writing."""


@contextmanager
def values_kept() -> Iterator[Common]:
    """Have every number in a sentence carry its value, for one that states a range in its place.

    Errors that are raised meanwhile tell their numbers without, marked as estimated.

    >>> from crankstar.language.numbers import number
    >>> with values_kept():
    ...     number(0.5) == f"{OPENING}0.5{MIDDLE}0.5{CLOSING}"
    True
    """
    common = Common()
    before = _KEPT.set(common)
    try:
        yield common
    except ValueError as error:
        error.args = tuple(_refusal(each) if isinstance(each, str) else each for each in error.args)
        raise
    finally:
        _KEPT.reset(before)


def plain(text: str) -> str:
    """Text without the values its numbers carry."""
    return NUMBER.sub(r"\2", text)


def _refusal(text: str) -> str:
    """What an error says of an engine with estimated values, marked where it has numbers."""
    return _("{sentence} (estimated)", sentence=plain(text)) if NUMBER.search(text) else text


def are_kept() -> bool:
    """Whether numbers carry their values, so that one unit has to do for all of a range."""
    return _KEPT.get() is not None


def alike(build: Callable[[Item], Any], engines: Iterable[Item]) -> list[Any]:
    """The analyses of engines, that of the engine as given first, which say the same things.

    They are made again where one of them has told less than another has found.
    """
    subjects = [*engines]
    with values_kept() as common:
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
    common = _KEPT.get()
    return own if common is None else common.given.setdefault(name, own)


def in_turn(name: Hashable, own: Item) -> Item:
    """What the engine as given decides when it asks under this name for the same time."""
    common = _KEPT.get()
    if common is None:
        return own
    common.asked[name] += 1
    return as_given((name, common.asked[name]), own)


def of_any(name: Hashable, own: Iterable[Item]) -> tuple[Item, ...]:
    """What any of the analyses has found under this name; its `own` where they are not alike."""
    common = _KEPT.get()
    if common is None:
        return tuple(own)
    found = common.found.setdefault(name, {})
    found.update(dict.fromkeys(own))
    common.told.append((name, len(found)))
    return tuple(found)


class Size(float):
    """A size that is nowhere below the sum of the absolute values in any row of its `bounds`.

    These [row, part] are complex amplitudes, each linear in every estimated value while the others
    are held: of a greatest value its two turning vectors together, its vertical part alone; of a
    peak over a turn the vector at any one crank angle.
    """

    bounds: NDArray[np.complex128]

    def __new__(cls, value: float, bounds: NDArray[np.complex128]) -> Size:
        """The size with its bounds."""
        size = super().__new__(cls, value)
        size.bounds = bounds
        return size

    def __mul__(self, factor: float) -> Size:
        """The size in another unit."""
        return Size(float(self) * factor, self.bounds * factor)

    __rmul__ = __mul__


def bounded(value: float, rows: Sequence[Sequence[complex]] | NDArray[np.complex128]) -> float:
    """The value as a Size with these bounds while values are kept, else as it is."""
    return Size(value, np.asarray(rows, complex)) if are_kept() else float(value)


def value_text(value: complex) -> str:
    """A number with all its digits, a Size with its bounds.

    >>> value_text(0.1), value_text(1 + 2j)
    ('0.1', '(1+2j)')
    """
    if not isinstance(value, Size):
        return repr(complex(value) if isinstance(value, complex) else float(value))
    flat = value.bounds.tobytes().hex()
    return f"{float(value)!r}{BESIDE}{value.bounds.shape[-1]}{BESIDE}{flat}"


def value_of(text: str) -> float | complex:
    """The number that `value_text` has written.

    >>> size = Size(5.0, np.array([[3.0, 4j]]))
    >>> value_of(value_text(size)) == size, value_of(value_text(size)).bounds.tolist()
    (True, [[(3+0j), 4j]])
    """
    if BESIDE not in text:
        return complex(text) if "j" in text else float(text)
    size, parts, flat = text.split(BESIDE)
    return Size(float(size), np.frombuffer(bytes.fromhex(flat), complex).reshape(-1, int(parts)))
