"""A sweep: its values with what is watched, each curve in one line, and the best value.

One table for readers, and two for machines: a row for each value, or a row for each amplitude.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import isnan

import numpy as np

from crankstar.analysis.document import (
    ROW_UNIT,
    Column,
    Document,
    Kind,
    Ranged,
    Remarks,
    Table,
    Value,
)
from crankstar.language.messages import _, passage
from crankstar.language.numbers import NEGLIGIBLE, number, rpm_of
from crankstar.language.shown_units import quantity_text
from crankstar.mechanics.labelled import AXIAL, VECTORS
from crankstar.spectra import Real
from crankstar.studies.best_value import Best
from crankstar.studies.sweep import Curve, Sweep
from crankstar.tables import ranges
from crankstar.tables.sweep_notes import doubt_sentences, is_forced, notes
from crankstar.tables.sweep_ranges import Band, estimate_remarks, ranged_text

FOUND = 1e-7
"""Share of the greatest value of a curve to which its best value is found; less is zero."""
ROWS = 13
BARS = "▁▂▃▄▅▆▇█"
"""Eighths of the greatest value: a curve in one line."""
COLUMNS = 60


def sweep_document(
    sweep: Sweep,
    curves: Sequence[Curve],
    found: Sequence[Best],
    *,
    bands: Sequence[Band | None] = (),
    greatest: bool = False,
) -> Document:
    """The values of a sweep, evenly chosen, each curve in one line, and the best values."""
    chosen = evenly(sweep.values.size)
    values = {"shown": len(chosen), "count": sweep.values.size, "path": sweep.path}
    title = _("{count} values of {path}", **values)
    if len(chosen) < sweep.values.size:
        title = _("{shown} of {count} values of {path} (--csv writes all)", **values)
    ranged = list(bands) or [None] * len(curves)
    table = _table(sweep, curves, ranged, title, chosen)
    bests = [
        best_sentence(sweep, curve, best, band, greatest=greatest)
        for curve, best, band in zip(curves, found, ranged, strict=True)
    ]
    bars = [f"{curve.label}: {_bars(curve)}" for curve in curves]
    lines = Remarks((*bars, *bests), _("Curves"))
    head = estimate_remarks(sweep, ranged)
    return Document(sweep.engine.name, (*head, table, lines, *notes(sweep, curves)))


def answer(
    sweep: Sweep,
    curves: Sequence[Curve],
    found: Sequence[Best],
    *,
    bands: Sequence[Band | None] = (),
) -> Document:
    """All values of a sweep with its curves, and where each is best."""
    ranged = list(bands) or [None] * len(curves)
    heads = tuple(
        Column(name, ROW_UNIT if name == "result" else "", KINDS.get(name, "number"), key=name)
        for name in ("curve", "unit", "value", "result", "at_edge", "at_gap", "flat")
    )
    bests = tuple(
        (
            curve.label,
            curve.unit,
            best.value,
            best.result if band is None else band.best,
            best.at_edge,
            best.at_gap,
            best.flat,
        )
        for curve, best, band in zip(curves, found, ranged, strict=True)
    )
    return Document(
        sweep.engine.name,
        (every_value(sweep, curves, ranged), Table("", heads, bests, key="best")),
        {
            **facts(sweep, curves),
            "over": sweep.path,
            "unit": sweep.unit,
            "doubts": doubt_sentences(sweep, curves),
        },
    )


KINDS: dict[str, Kind] = {"curve": "text", "unit": "unit"}


def facts(sweep: Sweep, curves: Sequence[Curve] = ()) -> dict[str, object]:
    """Engine, speed and what is varied, for machines; of vibration whether it is the maximum."""
    axes = [
        {
            "path": axis.path,
            "unit": axis.unit,
            "from": float(axis.values[0]),
            "to": float(axis.values[-1]),
            "count": int(axis.values.size),
            "closed": axis.closed,
        }
        for axis in sweep.axes
    ]
    rpm = {
        name: rpm_of(speed)
        for name, speed in (("speed_rpm", sweep.speed), ("highest_speed_rpm", sweep.highest_speed))
    }
    forced = is_forced(curves) and sweep.highest_speed is None
    over_all = {"maximum_over_speeds": not sweep.alone} if forced else {}
    counted = {**over_all, "units": sweep.units._asdict(), "axes": axes}
    return {"engine": sweep.engine.name, **rpm, **counted, **ranges.facts(sweep.engine)}


def every_value(sweep: Sweep, curves: Sequence[Curve], bands: Sequence[Band | None] = ()) -> Table:
    """All values of a sweep with its curves: a row for each value, or pair of values."""
    ranged = list(bands) or [None] * len(curves)
    heads = [*axis_columns(sweep), *_curve_columns(curves, ranged)]
    results = [_results(*pair) for pair in zip(curves, ranged, strict=True)]
    columns = [column.tolist() for column in sweep.columns().values()]
    return Table("", tuple(heads), tuple(zip(*columns, *results, strict=True)), key="values")


def _curve_columns(curves: Sequence[Curve], bands: Sequence[Band | None]) -> list[Column]:
    return [
        Column(curve.label, curve.unit, key=curve.label, estimated=band is not None)
        for curve, band in zip(curves, bands, strict=True)
    ]


def _results(curve: Curve, band: Band | None) -> list[Value]:
    """The results of a curve, with their ranges."""
    cells = curve.values.ravel().tolist() if band is None else band.cells
    return [None if isinstance(cell, float) and isnan(cell) else cell for cell in cells]


def axis_columns(sweep: Sweep) -> list[Column]:
    """A column for each number that is varied."""
    return [
        Column(axis.path, axis.unit, key=axis.path, label=True, fixed=True) for axis in sweep.axes
    ]


WAYS = {
    "": "greatest",
    "up": "vertical",
    "right": "horizontal",
    "pitch": "vertical",
    "yaw": "horizontal",
    "forward": "forward",
    "backward": "backward",
}
"""The direction of what is watched, as tables of amplitudes name it."""


def amplitudes(
    sweep: Sweep, curves: Sequence[Curve], bands: Sequence[Band | None] = ()
) -> Document:
    """The results as a tidy table: one row an amplitude.

    Direction `greatest` is the greatest value of a vector over a turn; an empty order stands for
    all orders together.
    """
    heads = [Column("engine", kind="text", key="engine", label=True), *axis_columns(sweep)]
    heads += [
        Column(name, kind="text" if name != "order" else "number", key=name)
        for name in ("order", "quantity", "direction")
    ]
    heads += [
        Column("amplitude", ROW_UNIT, key="amplitude", estimated=any(bands)),
        Column("unit", kind="unit", key="unit"),
    ]
    places = [*zip(*(column.tolist() for column in sweep.columns().values()), strict=True)]
    rows: list[tuple[Value, ...]] = []
    for curve, band in zip(curves, list(bands) or [None] * len(curves), strict=True):
        quantity, _dot, part = curve.what.partition(".")
        way = WAYS[part] if quantity in VECTORS else AXIAL
        if quantity in VECTORS and way in ("vertical", "horizontal"):
            quantity = VECTORS[quantity][way == "horizontal"]
        labels = (curve.order, quantity, way)
        rows += [
            (sweep.engine.name, *place, *labels, result, curve.unit)
            for place, result in zip(places, _results(curve, band), strict=True)
        ]
    table = Table("", tuple(heads), tuple(rows), key="amplitudes")
    return Document(sweep.engine.name, (table,), facts(sweep))


def _table(
    sweep: Sweep,
    curves: Sequence[Curve],
    bands: Sequence[Band | None],
    title: str,
    chosen: Sequence[int],
) -> Table:
    heads = [*axis_columns(sweep), *_curve_columns(curves, bands)]
    clear = [curve._replace(values=cleared(curve)) for curve in curves]
    results = [_results(*pair) for pair in zip(clear, bands, strict=True)]
    body = zip(
        sweep.values[chosen].tolist(),
        *([each[place] for place in chosen] for each in results),
        strict=True,
    )
    return Table(title, tuple(heads), tuple(body), key="values")


def cleared(curve: Curve) -> Real:
    """The results, those that are rounding errors zero."""
    return np.where(curve.values <= NEGLIGIBLE * curve.top, 0.0, curve.values)


def evenly(count: int, most: int = ROWS) -> list[int]:
    """The places of a few values: of all, else every n-th, so that even steps stay even.

    >>> evenly(5), evenly(21, most=6)
    ([0, 1, 2, 3, 4], [0, 4, 8, 12, 16, 20])
    """
    steps = count - 1
    every = next((n for n in range(1, count) if steps % n == 0 and steps // n < most), None)
    if every is not None:
        return [*range(0, count, every)]
    return sorted({round(place) for place in np.linspace(0, steps, most).tolist()})


def best_sentence(
    sweep: Sweep, curve: Curve, found: Best, band: Band | None = None, *, greatest: bool = False
) -> str:
    """The best value, where else it is as good, and whether it is an end of the range."""
    unit = f" {sweep.unit}" if sweep.unit else ""
    top = curve.top
    values = {
        "curve": curve.label,
        "result": quantity_text(
            found.result if found.result > FOUND * top else 0.0, curve.unit, beside=top
        ),
        "path": sweep.path,
        "value": f"{number(found.value)}{unit}",
    }
    if band is not None and isinstance(band.best, Ranged):
        values["result"] = ranged_text(band.best, curve.unit, beside=top)
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
    reach = ""
    if band is not None and band.reach is not None:
        low, high = map(number, band.reach)
        reach = _(
            "Over the ranges of the estimated values it lies at {low} to {high}{unit}.",
            low=low,
            high=high,
            unit=unit,
        )
    # Nothing is less than zero, so beyond the end it cannot be better.
    beyond = found.at_edge and (greatest or found.result > FOUND * top)
    edge = _("This is an end of the range; a better value may lie beyond it.") if beyond else ""
    gap = _("Beside it nothing could be computed.") if found.at_gap else ""
    return passage((best, also, reach, edge, gap))


def _bars(curve: Curve) -> str:
    values, top = curve.values, curve.top
    if top <= 0:
        return _("zero")
    count = min(COLUMNS, values.size)
    chosen = [
        float(values[round(index * (values.size - 1) / max(count - 1, 1))])
        for index in range(count)
    ]
    return "".join(" " if isnan(value) else BARS[min(7, int(8 * value / top))] for value in chosen)
