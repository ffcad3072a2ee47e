"""What a figure shows where nothing is named: the quantity and order of which something is left."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple, get_args

from crankstar.charts.drawing import checked_order
from crankstar.charts.sums import Quantity, checked_quantity
from crankstar.engine.engine import Engine
from crankstar.mechanics.balance import balance
from crankstar.mechanics.bounds import size
from crankstar.mechanics.excitation import Reference
from crankstar.mechanics.remains import MINOR, USUAL_ORDERS, pushed, sizes, summed


class Choice(NamedTuple):
    """A quantity, and an order or all orders; whether all quantities of them are zero."""

    quantity: str
    order: float | None
    nothing: bool = False


def quantity_shown(
    engines: Sequence[Engine],
    quantity: str | None,
    *,
    among: object = Quantity,
    order: float | None = None,
    reference: Reference | None = None,
) -> Choice:
    """The named quantity, else the first of which a visible share is left, else the greatest share.

    The share is that of the sum, of one `order` or the greatest of all, in what the parts push at
    the order at which they push most. Raises ChartError.
    """
    order = None if order is None else checked_order(order)
    if quantity is not None:
        return Choice(checked_quantity(quantity, among), order)
    shares = {name: _share(engines, name, order, reference) for name in get_args(among)}
    visible = [name for name, share in shares.items() if share > MINOR]
    greatest = max(shares, key=lambda name: shares[name])
    return Choice([*visible, greatest][0], order, nothing=not any(shares.values()))


def order_shown(
    engines: Sequence[Engine],
    quantity: Quantity | None,
    order: float | None,
    *,
    reference: Reference | None,
) -> Choice:
    """The named quantity and order, else the lowest order of which something is left, else 1."""
    if order is not None:
        return quantity_shown(engines, quantity, order=order, reference=reference)
    names = get_args(Quantity) if quantity is None else (checked_quantity(quantity),)
    for tried in range(1, int(USUAL_ORDERS) + 1):
        for name in names:
            if _share(engines, name, float(tried), reference) > MINOR:
                return Choice(name, float(tried))
    return Choice(names[0], 1.0, nothing=True)


def _share(
    engines: Sequence[Engine], quantity: str, order: float | None, reference: Reference | None
) -> float:
    """What is left of a quantity in what the parts push, in the engine in which it is greatest."""
    out = 0.0
    for engine in engines:
        result = balance(engine, reference=reference)
        whole = getattr(summed(result), quantity)
        parts = vars(result)["torque" if quantity == "roll" else quantity]
        most = float(pushed(parts).max(initial=0.0))
        left = size(whole, order) if order else float(sizes(whole).max(initial=0.0))
        out = max(out, left / most if most else 0.0)
    return out
