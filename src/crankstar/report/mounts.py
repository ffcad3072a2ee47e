"""The engine on its mounts: where they are, modes, vibration and forces over the speed."""

from __future__ import annotations

from crankstar.dynamics.mount_analysis import mounts as analysis
from crankstar.language.messages import N_, _
from crankstar.report.gallery import Gallery
from crankstar.report.markup import figures, parts_html, section
from crankstar.report.subject import Subject
from crankstar.tables.html import paragraph
from crankstar.tables.mounts import mounts_document
from crankstar.tables.table import Remarks, Table

FIGURES = (
    ("mount-layout", None, N_("The mounts from the front, from above and from the side.")),
    ("mount-modes", None, N_("Natural modes: share of each freedom in the kinetic energy.")),
)
"""The figures of every report, in their order: name, quantity, caption."""
OVER_SPEEDS = (
    ("mount-response", "velocity", N_("Velocity of the point over the speed.")),
    ("mount-response", "force", N_("Force on the ground over the speed.")),
)
"""Those of an engine whose speed is known."""
MORE = (
    ("mount-response", "mounts", N_("Force in each mount over the speed.")),
    ("transmissibility", None, N_("Transmissibility of the mounts over the speed.")),
)
"""Those of the full report."""


def mounts(subject: Subject, gallery: Gallery) -> str:
    """Empty where the engine file has no mounts."""
    if not subject.engine.mounts:
        return ""
    lead = "".join(paragraph(fact.sentence) for fact in subject.facts if fact.about == "mounts")
    turning = analysis(subject.engine, speed=subject.at).over is not None
    wanted = (*FIGURES, *(OVER_SPEEDS if turning else ()))
    drawn = [
        gallery.figure(name, _(caption), **({} if quantity is None else {"quantity": quantity}))
        for name, quantity, caption in (*wanted, *(MORE if subject.full and turning else ()))
    ]
    tables = parts_html(subject.parts(_tables))
    return section(_("On its mounts"), lead + tables + figures(drawn), name="mounts")


def _tables(subject: Subject) -> list[Table | Remarks]:
    document = mounts_document(subject.engine, analysis(subject.engine, speed=subject.at))
    first, *parts = document.parts  # the heading of the engine stands on the first page
    return parts if isinstance(first, Remarks) else [first, *parts]
