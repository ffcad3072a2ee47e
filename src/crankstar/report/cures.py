"""What weights and balance shafts do to the engine: before and after."""

from __future__ import annotations

from rich.console import Group

from crankstar import fitting
from crankstar.report.gallery import Gallery
from crankstar.report.markup import figures, of, paragraph, section
from crankstar.report.matter import Matter
from crankstar.workshop import Job, balance_card


def remedies(matter: Matter, gallery: Gallery) -> str:
    """Counterweights where something turns with a crankshaft, the balance shafts that are needed then, and what they leave."""
    found = fitting.recommended(matter.engine)
    if found is None:
        return section(
            "Remedies", paragraph("Nothing of the first and second order is left that could be taken away."), name="remedies"
        )
    card = balance_card(Job(matter.engine, found.after, found.factor, speed=matter.at))
    rest = Group(*card.renderables[1:]) if isinstance(card, Group) else card
    after = found.after.model_copy(update={"name": "fitted"})  # the line above the figure says with what
    drawn = gallery.figure("spectrum", "The spectra before and after, on common axes.", "wide", beside=after, speed=matter.at)
    return section("Remedies", paragraph(found.told) + figures([drawn]) + of(rest), name="remedies")
