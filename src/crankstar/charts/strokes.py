"""The stroke chart: when the valves or ports of each cylinder are open over one cycle, and when it fires."""

from __future__ import annotations

from collections.abc import Sequence
from math import degrees
from typing import TYPE_CHECKING, Any

from crankstar.charts.drawing import (
    BLUE,
    GREY,
    ORANGE,
    VERMILION,
    WIDTH,
    ChartError,
    Panel,
    checked_angle,
    figure,
    layered,
    of_rows,
)
from crankstar.engine import Engine
from crankstar.fault import EngineError
from crankstar.strokes import ExhaustGroup, Window, WorkingCycle, are_even, exhaust_groups, exhaust_intervals, pieces, working_cycle
from crankstar.succession import Follower
from crankstar.valves import EVENTS
from crankstar.wording import number

if TYPE_CHECKING:
    import altair

EXHAUST, BLOW_DOWN, INTAKE, POWER = "exhaust open", "blow-down", "intake open", "power stroke"
SPANS = {EXHAUST: (VERMILION, 0.5), BLOW_DOWN: (VERMILION, 1.0), INTAKE: (BLUE, 1.0), POWER: (ORANGE, 0.25)}
"""Colour and opacity: intake blue and exhaust red, as in the books; the crank angle is marked in grey here."""
PLACES = {POWER: (0.06, 0.94), EXHAUST: (0.16, 0.5), BLOW_DOWN: (0.16, 0.5), INTAKE: (0.5, 0.84)}
"""From where to where a span reaches in the height of its row."""
BOLT = "M0.25 -1L-0.55 0.15L-0.08 0.15L-0.25 1L0.55 -0.15L0.08 -0.15Z"
"""The mark of an ignition."""
TALL, LOW, MOST_TALL = 24.0, 15.0, 12
"""Heights of a row, px, and how many there may be of the taller ones."""
MOST_INTERVALS = 6
"""Intervals that are written one after the other."""
NO_ORDER = "no firing order is known"


def found_cycle(engine: Engine) -> WorkingCycle | None:
    """The working cycle that a figure shows; None without a firing order. Raises ChartError where there are no strokes."""
    if not engine.firing_order:
        return None
    try:
        return working_cycle(engine)
    except EngineError as error:
        raise ChartError(str(error)) from None


def stroke_chart(engine: Engine, *, theta: float = 0.0) -> altair.VConcatChart:
    """When intake (blue) and exhaust (red) of each cylinder are open over one cycle, with its blow-down, power stroke and ignition.

    One row a cylinder, front to rear, a panel for each bank or manifold, over 720 deg of a four-stroke or 360 deg of a two-stroke
    engine; a rule at the crank angle `theta` (radians). What is assumed of the timing is named. Raises ChartError.
    """
    theta = checked_angle(theta)
    found = found_cycle(engine)
    turns = round(engine.cycle_angle / 360)
    if found is None:
        return figure([[_empty(turns)]], title="Stroke chart", subtitle=[engine.name], theta=theta, turns=turns)
    groups = exhaust_groups(engine)
    if all(len(group.chambers) == 1 for group in groups):  # nothing to keep apart
        groups = (ExhaustGroup("", tuple(number for group in groups for number in group.chambers)),)
    height = TALL if len(found.chambers) <= MOST_TALL else LOW
    panels = [
        _panel(found, _title(found, group), _front_to_rear(engine, group.chambers), height, turns, foot=group == groups[-1])
        for group in groups
    ]
    subtitle = [engine.name, *brief_timing(found, engine)]
    return figure([[panel] for panel in panels], title="Stroke chart", subtitle=subtitle, theta=theta, turns=turns)


def _title(found: WorkingCycle, group: ExhaustGroup) -> str:
    """The name of a group and the intervals between its exhausts."""
    if not group.name or len(group.chambers) == 1:
        return group.name
    return f"{group.name}: exhausts {spacing(exhaust_intervals(found, group.chambers))}".rstrip()


def spacing(steps: Sequence[Follower]) -> str:
    """How far apart some events are: `every 90 deg`, each interval where there are few, else the least and the greatest."""
    if are_even(steps):
        return f"every {number(steps[0].interval_deg, digits=4)} deg"
    apart = [step.interval_deg for step in steps]
    shown = [number(one, digits=3) for one in (apart if len(apart) <= MOST_INTERVALS else (min(apart), max(apart)))]
    return f"{'-'.join(shown) if len(apart) <= MOST_INTERVALS else ' to '.join(shown)} deg apart"


def brief_timing(found: WorkingCycle, engine: Engine) -> list[str]:
    """When intake and exhaust are open, in lines that fit a figure, a star at what is assumed."""
    apart = "TDC" if engine.cycle == "four-stroke" else "BDC"
    told = {
        name: f"{number(degrees(getattr(found.timing, name)), 180.0)}°{'*' if name in found.timing.assumed else ''}"
        for name in EVENTS
    }
    lines = [
        f"intake {told['intake_opens']} before {apart} to {told['intake_closes']} after BDC",
        f"exhaust {told['exhaust_opens']} before BDC to {told['exhaust_closes']} after {apart}",
    ]
    return lines + (["* assumed; the engine file does not say"] if found.timing.assumed else [])


def _front_to_rear(engine: Engine, chambers: Sequence[int]) -> list[int]:
    place = {chamber: pistons[0].z for chamber, pistons in engine.chambers.items()}
    return sorted(chambers, key=lambda number: -place[number])


def span_rows(found: WorkingCycle, chambers: Sequence[int]) -> list[dict[str, Any]]:
    """The spans of chambers in rows 0, 1, ..., cut where they run over the end of the cycle."""
    rows = []
    for row, chamber in enumerate(chambers):
        one = found.chamber(chamber)
        rest = Window(one.blow_down.end_deg, one.exhaust.end_deg)
        whole = {POWER: one.strokes[0].window, EXHAUST: rest, BLOW_DOWN: one.blow_down, INTAKE: one.intake}
        for what, window in whole.items():
            low, high = PLACES[what]
            begins = window.start_deg % found.cycle_deg
            within = Window(begins, begins + window.length_deg)
            for part in pieces(within, cycle_deg=found.cycle_deg):
                span = {"x": round(part.start_deg, 6), "end": round(part.end_deg, 6), "y": row + low, "foot": row + high}
                rows.append({**span, "what": what, "cylinder": chamber})
    return rows


def _panel(found: WorkingCycle, title: str, chambers: Sequence[int], height: float, turns: int, *, foot: bool) -> Panel:
    import altair as alt

    x = _across(turns, foot=foot)
    named = "[" + ", ".join(f"'{chamber}'" for chamber in chambers) + "]"
    axis = alt.Axis(
        values=[row + 0.5 for row in range(len(chambers))],
        labelExpr=f"{named}[floor(datum.value)]",
        ticks=False,
        domain=False,
        grid=False,
        labelPadding=10,
        labelOverlap=False,
    )
    y = alt.Y("y:Q", scale=alt.Scale(domain=[len(chambers), 0], nice=False, zero=False), axis=axis, title="cylinder")
    names = list(SPANS)
    legend = alt.Legend(
        orient="top", title=None, columns=2, columnPadding=22, symbolType="square", symbolSize=150, symbolStrokeWidth=0
    )
    colours = alt.Scale(domain=names, range=[_mixed(*SPANS[name]) for name in names])
    spans = of_rows(span_rows(found, chambers)).mark_rect(strokeWidth=0, opacity=1)
    spans = spans.encode(x=x, x2=alt.X2("end:Q"), y=y, y2=alt.Y2("foot:Q"), color=alt.Color("what:N", scale=colours, legend=legend))
    fires = [(row, found.chamber(chamber).fires_deg) for row, chamber in enumerate(chambers)]
    marks = [{"x": angle, "y": row + 0.5} for row, angle in fires]
    marks += [{"x": found.cycle_deg, "y": row + 0.5} for row, angle in fires if angle == 0]
    bolts = of_rows(marks).mark_point(shape=BOLT, filled=True, opacity=1, size=14 * height, color=GREY, strokeWidth=0)
    turned = of_rows([{}]).transform_calculate(x=f"theta - {360 * turns} * floor(theta / {360 * turns + 1e-6})")
    rule = turned.mark_rule(color=GREY, strokeWidth=1.6, strokeDash=[3, 2]).encode(x=x)
    return layered([spans, bolts.encode(x=x, y=y), rule], width=WIDTH, height=height * len(chambers), title=title)


def _mixed(colour: str, opacity: float) -> str:
    """A colour that lets the page shine through."""
    red, green, blue = (int(colour[place : place + 2], 16) for place in (1, 3, 5))
    return f"rgba({red}, {green}, {blue}, {opacity:g})"


def _across(turns: int, *, foot: bool) -> Any:
    """The crank angle over one cycle; every other line has its number."""
    import altair as alt

    axis = alt.Axis(
        values=list(range(0, 360 * turns + 1, 45 * turns)),
        labels=foot,
        labelExpr=f"datum.value % {90 * turns} == 0 ? datum.label : ''",
        labelOverlap=False,
    )
    scale = alt.Scale(domain=[0, 360 * turns], nice=False)
    return alt.X("x:Q", scale=scale, axis=axis, title="crank angle θ (degrees)" if foot else None)


def _empty(turns: int) -> Panel:
    import altair as alt

    said = (
        of_rows([{"x": 180 * turns}])
        .mark_text(fontSize=13, color=GREY)
        .encode(x=_across(turns, foot=True), text=alt.TextValue(NO_ORDER))
    )
    rule = of_rows([{}]).transform_calculate(x=f"theta - {360 * turns} * floor(theta / {360 * turns + 1e-6})")
    return layered(
        [said, rule.mark_rule(color=GREY, strokeDash=[3, 2]).encode(x=_across(turns, foot=True))], width=WIDTH, height=60
    )
