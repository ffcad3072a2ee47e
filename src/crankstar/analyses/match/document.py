"""Parts matched to cylinders: what goes where, what is left, and what chance and classes leave."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from crankstar.analyses.match.batch import Batch
from crankstar.analyses.match.matching import Matched, Place, labels
from crankstar.analyses.match.question import Question
from crankstar.analyses.match.sets import Division
from crankstar.analysis.document import Column, Document, Table, Value, remarks
from crankstar.engine.engine import Engine
from crankstar.language.messages import N_, _, _n
from crankstar.language.numbers import RPM, number, order_text, rpm_of
from crankstar.language.shown_units import quantity_text

PARTS = {
    "piston": N_("piston"),
    "pin": N_("piston pin"),
    "small_end": N_("rod, small end"),
    "big_end": N_("rod, big end"),
}
"""The weighed parts as headings."""
ADDED = {
    ("piston",): N_("pistons"),
    ("pin",): N_("piston pins"),
    ("piston", "pin"): N_("pistons with their pins"),
    ("small_end",): N_("small ends of the rods"),
    ("big_end",): N_("big ends of the rods"),
    ("small_end", "big_end"): N_("both ends of the rods, added"),
}
"""What is added of the parts that are listed."""
CLASSED = N_(
    "Classes: every listed part lies anywhere in its class, so that all parts of an engine are "
    "within that width; it is counted from the middle of its class."
)
"""What is understood by classes."""


def document(engine: Engine, result: Division, question: Question) -> Document:
    """The matched engine or engines: what goes where, what is left beside chance and classes."""
    speed = question.turning(engine)
    first, *others = result.engines
    if others:
        return _several(engine, question.batch, result, speed)
    return _one(engine, question.batch, first, speed)


def _one(engine: Engine, batch: Batch, found: Matched, speed: float | None) -> Document:
    """One engine: its parts, what is left of which orders, beside chance and classes."""
    parts = (_places_table(batch, [found]), _left_table(found, speed))
    lines = [_said(batch, found), *_spare(found.left_over), *_notes(batch, found)]
    if found.classes:
        lines.append(_(CLASSED))
    return Document(engine.name, (*parts, *remarks(*lines, kind="note")), _facts(found, speed))


def _several(engine: Engine, batch: Batch, found: Division, speed: float | None) -> Document:
    """Several engines: the sets, what each leaves, how nearly equal their parts are."""
    first = found.engines[0]
    lines: list[str] = []
    spreads: dict[str, Any] = {}
    for name, sets, parts in (
        ("pistons", found.pistons, ("piston", "pin")),
        ("rods", found.rods, ("small_end", "big_end")),
    ):
        if sets is None:
            continue
        spreads[name] = {"spread": sets.spread, "proved": sets.proved}
        said = ADDED[tuple(part for part in parts if part in batch.masses)]
        values = {"what": _(said), "spread": quantity_text(sets.spread, "kg")}
        lines.append(
            _("Sum over the sets of greatest less least mass of {what}: {spread}, least.", **values)
            if sets.proved
            else _(
                "Sum over the sets of greatest less least mass of {what}: {spread}; there may be "
                "less, which is not proved.",
                **values,
            )
        )
    lines += _spare(batch.size - len(found.engines) * len(engine.cylinders))
    parts = (
        _places_table(batch, found.engines),
        _engines_table(found.engines, speed),
        *_class_table(found.engines),
    )
    facts = {**_facts(first, speed), "sets": spreads}
    lines += _notes(batch, first)
    if first.classes:
        lines.append(_(CLASSED))
    return Document(engine.name, (*parts, *remarks(*lines, kind="note")), facts)


def _facts(found: Matched, speed: float | None) -> dict[str, Any]:
    return {
        "format": 1,
        "orders": list(found.law.orders),
        "quantities": list(found.quantities),
        "arm_mm": 1000 * found.law.arm,
        "whole": found.whole,
        "whole_unbalance": found.whole_unbalance,
        "whole_alike": found.whole_alike,
        "proved": found.proved,
        "speed_rpm": rpm_of(speed),
    }


def _places_table(batch: Batch, engines: Sequence[Matched]) -> Table:
    """What goes into each cylinder, and what it weighs there."""
    several = len(engines) > 1
    kinds = [
        (_("piston"), "piston", "piston" in batch.masses),
        (_("piston pin"), "pin", "pin" in batch.masses),
        (_("rod"), "rod", batch.has_rods),
    ]
    shown = [index for index, (_said, _key, there) in enumerate(kinds) if there]
    columns = [Column(_("engine"), key="engine", label=True)] if several else []
    columns += [Column(_("cylinder"), key="cylinder", label=True)]
    columns += [Column(kinds[at][0], kind="text", key=kinds[at][1]) for at in shown]
    columns += [Column(_(PARTS[name]), "g", key=f"mass/{name}", digits=7) for name in batch.masses]
    moves = [
        Column(_("goes up and down, listed"), "g", key="reciprocating", digits=7),
        Column(_("turns, listed"), "g", key="rotating", digits=7),
    ]
    listed = any(name != "big_end" for name in batch.masses), "big_end" in batch.masses
    columns += [column for column, there in zip(moves, listed, strict=True) if there]
    rows: list[tuple[Value, ...]] = []
    for engine, found in enumerate(engines, 1):
        for place in found.places:
            own = labels(batch, place)
            masses = {name: _grams(_mass(batch, place, name)) for name in batch.masses}
            turning = masses.get("big_end", 0.0)
            up = float(f"{sum(masses[name] for name in masses if name != 'big_end'):.12g}")
            row: list[Value] = [engine] if several else []
            row += [place.cylinder, *(own[at] for at in shown), *masses.values()]
            row += [value for value, there in zip((up, turning), listed, strict=True) if there]
            rows.append(tuple(row))
    return Table(_("What goes where"), tuple(columns), tuple(rows), key="cylinders")


def _grams(mass: float) -> float:
    """Grams as they were listed, without what a change of units leaves in the last figure."""
    return float(f"{1000 * mass:.12g}")


def _mass(batch: Batch, place: Place, name: str) -> float:
    item = {"piston": place.piston, "pin": place.pin}.get(name, place.rod)
    return 0.0 if item is None else float(batch.masses[name][item])


def _left_table(found: Matched, speed: float | None) -> Table:
    """The unbalance that is left, beside that of other ways to choose."""
    rows: list[tuple[Value, ...]] = []

    def add(said: str, key: str, rms: float, most: float | None = None) -> None:
        force = () if speed is None else (rms * speed**2,)
        rows.append((said, key, rms, *force, most))

    add(_("matched"), "matched", found.unbalance)
    add(_("in the order of the list"), "as_listed", found.as_listed)
    add(_("by chance, rms of all assignments"), "by_chance", found.by_chance)
    for each in found.classes:
        width = quantity_text(each.width, "kg")
        said = _("classes of {width}, rms", width=width)
        add(said, f"class_{1000 * each.width:g}_g", each.rms, each.most)
    add(_("all parts alike"), "alike", found.fixed)
    columns = (
        Column(_("parts"), kind="text", label=True),
        Column("", kind="text", key="parts", machine=True),
        Column(_("unbalance left"), "kg*m", key="unbalance", digits=4),
        *_force_column(speed),
        Column(_("at most"), "kg*m", key="most", digits=4),
    )
    notes = _force_notes(found, speed)
    return Table(_("What is left"), columns, tuple(rows), notes, key="left")


def _force_column(speed: float | None) -> tuple[Column, ...]:
    if speed is None:
        return ()
    said = _("force, rms, at {rpm} rpm", rpm=number(speed * RPM))
    return (Column(said, "N", key="force", digits=4),)


def _force_notes(found: Matched, speed: float | None) -> tuple[str, ...]:
    """What the force is of, where it is not of the force alone."""
    if speed is None or "couple" not in found.quantities:
        return ()
    arm = f"{number(1000 * found.law.arm)} mm"
    if "force" in found.quantities:
        return (_("The force is the rms of force, and of couple over {arm}, together.", arm=arm),)
    return (_("The force is the rms of the couple over {arm}.", arm=arm),)


def _engines_table(engines: Sequence[Matched], speed: float | None) -> Table:
    """What is left in each of several engines."""
    columns = (
        Column(_("engine"), key="engine", label=True),
        Column(_("unbalance left"), "kg*m", key="unbalance", digits=4),
        *_force_column(speed),
        Column(_("by chance, rms of all assignments"), "kg*m", key="by_chance", digits=4),
        Column(_("proved least"), kind="text", key="proved_least"),
    )
    rows = tuple(
        (
            at,
            each.unbalance,
            *(() if speed is None else (each.unbalance * speed**2,)),
            each.by_chance,
            _("yes") if each.proved else _("no"),
        )
        for at, each in enumerate(engines, 1)
    )
    notes = _force_notes(engines[0], speed)
    return Table(_("What is left"), columns, rows, notes, key="engines")


def _class_table(engines: Sequence[Matched]) -> tuple[Table, ...]:
    """What classes leave in each of several engines."""
    columns = (
        Column(_("engine"), key="engine", label=True),
        Column(_("width of the classes"), "g", key="width"),
        Column(_("unbalance left, rms"), "kg*m", key="unbalance", digits=4),
        Column(_("at most"), "kg*m", key="most", digits=4),
    )
    rows = tuple(
        (at, _grams(each.width), each.rms, each.most)
        for at, engine in enumerate(engines, 1)
        for each in engine.classes
    )
    return (Table(_("What classes leave"), columns, rows, key="classes"),) if rows else ()


def _said(batch: Batch, found: Matched) -> str:
    size = quantity_text(found.unbalance, "kg*m")
    if found.any_order:
        return _("The parts are alike: every assignment leaves {size}.", size=size)
    if not found.proved:
        return _("{size} is the best that was found; that it is least is not proved.", size=size)
    if "piston" in batch.masses and "pin" in batch.masses:
        return _(
            "{size} is proved least: no other assignment of these parts, each piston with its pin, "
            "leaves less.",
            size=size,
        )
    return _("{size} is proved least: no other assignment of these parts leaves less.", size=size)


def _spare(count: int) -> list[str]:
    """What is said of parts that are too many."""
    if not count:
        return []
    return [
        _n(
            "{count} of each part is left over.",
            "{count} of each part are left over.",
            count,
            count=count,
        )
    ]


def _notes(batch: Batch, found: Matched) -> list[str]:
    """What was minimised, how pins went with pistons, what the list replaces."""
    orders = ", ".join(map(order_text, found.law.orders))
    what = {
        ("force", "couple"): N_(
            "Minimised: the rms over a turn of force, and of couple over {arm}, of the orders "
            "{orders}, as an unbalance (times ω² a force)."
        ),
        ("force",): N_(
            "Minimised: the rms over a turn of the force of the orders {orders}, as an unbalance "
            "(times ω² a force)."
        ),
        ("couple",): N_(
            "Minimised: the rms over a turn of the couple over {arm} of the orders {orders}, as an "
            "unbalance (times ω² a force)."
        ),
    }[found.quantities]
    lines = [_(what, arm=f"{number(1000 * found.law.arm)} mm", orders=orders)]
    values = {
        "size": quantity_text(found.whole_unbalance, "kg*m"),
        "alike": quantity_text(found.whole_alike, "kg*m", beside=found.whole_unbalance),
    }
    if found.whole:
        lines.append(
            _(
                "Of the whole engine with the counterweights of its file, which with the mean of "
                "the list in every cylinder leaves {alike}.",
                **values,
            )
        )
    else:
        lines.append(
            _(
                "It is what the parts add to the engine with the mean of the fitted parts in every "
                "cylinder, for which the crankshaft is to be balanced. The whole engine has {size} "
                "with the counterweights of its file, and {alike} with that mean; --whole "
                "minimises that.",
                **values,
            )
        )
    if "piston" in batch.masses and "pin" in batch.masses:
        lines.append(_("Pins go with pistons first, the heaviest with the lightest."))
    if any(cylinder.parts is None for cylinder in found.engine.cylinders):
        lines.append(
            _(
                "The file gives no cylinder.parts: only the differences of the weights count, "
                "about the masses of the file."
            )
        )
    return lines
