"""A generating set as tables: how evenly it runs, and several of them on one foundation."""

from __future__ import annotations

from collections.abc import Sequence
from math import degrees
from typing import Any

from crankstar.analyses.genset.generating_set import SHARES, GeneratingSet
from crankstar.analyses.genset.question import Question
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
from crankstar.dynamics.generator_angle import GeneratorAngle
from crankstar.dynamics.uneven import Running
from crankstar.engine.engine import Engine
from crankstar.language.messages import N_, _
from crankstar.language.numbers import RPM, number, rpm_of
from crankstar.mechanics.lacking import running_sentence
from crankstar.tables.gas_words import (
    at_points,
    burning_words,
    cycle_state,
    state_facts,
    weaker_facts,
)
from crankstar.tables.headings import heading

NAMES = {
    "force_vertical": N_("force, vertical"),
    "force_horizontal": N_("force, horizontal"),
    "pitch": N_("M_V, vertical"),
    "yaw": N_("M_H, horizontal"),
    "roll": N_("rolling moment"),
}


def document(engine: Engine, found: GeneratingSet, asked: Question) -> Document:
    """All of a set."""
    del engine, asked
    parts: list[Table | Remarks] = [heading(found.engine)]
    rows = _running_rows(found, found.running, found.angle) + _wanted_rows(found)
    if rows:
        parts.append(_running_table(found, rows))
    parts += for_each(*[_sum_table(found)] * 2)
    parts += remarks(*_notes(found), kind="note")
    parts += remarks(*_doubts(found), kind="doubt")
    return Document(found.engine.name, tuple(parts), _facts(found))


def _facts(found: GeneratingSet) -> dict[str, Any]:
    running, angle, pairs = found.running, found.angle, found.pole_pairs
    electrical = None
    if angle is not None and pairs is not None:
        electrical = degrees(angle.electrical(pairs))
    return {
        "format": 1,
        "engine": found.engine.name,
        "engines": found.engines,
        **state_facts(None if found.cycle is None else cycle_state(found.cycle)),
        "off": [] if found.cycle is None else list(found.cycle.off),
        "weaker": weaker_facts(found.cycle),
        "pole_pairs": pairs,
        "frequency_hz": found.frequency,
        "speed_rpm": rpm_of(found.speed),
        "inertia": None if running is None else running.inertia,
        "irregularity": None if running is None else running.irregularity,
        "ahead_deg": None if angle is None else degrees(angle.ends[1]),
        "behind_deg": None if angle is None else degrees(angle.ends[0]),
        "electrical_deg": electrical,
        "wanted_inertia": found.wanted,
        "shares": list(SHARES),
        "without_running": found.without_running or None,
        "without_sums": found.without_sums or None,
    }


def _running_rows(
    found: GeneratingSet, running: Running | None, angle: GeneratorAngle | None
) -> list[tuple[Value, ...]]:
    """Speed, irregularity and angle of the set; none without a flywheel."""
    if running is None or angle is None:
        return []
    uneven = running.irregularity
    rows: list[tuple[Value, ...]] = [
        (_("speed"), "speed", running.mean_speed * RPM, "rpm"),
        (_("inertia of all that turns and moves, mean"), "inertia", running.inertia, "kg*m^2"),
        (_("degree of irregularity"), "irregularity", uneven, ""),
        (_("one part in"), "one_part_in", 1 / uneven if uneven else None, ""),
        (_("ahead of even running at most"), "ahead", degrees(angle.ends[1]), "deg"),
        (_("behind it at most"), "behind", degrees(-angle.ends[0]), "deg"),
    ]
    if found.pole_pairs is not None:
        electrical = degrees(angle.electrical(found.pole_pairs))
        rows += [
            (_("frequency"), "frequency", found.frequency, "Hz"),
            (_("greatest electrical angle"), "electrical", electrical, "deg"),
        ]
    return rows


def _wanted_rows(found: GeneratingSet) -> list[tuple[Value, ...]]:
    """The inertia for the degree of irregularity that was asked for."""
    if found.wanted is None:
        return []
    said = _("inertia of crankshaft, flywheel and rotor for what is wanted")
    return [(said, "wanted_inertia", found.wanted, "kg*m^2")]


def _running_table(found: GeneratingSet, rows: Sequence[tuple[Value, ...]]) -> Table:
    """What of uneven running is known."""
    columns = (
        Column("", kind="text", label=True),
        Column("", kind="text", key="quantity", machine=True),
        Column(_("value"), ROW_UNIT, key="value"),
        Column(_("unit"), kind="unit", key="unit"),
    )
    title = _("Uneven running")
    if found.cycle is not None:
        title = burning_words(at_points(title, found.cycle), found.cycle)
    return Table(title, columns, tuple(rows), key="running")


def _sum_table(found: GeneratingSet) -> Table:
    """Forces and moments of one engine and, where there are several, of all, order by order."""
    alone = found.engines == 1
    columns = [
        Column(_("quantity"), kind="text", label=True),
        Column("", kind="text", key="quantity", machine=True),
        Column(_("order"), key="order", label=True),
        Column(_("one engine"), ROW_UNIT, key="one"),
        Column(_("all in phase"), ROW_UNIT, key="worst", machine=alone),
        Column(_("rms over all phases"), ROW_UNIT, key="typical", machine=alone),
        *(
            Column(
                _("exceeded {share} % of the time", share=number(100 * share)),
                ROW_UNIT,
                key=f"exceeded_{round(100 * share)}",
                machine=alone,
            )
            for share in SHARES
        ),
        Column(_("unit"), kind="unit", key="unit"),
    ]
    rows = tuple(
        (
            _(NAMES[each.quantity]),
            each.quantity,
            each.order,
            each.one,
            each.worst,
            each.typical,
            *each.exceeded,
            "N" if each.quantity.startswith("force") else "N*m",
        )
        for each in found.sums
    )
    title = _("{count} engines on one foundation", count=found.engines)
    if found.speed is not None:
        rpm = number(round(found.speed * RPM, 6))
        title = _("{count} engines on one foundation at {rpm} rpm", count=found.engines, rpm=rpm)
        if found.engines == 1:
            title = _("On the foundation at {rpm} rpm", rpm=rpm)
    if found.cycle is not None:
        title = burning_words(at_points(title, found.cycle), found.cycle)
    return Table(title, tuple(columns), rows, key="sums")


def _notes(found: GeneratingSet) -> list[str]:
    """What the numbers mean."""
    lines: list[str] = []
    if found.running is not None:
        lines.append(
            _(
                "No limits for uneven running are quoted: set these values against those of your "
                "contract or rules."
            )
        )
    if found.sums and found.steady_drive:
        lines.append(
            _(
                "What drives the engine is fixed to its frame, and its torque is taken as steady: "
                "it stays inside, and the frame rolls by the reaction to all that alternates of "
                "the engine. Moments are about the middle of the cylinders."
            )
        )
    elif found.sums:
        lines.append(
            _(
                "The generator is fixed to the frame of the engine: the mean torque stays inside, "
                "and the frame rolls by the reaction to all that alternates, a course of the load "
                "included. Moments are about the middle of the cylinders."
            )
        )
    if found.sums and found.engines > 1:
        lines.append(
            _(
                "Engines that run at slightly different speeds meet in all phases: all in phase is "
                "the worst; the rms of the amplitude over all phases is that of one times the root "
                "of their number; the rest is exceeded in so much of the time. The engines are "
                "alike and count as at one place."
            )
        )
    return lines


def missing_running(found: GeneratingSet) -> str:
    """Why uneven running is not told, as a sentence; empty where it is."""
    return running_sentence(found.without_running)


def missing_sums(found: GeneratingSet) -> str:
    """Why forces on the foundation are not told, as a sentence; empty where they are."""
    reason = found.without_sums.rstrip(".")
    return _("Without forces on the foundation: {reason}.", reason=reason) if reason else ""


def _doubts(found: GeneratingSet) -> list[str]:
    """What is missing."""
    lines = [missing_running(found), missing_sums(found)]
    if found.sums and found.cycle is None:
        lines.append(_("The rolling moment is that of inertia alone: the gas is not known."))
    if not found.sums and not found.without_sums:
        lines.append(_("Nothing reaches the foundation: forces and moments are balanced."))
    return lines
