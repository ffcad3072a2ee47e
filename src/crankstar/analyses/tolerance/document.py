"""The scatter of an engine built to its tolerances as tables: orders, what matters, tolerances."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

from crankstar.analyses.tolerance.question import BEARING, SIGNALS, Question
from crankstar.analyses.tolerance.scatter import OrderScatter, Scatter
from crankstar.analysis.document import (
    ROW_UNIT,
    Column,
    Document,
    Remarks,
    Table,
    Value,
    for_each,
    remarks,
)
from crankstar.engine.engine import Engine
from crankstar.files.tolerances import Tolerance, wide
from crankstar.files.units import text
from crankstar.language.faults import listed
from crankstar.language.messages import N_, _, _n
from crankstar.language.numbers import number, order_text, rpm_of
from crankstar.language.shown_units import quantity_text
from crankstar.tables.estimates import typical_remarks
from crankstar.tables.headings import heading
from crankstar.tables.ranges import estimated_paths

NAMES = {
    "force": N_("force"),
    "couple": N_("couple"),
    "roll": N_("rolling moment"),
    "torque": N_("torque"),
    "force.up": N_("force, upward"),
    "force.right": N_("force, rightward"),
    "couple.pitch": N_("couple, pitch"),
    "couple.yaw": N_("couple, yaw"),
}
"""The signals as headings, but for those of bearings."""
WHOLE = ("force", "couple", "roll")
"""What is shown to readers where no quantity is asked for; machines get all signals."""
LARGER = 1.02
"""Times the nominal amplitude that 5 % of the engines must exceed to be told."""
SEEN = 5e-3
"""Share of the greatest scatter of a quantity from which an order is shown."""
SMALL_SHARE = 0.0005


def signal_text(signal: str) -> str:
    """A signal as a heading.

    >>> signal_text("couple.pitch"), signal_text("bearing 3")
    ('couple, pitch', 'load on main bearing 3')
    """
    kind, _space, number = signal.partition(" ")
    return _("load on main bearing {number}", number=number) if kind == BEARING else _(NAMES[kind])


def is_of(row: OrderScatter, quantity: str) -> bool:
    """Whether a row is of a quantity that was asked for: of `bearing` those of every bearing."""
    return row.signal == quantity or row.signal.partition(" ")[0] == quantity


def document(engine: Engine, result: Scatter, question: Question) -> Document:
    """What is asked of a scatter."""
    del engine
    every = question.orders is not None
    return scatter_document(result, signals=question.quantity or None, every=every)


def scatter_document(
    found: Scatter, *, signals: Sequence[str] | None = None, every: bool = False
) -> Document:
    """All of a scatter; for readers the quantities of WHOLE, or those asked for in `signals`.

    `every`: also orders of which next to nothing is there.
    """
    rows = rows_shown(found, signals=signals or SIGNALS)
    told = rows_shown(found, signals=signals or WHOLE)
    told = told if every else _visible(told)
    parts: tuple[Table | Remarks, ...] = (
        heading(found.engine),
        *for_each(_order_table(told), _order_table(rows)),
        replace(_share_table(found, told), audience="readers"),
        replace(_share_list(rows), audience="machines"),
        _tolerance_table(found),
        *remarks(*sentences(found, signals or WHOLE)),
        *remarks(*_notes(found), kind="note"),
        *typical_remarks(found.engine),
        *remarks(*_doubts(found), kind="doubt"),
    )
    return Document(found.engine.name, parts, _facts(found))


def rows_shown(found: Scatter, *, signals: Sequence[str]) -> list[OrderScatter]:
    """The orders of these signals, in the order of the signals."""
    return [row for name in signals for row in found.rows if is_of(row, name)]


def _visible(rows: Sequence[OrderScatter]) -> list[OrderScatter]:
    """Those whose scatter is of a size beside the greatest of their signal."""
    out: list[OrderScatter] = []
    for name in dict.fromkeys(row.signal for row in rows):
        own = [row for row in rows if row.signal == name]
        scattered = max(row.rms for row in own)
        out += [row for row in own if row.rms > SEEN * scattered]
    return out


def _facts(found: Scatter) -> dict[str, Any]:
    return {
        "format": 1,
        "engine": found.engine.name,
        "speed_rpm": rpm_of(found.speed),
        "reference": list(found.reference),
        "distribution": found.distribution,
        "builds": found.count,
        "seed": found.seed,
        "errors": len(found.errors),
        "idle": list(found.idle),
        "assumed": dict(found.assumed),
        "estimated": estimated_paths(found.engine),
    }


def _order_table(rows: Sequence[OrderScatter]) -> Table:
    """Each order: nominal, scatter and worst case by the law, quantiles of the random engines."""
    columns = (
        Column(_("quantity"), kind="text", label=True),
        Column("", kind="text", key="signal", machine=True),
        Column(_("order"), key="order", label=True),
        Column(_("nominal"), ROW_UNIT, key="nominal"),
        Column(_("scatter, rms"), ROW_UNIT, key="rms", digits=4),
        Column(_("median"), ROW_UNIT, key="median", digits=4, optional=1),
        Column(_("1 in 20 exceeds"), ROW_UNIT, key="exceeded_by_5_percent", digits=4),
        Column(_("1 in 100 exceeds"), ROW_UNIT, key="exceeded_by_1_percent", digits=4, optional=2),
        Column(_("worst case"), ROW_UNIT, key="worst", digits=4),
        Column("", ROW_UNIT, key="rms_of_builds", machine=True),
        Column(_("unit"), kind="unit", key="unit"),
    )
    body = tuple(
        (
            signal_text(row.signal),
            row.signal,
            row.order,
            row.nominal,
            row.rms,
            row.half_of,
            row.one_in_20,
            row.one_in_100,
            row.worst,
            row.rms_found,
            row.unit,
        )
        for row in rows
    )
    return Table(_("Scatter of each order"), columns, body, key="orders" if rows else "")


def _share_list(rows: Sequence[OrderScatter]) -> Table:
    columns = (
        Column("", kind="text", key="signal"),
        Column("", key="order"),
        Column("", kind="text", key="tolerance"),
        Column("", key="share"),
    )
    body = tuple(
        (row.signal, row.order, path, share) for row in rows for path, share in row.shares.items()
    )
    return Table("", columns, body, key="shares")


def _share_table(found: Scatter, rows: Sequence[OrderScatter]) -> Table:
    """The share of each tolerance in the variance of each of these orders, the largest first."""
    columns = (
        Column(_("tolerance"), kind="text", label=True),
        *(
            Column(
                _(
                    "{quantity}, order {order}",
                    quantity=signal_text(row.signal),
                    order=order_text(row.order),
                ),
                "%",
                digits=3,
                fixed=True,
            )
            for row in rows
        ),
    )
    paths = [path for path in found.tolerances if path not in found.idle]
    paths.sort(key=lambda path: -max((row.shares.get(path, 0.0) for row in rows), default=0.0))
    body: list[tuple[Value, ...]] = []
    for path in paths:
        shares = [row.shares.get(path, 0.0) for row in rows]
        cells = (round(100 * each, 1) + 0.0 for each in shares)
        if max(shares, default=0.0) >= SMALL_SHARE:
            body.append((path, *cells))
    said = _("Share of each tolerance in the variance of the scatter.")
    return Table(_("Which tolerance matters"), columns, tuple(body), (said,))


def _tolerance_table(found: Scatter) -> Table:
    """The tolerances with the number of independent errors of each."""
    counts: dict[str, int] = {}
    for error in found.errors:
        counts[error.path] = counts.get(error.path, 0) + 1
    columns = (
        Column(_("tolerance"), kind="text", key="path", label=True),
        Column(_("value"), kind="text", optional=1),
        Column(_("within"), kind="text"),
        Column("", key="value", machine=True),
        Column("", key="bound", machine=True),
        Column(_("independent errors"), key="errors"),
        Column(_("source"), kind="text", optional=2),
        Column("", kind="text", key="source", machine=True),
    )
    body = tuple(
        (
            path,
            _value(own.value, own, found.engine),
            _("± {bound}", bound=_value(own.bound, own, found.engine)),
            own.value,
            own.bound,
            counts.get(path, 0),
            _assumed(found, path) or None,
            found.assumed.get(path) or None,
        )
        for path, own in found.tolerances.items()
    )
    return Table(_("Tolerances"), columns, body, key="tolerances")


def _assumed(found: Scatter, path: str) -> str:
    return _("assumed ({source})", source=found.assumed[path]) if path in found.assumed else ""


def _value(value: float, own: Tolerance, engine: Engine) -> str:
    if own.quantity.relative_to & set(engine.relative):
        return number(value)
    return text(value, own.quantity, digits=5)


def sentences(found: Scatter, signals: Sequence[str] = WHOLE) -> list[str]:
    """What the scatter does to engines as they are built: the greatest of each signal."""
    lines: list[str] = []
    for name in signals:
        own = [row for row in found.rows if is_of(row, name)]
        told = [row for row in own if row.one_in_20 > LARGER * row.nominal]
        if not told:
            continue
        row = max(told, key=lambda row: row.one_in_20 - row.nominal)
        values = {
            "quantity": signal_text(row.signal),
            "size": _rounded(row.one_in_20, row.unit),
            "order": order_text(row.order),
            "worst": _rounded(row.worst, row.unit),
            "share": "5 %",
        }
        if row.nominal:
            lines.append(
                _(
                    "Of engines built to these tolerances {share} have more than {size} of the "
                    "{quantity} of order {order} (as drawn {nominal}); at worst it is {worst}.",
                    nominal=quantity_text(row.nominal, row.unit, beside=row.one_in_20),
                    **values,
                )
            )
        else:
            lines.append(
                _(
                    "As drawn there is no {quantity} of order {order}; of engines built to these "
                    "tolerances {share} have more than {size}, at worst {worst}.",
                    **values,
                )
            )
        lines += _most(row)
    if not lines:
        lines.append(
            _(
                "With these tolerances no order is more than {share} greater than as drawn in one "
                "of 20 engines.",
                share="2 %",
            )
        )
    return lines


def _rounded(size: float, unit: str) -> str:
    return quantity_text(float(f"{size:.4g}"), unit)


def _most(row: OrderScatter) -> list[str]:
    if len(row.shares) < 2:
        return []
    path, share = next(iter(row.shares.items()))
    return [
        _(
            "The greatest part of that scatter, {share} of its variance, is due to {path}.",
            share=f"{number(round(100 * share, 1))} %",
            path=path,
        )
    ]


def _notes(found: Scatter) -> list[str]:
    """What the numbers mean, and what is left out."""
    count = len(found.errors)
    lines = [
        _n(
            "{count} error, independent of all others.",
            "{count} errors, each independent of all others.",
            count,
            count=count,
        )
    ]
    if found.distribution == "normal":
        lines.append(
            _(
                "An error is normal, its standard deviation a third of the tolerance; the worst "
                "case has every error at its tolerance."
            )
        )
    else:
        lines.append(
            _(
                "An error lies anywhere within its tolerance with equal chance; the worst case has "
                "every error at its tolerance."
            )
        )
    lines.append(
        _(
            "Scatter and worst case are those of the linear law, what engines exceed that of "
            "{builds} engines built at random; their scatter agrees with the law to {apart} %.",
            builds=number(found.count),
            apart=number(float(f"{100 * agreement(found):.2g}")),
        )
    )
    lines.append(
        _(
            "Amplitudes are the greatest values over a turn; the rms of a force or couple has "
            "both of its components."
        )
    )
    if found.idle:
        lines.append(
            _("No force depends on {paths}, or its tolerance is 0.", paths=", ".join(found.idle))
        )
    if any(is_of(row, BEARING) for row in found.rows):
        lines.append(
            _(
                "Bearing loads are those of inertia and weights on a crankshaft hinged at each "
                "main bearing, to first order in the errors; the bearings stay where they are."
            )
        )
        lines.append(_("Gas and the twist of the crankshaft are left out."))
    else:
        lines.append(_("Bearing loads, gas and the twist of the crankshaft are left out."))
    return lines


def agreement(found: Scatter) -> float:
    """By how much the scatter of the random engines differs from the law, where it is greatest."""
    out = 0.0
    for name in WHOLE:
        own = [row for row in found.rows if row.signal == name and row.rms > 0]
        if own:
            row = max(own, key=lambda row: row.rms)
            out = max(out, abs(row.rms_found / row.rms - 1))
    return out


def _doubts(found: Scatter) -> list[str]:
    doubted = wide(found.tolerances.values())
    if not found.assumed:
        return doubted
    return [
        *doubted,
        _(
            "Assumed: {paths}, as service manuals of car engines allow ({sources}); the references "
            "are in the documents.",
            paths=listed([*found.assumed]),
            sources=", ".join(dict.fromkeys(found.assumed.values())),
        ),
    ]
