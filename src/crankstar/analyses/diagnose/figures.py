"""What a diagnosis is about, by figures: what it rests on moves them."""

from __future__ import annotations

from collections.abc import Sequence

from crankstar.analyses.diagnose.readings import Reading
from crankstar.analysis.assumptions import Answer
from crankstar.engine.engine import Engine
from crankstar.studies.response_answers import felt


def explained(engine: Engine, readings: Sequence[Reading], *, point: str) -> Answer:
    """The velocity at the first position of the readings, by their orders.

    At the highest of their speeds.
    """
    return felt(
        engine,
        (),
        point=point,
        speed=max(each.speed for each in readings),
        orders=sorted({each.order for each in readings}),
        at=readings[0].place,
    )
