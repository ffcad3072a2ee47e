"""Counterweights and balance shafts: their tables, and the spectra before and after."""

from __future__ import annotations

from functools import partial

from crankstar.analysis.document import Remarks, Table
from crankstar.engine.copies import with_values
from crankstar.engine.engine import Engine
from crankstar.language.messages import N_, _
from crankstar.page.figures import fitted_spread
from crankstar.remedy import fitting
from crankstar.report.gallery import Gallery
from crankstar.report.markup import figures, parts_html, section
from crankstar.report.subject import Subject
from crankstar.tables.html import paragraph
from crankstar.tables.remedies import Job, parts

LONG_TABLE = 12
"""Rows above which a table of weights is in the full report only."""
ELSEWHERE = N_("{table}: a table in the report with --full.")


def remedies(subject: Subject, gallery: Gallery) -> str:
    """The recommended counterweights and balance shafts, and the remaining unbalance."""
    fitted = fitting.recommended(subject.engine)
    title = _("Remedies")
    if fitted is None:
        none = _("Counterweights and balance shafts cannot reduce the first two orders.")
        return section(title, paragraph(none), name="remedies")
    after = with_values(fitted.after, name=_("with weights and shafts"))
    spectra = gallery.figure(
        "spectrum",
        _("The spectra before and after, on common axes."),
        "wide",
        beside=after,
        spreads=[fitted_spread(subject.spreads[0], fitted, after)],
        speed=subject.at,
    )
    shown = subject.parts(partial(_tables, subject.engine, fitted))
    long = [part for part in shown if isinstance(part, Table) and len(part.rows) > LONG_TABLE]
    if not subject.full:
        shown = [part for part in shown if part not in long]
    tables = parts_html(shown)
    if long and not subject.full:
        tables += "".join(paragraph(_(ELSEWHERE, table=part.title), "note") for part in long)
    lead = paragraph(fitted.description)
    drawn = [spectra]
    if fitted.ratios and subject.full:
        caption = _("The balance shafts in their places, from the front and from the side.")
        drawn.append(gallery.figure("balance-shafts", caption, of=fitted.after))
    body = lead + tables + figures(drawn)
    return section(title, body, name="remedies")


def _tables(engine: Engine, fitted: fitting.Fitted, subject: Subject) -> list[Table | Remarks]:
    """The tables of the weights and shafts recommended for an engine, sized for the subject."""
    own = fitting.recommended_like(fitted, engine, subject.engine)
    return list(parts(Job(subject.engine, own.after, own.factor, speed=subject.at)))
