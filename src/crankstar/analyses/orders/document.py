"""Firing orders that a crank can fire."""

from __future__ import annotations

from collections.abc import Sequence

from crankstar.analyses.orders.listing import Listing
from crankstar.analyses.orders.question import Question
from crankstar.analysis.document import Column, Document, Remarks, Table, Value, for_each, remarks
from crankstar.engine.engine import Engine
from crankstar.firing.orders import place_of
from crankstar.firing.succession import Follower
from crankstar.language.messages import N_, _, _n
from crankstar.language.numbers import number
from crankstar.options.readers import USUAL_TOP
from crankstar.tables.headings import heading
from crankstar.tables.judgements import JUDGEMENTS, judge_column, mode_sentence

HEADS = {"torque": N_("torque"), "roll": N_("roll"), "twist": N_("twist")}
MEANINGS = {
    "torque": N_(
        "torque k: gas torque of order k. Of whole orders it is the same for all firing orders, "
        "and where they fire evenly all but multiples of the firing frequency vanish."
    ),
    "roll": N_(
        "roll k: rolling moment of order k that gas gives the block, the reaction of its torque. "
        "Of whole orders it is the same for all firing orders."
    ),
    "twist": N_(
        "twist k: gas torque of order k, each cylinder times its distance from the middle of the "
        "crankshaft over that of the farthest, or times the amplitude of --mode-shape."
    ),
}
EQUAL_INTERVALS = 1e-3
"""Degrees by which intervals may differ and are written as one."""


def document(engine: Engine, result: Listing, question: Question) -> Document:
    """The orders, best first, with exhaust intervals, neighbours and partners in succession.

    Of readers the first ones and that of the file, of machines all.
    """
    del engine
    listing = result
    own = place_of(listing.engine, listing.orders)
    every = range(len(listing.orders))
    top = question.top or USUAL_TOP
    shown = [place for place in every if place < top or place == own]
    first, whole = (
        Table("", _columns(listing), tuple(_row(listing, at, own) for at in places), key="orders")
        for places in (shown, every)
    )
    facts = {
        "engine": listing.engine.name,
        "cycle_deg": listing.engine.cycle_angle,
        "why_uneven": listing.why_uneven or None,
        "row_of_file": None if own is None else own + 1,
    }
    parts = (
        heading(listing.engine),
        *remarks(
            listing.why_uneven,
            _("The most even orders:") if listing.why_uneven and listing.orders else "",
        ),
        *for_each(first, whole),
        Remarks(tuple(_notes(listing, len(shown), own))),
    )
    return Document(listing.engine.name, parts, facts)


def _columns(listing: Listing) -> tuple[Column, ...]:
    banks = tuple(listing.orders[0].banks) if listing.orders else ()
    even = all(order.firing.even for order in listing.orders)
    out = [
        Column(_("row"), key="row", label=True),
        Column("", kind="text"),
        Column(_("firing order"), kind="order", key="order"),
        Column("", "deg", kind="list", key="angles_deg", machine=True),
        Column(_("intervals"), "deg", kind="text", wraps=True, machine=even),
        Column("", "deg", kind="list", key="intervals_deg", machine=True),
    ]
    for bank in banks:
        head = _("exhaust {bank}", bank=bank)
        out.append(Column(head, "deg", kind="text", wraps=True))
        out.append(Column("", "deg", kind="list", key=f"exhausts/{bank}", machine=True))
    out.append(Column(_("neighbours in succession"), kind="list", key="neighbours", wraps=True))
    out.append(Column(_("same pin in succession"), kind="list", key="partners", wraps=True))
    return (*out, *_sums(listing))


def _sums(listing: Listing) -> list[Column]:
    """The columns of what the orders are sorted by: crank orders, and all together; or a judge."""
    if listing.judged:
        return [judge_column(listing.judge)]
    if listing.weighed is None:
        return []
    unit = "N*m" if listing.load else ""
    head = _(HEADS[listing.weight])
    titles = {f"{order:g}": f"{head} {number(order)}" for order in listing.weighed.crank_orders}
    if len(titles) > 1:
        titles["together"] = _("together")
    return [Column(title, unit, key=f"{listing.weight}/{key}") for key, title in titles.items()]


def _row(listing: Listing, index: int, own: int | None) -> tuple[Value, ...]:
    order = listing.orders[index]
    angles = tuple(round(float(angle), 9) for angle in order.firing.angles_deg)
    cells: list[Value] = [index + 1, "*" if index == own else "", tuple(order.firing.order), angles]
    for intervals in (order.firing.intervals_deg, *order.banks.values()):
        cells += [_spaced(intervals), tuple(intervals)]
    pairs = (_pairs(steps) for steps in (order.neighbours, order.partners))
    if listing.judged:
        return (*cells, *pairs, listing.judged[index])
    if listing.weighed is None:
        return (*cells, *pairs)
    sums, whole = listing.weighed.sums[index], listing.weighed.whole[index]
    return (*cells, *pairs, *sums, *((whole,) if len(sums) > 1 else ()))


def _spaced(intervals: Sequence[float]) -> str:
    """Intervals in one cell; one number where they are equal."""
    if max(intervals) - min(intervals) < EQUAL_INTERVALS:
        return _("every {interval}", interval=number(intervals[0], digits=4))
    return "-".join(number(interval, digits=4) for interval in intervals)


def _pairs(steps: Sequence[Follower]) -> tuple[tuple[int, int], ...]:
    return tuple((step.first, step.then) for step in steps)


def _notes(listing: Listing, shown: int, own: int | None) -> list[str]:
    count = len(listing.orders)
    if not count:
        return [
            _(
                "No firing order meets these conditions; --any --together also lists those in "
                "which cylinders fire together."
            )
        ]
    out = [_count_sentence(listing)]
    if shown < count:
        out.append(
            _(
                "{shown} of {count} are shown; --top shows more, --csv all.",
                shown=shown,
                count=count,
            )
        )
    if count == 1 and listing.engine.cycle == "two-stroke":
        out.append(
            _(
                "A two-stroke cylinder fires at every top dead centre, so there is no other order; "
                "`crankstar search` finds other cranks."
            )
        )
    if own is not None:
        out.append(_("* the order of the file."))
    if listing.weighed is not None:
        out += [_(MEANINGS[listing.weight]), listing.load or _("Counted in one cylinder.")]
    if listing.mode is not None:
        out.append(mode_sentence(listing.mode))
    if listing.judged:
        out += [_(JUDGEMENTS[listing.judge]), listing.load]
    out.append(_("--row N -o FILE writes the engine with that order."))
    return out


def _count_sentence(listing: Listing) -> str:
    """How many orders there are, and whether they are even."""
    count = len(listing.orders)
    even = [order for order in listing.orders if order.firing.even]
    if len(even) == count:
        interval = number(even[0].firing.intervals_deg[0])
        return _n(
            "{count} order, firing evenly every {interval} deg.",
            "{count} orders, firing evenly every {interval} deg.",
            count,
            count=count,
            interval=interval,
        )
    if listing.asked_deg and listing.tolerance_deg:
        return _n(
            "{count} order with each firing within {tolerance} deg of its place.",
            "{count} orders with each firing within {tolerance} deg of its place.",
            count,
            count=count,
            tolerance=number(listing.tolerance_deg),
        )
    if listing.asked_deg:
        return _n(
            "{count} order at these intervals.",
            "{count} orders at these intervals.",
            count,
            count=count,
        )
    if not even:
        return _n(
            "{count} order, none of them even.",
            "{count} orders, none of them even.",
            count,
            count=count,
        )
    return _n(
        "{count} order, {even} of them even.",
        "{count} orders, {even} of them even.",
        count,
        count=count,
        even=len(even),
    )
