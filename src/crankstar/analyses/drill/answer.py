"""The unbalances that holes are drilled for, the holes, and what these rest on."""

from __future__ import annotations

from cmath import rect
from typing import NamedTuple

from crankstar.analyses.drill.question import Question
from crankstar.analysis.assumptions import Answer
from crankstar.engine.engine import Engine
from crankstar.language.alike import as_given
from crankstar.mechanics.bounds import bounded
from crankstar.options.holes import drill_of
from crankstar.options.refusals import RequestError
from crankstar.options.remedies import HALF
from crankstar.options.sources import Loaded
from crankstar.remedy import fitting
from crankstar.remedy.drilling import Drill, heavy_spots, holes
from crankstar.studies.answers import bobweights
from crankstar.tables.drilling import Correction


class Drilled(NamedTuple):
    """The drill, the planes with their holes, and of an engine the balance factor.

    It is `assumed` if neither asked for nor in the file.
    """

    drill: Drill
    corrections: tuple[Correction, ...]
    factor: float | None = None
    assumed: bool = False


def compute(file: Loaded | None, question: Question) -> Drilled:
    """The holes for what is measured, or for an engine with the factor of question, file or half.

    Raises RequestError, RemedyError.
    """
    made = drill_of(question)
    if file is None:
        return Drilled(made, tuple(_measured(question, made)))
    own = file.balance_factor if question.factor is None else question.factor
    factor = HALF if own is None else own
    return Drilled(
        made, tuple(_of_engine(file.engine, question, made, factor)), factor, own is None
    )


def _measured(question: Question, made: Drill) -> list[Correction]:
    """The holes for the unbalances that a balancing machine shows."""
    return [
        Correction(str(number), None, spot.unbalance, spot.angle, holes(spot.unbalance, made))
        for number, spot in enumerate(question.unbalance or (), 1)
    ]


def _of_engine(engine: Engine, question: Question, made: Drill, factor: float) -> list[Correction]:
    """The holes for what a crankshaft with its counterweights has too much.

    Those of an engine at the ends of estimated ranges are the holes of the engine as given.
    """
    if {"mass", "radius", "pitch"} & {*engine.relative}:
        raise RequestError(
            "what to drill is in grams and millimetres; add to the file what it leaves out of "
            "cylinder.stroke, layout.bore_pitch and cylinder.parts or the two masses"
        )
    weights = "ends" if question.weights is None else question.weights
    after = fitting.by_factor(engine, factor=factor, weights=weights)
    cranks = [shaft for shaft in engine.shafts if shaft.throws]
    first = {shaft.name: shaft.throws[0].angle for shaft in cranks}
    corrections: list[Correction] = []
    for number, spot in enumerate(heavy_spots(engine, after), 1):
        drilled = as_given(("drilled", number), spot)
        corrections.append(
            Correction(
                f"{spot.shaft} {number}" if len(cranks) > 1 else str(number),
                spot.z,
                bounded(spot.unbalance, [[rect(spot.unbalance, spot.angle)]]),
                spot.angle,
                holes(drilled.unbalance, made),
                first[spot.shaft],
                drilled.angle,
            )
        )
    return corrections


def answer(engine: Engine, _question: Question, *, result: Drilled) -> Answer:
    """The heaviest bobweight, which the holes are to leave."""
    factor = HALF if result.factor is None else result.factor
    return bobweights(engine, factor=factor, assumed=result.assumed)
