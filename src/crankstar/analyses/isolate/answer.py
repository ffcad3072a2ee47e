"""What answers a question of the best mounts, and what that rests on."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple, cast

from crankstar.analyses.isolate.isolation import (
    STARTS,
    Isolation,
    IsolationAim,
    MountLimits,
    isolated,
)
from crankstar.analyses.isolate.question import Question
from crankstar.analyses.mounts.figures import on_mounts
from crankstar.analysis.assumptions import Answer
from crankstar.dynamics.mount_analysis import MountAnalysis, mounts
from crankstar.engine.engine import Engine


class Isolated(NamedTuple):
    """The best mounts, their limits, and the engine on its mounts before and after."""

    best: Isolation
    limits: MountLimits
    before: MountAnalysis
    after: MountAnalysis


def compute(
    engine: Engine, question: Question, *, tell: Callable[[int, int], None] | None = None
) -> Isolated:
    """The best mounts; `tell` is called after each start. Raises MountError, RemedyError."""
    limits = MountLimits(question.stiffness, question.shift, question.sag, question.frequencies)
    before = _mounted(engine, question)
    best = isolated(
        engine,
        before,
        aim=cast("IsolationAim", question.minimise),
        limits=limits,
        starts=question.starts or STARTS,
        tell=tell,
    )
    return Isolated(best, limits, before, _mounted(best.engine, question))


def _mounted(engine: Engine, question: Question) -> MountAnalysis:
    return mounts(engine, point=question.point, speeds=question.speeds, at=question.at)


def best_engine(result: Isolated) -> Engine:
    """The engine on the best mounts."""
    return result.best.engine


def answer(engine: Engine, question: Question) -> Answer:
    """What an engine does on its mounts."""
    return on_mounts(engine, point=question.point, speeds=question.speeds, at=question.at)
