"""What answers a question of a marine engine, and what that rests on."""

from __future__ import annotations

import numpy as np

from crankstar.analyses.marine.doubts import missing_guide, missing_units
from crankstar.analyses.marine.marine_analysis import MarineAnalysis, marine
from crankstar.analyses.marine.question import Question
from crankstar.analysis.assumptions import Answer
from crankstar.analysis.tried_values import Figure, Figures
from crankstar.engine.engine import Engine
from crankstar.mechanics.guide_moments import GuideMoments
from crankstar.mechanics.operating_points import GasError
from crankstar.options.refusals import refuse_unused
from crankstar.studies.answer_parts import IN_GUIDES, friction_of_power, usual_gas
from crankstar.studies.assumed_gas import usual_load
from crankstar.studies.assumed_loads import of_load
from crankstar.studies.gas_alone import gas_alone, lacking_gas


def compute(engine: Engine, question: Question) -> MarineAnalysis:
    """The analysis. Raises RemedyError, OrderError, GasError, RequestError for what is not used."""
    analysis = _analysed(engine, question)
    if lacking := missing_guide(analysis):
        refuse_unused({"--bracing": question.bracing}, why=lacking)
    if lacking := missing_units(analysis):
        still = {} if analysis.after.speed is not None else {"--speeds": [*question.speeds]}
        refuse_unused(still | {"--rated-power": question.rated_power}, why=lacking)
    return analysis


def changed(engine: Engine, question: Question) -> Engine:
    """The engine with end weights and compensators."""
    return _analysed(engine, question).engine


def _analysed(engine: Engine, question: Question) -> MarineAnalysis:
    return marine(
        engine,
        point=question.point,
        speed=question.speed,
        speeds=question.speeds,
        rated_power=question.rated_power,
        horizontal_share=question.first_order,
        compensate=question.compensate or {},
        node=question.node,
        phase_error=question.phase_error or 0.0,
        orders=question.orders,
    )


def answer(engine: Engine, question: Question) -> Answer:
    """The external moments and the moments of the guide forces by order."""

    def figures(each: Engine) -> Figures:
        analysis = _analysed(each, question)
        if whole.guide is not None and analysis.guide is None:
            raise GasError(analysis.without_guide)
        out: dict[Figure, float] = {}
        for order in analysis.after.orders.tolist():
            for name, side in (("vertical couple", "V"), ("horizontal couple", "H")):
                out[name, order] = float(np.nan_to_num(analysis.after.moment(order, side)))
        return out | _guide_sizes(analysis.guide)

    whole = _analysed(engine, question)
    usual = usual_gas(engine, speed=whole.after.speed)[0]
    one_shaft = len({cylinder.shaft for cylinder in engine.cylinders}) == 1
    choices = [usual_load(usual, figures, IN_GUIDES)] if usual and one_shaft else []
    if whole.cycle is not None:
        choices += gas_alone(engine, whole.cycle, figures)
    elif one_shaft:
        asked = {"point": question.point, "speed": question.speed}
        lacking = lacking_gas(engine, figures, IN_GUIDES, **asked)
        choices += [] if lacking is None else [lacking]
    return Answer(
        figures=figures,
        unit=lambda quantity, each: (
            "N*m" if quantity.endswith("moment") else _analysed(each, question).after.units.couple
        ),
        uses=("inertia", *(("gas",) if whole.cycle is not None else ())),
        gas=whole.cycle,
        choices=[*choices, *friction_of_power(engine, whole.cycle), *of_load(engine, whole.cycle)],
    )


def _guide_sizes(guide: GuideMoments | None) -> dict[Figure, float]:
    """The moments of guide forces by order, N m; none where they are not computed."""
    if guide is None:
        return {}
    moments = {"H moment": guide.h} | ({"X moment": guide.x} if guide.pitch_known else {})
    return {
        (name, float(order)): float(abs(size))
        for name, of_all in moments.items()
        for order, size in zip(guide.orders, of_all, strict=True)
    }
