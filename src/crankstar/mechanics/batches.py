"""The sums of a whole batch of engines, in blocks of bounded memory."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from crankstar.engine.motion import Linkage
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
    length = max(
        (len(values) for record in (machine, machine.links) for values in _varied(record).values()),
        default=0,
    )
    if length == 0:
        return total(part_spectra(machine, reference=reference, orders=orders))
    blocks = [slice(start, min(start + block, length)) for start in range(0, length, block)]
    pieces = [
        total(part_spectra(_rows(machine, rows), reference=reference, orders=orders))
        for rows in blocks
    ]
    return Totals(*(_joined(spectra, blocks) for spectra in zip(*pieces, strict=True)))


def _varied(record: Mechanism | Linkage) -> dict[str, np.ndarray]:
    """The arrays of a record that have a leading axis."""
    return {
        name: values
        for name, values in vars(record).items()
        if isinstance(values, np.ndarray) and values.ndim > 1
    }


def _rows(machine: Mechanism, rows: slice) -> Mechanism:
    """Some engines of a batch; an array with one row serves them all."""

    def part(record: Any) -> Any:
        varied = _varied(record).items()
        return replace(
            record, **{name: values[rows] if len(values) > 1 else values for name, values in varied}
        )

    return replace(part(machine), links=part(machine.links))


def _joined(pieces: Sequence[Spectrum], blocks: Sequence[slice]) -> Spectrum:
    """The sums of all blocks with their leading axis, also where no varied value reaches them."""
    forward, backward = (
        np.concatenate(
            [
                np.broadcast_to(getattr(piece, name), (rows.stop - rows.start, piece.orders.size))
                for piece, rows in zip(pieces, blocks, strict=True)
            ]
        )
        for name in ("forward", "backward")
    )
    return replace(pieces[0], forward=forward, backward=backward)
