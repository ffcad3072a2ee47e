"""What is asked of V engines: cylinders, bank angles, pin splits, and which is written."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial
from typing import Annotated, cast, get_args

from crankstar.analysis.reader import Reader
from crankstar.engine.quantities import Cycle
from crankstar.language.messages import N_
from crankstar.options import readers
from crankstar.options import values as request
from crankstar.options.refusals import refuse_unused

USUAL_STAR = 1
"""The star of a row that is written where none is asked for."""


def _split(text: str) -> float:
    return request.degrees("--greatest-split", text)[0]


def _cycle(text: str) -> Cycle:
    return cast("Cycle", request.choice("--cycle", text, get_args(Cycle)))


@dataclass(frozen=True)
class Question:
    """How many cylinders, with what bank angles and greatest pin split (degrees) and cycle.

    `top` is how many rows readers see; the engine of `row`, with one of its stars, may be written.
    """

    cylinders: Annotated[
        int,
        Reader(
            "cylinders",
            partial(request.whole, "CYLINDERS"),
            N_("Number of cylinders, even, up to 16."),
        ),
    ]
    bank: Annotated[
        Sequence[float] | None, Reader("--bank", partial(request.degrees, "--bank"))
    ] = None
    greatest_split: Annotated[float | None, Reader("--greatest-split", _split)] = None
    cycle: Annotated[Cycle, Reader("--cycle", _cycle)] = "four-stroke"
    top: Annotated[int | None, readers.TOP] = None
    row: Annotated[int | None, Reader("--row", int)] = None
    star: Annotated[int, Reader("--star", int)] = USUAL_STAR


def refuse(_engine: None, question: Question) -> None:
    """Refuse a star of no row, and rows beside one. Raises RequestError."""
    if question.row is None:
        star = None if question.star == USUAL_STAR else question.star
        refuse_unused({"--star": star}, without="--row")
    else:
        refuse_unused({"--top": question.top}, beside="--row")


def writes(question: Question) -> str:
    """The option that has an engine written in place of the list; empty without."""
    return "" if question.row is None else "--row"
