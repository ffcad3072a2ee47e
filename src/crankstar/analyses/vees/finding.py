"""What finds V engines that fire evenly, and the engine of one of them."""

from __future__ import annotations

from collections.abc import Sequence

from crankstar.analyses.vees.question import Question
from crankstar.engine.engine import Engine
from crankstar.firing.vees import Vee, engine_of, vees
from crankstar.options.refusals import of_row


def compute(_source: None, question: Question) -> Sequence[Vee]:
    """The engines, best balanced first. Raises OrderError."""
    return vees(
        cylinders=question.cylinders,
        bank_angles_deg=question.bank,
        greatest_split_deg=question.greatest_split,
        cycle=question.cycle,
    )


def engine(result: Sequence[Vee], question: Question) -> Engine:
    """That of a row and one of its stars. Raises RequestError."""
    vee = of_row("--row", question.row or 0, result)
    of_row("--star", question.star, vee.stars)
    return engine_of(vee, star=question.star - 1)
