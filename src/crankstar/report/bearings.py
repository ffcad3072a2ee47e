"""Loads on the main bearings and the bending moment of the crankshaft."""

from __future__ import annotations

from crankstar.charts.canvas import Canvas
from crankstar.dynamics.bearings import BearingLoads, bearing_loads
from crankstar.language.messages import _
from crankstar.report.gallery import Gallery
from crankstar.report.markup import figures, parts_html, section
from crankstar.report.subject import Subject
from crankstar.tables.bearings import MODELS, peaks
from crankstar.tables.html import paragraph
from crankstar.tables.table import Remarks, Table

MOST = 5
"""Main bearings up to which the short report has room for them."""
WIDE = Canvas(width=325.0)
"""Polar diagrams of three bearings abreast are as wide as a page of A4."""
BESIDE = Canvas(width=400.0, stretch=0.62)
"""Bending moments in low panels, as wide as a page."""


def bearings(subject: Subject, gallery: Gallery) -> str:
    """Polar diagrams of the main bearings, the bending moment, and the greatest loads."""
    engine = subject.engine
    loads = bearing_loads(engine, speed=subject.at)
    if not (subject.full or _few(loads)):
        return ""
    drawn: list[str] = []
    if loads.bearings:
        at = subject.at
        caption = _("The load on each main bearing over a turn, from inertia and weights.")
        drawn.append(gallery.figure("bearing-loads", caption, "wide low", canvas=WIDE, speed=at))
        caption = _("The bending moment along the crankshaft, with counterweights and without.")
        model = None if subject.full else "determinate"
        options = {"canvas": BESIDE, "speed": at, "model": model}
        drawn.append(gallery.figure("bending", caption, "wide low", **options))
    lead = paragraph(_(MODELS[loads.model]), "note")
    tables = parts_html(subject.parts(_peaks))
    return section(_("Bearings"), lead + figures(drawn) + tables, name="bearings")


def _peaks(subject: Subject) -> list[Table | Remarks]:
    """The greatest loads, which in the short report stand above the diagrams."""
    loads = bearing_loads(subject.engine, speed=subject.at)
    return [peaks(subject.engine, loads)] if subject.full else []


def _few(loads: BearingLoads) -> bool:
    """Whether the short report has room for drawings: one shaft in few bearings."""
    one = len({bearing.shaft for bearing in loads.bearings}) == 1
    return one and len(loads.bearings) <= MOST
