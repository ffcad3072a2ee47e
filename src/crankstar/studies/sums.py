"""The sums of batches of engines: worked out in blocks, over speeds, over closed ranges."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from crankstar import spectra
from crankstar.engine import motion
from crankstar.mechanics.balance import Scale
from crankstar.mechanics.batches import totals
from crankstar.mechanics.excitation import Reference, Totals, part_spectra
from crankstar.mechanics.mechanism import Mechanism
from crankstar.spectra import Real, Spectrum
from crankstar.studies.variants import Batch, SweepError, picked

GREATEST_CELLS = 3_000_000
"""Values times orders: half a gigabyte of vectors."""
GREATEST_WORK = 200_000_000
"""Values times orders times parts: some ten seconds."""
GREATEST_ORDER = 1000


class Group(NamedTuple):
    """Variants of the same orders: their places among all values [row] and sums [row, order]."""

    rows: np.ndarray
    sums: Totals


def sums_of(
    batches: Sequence[Batch],
    *,
    orders: Sequence[float] | None,
    reference: Reference,
    scale: Scale,
    whole: int,
) -> tuple[Group, ...]:
    """The sums of the engines of each batch, of `whole` values in all. Raises SweepError.

    Batches of the same orders are one Group.
    """
    if orders is not None and not (
        len(orders) and all(0 < order <= GREATEST_ORDER for order in orders)
    ):
        raise SweepError(
            "the orders are not possible; give crank orders above 0 up to {most}, or none",
            most=GREATEST_ORDER,
        )
    count = sum(batch.rows.size for batch in batches)
    groups = [
        Group(
            batch.rows,
            _sums(batch.machine, batch.rows.size, orders, reference, scale, (count, whole)),
        )
        for batch in batches
    ]
    return _merged(groups)


def _sums(
    machine: Mechanism,
    count: int,
    orders: Sequence[float] | None,
    point: Reference,
    scale: Scale,
    wholes: tuple[int, int],
) -> Totals:
    """The sums of a batch [row, order], in blocks that fit the memory near the processor."""
    some = picked(machine, np.unique(np.linspace(0, count - 1, 9).astype(int)))
    try:
        wanted = part_spectra(some).force.orders.tolist() if orders is None else sorted(set(orders))
        feasible(wholes[1], len(wanted), GREATEST_CELLS)
        moved = motion.resolved(some.links).piston.place
        steps = moved.shape[-1] if moved.ndim > 2 else 1
        parts = 3 * len(machine.cylinder_shaft) + len(machine.rotor_shaft)
        feasible(wholes[0], len(wanted) * parts)
        block = max(1, min(256, (1 << 18) // (parts * max(steps, len(wanted)))))
        sums = totals(machine, orders=wanted, reference=point, block=block)
    except ValueError as error:
        raise SweepError(str(error)) from None
    factors = (scale.force, scale.couple, scale.moment, scale.moment)
    return Totals(
        *(
            replace(spectra.scaled(spectrum, factor), complete=orders is None)
            for spectrum, factor in zip(sums, factors, strict=True)
        )
    )


def feasible(values: int, work: int, most: int = GREATEST_WORK) -> None:
    """Refuse so many values that each need so much work, or room."""
    if values * work > most:
        raise SweepError(
            "{count} values are too many for an engine with so many parts and orders; give at most "
            "{most} values, or name the orders",
            count=values,
            most=max(2, most // work),
        )


def _merged(groups: Sequence[Group]) -> tuple[Group, ...]:
    """Groups with the same orders put together."""
    alike: dict[tuple[float, ...], list[Group]] = {}
    for group in groups:
        force = group.sums.force
        alike.setdefault((force.sense, *force.orders.tolist()), []).append(group)
    return tuple(_together(own) if len(own) > 1 else own[0] for own in alike.values())


def _together(groups: Sequence[Group]) -> Group:
    def joined(name: str) -> Spectrum:
        every = [getattr(group.sums, name) for group in groups]
        return replace(
            every[0],
            forward=np.concatenate([spectrum.forward for spectrum in every]),
            backward=np.concatenate([spectrum.backward for spectrum in every]),
        )

    rows = np.concatenate([group.rows for group in groups])
    return Group(rows, Totals(*map(joined, Totals._fields)))


def joined(groups: Sequence[Group], count: int) -> Totals:
    """The sums of all values [n, order], over all orders that any of them has."""
    orders = np.unique(np.concatenate([group.sums.force.orders for group in groups]))
    feasible(count, orders.size, GREATEST_CELLS)

    def whole(name: str) -> Spectrum:
        forward, backward = (np.zeros((count, orders.size), complex) for _ in range(2))
        for group in groups:
            own = spectra.selected(getattr(group.sums, name), orders)
            forward[group.rows], backward[group.rows] = own.forward, own.backward
        first: Spectrum = getattr(groups[0].sums, name)
        return replace(first, orders=orders, forward=forward, backward=backward)

    return Totals(*map(whole, Totals._fields))


def over_speeds(
    groups: Sequence[Group], shares: Real, shape: tuple[int, ...], axis: int
) -> tuple[Group, ...]:
    """The sums at every speed, a share [n] of the one they are at: inertia grows with its square.

    `shape` is that of all values, with the speed along `axis`; the groups' rows are without it.
    """
    places = np.moveaxis(np.arange(int(np.prod(shape))).reshape(shape), axis, 0)
    places = places.reshape(shares.size, -1)
    factors = (shares**2)[:, None, None]

    def grown(spectrum: Spectrum) -> Spectrum:
        size = (-1, spectrum.orders.size)
        return replace(
            spectrum,
            forward=(factors * spectrum.forward).reshape(size),
            backward=(factors * spectrum.backward).reshape(size),
        )

    return tuple(
        Group(places[:, group.rows].ravel(), Totals(*map(grown, group.sums))) for group in groups
    )


def closed(
    groups: Sequence[Group], shape: tuple[int, ...], closing: Sequence[bool]
) -> tuple[Group, ...]:
    """The sums of a closed range whose last value, which is the first one again, was left out.

    `shape` is that of all values; the groups' rows are without the last of the axes in `closing`.
    """
    inner = tuple(size - close for size, close in zip(shape, closing, strict=True))
    index = [
        np.append(np.arange(size), 0) if close else np.arange(size)
        for size, close in zip(inner, closing, strict=True)
    ]
    source = np.arange(int(np.prod(inner))).reshape(inner)[np.ix_(*index)].ravel()
    out: list[Group] = []
    for group in groups:
        where = np.full(int(np.prod(inner)), -1)
        where[group.rows] = np.arange(group.rows.size)
        own = where[source]
        kept = own >= 0
        sums = Totals(*(spectrum[own[kept]] for spectrum in group.sums))
        out.append(Group(np.flatnonzero(kept), sums))
    return tuple(out)
