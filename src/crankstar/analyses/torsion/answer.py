"""What answers a question of torsional vibration, and what that rests on."""

from __future__ import annotations

from crankstar.analyses.torsion.figures import twist
from crankstar.analyses.torsion.question import Question
from crankstar.analysis.assumptions import Answer
from crankstar.dynamics.torsion_analysis import TorsionAnalysis, torsion
from crankstar.engine.engine import Engine
from crankstar.engine.torsion import Chain
from crankstar.language.messages import _n
from crankstar.options.refusals import refusal


def compute(source: Engine | Chain, asked: Question) -> TorsionAnalysis:
    """The analysis. Raises TorsionError, RequestError for a mode that there is not."""
    found = torsion(
        source,
        point=asked.point,
        speed=asked.speed,
        speeds=asked.speeds,
        orders=asked.orders,
        modes=asked.modes,
        off=asked.off,
        weaker=dict(asked.weaker),
    )
    for option, wanted in (("--modes", asked.modes), ("--holzer", asked.holzer)):
        if wanted is not None and wanted > len(found.modes):
            count = len(found.modes)
            why = _n("there is one mode", "there are {count} modes", count, count=count)
            raise refusal(option, wanted, why)
    return found


def answer(engine: Engine, asked: Question) -> Answer:
    """The figures that it says first."""
    return twist(
        engine,
        point=asked.point,
        speed=asked.speed,
        speeds=asked.speeds,
        off=asked.off,
        weaker=dict(asked.weaker),
    )
