"""The other way: the cylinders that share a crank pin first, then the pins."""

from __future__ import annotations

from collections.abc import Sequence

from crankstar.derive import wave
from crankstar.derive.bodies import Body
from crankstar.derive.formula import Symbol, product, summed
from crankstar.derive.gather import told_once
from crankstar.derive.records import Line, Step
from crankstar.derive.task import Task, paired, rows, share
from crankstar.derive.wave import Wave, joined


def by_pin(task: Task, pistons: Sequence[Body]) -> list[Step]:
    """The same sum taken pin by pin, for engines whose banks share their pins."""
    pins: dict[tuple[str, int], list[Body]] = {}
    for body in pistons:
        pins.setdefault((body.shaft, body.place), []).append(body)
    shared = [members for members in pins.values() if len({round(b.bearing_deg, 9) for b in members}) > 1]
    if len(pins) < 2 or len(shared) < len(pins) or any(body.along is None for body in pistons):
        return []
    lines: list[Line] = []
    names: list[str] = []
    ups: list[Wave] = []
    rights: list[Wave] = []
    for (shaft, place), members in pins.items():
        name = f"pin {place}" if len(task.engine.shafts) == 1 else f"{shaft} {place}"
        up, right = joined(b.up for b in members), joined(b.right for b in members)
        numbers = ", ".join(str(body.cylinder) for body in members)
        for own, side, bearing in ((up, "up", 0.0), (right, "right", 90.0)):
            parts = [(share(body, up=side == "up"), body.along or {}) for body in members]
            raw = summed(*(product(factor, wave.signal(along, task.order)) for factor, along in parts))
            chain = told_once([raw, *paired(parts, task.order), wave.signal(own, task.order)])
            told = f"{name}, cylinders {numbers}, {side}"
            lines.append(Line(Symbol(task.letter, f"{name}, {side}"), chain, "signal", rows(members), bearing, told))
        names.append(name)
        ups.append(up)
        rights.append(right)
    for parts, side, bearing in ((ups, "up", 0.0), (rights, "right", 90.0)):
        raw = summed(*(wave.signal(part, task.order) for part in parts))
        whole = wave.signal(joined(parts), task.order)
        note = _cancelled(list(zip(names, parts, strict=True)))
        chain = told_once([raw, whole])
        lines.append(Line(Symbol(task.letter, side), chain, "signal", rows(pistons), bearing, f"all pins, {side}", note))
    words = ("The same sum taken another way: first the cylinders that share a crank pin, then the pins.",)
    return [Step("The other way, pin by pin", words, tuple(lines))]


def _cancelled(parts: Sequence[tuple[str, Wave]]) -> str:
    """The groups that cancel in pairs, by name."""
    rest = [(name, own) for name, own in parts if own]
    pairs: list[str] = []
    while rest:
        name, own = rest.pop(0)
        other = next((i for i, (_, far) in enumerate(rest) if not joined([own, far])), None)
        if other is not None:
            pairs.append(f"{name} and {rest.pop(other)[0]}")
    return f"Cancel: {'; '.join(pairs)}." if pairs else ""
