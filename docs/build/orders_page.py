"""The page on firing orders: its tables, from what the program works out when the page is built."""

from __future__ import annotations

from crankstar import load
from crankstar.firing.orders import Order, even_orders
from crankstar.firing.vees import interval_deg, vees

ENGINES = (
    "i4",
    "audi-25-tfsi",
    "i6",
    "boxer-6",
    "v6-60-six-throws",
    "gm-3800",
    "v8-cross-plane",
    "v8-flat-plane",
    "v12-60",
    "man-s90mc-c",
)
CYLINDERS = (4, 6, 8, 10, 12, 14, 16)


def page(part: str) -> str:
    """A part of the page: counts of orders, or counts of V engines."""
    return {"counts": counts, "vees": vee_counts}[part]()


def counts() -> str:
    """The number of even orders of known engines, and the rank of the catalog's order."""
    rows = [
        "| engine | fires every | even orders | first of them | its neighbours in succession |",
        "|---|---|---|---|---|",
    ]
    for name in ENGINES:
        engine = load(name)
        orders = even_orders(engine)
        every = f"{orders[0].firing.intervals_deg[0]:.4g}°"
        rows.append(
            f"| {engine.name} | {every} | {len(orders)} | {_joined(orders[0])} "
            f"| {_neighbours(orders[0])} |"
        )
    return "\n".join(rows)


def _joined(order: Order) -> str:
    return "-".join(map(str, order.firing.order))


def _neighbours(order: Order) -> str:
    return ", ".join(f"{step.first}-{step.then}" for step in order.neighbours) or "none"


def vee_counts() -> str:
    """Four-stroke V engines with common pins at multiples of the firing interval."""
    rows = [
        (
            "| engine | fires every "
            "| bank angle: cranks, without mirror images and reverses, balances |"
        ),
        "|---|---|---|",
    ]
    for cylinders in CYLINDERS:
        step = interval_deg(cylinders=cylinders, cycle="four-stroke")
        found = vees(cylinders=cylinders)
        cells: list[str] = []
        for angle in sorted({one.bank_angle_deg for one in found}):
            own = [one for one in found if one.bank_angle_deg == angle]
            cells.append(
                f"{angle:.4g}°: {sum(vee.count for vee in own)}, "
                f"{sum(len(vee.stars) for vee in own)}, {len(own)}"
            )
        rows.append(f"| V{cylinders} | {step:.4g}° | {'<br>'.join(cells)} |")
    return "\n".join(rows)
