"""The stroke chart: the open valves or ports and the ignition of each cylinder over one cycle."""

from __future__ import annotations

from collections.abc import Sequence
from math import degrees
from typing import Any

from crankstar.charts.canvas import curve_height, panel_width
from crankstar.charts.crank_angle import across, at_theta
from crankstar.charts.drawing import (
    BLUE,
    GREY,
    LINES,
    ORANGE,
    VERMILION,
    YELLOW,
    ChartError,
    Panel,
    figure,
    heading,
    layered,
)
from crankstar.charts.grammar import Channel, Chart, Layer, constant, field, of_rows, span
from crankstar.charts.resting import of_firing
from crankstar.engine.engine import Engine
from crankstar.engine.valves import EVENTS
from crankstar.firing.strokes import (
    ExhaustGroup,
    Window,
    WorkingCycle,
    are_even,
    exhaust_groups,
    exhaust_intervals,
    pieces,
    working_cycle,
)
from crankstar.firing.succession import Follower
from crankstar.language.faults import EngineError
from crankstar.language.messages import N_, _
from crankstar.language.numbers import number

STROKE_COLOURS = {"intake": BLUE, "compression": YELLOW, "power": ORANGE, "exhaust": VERMILION}
"""On the stage and in the chart: intake blue and exhaust red, as in textbooks."""
EXHAUST, BLOW_DOWN = N_("exhaust open"), N_("blow-down")
INTAKE, POWER = N_("intake open"), N_("power stroke")
SPANS = {
    EXHAUST: (STROKE_COLOURS["exhaust"], 0.5),
    BLOW_DOWN: (STROKE_COLOURS["exhaust"], 1.0),
    INTAKE: (STROKE_COLOURS["intake"], 1.0),
    POWER: (STROKE_COLOURS["power"], 0.25),
}
"""Colour and opacity; the crank angle is marked in grey here."""
PLACES = {POWER: (0.06, 0.94), EXHAUST: (0.16, 0.5), BLOW_DOWN: (0.16, 0.5), INTAKE: (0.5, 0.84)}
"""Lower and upper edge of a span as shares of the height of its row."""
BOLT = "M0.25 -1L-0.55 0.15L-0.08 0.15L-0.25 1L0.55 -0.15L0.08 -0.15Z"
"""The mark of an ignition."""
TALL, LOW, MOST_TALL = 24.0, 15.0, 12
"""Heights of a row, px, and the greatest number of tall rows."""
MOST_INTERVALS = 6
"""Intervals that are all written out; of more the least and the greatest."""
NO_ORDER = N_("The file gives no firing order.")


def cycle_of(engine: Engine) -> WorkingCycle | None:
    """The working cycle of an engine, None without a firing order.

    Raises ChartError where its cylinders have no common cycle.
    """
    if not engine.firing_order:
        return None
    try:
        return working_cycle(engine)
    except EngineError as error:
        raise ChartError(str(error)) from None


def stroke_chart(engine: Engine, *, theta: float = 0.0) -> Chart:
    """Open intake (blue) and exhaust (red), blow-down, power stroke, ignition over one cycle.

    One row a cylinder, front to rear, a panel for each bank or manifold, over 720 deg of a
    four-stroke or 360 deg of a two-stroke engine; a rule at the crank angle `theta` (radians).
    Assumed timing is marked. Raises ChartError.
    """
    cycle = cycle_of(engine)
    turns = round(engine.cycle_angle / 360)
    panels, words = [_empty(turns)], []
    if cycle is not None:
        groups = exhaust_groups(engine)
        if all(len(group.chambers) == 1 for group in groups):  # nothing to keep apart
            groups = (ExhaustGroup("", tuple(engine.chambers)),)
        panels = [_panel(cycle, engine, group, foot=group == groups[-1]) for group in groups]
        words = brief_timing(cycle, engine)
    return figure(
        [[panel] for panel in panels],
        title=_("Stroke chart"),
        subtitle=[*heading(engine), *words],
        theta=theta,
        turns=turns,
        rests=of_firing(engine, valves=True),
    )


def _title(cycle: WorkingCycle, group: ExhaustGroup) -> str:
    """The name of a group and the intervals between its exhausts."""
    if not group.name or len(group.chambers) == 1:
        return group.name
    intervals = spacing(exhaust_intervals(cycle, group.chambers))
    return _("{group}: exhausts {intervals}", group=group.name, intervals=intervals)


def spacing(steps: Sequence[Follower]) -> str:
    """The intervals of events: `every 90 deg`, all of a few, else the least and the greatest."""
    if are_even(steps):
        return _("every {interval} deg", interval=number(steps[0].interval_deg, digits=4))
    apart = [step.interval_deg for step in steps]
    if len(apart) <= MOST_INTERVALS:
        shown = "-".join(number(interval, digits=3) for interval in apart)
        return _("{intervals} deg apart", intervals=shown)
    least, greatest = (number(interval, digits=3) for interval in (min(apart), max(apart)))
    return _("{least} to {greatest} deg apart", least=least, greatest=greatest)


def brief_timing(cycle: WorkingCycle, engine: Engine) -> list[str]:
    """The timing of intake and exhaust in lines that fit a figure, a star at assumed values."""
    timing = {
        name: number(degrees(getattr(cycle.timing, name)), 180.0)
        + ("°*" if name in cycle.timing.assumed else "°")
        for name in EVENTS
    }
    if engine.cycle == "four-stroke":
        lines = [
            _("intake {intake_opens} before TDC to {intake_closes} after BDC", **timing),
            _("exhaust {exhaust_opens} before BDC to {exhaust_closes} after TDC", **timing),
        ]
    else:
        lines = [
            _("intake {intake_opens} before BDC to {intake_closes} after BDC", **timing),
            _("exhaust {exhaust_opens} before BDC to {exhaust_closes} after BDC", **timing),
        ]
    return lines + ([_("* assumed; not in the engine file")] if cycle.timing.assumed else [])


def _front_to_rear(engine: Engine, chambers: Sequence[int]) -> list[int]:
    place = {chamber: pistons[0].z for chamber, pistons in engine.chambers.items()}
    return sorted(chambers, key=lambda number: -place[number])


def span_rows(cycle: WorkingCycle, chambers: Sequence[int]) -> list[dict[str, Any]]:
    """The spans of chambers in rows 0, 1, ..., divided at the end of the cycle."""
    rows = []
    for row, chamber in enumerate(chambers):
        strokes = cycle.chamber(chamber)
        windows = {
            POWER: strokes.strokes[0].window,
            EXHAUST: Window(strokes.blow_down.end_deg, strokes.exhaust.end_deg),
            BLOW_DOWN: strokes.blow_down,
            INTAKE: strokes.intake,
        }
        for name, window in windows.items():
            low, high = PLACES[name]
            begins = window.start_deg % cycle.cycle_deg
            within = Window(begins, begins + window.length_deg)
            edges = {"y": row + low, "foot": row + high, "what": _(name), "cylinder": chamber}
            rows += [
                {"x": round(part.start_deg, 6), "end": round(part.end_deg, 6), **edges}
                for part in pieces(within, cycle_deg=cycle.cycle_deg)
            ]
    return rows


def _panel(cycle: WorkingCycle, engine: Engine, group: ExhaustGroup, *, foot: bool) -> Panel:
    chambers = _front_to_rear(engine, group.chambers)
    height = max(LOW, curve_height(TALL)) if len(cycle.chambers) <= MOST_TALL else LOW
    x, rule = _crank_angle(round(cycle.cycle_deg / 360), foot=foot)
    names = "[" + ", ".join(f"'{chamber}'" for chamber in chambers) + "]"
    axis = {
        "values": [row + 0.5 for row in range(len(chambers))],
        "labelExpr": f"{names}[floor(datum.value)]",
        "labelPadding": 10,
        **dict.fromkeys(("ticks", "domain", "grid", "labelOverlap"), False),
    }
    scale = span(len(chambers), 0) | {"zero": False}
    y = field("y:Q", scale=scale, axis=axis, title=_("cylinder"))
    squares = {"symbolType": "square", "symbolSize": 150, "symbolStrokeWidth": 0}
    colours = {
        "domain": [_(name) for name in SPANS],
        "range": [_translucent(*paint) for paint in SPANS.values()],
    }
    colour = field("what:N", scale=colours, legend={**LINES, "columns": 2, **squares})
    spans = of_rows(span_rows(cycle, chambers)).mark("rect", strokeWidth=0, opacity=1)
    fires = [(row + 0.5, cycle.chamber(chamber).fires_deg) for row, chamber in enumerate(chambers)]
    marks = [{"x": angle, "y": row} for row, angle in fires]
    marks += [{"x": cycle.cycle_deg, "y": row} for row, angle in fires if angle == 0]
    bolts = of_rows(marks).mark(
        "point", shape=BOLT, filled=True, opacity=1, size=14 * height, color=GREY, strokeWidth=0
    )
    layers = [
        spans.encode(x=x, x2=field("end"), y=y, y2=field("foot"), color=colour),
        bolts.encode(x=x, y=y),
        rule,
    ]
    size = {"width": panel_width(), "height": height * len(chambers)}
    return layered(layers, **size, title=_title(cycle, group))


def _translucent(colour: str, opacity: float) -> str:
    """A colour with an opacity."""
    red, green, blue = (int(colour[place : place + 2], 16) for place in (1, 3, 5))
    return f"rgba({red}, {green}, {blue}, {opacity:g})"


def _crank_angle(turns: int, *, foot: bool) -> tuple[Channel, Layer]:
    """The crank angle over one cycle, a number at every other tick; the rule at `theta`."""
    every_other = f"datum.value % {90 * turns} == 0 ? datum.label : ''"
    x = across(turns, ticks=45 * turns, foot=foot, labelExpr=every_other, labelOverlap=False)
    rule = at_theta(turns).mark("rule", color=GREY, strokeWidth=1.6, strokeDash=[3, 2])
    return x, rule.encode(x=x)


def _empty(turns: int) -> Panel:
    x, rule = _crank_angle(turns, foot=True)
    words = of_rows([{"x": 180 * turns}]).mark("text", fontSize=13, color=GREY)
    return layered(
        [words.encode(x=x, text=constant(_(NO_ORDER))), rule], width=panel_width(), height=60
    )
