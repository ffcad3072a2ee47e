"""What answers a question of a family of engines, and what that rests on."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from crankstar.analyses.guide.question import Question
from crankstar.analysis.assumptions import Answer
from crankstar.analysis.tried_values import Figures
from crankstar.engine.engine import Engine
from crankstar.options.refusals import not_compiled
from crankstar.studies.answer_parts import friction_of_power, narrowed
from crankstar.studies.answers import amplitudes

if TYPE_CHECKING:
    from crankstar.analyses.guide.engine_family import Member

SMALL = 8
"""Numbers of cylinders up to which an order is searched for in no time."""
OF_MEMBERS = ("force", "couple")


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
    whole = _of_members(engine, question)
    if whole.gas is None:
        return whole
    own = narrowed(whole, ["force", "couple", "roll with gas"])
    return replace(own, choices=[*own.choices, *friction_of_power(engine, whole.gas)])


def _of_members(engine: Engine, question: Question) -> Answer:
    """Force and couple by order, of the small members that which has most; the rest its own.

    An even number of cylinders may cancel what an odd one shows: a rotating mass that is missing.
    """
    from crankstar.analyses.guide.engine_family import best_orders, with_cylinders

    asked: Mapping[str, Any] = {"point": question.point, "speed": question.speed}
    whole = amplitudes(engine, **asked, both=True)
    numbers = [count for count in question.numbers if count <= SMALL] or question.numbers[:1]
    orders = best_orders(
        engine, numbers, options=question.goals, drive=question.chain_drive, speed=question.speed
    )

    def figures(each: Engine) -> Figures:
        out = {key: size for key, size in whole.figures(each).items() if key[0] not in OF_MEMBERS}
        for order in orders:
            member = with_cylinders(each, order, drive=question.chain_drive)
            for key, size in amplitudes(member, **asked, gas=True).figures(member).items():
                if key[0] in OF_MEMBERS:
                    out[key] = max(out.get(key, 0.0), size)
        return out

    return replace(whole, figures=figures)
