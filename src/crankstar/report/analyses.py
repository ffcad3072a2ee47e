"""The section of an analysis: what the verdict says of it, its tables, its figures."""

from __future__ import annotations

from typing import Any

from crankstar.analysis.document import Remarks, Table
from crankstar.analysis.record import Analysis, Figure
from crankstar.analysis.registry import added
from crankstar.charts.canvas import drawn_on
from crankstar.charts.grammar import Chart
from crankstar.language.messages import _
from crankstar.report.gallery import ACROSS, Gallery
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
    file = subject.file
    if not record.tells(subject.engine, subject.at, file=file):
        return ""
    question = record.question.value(speed=subject.at, **record.views)

    def tables(each: Subject) -> list[Table | Remarks]:
        return record.viewed(each.engine, each.at, file=each.file)

    found = record.compute.value(file if record.of_file else subject.engine, question)
    drawn = [
        gallery.figure(each.chart, _(each.caption), **_options(each, subject))
        for each in record.figures
        if (subject.full or not each.more) and each.shows(found)
    ]
    lead = "".join(paragraph(fact.sentence) for fact in subject.facts if fact.about == record.name)
    if (picture := record.picture) is not None and picture.caption:

        def chart() -> Chart:
            with drawn_on(ACROSS):
                return picture.draw.value(found, question)

        drawn.append(gallery.drawn(record.name, _(picture.caption), chart, "wide"))
    shown = parts_html(tables(subject) if record.unranged else subject.parts(tables))
    return section(_(record.title), lead + shown + figures(drawn), name=record.name)


def _options(figure: Figure, subject: Subject) -> dict[str, Any]:
    """Its quantity, and the speed of the report where it is drawn at one."""
    return {**figure.quantities, **({"speed": subject.at} if figure.at_speed else {})}
