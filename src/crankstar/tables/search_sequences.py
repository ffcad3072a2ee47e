"""A front over crank stars and firing sequences, and where an order stands beside it."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from crankstar.analysis.document import Column, Document, Remarks, Table, Value, remarks
from crankstar.engine.engine import Engine
from crankstar.language.messages import _, _n
from crankstar.language.numbers import number
from crankstar.stars.sequence_fronts import Point, SequenceFront
from crankstar.stars.shafts import Fired, followed
from crankstar.stars.vector_sums import OrderSum, SequenceQuestion, couple, force, shares
from crankstar.tables.judgements import JUDGEMENTS, judge_column, mode_sentence
from crankstar.tables.sequence_verdicts import Judged, judged_by, judgement, placed, uneven, verdict

if TYPE_CHECKING:
    from crankstar.dynamics.torsion_modes import Mode

FORMAT = 1
"""Of the JSON."""
ROWS = 60
"""Rows that are shown; all of them go into a file."""


def search_sequences(
    front: SequenceFront,
    *,
    engine: Engine | None = None,
    why: Fired | None = None,
    mode: Mode | None = None,
    found: Judged | None = None,
    limit: int | None = ROWS,
) -> Document:
    """The points of a front, its proof, and where the engine's own order and another stand.

    `mode`: the engine's own that gives torsion its shape; `found`: what each point is judged by.
    """
    shown = front.points[:limit]
    question = front.question
    known = {} if found is None else found
    rows = tuple(
        (*_row(question, index, point), *_best(question, point, known))
        for index, point in enumerate(shown, 1)
    )
    table = Table("", (*_columns(question), *_judge_columns(known)), rows, key="rows")
    judged = list(placed(front, engine, why))
    lines = [
        *(verdict(front, label, fired) + judged_by(fired, known) for label, fired in judged),
        *uneven(front, engine),
        *_notes(front, len(shown)),
        *([] if mode is None else [mode_sentence(mode)]),
        *(_(JUDGEMENTS[judge]) for judge in known),
        *_judged_sentences(known),
        certificate(front),
    ]
    told = [
        judgement(front, label, fired)
        | {judge: own.beside[fired] for judge, own in known.items() if fired in own.beside}
        for label, fired in judged
    ]
    facts = _facts(front) | {"judged": told}
    parts = (*remarks(census(question)), table, Remarks(tuple(lines)))
    return Document(heading(question), parts, facts)


def heading(question: SequenceQuestion) -> str:
    """What was asked."""
    shaft = question.shaft
    kind = _n("{count} cylinder", "{count} cylinders", shaft.cylinders, count=shaft.cylinders)
    if shaft.rods == 2:
        kind = f"V{shaft.cylinders}, {abs(float(shaft.bank_angle_deg)):g} deg"
    limits = ", ".join(
        f"{cap.sum.name} ≤ {number(cap.greatest)}" if cap.greatest else f"{cap.sum.name} = 0"
        for cap in question.caps
    )
    most = question.neighbours_at_most
    if most is not None:
        few = _("at most {most} neighbours in succession", most=most)
        none = _("no neighbours in succession")
        limits = ", ".join(part for part in (limits, few if most else none) if part)
    asked = _(
        "{engine}, {cycle}: Pareto front of {sums} over stars and firing orders",
        engine=kind,
        cycle=_(shaft.cycle),
        sums=", ".join(goal.name for goal in question.goals),
    )
    return _("{question}; limits: {limits}", question=asked, limits=limits) if limits else asked


def census(question: SequenceQuestion) -> str:
    """How many stars there are, and how many firing orders on each."""
    shaft = question.shaft
    size, each = shaft.count, shaft.sequences
    counts = {
        "stars": _n("{count} star", "{count} stars", size, count=f"{size:,}"),
        "orders": _n("{count} firing order", "{count} firing orders", each, count=f"{each:,}"),
    }
    if shaft.rods == 2:
        return _(
            "Two rods on each pin, fired evenly: {stars}, with {orders} on each; mirror images are "
            "counted.",
            **counts,
        )
    return _("Fired evenly: {stars}, with {orders} on each; mirror images are counted.", **counts)


def certificate(front: SequenceFront) -> str:
    """What was searched, and why nothing else belongs to the front."""
    shaft = front.question.shaft
    values = {
        "stars": f"{front.stars:,}",
        "of": f"{shaft.count:,}",
        "orders": f"{shaft.count * shaft.sequences:,}",
    }
    if not front.complete:
        return _(
            "INCOMPLETE: stopped after {stars} of {of} stars. These are the best so far; nothing "
            "is proved.",
            **values,
        )
    if not front.points:
        return _("Proved: no star keeps these limits ({of} searched).", **values)
    return _(
        "Proved complete: all {of} stars were searched, {orders} firing orders; each of them is a "
        "row, as good as a row, or worse than one.",
        **values,
    )


def _extra(question: SequenceQuestion) -> list[OrderSum]:
    """Sums beside the goals: those a goal is the largest of, and the first forces and couples."""
    shaft = question.shaft
    alone = {goal.sums[0] for goal in question.goals if len(goal.sums) == 1}
    parts = [one for goal in question.goals if len(goal.sums) > 1 for one in goal.sums]
    usual = [couple(shaft, 1), couple(shaft, 2), force(shaft, 1), force(shaft, 2)]
    return [one for one in dict.fromkeys([*parts, *usual]) if one not in alone]


def _columns(question: SequenceQuestion) -> list[Column]:
    out = [
        Column(_("row"), key="row", label=True),
        Column(_("firing order"), kind="order", key="firing_order", label=True),
        Column("", kind="list", key="classes", machine=True),
        Column("", "deg", kind="list", key="throw_angles", machine=True),
        Column("", "deg", kind="list", key="firing_angles", machine=True),
    ]
    out += [Column(goal.name, goal.unit, key=goal.name) for goal in question.goals]
    for one in _extra(question):
        out.append(Column(one.name, one.unit, key=one.name, machine=one.kind != "T"))
    beside = not any(goal.neighbours for goal in question.goals)
    out += [
        Column("", couple(question.shaft, 1).unit, key="M1_after_counterweights", machine=True),
        Column(_("neighbours"), key="neighbours_in_succession", machine=not beside),
        Column("", kind="list", key="neighbours", machine=True),
        Column(_("same pin"), key="same_pin_in_succession", machine=question.shaft.rods == 1),
        Column(_("ways"), key="orders"),
        Column("", key="like", machine=True),
    ]
    return out


def _row(question: SequenceQuestion, index: int, point: Point) -> tuple[Value, ...]:
    shaft, fired = question.shaft, point.fired
    order = shaft.firing_order(fired)
    throws = tuple(-float(own * shaft.step_deg) + 0.0 for own in fired.star)
    angles = tuple(float(angle) for angle in shaft.angles_deg(fired).values())
    along, against = shares(shaft, 1)
    left = couple(shaft, 1).length(shaft, fired) * against / ((along + against) or 1.0)
    steps = followed(shaft, order)
    return (
        index,
        order,
        tuple(fired.star),
        throws,
        angles,
        *point.values,
        *(one.length(shaft, fired) for one in _extra(question)),
        left,
        len(steps.neighbours),
        steps.neighbours,
        len(steps.partners),
        point.orders,
        tuple(shaft.firing_order(other) for other in point.like),
    )


def _judge_columns(known: Judged) -> list[Column]:
    """What the best way of a row is judged by, and which way it is."""
    out: list[Column] = []
    for judge in known:
        way = Column(_("by firing order"), kind="order", key=f"{judge}_order")
        out += [judge_column(judge), way]
    return out


def _best(question: SequenceQuestion, point: Point, known: Judged) -> Iterator[Value]:
    for own in known.values():
        yield own.rows[point.fired].value
        yield question.shaft.firing_order(own.rows[point.fired].fired)


def _judged_sentences(known: Judged) -> Iterator[str]:
    """Which orders were judged."""
    if not known:
        return
    own = next(iter(known.values()))
    if own.judged == own.of:
        yield _(
            "All ways of each row were judged ({count} in all): the least is shown, with the order "
            "that has it.",
            count=f"{own.judged:,}",
        )
    else:
        yield _(
            "{judged} of the {count} ways of all rows were judged: the least is shown, with the "
            "order that has it.",
            judged=f"{own.judged:,}",
            count=f"{own.of:,}",
        )


def _notes(front: SequenceFront, shown: int) -> list[str]:
    question, out = front.question, list[str]()
    if shown < len(front.points):
        out.append(
            _(
                "{shown} of {count} are shown; -o FILE.csv writes all.",
                shown=shown,
                count=f"{len(front.points):,}",
            )
        )
    out.append(_("ways: firing orders with these values, mirror images among them."))
    for goal in question.goals:
        if len(goal.sums) > 1:
            names = ", ".join(one.name for one in goal.sums)
            out.append(_("{name}: the largest of {sums}.", name=goal.name, sums=names))
    if any(one.kind == "T" for goal in question.goals for one in goal.sums):
        out.append(
            _(
                "T: gas torque of an order, each cylinder times the amplitude of its throw, in the "
                "torque of one cylinder."
            )
        )
    if any(one.name == "M1" for goal in question.goals for one in goal.sums):
        along, against = shares(question.shaft, 1)
        out.append(
            _(
                "Counterweights can take {share} of M1, of every star.",
                share=f"{100 * along / (along + against):.4g} %",
            )
        )
    for goal in question.functions:
        out.append(
            _(
                "{name} is a Python function, called for each of the {count} firing orders within "
                "the limits: no bound leaves any out.",
                name=goal.name,
                count=f"{front.evaluated:,}",
            )
        )
    out.append(_("--row N -o FILE writes the engine with that star and order."))
    return out


def _facts(front: SequenceFront) -> dict[str, Any]:
    question, shaft = front.question, front.question.shaft
    return {
        "format": FORMAT,
        "cylinders": shaft.cylinders,
        "cycle": shaft.cycle,
        "bank_angle_deg": abs(float(shaft.bank_angle_deg)) if shaft.rods == 2 else None,
        "positions": [float(place) for place in shaft.places],
        "pins": [list(pin) for pin in shaft.numbers],
        "directions": shaft.classes,
        "asked": heading(question),
        "goals": [
            {"name": goal.name, "unit": goal.unit, "largest_of": [one.name for one in goal.sums]}
            for goal in question.goals
        ],
        "certificate": {
            "complete": front.complete,
            "stars": front.stars,
            "of_stars": shaft.count,
            "sequences_of_each": shaft.sequences,
            "sentence": certificate(front),
        },
    }
