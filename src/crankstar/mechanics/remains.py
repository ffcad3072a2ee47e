"""What remains of a balance: what counts as zero, as negligible, as minor, which orders are shown.

Tables, verdict, page, charts and report decide by these functions and numbers alone.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from crankstar import spectra
from crankstar.language.numbers import NEGLIGIBLE
from crankstar.mechanics.balance import Balance, total
from crankstar.mechanics.excitation import rolling_moment
from crankstar.spectra import Real, Spectrum

OPTIMISED = 1e-6
"""Share of what the parts push below which a sum is zero where an optimiser chose the weights."""
SOLVED = 1e-5
"""The same for throw angles that a solver found."""
MINOR = 0.02
"""Share of the greatest order below which an order is named by its size alone, and not drawn."""
EQUAL = 0.01
"""Vectors that differ by no more than this share are equal, as those of a Lanchester pair."""
USUAL_ORDERS = 6.0
"""The orders up to this one are shown wherever a part pushes at them."""
HIGHEST_EXPLAINED = 4.0
"""The orders up to this one have figures and derivations on a page, zero or not..."""
MOST_EXPLAINED = 4
"""...but not more of them than these."""
HIGH_ORDER = 1e-3
"""Share of the greatest order from which an order above the usual ones is shown as well."""
ROUNDED_ARM = 1e-12
"""Lever arm (m, bore pitches or crank radii) that is rounding error: no moment of a force."""


class Sums(NamedTuple):
    """The sums of an engine; what is zero beside the parts it was added up from is exactly zero."""

    force: Spectrum
    couple: Spectrum
    roll: Spectrum
    axis_moment: Spectrum
    torque: Spectrum


def summed(result: Balance) -> Sums:
    """The sums of a Balance, `roll` being the rolling moment on the block.

    >>> from crankstar.files.catalog import load
    >>> from crankstar.mechanics.balance import balance
    >>> sums = summed(balance(load("v8-cross-plane")))
    >>> float(abs(spectra.selected(sums.force, [2.0]).forward[0]))
    0.0
    """
    sums = total(result)
    force, couple, axis, twist = (weighed(result, name) for name in sums._fields)
    axis_moment = _cleared(sums.axis_moment, axis)
    torque = _cleared(sums.torque, twist)
    # the block rolls only if a moment about the axis or a torque remains
    none = not (sizes(axis_moment).any() or sizes(torque).any())
    return Sums(
        force=_cleared(sums.force, force),
        couple=_cleared(sums.couple, couple),
        roll=_cleared(rolling_moment(sums), axis + twist, none=none),
        axis_moment=axis_moment,
        torque=torque,
    )


def _cleared(whole: Spectrum, beside: Real, *, none: bool = False) -> Spectrum:
    """Zero where it is zero beside the parts of its order, or negligible beside every order.

    All of it is zero where `none` of it is to remain, or its greatest order is negligible.
    """
    kept = sizes(whole) > NEGLIGIBLE * np.maximum(beside, NEGLIGIBLE * beside.max(initial=0.0))
    kept &= not none and _is_there(whole, beside)
    return replace(whole, forward=whole.forward * kept, backward=whole.backward * kept)


def kept(size: float, *, beside: float) -> float:
    """The size of a sum, zero where it is negligible beside the sizes that it was added up from.

    >>> kept(2e-12, beside=0.04), kept(2e-3, beside=0.04)
    (0.0, 0.002)
    """
    return size if size > NEGLIGIBLE * beside else 0.0


def sizes(spectrum: Spectrum) -> Real:
    """The greatest value over a turn of each order, |forward| + |backward| [..., order]."""
    return np.abs(spectrum.forward) + np.abs(spectrum.backward)


def pushed(parts: Spectrum) -> Real:
    """What all parts push together at each order, without regard to direction."""
    return sizes(parts).sum(axis=0)


def weighed(result: Balance, name: str) -> Real:
    """What a sum is zero beside, by order: what its parts push, without regard to direction.

    Of a moment at least what the forces have on an arm that is rounding error, as where all of them
    go through the crank axis.

    >>> from crankstar.files.catalog import load
    >>> from crankstar.mechanics.balance import balance
    >>> result = balance(load("i4"))
    >>> bool(weighed(result, "axis_moment").max() > 0), remains(summed(result).axis_moment)
    (True, False)
    """
    own = pushed(getattr(result, name))
    if name == "force":
        return own
    return np.maximum(own, ROUNDED_ARM / NEGLIGIBLE * pushed(result.force))


def remains(whole: Spectrum) -> bool:
    """Whether anything of a sum of `summed` remains."""
    return bool(sizes(whole).any())


def _is_there(whole: Spectrum, beside: Real) -> bool:
    return float(sizes(whole).max(initial=0.0)) > NEGLIGIBLE * float(beside.max(initial=0.0))


def ranked(spectrum: Spectrum, orders: Sequence[float]) -> tuple[list[float], list[float]]:
    """Of these orders those that remain, the greatest first, and those that do not.

    >>> from crankstar.files.catalog import load
    >>> from crankstar.mechanics.balance import balance
    >>> ranked(summed(balance(load("i4"))).force, (1.0, 2.0, 4.0))
    ([2.0, 4.0], [1.0])
    """
    size_of = dict(zip(orders, sizes(spectra.selected(spectrum, orders)).tolist(), strict=True))
    least = NEGLIGIBLE * float(sizes(spectrum).max(initial=0.0))
    left = sorted(
        (order for order in orders if size_of[order] > least), key=lambda order: -size_of[order]
    )
    return left, [order for order in orders if size_of[order] <= least]


def orders_pushed(result: Balance) -> tuple[float, ...]:
    """The usual orders excited by any part, even if the sum is zero; at least order 1."""
    arm = ROUNDED_ARM * float(pushed(result.force).max(initial=0.0))
    greatest = {
        name: sizes(getattr(result, name)).max(axis=0, initial=0.0)
        for name in ("force", "couple", "axis_moment")
    }
    there = np.any(
        [
            row > max(NEGLIGIBLE * row.max(initial=0.0), 0.0 if name == "force" else arm)
            for name, row in greatest.items()
        ],
        axis=0,
    )
    return tuple(result.force.orders[there & (result.force.orders <= USUAL_ORDERS)].tolist()) or (
        1.0,
    )


def orders_turning(result: Balance, sums: Sums) -> tuple[float, ...]:
    """Those at which a part pushes, the usual ones at which the block rolls, and the greatest roll.

    A centred piston has no moment about the axis; the block rolls because a flywheel takes the
    torque.
    """
    rolls = np.maximum(sizes(sums.torque), sizes(sums.roll))
    usual = (sums.roll.orders <= USUAL_ORDERS) | (rolls == rolls.max(initial=0.0))
    left = (rolls > NEGLIGIBLE * rolls.max(initial=0.0)) & usual
    return tuple(sorted({*orders_pushed(result), *sums.roll.orders[left].tolist()}))


def orders_shown(result: Balance, sums: Sums) -> tuple[float, ...]:
    """The orders of a page: those at which a part pushes or the block rolls, and strong high ones.

    High ones are the only orders left of an engine with many cylinders.
    """
    high = sums.force.orders > USUAL_ORDERS
    strong = np.zeros(high.size, bool)
    for spectrum in (sums.force, sums.couple, sums.roll, result.force):
        each = sizes(spectrum).reshape(-1, high.size).max(axis=0, initial=0.0)
        strong |= (each > HIGH_ORDER * each.max(initial=0.0)) & high
    return tuple(sorted({*orders_turning(result, sums), *sums.force.orders[strong].tolist()}))


def orders_explained(result: Balance, sums: Sums) -> tuple[float, ...]:
    """The orders of the figures and derivations of a page.

    The lowest at which a part pushes, zero or not, and the greatest of force and of couple, which
    of a six in line is of order 6, and all that remains.

    >>> from crankstar.files.catalog import load
    >>> from crankstar.mechanics.balance import balance
    >>> pushed = balance(load("i6"))
    >>> orders_explained(pushed, summed(pushed))
    (1.0, 2.0, 4.0, 6.0)
    """
    usual = orders_pushed(result)
    low = [order for order in usual if order <= HIGHEST_EXPLAINED] or [usual[0]]
    greatest = [
        order
        for spectrum in (sums.force, sums.couple)
        for order in ranked(spectrum, spectrum.orders.tolist())[0][:1]
    ]
    return tuple(sorted({*low[:MOST_EXPLAINED], *greatest}))


def orders_drawn(
    result: Balance, sums: Sums, quantity: str, orders: Sequence[float], *, minor: float = MINOR
) -> tuple[float, ...]:
    """Of these orders of force or couple those worth a drawing.

    The first two if a part pushes at them, and what remains of the others unless it is minor (a
    share of the greatest); with a negative `minor` all at which a part pushes.
    """
    parts = spectra.selected(getattr(result, quantity), orders)
    floor = ROUNDED_ARM * float(pushed(result.force).max(initial=0.0))
    lengths = sizes(spectra.selected(getattr(sums, quantity), orders))
    least = minor * float(lengths.max(initial=0.0))
    return tuple(
        order
        for order, size_, share in zip(orders, lengths, pushed(parts), strict=True)
        if share > floor and (minor < 0 or order in (1.0, 2.0) or size_ > least)
    )
