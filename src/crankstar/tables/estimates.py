"""What `estimate` fills in: each value with its range and its source, and the type of engine."""

from __future__ import annotations

from typing import TYPE_CHECKING

from crankstar.analysis.document import Column, Document, Remarks, Table, remarks
from crankstar.engine.engine import Engine
from crankstar.engine.gas import said_ignition
from crankstar.engine.proportions import SPARK
from crankstar.files import engine_of, units
from crankstar.language.messages import N_, _, passage
from crankstar.mechanics.mass_doubts import scale_doubts
from crankstar.tables.ranges import estimated_paths, listed

if TYPE_CHECKING:
    from crankstar.files.estimate import Estimate

TYPES = {
    "petrol": N_("petrol car"),
    "diesel-car": N_("diesel car"),
    "diesel": N_("truck or medium-speed diesel"),
    "motorcycle": N_("motorcycle or racing"),
    "aero": N_("aero"),
    "crosshead": N_("two-stroke with crosshead"),
}
"""Types of engines, by the values of --type."""
REASONS = {
    "": N_("as named"),
    "large-bore": N_("a bore too large for trunk pistons"),
    "long-stroke": N_("a two-stroke of long stroke"),
    "opposed": N_("two pistons to a cylinder"),
    "radial": N_("radial"),
    "large-fast": N_("a large bore at a high piston speed"),
    "large": N_("a bore larger than those of cars"),
    "large-slow": N_("a bore larger than those of cars, at a low piston speed"),
    "large-compression": N_("a bore larger than those of cars, and compression ignition"),
    "small-two-stroke": N_("a small two-stroke"),
    "high-speed": N_("a speed above that of road cars"),
    "few-cylinders": N_("few cylinders, and no speed in the file"),
    "few-fast-cylinders": N_("few cylinders at a high piston speed"),
    "few-slow-cylinders": N_("few cylinders, at a piston speed as of cars"),
    "slow": N_("a low rated speed and a low piston speed"),
    "slow-piston-speed": N_("a low rated speed at a piston speed as of cars"),
    "compression": N_("compression ignition and a bore as of cars"),
    "compression-two-stroke": N_("compression ignition in two strokes"),
    "compression-slow": N_("compression ignition, a low rated speed and a low piston speed"),
    "compression-piston-speed": N_("compression ignition, and a piston speed as of cars"),
    "compression-fast": N_("compression ignition, and a rated speed as of cars"),
    "spark": N_("spark ignition"),
    "car": N_("bore and speed as in petrol cars"),
    "car-bore": N_("a bore as in petrol cars, and no speed in the file"),
}
"""What tells the type of an engine."""
THOUGH = {
    "spark": N_("{reason}, though the file says spark ignition"),
    "compression": N_("{reason}, though the file says compression ignition"),
}
"""The reason for a type whose engines ignite in the other way."""


def _reason(estimate: Estimate, engine: Engine) -> str:
    """What told the type, and that the file says another ignition than such engines have."""
    reason, (fires, told) = _(REASONS[estimate.reason]), said_ignition(engine.gas)
    if fires is None or not told or (fires == "spark") == (estimate.kind in SPARK):
        return reason
    return _(THOUGH[fires], reason=reason)


def typical_remarks(engine: Engine) -> tuple[Remarks, ...]:
    """What is estimated, where results are for typical values alone; none where nothing is."""
    paths = estimated_paths(engine)
    line = _("Results are for these typical values, without ranges.")
    return remarks(passage((listed(engine), line)) if paths else "", kind="doubt")


def estimate_document(estimate: Estimate, *, name: str) -> Document:
    """The values filled in, in the units of a file, and for machines in SI."""
    columns = (
        Column(_("value"), kind="text", key="path", label=True),
        Column(_("typical"), kind="text", estimated=True),
        Column(_("low"), kind="text"),
        Column(_("high"), kind="text"),
        Column(_("source"), kind="text", key="source", wraps=True),
        Column("unit", kind="text", key="unit", machine=True),
        Column("estimated", key="estimated_value", machine=True),
        Column("low", key="low", machine=True),
        Column("high", key="high", machine=True),
        Column("moves_with", kind="text", key="moves_with", machine=True),
    )
    rows = tuple(
        (
            value.path,
            *(
                units.text(size, value.quantity, digits=3)
                for size in (value.typical, value.low, value.high)
            ),
            value.source,
            units.si_unit(value.quantity),
            *(value.typical, value.low, value.high),
            value.moves_with or None,
        )
        for value in estimate.filled
    )
    completed = engine_of(estimate.tree, name=name)
    words = {"kind": _(TYPES[estimate.kind]), "reason": _reason(estimate, completed)}
    kind = _("Type of engine: {kind} ({reason}); --type names another.", **words)
    none = "" if rows else _("The file leaves nothing out that could be estimated.")
    lines = Remarks(tuple(filter(None, (kind, none))), kind="note")
    outside = remarks(*(f"{one.sentence}." for one in scale_doubts(completed)), kind="doubt")
    table = Table(_("Estimated values"), columns, rows, key="filled")
    facts = {"engine": name, "type": estimate.kind, "inferred": estimate.reason != ""}
    return Document(name, (*outside, lines, table), facts)
