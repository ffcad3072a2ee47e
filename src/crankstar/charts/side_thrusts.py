"""Side thrust of the pistons on their cylinder walls over a working cycle."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial

import numpy as np

from crankstar.charts.drawing import BLUE, GREEN, GREY, Panel, figure
from crankstar.charts.gas_curves import Line, about, over_angle, without
from crankstar.charts.grammar import Chart
from crankstar.charts.letters import TEXT
from crankstar.charts.resting import Rests
from crankstar.engine.engine import Engine
from crankstar.language.messages import N_, _
from crankstar.mechanics.gas import check_gas, cycle
from crankstar.mechanics.operating_points import GasError
from crankstar.mechanics.side_thrust import side_thrust
from crankstar.spectra import Real
from crankstar.studies.chart_answers import pressed

TITLE = N_("Side thrust of the pistons")
AXIS = N_("side thrust\n({unit})")
MOST = 3
"""Cylinders that are drawn, of those that differ."""


def side_thrust_chart(
    engine: Engine, *, point: str | None = None, speed: float | None = None, off: Sequence[int] = ()
) -> Chart:
    """The side thrust of cylinders that differ: of gas, of inertia, and of both together.

    Positive to the side to which gas presses during expansion. At an operating point, or at the
    load of the file. At `speed` (rad/s), with cylinders that are `off`. Raises ChartError.
    """
    try:
        check_gas(engine)
    except GasError as error:
        return without(engine, title=_(TITLE), reason=str(error))
    make = partial(cycle, point=point or "", speed=speed, off=off)
    found = make(engine)
    thrust = side_thrust(engine, found)
    whole = thrust.total
    greatest = float(np.abs(whole).max())
    panels: list[Panel] = []
    chosen = _different(whole)
    for row in chosen:
        lines = [
            Line(_("together"), GREY, 3.0, whole[row]),
            Line(_("gas"), BLUE, 1.6, thrust.gas[row]),
        ]
        if thrust.inertia is not None:
            lines.append(Line(_("inertia"), GREEN, 1.6, thrust.inertia[row]))
        panel = over_angle(
            thrust.theta, lines, title=AXIS, unit="N", height=150, foot=row == chosen[-1]
        )
        head = _("cylinder {number}", number=thrust.numbers[row])
        panels.append({**panel, "title": {"text": head, "fontSize": TEXT}})
    subtitle = [
        *about(engine, found),
        _("positive to the side on which the piston presses during expansion"),
    ]
    if len(chosen) < len(whole):
        subtitle.append(_("The others press as hard, each in its time."))
    if not greatest:
        subtitle.append(_("There is no side thrust."))
    rests = Rests([engine], partial(pressed, make=make), "torque")
    return figure([[panel] for panel in panels], title=_(TITLE), subtitle=subtitle, rests=rests)


def _different(whole: Real) -> list[int]:
    """Rows of cylinders that press unlike the others, the first ones of them."""
    order = {
        tuple(f"{end:.2e}" for end in (row.min(), row.max())): at
        for at, row in reversed([*enumerate(whole)])
    }
    return sorted(order.values())[:MOST]
