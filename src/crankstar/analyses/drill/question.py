"""What is asked of holes: how they are drilled, for which unbalance."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Annotated

from crankstar.analysis.reader import Reader, is_given
from crankstar.engine.engine import Engine
from crankstar.options import remedies
from crankstar.options.holes import Hole, refuse_lacking
from crankstar.options.refusals import RequestError, refuse_unused
from crankstar.options.unbalances import Measured, measured
from crankstar.remedy import Plane
from crankstar.remedy.fitting import Places

Weights = list[Plane] | Places


def _measured(text: str, *, at_radius: float | None) -> Sequence[Measured]:
    return measured(text, radius=at_radius)


def _weights(text: str, engine: Engine | None) -> Weights | None:
    return None if engine is None else remedies.weights(text, engine)


@dataclass(frozen=True)
class Question(Hole):
    """The hole, and either a measured unbalance or what an engine's counterweights have too much.

    Of that `factor` is the share of the reciprocating masses that is balanced, None as in the file;
    `weights` are the planes.
    """

    unbalance: Annotated[
        Sequence[Measured] | None,
        Reader(
            "--unbalance",
            _measured,
            "A mass alone is at the radius of --at-radius.",
            beside=("at_radius",),
        ),
    ] = None
    factor: Annotated[float | None, Reader("--factor", remedies.factor)] = None
    weights: Annotated[
        Weights | None, Reader("--weights", _weights, "Default: ends.", of_source=True)
    ] = None


def refuse(engine: Engine | None, question: Question) -> None:
    """Refuse holes without a size, for nothing or for two things. Raises RequestError."""
    shown = is_given(question, "unbalance")
    if engine is None and not shown:
        raise RequestError(
            "name an engine file with its counterweights, or give what the balancing machine "
            'shows, as in --unbalance "850 g*mm at 20 deg"'
        )
    if shown:
        others = {
            "ENGINE": None if engine is None else engine.name,
            "--factor": is_given(question, "factor"),
            "--weights": is_given(question, "weights"),
        }
        refuse_unused(others, beside="--unbalance")
    refuse_lacking(question)
