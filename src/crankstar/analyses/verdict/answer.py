"""What answers it: the facts of an engine, also as it may be built, and what they rest on."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial
from typing import NamedTuple

from crankstar.analyses.verdict.facts import Fact, verdict
from crankstar.analyses.verdict.question import Question
from crankstar.analyses.verdict.ranges import ranged_facts
from crankstar.analysis.assumptions import Answer
from crankstar.analysis.record import Onward
from crankstar.analysis.registry import added, analyses
from crankstar.engine.engine import Engine
from crankstar.language.messages import N_
from crankstar.options.sources import Loaded
from crankstar.remedy.fitting import recommended
from crankstar.studies.answers import summary

REMEDIES = ("cure", "remedied", "relatives")
"""Topics that follow those of the file."""


class Verdict(NamedTuple):
    """The sentences on an engine, each with its subject."""

    facts: tuple[Fact, ...]


def compute(file: Loaded, asked: Question) -> Verdict:
    """The verdict on an engine, with the ranges of what is estimated, and on it as built."""
    engine, speed = file.engine, asked.speed
    facts = ranged_facts(partial(verdict, speed=speed), file.spread, engine)
    last = max(
        (index for index, fact in enumerate(facts) if fact.about not in REMEDIES), default=-1
    )
    return Verdict((*facts[: last + 1], *_of_file(file, speed), *facts[last + 1 :]))


def _of_file(file: Loaded, speed: float | None) -> Iterator[Fact]:
    """What the analyses say that are of the file of an engine."""
    for record in analyses():
        if record.facts is None or not record.of_file:
            continue
        with added().among_others(record.name):
            if record.tells(file.engine, speed, file=file):
                for sentence in record.facts.value(file, speed=speed):
                    yield Fact(record.name, sentence)


def answer(engine: Engine, asked: Question) -> Answer:
    """The figures of its sentences."""
    return summary(engine, speed=asked.speed)


def onward(engine: Engine) -> Onward | None:
    """The command that fits what it recommends, if anything."""
    if recommended(engine) is None:
        return None
    sentence = N_("To fit the recommended remedy and see what remains: {command}")
    return Onward(sentence, "balance", ("--recommended",))
