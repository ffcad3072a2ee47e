"""A sweep: its values with what is watched, each curve in one line, and the best value."""

from __future__ import annotations

from collections.abc import Sequence

from crankstar.language.messages import _
from crankstar.language.numbers import NEGLIGIBLE, number
from crankstar.language.shown_units import quantity_text
from crankstar.studies.best_value import Best
from crankstar.studies.sweep import Curve, Sweep, rows
from crankstar.tables.table import ROW_UNIT, Column, Document, Kind, Remarks, Table, Value

FOUND = 1e-7
"""Share of the greatest value of a curve to which its best value is found; less is zero."""
ROWS = 13
BARS = "▁▂▃▄▅▆▇█"
"""Eighths of the greatest value: a curve in one line."""
COLUMNS = 60


def sweep_document(
    sweep: Sweep, curves: Sequence[Curve], found: Sequence[Best], *, greatest: bool = False
) -> Document:
    """The values of a sweep, evenly chosen, each curve in one line, and the best values."""
    count = _shown(sweep.values.size)
    whole = len(sweep.values)
    values = {"shown": count, "count": whole, "path": sweep.path}
    title = _("{count} values of {path}", **values)
    if count < whole:
        title = _("{shown} of {count} values of {path} (--csv writes all)", **values)
    table = _table(sweep, curves, title, count=count)
    bests = [
        best_sentence(sweep, curve, best, greatest=greatest)
        for curve, best in zip(curves, found, strict=True)
    ]
    bars = [f"{curve.label}: {_bars(curve)}" for curve in curves]
    lines = Remarks((*bars, *bests), _("Curves"))
    return Document(sweep.engine.name, (table, lines))


def answer(sweep: Sweep, curves: Sequence[Curve], found: Sequence[Best]) -> Document:
    """All values of a sweep with its curves, and where each is best."""
    kinds: dict[str, Kind] = {"curve": "text", "unit": "unit"}
    heads = tuple(
        Column(name, ROW_UNIT if name == "result" else "", kinds.get(name, "number"), key=name)
        for name in ("curve", "unit", "value", "result", "at_edge", "flat")
    )
    bests = tuple(
        (curve.label, curve.unit, best.value, best.result, best.at_edge, best.flat)
        for curve, best in zip(curves, found, strict=True)
    )
    table = _table(sweep, curves, "", count=len(sweep.values))
    facts = {"engine": sweep.engine.name, "over": sweep.path, "unit": sweep.unit}
    return Document(sweep.engine.name, (table, Table("", heads, bests, key="best")), facts)


def _table(sweep: Sweep, curves: Sequence[Curve], title: str, *, count: int) -> Table:
    heads = [Column(sweep.path, sweep.unit, key=sweep.path, label=True, fixed=True)]
    heads += [Column(curve.label, curve.unit, key=curve.label) for curve in curves]
    tops = [NEGLIGIBLE * float(curve.values.max()) for curve in curves]
    body: list[tuple[Value, ...]] = []
    for value, *results in rows(sweep, curves, count=count):
        cells = (
            float(result) if result > top else 0.0
            for result, top in zip(results, tops, strict=True)
        )
        body.append((float(value), *(cells if title else map(float, results))))
    return Table(title, tuple(heads), tuple(body), key="values")


def _shown(count: int) -> int:
    """How many values are shown: all of a few, else every n-th, so that even steps stay even."""
    steps = count - 1
    return next(
        (
            steps // every + 1
            for every in range(1, count)
            if steps % every == 0 and steps // every < ROWS
        ),
        ROWS,
    )


def best_sentence(sweep: Sweep, curve: Curve, found: Best, *, greatest: bool = False) -> str:
    """The best value, where else it is as good, and whether it is an end of the range."""
    unit = f" {sweep.unit}" if sweep.unit else ""
    top = float(curve.values.max())
    values = {
        "curve": curve.label,
        "result": quantity_text(
            found.result if found.result > FOUND * top else 0.0, curve.unit, beside=top
        ),
        "path": sweep.path,
        "value": f"{number(found.value)}{unit}",
    }
    if found.flat:
        return _("{curve}: {result} at every value; {path} has no effect.", **values)
    best = _("Least {curve}: {result} at {path} = {value}.", **values)
    if greatest:
        best = _("Greatest {curve}: {result} at {path} = {value}.", **values)
    also = ""
    if found.stretch is not None:
        low, high = found.stretch
        also = _(
            "The value is the same from {low} to {high}{unit}.",
            low=number(low),
            high=number(high),
            unit=unit,
        )
    elif found.also:
        others = ", ".join(number(other) for other in found.also)
        also = _("The value is the same at {others}{unit}.", others=others, unit=unit)
    # Nothing is less than zero, so beyond the end it cannot be better.
    beyond = found.at_edge and (greatest or found.result > FOUND * top)
    edge = _("This is an end of the range; a better value may lie beyond it.") if beyond else ""
    return " ".join(filter(None, (best, also, edge)))


def _bars(curve: Curve) -> str:
    values = curve.values
    top = float(values.max())
    if top <= 0:
        return _("zero")
    count = min(COLUMNS, values.size)
    chosen = [
        float(values[round(place * (values.size - 1) / max(count - 1, 1))])
        for place in range(count)
    ]
    return "".join(BARS[min(7, int(8 * value / top))] for value in chosen)
