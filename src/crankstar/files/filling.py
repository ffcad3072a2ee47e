"""Values that are filled in where an engine file leaves them out, each with source and range."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

from crankstar.engine.quantities import Quantity
from crankstar.engine.weighed import EngineType
from crankstar.files import units
from crankstar.files.changes import keys_of
from crankstar.files.forms import field_at, form_of, quantity_of
from crankstar.files.mistakes import Tree


class Bond(NamedTuple):
    """The key that a value moves with; its own ends, as multiples, while that key stays."""

    key: str = ""
    ends: tuple[float, ...] = ()


class Filled(NamedTuple):
    """A value filled in: its key path, SI number with range, what it measures, its source."""

    path: str
    typical: float
    low: float
    high: float
    quantity: Quantity
    source: str
    moves_with: str = ""


class Filling:
    """A tree of an engine file while values are filled in."""

    def __init__(self, tree: Tree, kind: EngineType) -> None:
        self.tree = tree
        self.kind: EngineType = kind
        self.filled: list[Filled] = []

    def table(self, *keys: str) -> dict[str, Any]:
        """The table at a path of keys, made where the tree has none."""
        table = self.tree
        for key in keys:
            table = table.setdefault(key, {})
        return table

    def fill(
        self, path: str, sizes: Sequence[float], source: str, bond: Bond | None = None
    ) -> None:
        """Set a value to the second of the sizes (lowest, typical, highest), with its source."""
        *outer, last = map(str, keys_of(path))
        quantity = self._quantity(path)
        text = units.text(sizes[1], quantity, digits=4)
        self.table(*outer)[last] = text
        low, high = sizes[0], sizes[2]
        self.mark(path, (low, units.si(text, quantity), high), source, bond)

    def mark(
        self, path: str, sizes: Sequence[float], source: str, bond: Bond | None = None
    ) -> None:
        """Give the source of a value that was filled in."""
        moves_with, own = bond or Bond()
        low, value, high = min(sizes), sizes[1], max(sizes)
        quantity = self._quantity(path)
        ends = " to ".join(units.text(end, quantity, digits=3) for end in (low, high))
        self.table("provenance")[path] = {
            "status": "estimated",
            "source": f"{source}; {ends}",
            "range": [float(f"{end:.4g}") for end in own or (low / value, high / value)],
            **({"moves_with": moves_with} if moves_with else {}),
        }
        self.filled.append(Filled(path, value, low, high, quantity, source, moves_with))

    def _quantity(self, path: str) -> Quantity:
        info = field_at(form_of(self.tree), keys_of(path))
        quantity = quantity_of(info) if info else None
        if quantity is None:  # a slip in this module
            raise LookupError(path)
        return quantity
