"""What is asked of a generating set."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Annotated

from crankstar.engine.engine import Engine
from crankstar.mechanics.phase_sums import MOST
from crankstar.options import readers
from crankstar.options.gas import refuse_strange, refuse_together
from crankstar.options.refusals import each

MOST_PAIRS = 200
"""Of poles: more than any slow hydroelectric generator has."""


@dataclass(frozen=True)
class Question:
    """Of how many pole pairs and engines, with what flywheel (kg m^2), or how even (1) it is to be.

    Cylinders may be off or lack a share of their combustion; speed in rad/s.
    """

    pole_pairs: Annotated[int | None, readers.count("--pole-pairs", MOST_PAIRS)] = None
    engines: Annotated[int | None, readers.count("--engines", MOST, "Default: 1.")] = None
    flywheel: Annotated[float | None, readers.FLYWHEEL] = None
    irregularity: Annotated[float | None, readers.IRREGULARITY] = None
    off: Annotated[Sequence[int], readers.OFF] = ()
    weaker: Annotated[Sequence[tuple[int, float]], readers.WEAKER] = ()
    point: Annotated[str, readers.POINT] = ""
    speed: Annotated[float | None, readers.SPEED] = None


def refuse(engine: Engine, asked: Question) -> None:
    """Refuse cylinders that are both off and weaker, and what the engine has not.

    Raises RequestError, GasError.
    """
    each(
        lambda: refuse_together(off=asked.off, weaker=asked.weaker),
        lambda: refuse_strange(engine, asked),
    )
