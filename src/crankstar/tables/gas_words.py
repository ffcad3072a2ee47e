"""Operating points, and what does not burn in a cycle, in words and for machines."""

from __future__ import annotations

from math import pi

from crankstar.engine.engine import Engine
from crankstar.language.messages import _
from crankstar.language.numbers import number, numbers_text
from crankstar.language.quoting import one_line
from crankstar.mechanics.gas import Cycle
from crankstar.mechanics.gas_loads import points_by_speed
from crankstar.mechanics.operating_points import default_point


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


def weaker_facts(cycle: Cycle | None) -> dict[str, float]:
    """The share that each weak chamber lacks, by its number as text."""
    return {} if cycle is None else {str(key): share for key, share in cycle.weaker.items()}


def load_words(engine: Engine, point: str, speed: float) -> str:
    """The operating point and speed (rad/s) of a number, as a sentence.

    `point` "" is the load of the table [gas], or that between the points of the file.
    """
    rpm = number(round(speed * 30 / pi, 6))
    if engine.gas is None:
        return _("At {rpm} rpm, without gas, which the file does not have.", rpm=rpm)
    known = points_by_speed(engine)
    point = point or next((known[at] for at in known if abs(at - speed) <= 1e-9 * speed), "")
    if not (point or known):
        point = default_point(engine.gas)
    if point:
        name = one_line(point, longest=60)
        return _("At {rpm} rpm, operating point {point}.", rpm=rpm, point=name)
    if not known or any(abs(at - speed) <= 1e-9 * speed for at in known):
        return _("At {rpm} rpm, with the load of the table [gas].", rpm=rpm)
    around = [at for at in sorted(known) if at < speed][-1:]
    around += [at for at in sorted(known) if at > speed][:1]
    names = ", ".join(one_line(known[at], longest=60) or "[gas]" for at in around)
    if len(around) == 1:
        return _("At {rpm} rpm, with the load of the nearest point, {names}.", rpm=rpm, names=names)
    return _("At {rpm} rpm, with a load between the points {names}.", rpm=rpm, names=names)
