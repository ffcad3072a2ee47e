"""Several engines side by side: the greatest value of each order, and the peaks over a turn."""

from __future__ import annotations

from collections.abc import Sequence
from math import pi

from crankstar import spectra
from crankstar.firing.intervals import firing
from crankstar.language.messages import _
from crankstar.language.numbers import NEGLIGIBLE, number, unit_text
from crankstar.mechanics.remains import Sums, size, summed
from crankstar.tables.analysis import QUANTITIES, Analysis, none_line, sums_size, unverified
from crankstar.tables.headings import firing_text
from crankstar.tables.table import Column, Document, Table, Value


def comparison(shown: Sequence[Analysis]) -> Document:
    """The orders of every quantity, a column for each engine, and what the engines are."""
    real = all(analysis.real is not None for analysis in shown)
    results = [analysis.best if real else analysis.normalised for analysis in shown]
    sums = [summed(result) for result in results]
    parts = [_quantity(name, shown, sums, results) for name in Sums._fields]
    title = (
        _("Greatest value of each order")
        if real
        else _("Greatest value of each order, each engine in its own m r ω²")
    )
    return Document(title, (*parts, _engines(shown, real=real)))


def _quantity(
    name: str, shown: Sequence[Analysis], sums: Sequence[Sums], results: Sequence
) -> Table:
    plane = name in ("force", "couple")
    units = dict.fromkeys(
        unit_text(getattr(result.units, name if plane else "moment")) for result in results
    )
    wanted = sorted(
        {order for analysis in shown for order in (analysis.orders if plane else analysis.turning)}
    )
    signals = [getattr(sums_, name) for sums_ in sums]
    least = [NEGLIGIBLE * sums_size(signal) for signal in signals]
    rows: list[tuple[Value, ...]] = []
    zero: list[float] = []
    for order in wanted:
        lengths = [size(signal, order) for signal in signals]
        cells = [
            length if length > floor else 0.0 for length, floor in zip(lengths, least, strict=True)
        ]
        if any(cells):
            rows.append((number(order), *cells))
        else:
            zero.append(order)
    if rows:
        peaks = [spectra.peak(signal).value for signal in signals]
        shown_peaks = (peak if peak > NEGLIGIBLE * max(peaks) else 0.0 for peak in peaks)
        rows.append((_("peak"), *shown_peaks))
    heads = (
        Column(_("order"), kind="text", key="order", label=True),
        *(Column(analysis.engine.name, key=analysis.engine.name) for analysis in shown),
    )
    title = f"{_(QUANTITIES[name]).capitalize()} [{_(' or ').join(units)}]"
    return Table(title, heads, tuple(rows), notes=none_line(zero), key=name)


def _engines(shown: Sequence[Analysis], *, real: bool) -> Table:
    heads = [
        Column(_("engine"), kind="text", wraps=True),
        Column(_("firing"), kind="text", wraps=True),
    ]
    if real:
        heads.append(Column(_("speed"), "rpm"))
    heads.append(Column(_("unverified values")))
    rows: list[tuple[Value, ...]] = []
    for analysis in shown:
        engine = analysis.engine
        fires = firing_text(firing(engine)) if engine.firing_order else _("no order given")
        speed = ((analysis.best.speed or 0) * 30 / pi,) if real else ()
        rows.append((engine.name, fires, *speed, len(unverified(engine))))
    return Table(_("Engines"), tuple(heads), tuple(rows))
