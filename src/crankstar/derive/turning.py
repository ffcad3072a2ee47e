"""What turns with the shafts: throws, big ends, weights."""

from __future__ import annotations

from collections.abc import Sequence

from crankstar.derive.algebra import wave
from crankstar.derive.algebra.wave import joined
from crankstar.derive.body import Body
from crankstar.derive.records import Line, Step
from crankstar.derive.task import Task, arm_of, rows, sides
from crankstar.language.messages import _


def turning(task: Task, rotors: Sequence[Body], *, mixed: bool) -> list[Step]:
    """The pushes of rotating masses; with those of the pistons where the engine has both."""
    lines: list[Line] = []
    for body in rotors:
        arm = wave.form(arm_of(task.arms, body)) if task.quantity == "couple" else None
        name, label = _named(body)
        lines += sides(task, name, body.up, body.right, rows([body]), label, arm)
    up, right = joined(b.up for b in rotors), joined(b.right for b in rotors)
    lines += sides(task, "turning", up, right, rows(rotors), _("all rotating masses"))
    words = _(
        "A rotating mass gives a force of constant size, outwards along its crank, which turns "
        "with the shaft: mass times radius times the square of the speed of the shaft. The first "
        "two are counted in m r, the speed in ω."
    )
    steps = [Step(_("Rotating masses"), (words,), tuple(lines))]
    if mixed:
        whole = sides(task, "all", task.up, task.right, rows(task.moving), _("all parts"))
        steps.append(Step(_("Pistons and rotating masses together"), (), tuple(whole)))
    return steps


def _named(body: Body) -> tuple[str, str]:
    """The name of a rotor in a formula, and its label."""
    values = {"place": body.place, "shaft": body.shaft}
    if body.kind == "throw":
        return f"throw {body.place} of {body.shaft}", _("throw {place} of {shaft}", **values)
    if body.kind == "weight":
        return f"weight {body.place} of {body.shaft}", _("weight {place} of {shaft}", **values)
    label = _("big end of cylinder {number}", number=body.cylinder)
    return f"big end {body.cylinder} of {body.shaft}", label
