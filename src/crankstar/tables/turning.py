"""What turns with the crankshaft: of the moving parts, of the weights there were, of new ones."""

from __future__ import annotations

from cmath import phase
from collections.abc import Iterator, Sequence
from math import degrees

import numpy as np

from crankstar import spectra
from crankstar.analysis.document import Column, Table, Value
from crankstar.engine.engine import Engine
from crankstar.engine.records import Shaft, Weight
from crankstar.language.messages import _
from crankstar.mechanics.balance import balance, default_reference, scales, total
from crankstar.mechanics.remains import OPTIMISED
from crankstar.remedy import changes
from crankstar.remedy.kept import vectors


def turning(before: Engine, after: Engine, *, speed: float | None) -> Iterator[Table]:
    """The primary vectors that turn with the crankshaft, part by part and in total.

    None where no weights of the file were kept.
    """
    became = changes(before, after)
    cranks = [shaft for shaft in after.shafts if shaft.speed_ratio == 1]
    kept = {shaft.name: became[shaft.name].kept for shaft in cranks}
    if not any(kept.values()):
        return
    result = balance(after, speed=speed)
    sums = total(result)
    whole = tuple(
        complex(spectra.selected(getattr(sums, name), [1.0]).forward[0])
        for name in ("force", "couple")
    )
    added = {shaft.name: became[shaft.name].added for shaft in cranks}
    (old, sizes), (new, others) = (
        _pushed(after, cranks, weights, speed) for weights in (kept, added)
    )
    parts = tuple(all_of - one - other for all_of, one, other in zip(whole, old, new, strict=True))
    greatest = [one + other for one, other in zip(sizes, others, strict=True)]
    columns = (
        Column(_("part"), kind="text", key="part", label=True, wraps=True),
        Column(_("force"), result.units.force, key="force"),
        Column(_("bearing at θ = 0"), "deg", key="force_bearing_deg"),
        Column(_("couple"), result.units.couple, key="couple"),
        Column(_("bearing at θ = 0"), "deg", key="couple_bearing_deg", optional=1),
    )
    rows = (
        (_("moving parts"), *_cells(parts, greatest)),
        (_("weights of the file"), *_cells(old, greatest)),
        (_("new weights"), *_cells(new, greatest)),
        (_("remaining"), *_cells(whole, greatest)),
    )
    yield Table(_("Primary vectors that turn with the crankshaft"), columns, rows, key="turning")


def _pushed(
    engine: Engine,
    shafts: Sequence[Shaft],
    weights: dict[str, tuple[Weight, ...]],
    speed: float | None,
) -> tuple[tuple[complex, complex], tuple[float, float]]:
    """Force and couple of these weights, and the sums of the sizes of their parts."""
    scale, _units = scales(engine, speed)
    middle = default_reference(engine).z
    own = [weight for shaft in shafts for weight in weights[shaft.name]]
    pushes = vectors(own)
    moments = [push * (weight.z - middle) for push, weight in zip(pushes, own, strict=True)]
    return (sum(pushes, 0j) * scale.force, sum(moments, 0j) * scale.couple), (
        sum(map(abs, pushes)) * scale.force,
        sum(map(abs, moments)) * scale.couple,
    )


def _cells(pair: Sequence[complex], greatest: Sequence[float]) -> tuple[Value, ...]:
    """Size and bearing of force and couple; rounding is zero, and has no bearing."""
    cells: list[Value] = []
    for vector, most in zip(pair, greatest, strict=True):
        size = abs(vector) if abs(vector) > OPTIMISED * most else 0.0
        cells += [size, bearing(phase(vector)) if size else None]
    return tuple(cells)


def bearing(angle: float) -> float:
    """A bearing in degrees, over -180 up to 180, without rounding errors."""
    turned = round(degrees(phase(complex(np.exp(1j * angle)))), 3)
    return 180.0 if turned == -180 else turned + 0.0
