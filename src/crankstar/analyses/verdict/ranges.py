"""The verdict on an estimated engine: each sentence with the ranges of its numbers."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from crankstar.analyses.verdict.facts import Fact
from crankstar.engine.engine import Engine
from crankstar.files.box import Spread
from crankstar.language.alike import alike
from crankstar.tables.laid import sentences

Verdict = Callable[[Engine], Sequence[Fact]]


def ranged_facts(verdict: Verdict, spread: Spread | None, engine: Engine) -> tuple[Fact, ...]:
    """The facts of an engine, with ranges where they rest on estimates."""
    if spread is None:
        return tuple(verdict(engine))
    facts = alike(verdict, (engine, spread.middle, *spread.corners))
    own, *others = map(_by_topic, facts)
    return tuple(
        Fact(about, text)
        for about, lines in own.items()
        for text in sentences(lines, [other.get(about, []) for other in others])
    )


def _by_topic(facts: Sequence[Fact]) -> dict[str, list[str]]:
    """The sentences of a verdict by topic."""
    out: dict[str, list[str]] = {}
    for fact in facts:
        out.setdefault(fact.about, []).append(fact.sentence)
    return out
