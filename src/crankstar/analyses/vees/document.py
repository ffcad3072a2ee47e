"""V engines that fire evenly, crank and bank together."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from crankstar.analyses.vees.question import Question
from crankstar.analysis.document import Column, Document, Remarks, Table, Value, for_each
from crankstar.firing.vees import ORDERS, Vee, interval_deg
from crankstar.language.messages import _, _n
from crankstar.language.numbers import number
from crankstar.options.readers import USUAL_TOP

FORCE, COUPLE = "m*r*w^2*A_k", "m*r*w^2*A_k*a"
SPLIT_EXAMPLES = (60.0, 90.0, 72.0)
"""Bank angles (degrees) of which two that need split pins are given as examples."""


def document(_source: None, result: Sequence[Vee], question: Question) -> Document:
    """The solutions, best first: bank angle, pin split, throws, and their balance.

    Of readers the first ones, of machines all.
    """
    solutions, limit = result, question.top or USUAL_TOP
    only_multiples = question.bank is None and question.greatest_split is None
    if not solutions:
        return Document("", (Remarks((_("No V engine of this kind fires evenly."),)),))
    vee = solutions[0]
    step = interval_deg(cylinders=vee.cylinders, cycle=vee.cycle)
    rows = tuple(_row(index, vee) for index, vee in enumerate(solutions, 1))
    whole = Table("", _columns(), rows, key="solutions")
    first = replace(whole, rows=rows[:limit])
    title = _(
        "V{cylinders}, {cycle}, firing every {interval} deg",
        cylinders=vee.cylinders,
        cycle=_(vee.cycle),
        interval=number(step),
    )
    facts = {"cylinders": vee.cylinders, "cycle": vee.cycle}
    notes = Remarks(tuple(_notes(solutions, limit, only_multiples)))
    return Document(title, (*for_each(first, whole), notes), facts)


def _columns() -> tuple[Column, ...]:
    out = [
        Column(_("row"), key="row", label=True),
        Column(_("bank angle"), "deg", key="bank_angle_deg"),
        Column(_("pin split"), "deg", key="pin_split_deg"),
        Column(_("throws"), "deg", kind="list", wraps=True, digits=4),
        Column("", key="stars_deg", machine=True),
        Column(_("stars"), key="stars"),
        Column(_("cranks"), key="cranks"),
    ]
    for name, unit in (("force", FORCE), ("couple", COUPLE)):
        for order in ORDERS:
            key = f"{name}/order_{order}"
            out += [
                Column("", unit, key=f"{key}/forward", machine=True),
                Column("", unit, key=f"{key}/backward", machine=True),
            ]
            if (name, order) == ("couple", 1):
                out += [Column(_("couple 1 with crank")), Column(_("couple 1 against"))]
            elif name == "force":
                out.append(Column(_("force {order}", order=order)))
            else:
                out.append(Column(_("couple {order}", order=order)))
    out.append(Column("", key="counterweights_suffice", machine=True))
    out.append(Column(_("left"), key="left"))
    return tuple(out)


def _row(index: int, vee: Vee) -> tuple[Value, ...]:
    stars = tuple(tuple(float(angle) for angle in star) for star in vee.stars)
    angles = (vee.bank_angle_deg, vee.pin_split_deg)
    cells: list[Value] = [index, *angles, stars[0], stars, len(stars), vee.count]
    for name, vectors in (("force", vee.force), ("couple", vee.couple)):
        for order, vector in zip(ORDERS, vectors, strict=True):
            ways = (float(vector.forward), float(vector.backward))
            cells += ways
            cells += ways if (name, order) == ("couple", 1) else (float(vector.greatest),)
    return (*cells, vee.counterweights_suffice, float(vee.left))


def _notes(solutions: Sequence[Vee], limit: int, only_multiples: bool) -> list[str]:
    cranks, stars = sum(vee.count for vee in solutions), sum(len(vee.stars) for vee in solutions)
    out = [
        _n(
            "{cranks} cranks; {stars} not counting mirror images and reversals, with {count} "
            "balance.",
            "{cranks} cranks; {stars} not counting mirror images and reversals, with {count} "
            "different balances.",
            len(solutions),
            cranks=cranks,
            stars=stars,
            count=len(solutions),
        )
    ]
    if limit < len(solutions):
        out.append(
            _(
                "{shown} of {count} are shown; --top shows more, --csv all.",
                shown=limit,
                count=len(solutions),
            )
        )
    if only_multiples:
        out.append(_split_pins(solutions[0]))
    return [
        *out,
        _(
            "Throws: pin angles of the first bank, clockwise from pin 1, of one crank with this "
            "balance. The pins of the second bank are turned clockwise by the split."
        ),
        _(
            "Greatest values over a turn: forces in m r ω² Aₖ, couples about the middle in m r "
            "ω² Aₖ a, with the rods of a pin in one plane."
        ),
        _(
            "Left: the part of all orders that counterweights cannot remove, in m r ω², at a rod "
            "ratio of 4; couples are divided by a."
        ),
        _("--row N -o FILE writes an engine file; --star N chooses among the stars of a row."),
    ]


def _split_pins(vee: Vee) -> str:
    """How other bank angles are asked for than the multiples of the firing interval."""
    step = interval_deg(cylinders=vee.cylinders, cycle=vee.cycle)
    others = [angle for angle in SPLIT_EXAMPLES if abs(angle / step - round(angle / step)) > 1e-9]
    return _(
        "Only bank angles that are multiples of {interval} deg were tried; others fire evenly with "
        'split pins: --bank "{example}".',
        interval=number(step),
        example=", ".join(f"{angle:g} deg" for angle in others[:2]),
    )
