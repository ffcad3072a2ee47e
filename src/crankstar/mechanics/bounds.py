"""Greatest values of a spectrum which, where bounds are kept, say how low they can come.

The greatest value of an order over a turn is |forward| + |backward|, and no less than any of its
components; the peak of all orders is no less than the vector at any crank angle. Each of these is
linear in every estimated value while the others are held (`Size`).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from contextvars import ContextVar
from typing import Literal

import numpy as np

from crankstar import spectra
from crankstar.language.alike import are_laid
from crankstar.spectra import Complex, Peak, Real, Spectrum

ANGLES = np.arange(24) * (2 * np.pi / 24)
"""Crank angles at which a peak is bounded."""
HIGHEST = 8
"""The last order that bounds a peak."""
_KEPT: ContextVar[bool] = ContextVar("bounds kept", default=False)


class Size(float):
    """A size that is nowhere below the sum of the absolute values in any row of its `bounds`.

    These [row, part] are complex amplitudes, each linear in every estimated value while the others
    are held: of a greatest value its two turning vectors together, its vertical part alone; of a
    peak over a revolution the vector at any one crank angle.
    """

    bounds: Complex

    def __new__(cls, value: float, bounds: Complex) -> Size:
        """The size with its bounds."""
        size = super().__new__(cls, value)
        size.bounds = bounds
        return size

    def __mul__(self, factor: float) -> Size:
        """The size in another unit."""
        return Size(float(self) * factor, self.bounds * factor)

    __rmul__ = __mul__


@contextmanager
def bounds_kept() -> Iterator[None]:
    """Have sizes that are computed within carry what bounds them."""
    token = _KEPT.set(True)
    try:
        yield
    finally:
        _KEPT.reset(token)


def are_kept() -> bool:
    """Whether sizes carry what bounds them, as those do of which ranges are found."""
    return _KEPT.get() or are_laid()


def bounded(value: float, rows: Sequence[Sequence[complex]] | Complex) -> float:
    """The value as a Size with these bounds while bounds are kept, else as it is."""
    return Size(value, np.asarray(rows, complex)) if are_kept() else float(value)


def length(amplitude: complex) -> float:
    """The absolute value of an amplitude."""
    return bounded(abs(amplitude), [[amplitude]])


def lengths(amplitudes: Complex) -> list[float]:
    """Those of a row of amplitudes."""
    return (
        [length(each) for each in amplitudes.tolist()] if are_kept() else abs(amplitudes).tolist()
    )


def of_order(forward: Complex, backward: Complex) -> Complex:
    """What bounds |forward| + |backward| of vectors [...]: rows of amplitudes [..., row, part]."""
    mate = np.conj(backward)
    rows = [(forward, backward), (forward + mate, 0 * mate), (forward - mate, 0 * mate)]
    return np.stack([np.stack(row, axis=-1) for row in rows], axis=-2)


def of_peak(spectrum: Spectrum) -> Complex:
    """What bounds the peaks of vectors [..., n]: rows of amplitudes [..., row, part].

    With M the peak, each turning vector of order k is the mean of the vector times exp(-+ i k
    theta) and so no longer than M. The component along any axis is a real signal; its amplitude at
    order k is twice the mean of it times cos(k theta - p), at most 2 M times the mean 2/pi of
    |cos|: M is no less than pi/4 of the greatest value of any order.
    """
    at = spectra.value(spectrum, ANGLES)
    forward, backward = (_by_half_orders(spectrum, way) for way in ("forward", "backward"))
    parts = np.pi / 4 * of_order(forward, backward)
    rows = [
        np.stack([at, 0 * at], axis=-1),
        np.stack([forward, 0 * forward], axis=-1),
        np.stack([backward, 0 * backward], axis=-1),
        parts.reshape(*parts.shape[:-3], -1, 2),
    ]
    return np.concatenate(rows, axis=-2)


def _by_half_orders(spectrum: Spectrum, way: Literal["forward", "backward"]) -> Complex:
    """One turning vector of the orders 1/2, 1, ... HIGHEST [..., order], whichever there are."""
    there: Complex = getattr(spectrum, way)
    out = np.zeros((*there.shape[:-1], 2 * HIGHEST), complex)
    for index, order in enumerate(2 * spectrum.orders):
        if order == round(order) <= 2 * HIGHEST:
            out[..., round(order) - 1] = there[..., index]
    return out


def greatest(forward: complex, backward: complex) -> float:
    """The greatest value over a turn of two vectors that turn with and against the crankshaft."""
    size = abs(forward) + abs(backward)
    return Size(size, of_order(np.array(forward), np.array(backward))) if are_kept() else size


def size(spectrum: Spectrum, order: float) -> float:
    """The greatest value of one order over a turn."""
    chosen = spectra.selected(spectrum, [order])
    return greatest(complex(chosen.forward[0]), complex(chosen.backward[0]))


def peak(spectrum: Spectrum) -> Peak:
    """The peak of all orders together."""
    return tops(spectrum[None])[0]


def tops(spectrum: Spectrum) -> list[Peak]:
    """The peak of every vector of a batch [vector, n]."""
    found = spectra.tops(spectrum)
    sizes = peaks(spectrum, np.array([top.value for top in found]))
    return [top._replace(value=size) for top, size in zip(found, sizes, strict=True)]


def peaks(spectrum: Spectrum, values: Real) -> list[float]:
    """The peaks `values` [vector] of a batch [vector, n], with what bounds them."""
    if not are_kept():
        return values.tolist()
    return [Size(*each) for each in zip(values.tolist(), of_peak(spectrum), strict=True)]


def highest(spectrum: Spectrum) -> float:
    """The highest peak of a batch [vector, n], as along a shaft."""
    value = float(spectra.peaks(spectrum).max(initial=0.0))
    return Size(value, of_peak(spectrum).reshape(-1, 2)[::3]) if are_kept() else value
