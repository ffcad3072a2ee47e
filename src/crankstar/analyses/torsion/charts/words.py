"""The common parts of the figures of torsion: what they say, and why there are none."""

from __future__ import annotations

from collections.abc import Sequence
from math import pi
from typing import Any

from crankstar.analyses.torsion.figures import twist, twisting_modes
from crankstar.analysis.assumptions import Answer
from crankstar.charts.canvas import names_engine
from crankstar.charts.drawing import heading
from crankstar.charts.gas_curves import refusal, without
from crankstar.charts.grammar import Chart
from crankstar.charts.resting import Rests, narrowed
from crankstar.dynamics.torsion_analysis import TorsionAnalysis
from crankstar.engine.engine import Engine
from crankstar.engine.torsion import Chain
from crankstar.language.messages import N_, _
from crankstar.language.numbers import RPM, number, order_text
from crankstar.tables.gas_words import points_text, range_points

NO_SPEED = N_("Without a speed nothing is driven: give --speeds, or speed in the file.")
TWISTING = ("natural frequency", "torsional amplitude", "resonant amplitude")
TWISTED = ("torsional stress", "torsional torque")
"""Of these an engine has the one that can be computed."""


def refused(source: Engine | Chain, *, title: str, reason: str) -> Chart:
    """A figure that says why nothing is drawn of an engine or a drive line."""
    if isinstance(source, Engine):
        return without(source, title=title, reason=reason)
    return refusal(reason, title=title, subtitle=named_lines(source))


def named_lines(source: Engine | Chain) -> list[str]:
    """The name of what is drawn, unless the canvas leaves it."""
    if isinstance(source, Engine):
        return heading(source)
    return [source.name] if names_engine() else []


def load_lines(source: Engine | Chain, found: TorsionAnalysis) -> list[str]:
    """Of which operating points the gas is, or why there is none; where the range comes from."""
    lines: list[str] = []
    if found.cycle is not None and isinstance(source, Engine):
        known = range_points(source, found.point)
        names = ", ".join(points_text([(name, 1.0)]) for name, _speed in known)
        if len(known) > 1:
            lines.append(_("gas of the operating points {points}, by the speed", points=names))
        elif known[0][0]:
            lines.append(_("gas of the operating point {point}", point=names))
    if found.without_gas:
        lines.append(_("Without gas: {reason}.", reason=found.without_gas.rstrip(".")))
    if found.range_assumed:
        lines.append(_("The range of speeds is taken about the one that is known; see --speeds."))
    return lines


def hertz(speed: float) -> str:
    """A circular frequency (rad/s) in Hz, as text to four figures."""
    return number(float(f"{speed / (2 * pi):.4g}"))


def rpm_text(speed: float) -> str:
    """A speed (rad/s) in whole rpm, as text.

    >>> rpm_text(585.0)
    '5586'
    """
    return number(round(speed * RPM))


def strongest_line(found: TorsionAnalysis) -> list[str]:
    """A line about the critical speed that counts for most; which that is, the gas decides."""
    if not found.criticals:
        return [_("No order meets a mode in this range of speeds.")]
    top = found.strongest
    if top is None:
        return [_("Which critical speed is the strongest depends on the gas.")]
    return [
        _(
            "Strongest critical speed: order {order} at {rpm} rpm, mode {mode}.",
            order=order_text(top.order),
            rpm=rpm_text(top.speed),
            mode=top.mode,
        )
    ]


def rests(
    source: Engine | Chain, *, quantities: Sequence[str] = (), **options: Any
) -> Rests | None:
    """Of a figure of torsion, none of a drive line; `options` as of `figures.twist`."""
    if not isinstance(source, Engine):
        return None

    def answer(each: Engine) -> Answer:
        if not quantities:
            return twisting_modes()
        return narrowed(twist(each, **options), quantities)

    return Rests([source], answer, "torsion")
