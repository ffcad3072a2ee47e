"""The verdict on an estimated engine: each sentence with the ranges of its numbers."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from crankstar.engine.engine import Engine
from crankstar.files.box import Spread
from crankstar.language.kept import alike
from crankstar.tables.ranges import sentence
from crankstar.tables.verdict import Fact

Verdict = Callable[[Engine], Sequence[Fact]]


def ranged_facts(
    verdict: Verdict, spread: Spread | None, engine: Engine, *, at_ends: Verdict | None = None
) -> tuple[Fact, ...]:
    """The facts of an engine, with ranges where they rest on estimates.

    `at_ends` gives those of the engines in the middle and at the corners of the ranges, if it is
    another: a comparison with the catalog, which it may leave out, is marked without ranges.
    """
    if spread is None:
        return tuple(verdict(engine))
    facts = alike(
        lambda each: (verdict if each is engine else at_ends or verdict)(each),
        (engine, spread.middle, *spread.corners),
    )
    own, *others = map(_by_topic, facts)
    return tuple(
        Fact(about, sentence(text, [other.get((about, place), "") for other in others]))
        for (about, place), text in own.items()
    )


def _by_topic(facts: Sequence[Fact]) -> dict[tuple[str, int], str]:
    """The sentences of a verdict by topic and place within it."""
    out: dict[tuple[str, int], str] = {}
    for fact in facts:
        place = sum(about == fact.about for about, _place in out)
        out[fact.about, place] = fact.sentence
    return out
