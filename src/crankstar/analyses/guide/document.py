"""A family of engines as the table of a project guide: one row a firing order."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from crankstar.analyses.guide.published_orders import Published
from crankstar.analyses.guide.question import ChainDrive, Question
from crankstar.analyses.marine.document import OF_GUIDES
from crankstar.analyses.marine.doubts import missing_units
from crankstar.analysis.document import Column, Document, Remarks, Table, Value, remarks
from crankstar.engine.engine import Engine
from crankstar.language.messages import N_, _
from crankstar.language.numbers import number, rpm_of, unit_text
from crankstar.mechanics.external_moments import unbalance_class
from crankstar.mechanics.operating_points import OperatingState
from crankstar.tables.gas_words import at_points, cycle_state, state_facts

if TYPE_CHECKING:
    from crankstar.analyses.guide.engine_family import Member

CHOSEN = {"best": N_("best"), "given": N_("given"), "published": N_("published")}


def document(engine: Engine, members: Sequence[Member], question: Question) -> Document:
    """The members of a family, and by which goals the best were found."""
    goals, drive = question.goal_words, question.chain_drive
    horizontal_share = question.first_order
    notes = remarks(*_notes(members, goals, horizontal_share, drive), kind="note")
    parts = (Remarks((_heading(engine, members),)), _table(members), *notes)
    facts: dict[str, Any] = {
        "format": 1,
        "engine": engine.name,
        **state_facts(_state(members)),
        "speed_rpm": next((_speed(member) for member in members if member.found), None),
        "goals": goals,
        "horizontal_share": horizontal_share,
        "chain_drive": None if drive is None else [drive.cylinders, drive.wider],
    }
    return Document(engine.name, parts, facts)


def _state(members: Sequence[Member]) -> OperatingState | None:
    """The operating points of the gas of guide-force moments, None without."""
    found = next((own.found for own in members if own.found and own.found.cycle), None)
    return None if found is None or found.cycle is None else cycle_state(found.cycle)


def _speed(member: Member) -> float | None:
    speed = member.found and member.found.after.speed
    return rpm_of(speed)


def _heading(engine: Engine, members: Sequence[Member]) -> str:
    """The engine whose cylinders they are, at which speed and operating points."""
    found = next((own.found for own in members if own.found and own.found.cycle), None)
    return at_points(_at_speed(engine, members), None if found is None else found.cycle)


def _at_speed(engine: Engine, members: Sequence[Member]) -> str:
    speed = next((_speed(member) for member in members if member.found), None)
    if speed is None:
        return _("Engines with the cylinders of {engine}", engine=engine.name)
    return _(
        "Engines with the cylinders of {engine}, at {rpm} rpm",
        engine=engine.name,
        rpm=number(round(speed, 6)),
    )


def _table(members: Sequence[Member]) -> Table:
    """A row for each member; guide-force moments where gas is known."""
    known = [member.found for member in members if member.found is not None]
    unit = known[0].after.units.couple if known else "N*m"
    powered = any(found.power is not None and unit == "N*m" for found in known)
    guided = any(member.h for member in members)
    crossed = any(member.x for member in members)
    grown = any(_frequency(member) for member in members)
    columns = [
        Column(_("cylinders"), key="cylinders", label=True),
        Column(_("firing order"), kind="order", key="firing_order"),
        Column(_("chosen"), kind="text", key="chosen"),
        Column("", kind="text", key="published", machine=True),
        Column("M_1V", unit, key="m1v"),
        Column("M_1H", unit, key="m1h"),
        Column("M_2V", unit, key="m2v"),
        Column("M_4V", unit, key="m4v"),
    ]
    if powered:
        columns += [
            Column(_("power"), "W", key="power"),
            Column(_("M_2V over the power"), "N*m/kW", key="unbalance", digits=3),
            Column(_("compensator"), kind="text", key="compensator", optional=2),
        ]
    if guided:
        columns += [Column(_("greatest H"), "N*m", key="h"), Column(_("of order"), key="h_order")]
    if crossed:
        columns += [Column(_("greatest X"), "N*m", key="x"), Column(_("of order"), key="x_order")]
        summed = _("vector sum") if grown else _("vector sum, straight")
        columns.append(Column(summed, key="torsion_sum", digits=4))
    columns += [
        Column(_("torsion shape"), kind="text", key="torsion_shape", machine=not grown),
        Column(
            _("natural frequency"), "Hz", key="natural_frequency", fixed=True, machine=not grown
        ),
    ]
    rows = tuple(
        _row(member, powered=powered, guided=guided, crossed=crossed) for member in members
    )
    return Table(_("Family"), tuple(columns), rows, key="members", usual=OF_GUIDES)


def _frequency(member: Member) -> float | None:
    """The natural frequency whose shape counts, Hz."""
    return None if member.twist is None else member.twist.frequency


def _row(member: Member, *, powered: bool, guided: bool, crossed: bool) -> tuple[Value, ...]:
    """The cells of a member; empty ones where no order keeps the limits."""
    found = member.found
    chosen = _("none keeps the limits") if found is None else _(CHOSEN[member.chosen])
    source = member.published and member.published.engine
    row: list[Value] = [member.cylinders, member.order or None, chosen, source]
    if found is None:
        row += [None] * 4 + [None, None, ""] * powered + [None, None] * guided
        return (*row, *[None] * 3 * crossed, "", None)
    after = found.after
    row += [after.moment(1), after.moment(1, "H"), after.moment(2), after.moment(4)]
    if powered:
        value = found.unbalance(after.moment(2))
        row += [found.power, value, "" if value is None else _(unbalance_class(value))]
    if guided:
        row += [member.h[1], member.h[0]] if member.h else [None, None]
    if crossed:
        size = None if member.twist is None else member.twist.size
        row += [member.x[1], member.x[0], size] if member.x else [None, None, None]
    own = _frequency(member)
    return (*row, _("straight") if own is None else _("mode 1"), own)


def _notes(
    members: Sequence[Member], goals: str, horizontal_share: float | None, drive: ChainDrive | None
) -> list[str]:
    """How the orders were chosen, and what the columns mean."""
    lines = [
        _(
            "Best: by {goals}, of all crank stars with evenly spaced throws, with proof; mirror "
            "images and orders counted from the rear end are as good.",
            goals=goals,
        )
    ]
    lines += _choice(members, goals)
    if horizontal_share is not None:
        share = number(round(100 * horizontal_share, 6))
        lines.append(
            _(
                "Weights at the ends of the crankshaft make {share} % of the first-order moment "
                "horizontal, once the order is chosen.",
                share=share,
            )
        )
    if drive is not None:
        lines.append(
            _(
                "From {count} cylinders up the two middle ones are farther apart, for the drive.",
                count=drive.cylinders,
            )
        )
    lines += _torsion_notes(members, drive)
    lines += [_published(member, member.published) for member in members if member.published]
    found = next((member.found for member in members if member.found is not None), None)
    if found is not None and (lacking := missing_units(found)):
        lines.append(lacking)
    lines.append(
        _("Counterweights, block and mounts of the engine are left out, and so is axial vibration.")
    )
    return lines


def _torsion_notes(members: Sequence[Member], drive: ChainDrive | None) -> list[str]:
    """By which shape the vector sums are, and why some are by a straight one."""
    lines: list[str] = []
    grown = [member for member in members if _frequency(member) is not None]
    straight = [member for member in members if member.x and _frequency(member) is None]
    if grown:
        lines.append(_(BY_MODE))
    if any(drive and member.cylinders >= drive.cylinders for member in grown):
        lines.append(_("The wider gap counts as stiff as the others."))
    if straight:
        reasons = "; ".join(dict.fromkeys(member.without_chain for member in straight))
        lines.append(_(STRAIGHT, reason=reasons))
    return lines


def _published(member: Member, found: Published) -> str:
    """Where an order was read, or that of which it is the mirror image."""
    words = SAME if found.order == member.order else MIRRORED
    order = "-".join(map(str, member.order))
    return _(words, order=order, engine=found.engine, source=found.source)


def _choice(members: Sequence[Member], goals: str) -> list[str]:
    """By what number an order is better than another, and what that leaves out."""
    lines: list[str] = []
    names = [name.strip().rpartition("*")[2] for name in goals.split(";")[0].split(",")]
    if len(names) > 1:
        found = next((member.found for member in members if member.found is not None), None)
        unit = unit_text(found.after.units.couple if found else "N*m")
        lines.append(_(BESIDE, unit=unit) if NEIGHBOURS in names else _(ALONE))
    if "M1" in names:
        lines.append(_(HELD))
    return lines


BY_MODE = N_(
    "Vector sum of torsion: of the order of X, by the shape of mode 1, which is 1 at the first "
    "mass. The chain is that of the table [torsion] with a throw for each cylinder."
)
STRAIGHT = N_(
    "Vector sum by a straight shape: of the order of X, 1 at the end cylinders, the same star as "
    "that of X; {reason}."
)
SAME = N_("{order} is published in {source} ({engine} of the catalog).")
MIRRORED = N_("The mirror image of {order} is published in {source} ({engine} of the catalog).")
NEIGHBOURS = "neighbours"
ALONE = N_(
    "Of values that are minimised together the root of the sum of their squares counts, each "
    "times its weight if it has one: the greatest value over a turn."
)
BESIDE = N_(
    "Of values that are minimised together the root of the sum of their squares counts, each "
    "times its weight if it has one: the greatest value over a turn, moments in {unit}. The number "
    "of neighbours is added to it."
)
HELD = N_(
    "M1 holds rotating masses and those of throws, since counterweights of the engine are left "
    "out: the choice hangs on what weights would remove. --minimise M2 or --limit chooses "
    "otherwise; --first-order changes the moments only, once the order is chosen."
)
