"""Loads on the main bearings and the bending moment of the crankshaft."""

from __future__ import annotations

from typing import Any

from crankstar.analyses.bearings.document import MODELS, peaks
from crankstar.analysis.document import Remarks, Table
from crankstar.charts.canvas import Canvas
from crankstar.dynamics.bearings import BearingError, BearingLoads, bearing_loads
from crankstar.language.messages import N_, _
from crankstar.mechanics.gas import cycle
from crankstar.mechanics.operating_points import GasError
from crankstar.report.gallery import Gallery
from crankstar.report.markup import figures, parts_html, section
from crankstar.report.subject import Subject
from crankstar.tables.html import paragraph
from crankstar.tables.torque import load_sentence

FEW = 5
"""Main bearings up to which the short report draws them all."""
GREATEST = 3
"""How many of more bearings the short report draws, those with the greatest loads."""
LONG_TABLE = 12
"""Rows above which the table of the greatest loads is in the full report only."""
REST = N_(
    "{count} of {all} main bearings are drawn, those with the greatest loads; `crankstar report "
    "--full` draws them all, with their table."
)
WIDE = Canvas(width=325.0)
"""Polar diagrams of three bearings abreast are as wide as a page of A4."""
BESIDE = Canvas(width=400.0, stretch=0.44)
"""Bending moments in low panels, as wide as a page."""


def bearings(subject: Subject, gallery: Gallery) -> str:
    """Polar diagrams of the main bearings, the bending moment, and the greatest loads.

    A short report of many bearings draws the greatest loads, and says where the others are.
    """
    loads = bearing_loads(subject.engine, speed=subject.at)
    one = len({bearing.shaft for bearing in loads.bearings}) == 1
    whole = subject.full or (one and len(loads.bearings) <= FEW)
    notes = [_(MODELS[loads.model])]
    drawn: list[str] = []
    if loads.bearings:
        caption = _("The load on each main bearing over a turn, from inertia and weights.")
        options = {"canvas": WIDE, "speed": subject.at}
        if not whole:
            caption = _(
                "The greatest loads on main bearings over a turn, from inertia and weights."
            )
            options["most"] = GREATEST
            notes.append(_(REST, count=GREATEST, all=len(loads.bearings)))
        drawn.append(gallery.figure("bearing-loads", caption, "wide low", **options))
        drawn += _with_gas(subject, gallery, options)
    if loads.bearings and whole:
        caption = _("The bending moment along the crankshaft, with counterweights and without.")
        model = None if subject.full else "determinate"
        options = {"canvas": BESIDE, "speed": subject.at, "model": model}
        drawn.append(gallery.figure("bending", caption, "wide low", **options))
    lead = "".join(paragraph(note, "note") for note in notes)
    table = subject.full or (not whole and len(loads.bearings) <= LONG_TABLE)
    tables = parts_html(subject.parts(_peaks)) if table else ""
    return section(_("Bearings"), f"{lead}<div>{tables}</div>{figures(drawn)}", name="bearings")


def _with_gas(subject: Subject, gallery: Gallery, options: dict[str, Any]) -> list[str]:
    """The same loads with the gas of the report's cycle, where it can be computed."""
    if _loads_with_gas(subject) is None:
        return []
    load = load_sentence(cycle(subject.engine, speed=subject.at))
    caption = _("The load on each main bearing over a cycle, with gas.")
    if "most" in options:
        caption = _("The greatest loads on main bearings over a cycle, with gas.")
    return [gallery.figure("bearing-loads", f"{caption} {load}", "wide low", **options, gas=True)]


def _loads_with_gas(subject: Subject) -> BearingLoads | None:
    """None where the engine file does not say what the gas does, or lacks masses or a speed."""
    if subject.engine.gas is None:
        return None
    try:
        found = cycle(subject.engine, speed=subject.at)
        return bearing_loads(subject.engine, speed=subject.at, cycle=found)
    except (BearingError, GasError):
        return None


def _peaks(subject: Subject) -> list[Table | Remarks]:
    """The greatest loads, with gas as well where it is known."""
    out: list[Table | Remarks] = [
        peaks(subject.engine, bearing_loads(subject.engine, speed=subject.at))
    ]
    gas = _loads_with_gas(subject)
    return out if gas is None else [*out, peaks(subject.engine, gas, gas=True)]
