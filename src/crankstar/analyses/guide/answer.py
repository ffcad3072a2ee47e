"""What answers a question of a family of engines, and what that rests on."""

from __future__ import annotations

from typing import TYPE_CHECKING

from crankstar.analyses.guide.question import Question
from crankstar.analysis.assumptions import Answer
from crankstar.engine.engine import Engine
from crankstar.options.refusals import not_compiled
from crankstar.studies.answer_parts import narrowed
from crankstar.studies.answers import amplitudes

if TYPE_CHECKING:
    from crankstar.analyses.guide.engine_family import Member


def compute(engine: Engine, question: Question) -> tuple[Member, ...]:
    """The members of the family. Raises MarineError, RemedyError, SearchError, RequestError."""
    try:
        from crankstar.analyses.guide.engine_family import engine_family
    except ImportError as error:
        raise not_compiled(error) from None
    from crankstar.analyses.guide.published_orders import published_orders

    return engine_family(
        engine,
        numbers=question.numbers,
        given=question.firing_orders,
        published=published_orders(engine.cycle, question.numbers),
        options=question.goals,
        drive=question.chain_drive,
        point=question.point,
        speed=question.speed,
        horizontal_share=question.first_order,
    )


def answer(engine: Engine, question: Question) -> Answer:
    """The figures that it says first; the guide-force moments are rolls with gas, where it is."""
    whole = amplitudes(engine, point=question.point, speed=question.speed, both=True)
    if whole.gas is None:
        return whole
    return narrowed(whole, ["force", "couple", "roll with gas"])
