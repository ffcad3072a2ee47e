"""The rotor whose balance quality is asked, and what its permissible unbalance rests on."""

from __future__ import annotations

from crankstar.analyses.grade.grades import GRADES, permissible, shares
from crankstar.analyses.grade.question import Question, Rotor
from crankstar.analysis.assumptions import Answer
from crankstar.engine.engine import Engine

USUAL = GRADES[3]
"""Of crankshafts of engines of which nothing else is known, G 6.3."""


def compute(engine: Engine | None, question: Question) -> Rotor:
    """The rotor at the speed that is asked for, else at that of the engine."""
    own = None if engine is None else engine.speed
    speed = own if question.speed is None else question.speed
    front, rear = question.bearing_distances or (1.0, 1.0)
    return Rotor(question.mass or 0.0, speed or 0.0, shares(front=front, rear=rear))


def answer(engine: Engine, question: Question, *, result: Rotor) -> Answer:
    """The permissible unbalance, which only the speed of an engine moves."""
    grade = USUAL if question.grade is None else question.grade

    def figures(each: Engine) -> dict[tuple[str, float | None], float]:
        speed = question.speed or each.speed or result.speed
        return {("permissible unbalance", None): permissible(grade, mass=result.mass, speed=speed)}

    given = [path for path in engine.provenance if path != "speed" or question.speed is not None]
    return Answer(figures=figures, unit=lambda _quantity, _engine: "kg*m", uses=(), given=given)
