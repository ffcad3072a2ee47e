"""What a list of firing orders rests on, and the engine that fires one of them."""

from __future__ import annotations

from dataclasses import replace
from typing import cast

from crankstar.analyses.orders.listing import Listing, gas_of, sums_of
from crankstar.analyses.orders.question import Question
from crankstar.analysis.assumptions import Answer
from crankstar.analysis.tried_values import Figures
from crankstar.engine.copies import with_values
from crankstar.engine.engine import Engine
from crankstar.firing.numbering import with_order
from crankstar.language.messages import _
from crankstar.language.quoting import one_line
from crankstar.mechanics.gas import cycle
from crankstar.options.refusals import of_row
from crankstar.studies.chart_answers import firing
from crankstar.studies.judged_orders import UNITS, Judge, judgement

SUM, LOAD, STRESS = "least sum of firing orders", "least bearing load", "least torsional stress"
"""What the first order has of what they are sorted by, as quantities."""


def answer(engine: Engine, question: Question, *, result: Listing) -> Answer:
    """What the first order has of what orders are sorted by; else only when cylinders fire."""
    what = question.minimise
    if what is None or not result.orders:
        own = firing(engine)  # but for its order, which is one of the list
        return replace(own, given=(*own.given, "firing_order"))
    first = result.orders[0]
    if result.judged:
        judge = cast("Judge", what)
        name = STRESS if judge == "stress" else LOAD

        def whole(each: Engine) -> Figures:
            fired = with_order(each, first.firing)
            return {(name, None): judgement(fired, judge, point=question.point)}

        of_twist = judge == "stress"
        return Answer(
            figures=whole,
            unit=lambda _quantity, _engine: UNITS[judge],
            uses=("inertia", "gas", "torsion" if of_twist else "bearings"),
            gas=cycle(engine, point=question.point),
        )
    gas = gas_of(engine, question)

    def figures(each: Engine) -> Figures:
        return {(SUM, None): sums_of(each, (first,), what, question).whole[0]}

    return Answer(
        figures=figures,
        unit=lambda _quantity, _engine: "" if gas is None else "N*m",
        uses=("firing",) if gas is None else ("firing", "gas"),
        gas=gas,
    )


def fired(result: Listing, question: Question) -> Engine:
    """The engine with the order of a row. Raises RequestError."""
    firing = of_row("--row", question.row or 0, result.orders).firing
    words = _("fires {order}", order="-".join(map(str, firing.order)))
    name = one_line(f"{result.engine.name}, {words}")
    return with_values(with_order(result.engine, firing), name=name)
