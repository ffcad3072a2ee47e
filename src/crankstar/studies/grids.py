"""Engines over two of their numbers at once, as arrays.

Along each number arrays mostly follow a law (`variants`). If they do so along both, the engines at
two values a0, a1 of the first number, each with its law in the second number b, give all others:

    array(a, b) = array(a0, b) + (a - a0) / (a1 - a0) (array(a1, b) - array(a0, b)),

angles but for whole turns, and weights as vectors where the first number moves them as vectors. A
few engines, built where nobody would look for a round number, tell whether it holds. The lines at
the ends of both ranges and at nought are taken by themselves, since there weights may vanish. Where
there is no such law, the engines are taken line by line.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import product

import numpy as np

from crankstar.engine.engine import Engine
from crankstar.mechanics.mechanism import Mechanism, mechanism
from crankstar.spectra import Real
from crankstar.studies.variants import (
    ANGLES,
    FEW,
    PROBES,
    Arrays,
    Batch,
    Law,
    Make,
    Make2,
    Tell,
    agrees,
    alike,
    arrays_of,
    check_built,
    law_of,
    variants,
    with_arrays,
)

SHARES = (PROBES[0], PROBES[7])
"""Places of the two lines, as shares of the range of the first number."""
CHECKED = ((0.113, 0.871), (0.297, 0.059), (0.541, 0.937), (0.713, 0.331), (0.959, 0.643))
"""Engines that must agree with the law, as shares of both ranges."""
ROTORS = ("unbalance", "unbalance_angle")


def grid_variants(
    make: Make2,
    first: Sequence[float] | Real,
    second: Sequence[float] | Real,
    *,
    tell: Tell | None = None,
) -> tuple[Batch, ...]:
    """The engines `make(a, b)` of all pairs of values as arrays, b changing fastest.

    The row of a Batch is that of a pair among all. Raises as `variants` does.

    >>> from crankstar import load
    >>> def made(mass: float, ratio: float):
    ...     changes = {"cylinder.rotating_mass": mass, "cylinder.rod_ratio": ratio}
    ...     return load("v8-cross-plane", changes=changes)
    >>> batches = grid_variants(made, np.linspace(1, 2, 30), np.linspace(3, 4, 40))
    >>> sum(batch.rows.size for batch in batches)
    1200
    """
    values = np.asarray(first, float), np.asarray(second, float)
    counted = _Counted(make)
    inner = [_inner(own) for own in values]
    law = None
    if all(np.unique(own[kept]).size > FEW for own, kept in zip(values, inner, strict=True)):
        law = _grid_law(counted, *(own[kept] for own, kept in zip(values, inner, strict=True)))
    if law is None:
        return _line_by_line(counted, *values, tell)
    grid = np.arange(values[0].size * values[1].size).reshape(values[0].size, values[1].size)
    batches = _ruled(law, *values, grid, *inner)
    for place in np.flatnonzero(~inner[0]):
        line = variants(_over_second(counted, float(values[0][place])), values[1])
        batches += [Batch(grid[place, batch.rows], batch.machine) for batch in line]
    rows = np.flatnonzero(inner[0])
    for place in np.flatnonzero(~inner[1]):
        line = variants(_over_first(counted, float(values[1][place])), values[0][rows])
        batches += [Batch(grid[rows[batch.rows], place], batch.machine) for batch in line]
    return tuple(batches)


class _Counted:
    """Builds engines, up to so many."""

    def __init__(self, make: Make2) -> None:
        self._make, self._count = make, 0

    def __call__(self, a: float, b: float) -> Engine:
        self._count += 1
        check_built(self._count)
        return self._make(a, b)


def _inner(values: Real) -> np.ndarray:
    """Which values are neither an end of their range nor nought."""
    return (values != values.min()) & (values != values.max()) & (values != 0)


def _over_first(make: Make2, b: float) -> Make:
    """The engine over the first number at one value of the second."""
    return lambda a: make(a, b)


def _over_second(make: Make2, a: float) -> Make:
    """The engine over the second number at one value of the first."""
    return lambda b: make(a, b)


@dataclass(frozen=True)
class _GridLaw:
    """Arrays over two numbers: `along` the first, and along the second at two `places` of it."""

    along: Law
    ends: tuple[Law, Law]
    places: tuple[float, float]

    def at(self, a: Real, b: Real) -> Mechanism:
        """The engines of these pairs of numbers [n]."""
        span = self.places[1] - self.places[0]
        share = ((a - self.places[0]) / span)[:, None]
        low, high = (arrays_of(end.at(b)) for end in self.ends)
        out: Arrays = {}
        for name, start in low.items():
            rate = self.along.slope[name]
            change = high[name] - start
            if name in ANGLES:
                change = change + 2 * np.pi * np.round((rate * span - change) / (2 * np.pi))
            moves = np.any(rate) or start.ndim > 1
            out[name] = start + share * change if moves else start
        vectors = self.along.vectors
        if np.any(vectors):
            ends = [
                each["unbalance"] * np.exp(1j * each["unbalance_angle"]) for each in (low, high)
            ]
            vector = ends[0] + share * (ends[1] - ends[0])
            out["unbalance"] = np.where(vectors, np.abs(vector), out["unbalance"])
            out["unbalance_angle"] = np.where(vectors, np.angle(vector), out["unbalance_angle"])
        return with_arrays(self.along.machine, out, a.size)

    def moving(self, which: int) -> frozenset[str]:
        """The arrays that the first number (0) or the second (1) changes."""
        laws = (self.along,) if which == 0 else self.ends
        names = {name for law in laws for name, rate in law.slope.items() if np.any(rate)}
        return frozenset(names | ({*ROTORS} if "vector" in names else set()))

    def line(self, a: Real, b: Real, *, along: int) -> Mechanism:
        """Engines of which one number is the same: what it alone changes has no axis."""
        machine = self.at(a, b)
        still = frozenset(arrays_of(machine)) - self.moving(along) - {*ROTORS}
        arrays = {
            name: values[0] if name in still and values.ndim > 1 else values
            for name, values in arrays_of(machine).items()
        }
        return with_arrays(machine, arrays, a.size)


def _grid_law(make: Make2, first: Real, second: Real) -> _GridLaw | None:
    """The law of the engines within both ranges, None where there is none."""
    (low_a, span_a), (low_b, span_b) = (
        (float(values.min()), float(np.ptp(values))) for values in (first, second)
    )

    def _built(a: float, b: float) -> Mechanism:
        return mechanism(make(a, b))

    places = (low_a + SHARES[0] * span_a, low_a + SHARES[1] * span_a)
    middle = low_b + SHARES[0] * span_b
    try:
        probes = [
            {a: _built(a, middle) for a in (low_a + share * span_a for share in PROBES)},
            *({b: _built(a, b) for b in (low_b + p * span_b for p in PROBES)} for a in places),
        ]
    except ValueError:
        return None
    laws = [law_of(each) for each in probes]
    for law, each in zip(laws, probes, strict=True):
        if law is None or not all(agrees(law, x, machine) for x, machine in each.items()):
            return None
    along, *ends = (law for law in laws if law is not None)
    law = _GridLaw(along, (ends[0], ends[1]), places)
    motion = any(name.startswith("links.") for name in law.moving(0) | law.moving(1))
    if motion and any(master >= 0 for master in along.machine.links.master):
        return None  # whether a slave rod reaches its cylinder is seen only engine by engine
    for share_a, share_b in (*CHECKED, *product((0.0, 1.0), repeat=2)):
        a, b = low_a + share_a * span_a, low_b + share_b * span_b
        if not alike(law.at(np.array([a]), np.array([b])), _built(a, b), beside=along.start):
            return None
    return law


def _ruled(
    law: _GridLaw, first: Real, second: Real, grid: np.ndarray, *inner: np.ndarray
) -> list[Batch]:
    """The engines within both ranges: in one batch, or where that spares motion, line by line."""
    rows, columns = (np.flatnonzero(kept) for kept in inner)
    moved = [any(name.startswith("links.") for name in law.moving(which)) for which in (0, 1)]
    if moved[0] == moved[1]:
        pairs = grid[np.ix_(rows, columns)].ravel()
        a, b = np.repeat(first[rows], columns.size), np.tile(second[columns], rows.size)
        return [Batch(pairs, law.at(a, b))]
    if moved[0]:
        return [
            Batch(
                grid[row, columns],
                law.line(np.full(columns.size, first[row]), second[columns], along=1),
            )
            for row in rows
        ]
    return [
        Batch(
            grid[rows, column], law.line(first[rows], np.full(rows.size, second[column]), along=0)
        )
        for column in columns
    ]


def _line_by_line(make: Make2, first: Real, second: Real, tell: Tell | None) -> tuple[Batch, ...]:
    """The engines along the number with more values, for one value of the other after the other."""
    grid = np.arange(first.size * second.size).reshape(first.size, second.size)
    batches: list[Batch] = []
    swap = second.size < first.size
    lines = second if swap else first
    for index, value in enumerate(lines.tolist()):
        if swap:
            line, rows = variants(_over_first(make, value), first), grid[:, index]
        else:
            line, rows = variants(_over_second(make, value), second), grid[index]
        batches += [Batch(rows[batch.rows], batch.machine) for batch in line]
        if tell is not None:
            tell(rows.size * (index + 1), grid.size)
    return tuple(batches)
