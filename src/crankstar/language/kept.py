"""Numbers whose values are kept, for a table or a sentence that gives ranges in their place.

While `values_kept`, a number in a sentence carries its value, and a size, which alone does not tell
how low it can come, the amplitudes that bound it (`Size`). `tables.ranges` reads them.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from contextvars import ContextVar

import numpy as np
from numpy.typing import NDArray

_KEPT: ContextVar[bool] = ContextVar("values kept", default=False)
OPENING, MIDDLE, CLOSING = "\ue000", "\ue001", "\ue002"
"""Around the value and the writing of a number whose value is kept; no text of a file has them."""
BESIDE = ";"
"""Between a size and its bounds."""


@contextmanager
def values_kept() -> Iterator[None]:
    """Have every number in a sentence carry its value, for one that states a range in its place.

    >>> from crankstar.language.numbers import number
    >>> with values_kept():
    ...     number(0.5) == f"{OPENING}0.5{MIDDLE}0.5{CLOSING}"
    True
    """
    before = _KEPT.set(True)
    try:
        yield
    finally:
        _KEPT.reset(before)


def are_kept() -> bool:
    """Whether numbers carry their values, so that one unit has to do for all of a range."""
    return _KEPT.get()


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
