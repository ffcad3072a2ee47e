"""Counterweights and balance shafts: their tables, and the spectra before and after."""

from __future__ import annotations

from crankstar.engine.copies import with_values
from crankstar.language.messages import _
from crankstar.remedy import fitting
from crankstar.report.gallery import Gallery
from crankstar.report.markup import figures, parts_html, section
from crankstar.report.subject import Subject
from crankstar.tables.html import paragraph
from crankstar.tables.remedies import Job, parts


def remedies(subject: Subject, gallery: Gallery) -> str:
    """The recommended counterweights and balance shafts, and the remaining unbalance."""
    fitted = fitting.recommended(subject.engine)
    title = _("Remedies")
    if fitted is None:
        none = _("Counterweights and balance shafts cannot reduce the first two orders.")
        return section(title, paragraph(none), name="remedies")
    job = Job(subject.engine, fitted.after, fitted.factor, speed=subject.at)
    spectra = gallery.figure(
        "spectrum",
        _("The spectra before and after, on common axes."),
        "wide low",
        beside=with_values(fitted.after, name=_("with weights and shafts")),
        speed=subject.at,
    )
    tables = parts_html(parts(job))
    body = paragraph(fitted.description) + tables + figures([spectra])
    return section(title, body, name="remedies")
