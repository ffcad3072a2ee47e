"""What weights and balance shafts do to the engine: before and after."""

from __future__ import annotations

from rich.console import Group

from crankstar import fitting
from crankstar.engine import Engine
from crankstar.remedy import RemedyError, needs, without_counterweights
from crankstar.report.gallery import Gallery
from crankstar.report.markup import figures, of, paragraph, section
from crankstar.report.matter import Matter
from crankstar.wording import number
from crankstar.workshop import Job, balance_card

HALF = 0.5
"""The balance factor where the engine file gives none."""


def remedies(matter: Matter, gallery: Gallery) -> str:
    """Counterweights where the first order turns with the crank, the balance shafts that are needed then, and what they leave."""
    engine = matter.engine
    given = matter.tree.get("balance_factor")
    factor = float(given) if isinstance(given, int | float) else HALF
    job, done = _fitted(engine, factor)
    if not done:
        return section(
            "Remedies", paragraph("Nothing of the first and second order is left that could be taken away."), name="remedies"
        )
    job = job._replace(speed=matter.at)
    card = balance_card(job)
    rest = Group(*card.renderables[1:]) if isinstance(card, Group) else card
    after = job.after.model_copy(update={"name": "with " + " and ".join(done)})
    drawn = gallery.figure("spectrum", "The spectra before and after, on common axes.", "wide", beside=after, speed=matter.at)
    told = paragraph(f"Fitted with {' and '.join(done)}.")
    return section("Remedies", told + figures([drawn]) + of(rest), name="remedies")


def _fitted(engine: Engine, factor: float) -> tuple[Job, list[str]]:
    """The engine with what takes most away, and what that is in words; nothing where nothing is left."""
    done: list[str] = []
    after = engine
    if not engine.shafts[0].weights and any(need.ratio == 1 for need in needs(without_counterweights(engine), highest=1)):
        try:
            after = fitting.by_factor(engine, factor=factor, weights="ends")
            done.append(f"counterweights on the end webs (balance factor {number(factor)})")
        except RemedyError:
            after = engine
    try:
        after = fitting.with_shafts(after, ratios="needed", places=fitting.ShaftPlaces())
        done.append("the balance shafts that it needs")
    except RemedyError:
        pass  # it needs none
    return Job(engine, after, factor), done
