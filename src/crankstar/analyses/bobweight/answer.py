"""What answers a question of bobweights, and what that rests on."""

from __future__ import annotations

from crankstar.analyses.bobweight.question import Card, Question
from crankstar.analysis.assumptions import Answer
from crankstar.engine.engine import Engine
from crankstar.options.remedies import HALF
from crankstar.options.sources import Loaded
from crankstar.studies.answers import bobweights


def compute(file: Loaded, question: Question) -> Card:
    """The balance factor that is asked for, else that of the file, else a half."""
    own = file.balance_factor if question.factor is None else question.factor
    return Card(HALF if own is None else own, own is None)


def answer(engine: Engine, question: Question, *, result: Card) -> Answer:
    """The heaviest bobweight."""
    del question
    return bobweights(engine, factor=result.factor, assumed=result.assumed)
