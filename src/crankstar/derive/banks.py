"""Cylinder by cylinder, bank by bank, and the banks together."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import NamedTuple

from crankstar.derive.addition import Term, addition, distinct, lag
from crankstar.derive.algebra import wave
from crankstar.derive.algebra.cyclotomic import Number
from crankstar.derive.algebra.formula import (
    THETA,
    Degrees,
    Formula,
    Product,
    Sum,
    Symbol,
    angle,
    cosine,
    number,
    product,
    summed,
)
from crankstar.derive.algebra.radicals import closed
from crankstar.derive.algebra.wave import Wave, joined
from crankstar.derive.body import Body
from crankstar.derive.records import Line, Step
from crankstar.derive.task import Task, arm_of, degrees_text, paired, rows, share, sides
from crankstar.language.messages import _


class Row(NamedTuple):
    """Cylinders of one bank on one shaft, which push along one line."""

    name: str
    members: tuple[Body, ...]
    wave: Wave


def by_bank(task: Task, pistons: list[Body]) -> list[Step]:
    """Every cylinder, every bank along its own line, and the banks together."""
    steps = [_each(task, pistons)]
    if any(body.along is None for body in pistons):
        return [*steps, _components(task, pistons)]
    banks = _banks(pistons)
    if any(len(row.members) > 1 for row in banks):
        steps.append(_sums(task, banks))
    steps.append(_resolved(task, banks, pistons))
    return steps


def _banks(pistons: Sequence[Body]) -> list[Row]:
    """Cylinders that push along one line, grouped by bank, shaft and bearing."""
    groups: dict[tuple[str, str, float], list[Body]] = {}
    for body in pistons:
        groups.setdefault((body.bank, body.shaft, round(body.bearing_deg, 9)), []).append(body)
    several = {name for name, _, _ in groups if sum(1 for key in groups if key[0] == name) > 1}
    out = []
    for (bank, _shaft, bearing), members in groups.items():
        name = bank if len(groups) > 1 else "all"
        if bank in several:
            name = f"{name} at {degrees_text(bearing)}"
        out.append(Row(name, tuple(members), joined(b.along or {} for b in members)))
    return out


def _each(task: Task, pistons: Sequence[Body]) -> Step:
    """The cosine of each cylinder along its own axis."""
    lines = []
    for body in pistons:
        label = _cylinder_label(task, body)
        arm = wave.form(arm_of(task.arms, body)) if task.quantity == "couple" else None
        if body.along is None:
            name = str(body.cylinder)
            lines += sides(task, name, body.up, body.right, rows([body]), label, arm)
            continue
        name = Symbol(task.letter, str(body.cylinder))
        chain = _own(task, body)
        lines.append(Line(name, chain, "signal", rows([body]), body.bearing_deg, label, arm=arm))
    words = [_("The cosine of each piston has its crest where the piston is at top dead centre.")]
    if task.quantity == "couple":
        words.append(
            _(
                "Each force is multiplied by its arm, the distance of the cylinder in front of the "
                "reference plane. A couple is shown in the plane in which it acts."
            )
        )
    return Step(_("Every cylinder along its own axis"), tuple(words), tuple(lines))


def _cylinder_label(task: Task, body: Body) -> str:
    """What a line of one cylinder is about."""
    values = {"number": body.cylinder, "bearing": degrees_text(body.bearing_deg)}
    centre = None if body.dead_centre is None else degrees_text(float(360 * body.dead_centre))
    if len(task.engine.banks) > 1:
        values["bank"] = body.bank
        if centre is None:
            return _("cylinder {number} ({bank}), at {bearing}", **values)
        return _(
            "cylinder {number} ({bank}), at {bearing}, top dead centre at θ = {centre}",
            centre=centre,
            **values,
        )
    if centre is None:
        return _("cylinder {number}, at {bearing}", **values)
    return _(
        "cylinder {number}, at {bearing}, top dead centre at θ = {centre}", centre=centre, **values
    )


def _own(task: Task, body: Body) -> tuple[Formula, ...]:
    """A cylinder's cosine as k (theta - its dead centre), then with its phase."""
    along = body.along or {}
    if body.lag is None or body.dead_centre is None:
        return (wave.signal(along, task.order),)
    factors = summed(*(product(_size(amount, body.lag), *key) for key, amount in along.items()))
    chain: list[Formula] = []
    if body.dead_centre:
        turned = summed(THETA, _degrees_of(-body.dead_centre))
        inside = turned if task.order == 1 else product(task.order, turned)
        chain.append(product(factors, cosine(inside)))
    chain.append(product(factors, cosine(wave.phased(task.order, angle(lag(body.lag))))))
    return distinct(chain)


def _degrees_of(turn: Fraction) -> Formula:
    """A part of a turn in degrees, as a multiple of pi where degrees are no short decimal."""
    return Degrees(number(360 * turn)) if 1000 % (360 * turn).denominator == 0 else angle(turn)


def _size(amount: wave.Amount, phase: Fraction) -> Formula:
    """The real number that stands before a cosine whose phase is known."""
    turned = amount.turned(-phase)
    if isinstance(turned, Number):
        return closed(turned).formula
    raise TypeError("a rational phase belongs to an exact amount")


def _sums(task: Task, banks: Sequence[Row]) -> Step:
    """The cosines of each bank added up."""
    many = len(banks) > 1
    lines: list[Line] = []
    for row in banks:
        name = Symbol(task.letter, f"bank {row.name}" if many else "all")
        bearing = row.members[0].bearing_deg
        label = _("{bank}, at {bearing}", bank=row.name, bearing=degrees_text(bearing))
        terms, chain, note = _terms(row.members), (wave.signal(row.wave, task.order),), ""
        if terms is not None:
            sums = addition(terms, task.order, moments=task.quantity == "couple")
            chain, note = sums.chain, " ".join(sums.notes)
        lines.append(Line(name, chain, "signal", rows(row.members), bearing, label, note))
    if many:
        words = _("The cylinders of a bank push along one line, so their cosines simply add.")
        return Step(_("Bank by bank"), (words,), tuple(lines))
    words = _("All cylinders push along one line, so their cosines simply add.")
    return Step(_("All cylinders"), (words,), tuple(lines))


def _terms(members: Sequence[Body]) -> list[Term] | None:
    """The cosines of cylinders with rational weights and phases; None where they have not."""
    out: list[Term] = []
    for body in members:
        if body.lag is None or body.along is None or body.cylinder is None:
            return None
        weight: dict[wave.Key, Fraction] = {}
        for key, amount in body.along.items():
            turned = amount.turned(-body.lag)
            size = turned.rational if isinstance(turned, Number) else None
            if size is None:
                return None
            weight[key] = size
        out.append(Term(body.cylinder, weight, body.lag))
    return out


def _resolved(task: Task, banks: Sequence[Row], pistons: Sequence[Body]) -> Step:
    """Forces along several lines, each resolved into up and right, and added."""
    lines = []
    sides = (("up", 0.0, _("up")), ("right", 90.0, _("right")))
    for side, bearing, label in sides:
        parts = [(share(row.members[0], up=side == "up"), row.wave) for row in banks]
        whole = joined(body.up if side == "up" else body.right for body in pistons)
        raw = summed(*(product(factor, wave.signal(own, task.order)) for factor, own in parts))
        chain = distinct([raw, *paired(parts, task.order), wave.signal(whole, task.order)])
        note = ""
        if len(chain) == 2 and _several(chain[0]):
            note = _("Added as vectors, each with its length and phase.")
        name = Symbol(task.letter, side)
        lines.append(Line(name, chain, "signal", rows(pistons), bearing, label, note))
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


def _several(formula: Formula) -> bool:
    """Whether cosines of different phases are added."""
    if not isinstance(formula, Sum):
        return False
    last = {term.factors[-1] if isinstance(term, Product) else term for term in formula.terms}
    return len(last) > 1


def _components(task: Task, pistons: Sequence[Body]) -> Step:
    """Cylinders with rods that swing knuckle pins about: components up and right simply add."""
    up, right = joined(body.up for body in pistons), joined(body.right for body in pistons)
    return Step(
        _("All cylinders"),
        (_("The components up and to the right are added."),),
        tuple(sides(task, "all", up, right, rows(pistons), _("all cylinders"))),
    )
