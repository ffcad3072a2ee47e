"""The bobweight card: parts of a cylinder, bobweight of each pin, overbalance and underbalance."""

from __future__ import annotations

from cmath import exp
from collections.abc import Iterator

from crankstar.analyses.bobweight.question import Card, Question
from crankstar.analysis.document import Column, Document, Table, Value, remarks
from crankstar.engine.cylinder_parts import RECIPROCATING, ROTATING, Parts
from crankstar.engine.engine import Engine
from crankstar.language.messages import N_, _, _n
from crankstar.remedy.loads import Load, bobweight, loads
from crankstar.tables.bobweights import bobweight_heading, bobweights, lacks_rotating, pin_name
from crankstar.tables.scales import scales

NAMES = {
    "piston": N_("piston"),
    "pin": N_("piston pin"),
    "locks": N_("locks"),
    "rings": N_("rings"),
    "small_end": N_("rod, small end"),
    "big_end": N_("rod, big end"),
    "bearing_shells": N_("bearing shells"),
    "oil": N_("oil"),
}
STEPS = (-0.04, -0.02, 0.0, 0.02, 0.04)
"""Shares by which the factors of the last table differ from the one asked for."""
BALANCED = 1e-9
"""Share of the bobweights that counts as none."""


def document(engine: Engine, result: Card, question: Question) -> Document:
    """The card of an engine for a balance factor."""
    del question
    factor = result.factor
    own, pins = parts_table(engine), bobweights(engine, factor)
    lines = (*_remarks(engine, factor), "" if own else _without_parts(engine))
    return Document(
        engine.name,
        (*own, pins, overbalance(engine, factor), *remarks(*lines, kind="note")),
        {"engine": engine.name, "factor": factor},
    )


def _without_parts(engine: Engine) -> str:
    if "mass" in engine.relative:
        return _(
            "In m, the reciprocating mass of one cylinder. For grams, add to the file: "
            "cylinder.parts (piston, pin, locks, rings, small_end, big_end, bearing_shells, oil)."
        )
    return _(
        "For the card by parts, add to the file: cylinder.parts (piston, pin, locks, rings, "
        "small_end, big_end, bearing_shells, oil) instead of the two masses."
    )


def parts_table(engine: Engine) -> list[Table]:
    """The parts of cylinders that are alike, a column each; none where the file has no parts."""
    alike: dict[Parts, list[int]] = {}
    for cylinder in engine.cylinders:
        if cylinder.parts is not None:
            alike.setdefault(cylinder.parts, []).append(cylinder.number)
    if not alike:
        return []
    unit, factor = scales(engine).mass.unit, scales(engine).mass.factor
    columns = [
        Column(_("part"), kind="text", key="part", label=True),
        Column(_("moves"), kind="text", key="moves"),
    ]
    for numbers in alike.values():
        every = len(numbers) == len(engine.cylinders)
        some = ", ".join(map(str, numbers))
        heading = _n("cylinder {numbers}", "cylinders {numbers}", len(numbers), numbers=some)
        heading = _("each cylinder") if every else heading
        key = "mass" if every else f"mass_{'_'.join(map(str, numbers))}"
        columns.append(Column(heading, unit, key=key))
    rows: list[tuple[Value, ...]] = []
    groups = (
        (RECIPROCATING, _("up and down"), _("reciprocating, total"), "reciprocating"),
        (ROTATING, _("with the crank pin"), _("rotating, total"), "rotating"),
    )
    for names, moves, words, total in groups:
        given = [name for name in names if any(getattr(parts, name) for parts in alike)]
        for name in (*given, *([total] if given else [])):
            title = words if name == total else _(NAMES[name])
            masses = (round(getattr(parts, name) * factor, 12) for parts in alike)
            rows.append((title, moves, *masses))
    title = _("Bobweight card: parts of one cylinder")
    return [Table(title, tuple(columns), tuple(rows), key="parts")]


def overbalance(engine: Engine, factor: float) -> Table:
    """The bobweight of each kind of pin at factors beside the one asked for."""
    scale = scales(engine).mass
    kinds: dict[tuple[str, str], list[Load]] = {}
    for pin in loads(engine):
        kinds.setdefault((f"{pin.rotating:.9g}", f"{pin.reciprocating:.9g}"), []).append(pin)
    columns = [
        Column(_("more or less"), "%", key="more_percent", label=True),
        Column(_("balance factor"), "%", key="factor_percent"),
    ]
    for number, pins in enumerate(kinds.values(), 1):
        heading = bobweight_heading(engine)
        if len(kinds) > 1:
            names = ", ".join(pin_name(engine, pin) for pin in pins)
            heading = _("bobweight, pin {names}", names=names)
        key = "bobweight" if len(kinds) == 1 else f"bobweight_{number}"
        columns.append(Column(heading, scale.unit, key=key))
    rows: list[tuple[Value, ...]] = [
        (
            round(100 * step, 6),
            round(100 * (factor + step), 6),
            *(bobweight(pins[0], factor + step) * scale.factor for pins in kinds.values()),
        )
        for step in STEPS
        if factor + step >= 0 or step == 0
    ]
    title = _("Overbalance and underbalance")
    return Table(title, tuple(columns), tuple(rows), key="overbalance")


def _remarks(engine: Engine, factor: float) -> Iterator[str]:
    """Whether the crankshafts need bobweights at all."""
    if lacks_rotating(engine):
        return
    for shaft in engine.shafts:
        pins = [pin for pin in loads(engine) if pin.shaft == shaft.name]
        masses = [bobweight(pin, factor) * pin.radius for pin in pins]
        turned = [mass * exp(1j * pin.angle) for mass, pin in zip(masses, pins, strict=True)]
        force = abs(sum(turned, 0j))
        couple = abs(sum((v * pin.z for v, pin in zip(turned, pins, strict=True)), 0j))
        arms = sum(mass * abs(pin.z) for mass, pin in zip(masses, pins, strict=True))
        if len(pins) > 1 and force <= BALANCED * sum(masses) and couple <= BALANCED * arms:
            yield _(
                "The bobweights of the shaft {name} balance each other: the machine shows the "
                "same with them and without.",
                name=shaft.name,
            )
