"""The values of a range at which the figures of an answer are tried, and the extremes in between.

Between the ends of a range a figure may be greater or smaller than at both. Tried are

* both ends, and the value as it is where it lies between them, else their middle; where an end is
  no engine, the last value towards it that is one, by halving to NEAR of the range;
* the values at which a natural frequency meets an order of the speeds of the answer, where it does
  so at none of these: w_i(x) = n W, with w_i by eigenvalues at five values of the range alone, and
  one step of the secant;
* for an answer that resonates, the quarters too, where the figure moves by more than a per cent;
* for the figure that moves most, the vertex of a parabola through its extreme and the neighbours,
  up to ROUNDS times: of f^2 for the minimum, exact for the absolute value of what is linear in x,
  and of 1 / f^2 for the maximum, exact for a single resonance in its stiffness; where that promises
  nothing, the middle of a wide gap beside the extreme;
* for that figure, both sides of a jump, to NEAR of the range, where its slope between two of these
  values is far from those between the others.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from crankstar.engine.engine import Engine
from crankstar.language.faults import EngineError
from crankstar.language.messages import MessageError
from crankstar.spectra import Real

Figure = tuple[str, float | None]
"""A quantity (`force`, `couple`, `roll`) and an order; None where the quantity has no orders."""
Figures = Mapping[Figure, float]
ROUNDS = 3
"""Vertices that are tried at most, for the minimum and for the maximum."""
MOST_MEETINGS = 12
"""Values at which a natural frequency meets an order, at most; of more, evenly chosen ones."""
POINTS = 3
"""Of a parabola."""
PARTS = 5
"""Values at which natural frequencies are computed."""
ASIDE = 0.15
"""Share of the range by which the value as it is must lie off both ends to stand for the middle."""
CLOSE = 0.01
"""Share of the distance of its neighbours by which a vertex must lie off a value tried before."""
GAIN = 0.01
"""Share of the greatest by which a vertex must promise more than is known."""
WIDE = 0.2
"""Share of the range from which a gap beside an extreme is divided where no parabola has one."""
NEAR = 0.01
"""Share of the range within which the last value that makes an engine is known."""
SMALL_JUMP, STEEP = 0.02, 1.5
"""Of the greatest, what a jump is at least; and how much its slope differs, of those elsewhere."""
SMOOTH = 0.5
"""The change in one half over that in the other from which a curve does not jump between them."""
SAME = 1e-6
"""Share by which natural frequencies must differ at both ends for anything to meet in between."""


@dataclass(frozen=True)
class Tuning:
    """Natural frequencies (rad/s, from low to high) of an engine, and the orders that meet them.

    `speeds` are the lowest and the highest of an answer, rad/s.
    """

    natural: Callable[[Engine], Sequence[float]]
    orders: Sequence[float]
    speeds: tuple[float, float]


class Tried:
    """The figures of an answer at values of a range, more and more of them.

    `at` gives the engine with a value, `now` the figures as they are, at `value` if that is inside.
    Where an end is no engine, `ends` has the last value that is one instead, and `beyond` says of
    what end there is none and why. Raises EngineError or MessageError where no other value makes
    one.
    """

    def __init__(
        self,
        *,
        at: Callable[[float], Engine],
        figures: Callable[[Engine], Figures],
        now: Figures,
        ends: tuple[float, float],
        value: float | None,
    ) -> None:
        self._at, self._figures, self.ends = at, figures, ends
        low, high = ends
        self.known: dict[float, Figures] = {}
        self.beyond: list[tuple[float, str]] = []
        if value is not None and low <= value <= high:
            self.known[value] = now
        failed: dict[float, EngineError | MessageError] = {}
        for end in dict.fromkeys(ends):
            if end not in self.known:
                try:
                    self.known[end] = figures(at(end))
                except (EngineError, MessageError) as error:
                    failed[end] = error
        for end, error in failed.items():
            if not self.known:
                raise error
            self.beyond.append((end, _why(error)))
            self._halve(min(self.known, key=lambda x: abs(x - end)), end)
            if len(self.known) == 1:
                raise error
        self.ends = low, high = min(self.known), max(self.known)
        aside = ASIDE * (high - low)
        if low < high and not any(low + aside < x < high - aside for x in self.known):
            self.add([(low + high) / 2])

    def _halve(self, good: float, bad: float) -> None:
        """Try values between one that makes an engine and one that makes none, to NEAR."""
        near = NEAR * (self.ends[1] - self.ends[0])
        while abs(bad - good) > near:
            middle = (good + bad) / 2
            self.add([middle])
            good, bad = (middle, bad) if middle in self.known else (good, middle)

    def add(self, values: Iterable[float]) -> None:
        """Try more values; one that makes no engine is left out."""
        for value in values:
            if value not in self.known:
                with suppress(EngineError, MessageError):
                    self.known[value] = self._figures(self._at(value))

    def add_quarters(self) -> None:
        """Try the quarters of the range, but not beside a value that is known."""
        low, high = self.ends
        near = 0.5 * ASIDE * (high - low)
        quarters = (low + share * (high - low) for share in (0.25, 0.75))
        self.add(own for own in quarters if all(abs(own - x) > near for x in self.known))

    def add_meetings(self, tunings: Sequence[Tuning]) -> None:
        """Try the values at which a natural frequency meets an order in between."""
        found = [value for tuning in tunings for value in self._meetings(tuning)]
        low, high = self.ends
        found = sorted({round(each / (high - low), 4): each for each in found}.values())
        if len(found) > MOST_MEETINGS:
            chosen = np.linspace(0, len(found) - 1, MOST_MEETINGS).round().astype(int)
            found = [found[number] for number in chosen]
        self.add(found)

    def _meetings(self, tuning: Tuning) -> list[float]:
        """Values at which a mode passes over all speeds of an order at once."""
        values = np.linspace(*self.ends, PARTS)

        def natural(value: float) -> Real:
            return np.asarray(tuning.natural(self._at(value)), float)

        edges = [natural(self.ends[0]), natural(self.ends[1])]
        if edges[0].shape != edges[1].shape or np.allclose(*edges, rtol=SAME, atol=0.0):
            return []
        try:
            rows = [edges[0], *map(natural, values[1:-1].tolist()), edges[1]]
        except (EngineError, MessageError):
            return []
        least, most = tuning.speeds
        out: list[float] = []
        for (x, before), (y, after) in pairwise(zip(values.tolist(), rows, strict=True)):
            for order in tuning.orders:
                below = np.minimum(before, after) < order * least
                over = np.maximum(before, after) > order * most
                for mode in np.nonzero(below & over)[0].tolist():
                    goal = order * (least + most) / 2
                    out.append(_crossing(natural, mode, goal, (x, before[mode]), (y, after[mode])))
        return out

    def sizes(self, key: Figure) -> list[tuple[float, float]]:
        """The values tried, ascending, each with one figure."""
        return [(x, self.known[x].get(key, 0.0)) for x in sorted(self.known)]

    def add_extremes(self, key: Figure, *, top: float) -> None:
        """Try where a figure may have its minimum and its maximum; `top` is the greatest."""
        for highest in (True, False):
            for _round in range(ROUNDS):
                sizes = self.sizes(key)
                more = _vertex(sizes, highest=highest, top=top)
                more = _gap(sizes, highest=highest) if more is None else more
                self.add([] if more is None else [more])
                if len(self.known) == len(sizes):
                    break

    def add_jump(self, key: Figure, *, top: float) -> None:
        """Try both sides of a jump of a figure, as where another assumption is made beyond it.

        Where between two values that were tried its slope is far from those elsewhere, the half
        with the jump is halved again; a curve that is only steep there has it in both halves.
        """
        sizes = self.sizes(key)
        if len(sizes) < POINTS:
            return
        x, f = np.array(sizes).T
        slopes = np.diff(f) / np.diff(x)
        ordered = np.sort(slopes)
        middle = (ordered[(slopes.size - 1) // 2] + ordered[slopes.size // 2]) / 2
        apart = np.abs(slopes - middle)  # np.median would load masked arrays
        at = int(np.argmax(apart))
        others = np.abs(np.delete(slopes, at))
        if abs(f[at + 1] - f[at]) < SMALL_JUMP * top or apart[at] < STEEP * others.max():
            return
        (a, before), (b, after) = sizes[at], sizes[at + 1]
        while b - a > NEAR * (x[-1] - x[0]):
            middle = (a + b) / 2
            self.add([middle])
            if middle not in self.known:
                return
            here = self.known[middle].get(key, 0.0)
            left, right = abs(here - before), abs(after - here)
            if min(left, right) > SMOOTH * max(left, right):
                return
            if left > right:
                b, after = middle, here
            else:
                a, before = middle, here


def _why(error: EngineError | MessageError) -> str:
    """The first reason why a value makes no engine, without a full stop."""
    return str(error).partition("\n")[0].rstrip(".。")


def _crossing(
    natural: Callable[[float], Real],
    mode: int,
    goal: float,
    first: tuple[float, float],
    second: tuple[float, float],
) -> float:
    """Where a natural frequency is `goal`, between two values of which it is known."""

    def chord(one: tuple[float, float], other: tuple[float, float]) -> float:
        (x, low), (y, high) = one, other
        return x + (y - x) * (goal**2 - low**2) / (high**2 - low**2)

    between = chord(first, second)
    own = float(natural(between)[mode])
    if own == goal:
        return between
    far = first if (first[1] - goal) * (own - goal) < 0 else second
    return chord((between, own), far)


def _gap(sizes: Sequence[tuple[float, float]], *, highest: bool) -> float | None:
    """The middle of the wider gap beside an extreme inside; None where it is narrow already."""
    own = [size for _x, size in sizes]
    best = int(np.argmax(own) if highest else np.argmin(own))
    if not 0 < best < len(sizes) - 1:
        return None
    x = [value for value, _size in sizes]
    width, first = max((x[n + 1] - x[n], n) for n in (best - 1, best))
    return (x[first] + x[first + 1]) / 2 if width > WIDE * (x[-1] - x[0]) else None


def _vertex(sizes: Sequence[tuple[float, float]], *, highest: bool, top: float) -> float | None:
    """The vertex of a parabola about the extreme of a figure; None where it promises nothing."""
    if len(sizes) < POINTS:
        return None
    own = [size for _x, size in sizes]
    best = int(np.argmax(own) if highest else np.argmin(own))
    first = min(max(best - 1, 0), len(sizes) - POINTS)
    x, f = np.array(sizes[first : first + POINTS]).T
    if highest and not (f > 0).all():
        return None
    unit = (x - x[0]) / (x[2] - x[0])
    a, b, c = np.polyfit(unit, f**-2.0 if highest else f**2, 2)
    if a <= 0:
        return None
    where = -b / (2 * a)
    if not 0 < where < 1 or np.abs(unit - where).min() < CLOSE:
        return None
    there = c - b**2 / (4 * a)
    if highest:
        gain = np.inf if there <= 0 else there**-0.5 - max(own)
    else:
        gain = abs(min(own)) - max(there, 0.0) ** 0.5
    return float(x[0] + where * (x[2] - x[0])) if gain > GAIN * top else None
