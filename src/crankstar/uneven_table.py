"""Uneven angles of a star as a table: what each degree of unevenness brings in couples and costs in free forces."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from rich.console import Group, RenderableType
from rich.text import Text

from crankstar.engine import Engine
from crankstar.search import weighed
from crankstar.search.angles import Term, Uneven, curve, sentence
from crankstar.search.engines import firing_order
from crankstar.search.question import Question
from crankstar.search.stars import SearchError, Star, Stars
from crankstar.search.sums import VectorSum, force
from crankstar.wording import NEGLIGIBLE, number, table, unit_text

SOLVED = 1e-5
"""Share of the greatest length a sum can have that is nothing beside how near the solver comes."""
FREE_FORCE = 1e-3
"""What a free force weighs beside a couple: of angles with equal couples those with the least free force are taken."""


def curve_of(
    question: Question, star: Star, *, deviations_deg: Sequence[float], engine: Engine | None, speed: float | None
) -> tuple[Uneven, ...]:
    """The best angles by the sums of a question, for each deviation of the firing intervals; free forces are told.

    Raises SearchError where the question has no couple, force or torsion.
    """
    named = [(weight, vector) for objective in question.objectives for weight, vector in objective.terms]
    if not named:
        raise SearchError(["--uneven: needs a couple, force or torsion in --minimise, which other angles can make less"])
    terms = [Term(vector, _order(vector), weight) for weight, vector in named]
    for order in sorted({_order(vector) for _, vector in named if vector.name.startswith("M")}):
        told = _force(question.stars, int(order), engine, speed)
        if all(term.sum.name != told.name for term in terms):
            terms.append(Term(told, order, FREE_FORCE))
    return curve(question.stars, star, terms, deviations_deg=[0.0, *deviations_deg])


def _order(vector: VectorSum) -> Fraction:
    return Fraction(vector.name[1:])


def _force(stars: Stars, order: int, engine: Engine | None, speed: float | None) -> VectorSum:
    return force(stars, order) if engine is None else weighed.force_of(engine, stars, order, speed=speed)


def uneven_table(curve_: Sequence[Uneven]) -> RenderableType:
    """A row for each deviation: sums, firing intervals, throw angles; and how far it can be trusted."""
    first = curve_[0]
    order = "-".join(map(str, firing_order(first.stars, first.star)))
    heads = [f"{term.sum.name} [{unit_text(term.sum.unit)}]" if term.sum.unit else term.sum.name for term in first.terms]
    out = table("intervals within", *heads, "firing intervals [deg]", "top dead centre later by [deg]")
    reach = [float(sum(map(abs, term.sum.weights))) * term.sum.scale for term in first.terms]
    for found in curve_:
        lengths = [number(length, SOLVED / NEGLIGIBLE * most, digits=4) for length, most in zip(found.after, reach, strict=True)]
        later = " ".join(number(round(by, 2), 1e3, digits=3) for by in found.later_deg)
        intervals = " ".join(number(round(interval, 2), digits=5) for interval in found.intervals_deg)
        out.add_row(f"{number(found.deviation_deg, digits=4)} deg", *lengths, intervals, later)
    lines = [Text(f"Uneven angles: fires {order}", style="bold"), Text(), out, Text(), Text(_upper(sentence(curve_[-1])) + ".")]
    lines.append(Text("Intervals in firing order; top dead centres of cylinders 1, 2, 3 ... beside those of the even star."))
    lines.append(Text("Of angles with equal couples, those with the least free force."))
    return Group(*lines)


def _upper(text: str) -> str:
    return text[:1].upper() + text[1:]
