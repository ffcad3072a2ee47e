"""Torsional vibration: modes, critical speeds, what the crankshaft does over the speed."""

from __future__ import annotations

from crankstar.dynamics.torsion_analysis import torsion as analysis
from crankstar.language.messages import N_, _
from crankstar.report.gallery import Gallery
from crankstar.report.markup import figures, parts_html, section
from crankstar.report.subject import Subject
from crankstar.tables.html import paragraph
from crankstar.tables.table import Remarks, Table
from crankstar.tables.torsion import torsion_document

FIGURES = (
    ("torsion-modes", None, N_("The first torsional modes: turn of each mass, and nodes.")),
    ("campbell", None, N_("Natural frequencies and orders over the speed.")),
    ("torsion-response", "amplitude", N_("Vibration of the free end over the speed.")),
    ("torsion-response", "stress", N_("Shear stress of the most strained shaft over the speed.")),
)
"""The figures of every report, in their order: name, quantity, caption."""
MORE = (
    ("torsion-star", "mode-1", N_("Vectors of the cylinders in the first mode, by order.")),
    ("torsion-star", "mode-2", N_("Vectors of the cylinders in the second mode, by order.")),
)
"""Those of the full report."""


def torsion(subject: Subject, gallery: Gallery) -> str:
    """Empty where the engine file has no table [torsion]."""
    if subject.engine.torsion is None:
        return ""
    lead = "".join(paragraph(fact.sentence) for fact in subject.facts if fact.about == "torsion")
    drawn = [
        gallery.figure(name, _(caption), **({} if quantity is None else {"quantity": quantity}))
        for name, quantity, caption in (*FIGURES, *(MORE if subject.full else ()))
        if _is_there(subject, name, quantity)
    ]
    tables = parts_html(subject.parts(_tables))
    return section(_("Torsional vibration"), lead + tables + figures(drawn), name="torsion")


def _is_there(subject: Subject, name: str, quantity: str | None) -> bool:
    """Whether a figure has something to show, rather than what is missing."""
    found = analysis(subject.engine, speed=subject.at)
    if name == "torsion-response":
        known = any(each.diameter is not None for each in found.chain.sections)
        return found.response is not None and (quantity != "stress" or known)
    if name == "torsion-star":
        return len(found.modes) >= (2 if quantity == "mode-2" else 1)
    return bool(found.modes) and (name != "campbell" or bool(found.speeds.size))


def _tables(subject: Subject) -> list[Table | Remarks]:
    document = torsion_document(subject.engine, analysis(subject.engine, speed=subject.at))
    first, *parts = document.parts  # the heading of the engine stands on the first page
    return parts if isinstance(first, Remarks) else [first, *parts]
