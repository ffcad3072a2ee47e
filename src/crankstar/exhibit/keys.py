"""The figures and derivations that a page can show of an engine, by key: `figure:order=2:quantity=couple`, `force:2`."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal

from crankstar.engine import Engine
from crankstar.exhibit.records import ChartKey, DerivationKey
from crankstar.wording import number

FIGURES = {
    "crank-star": "Crank star",
    "vector-star": "Vector star",
    "polygon": "Polygon",
    "hodograph": "Hodograph",
    "over-turn": "Over the crank angle",
    "spectrum": "Spectrum",
    "shaft": "Shafts from the side",
    "stroke-chart": "Strokes",
    "firing-ring": "Firing ring",
}
"""Figures of a page, in the order in which they are offered; `forces` stands on the stage itself."""
OF_ORDER = ("vector-star", "polygon", "hodograph")
WITHOUT_ANGLE = ("spectrum",)
VECTORS: tuple[Literal["force", "couple"], ...] = ("force", "couple")
OVER_TURN = ("force", "couple", "roll", "torque")
NEED_FIRING = ("stroke-chart", "firing-ring")
BEFORE_AND_AFTER = "spectrum:fitted"
"""The spectra of an engine as it is and with what `fitting.recommended` gives it, on common axes; for engines that it helps.

It is not among `chart_keys`, because whether it helps is worked out only when that is asked.
"""
HIGHEST = 4.0
MOST_ORDERS = 4


def chart_keys(engine: Engine, orders: Sequence[float]) -> tuple[ChartKey, ...]:
    """Every figure of an engine, those of single orders for the lowest orders."""
    out: list[ChartKey] = []
    for figure, label in FIGURES.items():
        if figure in NEED_FIRING and not engine.firing_order:
            continue
        turning = figure not in WITHOUT_ANGLE
        if figure in OF_ORDER:
            for quantity in VECTORS:
                for order in _drawn(orders):
                    key = chart_key(figure, order=order, quantity=quantity)
                    said = f"{label}, {quantity}, order {number(order)}"
                    out.append(ChartKey(key=key, figure=figure, label=said, quantity=quantity, order=order, turning=turning))
            if figure == "hodograph":
                for quantity in VECTORS:
                    key = chart_key(figure, quantity=quantity)
                    said = f"{label}, {quantity}, all orders"
                    out.append(ChartKey(key=key, figure=figure, label=said, quantity=quantity, turning=turning))
        elif figure == "over-turn":
            out += [
                ChartKey(key=chart_key(figure, quantity=q), figure=figure, label=f"{label}, {q}", quantity=q, turning=turning)
                for q in OVER_TURN
            ]
        else:
            out.append(ChartKey(key=figure, figure=figure, label=label, turning=turning))
    return tuple(out)


def _drawn(orders: Sequence[float]) -> list[float]:
    low = [order for order in orders if order <= HIGHEST] or list(orders[:1])
    return low[:MOST_ORDERS]


def chart_key(figure: str, *, order: float | None = None, quantity: str | None = None) -> str:
    """The key of a figure with its options, sorted by name.

    >>> chart_key("polygon", order=2.0, quantity="couple")
    'polygon:order=2:quantity=couple'
    """
    options = {"order": None if order is None else f"{order:.12g}", "quantity": quantity}
    return ":".join([figure, *(f"{name}={value}" for name, value in sorted(options.items()) if value is not None)])


def derivation_keys(orders: Sequence[float]) -> tuple[DerivationKey, ...]:
    """The derivations of an engine: force and couple of the lowest orders."""
    return tuple(
        DerivationKey(key=f"{name}:{order:.12g}", label=f"{name.capitalize()} of order {number(order)}", quantity=name, order=order)
        for name in VECTORS
        for order in _drawn(orders)
    )
