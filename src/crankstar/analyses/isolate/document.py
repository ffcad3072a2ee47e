"""The best mounts found, beside those of the file: values, modes, and what is gained."""

from __future__ import annotations

from typing import Any

from crankstar.analyses.isolate.answer import UNITS, Isolated
from crankstar.analyses.isolate.free_values import MountLimits
from crankstar.analyses.isolate.isolation import KEPT, Isolation
from crankstar.analyses.isolate.question import Question
from crankstar.analysis.document import Column, Document, Remarks, Table, Value, remarks
from crankstar.dynamics.mount_analysis import MountAnalysis
from crankstar.dynamics.mount_worst import ROLL, roll_mode
from crankstar.engine.engine import Engine
from crankstar.engine.mounts import Mount
from crankstar.language.messages import N_, _, _n
from crankstar.tables.gas_words import range_words
from crankstar.tables.headings import heading
from crankstar.tables.mount_points import told_point

MM = 1e3
AIMS = {
    "force": N_("greatest force on the ground, rms"),
    "mounts": N_("greatest force of all mounts, rms"),
    "velocity": N_("greatest velocity of the point, rms"),
    "rms force": N_("force on the ground, rms over the speeds too"),
    "rms mounts": N_("force of all mounts, rms over the speeds too"),
    "rms velocity": N_("velocity of the point, rms over the speeds too"),
    "roll": N_("other freedoms in the mode of roll"),
}


def document(engine: Engine, result: Isolated, question: Question) -> Document:
    """The gain, the mounts and the modes before and after, and what kind of optimum it is."""
    del engine, question
    best, limits, before, after = result
    parts: list[Table | Remarks] = [
        heading(best.engine),
        _gain(best, before, after),
        _mounts(before, after),
        _modes(before, after),
        *remarks(*_notes(best, after, limits), kind="note"),
    ]
    return Document(best.engine.name, tuple(parts), _facts(best))


def _facts(best: Isolation) -> dict[str, Any]:
    factor = UNITS[best.aim][1]
    ends = [None if end != end else end * factor for end in best.ends]
    return {
        "format": 1,
        "engine": best.engine.name,
        "minimise": best.aim,
        "unit": UNITS[best.aim][0],
        "before": best.before * factor,
        "after": best.after * factor,
        "ends": ends,
        "certificate": None,
    }


def _gain(best: Isolation, before: MountAnalysis, after: MountAnalysis) -> Table:
    """What is minimised, how it sits down, and the roll in its mode."""
    unit, factor = UNITS[best.aim]
    columns = (
        Column("", kind="text", key="quantity", label=True),
        Column(_("of the file"), key="before", digits=4),
        Column(_("best found"), key="after", digits=4),
        Column(_("unit"), kind="unit", key="unit"),
    )
    rows: list[tuple[Value, ...]] = [
        (_(AIMS[best.aim]), best.before * factor, best.after * factor, unit),
        (_("it sits down by"), -MM * float(before.sag[0]), -MM * float(after.sag[0]), "mm"),
    ]
    rolls = [
        100 * float(each.modes[roll_mode(each.modes)].energy[ROLL]) for each in (before, after)
    ]
    rows.append((_("share of roll in its mode"), *rolls, "%"))
    return Table(_("Best mounts"), columns, tuple(rows), key="gain")


def _mounts(before: MountAnalysis, after: MountAnalysis) -> Table:
    columns = (
        Column(_("mount"), kind="text", key="name", label=True),
        Column(
            _("stiffness along its axes"), "N/mm", kind="list", key="stiffness_before", digits=3
        ),
        Column(_("best found"), "N/mm", kind="list", key="stiffness", digits=3),
        Column(_("up, right, along"), "mm", kind="list", key="place_before", optional=1),
        Column(_("best found"), "mm", kind="list", key="place"),
    )
    own = before.block.mounts[: before.block.of_block]
    new = after.block.mounts[: after.block.of_block]
    rows = tuple(
        (old.name, _stiffness(old), _stiffness(found), _place(old), _place(found))
        for old, found in zip(own, new, strict=True)
    )
    return Table(_("Mounts"), columns, rows, key="mounts")


def _stiffness(mount: Mount) -> tuple[float, ...]:
    return tuple(float(f"{each / MM:.12g}") for each in mount.along)


def _place(mount: Mount) -> tuple[float, ...]:
    return tuple(float(f"{each * MM:.12g}") + 0.0 for each in (mount.up, mount.right, mount.z))


def _modes(before: MountAnalysis, after: MountAnalysis) -> Table:
    columns = (
        Column(_("mode"), key="mode", label=True),
        Column(_("of the file"), "Hz", key="before", fixed=True, digits=3),
        Column(_("best found"), "Hz", key="after", fixed=True, digits=3),
    )
    rows = tuple(
        (number, old.frequency, new.frequency)
        for number, (old, new) in enumerate(zip(before.modes, after.modes, strict=True), 1)
    )
    return Table(_("Natural frequencies"), columns, rows, key="modes")


def _notes(best: Isolation, after: MountAnalysis, limits: MountLimits) -> list[str]:
    """That it is a local optimum, which limits it has come to, what it is of."""
    lines = [
        _n(
            "A local optimum, without proof: the best of {count} start.",
            "A local optimum, without proof: the best of {count} starts; {same} end there.",
            len(best.ends),
            count=len(best.ends),
            same=best.agreeing,
        )
    ]
    held = _held(after, limits)
    if held:
        lines.append(_("It has come to these limits: {limits}.", limits=", ".join(held)))
    lines.append(range_words(best.engine, after.operating_point))
    if best.aim.endswith("velocity"):
        point = told_point(best.engine, after.point)
        lines.append(_("Vibration is that of the point {point}; see --at.", point=point))
    return lines


def _held(after: MountAnalysis, limits: MountLimits) -> list[str]:
    """The limits that a better optimum would have to go beyond."""
    out: list[str] = []
    own = after.block.mounts[: after.block.of_block]
    if limits.stiffness is not None:
        low, high = limits.stiffness
        values = [value for mount in own for value in mount.stiffness if value]
        if min(values) < low * (1 + 10 * KEPT):
            out.append(_("least stiffness"))
        if max(values) > high * (1 - 10 * KEPT):
            out.append(_("greatest stiffness"))
    if limits.sag is not None and -float(after.sag[0]) > limits.sag * (1 - 10 * KEPT):
        out.append(_("sag"))
    if limits.frequencies is not None:
        low, high = limits.frequencies
        if after.modes[0].frequency < low * (1 + 10 * KEPT):
            out.append(_("lowest frequency"))
        if after.modes[-1].frequency > high * (1 - 10 * KEPT):
            out.append(_("highest frequency"))
    return out
