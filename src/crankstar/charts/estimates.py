"""Estimated engines in figures: the ranges of what is drawn, and a line that says it is estimated.

`over_ranges` names the engines over whose ranges figures are drawn in a context, as `drawn_on`
names their room. A force, couple or moment at a crank angle is linear in each estimated value while
the others are held, so that it lies between its values at the corners; its peak and the semi-axes
of its path are bounded as in `tables.number_ranges`.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager
from contextvars import ContextVar

from crankstar import spectra
from crankstar.analysis.document import Ranged
from crankstar.engine.engine import Engine
from crankstar.files.box import Spread
from crankstar.language.messages import _
from crankstar.mechanics import bounds
from crankstar.mechanics.bounds import bounds_kept
from crankstar.spectra import Spectrum
from crankstar.tables.cells import rough
from crankstar.tables.number_ranges import number_range
from crankstar.tables.ranges import estimated_paths

_SPREADS: ContextVar[tuple[Spread, ...]] = ContextVar("spreads", default=())


@contextmanager
def over_ranges(spreads: Iterable[Spread | None]) -> Iterator[None]:
    """Within it, figures of the engines of these spreads show their ranges."""
    token = _SPREADS.set(tuple(spread for spread in spreads if spread is not None))
    try:
        yield
    finally:
        _SPREADS.reset(token)


def ends_of(engine: Engine) -> tuple[Engine, ...]:
    """The engine in the middle of its ranges and those at their corners; none without ranges."""
    for spread in _SPREADS.get():
        if spread.engine is engine:
            return (spread.middle, *spread.corners)
    return ()


def estimate_lines(engines: Sequence[Engine], *, drawn: str = "") -> list[str]:
    """The line under the title of a figure of estimated engines; `drawn` says how its ranges are.

    >>> from crankstar.files.catalog import load
    >>> estimate_lines([load("i4")])
    []
    """
    if not any(map(estimated_paths, engines)):
        return []
    with_ranges = drawn and any(map(ends_of, engines))
    return [drawn if with_ranges else _("Estimated masses or lengths.")]


def size_range(own: complex, others: Sequence[complex]) -> tuple[float, float] | None:
    """The lowest and the highest of a size, or of an amplitude's; None where it is known.

    A size is convex in each estimated value, an amplitude linear.
    """
    ranged = number_range([own, *others]) if others else own
    return (ranged.low, ranged.high) if isinstance(ranged, Ranged) else None


def peak_range(spectrum: Spectrum, others: Sequence[Spectrum]) -> tuple[float, float] | None:
    """The lowest and the highest peak over a turn; None where it is known."""
    with bounds_kept():
        own, *ends = [bounds.peak(each).value for each in (spectrum, *others)]
    return size_range(own, ends)


def range_text(ends: tuple[float, float] | None) -> str:
    """A range behind a number, as ` (9 to 16)`; empty where there is none."""
    if ends is None:
        return ""
    low, high = map(rough, ends)
    return " " + _("({low} to {high})", low=low, high=high)


def length_ranges(spectrum: Spectrum, others: Sequence[Spectrum]) -> list[tuple[float, float]]:
    """The range of the greatest length of each order of a spectrum, none where there is none."""
    if not others:
        return []
    with bounds_kept():
        sizes = [
            [bounds.size(each, order) for each in (spectrum, *others)] for order in spectrum.orders
        ]
    return [size_range(own, ends) or (float(own), float(own)) for own, *ends in sizes]


def axis_ranges(spectrum: Spectrum, others: Sequence[Spectrum]) -> list[tuple[float, float] | None]:
    """The ranges of the semi-axes |f| + |b| and ||f| - |b|| of the ellipse of the first order."""
    if not others:
        return []
    own, *ends = [spectra.selected(each, spectrum.orders[:1]) for each in (spectrum, *others)]
    sides: list[tuple[float, float]] = []
    for side in ("forward", "backward"):
        waves = [complex(getattr(each, side)[0]) for each in (own, *ends)]
        sides.append(size_range(waves[0], waves[1:]) or (abs(waves[0]), abs(waves[0])))
    (low, high), (least, most) = sides
    minor = (max(0.0, low - most, least - high), max(high - least, most - low))
    major = length_ranges(spectrum, others)[0]
    return [ends if ends[1] > ends[0] else None for ends in (major, minor)]
