"""The same sum by crank pins: the cylinders that share a pin first, then the pins."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from crankstar.derive.addition import distinct
from crankstar.derive.algebra import wave
from crankstar.derive.algebra.formula import Symbol, product, summed
from crankstar.derive.algebra.wave import Wave, joined
from crankstar.derive.body import Body
from crankstar.derive.records import Line, Step
from crankstar.derive.task import Task, paired, rows, share
from crankstar.language.messages import _


class Pin(NamedTuple):
    """The cylinders on one crank pin, and their sums."""

    name: str
    members: list[Body]
    up: Wave
    right: Wave


def by_pin(task: Task, pistons: Sequence[Body]) -> list[Step]:
    """The same sum taken pin by pin, for engines whose banks share their pins."""
    sharing: dict[tuple[str, int], list[Body]] = {}
    for body in pistons:
        sharing.setdefault((body.shaft, body.place), []).append(body)
    shared = [
        members
        for members in sharing.values()
        if len({round(b.bearing_deg, 9) for b in members}) > 1
    ]
    if len(sharing) < 2 or len(shared) < len(sharing) or any(b.along is None for b in pistons):
        return []
    one_shaft = len(task.engine.shafts) == 1
    pins = [
        Pin(
            str(place) if one_shaft else f"{shaft} {place}",
            members,
            joined(b.up for b in members),
            joined(b.right for b in members),
        )
        for (shaft, place), members in sharing.items()
    ]
    lines = [line for pin in pins for line in _of_pin(task, pin)]
    lines += [_of_all(task, pins, pistons, up=True), _of_all(task, pins, pistons, up=False)]
    words = _(
        "The same sum in another order: first the cylinders on each crank pin, then the pins."
    )
    return [Step(_("The other way, pin by pin"), (words,), tuple(lines))]


def _of_pin(task: Task, pin: Pin) -> list[Line]:
    """The cylinders of a pin added up, upwards and to the right."""
    numbers = ", ".join(str(body.cylinder) for body in pin.members)
    up = _("pin {pin}, cylinders {numbers}, up", pin=pin.name, numbers=numbers)
    right = _("pin {pin}, cylinders {numbers}, right", pin=pin.name, numbers=numbers)
    lines: list[Line] = []
    for own, side, bearing, label in ((pin.up, "up", 0.0, up), (pin.right, "right", 90.0, right)):
        parts = [(share(body, up=side == "up"), body.along or {}) for body in pin.members]
        raw = summed(*(product(factor, wave.signal(along, task.order)) for factor, along in parts))
        chain = distinct([raw, *paired(parts, task.order), wave.signal(own, task.order)])
        name = Symbol(task.letter, f"pin {pin.name}, {side}")
        lines.append(Line(name, chain, "signal", rows(pin.members), bearing, label))
    return lines


def _of_all(task: Task, pins: Sequence[Pin], pistons: Sequence[Body], *, up: bool) -> Line:
    """The pins added up."""
    parts = [(pin.name, pin.up if up else pin.right) for pin in pins]
    raw = summed(*(wave.signal(own, task.order) for _name, own in parts))
    whole = wave.signal(joined(own for _name, own in parts), task.order)
    name = Symbol(task.letter, "up" if up else "right")
    label = _("all pins, up") if up else _("all pins, right")
    bearing = 0.0 if up else 90.0
    note = _cancelled(parts)
    return Line(name, distinct([raw, whole]), "signal", rows(pistons), bearing, label, note)


def _cancelled(parts: Sequence[tuple[str, Wave]]) -> str:
    """The pins that cancel in pairs, by name."""
    rest = [(name, own) for name, own in parts if own]
    pairs: list[str] = []
    while rest:
        name, own = rest.pop(0)
        other = next((i for i, (_far, far) in enumerate(rest) if not joined([own, far])), None)
        if other is not None:
            pairs.append(f"{name}, {rest.pop(other)[0]}")
    return _("Pins that cancel in pairs: {pairs}.", pairs="; ".join(pairs)) if pairs else ""
