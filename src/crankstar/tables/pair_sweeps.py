"""A sweep of two numbers: each result over both, the best pair, and the pairs that none beats."""

from __future__ import annotations

from collections.abc import Sequence
from math import isnan

import numpy as np

from crankstar.analysis.document import ROW_UNIT, Column, Document, Remarks, Table
from crankstar.language.messages import _, _n, passage
from crankstar.language.numbers import number
from crankstar.language.shown_units import quantity_text
from crankstar.language.written import capitalised
from crankstar.studies.best_pair import BestPair, Unbeaten
from crankstar.studies.sweep import Curve, Sweep
from crankstar.tables.sweep_notes import doubt_sentences, notes
from crankstar.tables.sweep_ranges import estimate_remarks
from crankstar.tables.sweeps import FOUND, KINDS, axis_columns, cleared, evenly, every_value, facts

ACROSS = 7
"""Values of the second number in a table for readers."""
LISTED = 13
"""Pairs of the front in a table for readers."""


def pair_document(
    sweep: Sweep,
    curves: Sequence[Curve],
    found: Sequence[BestPair],
    front: Sequence[Unbeaten] = (),
    *,
    greatest: bool = False,
) -> Document:
    """Each result over both numbers, evenly chosen; the best pairs; the front of two results."""
    tables = [_over_both(sweep, curve) for curve in curves]
    bests = [
        best_sentence(sweep, curve, best, greatest=greatest)
        for curve, best in zip(curves, found, strict=True)
    ]
    parts = (*estimate_remarks(sweep), *tables, Remarks(tuple(bests), _("Best values")))
    if front:
        parts = (*parts, _front_table(sweep, curves, front, greatest=greatest))
    return Document(sweep.engine.name, (*parts, *notes(sweep, curves)))


def _over_both(sweep: Sweep, curve: Curve) -> Table:
    """A result: the first number down, the second across."""
    down, across = sweep.axes
    rows, columns = evenly(down.values.size), evenly(across.values.size, ACROSS)
    unit = f" {across.unit}" if across.unit else ""
    heads = [
        Column(f"{number(value)}{unit}", curve.unit) for value in across.values[columns].tolist()
    ]
    shown = cleared(curve)[np.ix_(rows, columns)].tolist()
    cells = [[None if isnan(cell) else cell for cell in row] for row in shown]
    body = [(value, *row) for value, row in zip(down.values[rows].tolist(), cells, strict=True)]
    names = {"quantity": curve.label, "down": down.path, "across": across.path}
    title = _("{quantity}: {down} down, {across} across", **names)
    notes: tuple[str, ...] = ()
    if curve.values.size > len(rows) * len(columns):
        notes = (
            _(
                "{shown} of {count} pairs of values; --csv writes all.",
                shown=len(rows) * len(columns),
                count=curve.values.size,
            ),
        )
    return Table(capitalised(title), (axis_columns(sweep)[0], *heads), tuple(body), notes=notes)


def best_sentence(sweep: Sweep, curve: Curve, found: BestPair, *, greatest: bool = False) -> str:
    """The best pair of values, how many others are as good, and whether it is an end of a range."""
    top = curve.top
    clear = found.result if found.result > FOUND * top else 0.0
    values = {
        "curve": curve.label,
        "result": quantity_text(clear, curve.unit, beside=top),
        "first": _place(sweep, found, 0),
        "second": _place(sweep, found, 1),
    }
    if found.flat:
        return _("{curve}: {result} at every pair of values; neither has an effect.", **values)
    best = _("Least {curve}: {result} at {first}, {second}.", **values)
    if greatest:
        best = _("Greatest {curve}: {result} at {first}, {second}.", **values)
    also = ""
    if found.ridge:
        also = _("It is one of many: the best pairs lie on a line.")
    elif found.also:
        also = _n(
            "It is the same at {count} other pair.",
            "It is the same at {count} other pairs.",
            found.also,
            count=found.also,
        )
    ends = [axis.path for axis, edge in zip(sweep.axes, found.at_edge, strict=True) if edge]
    beyond = ends and (greatest or clear)
    edge = ""
    if beyond:
        edge = _(
            "This is an end of the range of {paths}; a better value may lie beyond it.",
            paths=", ".join(ends),
        )
    return passage((best, also, edge))


def _place(sweep: Sweep, found: BestPair, which: int) -> str:
    axis = sweep.axes[which]
    unit = f" {axis.unit}" if axis.unit else ""
    return f"{axis.path} = {number(found.values[which])}{unit}"


def _front_table(
    sweep: Sweep, curves: Sequence[Curve], front: Sequence[Unbeaten], *, greatest: bool
) -> Table:
    """The pairs of values that no other one beats in both results."""
    heads = (*axis_columns(sweep), *(Column(curve.label, curve.unit) for curve in curves))
    tops = [FOUND * curve.top for curve in curves]
    rows = [
        (*pair.values, *(r if r > top else 0.0 for r, top in zip(pair.results, tops, strict=True)))
        for pair in (front[place] for place in evenly(len(front), LISTED))
    ]
    names = {"first": curves[0].label, "second": curves[1].label}
    title = _("Front of {first} and {second}", **names)
    note = _("No other pair of values has less of one without more of the other.")
    if greatest:
        note = _("No other pair of values has more of one without less of the other.")
    notes = [note]
    if len(rows) < len(front):
        notes.append(_("{shown} of {count}; --json has all.", shown=len(rows), count=len(front)))
    return Table(title, heads, tuple(rows), notes=tuple(notes))


def answer(
    sweep: Sweep, curves: Sequence[Curve], found: Sequence[BestPair], front: Sequence[Unbeaten] = ()
) -> Document:
    """All pairs of values with the results, where each is best, and the front."""
    heads = [
        *(Column(name, kind=KINDS[name], key=name) for name in ("curve", "unit")),
        *axis_columns(sweep),
        Column("result", ROW_UNIT, key="result"),
        *(Column(name, key=name) for name in ("at_edge", "flat", "also", "ridge")),
    ]
    rows = tuple(
        (
            curve.label,
            curve.unit,
            *best.values,
            best.result,
            any(best.at_edge),
            best.flat,
            best.also,
            best.ridge,
        )
        for curve, best in zip(curves, found, strict=True)
    )
    parts = [every_value(sweep, curves), Table("", tuple(heads), rows, key="best")]
    if front:
        columns = [*axis_columns(sweep), *(Column(c.label, c.unit, key=c.label) for c in curves)]
        columns.append(Column("alike", key="alike"))
        pairs = tuple((*pair.values, *pair.results, pair.alike) for pair in front)
        parts.append(Table("", tuple(columns), pairs, key="front"))
    own = {**facts(sweep, curves), "doubts": doubt_sentences(sweep, curves)}
    return Document(sweep.engine.name, tuple(parts), own)
