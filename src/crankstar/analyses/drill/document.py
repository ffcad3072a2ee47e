"""What to drill, with what the unbalances are those of."""

from __future__ import annotations

from collections.abc import Iterator

from crankstar.analyses.drill.answer import Drilled
from crankstar.analyses.drill.question import Question
from crankstar.analysis.document import Document
from crankstar.engine.engine import Engine
from crankstar.language.messages import _
from crankstar.language.numbers import number
from crankstar.tables.drilling import drilling_document
from crankstar.tables.ranges import estimated_paths
from crankstar.tables.scales import scales


def document(engine: Engine | None, result: Drilled, question: Question) -> Document:
    """The holes plane by plane."""
    if engine is None:
        lines = [*_at_usual_radius(question, result)]
        title = _("Correction of a measured unbalance")
        return drilling_document(title, result.corrections, result.drill, lines=lines)
    return drilling_document(
        engine.name,
        result.corrections,
        result.drill,
        along=scales(engine).along,
        lines=[*_of_engine(engine, result)],
        estimated=bool(estimated_paths(engine)),
    )


def _at_usual_radius(question: Question, result: Drilled) -> Iterator[str]:
    if any(spot.at_usual_radius for spot in question.unbalance or ()):
        radius = number(1000 * result.drill.radius)
        yield _(
            "A mass without a radius counts at {radius} mm, that of --at-radius.", radius=radius
        )


def _of_engine(engine: Engine, result: Drilled) -> Iterator[str]:
    if not any(shaft.weights for shaft in engine.shafts if shaft.throws):
        yield _(
            "The file gives no counterweights: what is listed is all that the throws and their "
            "bobweights come to. Add the crankshaft's weights to the file."
        )
    yield _(
        "Bobweights of the rotating masses and {factor} of the reciprocating masses.",
        factor=f"{100 * (result.factor or 0.0):.6g} %",
    )
    if not result.corrections:
        yield _("The counterweights fit the bobweights: nothing is to be drilled.")
