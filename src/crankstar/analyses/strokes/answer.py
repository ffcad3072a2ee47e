"""What answers a question of strokes, and what that rests on."""

from __future__ import annotations

from crankstar.analyses.strokes.question import Question
from crankstar.analysis.assumptions import Answer
from crankstar.engine.engine import Engine
from crankstar.firing.strokes import WorkingCycle, working_cycle
from crankstar.studies.chart_answers import firing


def compute(engine: Engine, _question: Question) -> WorkingCycle:
    """The working cycle. Raises EngineError as `working_cycle`."""
    return working_cycle(engine)


def answer(engine: Engine, _question: Question) -> Answer:
    """When the cylinders fire; what is assumed of valves is said beside their angles."""
    return firing(engine)
