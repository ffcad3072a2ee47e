"""Cylinder by cylinder, bank by bank, and the banks together; and the same sum by crank pins."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction
from functools import partial
from typing import NamedTuple

from crankstar.derive.addition import Term, addition, distinct, lag, opposite_pairs
from crankstar.derive.algebra import wave
from crankstar.derive.algebra.cyclotomic import Number
from crankstar.derive.algebra.formula import (
    THETA,
    Degrees,
    Formula,
    Product,
    Symbol,
    angle,
    cosine,
    number,
    product,
    summed,
    terms_of,
)
from crankstar.derive.algebra.radicals import closed
from crankstar.derive.algebra.wave import Wave, joined
from crankstar.derive.bodies import Body, Push, pushed
from crankstar.derive.records import Line, Step
from crankstar.derive.task import Task, degrees_text, resolved, rows, sides
from crankstar.engine.engine import Engine
from crankstar.language.messages import _, passage


class Row(NamedTuple):
    """Cylinders of one bank on one shaft, which push along one line."""

    name: str
    members: tuple[Body, ...]
    wave: Wave


def by_bank(task: Task, pistons: list[Body]) -> list[Step]:
    """Every cylinder, every bank along its own line, and the banks together."""
    steps = [_each(task, pistons)]
    if any(body.along is None for body in pistons):
        words = _("The components up and to the right are added.")
        lines = sides(task, "all", pistons, _("all cylinders"))
        return [*steps, Step(_("All cylinders"), (words,), tuple(lines))]
    banks = _banks(pistons)
    if any(len(row.members) > 1 for row in banks):
        steps.append(_sums(task, banks))
    return [*steps, _resolved(task, banks, pistons)]


def _banks(pistons: Sequence[Body]) -> list[Row]:
    """Cylinders that push along one line, grouped by bank, shaft and bearing."""
    groups: dict[tuple[str, str, float], list[Body]] = {}
    for body in pistons:
        groups.setdefault((body.bank, body.shaft, round(body.bearing_deg, 9)), []).append(body)
    names = [bank for bank, _shaft, _bearing in groups]
    out = []
    for (bank, _shaft, bearing), members in groups.items():
        name = bank if len(groups) > 1 else "all"
        if names.count(bank) > 1:
            name = f"{name} at {degrees_text(bearing)}"
        out.append(Row(name, tuple(members), joined(b.along or {} for b in members)))
    return out


def _each(task: Task, pistons: Sequence[Body]) -> Step:
    """The cosine of each cylinder along its own axis."""
    lines: list[Line] = []
    for body in pistons:
        label, arm = cylinder_label(task.engine, body), task.arm(body)
        if body.along is None:
            lines += sides(task, str(body.cylinder), [body], label, arm=arm)
        else:
            name, chain = Symbol(task.letter, str(body.cylinder)), _own(task, body.along, body)
            own, bearing = rows([body]), body.bearing_deg
            lines.append(Line(name, chain, "signal", own, bearing, label, arm=arm))
    words: list[str] = []
    if not any(each.articulated or each.offset for each in task.engine.cylinders):
        words.append(
            _("The cosine of each piston has its crest where the piston is at top dead centre.")
        )
    if task.quantity == "couple":
        words.append(
            _(
                "Each force is multiplied by its arm, the distance of the cylinder in front of the "
                "reference plane. A couple is shown in the plane in which it acts."
            )
        )
    return Step(_("Every cylinder along its own axis"), tuple(words), tuple(lines))


def cylinder_label(engine: Engine, body: Body) -> str:
    """What a line of one cylinder is about."""
    values = {"number": body.cylinder, "bearing": degrees_text(body.bearing_deg)}
    if len(engine.banks) > 1:
        label = _("cylinder {number} ({bank}), at {bearing}", bank=body.bank, **values)
    else:
        label = _("cylinder {number}, at {bearing}", **values)
    if body.dead_centre is None:
        return label
    centre = degrees_text(float(360 * body.dead_centre))
    return _("{cylinder}, top dead centre at θ = {centre}", cylinder=label, centre=centre)


def _own(task: Task, along: Wave, body: Body) -> tuple[Formula, ...]:
    """A cylinder's cosine as k (theta - its dead centre), then with its phase."""
    if body.lag is None or body.dead_centre is None:
        return (wave.signal(along, task.order),)
    sizes = (product(_size(amount, body.lag), *key) for key, amount in along.items())
    factors, chain = summed(*sizes), []
    if body.dead_centre:
        chain.append(product(factors, cosine(turned(task.order, body.dead_centre))))
    chain.append(product(factors, cosine(wave.phased(task.order, angle(lag(body.lag))))))
    return distinct(chain)


def turned(order: Fraction, dead_centre: Fraction) -> Formula:
    """K (theta - a dead centre), in degrees where they are short."""
    degrees = -360 * dead_centre
    short = 1000 % degrees.denominator == 0
    behind = summed(THETA, Degrees(number(degrees)) if short else angle(-dead_centre))
    return behind if order == 1 else product(order, behind)


def _size(amount: wave.Amount, phase: Fraction) -> Formula:
    """The real number that stands before a cosine whose phase is known."""
    turned = amount.turned(-phase)
    if isinstance(turned, Number):
        return closed(turned)
    raise TypeError("a rational phase belongs to an exact amount")


def _sums(task: Task, banks: Sequence[Row]) -> Step:
    """The cosines of each bank added up."""
    many = len(banks) > 1
    lines: list[Line] = []
    for row in banks:
        bank = row.name if row.name.startswith("bank ") else f"bank {row.name}"
        name = Symbol(task.letter, bank if many else "all")
        bearing = row.members[0].bearing_deg
        label = _("{bank}, at {bearing}", bank=row.name, bearing=degrees_text(bearing))
        terms, chain, note = _terms(row.members), (wave.signal(row.wave, task.order),), ""
        if terms is not None:
            sums = addition(terms, task.order, moments=task.quantity == "couple")
            chain, note = sums.chain, passage(sums.notes)
        lines.append(Line(name, chain, "signal", rows(row.members), bearing, label, note))
    title = _("Bank by bank") if many else _("All cylinders")
    words = _("All cylinders push along one line, so their cosines simply add.")
    if many:
        words = _("The cylinders of a bank push along one line, so their cosines simply add.")
    return Step(title, (words,), tuple(lines))


def _terms(members: Sequence[Body]) -> list[Term] | None:
    """The cosines of cylinders with rational weights and phases; None where they have not."""
    out: list[Term] = []
    for body in members:
        if body.lag is None or body.along is None or body.cylinder is None:
            return None
        turned = {key: amount.turned(-body.lag) for key, amount in body.along.items()}
        weight = {
            key: size
            for key, amount in turned.items()
            if isinstance(amount, Number) and (size := amount.rational) is not None
        }
        if len(weight) < len(turned):
            return None
        out.append(Term(body.cylinder, weight, body.lag))
    return out


def _resolved(task: Task, banks: Sequence[Row], pistons: Sequence[Body]) -> Step:
    """Forces along several lines, each resolved into up and right, and added."""
    parts = [(row.members[0], row.wave) for row in banks]
    note = _("The terms are added as vectors, each with its length and phase.")
    lines = [
        replace(line, note=note) if len(line.chain) == 2 and _several(line.chain[0]) else line
        for line in sides(
            task, _whole(task), pistons, before=lambda side: resolved(task, parts, side)
        )
    ]
    angles = sorted({round(row.members[0].bearing_deg, 9) for row in banks})
    words = [
        _(
            "A force along a cylinder at bearing β has the component cos β upwards and sin β to "
            "the right, seen from the front."
        )
    ]
    if len(angles) == 2 and angles[0] == -angles[1]:
        angle = degrees_text(angles[1])
        words.append(_("Here β = ±{angle}, half the bank angle.", angle=angle))
    return Step(_("Upwards and to the right"), tuple(words), tuple(lines))


def _whole(task: Task) -> str:
    """The name of the sum of all pistons; none where there is nothing else that pushes."""
    return "pistons" if any(body.turning for body in task.moving) else ""


def _several(formula: Formula) -> bool:
    """Whether cosines of different phases are added."""
    terms = terms_of(formula)
    return len({term.factors[-1] if isinstance(term, Product) else term for term in terms}) > 1


def by_pin(task: Task, pistons: Sequence[Body]) -> list[Step]:
    """The same sum taken pin by pin, for engines whose banks share their pins."""
    sharing: dict[tuple[str, int], list[tuple[Body, Wave]]] = {}
    for body in pistons:
        if body.along is None:
            return []
        sharing.setdefault((body.shaft, body.place), []).append((body, body.along))
    if len(sharing) < 2 or any(
        len({round(body.bearing_deg, 9) for body, _ in parts}) < 2 for parts in sharing.values()
    ):
        return []
    lines: list[Line] = []
    pins: list[tuple[str, Push]] = []
    for (shaft, place), parts in sharing.items():
        name = str(place) if len(task.engine.shafts) == 1 else f"{shaft} {place}"
        members = [body for body, _along in parts]
        numbers = ", ".join(str(body.cylinder) for body in members)
        label = _("pin {pin}, cylinders {numbers}", pin=name, numbers=numbers)
        before = partial(resolved, task, parts)
        lines += sides(task, f"pin {name}", members, label, before=before)
        pins.append((name, pushed(members)))

    def added(side: int) -> list[Formula]:
        return [summed(*(wave.signal(push[side], task.order) for _, push in pins))]

    every = sides(task, _whole(task), pistons, _("all pins"), before=added)
    lines += [
        replace(line, note=_cancelled([(name, push[side]) for name, push in pins]))
        for side, line in enumerate(every)
    ]
    words = _(
        "The same sum in another order: first the cylinders on each crank pin, then the pins."
    )
    return [Step(_("The other way, pin by pin"), (words,), tuple(lines))]


def _cancelled(parts: Sequence[tuple[str, Wave]]) -> str:
    """The pins that cancel in pairs, by name."""
    pushing = [(name, own) for name, own in parts if own]
    pairs = opposite_pairs(pushing, lambda own, far: not joined([own, far]))
    return _("Pins that cancel in pairs: {pairs}.", pairs="; ".join(pairs)) if pairs else ""
