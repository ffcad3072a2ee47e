"""The sums of a whole batch of engines, in blocks of bounded memory."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from crankstar.mechanics.excitation import Reference, Totals, part_spectra, total
from crankstar.mechanics.mechanism import Mechanism
from crankstar.spectra import Spectrum


def totals(
    machine: Mechanism,
    *,
    orders: Sequence[float],
    reference: Reference | None = None,
    block: int = 2048,
) -> Totals:
    """The sums over each engine [variant, order] at 1 rad/s of a batch with one leading axis.

    Memory stays that of one block of variants, whatever the length of the batch.
    """
    arrays = {
        name: values for name, values in vars(machine).items() if isinstance(values, np.ndarray)
    }
    links = {
        name: values
        for name, values in vars(machine.links).items()
        if isinstance(values, np.ndarray)
    }
    length = max(
        (len(values) for values in (*arrays.values(), *links.values()) if values.ndim > 1),
        default=0,
    )
    if length == 0:
        return total(part_spectra(machine, reference=reference, orders=orders))
    pieces: list[Totals] = []
    for start in range(0, length, block):

        def part(values: np.ndarray, start: int = start) -> np.ndarray:
            return values[start : start + block] if values.ndim > 1 and len(values) > 1 else values

        own = replace(machine.links, **{name: part(values) for name, values in links.items()})
        one = replace(machine, links=own, **{name: part(values) for name, values in arrays.items()})
        sums = total(part_spectra(one, reference=reference, orders=orders))
        pieces.append(Totals(*(_spread(spectrum, min(block, length - start)) for spectrum in sums)))
    return Totals(*(_joined([getattr(piece, name) for piece in pieces]) for name in Totals._fields))


def _spread(spectrum: Spectrum, count: int) -> Spectrum:
    """The sums of a block with their leading axis, also where no varied value reaches them."""
    shape = (count, spectrum.orders.size)
    forward, backward = (
        np.broadcast_to(values, shape) for values in (spectrum.forward, spectrum.backward)
    )
    return replace(spectrum, forward=forward, backward=backward)


def _joined(pieces: list[Spectrum]) -> Spectrum:
    forward, backward = (
        np.concatenate([getattr(piece, name) for piece in pieces])
        for name in ("forward", "backward")
    )
    return replace(pieces[0], forward=forward, backward=backward)
