"""What answers a question of measurements, and what that rests on."""

from __future__ import annotations

from crankstar.analyses.diagnose.diagnosis import Diagnosis, diagnosed
from crankstar.analyses.diagnose.figures import explained
from crankstar.analyses.diagnose.question import Question
from crankstar.analysis.assumptions import Answer
from crankstar.engine.engine import Engine


def compute(engine: Engine, question: Question) -> Diagnosis:
    """The likeliest faults. Raises DiagnosisError."""
    measured, before = question.readings(engine)
    return diagnosed(engine, measured, before=before, point=question.point)


def answer(engine: Engine, question: Question) -> Answer:
    """The figures that it explains."""
    return explained(engine, question.readings(engine)[0], point=question.point)
