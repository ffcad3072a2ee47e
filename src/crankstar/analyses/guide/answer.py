"""What answers a question of a family of engines, and what that rests on."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np

from crankstar.analyses.guide.question import Question
from crankstar.analysis.assumptions import COUPLE_OF, H_OF, X_OF, Answer
from crankstar.analysis.tried_values import Figure, Figures
from crankstar.engine.engine import Engine
from crankstar.mechanics.balance import scales
from crankstar.mechanics.operating_points import GasError, operating_state
from crankstar.options.refusals import not_compiled
from crankstar.studies.answer_parts import IN_GUIDES, friction_of_power, gas_of
from crankstar.studies.gas_alone import gas_alone, lacking_gas

if TYPE_CHECKING:
    from crankstar.analyses.guide.engine_family import Member

SMALL = 8
"""Numbers of cylinders up to which an order is searched for in no time."""
ORDERS = (1.0, 2.0, 4.0)
"""Those of the external moments in its table."""


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
    """The moments of the small members with their best firing orders, as its table has them.

    Other members have more of the same, and an even number of cylinders may cancel what an odd one
    shows: a rotating mass that is missing.
    """
    from crankstar.analyses.guide.engine_family import best_orders, member, with_cylinders

    numbers = [count for count in question.numbers if count <= SMALL] or question.numbers[:1]
    orders = best_orders(
        engine, numbers, options=question.goals, drive=question.chain_drive, speed=question.speed
    )
    asked = {
        "point": question.point,
        "speed": question.speed,
        "horizontal_share": question.first_order,
    }

    found, why = gas_of(engine, point=question.point, speed=question.speed)
    burns = found is not None

    def figures(each: Engine) -> Figures:
        out: dict[Figure, float] = {}
        for order in orders:
            made = with_cylinders(each, order, drive=question.chain_drive)
            own = member(made, "best", asked)
            if burns and own.found is not None and own.found.cycle is None:
                raise GasError(own.found.without_guide)
            out |= _of_member(own)
        return out

    def least(each: Engine) -> Mapping[str, float]:
        """The greatest of its kind in the table: what a member cancels is no measure."""
        sizes = figures(each)
        tops: dict[str, float] = {}
        for (name, _order), size in sizes.items():
            kind = name.rpartition(" ")[0]
            tops[kind] = max(tops.get(kind, 0.0), size)
        return {name: tops[name.rpartition(" ")[0]] for name, _order in sizes}

    guided = [f"{name}{count}" for name in (H_OF, X_OF) for count in numbers]
    choices = [*friction_of_power(engine, found)]
    if found is not None:
        choices += gas_alone(engine, found, figures, guided)
    lacking = lacking_gas(engine, figures, IN_GUIDES, speed=question.speed, point=question.point)
    choices += [] if lacking is None else [lacking]
    turning = operating_state(engine, point=question.point, speed=question.speed).speed
    return Answer(
        figures=figures,
        unit=lambda quantity, each: (
            scales(each, turning)[1].couple if quantity.startswith(COUPLE_OF) else "N*m"
        ),
        uses=("inertia", *(("gas",) if found is not None else ())),
        gas=found,
        least=least,
        why_gasless=why,
        choices=choices,
    )


def _of_member(own: Member) -> dict[Figure, float]:
    """The moments of a member that its table has: couples by order, the greatest H and X."""
    out: dict[Figure, float] = {}
    if own.found is not None:
        for order in ORDERS:
            sizes = [own.found.after.moment(order, side) for side in ("V", "H")]
            out[f"{COUPLE_OF}{own.cylinders}", order] = float(np.nanmax([0.0, *sizes]))
    for name, greatest in ((H_OF, own.h), (X_OF, own.x)):
        if greatest is not None:
            out[f"{name}{own.cylinders}", None] = greatest[1]
    return out
