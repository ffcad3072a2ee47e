"""The front page: the engine, how it shakes, what to do; then the contents."""

from __future__ import annotations

from collections.abc import Sequence

from crankstar.analyses.verdict.facts import Fact
from crankstar.language.messages import N_, _, passage
from crankstar.remedy.fitting import recommended, recommended_like
from crankstar.report.markup import figure
from crankstar.report.subject import Subject
from crankstar.report.title import MOST_TRUSTED, data
from crankstar.report.views import FRONT_PAGE, view
from crankstar.tables.html import paragraph, text
from crankstar.tables.ranges import estimated_paths
from crankstar.tables.roll_cures import roll_left

WHAT = ("layout",)
HOW = ("units", "force", "couple", "roll")
CURES = ("cure",)
HEADINGS = {WHAT: N_("What it is"), HOW: N_("How it shakes"), CURES: N_("What to do")}
"""What the front page says of the engine, by the topics of the verdict."""
ESTIMATED = N_(
    "Masses or lengths of this engine are estimated, not measured. A number that rests on them is "
    "marked “estimated” and has a range; the section Sources, or `crankstar show`, says where each "
    "of them comes from."
)
SHOWN = 7
"""Lines of the data sheet on the front page."""


def front(subject: Subject) -> str:
    """The first page: title, picture, what it is, how it shakes in newtons, what to do."""
    engine, facts = subject.engine, subject.facts
    beside = ""
    if subject.beside is not None:
        beside = paragraph(_("compared with {engine}", engine=subject.beside.name))
    kind = _("Inertia forces of a piston engine")
    drawing = figure(view(engine, FRONT_PAGE), _("The engine at θ = 0."))
    parts = [_what(subject, facts)]
    for topics in (HOW, CURES):
        lines = [fact.sentence for fact in facts if fact.about in topics]
        lines += _rolling(subject) if topics is CURES else []
        parts.append(_part(_(HEADINGS[topics]), lines))
    if subject.rests_on:
        parts.append(_part(_("What it rests on"), subject.rests_on[:MOST_TRUSTED]))
    return (
        f'<header><p class="kind">{text(kind)}</p><h1>{text(engine.name)}</h1>{beside}</header>'
        f'{_estimated(subject)}<div class="front"><div class="figures views">{drawing}</div>'
        f"{''.join(parts)}</div>"
    )


def _estimated(subject: Subject) -> str:
    """That the numbers of the report rest on estimates, in plain words."""
    if not estimated_paths(subject.engine):
        return ""
    return paragraph(_(ESTIMATED), "doubt")


def _rolling(subject: Subject) -> Sequence[str]:
    """The rolling moment that the recommended weights and shafts leave, and what removes it."""
    own = subject.engine
    fitted = recommended(own)

    def line(each: Subject) -> list[str]:
        if fitted is None:
            return [roll_left(each.engine, speed=each.at)]
        like = recommended_like(fitted, own, each.engine)
        left = roll_left(like.after, speed=each.at, before=each.engine)
        return [passage((fitted.description, left))] if left else []

    return [*filter(None, subject.lines(line))]


def _part(title: str, lines: Sequence[str]) -> str:
    return f'<div class="plain"><h2>{text(title)}</h2>{"".join(map(paragraph, lines))}</div>'


def _what(subject: Subject, facts: Sequence[Fact]) -> str:
    """The first lines of the data sheet as a sentence, and the layout, which says how it fires."""
    shown = [
        f"{datum.label}: {datum.value}"
        for datum in data(subject)
        if datum.value and "firing_order" not in datum.keys
    ][:SHOWN]
    lines = ["; ".join(shown) + "."]
    lines += [fact.sentence for fact in facts if fact.about in WHAT]
    return _part(_(HEADINGS[WHAT]), lines)


def contents(entries: Sequence[tuple[str, str, str]]) -> str:
    """The contents: number, title and address of each section; a PDF has its pages as well."""
    rows = "".join(
        f'<li><a href="#{address}"><span class="number">{number}</span> {title}</a>'
        f'<span class="page" data-of="{address}"></span></li>'
        for number, address, title in entries
    )
    heading = _("Contents")
    return f'<nav class="contents"><h2>{text(heading)}</h2><ol>{rows}</ol></nav>'
