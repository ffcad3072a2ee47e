"""Engine -> Derivation: one order of the force or the couple, from one cylinder to the resultant.

The way of the textbooks: each cylinder's cosine, the sum of each bank, its parts up and to the right, their sum; the same
again by crank pin; what turns with the shafts; the resultant as two counter-rotating vectors and their ellipse; the real
force. Every formula on the way can be evaluated and must come to the Balance of the parts it names.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from math import isfinite
from numbers import Real
from typing import NamedTuple

from crankstar.derive import cyclotomic, enclosure, positions, wave
from crankstar.derive.bodies import Bodies, Body, armed, bodies
from crankstar.derive.formula import THETA, Degrees, Formula, Power, Product, Sum, Symbol, angle, cosine, number, product, summed
from crankstar.derive.gather import Term, gathered, lag, told_once
from crankstar.derive.pins import by_pin
from crankstar.derive.radical import closed
from crankstar.derive.records import (
    GREATEST_ORDER,
    Derivation,
    DerivationError,
    Line,
    Quantity,
    Step,
    ordinal,
    unit_formula,
    unit_symbol,
)
from crankstar.derive.resultant import real, resultant
from crankstar.derive.task import Task, arm_of, degrees_text, paired, rows, share, sides
from crankstar.derive.wave import Wave, joined
from crankstar.engine import Engine
from crankstar.mechanism import Reference
from crankstar.quantity import one_line


class Row(NamedTuple):
    """Cylinders of one bank on one shaft, which push along one line."""

    name: str
    members: tuple[Body, ...]
    wave: Wave


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

    `order` is a crank order above 0 and up to 24; the couple is taken about the middle of the cylinders' span unless a
    `reference` is given; numbers in newtons are for `speed` (rad/s), else for the speed of the engine file; the series of A_k
    goes to lambda**power. Raises DerivationError.

    >>> from crankstar.catalog import load
    >>> from crankstar.derive.typeset import text
    >>> last = derivation(load("v8-flat-plane"), 2).steps[-2].lines
    >>> text(last[0].chain[-1]), text(last[1].chain[-1])
    ('0', '−4√2 cos 2θ')
    """
    wanted = _order(order)
    if quantity not in ("force", "couple"):
        raise DerivationError(f"there is no derivation of {quantity!r}; the quantity can be force or couple")
    if isinstance(power, bool) or power not in range(1, GREATEST_ORDER + 1):
        raise DerivationError(f"the power is {power!r}; give a power of λ from 1 to {GREATEST_ORDER}")
    if reference is not None and not all(map(isfinite, reference)):
        raise DerivationError("the point of reference is not finite; give its place in metres (or bore pitches)")
    with cyclotomic.precision(cyclotomic.DIGITS):
        found = _bodies(engine, wanted)
        arms = positions.arms(engine, reference)
        moving = found.moving if quantity == "force" else tuple(armed(body, arm_of(arms, body)) for body in found.moving)
        speed = engine.speed if speed is None else speed
        return _derived(Task(engine, wanted, quantity, found, moving, arms, reference, speed, power))


def _derived(task: Task) -> Derivation:
    found, moving = task.found, task.moving
    symbols = _symbols(found, task.arms)
    pistons = [body for body in moving if body.cylinder is not None]
    turning = [body for body in moving if body.cylinder is None]
    steps = [_law(task)]
    if not moving:
        words = "No part of the engine pushes in this order. Pistons on a centred crank have the harmonics 1, 2, 4, 6, ... of the "
        steps.append(
            Step("No such harmonic", (f"{words}turns of their crankshaft, and what turns with a shaft has the first only.",))
        )
    elif task.quantity == "couple" and not task.has_arms:
        words = "All that pushes stands in the reference plane: nothing has an arm, and there is no couple of this order."
        steps.append(Step("No arms", (words,)))
    else:
        if pistons:
            steps += _by_bank(task, pistons)
            steps += by_pin(task, pistons)
        if turning:
            steps += _turning(task, turning, mixed=bool(pistons))
    steps += [resultant(task, rows(moving), symbols), real(task)]
    forward, backward = task.vectors
    return Derivation(
        engine=task.engine.name,
        order=task.order,
        quantity=task.quantity,
        harmonic=found.harmonic,
        scale=_harmonic(found.harmonic, found.rod_ratio),
        symbols=symbols,
        steps=tuple(steps),
        up=task.up,
        right=task.right,
        forward=forward,
        backward=backward,
        why=found.why,
        meanings=positions.meanings(task.engine, task.arms) | _theta(task),
    )


def _theta(task: Task) -> dict[str, str]:
    """What theta is measured from, where that is not the dead centre of the first cylinder."""
    first = next((body for body in task.found.moving if body.cylinder == task.engine.first.number), None)
    if first is None or first.dead_centre is None or first.dead_centre == 0:
        return {}
    return {"theta": "crank angle, from the position in the engine file, in the direction of rotation"}


def _order(order: float | Fraction) -> Fraction:
    seen = one_line(str(order), longest=40)
    told = f"the order is {seen}; give a crank order above 0 and up to {GREATEST_ORDER}, such as 2 or 29/31"
    if not isinstance(order, Real) or isinstance(order, bool):
        raise DerivationError(told)
    try:
        given = Fraction(order)
    except (ValueError, OverflowError):
        raise DerivationError(told) from None
    wanted = given.limit_denominator(1000)
    if not 0 < wanted <= GREATEST_ORDER or abs(wanted - given) > Fraction(1, 10**9):
        raise DerivationError(told)
    return wanted


def _bodies(engine: Engine, order: Fraction) -> Bodies:
    try:
        return bodies(engine, order)
    except ValueError as error:
        raise DerivationError(
            f"order {float(order):g} cannot be derived: {error}; `crankstar analyze` gives it as a number"
        ) from None


def _harmonic(order: int | None, rod_ratio: Fraction | None) -> float:
    if order is None or order == 1 or rod_ratio is None:
        return 1.0
    with cyclotomic.precision(cyclotomic.DIGITS):
        return float(enclosure.coefficient(rod_ratio, order).mid())


def _symbols(found: Bodies, arms: positions.Arms) -> dict[str, float]:
    lengths = {symbol.name: float(value) for symbol, value in arms.values.items()}
    return lengths | {symbol.name: _harmonic(order, ratio) for symbol, (order, ratio) in found.values.items()}


def degrees_of(turn: Fraction) -> Formula:
    """A part of a turn in degrees, as a multiple of pi where degrees are no short decimal."""
    return Degrees(number(360 * turn)) if 1000 % (360 * turn).denominator == 0 else angle(turn)


def shown(turn: Fraction) -> str:
    """A part of a turn in degrees, as text, with a sign that a reader sees."""
    value = float(360 * turn)
    return f"{value:.6g}°".replace("-", "−")


def _law(task: Task) -> Step:
    """What one cylinder does."""
    psi, harmonic = Symbol("psi"), task.found.harmonic
    terms: list[Formula] = [cosine(psi)]
    highest = max(4, 2 * int(-(-task.order // 2)))
    terms += [product(Symbol("A", str(k)), cosine(product(k, psi))) for k in range(2, min(highest, 8) + 1, 2)]
    terms.append(Symbol("…"))
    force = product(Symbol("m"), Symbol("r"), Power(Symbol("omega"), 2), summed(*terms))
    law = (
        "A piston pushes on the block along its cylinder, outwards where the cosine is positive, with the force F; "
        "ψ is the angle of its crank from its cylinder."
    )
    words = [f"{law} (So on a centred crank with a plain rod.)" if task.found.why else law]
    if task.found.why:
        words.append(
            f"Numbers below are enclosed decimals, every digit certain, and not closed forms: {task.found.why}. "
            "What cannot be told from zero is left out; it is not proved to be zero."
        )
    counted = unit_symbol(harmonic)
    arm = ", lengths along the crankshaft as letters" if task.quantity == "couple" else ""
    words.append(f"What follows is the {ordinal(task.order)} order, counted in the unit below{arm}; θ is the crank angle.")
    unit = Line(counted, (unit_formula(harmonic),), label="unit")
    return Step("One cylinder", tuple(words), (Line(Symbol("F"), (force,), label="law"), unit))


def _banks(pistons: Sequence[Body]) -> list[Row]:
    """Cylinders that push along one line, grouped by bank, shaft and bearing."""
    groups: dict[tuple[str, str, float], list[Body]] = {}
    for body in pistons:
        groups.setdefault((body.name, body.shaft, round(body.bearing_deg, 9)), []).append(body)
    several = {name for name, _, _ in groups if sum(1 for key in groups if key[0] == name) > 1}
    out = []
    for (name, _, bearing), members in groups.items():
        title = name if len(groups) > 1 else "all"
        out.append(
            Row(
                f"{title} at {degrees_text(bearing)}" if name in several else title,
                tuple(members),
                joined(b.along or {} for b in members),
            )
        )
    return out


def _by_bank(task: Task, pistons: list[Body]) -> list[Step]:
    """Every cylinder, every bank along its own line, and the banks together."""
    steps = [_each(task, pistons)]
    if any(body.along is None for body in pistons):
        return [*steps, _components(task, pistons)]
    banks = _banks(pistons)
    if any(len(row.members) > 1 for row in banks):
        steps.append(_sums(task, banks))
    steps.append(_resolved(task, [(row.name, row.members, row.wave) for row in banks], pistons))
    return steps


def _each(task: Task, pistons: Sequence[Body]) -> Step:
    """The cosine of each cylinder along its own axis."""
    lines = []
    for body in pistons:
        told = f"cylinder {body.cylinder}" + (f" ({body.name})" if len(task.engine.banks) > 1 else "")
        told += f", at {degrees_text(body.bearing_deg)}"
        if body.dead_centre is not None:
            told += f", top dead centre at θ = {shown(body.dead_centre)}"
        arm = wave.form(arm_of(task.arms, body)) if task.quantity == "couple" else None
        if body.along is None:
            lines += sides(task, str(body.cylinder), body.up, body.right, rows([body]), told, arm)
            continue
        name = Symbol(task.letter, str(body.cylinder))
        lines.append(Line(name, _own(task, body), "signal", rows([body]), body.bearing_deg, told, arm=arm))
    words = ["Each piston's cosine has its crest where the piston is at top dead centre."]
    if task.quantity == "couple":
        words.append(
            "Each is multiplied by its arm, the distance of the cylinder in front of the reference plane; "
            "a couple is shown in the plane in which it acts."
        )
    return Step("Every cylinder along its own axis", tuple(words), tuple(lines))


def _own(task: Task, body: Body) -> tuple[Formula, ...]:
    """A cylinder's cosine as k (theta - its dead centre), then with its phase."""
    along = body.along or {}
    if body.lag is None or body.dead_centre is None:
        return (wave.signal(along, task.order),)
    factors = summed(*(product(_size(amount, body.lag), *key) for key, amount in along.items()))
    chain: list[Formula] = []
    if body.dead_centre:
        turned = summed(THETA, degrees_of(-body.dead_centre))
        inside = turned if task.order == 1 else product(task.order, turned)
        chain.append(product(factors, cosine(inside)))
    chain.append(product(factors, cosine(wave.phased(task.order, angle(lag(body.lag))))))
    return told_once(chain)


def _size(amount: wave.Amount, phase: Fraction) -> Formula:
    """The real number that stands before a cosine whose phase is known."""
    turned = amount.turned(-phase)
    if isinstance(turned, cyclotomic.Number):
        return closed(turned).formula
    raise TypeError("a rational phase belongs to an exact amount")


def _sums(task: Task, banks: Sequence[Row]) -> Step:
    """The cosines of each bank added up."""
    lines: list[Line] = []
    for row in banks:
        name = Symbol(task.letter, f"bank {row.name}" if len(banks) > 1 else "all")
        line_rows, bearing = rows(row.members), row.members[0].bearing_deg
        told = f"{row.name}, at {degrees_text(bearing)}"
        terms = _terms(row.members)
        if terms is None:
            lines.append(Line(name, (wave.signal(row.wave, task.order),), "signal", line_rows, bearing, told))
            continue
        sums = gathered(terms, task.order, moments=task.quantity == "couple")
        lines.append(Line(name, sums.chain, "signal", line_rows, bearing, told, " ".join(sums.notes)))
    many = len(banks) > 1
    title = "Bank by bank" if many else "All cylinders"
    words = (
        "The cylinders of a bank push along one line, so that their cosines simply add."
        if many
        else ("All cylinders push along one line, so that their cosines simply add.")
    )
    return Step(title, (words,), tuple(lines))


def _terms(members: Sequence[Body]) -> list[Term] | None:
    """The cosines of cylinders with rational weights and phases; None where they have not."""
    out: list[Term] = []
    for body in members:
        if body.lag is None or body.along is None or body.cylinder is None:
            return None
        weight: dict[wave.Key, Fraction] = {}
        for key, amount in body.along.items():
            turned = amount.turned(-body.lag)
            size = turned.rational if isinstance(turned, cyclotomic.Number) else None
            if size is None:
                return None
            weight[key] = size
        out.append(Term(body.cylinder, weight, body.lag))
    return out


def _resolved(task: Task, groups: Sequence[tuple[str, Sequence[Body], Wave]], pistons: Sequence[Body]) -> Step:
    """Forces along several lines, each resolved into up and right, and added."""
    lines = []
    for name, letter in (("up", "up"), ("right", "right")):
        parts: list[tuple[Formula, Wave]] = []
        for _, members, own in groups:
            parts.append((share(members[0], up=name == "up"), own))
        whole = joined(getattr(body, name) for body in pistons)
        raw = summed(*(product(factor, wave.signal(own, task.order)) for factor, own in parts))
        chain = told_once([raw, *paired(parts, task.order), wave.signal(whole, task.order)])
        note = "Added as vectors, each of its length and at its phase." if len(chain) == 2 and _several(chain[0]) else ""
        bearing = 0.0 if name == "up" else 90.0
        lines.append(Line(Symbol(task.letter, letter), chain, "signal", rows(pistons), bearing, name, note))
    angles = sorted({round(members[0].bearing_deg, 9) for _, members, _ in groups})
    words = ["A force along a cylinder at bearing β has the part cos β upwards and sin β to the right, seen from the front."]
    if len(angles) == 2 and angles[0] == -angles[1]:
        words.append(f"Here β = ±{angles[1]:g}°, half the bank angle.")
    return Step("Upwards and to the right", tuple(words), tuple(lines))


def _several(formula: Formula) -> bool:
    """Whether cosines of different phases are added."""
    if not isinstance(formula, Sum):
        return False
    return len({term.factors[-1] if isinstance(term, Product) else term for term in formula.terms}) > 1


def _components(task: Task, pistons: Sequence[Body]) -> Step:
    """Cylinders with rods that swing knuckle pins about: their parts up and right are simply added."""
    up, right = joined(body.up for body in pistons), joined(body.right for body in pistons)
    return Step(
        "All cylinders", ("The parts up and to the right are added.",), tuple(sides(task, "all", up, right, rows(pistons), "all"))
    )


def _turning(task: Task, turning: Sequence[Body], *, mixed: bool) -> list[Step]:
    """What turns with the shafts: crank pins, big ends, weights."""
    lines: list[Line] = []
    for body in turning:
        told = f"{body.name} of {body.shaft}"
        arm = wave.form(arm_of(task.arms, body)) if task.quantity == "couple" else None
        lines += sides(task, f"{body.name} of {body.shaft}", body.up, body.right, rows([body]), told, arm)
    up, right = joined(b.up for b in turning), joined(b.right for b in turning)
    lines += sides(task, "turning", up, right, rows(turning), "all that turns")
    law = (
        "A rotating mass on a shaft gives a force of constant size, outwards along its crank, which turns with the shaft: the mass "
        "times its radius times the square of the shaft's speed. Here the first two are counted in m r, the speed in ω."
    )
    words = (law,)
    steps = [Step("What turns with the shafts", words, tuple(lines))]
    if mixed:
        every = task.moving
        whole = sides(task, "all", joined(b.up for b in every), joined(b.right for b in every), rows(every), "all")
        steps.append(Step("Pistons and rotating masses together", (), tuple(whole)))
    return steps
