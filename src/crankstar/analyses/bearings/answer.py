"""What answers a question of the loads on bearings, and what that rests on."""

from __future__ import annotations

from dataclasses import dataclass

from crankstar.analyses.bearings.question import Question
from crankstar.analysis.assumptions import Answer
from crankstar.dynamics.bearings import BearingLoads, bearing_loads
from crankstar.engine.engine import Engine
from crankstar.mechanics.gas import Cycle, cycle
from crankstar.studies.load_answers import bearing_peaks


@dataclass(frozen=True)
class Loads:
    """The loads of an engine, the cycle of their gas if any, and their speed, rad/s."""

    of_parts: BearingLoads
    cycle: Cycle | None
    speed: float | None


def compute(engine: Engine, question: Question) -> Loads:
    """The loads. Raises BearingError, GasError."""
    burnt = _burnt(engine, question)
    speed = engine.speed if question.speed is None else question.speed
    if burnt is not None:
        speed = burnt.speed
    return Loads(
        bearing_loads(engine, speed=speed, model=question.model, cycle=burnt), burnt, speed
    )


def _burnt(engine: Engine, question: Question) -> Cycle | None:
    if not question.burning:
        return None
    return cycle(engine, point=question.point or "", speed=question.speed, off=question.off)


def answer(engine: Engine, question: Question) -> Answer:
    """The figures that it says first."""
    return bearing_peaks(
        engine, lambda each: _burnt(each, question), speed=question.speed, model=question.model
    )
