"""Several engines side by side: the greatest value of each order, and the peaks over a turn."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import chain, count
from typing import Any, NamedTuple

from crankstar.analysis.assumptions import Assumption
from crankstar.analysis.document import ROW_UNIT, Column, Document, Ranged, Table, Value, remarks
from crankstar.analysis.registry import added, analyses
from crankstar.engine.engine import Engine
from crankstar.language.alike import of_any
from crankstar.language.messages import _, spoken
from crankstar.language.numbers import NEGLIGIBLE, rpm_of
from crankstar.mechanics.balance import Balance
from crankstar.mechanics.bounds import peak, size
from crankstar.mechanics.excitation import Reference
from crankstar.mechanics.operating_points import speed_beside
from crankstar.mechanics.remains import Sums, summed
from crankstar.tables.analysis import Analysis, analysis
from crankstar.tables.assumptions import assumption_facts, side_by_side
from crankstar.tables.by_order import QUANTITIES, none_line, sums_size
from crankstar.tables.compared_speeds import speed_head
from crankstar.tables.conditions import unverified
from crankstar.tables.headings import firing_text

PLANE = ("force", "couple")
"""Vectors across the crankshaft; the others turn about it."""

GREATEST = 4
"""The column of the greatest value in the table for machines."""
MOST_TIMES = 1000.0
"""From so many times the value of the first engine on, the share says nothing: that has none."""


def told_apart(names: Sequence[str], *marks: Sequence[str]) -> list[str]:
    """Names that differ: the same ones with the first of the marks by which they differ.

    Those that differ in no mark are counted.

    >>> told_apart(["V8", "V8", "I4"], ["a.toml", "b.toml", "c.toml"])
    ['V8 (a.toml)', 'V8 (b.toml)', 'I4']
    >>> told_apart(["V8", "V8", "V8 (2)"])
    ['V8 (1)', 'V8 (3)', 'V8 (2)']
    """
    out: list[str] = []
    for index, name in enumerate(names):
        alike = [other for other, same in enumerate(names) if same == name]
        differing = (mark for mark in marks if len({mark[i] for i in alike}) == len(alike))
        mark = next(differing, None)
        own = (mark[index] or _("as in the file"),) if mark is not None else ()
        numbers = map(str, count(alike.index(index) + 1))
        told = (f"{name} ({each})" for each in chain(own, numbers))
        taken = {*out, *names}
        out.append(name if len(alike) == 1 else next(each for each in told if each not in taken))
    return out


class _Compared(NamedTuple):
    """What stands in the tables of a comparison: the engines, their names, results and sums."""

    shown: Sequence[Analysis]
    names: Sequence[str]
    results: Sequence[Balance]
    sums: Sequence[Sums]
    real: bool


def _compared(shown: Sequence[Analysis], names: Sequence[str] | None) -> _Compared:
    """In newtons where all engines can be."""
    real = all(analysis.real is not None for analysis in shown)
    results = [analysis.best if real else analysis.normalised for analysis in shown]
    own = told_apart([analysis.engine.name for analysis in shown]) if names is None else names
    return _Compared(shown, own, results, [summed(result) for result in results], real)


def comparison(shown: Sequence[Analysis], names: Sequence[str] | None = None) -> Document:
    """The orders of every quantity, engine by engine, absolute and as a share of the first.

    `names` are those of the engines, by default their own, told apart.
    """
    compared = _compared(shown, names)
    real = compared.real
    parts = [_quantity(name, compared) for name in Sums._fields]
    title = (
        _("Greatest value of each order")
        if real
        else _("Greatest value of each order, each engine in its own m r ω²")
    )
    responses = _of_analyses(compared)
    tables = (*parts, *_with_gas(compared), *responses, _engines(compared))
    return Document(title, (*remarks(_speed_head(compared)), *tables))


def _speed_head(compared: _Compared) -> str:
    """At which speed the engines are; empty where forces are in m r omega^2."""
    engines = [shown.engine for shown in compared.shown]
    return speed_head(engines, compared.names, [result.speed for result in compared.results])


def _with_gas(compared: _Compared) -> tuple[Table, ...]:
    """Torque of gas and inertia, where the files of all engines say what the gas does."""
    engines = [shown.engine for shown in compared.shown]
    if any(engine.gas is None for engine in engines):
        return ()
    from crankstar.tables.gas_comparison import gas_comparison

    return gas_comparison(engines, compared.names, _speeds(compared), orders=_asked(compared))


def _of_analyses(compared: _Compared) -> tuple[Table, ...]:
    """The analyses of those engines whose files have what they are of."""
    engines = [shown.engine for shown in compared.shown]
    tables: list[Table] = []
    for record in analyses():
        if record.compared is None:
            continue
        with added().among_others(record.name):
            if any(map(record.tells, engines)):
                tables += record.compared.value(engines, compared.names, _speeds(compared))
    return tuple(tables)


def _speeds(compared: _Compared) -> list[float | None]:
    """The speed of each engine: gas has one too where forces are in m r omega^2."""
    return [shown.speed if shown.real is None else shown.real.speed for shown in compared.shown]


def _asked(compared: _Compared) -> tuple[float, ...]:
    """The orders that were asked for; none where those that matter are shown."""
    first = compared.shown[0]
    return first.orders if first.asked else ()


def _gas_rows(compared: _Compared) -> tuple[list[tuple[Value, ...]], dict[str, Any]]:
    """The same as rows for machines, and the speed and operating point of each engine."""
    engines = [shown.engine for shown in compared.shown]
    if any(engine.gas is None for engine in engines):
        return [], {}
    from crankstar.tables.gas_comparison import gas_cycles, gas_sizes, gas_state_facts

    cycles = gas_cycles(engines, _speeds(compared))
    rows: list[tuple[Value, ...]] = [
        ("torque_with_gas", order, name, rpm_of(own.speed), cell, "N*m", _share(cell, cells[0], 1))
        for order, cells in gas_sizes(engines, compared.names, cycles, _asked(compared))
        for name, own, cell in zip(compared.names, cycles, cells, strict=True)
    ]
    return rows, {"gas": gas_state_facts(compared.names, cycles)} if cycles else {}


def compare(
    *engines: Engine,
    speed: float | None = None,
    reference: Reference | None = None,
    orders: Sequence[float] = (),
) -> Document:
    """The comparison of engines at `speed` (rad/s), else at their own, in tables for readers.

    Where one of them has no speed all are at `common_speed`.

    >>> from crankstar.files.catalog import load
    >>> compare(load("i4"), load("i6"), orders=[2]).tables.__next__().columns[2].heading
    'Six in line'
    """
    turning = speed_beside(engines, speed)
    shown = [analysis(each, speed=turning, reference=reference).of(orders) for each in engines]
    return comparison(shown)


def _sizes(name: str, compared: _Compared) -> list[tuple[float | None, list[float]]]:
    """The greatest value of each order by engine, nought where negligible; None: over a turn."""
    signals = [getattr(sums, name) for sums in compared.sums]
    least = [NEGLIGIBLE * sums_size(signal) for signal in signals]
    plane = name in PLANE
    wanted = {
        order
        for analysis in compared.shown
        for order in (analysis.orders if plane else analysis.turning)
    }
    rows: list[tuple[float | None, list[float]]] = []
    for order in sorted(wanted):
        lengths = [size(signal, order) for signal in signals]
        pairs = zip(lengths, least, strict=True)
        rows.append((order, [length if length > floor else 0.0 for length, floor in pairs]))
    peaks = [peak(signal).value for signal in signals]
    rows.append((None, [each if each > NEGLIGIBLE * max(peaks) else 0.0 for each in peaks]))
    return rows


def _share(value: float, first: float, whole: float) -> float | None:
    """Of the value of the first engine, which is `whole`; None where that is next to nothing."""
    return whole * value / first if MOST_TIMES * first > value else None


def resting(
    document: Document, found: Sequence[Sequence[Assumption]], names: Sequence[str]
) -> Document:
    """The comparison with what each engine rests on, for machines too.

    What matters most of each stands below the first table, on the first screen; the rest at the
    end.
    """
    first, rest = side_by_side(found, names)
    parts = [*document.parts]
    headline = next((n for n, part in enumerate(parts) if isinstance(part, Table)), -1)
    parts[headline + 1 : headline + 1] = first
    rows = [
        {"engine": name, **row}
        for own, name in zip(found, names, strict=True)
        for row in assumption_facts(own).get("rests_on", ())
    ]
    facts = {**document.facts, **({"rests_on": rows} if rows else {})}
    return replace(document, parts=(*parts, *rest), facts=facts)


def with_shares(document: Document, engines: Sequence[Engine]) -> Document:
    """The comparison of engines with the shares that follow from ranges, if it has any.

    The ranges of two engines are independent: the least share is the least over the greatest. Where
    the first may be nought there is none. The same parts (`same_parts`) move together in both.
    """
    free = [not same_parts(engines[0], engine) for engine in engines]
    parts = [
        _with_shares(part, free) if isinstance(part, Table) and part.key else part
        for part in document.parts
    ]
    return replace(document, parts=tuple(parts))


def same_parts(first: Engine, other: Engine) -> bool:
    """Whether the estimated values of two engines are of one engine, or equal one by one."""
    own, its = (
        {path: source for path, source in engine.provenance.items() if source.range}
        for engine in (first, other)
    )
    return own.keys() == its.keys() and (first.name == other.name or own == its)


def _with_shares(table: Table, free: Sequence[bool]) -> Table:
    flat, count = table.key == "amplitudes", len(free)
    if not any(isinstance(cell, Ranged) for row in table.rows for cell in row):
        return table
    rows: list[tuple[Value, ...]] = []
    for index, row in enumerate(table.rows):
        if flat:
            first = table.rows[index - index % count][GREATEST]
            own = free[index % count] and index % count
            rows.append((*row[:-1], _ranged_share(row[GREATEST], first, 1) if own else row[-1]))
        else:
            shares = [
                _ranged_share(cell, row[1], 100) if independent else own
                for independent, cell, own in zip(
                    free[1:], row[2 : count + 1], row[count + 1 :], strict=True
                )
            ]
            rows.append((*row[: count + 1], *shares))
    columns = [
        replace(column, estimated=any(isinstance(row[index], Ranged) for row in rows))
        for index, column in enumerate(table.columns)
    ]
    return replace(table, columns=tuple(columns), rows=tuple(rows))


def _ranged_share(value: Value, first: Value, whole: float) -> Value:
    """Value over first, in ranges where these have any; None without one."""
    sizes = [
        (abs(each.value), each.low, each.high) if isinstance(each, Ranged) else (each, each, each)
        for each in (value, first)
        if isinstance(each, Ranged | int | float)
    ]
    if len(sizes) < 2 or not sizes[1][1]:
        return None
    (size, low, high), (base, least, most) = sizes
    if size >= MOST_TIMES * base:
        return None
    if not high or not (isinstance(value, Ranged) or isinstance(first, Ranged)):
        return whole * size / base
    return Ranged(whole * size / base, whole * low / most, whole * high / least)


def _quantity(name: str, compared: _Compared) -> Table:
    *orders, (_whole, peaks) = _sizes(name, compared)
    left = of_any(("compared", name), [order for order, cells in orders if any(cells)])
    rows: list[tuple[Value, list[float]]] = [
        (order, cells) for order, cells in orders if order in left
    ]
    if rows:
        rows.append((_("peak"), peaks))
    shares = [
        Column(
            _("{engine}, of the first", engine=name) if len(compared.names) > 2 else _("share"),
            "%",
            digits=4,
            optional=1,
            key=_("{engine}, of the first", engine=name),
        )
        for name in compared.names[1:]
    ]
    heads = (
        Column(_("order"), kind="text", key="order", label=True),
        *(
            Column(engine, _unit(result, name), key=engine)
            for engine, result in zip(compared.names, compared.results, strict=True)
        ),
        *shares,
    )
    body: list[tuple[Value, ...]] = [
        (label, *cells, *(_share(cell, cells[0], 100) for cell in cells[1:]))
        for label, cells in rows
    ]
    title = _(QUANTITIES[name]).capitalize()
    zero = [order for order, _cells in orders if order is not None and order not in left]
    return Table(title, heads, tuple(body), notes=none_line(zero), key=name)


def _unit(result: Balance, name: str) -> str:
    return getattr(result.units, name if name in PLANE else "moment")


def answer(shown: Sequence[Analysis], names: Sequence[str] | None = None) -> Document:
    """The comparison for machines: one row for a quantity, an order and an engine.

    `share` is of the first engine, null where that has none; `order` is null for the peak over a
    turn of all orders together.
    """
    compared = _compared(shown, names)
    heads = (
        Column("quantity", kind="text", key="quantity", label=True),
        Column("order", key="order", label=True),
        Column("engine", kind="text", key="engine", label=True),
        Column("speed_rpm", key="speed_rpm"),
        Column("greatest", ROW_UNIT, key="greatest"),
        Column("unit", kind="unit", key="unit"),
        Column("share", key="share"),
    )
    rows: list[tuple[Value, ...]] = []
    for name in Sums._fields:
        for order, cells in _sizes(name, compared):
            for engine, result, cell in zip(compared.names, compared.results, cells, strict=True):
                share = _share(cell, cells[0], 1)
                rows.append(
                    (name, order, engine, rpm_of(result.speed), cell, _unit(result, name), share)
                )
    with_gas, facts = _gas_rows(compared)
    rows += [*with_gas, *_response_rows(compared)]
    title = ", ".join(compared.names)
    tables = (Table("", heads, tuple(rows), key="amplitudes"), _engine_rows(compared))
    with spoken("en"):
        head = _speed_head(compared)
    return Document(title, tables, facts | ({"at_speed": head} if head else {}))


def _response_rows(compared: _Compared) -> list[tuple[Value, ...]]:
    """The analyses of those engines that have what they are of."""
    engines = [shown.engine for shown in compared.shown]
    rows: list[tuple[Value, ...]] = []
    for record in analyses():
        if record.sizes is None:
            continue
        with added().among_others(record.name):
            having = [record.tells(engine) for engine in engines]
            sizes = record.sizes.value(engines, _speeds(compared)) if any(having) else []
            for what, order, cells, unit in sizes:
                for has, engine, result, cell in zip(
                    having, compared.names, compared.results, cells, strict=True
                ):
                    share = _share(cell, cells[0] or 0.0, 1) if cell else None
                    row = (what, order, engine, rpm_of(result.speed), cell, unit, share)
                    rows += [row] if has else []
    return rows


def _engines(compared: _Compared) -> Table:
    heads = [
        Column(_("engine"), kind="text", wraps=True),
        Column(_("firing"), kind="text", wraps=True),
    ]
    if compared.real:
        heads.append(Column(_("speed"), "rpm"))
    heads.append(Column(_("unverified values")))
    rows: list[tuple[Value, ...]] = []
    for name, own, result in zip(compared.names, compared.shown, compared.results, strict=True):
        speed = (rpm_of(result.speed),) if compared.real else ()
        rows.append((name, _fires(own.engine), *speed, len(unverified(own.engine))))
    return Table(_("Engines"), tuple(heads), tuple(rows))


def _engine_rows(compared: _Compared) -> Table:
    """The same for machines."""
    heads = (
        Column("engine", kind="text", key="engine", label=True),
        Column("firing", kind="text", key="firing"),
        Column("speed_rpm", key="speed_rpm"),
        Column("file_speed_rpm", key="file_speed_rpm"),
        Column("unverified", key="unverified"),
    )
    with spoken("en"):
        rows: list[tuple[Value, ...]] = [
            (
                name,
                _fires(own.engine),
                rpm_of(result.speed),
                rpm_of(own.engine.speed),
                len(unverified(own.engine)),
            )
            for name, own, result in zip(
                compared.names, compared.shown, compared.results, strict=True
            )
        ]
    return Table("", heads, tuple(rows), key="engines")


def _fires(engine: Engine) -> str:
    """The firing order in words."""
    return firing_text(engine) if engine.firing_order else _("no order given")
