"""The keys of figures and derivations: `polygon:order=2:quantity=couple`, `force:2`."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import product
from typing import Literal

from crankstar.engine.engine import Engine
from crankstar.language.messages import N_, _
from crankstar.language.numbers import number
from crankstar.page.records import ChartKey, DerivationKey
from crankstar.tables.by_order import QUANTITIES

FIGURES = {
    "crank-star": N_("Crank star"),
    "vector-star": N_("Vector star"),
    "polygon": N_("Polygon"),
    "hodograph": N_("Hodograph"),
    "over-turn": N_("Over the crank angle"),
    "spectrum": N_("Spectrum"),
    "shaft": N_("Shafts from the side"),
    "stroke-chart": N_("Strokes"),
    "firing-ring": N_("Firing ring"),
}
"""Figures of a page in order; `forces` are shown on the stage."""
DERIVATIONS = {"force": N_("Force of order {order}"), "couple": N_("Couple of order {order}")}
VECTORS: tuple[Literal["force", "couple"], ...] = ("force", "couple")
OF_ORDER = {"vector-star": VECTORS, "polygon": VECTORS, "hodograph": VECTORS}
OF_ALL_ORDERS = {"hodograph": VECTORS, "over-turn": ("force", "couple", "roll", "torque")}
NEED_FIRING = ("stroke-chart", "firing-ring")
BEFORE_AND_AFTER = "spectrum:fitted"
"""The spectra of an engine before and after `fitting.recommended`, if it recommends something.

Not among `chart_keys`, because the recommendation takes time.
"""


def chart_keys(engine: Engine, orders: Sequence[float]) -> tuple[ChartKey, ...]:
    """Every figure of an engine, those of single orders for these orders."""
    return tuple(
        ChartKey(
            key=chart_key(figure, order=order, quantity=quantity),
            figure=figure,
            label=_label(figure, quantity, order),
            quantity=quantity,
            order=order,
        )
        for figure in FIGURES
        if engine.firing_order or figure not in NEED_FIRING
        for quantity, order in (
            *product(OF_ORDER.get(figure, ()), orders),
            *product(OF_ALL_ORDERS.get(figure, () if figure in OF_ORDER else (None,)), (None,)),
        )
    )


def _label(figure: str, quantity: str | None, order: float | None) -> str:
    if quantity is None:
        return _(FIGURES[figure])
    words = {"figure": _(FIGURES[figure]), "quantity": _(QUANTITIES[quantity])}
    if order is not None:
        return _("{figure}, {quantity}, order {order}", order=number(order), **words)
    if figure in OF_ORDER:
        return _("{figure}, {quantity}, all orders", **words)
    return _("{figure}, {quantity}", **words)


def chart_key(
    figure: str,
    *,
    order: float | None = None,
    orders: float | None = None,
    quantity: str | None = None,
) -> str:
    """The key of a figure with its options, sorted by name; `orders` where it takes several.

    >>> chart_key("polygon", order=2.0, quantity="couple")
    'polygon:order=2:quantity=couple'
    """
    options = {
        "order": None if order is None else f"{order:.12g}",
        "orders": None if orders is None else f"{orders:.12g}",
        "quantity": quantity,
    }
    return ":".join(
        [
            figure,
            *(f"{name}={value}" for name, value in sorted(options.items()) if value is not None),
        ]
    )


def derivation_keys(orders: Sequence[float]) -> tuple[DerivationKey, ...]:
    """The derivations of an engine: force and couple of these orders."""
    return tuple(
        DerivationKey(
            key=f"{name}:{order:.12g}",
            label=_(DERIVATIONS[name], order=number(order)),
            quantity=name,
            order=order,
        )
        for name in VECTORS
        for order in orders
    )
