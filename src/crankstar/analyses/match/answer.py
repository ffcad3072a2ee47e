"""What answers a question of a batch of parts, and what that rests on."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from crankstar.analyses.match.matching import Matched, left_by
from crankstar.analyses.match.question import Question
from crankstar.analyses.match.sets import Division, divided
from crankstar.analysis.assumptions import Answer
from crankstar.analysis.tried_values import Figures
from crankstar.engine.copies import with_values
from crankstar.engine.engine import Engine
from crankstar.language.messages import _
from crankstar.language.quoting import one_line

LEFT = "unbalance left"
"""What is left in the engine with most, as a quantity."""


def compute(
    engine: Engine, question: Question, *, tell: Callable[[int, int], bool] | None = None
) -> Division:
    """The matched engines; where `tell` gives False, the best so far. Raises MatchingError."""
    batch = question.batch
    return divided(
        engine,
        batch,
        engines=question.engines,
        orders=question.orders,
        quantities=question.quantity,
        classes=question.classes,
        whole=question.whole,
        watch=tell,
    )


def proved(result: Division) -> bool:
    """Whether each engine has its best assignment."""
    return all(each.proved for each in result.engines)


def built(result: Division) -> Sequence[Engine]:
    """The engines with their parts, each with a name of its own."""
    several = len(result.engines) > 1
    return [
        with_values(
            each.engine,
            name=one_line(
                _("{engine}, parts matched, no. {number}", engine=each.engine.name, number=number)
                if several
                else _("{engine}, parts matched", engine=each.engine.name)
            ),
        )
        for number, each in enumerate(result.engines, 1)
    ]


def answer(engine: Engine, question: Question, *, result: Division | None = None) -> Answer:
    """The unbalance that is left with the parts where they are, in the engine with most."""
    found = compute(engine, question) if result is None else result

    def figures(each: Engine) -> Figures:
        return {(LEFT, None): max(_left(each, question, one) for one in found.engines)}

    return Answer(figures=figures, unit=lambda _quantity, _engine: "kg*m")


def _left(engine: Engine, question: Question, found: Matched) -> float:
    return left_by(
        engine,
        question.batch,
        found.places,
        orders=question.orders,
        quantities=question.quantity,
        whole=question.whole,
    )
