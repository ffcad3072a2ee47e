"""What answers a question of engines built to their tolerances, and what that rests on."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import replace
from functools import lru_cache

from crankstar.analyses.tolerance.charts import scatter_chart
from crankstar.analyses.tolerance.question import BEARING, Question
from crankstar.analyses.tolerance.scatter import Scatter, scatter_of
from crankstar.analysis.assumptions import Answer
from crankstar.charts.grammar import Chart
from crankstar.engine.engine import Engine
from crankstar.options.sources import Loaded
from crankstar.studies.answers import amplitudes
from crankstar.studies.fields import Source


def compute(
    file: Loaded, question: Question, *, tell: Callable[[int, int], object] | None = None
) -> Scatter:
    """The scatter of the engine of a file. Raises ScatterError, OrderError.

    One that is not waited for is not worked out again for the same question.
    """
    if tell is None:
        orders = question.orders if isinstance(question.orders, str | None) else (*question.orders,)
        hashed = replace(question, quantity=tuple(question.quantity), orders=orders)
        return _known(file.name, json.dumps(file.tree, default=str), file.engine, hashed)
    return _scatter(Source(file.name, file.tree, file.engine), question, tell)


@lru_cache(maxsize=8)
def _known(name: str, tree: str, engine: Engine, question: Question) -> Scatter:
    return _scatter(Source(name, json.loads(tree), engine), question, None)


def _scatter(
    source: Source, question: Question, tell: Callable[[int, int], object] | None
) -> Scatter:
    return scatter_of(
        source,
        speed="file" if question.speed is None else question.speed,
        reference=question.reference,
        orders=question.wanted,
        assume="typical" if question.typical else None,
        distribution=question.distribution,
        count=question.builds,
        seed=question.seed,
        bearings=BEARING in question.quantity,
        tell=tell,
    )


def answer(engine: Engine, question: Question, *, result: Scatter) -> Answer:
    """The amplitudes of the engine as drawn."""
    del question
    return amplitudes(engine, speed=result.speed, reference=result.reference)


def picture(result: Scatter, question: Question) -> Chart:
    """The engines by amplitude, of the quantities and orders that are named."""
    orders = () if question.orders is None else result.orders
    return scatter_chart(result, quantities=question.quantity, orders=orders)
