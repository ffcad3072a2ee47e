"""A sweep as a table: some of its values with what is watched, and the best value in words."""

from __future__ import annotations

import csv
import io
from collections.abc import Sequence

from rich.console import Group, RenderableType
from rich.text import Text

from crankstar.sweep import Best, Curve, Sweep, rows
from crankstar.wording import NEGLIGIBLE, number, table, titled, unit_text

FOUND = 1e-7
"""Share of the greatest value of a curve to which its best value is found: less is nothing."""
ROWS = 13
BARS = "▁▂▃▄▅▆▇█"
"""Eighths of the greatest value: a curve in one line."""
COLUMNS = 60


def sweep_table(sweep: Sweep, curves: Sequence[Curve], found: Sequence[Best], *, greatest: bool = False) -> RenderableType:
    """The values of a sweep, evenly chosen, with the curves; each curve in one line; and the best value of each."""
    name = f"{sweep.path} [{sweep.unit}]" if sweep.unit else sweep.path
    out = table(name, *(f"{curve.label} [{unit_text(curve.unit)}]" for curve in curves))
    tops = [float(curve.values.max()) for curve in curves]
    count = _shown(sweep.values.size)
    for value, *results in rows(sweep, curves, count=count):
        out.add_row(number(value), *(number(result, top) for result, top in zip(results, tops, strict=True)))
    shown = f"{count} of " if count < sweep.values.size else ""
    more = " (--csv for all)" if shown else ""
    lines = [Text(sweep.engine.name, style="bold"), titled(f"{shown}{len(sweep.values)} values of {sweep.path}{more}", out), Text()]
    lines += [Text(f"{curve.label}: {_bars(curve)}") for curve in curves]
    lines += [Text(best_sentence(sweep, curve, one, greatest=greatest)) for curve, one in zip(curves, found, strict=True)]
    return Group(*lines)


def _shown(count: int) -> int:
    """How many values are shown: all of a few, else every n-th, so that steps stay even where they were."""
    steps = count - 1
    return next((steps // every + 1 for every in range(1, count) if steps % every == 0 and steps // every < ROWS), ROWS)


def best_sentence(sweep: Sweep, curve: Curve, found: Best, *, greatest: bool = False) -> str:
    """The best value in words, where else it is as good, and whether it is an end of the range."""
    unit = f" {sweep.unit}" if sweep.unit else ""
    what = "Greatest" if greatest else "Least"
    result = f"{number(found.result, FOUND / NEGLIGIBLE * float(curve.values.max()))} {unit_text(curve.unit)}"
    if found.flat:
        return f"{curve.label}: {result} at every value; {sweep.path} makes no difference to it."
    told = f"{what} {curve.label}: {result} at {sweep.path} = {number(found.value)}{unit}"
    if found.stretch is not None:
        low, high = found.stretch
        told += f", and all the way from {number(low)} to {number(high)}{unit}"
    elif found.also:
        told += f", and as good at {', '.join(number(other) for other in found.also)}{unit}"
    beyond = found.at_edge and (greatest or found.result > FOUND * float(curve.values.max()))  # nothing is less than none
    return told + (", an end of the range: it may be better beyond." if beyond else ".")


def _bars(curve: Curve) -> str:
    values = curve.values
    top = float(values.max())
    if top <= 0:
        return "nothing"
    count = min(COLUMNS, values.size)
    chosen = [float(values[round(place * (values.size - 1) / max(count - 1, 1))]) for place in range(count)]
    return "".join(BARS[min(7, int(8 * value / top))] for value in chosen)


def csv_text(sweep: Sweep, curves: Sequence[Curve]) -> str:
    """All values of a sweep with its curves as CSV, a row per value, units in the header."""
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    writer.writerow([_head(sweep.path, sweep.unit), *(_head(curve.label, curve.unit) for curve in curves)])
    writer.writerows(rows(sweep, curves, count=sweep.values.size))
    return out.getvalue()


def _head(name: str, unit: str) -> str:
    return f"{name} [{unit}]" if unit else name
