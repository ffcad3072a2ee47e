"""Where an order stands beside a front over stars and firing sequences, and what beats it."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any

from crankstar.engine.engine import Engine
from crankstar.language.messages import _
from crankstar.language.numbers import number
from crankstar.language.written import capitalised
from crankstar.stars.sequence_engines import fired_of_engine
from crankstar.stars.sequence_fronts import Point, SequenceFront, beaten
from crankstar.stars.shafts import Fired
from crankstar.stars.vector_sums import NEIGHBOURS, Goal, SequenceQuestion
from crankstar.tables.judgements import judge_text

if TYPE_CHECKING:
    from crankstar.studies.judged_orders import Judge, JudgedWays

Judged = Mapping["Judge", "JudgedWays"]
"""What the whole engine does with a star and its firing order."""
BEATEN = 3
"""Points that are named as better than an order."""


def placed(
    front: SequenceFront, engine: Engine | None, why: Fired | None
) -> Iterator[tuple[str, Fired]]:
    """The order of the engine and the one that was typed, with their names."""
    own = None if engine is None else fired_of_engine(engine, front.question.shaft)
    if own is not None:
        yield "engine", own
    if why is not None:
        yield "why", why


def uneven(front: SequenceFront, engine: Engine | None) -> Iterator[str]:
    """That an engine as it is belongs to none of the stars, where that is so."""
    if engine is not None and fired_of_engine(engine, front.question.shaft) is None:
        yield _("The engine as it is does not fire evenly: it is none of these stars.")


def verdict(front: SequenceFront, label: str, fired: Fired) -> str:
    """Whether an order is on the front, else which rows are better, and in what."""
    question = front.question
    order = "-".join(map(str, question.shaft.firing_order(fired)))
    name = _("The engine as it is ({order})", order=order) if label == "engine" else order
    if not question.within(fired):
        return _("{name} breaks a limit: {limits}.", name=name, limits=_broken(question, fired))
    values, better = beaten(front, fired)
    known = {"name": name, "values": _valued(question.goals, values)}
    if not better:
        return _("{name}: {values}.", **known)
    first, which = better[0]
    if not which:
        return _("{name} is on the front, row {row}: {values}.", row=first + 1, **known)
    ranked = sorted(better, key=lambda each: -len(each[1]))
    beating = "; ".join(
        _beating(front.points[place], place, goals, values, question.goals)
        for place, goals in ranked[:BEATEN]
    )
    if len(better) > BEATEN:
        more = len(better) - BEATEN
        beating = _("{rows}; and {count} more", rows=beating, count=more)
    return _(
        "{name} is not on the front: {values}. No worse in anything and better: {rows}.",
        rows=beating,
        **known,
    )


def _broken(question: SequenceQuestion, fired: Fired) -> str:
    """The limits that an order breaks."""
    shaft, most = question.shaft, question.neighbours_at_most
    limits = [(cap.sum.name, cap.sum.length(shaft, fired), cap.greatest) for cap in question.caps]
    if most is not None:
        limits.append((NEIGHBOURS.name, NEIGHBOURS.value(shaft, fired), most))
    functions = question.functions
    limits += [(each.name, each.value(shaft, fired), each.greatest) for each in functions]
    return ", ".join(
        f"{name} {number(value)} > {number(most)}" for name, value, most in limits if value > most
    )


def judged_by(fired: Fired, known: Judged) -> str:
    """What an order beside the rows is judged by, as the end of its sentence."""
    values = [
        judge_text(judge, own.beside[fired]) for judge, own in known.items() if fired in own.beside
    ]
    words = "; ".join(values)
    return f" {capitalised(words)}." if words else ""


def _valued(goals: tuple[Goal, ...], values: tuple[float, ...]) -> str:
    return ", ".join(
        f"{goal.name} {number(value)}" for goal, value in zip(goals, values, strict=True)
    )


def _beating(
    point: Point,
    index: int,
    which: tuple[int, ...],
    values: tuple[float, ...],
    goals: tuple[Goal, ...],
) -> str:
    """A row that beats an order, and in what."""
    what = ", ".join(
        f"{goals[q].name} {number(point.values[q])} < {number(values[q])}" for q in which
    )
    return _("row {row} ({what})", row=index + 1, what=what)


def judgement(front: SequenceFront, label: str, fired: Fired) -> dict[str, Any]:
    """The same for programs."""
    question = front.question
    out: dict[str, Any] = {
        "of": "engine" if label == "engine" else "order",
        "firing_order": list(question.shaft.firing_order(fired)),
        "within_limits": question.within(fired),
    }
    if not out["within_limits"]:
        return out
    values, better = beaten(front, fired)
    names = [goal.name for goal in question.goals]
    out["values"] = dict(zip(names, values, strict=True))
    out["row"] = next((place + 1 for place, which in better if not which), None)
    out["dominated_by"] = [
        {"row": place + 1, "in": [names[q] for q in which]} for place, which in better if which
    ]
    return out
