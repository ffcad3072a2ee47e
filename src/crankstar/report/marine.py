"""A large two-stroke engine in its ship: external moments and guide-force moments at its speed."""

from __future__ import annotations

from crankstar.analysis.document import Remarks, Table
from crankstar.language.messages import _
from crankstar.report.gallery import Gallery
from crankstar.report.markup import figures, parts_html, section
from crankstar.report.subject import Subject
from crankstar.tables.large_engines import ship_engine, ship_parts


def marine(subject: Subject, gallery: Gallery) -> str:
    """Empty for other engines, and where the file lacks what moments in N m take."""
    if ship_engine(subject.engine, subject.at) is None:
        return ""
    caption = _("Guide-force moments by order: H sways all heads together, X twists the frame.")
    drawn = gallery.figure("guide-moments", caption, speed=subject.at)
    tables = parts_html(subject.parts(_parts))
    return section(_("In the ship"), tables + figures([drawn]), name="marine")


def _parts(subject: Subject) -> list[Table | Remarks]:
    found = ship_engine(subject.engine, subject.at)
    return [] if found is None else ship_parts(found)
