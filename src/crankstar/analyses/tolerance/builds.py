"""Engines built at random within their tolerances: the distribution of each order's amplitude.

Every error is drawn by itself, normal with a standard deviation of a third of the bound (of 370
parts one lies outside), or uniform between the bounds. Masses, angles and places enter exactly.
Errors of the lengths that shape the motion enter to first order where they are small, which misses
by their square; where one is large, every engine's motion is worked out. Bearing loads are of first
order in all errors.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

import numpy as np

from crankstar.analyses.tolerance.error_sources import ErrorSource
from crankstar.analyses.tolerance.linear_law import (
    Linear,
    Vectors,
    amplitudes,
    mean_square,
    named,
    sums_with,
)
from crankstar.analyses.tolerance.question import Distribution
from crankstar.analyses.tolerance.unit_parts import EXACT, parts_of
from crankstar.engine.engine import Engine
from crankstar.mechanics.balance import Scale
from crankstar.mechanics.excitation import Reference
from crankstar.mechanics.mechanism import Mechanism, mechanism
from crankstar.spectra import Real
from crankstar.studies.variants import ANGLES

DEVIATION: dict[Distribution, float] = {"normal": 1 / 3, "uniform": 3**-0.5}
"""Standard deviation of an error as a share of its bound."""
LARGE = 0.01
"""Share of the crank radius, or radians, from which errors of the motion are no longer linear."""
REACH = ("crank_radius", "rod_length", "offset")
"""The arrays by which a plain rod reaches its cylinder."""
TWICE, CLEAR = 2.0, 1.05
"""Bounds to which errors are taken, and how much longer a rod must then be than what it spans."""
BLOCK = 512
"""Engines worked out at once: so few stay in the cache, and are multiplied by one thread."""
Tell = Callable[[int, int], object]


class Builds(NamedTuple):
    """Random engines: the amplitude of each signal [engine, order], and the mean square found."""

    amplitudes: dict[str, Real]
    mean_square: dict[str, Real]
    """Of the deviation from the nominal engine [order], as `linear_law.mean_square` counts it."""


class _Plan(NamedTuple):
    """What is the same for all blocks: what is exact, what is of first order, and which errors."""

    exact: Callable[[Real], dict[str, Vectors]]
    places: list[int]
    first_order: list[int]
    lines: dict[str, Linear]
    signals: Sequence[str]
    sense: int


def builds(
    engine: Engine,
    errors: Sequence[ErrorSource],
    lines: dict[str, Linear],
    *,
    signals: Sequence[str],
    orders: Sequence[float],
    reference: Reference,
    scale: Scale,
    count: int,
    seed: int,
    distribution: Distribution = "normal",
    tell: Tell | None = None,
) -> Builds:
    """`count` engines; the same `seed` gives the same ones. `lines` is their linear law."""
    machine = mechanism(engine)
    how: dict[str, Any] = {"orders": orders, "reference": reference, "scale": scale}
    plan = _plan(machine, errors, lines, signals, how)
    random = np.random.default_rng(seed)
    bounds = np.array([error.bound for error in errors])
    out = {name: np.empty((count, len(orders))) for name in signals}
    squares = {name: np.zeros(len(orders)) for name in signals}
    for start in range(0, count, BLOCK):
        drawn = _drawn(random, min(BLOCK, count - start), bounds, distribution)
        for name, (sizes, square) in _block(plan, drawn).items():
            out[name][start : start + len(sizes)] = sizes
            squares[name] += square
        if tell is not None:
            tell(min(start + BLOCK, count), count)
    return Builds(out, {name: total / count for name, total in squares.items()})


def _plan(
    machine: Mechanism,
    errors: Sequence[ErrorSource],
    lines: dict[str, Linear],
    signals: Sequence[str],
    how: dict[str, Any],
) -> _Plan:
    """Which errors are exact, and how."""
    sense = machine.sense
    every = [*range(len(errors))]
    if any(_large(error, machine) for error in errors):

        def whole(sizes: Real) -> dict[str, Vectors]:
            return sums_with(machine, errors, sizes, **how)

        return _Plan(whole, every, [], lines, signals, sense)
    places = [place for place in every if EXACT.issuperset(errors[place].moves)]
    rest = [place for place in every if place not in places]
    parts = parts_of(machine, [errors[place] for place in places], **how)
    return _Plan(parts.sums, places, rest, lines, signals, sense)


def _large(error: ErrorSource, machine: Mechanism) -> bool:
    """Whether an error of the motion is too large for a straight law."""
    radius = float(np.min(machine.links.crank_radius))
    sizes = (
        error.bound * float(np.abs(change).max(initial=0.0)) / (1.0 if name in ANGLES else radius)
        for name, change in error.moves.items()
        if name.startswith("links.") or name == "bearing"
    )
    return max(sizes, default=0.0) > LARGE


def _drawn(
    random: np.random.Generator, count: int, bounds: Real, distribution: Distribution
) -> Real:
    """Errors [engine, error]."""
    if distribution == "uniform":
        return random.uniform(-1.0, 1.0, (count, bounds.size)) * bounds
    return random.standard_normal((count, bounds.size)) * (DEVIATION["normal"] * bounds)


def _block(plan: _Plan, sizes: Real) -> dict[str, tuple[Real, Real]]:
    """Amplitudes of one block of engines, and the sum of the squares of their deviations."""
    sums = plan.exact(sizes[:, plan.places])
    if plan.first_order:
        rest = sizes[:, plan.first_order]
        sums = {name: _added(own, plan, rest, name) for name, own in sums.items()}
    for name in plan.lines.keys() - sums.keys():  # bearing loads
        nominal, rates = plan.lines[name]
        sums[name] = Vectors(*(a + sizes @ b for a, b in zip(nominal, rates, strict=True)))
    off = {
        name: Vectors(*(a - b for a, b in zip(own, plan.lines[name].nominal, strict=True)))
        for name, own in sums.items()
    }
    return {
        name: (
            amplitudes(named(sums, name, sense=plan.sense)),
            mean_square(named(off, name, sense=plan.sense)).sum(axis=0),
        )
        for name in plan.signals
    }


def _added(own: Vectors, plan: _Plan, rest: Real, name: str) -> Vectors:
    """Sums of a block with the errors that count to first order."""
    rates = plan.lines[name].rates
    pairs = zip(own, rates, strict=True)
    return Vectors(*(part + rest @ rate[plan.first_order] for part, rate in pairs))


def out_of_reach(machine: Mechanism, errors: Sequence[ErrorSource]) -> int | None:
    """The row of a plain rod that hardly reaches its cylinder, or whose stroke vanishes.

    With all errors of the motion at twice their bounds, about the most that is ever drawn.
    """
    links = machine.links
    moved = {name: np.zeros_like(getattr(links, name)) for name in REACH}
    for error in errors:
        for name in REACH:
            change = error.moves.get(f"links.{name}")
            if change is not None:
                moved[name] = moved[name] + TWICE * error.bound * np.abs(change)
    longest = links.crank_radius + moved["crank_radius"] + np.abs(links.offset) + moved["offset"]
    short = links.rod_length - moved["rod_length"] < CLEAR * longest
    short = short | (links.crank_radius <= moved["crank_radius"])
    rows = np.flatnonzero(short & (np.array(links.master) < 0) & (sum(moved.values()) > 0))
    return int(rows[0]) if rows.size else None
