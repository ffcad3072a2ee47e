"""The arrows of inertia force and couple on a drawn engine, in shares of the longest of its kind.

A couple is a pair of forces at both ends of the engine, in its plane. The longest arrow stands for
the greatest value over the whole cycle; a sum that is small beside a cylinder's greatest force (or
couple) is drawn small, and a rounding error not at all. It is the rule of the page.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from crankstar import spectra
from crankstar.engine.engine import Engine
from crankstar.mechanics import remains
from crankstar.mechanics.balance import balance, of_parts
from crankstar.page.proportions import proportions
from crankstar.page.records import Scene
from crankstar.page.shown_units import units_of
from crankstar.pictures.motions import turns_of
from crankstar.spectra import Complex, Spectrum

Kind = Literal["force", "couple"]
KINDS: tuple[Kind, ...] = ("force", "couple")
ROUNDING, LITTLE = 1e-9, 0.1
"""Shares of a cylinder's greatest force (or couple): a rounding error, and a little sum."""
STEPS = 180
"""Crank angles of a turn at which the greatest value is looked for."""


class Arrow(NamedTuple):
    """An arrow at (x, y, z); its vector `up + i right` [angle] in shares of the longest."""

    kind: Kind
    place: tuple[float, float, float]
    vector: Complex


class Load(NamedTuple):
    """Arrows at some crank angles; what the longest of each kind stands for, with its unit."""

    arrows: tuple[Arrow, ...] = ()
    values: tuple[tuple[Kind, float, str], ...] = ()


def load_of(
    engine: Engine,
    drawn: Scene,
    theta: ArrayLike,
    *,
    kinds: Sequence[Kind] = KINDS,
    orders: Sequence[float] | None = None,
) -> Load:
    """The arrows of these kinds and orders (None: all that are not negligible) at crank angles."""
    if not kinds:
        return Load()
    result = balance(engine, speed=engine.speed)
    sums = remains.summed(result)
    shown = remains.orders_shown(result, sums)
    chosen = [order for order in shown if orders is None or _among(order, orders)]
    grid = np.linspace(0, 2 * np.pi * turns_of(engine), STEPS * turns_of(engine), endpoint=False)

    def greatest(whole: Spectrum) -> float:
        return float(np.abs(spectra.value(spectra.selected(whole, chosen), grid)).max(initial=0.0))

    along = proportions(engine).along
    alone, arm = 0.0, 0.0
    for cylinder in engine.cylinders:
        alone = max(alone, greatest(of_parts(result, cylinder=cylinder.number).force))
        arm = max(arm, abs(cylinder.z - result.reference.z))
    units, _scaling = units_of(engine, result, sums)
    x, y = (drawn.shafts[0].right, drawn.shafts[0].up) if drawn.shafts else (0.0, 0.0)
    ends = {
        "force": ((result.reference.z * along, 1),),
        "couple": ((drawn.high[2], 1), (drawn.low[2], -1)),
    }
    floors = {"force": alone, "couple": alone * arm}
    labels = {
        "force": (units.force_factor, units.force),
        "couple": (units.couple_factor, units.couple),
    }
    arrows: list[Arrow] = []
    values: list[tuple[Kind, float, str]] = []
    for kind in kinds:
        whole = spectra.selected(getattr(sums, kind), chosen)
        most = greatest(whole)
        if most <= ROUNDING * floors[kind]:
            continue
        longest = max(most, LITTLE * floors[kind])
        now = np.atleast_1d(spectra.value(whole, theta)) / longest
        arrows += [Arrow(kind, (x, y, z), side * now) for z, side in ends[kind]]
        factor, unit = labels[kind]
        values.append((kind, longest * factor, unit))
    return Load(tuple(arrows), tuple(values))


def absent(engine: Engine, kinds: Sequence[Kind], orders: Sequence[float]) -> list[float]:
    """Of these orders those of which nothing of these kinds remains.

    >>> from crankstar.files.catalog import load
    >>> absent(load("i4"), KINDS, [1.0, 2.0, 999.0])
    [1.0, 999.0]
    """
    sums = remains.summed(balance(engine, speed=engine.speed))
    left = {order for kind in kinds for order in remains.ranked(getattr(sums, kind), orders)[0]}
    return [order for order in orders if order not in left]


def _among(order: float, orders: Sequence[float]) -> bool:
    return any(abs(order - other) < 1e-6 for other in orders)


def round_value(value: float) -> float:
    """The greatest of 1, 2, 5, 10, ... that is not above a value.

    >>> round_value(37.0), round_value(0.6)
    (20.0, 0.5)
    """
    power = 10.0 ** np.floor(np.log10(value))
    step = value / power
    return float(power * (5 if step >= 5 else 2 if step >= 2 else 1))
