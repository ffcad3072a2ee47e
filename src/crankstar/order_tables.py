"""Firing orders that were found, as a table, as CSV and as JSON."""

from __future__ import annotations

import csv
import io
from collections.abc import Sequence
from typing import Any, NamedTuple

from rich.console import Group, RenderableType
from rich.text import Text

from crankstar.engine import Engine
from crankstar.search.orders import Order, place_of
from crankstar.succession import Follower
from crankstar.wording import heading, number, table

FORMAT = 1
"""Version of the JSON object."""


class Listing(NamedTuple):
    """Firing orders of an engine, what they were asked to be, and, where even ones were asked for and there are none, why.

    `asked_deg`: the intervals that were asked for, none where any would do; `tolerance_deg`: how far a firing may be from its
    place, None where that was not said.
    """

    engine: Engine
    orders: tuple[Order, ...]
    why_uneven: str = ""
    asked_deg: tuple[float, ...] = ()
    tolerance_deg: float | None = None


def orders_table(listing: Listing, *, limit: int) -> RenderableType:
    """The first orders, best first, with exhaust intervals, neighbours and partners in succession; the file's own is marked."""
    own = place_of(listing.engine, listing.orders)
    shown = _shown(listing, limit, own)
    uneven = not all(one.firing.even for one in listing.orders)
    banks = tuple(listing.orders[0].banks) if listing.orders else ()
    intervals = ("intervals [deg]",) if uneven else ()
    exhaust = tuple(f"exhaust {name} [deg]" for name in banks)
    heads = ("row", "", "order", *intervals, *exhaust, "neighbours", "on one throw")
    out = table(*heads, left=heads[1:])
    for place in shown:
        one = listing.orders[place]
        rows = ([_spaced(one.firing.intervals_deg)] if uneven else []) + [_spaced(row) for row in one.banks.values()]
        marks = (_pairs(one.neighbours), _pairs(one.partners))
        out.add_row(str(place + 1), "*" if place == own else "", _joined(one.firing.order), *rows, *marks)
    lines = [heading(listing.engine), Text()]
    if listing.why_uneven:
        lines.append(Text(listing.why_uneven + (" The most even orders are these:" if listing.orders else "")))
    lines += [out] if listing.orders else []
    return Group(*lines, Text(), *map(Text, _remarks(listing, len(shown), own)))


def _shown(listing: Listing, limit: int, own: int | None) -> list[int]:
    """The first rows, and the file's own order wherever it is."""
    first = list(range(min(limit, len(listing.orders))))
    return first if own is None or own in first else [*first, own]


def _remarks(listing: Listing, shown: int, own: int | None) -> list[str]:
    count = len(listing.orders)
    if not count:
        return ["No firing order is like that; --any --together also lists those in which cylinders fire at once."]
    more = f" {shown} {'is' if shown == 1 else 'are'} shown; --limit shows more, --csv all." if shown < count else ""
    out = [_count_sentence(listing) + more]
    if count == 1 and listing.engine.cycle == "two-stroke":
        out.append("There is no other: in a two-stroke engine every dead centre of a cylinder is one at which it fires.")
    if own is not None:
        out.append("* as the file has it.")
    out.append(
        "Neighbours and pistons on one throw are those that fire one after the other. --row N -o FILE writes an engine file."
    )
    return out


def _count_sentence(listing: Listing) -> str:
    """How many orders there are, and how they fire: evenly, as was asked, or as it comes."""
    count = len(listing.orders)
    even = [one for one in listing.orders if one.firing.even]
    orders, fire = (f"{count} orders", "fire") if count > 1 else ("1 order", "fires")
    if len(even) == count:
        return f"{orders} {fire} evenly, every {number(even[0].firing.intervals_deg[0])} deg."
    if asked := listing.asked_deg:
        when = f"every {number(asked[0])} deg" if len(set(asked)) == 1 else "at these intervals"
        near = f", each firing within {number(listing.tolerance_deg)} deg of its place" if listing.tolerance_deg else ""
        return f"{orders} {fire} {when}{near}."
    return f"{orders}, none of them even." if not even else f"{orders}, {len(even)} of them even."


def _joined(order: Sequence[int]) -> str:
    return "-".join(map(str, order))


def _spaced(intervals: Sequence[float]) -> str:
    """Intervals in one cell; one number where they are alike."""
    alike = max(intervals) - min(intervals) < 1e-3
    return f"every {number(intervals[0], digits=4)}" if alike else "-".join(number(one, digits=4) for one in intervals)


def _pairs(steps: Sequence[Follower]) -> str:
    return ", ".join(f"{step.first}-{step.then}" for step in steps) or "-"


def orders_csv(listing: Listing) -> str:
    """All orders as CSV, a row for each."""
    own = place_of(listing.engine, listing.orders)
    banks = tuple(listing.orders[0].banks) if listing.orders else ()
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    exhaust = [f"exhaust {name} [deg]" for name in banks]
    writer.writerow(["row", "order", "angles [deg]", "intervals [deg]", *exhaust, "neighbours", "on one throw", "now"])
    for place, one in enumerate(listing.orders):
        numbers = [one.firing.angles_deg, one.firing.intervals_deg, *one.banks.values()]
        pairs = [" ".join(f"{step.first}-{step.then}" for step in steps) for steps in (one.neighbours, one.partners)]
        cells = [" ".join(f"{value:.10g}" for value in row) for row in numbers]
        writer.writerow([place + 1, _joined(one.firing.order), *cells, *pairs, int(place == own)])
    return out.getvalue()


def orders_tree(listing: Listing) -> dict[str, Any]:
    """All orders as a JSON object; angles in degrees of the reference crankshaft."""
    own = place_of(listing.engine, listing.orders)
    return {
        "format": FORMAT,
        "engine": listing.engine.name,
        "cycle_deg": listing.engine.cycle_angle,
        "why_uneven": listing.why_uneven or None,
        "orders": [
            {
                "row": place + 1,
                "order": list(one.firing.order),
                "angles_deg": [round(angle, 9) for angle in one.firing.angles_deg],
                "intervals_deg": list(one.firing.intervals_deg),
                "banks": [{"bank": name, "intervals_deg": list(row)} for name, row in one.banks.items()],
                "neighbours": [[step.first, step.then] for step in one.neighbours],
                "partners": [[step.first, step.then] for step in one.partners],
                "now": place == own,
            }
            for place, one in enumerate(listing.orders)
        ],
    }
