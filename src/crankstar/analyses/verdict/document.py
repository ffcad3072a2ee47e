"""The verdict as a table: the subject, and the sentence."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from crankstar.analyses.verdict.answer import Verdict
from crankstar.analyses.verdict.facts import Fact
from crankstar.analyses.verdict.question import Question
from crankstar.analysis.document import Column, Document, Table
from crankstar.analysis.registry import analyses
from crankstar.engine.engine import Engine
from crankstar.language.messages import _
from crankstar.language.numbers import rpm_of


def document(engine: Engine, found: Verdict, asked: Question) -> Document:
    """The facts of an engine in two columns; machines have the speed of their numbers besides."""
    speed = engine.speed if asked.speed is None else asked.speed
    facts = {"engine": engine.name, "speed_rpm": rpm_of(speed)}
    return replace(verdict_document(engine, found.facts), facts=facts)


def verdict_document(engine: Engine, facts: Sequence[Fact]) -> Document:
    """The facts of an engine in two columns: the subject, and the sentence."""
    columns = (
        Column("", kind="text", label=True),
        Column("", kind="text", key="about", machine=True),
        Column("", kind="text", key="sentence", wraps=True),
    )
    rows = zip(verdict_rows(facts), facts, strict=True)
    table = Table(
        "", columns, tuple((row[0], fact.about, row[1]) for row, fact in rows), key="facts"
    )
    return Document(engine.name, (table,))


def verdict_rows(facts: Sequence[Fact]) -> list[tuple[str, str]]:
    """Each sentence beside its subject, which is named once."""
    names = subjects()
    before = ["", *(fact.about for fact in facts)]
    return [
        ("" if fact.about == about else names[fact.about], fact.sentence)
        for fact, about in zip(facts, before, strict=False)
    ]


def subjects() -> dict[str, str]:
    """The subjects of facts in the reader's language."""
    return {
        "layout": _("layout"),
        "firing": _("firing"),
        "units": _("units"),
        "force": _("force"),
        "couple": _("couple"),
        "roll": _("rolling moment"),
        **{record.name: _(record.subject) for record in analyses() if record.facts},
        "cure": _("remedy"),
        "remedied": _("with the remedy"),
        "relatives": _("comparison"),
    }
