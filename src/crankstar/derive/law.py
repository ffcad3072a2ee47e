"""The first step: the force of one piston, and the unit of what follows."""

from __future__ import annotations

from crankstar.derive.algebra.formula import Formula, Power, Symbol, cosine, product, summed
from crankstar.derive.records import Line, Step, unit_formula, unit_symbol
from crankstar.derive.task import Task
from crankstar.language.messages import _


def law(task: Task) -> Step:
    """What one cylinder does."""
    psi, harmonic = Symbol("psi"), task.bodies.harmonic
    terms: list[Formula] = [cosine(psi)]
    highest = max(4, 2 * int(-(-task.order // 2)))
    terms += [
        product(Symbol("A", str(k)), cosine(product(k, psi)))
        for k in range(2, min(highest, 8) + 1, 2)
    ]
    terms.append(Symbol("…"))
    force = product(Symbol("m"), Symbol("r"), Power(Symbol("omega"), 2), summed(*terms))
    lines = (
        Line(Symbol("F"), (force,), label=_("law")),
        Line(unit_symbol(harmonic), (unit_formula(harmonic),), label=_("unit")),
    )
    return Step(_("One cylinder"), tuple(_words(task)), lines)


def _words(task: Task) -> list[str]:
    words = [
        _(
            "A piston pushes on the block along its cylinder with the force F, outwards where it "
            "is positive; ψ is the angle of the crank from the cylinder."
        )
    ]
    if task.bodies.why:
        words += [
            _("The series holds for a plain rod on a centred crank."),
            task.bodies.why,
            _(
                "The numbers below are therefore enclosed decimals, every digit certain, and not "
                "closed forms. A sum that cannot be distinguished from zero is left out; it is not "
                "proved to be zero."
            ),
        ]
    if task.quantity == "couple":
        words.append(
            _(
                "The following lines are of order {order}, counted in the unit below, with lengths "
                "along the crankshaft as letters; θ is the crank angle.",
                order=task.order,
            )
        )
    else:
        words.append(
            _(
                "The following lines are of order {order}, counted in the unit below; θ is the "
                "crank angle.",
                order=task.order,
            )
        )
    return words
