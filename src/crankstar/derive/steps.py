"""Engine -> Derivation: one order of the force or the couple, from one cylinder to the resultant.

The way of the textbooks: each cylinder's cosine, the sum of each bank, its components up and to the
right, their sum; the same again by crank pin; the rotating masses; the resultant as two
counter-rotating vectors and their ellipse; the real force. Every formula on the way can be
evaluated and must come to the Balance of the parts it names.
"""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from math import isfinite
from numbers import Rational, Real

from crankstar.derive import positions
from crankstar.derive.algebra import cyclotomic, enclosure
from crankstar.derive.algebra.formula import Formula, Symbol, cosine, product, summed
from crankstar.derive.banks import by_bank, by_pin
from crankstar.derive.bodies import Body, armed, bodies
from crankstar.derive.chapters import Derivation
from crankstar.derive.real import real
from crankstar.derive.records import (
    GREATEST_ORDER,
    DerivationError,
    Line,
    Quantity,
    Step,
    heading,
    unit_formula,
    unit_symbol,
)
from crankstar.derive.resultant import resultant
from crankstar.derive.task import Task, arm_of, sides
from crankstar.engine.engine import Engine
from crankstar.language.messages import _
from crankstar.language.quoting import given as quoted
from crankstar.language.quoting import one_line
from crankstar.mechanics.excitation import Reference


def derivation(
    engine: Engine,
    order: float | Fraction,
    quantity: Quantity = "force",
    *,
    reference: Reference | None = None,
    speed: float | None = None,
    power: int = 7,
) -> Derivation:
    """The derivation of one order of the force or the couple of an engine, step by step.

    `order` is a crank order above 0 and up to 24; the couple is taken about the middle of the
    cylinders' span unless a `reference` is given; numbers in newtons are for `speed` (rad/s), else
    for the speed of the engine file; the series of A_k goes to lambda**power. Raises
    DerivationError.

    >>> from crankstar.files.catalog import load
    >>> from crankstar.derive.algebra.typeset import text
    >>> last = derivation(load("v8-flat-plane"), 2).steps[-2].lines
    >>> text(last[0].chain[-1]), text(last[1].chain[-1])
    ('0', '−4√2 cos 2θ')
    """
    wanted = _order(order)
    if quantity not in ("force", "couple"):
        raise DerivationError(
            _(
                "There is no derivation of {quantity}; the quantity can be force or couple.",
                quantity=repr(quantity),
            )
        )
    if isinstance(power, bool) or power not in range(1, GREATEST_ORDER + 1):
        raise DerivationError(
            _(
                "The power is {power}; give a power of λ from 1 to {greatest}.",
                power=repr(power),
                greatest=GREATEST_ORDER,
            )
        )
    if reference is not None and not all(map(isfinite, reference)):
        raise DerivationError(
            _("The reference point is not finite; give its place in metres or bore pitches.")
        )
    with cyclotomic.precision(cyclotomic.DIGITS):
        try:
            parts = bodies(engine, wanted)
        except enclosure.EnclosureError:
            raise DerivationError(
                _(
                    "Order {order} cannot be derived: the rods come too near to locking for their "
                    "harmonics to be enclosed. `crankstar analyze` gives the order as a number.",
                    order=f"{float(wanted):g}",
                )
            ) from None
        arms = positions.arms(engine, reference)
        moving = parts.moving
        if quantity == "couple":
            moving = tuple(armed(body, arm_of(arms, body)) for body in moving)
        speed = engine.speed if speed is None else speed
        task = Task(engine, wanted, quantity, parts, moving, arms, speed, power)
        return _derived(task)


def _derived(task: Task) -> Derivation:
    parts, arms = task.bodies, task.arms
    symbols = {symbol.name: float(value) for symbol, value in arms.values.items()}
    symbols |= {symbol.name: _harmonic(*harmonic) for symbol, harmonic in parts.values.items()}
    forward, backward = task.vectors
    return Derivation(
        engine=task.engine.name,
        title=heading(task.order, task.quantity),
        order=task.order,
        quantity=task.quantity,
        harmonic=parts.harmonic,
        scale=_harmonic(parts.harmonic, parts.rod_ratio),
        symbols=symbols,
        steps=(_law(task), *_sums(task), resultant(task, symbols), real(task)),
        up=task.push.up,
        right=task.push.right,
        forward=forward,
        backward=backward,
        why=parts.why,
        meanings=positions.meanings(task.engine, arms) | theta(task.engine, task.moving),
    )


def _law(task: Task) -> Step:
    """The first step: the force of one piston, and the unit of what follows."""
    psi, harmonic = Symbol("psi"), task.bodies.harmonic
    highest = min(max(4, 2 * int(-(-task.order // 2))), 8)
    terms: list[Formula] = [
        product(Symbol("A", str(k)), cosine(product(k, psi))) for k in range(2, highest + 1, 2)
    ]
    force = product(unit_formula(None), summed(cosine(psi), *terms, Symbol("…")))
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
                "The numbers below are therefore not closed forms but decimals with proved "
                "bounds, every digit certain. A sum that cannot be distinguished from zero is "
                "left out; it is not proved to be zero."
            ),
        ]
    harmonic = task.bodies.harmonic
    unit = "m r ω²" if harmonic is None or harmonic == 1 else f"m r ω² A_{harmonic}"
    counted = _(
        "The following lines are of order {order}, counted in the unit {unit}; θ is the crank "
        "angle.",
        order=task.order,
        unit=unit,
    )
    if task.quantity == "couple":
        counted = _(
            "The following lines are of order {order}, counted in the unit {unit}, with lengths "
            "along the crankshaft as letters; θ is the crank angle.",
            order=task.order,
            unit=unit,
        )
    return [*words, counted]


def _sums(task: Task) -> list[Step]:
    """The steps between the law and the resultant."""
    if not task.moving:
        words = _(
            "No part of the engine exerts a force of this order. Pistons on a centred crank have "
            "the harmonics 1, 2, 4, 6, ... of the speed of their crankshaft, and rotating masses "
            "have the first only."
        )
        return [Step(_("No such harmonic"), (words,))]
    if task.quantity == "couple" and not any(arm_of(task.arms, body) for body in task.moving):
        words = _(
            "All forces of this order act in the reference plane and have no arm, so there is no "
            "couple of this order."
        )
        return [Step(_("No arms"), (words,))]
    pistons = [body for body in task.moving if not body.turning]
    rotors = [body for body in task.moving if body.turning]
    steps = [*by_bank(task, pistons), *by_pin(task, pistons)] if pistons else []
    if rotors:
        steps.append(_turning(task, rotors))
    if rotors and pistons:
        lines = sides(task, "all", task.moving, _("all parts"))
        steps.append(Step(_("Pistons and rotating masses together"), (), tuple(lines)))
    return steps


def _turning(task: Task, rotors: list[Body]) -> Step:
    """The pushes of rotating masses: throws, big ends, weights."""
    lines: list[Line] = []
    for body in rotors:
        values = {"place": body.place, "shaft": body.shaft}
        if body.kind == "throw":
            label = _("throw {place} of {shaft}", **values)
        elif body.kind == "weight":
            label = _("weight {place} of {shaft}", **values)
        else:
            label = _("big end of cylinder {number}", number=body.cylinder)
        name = f"{body.kind} {body.cylinder or body.place} of {body.shaft}"
        lines += sides(task, name, [body], label, arm=task.arm(body))
    lines += sides(task, "turning", rotors, _("all rotating masses"))
    words = _(
        "A rotating mass exerts a force of constant size, outwards along its crank, which turns "
        "with the shaft: mass times radius times the square of the speed of the shaft. Mass "
        "times radius is in units of m r, the speed in units of ω."
    )
    return Step(_("Rotating masses"), (words,), tuple(lines))


def theta(engine: Engine, moving: Iterable[Body]) -> dict[str, str]:
    """What theta is measured from, where that is not the dead centre of the first cylinder."""
    number = engine.first.number
    first = next((body for body in moving if body.cylinder == number and not body.turning), None)
    if first is None or not first.dead_centre:
        return {}
    meaning = _("crank angle, from the position in the engine file, in the direction of rotation")
    return {"theta": meaning}


def _order(order: float | Fraction) -> Fraction:
    refused = DerivationError(
        _(
            "The order is {order}; give a crank order above 0 and up to {greatest}, such as 2 or "
            "29/31.",
            order=one_line(str(order), longest=40) if isinstance(order, Real) else quoted(order),
            greatest=GREATEST_ORDER,
        )
    )
    if not isinstance(order, Real) or isinstance(order, bool):
        raise refused
    try:
        given = Fraction(order if isinstance(order, Rational) else float(order))
    except (ValueError, OverflowError):
        raise refused from None
    wanted = given.limit_denominator(1000)
    if not 0 < wanted <= GREATEST_ORDER or abs(wanted - given) > Fraction(1, 10**9):
        raise refused
    return wanted


def _harmonic(order: int | None, rod_ratio: Fraction | None) -> float:
    if order is None or order == 1 or rod_ratio is None:
        return 1.0
    return float(enclosure.coefficient(rod_ratio, order).mid())
