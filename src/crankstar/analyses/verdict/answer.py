"""What answers it: the facts of an engine, also as it may be built, and what they rest on."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING, NamedTuple

from crankstar.analyses.tolerance.as_built import as_built
from crankstar.analyses.verdict.facts import Fact, verdict
from crankstar.analyses.verdict.question import Question
from crankstar.analyses.verdict.ranges import ranged_facts
from crankstar.analysis.assumptions import Answer
from crankstar.analysis.record import Onward
from crankstar.engine.engine import Engine
from crankstar.language.messages import N_
from crankstar.options.sources import Loaded
from crankstar.remedy.fitting import recommended
from crankstar.studies.answers import summary

if TYPE_CHECKING:
    from crankstar.analyses.tolerance.scatter import Scatter


REMEDIES = ("cure", "remedied", "relatives")
"""Topics that follow those of engines as built."""


class Verdict(NamedTuple):
    """The sentences on an engine, each with its subject."""

    facts: tuple[Fact, ...]


def compute(file: Loaded, asked: Question) -> Verdict:
    """The verdict on an engine, with the ranges of what is estimated, and on it as built."""
    engine, speed = file.engine, asked.speed
    facts = ranged_facts(partial(verdict, speed=speed), file.spread, engine)
    return Verdict(_with_built(facts, as_built(engine, file.tree, speed=speed)))


def _with_built(facts: tuple[Fact, ...], built: Scatter | None) -> tuple[Fact, ...]:
    """The facts of an engine with those of engines as built, where its file has tolerances."""
    if built is None:
        return facts
    from crankstar.analyses.tolerance.document import sentences

    own = [Fact("tolerances", sentence) for sentence in sentences(built)]
    last = max(
        (index for index, fact in enumerate(facts) if fact.about not in REMEDIES), default=-1
    )
    return (*facts[: last + 1], *own, *facts[last + 1 :])


def answer(engine: Engine, asked: Question) -> Answer:
    """The figures of its sentences."""
    return summary(engine, speed=asked.speed)


def onward(engine: Engine) -> Onward | None:
    """The command that fits what it recommends, if anything."""
    if recommended(engine) is None:
        return None
    sentence = N_("To fit the recommended remedy and see what remains: {command}")
    return Onward(sentence, "balance", ("--recommended",))
