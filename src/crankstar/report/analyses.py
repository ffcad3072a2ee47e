"""The section of an analysis: what the verdict says of it, its tables, its figures."""

from __future__ import annotations

from typing import Any

from crankstar.analysis.document import Remarks, Table
from crankstar.analysis.record import Analysis, Figure
from crankstar.analysis.registry import added
from crankstar.language.messages import _
from crankstar.report.gallery import Gallery
from crankstar.report.markup import figures, parts_html, section
from crankstar.report.subject import Subject
from crankstar.tables.html import paragraph


def section_of(record: Analysis, subject: Subject, gallery: Gallery) -> str:
    """Empty where the engine file lacks what the analysis is of.

    Raises PackageError where that of another package fails.
    """
    with added().running(record.name):
        return _section_of(record, subject, gallery)


def _section_of(record: Analysis, subject: Subject, gallery: Gallery) -> str:
    if not record.tells(subject.engine, subject.at):
        return ""
    question = record.question.value(speed=subject.at)

    def tables(each: Subject) -> list[Table | Remarks]:
        first, *parts = record.told(each.engine, record.question.value(speed=each.at)).parts
        # the heading of the engine stands on the first page
        return parts if isinstance(first, Remarks) else [first, *parts]

    found = record.compute.value(subject.engine, question)
    drawn = [
        gallery.figure(each.chart, _(each.caption), **_options(each, subject))
        for each in record.figures
        if (subject.full or not each.more) and each.shows(found)
    ]
    lead = "".join(paragraph(fact.sentence) for fact in subject.facts if fact.about == record.name)
    shown = parts_html(subject.parts(tables))
    return section(_(record.title), lead + shown + figures(drawn), name=record.name)


def _options(figure: Figure, subject: Subject) -> dict[str, Any]:
    """Its quantity, and the speed of the report where it is drawn at one."""
    return {**figure.quantities, **({"speed": subject.at} if figure.at_speed else {})}
