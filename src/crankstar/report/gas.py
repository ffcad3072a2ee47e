"""Gas and torque: the cycle, the torque over it, what the block feels, and how evenly it runs."""

from __future__ import annotations

from crankstar.analyses.marine.large_engines import large_engine_table, ship_engine
from crankstar.analysis.document import Remarks, Table
from crankstar.dynamics.uneven import UnevenError, driven
from crankstar.language.messages import N_, _
from crankstar.mechanics.gas import cycle
from crankstar.mechanics.operating_points import GasError
from crankstar.report.gallery import Gallery
from crankstar.report.markup import figures, parts_html, section
from crankstar.report.subject import Subject
from crankstar.tables.html import paragraph
from crankstar.tables.torque import torque_document

FIGURES = (
    ("torque", "together", N_("Torque over one cycle: gas, inertia and both together.")),
    ("torque", "orders", N_("Torque by order.")),
    ("pressure", "volume", N_("The indicator diagram: pressure over the volume.")),
    ("torque", "loads", N_("Torque over one cycle, motored and under load.")),
)
"""The figures of every report, in their order: name, quantity, caption."""
MORE = (("torque", "cylinders", N_("Gas torque of each cylinder over one cycle.")),)
"""Those of the full report."""


def gas(subject: Subject, gallery: Gallery) -> str:
    """Empty where the engine file does not say what the gas does."""
    if subject.engine.gas is None:
        return ""
    try:
        cycle(subject.engine, speed=subject.at)
    except GasError as error:
        return section(_("Gas and torque"), paragraph(str(error), "doubt"), name="gas")
    drawn = [
        gallery.figure(name, _(caption), quantity=quantity, speed=subject.at)
        for name, quantity, caption in (*FIGURES, *(MORE if subject.full else ()))
    ]
    caption = _("Amplitude over the speed: force, couple and rolling moment with gas.")
    drawn.append(gallery.figure("amplitudes", caption))
    lead = paragraph(
        _(
            "The gas turns the crankshaft unevenly and rolls the block, in half orders too; it "
            "makes no force and no couple."
        )
    )
    tables = parts_html(subject.parts(_tables))
    return section(_("Gas and torque"), lead + tables + figures(drawn), name="gas")


def _tables(subject: Subject) -> list[Table | Remarks]:
    found = cycle(subject.engine, speed=subject.at)
    try:
        running = driven(subject.engine, found)
    except UnevenError:
        running = None
    document = torque_document(subject.engine, found, running=running)
    first, *parts = document.parts  # the heading of the engine stands on the first page
    own = parts if isinstance(first, Remarks) else [first, *parts]
    if ship_engine(subject.engine, subject.at) is not None:
        return own  # which has a section of its own
    guide = large_engine_table(subject.engine, found)
    return own if guide is None else [*own, guide]
