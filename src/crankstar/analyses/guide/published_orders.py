"""Published firing orders of engines in line: those of the catalog that were read in a source."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from crankstar.engine.quantities import Cycle
from crankstar.files.catalog import load, summaries
from crankstar.firing.intervals import firing

READ = "published"
"""The status of a value that was read in a source."""


class Published(NamedTuple):
    """A firing order, the engine of the catalog that has it, and where it was read."""

    order: tuple[int, ...]
    engine: str
    source: str


def published_orders(cycle: Cycle, numbers: Sequence[int]) -> tuple[Published, ...]:
    """The published orders of engines in line that fire evenly, of these numbers of cylinders.

    >>> [(each.order, each.engine) for each in published_orders("two-stroke", [6])]
    [((1, 5, 3, 4, 2, 6), 'sinitsyn-6-loop')]
    """
    found: list[Published] = []
    for each in summaries():
        if each.layout != "inline" or each.cycle != cycle or each.cylinders not in numbers:
            continue
        engine = load(each.name)
        origin = engine.provenance.get("firing_order")
        if origin is not None and origin.status == READ and firing(engine).even:
            found.append(Published(engine.firing_order, each.name, origin.source))
    return tuple(found)


def backwards(order: Sequence[int]) -> tuple[int, ...]:
    """An order in the opposite direction, from cylinder 1 on: that of the mirror image.

    >>> backwards((1, 5, 3, 4, 2, 6))
    (1, 6, 2, 4, 3, 5)
    """
    first = order.index(1)
    others = (*order[first + 1 :], *order[:first])
    return (1, *reversed(others))
