"""What answers a question of a generating set, and what that rests on."""

from __future__ import annotations

from functools import partial
from typing import Any

from crankstar.analyses.genset.document import missing_running, missing_sums
from crankstar.analyses.genset.generating_set import GeneratingSet, generating_set
from crankstar.analyses.genset.question import Question
from crankstar.analysis.assumptions import Answer
from crankstar.engine.engine import Engine
from crankstar.mechanics.gas import cycle, cycle_or_reason
from crankstar.options.values import refuse_unused
from crankstar.studies.answers import amplitudes, torques


def compute(engine: Engine, asked: Question) -> GeneratingSet:
    """The set. Raises GasError, UnevenError, RequestError for what cannot be told of it."""
    found = generating_set(
        engine,
        point=asked.point,
        speed=asked.speed,
        flywheel=asked.flywheel,
        pole_pairs=asked.pole_pairs,
        engines=asked.engines or 1,
        irregularity=asked.irregularity,
        off=asked.off,
        weaker=dict(asked.weaker),
    )
    if lacking := missing_running(found):
        of_running = {
            "--pole-pairs": asked.pole_pairs,
            "--flywheel": asked.flywheel,
            "--irregularity": asked.irregularity if found.wanted is None else None,
        }
        refuse_unused(of_running, why=lacking)
    if lacking := missing_sums(found):
        refuse_unused({"--engines": asked.engines}, why=lacking)
    return found


def answer(engine: Engine, asked: Question) -> Answer:
    """The figures that it says first."""
    at: dict[str, Any] = {"point": asked.point, "speed": asked.speed}
    at |= {"off": asked.off, "weaker": dict(asked.weaker)}
    if cycle_or_reason(engine, **at)[0] is None:
        return amplitudes(engine)
    return torques(
        engine,
        partial(cycle, **at),
        flywheel=asked.flywheel,
        irregularity=asked.irregularity,
        sums=True,
    )
