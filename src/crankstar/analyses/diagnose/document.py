"""Which fault explains a measurement, as tables and sentences."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from crankstar.analyses.diagnose.diagnosis import EXPLAINS, FEW, Diagnosis, Suspect
from crankstar.analyses.diagnose.question import Question
from crankstar.analyses.diagnose.readings import AXES
from crankstar.analysis.document import Column, Document, Remarks, Table, Value, for_each, remarks
from crankstar.engine.engine import Engine
from crankstar.language.messages import N_, _
from crankstar.language.numbers import number, rpm_of
from crankstar.language.shown_units import quantity_text
from crankstar.studies.fault_kinds import Fault, fault_facts, fault_text
from crankstar.studies.single_faults import limits
from crankstar.tables.gas_words import state_facts, state_words

ROWS = 12
"""Suspects that are shown to readers; all are in JSON and CSV."""
SAME_MASS = 1e-6
SHARES = ("weight", "combustion")
"""Faults whose size is a share of what there is; that of others is a mass."""
NAMES = {"up": N_("up"), "right": N_("right"), "z": N_("along")}


def document(engine: Engine, found: Diagnosis, question: Question) -> Document:
    """The suspects, what the likeliest leaves unexplained reading by reading."""
    states = [state_words(engine, state) for state in found.states]
    parts: list[Table | Remarks] = [*remarks(*_verdict(found), *states)]
    if found.suspects and not found.healthy:
        shown = suspects_of(found)[:ROWS]
        parts += for_each(_suspects(found, shown), _suspects(found, found.suspects))
        parts.append(replace(_readings(found), audience="all" if shown else "machines"))
    parts += remarks(*_notes(found, before=question.before is not None), kind="note")
    facts = {
        "format": 1,
        "speeds_rpm": [rpm_of(each.speed or 0.0) for each in found.states],
        "operating_points": [each.point or None for each in found.states],
        "points": [state_facts(each)["points"] for each in found.states],
        "difference_share": found.share,
        "explained": found.found and not found.healthy,
        "healthy": found.healthy,
        "pair": None if found.pair is None else _plain_suspect(found.pair),
        "cannot_be_told_apart": [_plain_suspect(each) for each in found.alike],
    }
    return Document(engine.name, tuple(parts), facts)


def _notes(found: Diagnosis, *, before: bool) -> list[str]:
    """What the numbers mean; `before`: a measurement before the fault is compared with."""
    notes = [
        _(
            "Explained: share of the mean square of the difference, as velocity over its error, "
            "that the fault of its likeliest size has. Errors are those of the list."
        )
        if all(each.error > 0 for each in found.readings)
        else _(
            "Explained: share of the mean square of the difference, as velocity over the size of "
            "the reading, that the fault of its likeliest size has. Without a column error a "
            "reading is taken to be as uncertain as it is great."
        ),
        _("The difference is that to the measurement before.")
        if before
        else _(
            "The difference is that to what the engine file says; what the model leaves out is in "
            "it. A measurement before the fault (--before) cancels that."
        ),
        _("The block stands on its mounts.")
        if found.engine.mounts
        else _("The block is taken as free: the file has no mounts."),
    ]
    shown = suspects_of(found)[:ROWS]
    spent = [each.faults[0] for each in shown if _takes_all(each.faults[0], found)]
    if spent and not found.healthy:
        notes.append(
            _(
                "A part loses no more than it weighs in the file: {faults}.",
                faults="; ".join(fault_text(fault, found.engine) for fault in spent),
            )
        )
    return notes


def _takes_all(fault: Fault, found: Diagnosis) -> bool:
    """Whether a part would have to lose all that it weighs."""
    least = limits(found.engine, fault)[0]
    return fault.size < 0 and fault.size <= least * (1 - SAME_MASS)


def _plain_suspect(suspect: Suspect) -> dict[str, Any]:
    return {
        "faults": [fault_facts(fault) for fault in suspect.faults],
        "explained": suspect.explained,
    }


def suspect_text(suspect: Suspect, found: Diagnosis) -> str:
    """The faults of a suspect with their sizes, that of a single one to its error."""
    return ", ".join(fault_text(fault, found.engine) for fault in suspect.rounded)


def suspects_of(found: Diagnosis) -> list[Suspect]:
    """The suspects that readers are told of, the likeliest first: those that have a size."""
    return [each for each in found.suspects if each.has_size]


def _percent(share: float) -> str:
    return number(float(f"{100 * share:.4g}"), 100.0)


def _likeliest(found: Diagnosis) -> list[str]:
    """The likeliest fault, how sure it is, and the next that can be told from it."""
    first = found.suspects[0]
    lines = [
        _(
            "Likeliest: {fault}, which explains {share} %.",
            fault=suspect_text(first, found),
            share=_percent(first.explained),
        )
    ]
    if first.explained < EXPLAINS:
        lines.append(
            _(
                "Its size is {times} times its error; the rest is noise, or not in the model.",
                times=f"{first.certainty:.3g}",
            )
        )
    alike = [id(each) for each in found.alike]
    others = [each for each in suspects_of(found)[1:] if id(each) not in alike]
    if others:
        lines.append(
            _(
                "Next: {fault}, {share} %.",
                fault=suspect_text(others[0], found),
                share=_percent(max(others[0].explained, 0.0)),
            )
        )
    return lines


def _verdict(found: Diagnosis) -> list[str]:
    if found.healthy:
        return [
            _(
                "Nothing is out of order by this measurement: it differs by {share} % from the "
                "engine without a fault.",
                share=_percent(found.share),
            )
        ]
    if not found.found:
        best = found.suspects[0].explained if found.suspects else 0.0
        lines = [
            _(
                "No single fault explains this measurement: the best explains {share} % of it.",
                share=_percent(best),
            )
        ]
    else:
        lines = _likeliest(found)
    if found.found and found.alike:
        lines.append(
            _(
                "By these readings it cannot be told from: {faults}; measure at other points, "
                "directions or orders.",
                faults="; ".join(suspect_text(each, found) for each in found.alike),
            )
        )
    if len(found.readings) < FEW:
        lines.append(
            _(
                "So few readings are explained by many faults: measure more orders, points and "
                "directions."
            )
        )
    if found.pair is not None:
        lines.append(
            _(
                "Two faults together would explain {share} %: {faults}.",
                share=_percent(found.pair.explained),
                faults=suspect_text(found.pair, found),
            )
        )
    return lines


def _suspects(found: Diagnosis, suspects: Sequence[Suspect]) -> Table:
    columns = (
        Column(_("fault"), kind="text", label=True),
        Column("", kind="text", key="kind", machine=True),
        Column("", key="number", machine=True),
        Column("", kind="text", key="shaft", machine=True),
        Column("", key="size", machine=True),
        Column(_("error of the size"), kind="text"),
        Column("", key="size_error", machine=True),
        Column("", kind="text", key="size_unit", machine=True),
        Column(_("explained"), "%", key="explained_percent", digits=4),
        Column(_("left, rms"), "mm/s", key="left_rms", digits=4),
    )
    rows: list[tuple[Value, ...]] = []
    for suspect in suspects:
        (fault,) = suspect.faults
        left = found.difference - suspect.rows
        rms = 1e3 * float(np.sqrt((np.abs(left) ** 2).mean() / 2))
        own = (suspect_text(suspect, found), fault.kind, fault.number, fault.shaft, fault.size)
        error = f"± {_error(fault, suspect.error)}"
        unit = "share" if fault.kind in SHARES else "kg"
        rows.append((*own, error, suspect.error, unit, 100 * suspect.explained, rms))
    return Table(_("Suspects"), columns, tuple(rows), key="suspects")


def _error(fault: Fault, error: float) -> str:
    """The standard error of a size in its unit, to two figures."""
    if fault.kind in SHARES:
        return f"{number(float(f'{100 * error:.2g}'))} %"
    return quantity_text(float(f"{error:.2g}"), "kg")


def _readings(found: Diagnosis) -> Table:
    """Each reading: the difference, and what the likeliest fault explains of it."""
    first = found.suspects[0]
    columns = (
        Column(_("line"), key="line", label=True),
        Column(_("order"), key="order"),
        Column(_("direction"), kind="text", key="direction"),
        Column(_("difference"), "mm/s", kind="wave", key="difference"),
        Column(_("explained"), "mm/s", kind="wave", key="explained"),
    )
    rows = tuple(
        (each.line, each.order, _(NAMES[AXES[each.axis]]), 1e3 * complex(own), 1e3 * complex(said))
        for each, own, said in zip(found.readings, found.difference, first.rows, strict=True)
    )
    return Table(
        _("Readings, and what the likeliest fault explains"), columns, rows, key="readings"
    )
