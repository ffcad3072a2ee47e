"""What answers a question of an engine on its mounts, and what that rests on."""

from __future__ import annotations

from crankstar.analyses.mounts.figures import on_mounts
from crankstar.analyses.mounts.question import Question
from crankstar.analysis.assumptions import Answer
from crankstar.dynamics.mount_analysis import MountAnalysis, mounts
from crankstar.engine.engine import Engine


def compute(engine: Engine, asked: Question) -> MountAnalysis:
    """The analysis. Raises MountError."""
    return mounts(
        engine,
        point=asked.point,
        speed=asked.speed,
        speeds=asked.speeds,
        orders=asked.orders,
        at=asked.at,
    )


def answer(engine: Engine, asked: Question) -> Answer:
    """The figures that it says first."""
    return on_mounts(engine, point=asked.point, speed=asked.speed, speeds=asked.speeds, at=asked.at)
