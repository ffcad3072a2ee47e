"""Uneven angles of a star as a table: the gain in couples, the cost in free forces."""

from __future__ import annotations

from collections.abc import Sequence

from crankstar.analysis.document import Column, Document, Table, Value
from crankstar.engine.engine import Engine
from crankstar.language.messages import _
from crankstar.mechanics.remains import SOLVED
from crankstar.stars import engine_stars
from crankstar.stars.angles import Term, Uneven, UnevenAngles, curve, sentence
from crankstar.stars.faults import error
from crankstar.stars.question import Question
from crankstar.stars.star import Star, Stars
from crankstar.stars.sums import VectorSum, force

FREE_FORCE = 1e-3
"""The weight of a free force beside a couple.

Of angles with equal couples those with the least free force are taken.
"""


def curve_of(
    question: Question,
    star: Star,
    *,
    deviations_deg: Sequence[float],
    engine: Engine | None,
    speed: float | None,
) -> tuple[Uneven, ...]:
    """The best angles by the sums of a question, for each deviation of the firing intervals.

    Raises SearchError where the question has no couple, force or torsion.
    """
    named = [
        (weight, vector) for objective in question.objectives for weight, vector in objective.terms
    ]
    if not named:
        raise error("uneven", "needs-sum")
    terms = [Term(vector, vector.order, weight) for weight, vector in named]
    for order in sorted({vector.order for _weight, vector in named if vector.short[0] == "M"}):
        free_force = _force(question.stars, int(order), engine, speed)
        if all(term.sum.name != free_force.name for term in terms):
            terms.append(Term(free_force, order, FREE_FORCE))
    return curve(question.stars, star, terms, deviations_deg=[0.0, *deviations_deg])


def _force(stars: Stars, order: int, engine: Engine | None, speed: float | None) -> VectorSum:
    return (
        force(stars, order)
        if engine is None
        else engine_stars.force_of(engine, stars, order, speed=speed)
    )


def uneven_angles(curve_: Sequence[UnevenAngles]) -> Document:
    """A row for each deviation: sums, firing intervals, throw angles."""
    first = curve_[0]
    stars = [term.sum for term in first.terms if isinstance(term.sum, VectorSum)]
    of_pistons = [one for one in stars if one.parts]
    heads = [
        Column(_("intervals within"), "deg", key="deviation_deg", digits=4, label=True),
        *(
            Column(term.sum.name, term.sum.unit, key=term.sum.name, digits=4)
            for term in first.terms
        ),
        *(Column(each.short, each.unit, key=each.short, digits=4) for each in of_pistons),
        Column(_("firing intervals"), "deg", kind="list", key="intervals_deg", wraps=True),
        Column(_("top dead centre later by"), "deg", kind="list", key="later_deg", wraps=True),
    ]
    # Beside the greatest length a sum can have, less than the solver's accuracy is zero.
    reach = [float(sum(map(abs, term.sum.weights))) * term.sum.scale for term in first.terms]
    rows: list[tuple[Value, ...]] = []
    for uneven in curve_:
        lengths = (
            float(length) if length > SOLVED * most else 0.0
            for length, most in zip(uneven.after, reach, strict=True)
        )
        angles = (
            tuple(round(float(angle), 2) + 0.0 for angle in row)
            for row in (uneven.intervals_deg, uneven.later_deg)
        )
        of_engine = (
            vector.of_engine(uneven.star, uneven.later_deg)
            for vector in of_pistons
            if isinstance(uneven, Uneven)
        )
        rows.append((float(uneven.deviation_deg), *lengths, *of_engine, *angles))
    notes = (
        sentence(curve_[-1]),
        _(
            "Firing intervals are listed in firing order, top dead centres by cylinder, 1, 2, 3, "
            "..., relative to those of the even star."
        ),
        _("Among throw angles with equal couples, those with the least free force are taken."),
    )
    order = "-".join(map(str, first.firing_order))
    table = Table("", tuple(heads), tuple(rows), notes=notes, key="angles")
    return Document(_("Uneven throw angles, firing order {order}", order=order), (table,))
