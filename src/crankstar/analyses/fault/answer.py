"""What answers a question of faults, and what that rests on."""

from __future__ import annotations

from crankstar.analyses.fault.document import shown_orders
from crankstar.analyses.fault.question import Question
from crankstar.analysis.assumptions import Answer
from crankstar.analysis.document import Audience
from crankstar.engine.engine import Engine
from crankstar.studies.response_answers import felt
from crankstar.studies.single_faults import Shaken, fired, shaken


def compute(engine: Engine, question: Question) -> tuple[Shaken, Shaken]:
    """What shakes the block without the faults and with them. Raises DiagnosisError."""
    engine = fired(engine, question.faults)
    state = {"point": question.point, "speed": question.speed, "orders": question.orders or ()}
    return shaken(engine, **state), shaken(engine, question.faults, **state)


def answer(engine: Engine, question: Question, *, audience: Audience) -> Answer:
    """What shakes the block with the faults, in the orders that the audience is shown."""
    before, after = compute(engine, question)
    at = question.position(engine)
    orders = shown_orders(before, after, at, audience=audience) or question.orders or ()
    state = {"point": question.point, "speed": question.speed, "orders": orders}
    return felt(engine, question.faults, at=at, **state)
