"""Operating points, and what does not burn in a cycle, in words and for machines."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from crankstar.engine.engine import Engine
from crankstar.language.messages import _
from crankstar.language.numbers import RPM, number, numbers_text, rpm_of
from crankstar.language.quoting import one_line
from crankstar.mechanics.gas import Cycle
from crankstar.mechanics.operating_points import (
    OperatingState,
    operating_state,
    own_speed,
    points_by_speed,
)


def burning_words(title: str, cycle: Cycle) -> str:
    """A title with the cylinders that burn nothing, or less than the others."""
    if cycle.off:
        off = numbers_text(cycle.off)
        title = _("{title}, without combustion in {numbers}", title=title, numbers=off)
    for cylinder, lost in cycle.weaker.items():
        share = number(100 * lost, digits=3)
        title = _(
            "{title}, cylinder {number} weak by {share} %",
            title=title,
            number=cylinder,
            share=share,
        )
    return title


def at_points(title: str, cycle: Cycle | None) -> str:
    """A title with the operating points of its gas; nothing of the one load of the table [gas]."""
    if cycle is None or cycle.shares in ((), (("", 1.0),)):
        return title
    point = points_text(cycle.shares)
    if len(cycle.shares) > 1:
        return _("{title}, between the operating points {names}", title=title, names=point)
    return _("{title}, operating point {point}", title=title, point=point)


def weaker_facts(cycle: Cycle | None) -> dict[str, float]:
    """The share that each weak chamber lacks, by its number as text."""
    return {} if cycle is None else {str(key): share for key, share in cycle.weaker.items()}


def state_words(engine: Engine, state: OperatingState) -> str:
    """The operating point and speed of a number, as a sentence."""
    rpm = rpm_text(state.speed)
    if engine.gas is None and state.speed is not None:
        return _("At {rpm} rpm, without gas, which the file does not have.", rpm=rpm)
    point = points_text(state.shares)
    if state.speed is None:
        return _("At the operating point {point}, without a speed.", point=point)
    if len(state.shares) > 1:
        return _("At {rpm} rpm, with a load between the points {names}.", rpm=rpm, names=point)
    if not state.point:
        return _("At {rpm} rpm, with the load of the table [gas].", rpm=rpm)
    own = own_speed(engine, state.point)
    if own is None or abs(own - state.speed) <= 1e-9 * state.speed:
        return _("At {rpm} rpm, operating point {point}.", rpm=rpm, point=point)
    return _("At {rpm} rpm, with the load of the point {point}.", rpm=rpm, point=point)


def cycle_words(engine: Engine, cycle: Cycle) -> str:
    """The operating point and speed of a cycle; that it is a usual one where the file has none."""
    if engine.gas is None and cycle.speed is not None:
        return usual_words(cycle.speed)
    return state_words(engine, cycle_state(cycle))


def usual_words(speed: float) -> str:
    """The speed (rad/s) of a usual cycle, where the file has none."""
    return _("At {rpm} rpm, with a usual cycle: the file has no gas.", rpm=rpm_text(speed))


def cycle_state(cycle: Cycle) -> OperatingState:
    """The speed and points of a cycle."""
    return OperatingState(cycle.speed, cycle.shares)


def points_text(shares: Sequence[tuple[str, float]]) -> str:
    """Operating points by name, of two their shares too.

    >>> points_text([("idle", 0.75), ("", 0.25)])
    'idle 75 %, [gas] 25 %'
    """
    names = [one_line(name, longest=60) if name else "[gas]" for name, _share in shares]
    if len(names) == 1:
        return names[0]
    percent = [number(100 * share, digits=3) for _name, share in shares]
    return ", ".join(f"{name} {each} %" for name, each in zip(names, percent, strict=True))


def range_words(engine: Engine, point: str = "") -> str:
    """Which gas there is over a range of speeds, as a sentence; empty without gas."""
    if engine.gas is None and not point:
        return ""
    points = range_points(engine, point)
    if len(points) > 1:
        told = [
            _("{point} at {rpm} rpm", point=points_text([(name, 1.0)]), rpm=rpm_text(speed))
            for name, speed in points
        ]
        return _(
            "The gas follows the speed: it is that of the operating points {points}, of the two "
            "next to a speed by their distance, beyond the last of the nearest.",
            points=", ".join(told),
        )
    if not points[0][0]:
        return _("The gas is that of the load of the table [gas] at all speeds.")
    name = points_text([(points[0][0], 1.0)])
    return _("The gas is that of the operating point {point} at all speeds.", point=name)


def range_points(engine: Engine, point: str = "") -> list[tuple[str, float | None]]:
    """The operating points of which the gas is over a range of speeds, and their speeds (rad/s)."""
    known = {} if point else points_by_speed(engine)
    alone = operating_state(engine, point=point).point
    return [(name, at) for at, name in known.items()] or [(alone, own_speed(engine, alone))]


def range_facts(engine: Engine, point: str = "") -> list[dict[str, Any]]:
    """The same for machines, the load of the table [gas] by null."""
    if engine.gas is None and not point:
        return []
    return [
        {"name": name or None, "speed_rpm": rpm_of(speed)}
        for name, speed in range_points(engine, point)
    ]


def rpm_text(speed: float | None) -> str:
    """A speed (rad/s) in rpm."""
    return "" if speed is None else number(round(speed * RPM, 6))


def state_facts(state: OperatingState | None) -> dict[str, Any]:
    """Speed and operating points for machines: `point` is null between two, and for [gas]."""
    if state is None:
        return {"point": None, "points": []}
    return {
        "point": state.point or None,
        "points": [{"name": name or None, "share": share} for name, share in state.shares],
    }
