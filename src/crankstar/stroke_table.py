"""Strokes, valve events, exhaust intervals and who disturbs whom, as tables for the terminal."""

from __future__ import annotations

from collections.abc import Sequence

from rich.console import Group, RenderableType
from rich.text import Text

from crankstar.engine import Engine
from crankstar.fault import EngineError, Fault
from crankstar.firing import Firing
from crankstar.strokes import (
    EVEN,
    ChamberStrokes,
    ExhaustGroup,
    Window,
    WorkingCycle,
    are_even,
    disturbances,
    exhaust_groups,
    exhaust_intervals,
    working_cycle,
)
from crankstar.succession import Follower, in_succession, neighbours, partners
from crankstar.wording import heading, number, table, timing_lines, titled

ALONE = "Every cylinder has an exhaust of its own; valves.manifolds = [[1, 2], ...] in the engine file joins them."
NO_ORDER = (
    "is missing, and without it nobody knows which stroke a cylinder is on; `crankstar orders` with this engine lists the orders "
    "that its crank can fire: give one, as in firing_order = [1, 3, 4, 2]"
)
"""What is said of an engine file that has no firing order."""


def stroke_tables(engine: Engine) -> RenderableType:
    """The working cycle of an engine as tables. Raises EngineError as `strokes.working_cycle`."""
    if not engine.firing_order:
        raise EngineError([Fault(("firing_order",), NO_ORDER)])
    found = working_cycle(engine)
    groups = exhaust_groups(engine)
    lines = [_ring(found.firing), *timing_lines(engine)]
    if found.timing.assumed:
        lines.append(f"assumed: typical angles of {engine.cycle} engines, for want of this one's own in the file ([valves])")
    blocks: list[RenderableType] = [heading(engine), *(Text(line) for line in lines), _cylinders(found, groups)]
    if all(len(group.chambers) == 1 for group in groups):
        blocks += [Text(), Text(ALONE), Text()]
    else:
        blocks += [_exhausts(found, groups), _disturbances(found, groups)]
    for title, pairs in (("Neighbours that fire one after the other", neighbours), ("On one pin, one after the other", partners)):
        steps = in_succession(found.firing, pairs(engine))
        blocks.append(Text(f"{title}: {succession_text(steps)}."))
    return Group(*blocks)


def succession_text(steps: Sequence[Follower]) -> str:
    """Firings and the next ones with the angle between them: `5-7 (90 deg)`; `none` where there are none."""
    return ", ".join(f"{step.first}-{step.then} ({number(step.interval_deg, 720.0)} deg)" for step in steps) or "none"


def _ring(fired: Firing) -> str:
    """Where each cylinder stands on the firing ring, and whether the firing is even."""
    even = "even firing" if fired.even else f"odd firing, {number(fired.cycle_deg / len(fired.order))} deg would be even"
    if len(fired.order) > 1 and max(fired.intervals_deg) > fired.cycle_deg - EVEN:
        even = "all fire together"
    places = ", ".join(f"{n} at {number(a % fired.cycle_deg, 720.0)}" for n, a in zip(fired.order, fired.angles_deg, strict=True))
    return f"{even}; round the firing ring of {fired.cycle_deg:.0f} deg: {places}"


def _cylinders(found: WorkingCycle, groups: Sequence[ExhaustGroup]) -> RenderableType:
    """Every stroke and every event, as spans of crank angle."""
    names = [stroke.name for stroke in found.chambers[0].strokes]
    heads = ["cylinder", "exhaust", *names, "exhaust open", "blow-down", "intake open"]
    out = table(*heads, left=("exhaust",))
    home = {number: group.name for group in groups for number in group.chambers}
    for one in sorted(found.chambers, key=lambda one: one.number):
        spans = [_span(window, found.cycle_deg) for window in _windows(one)]
        out.add_row(str(one.number), Text(home[one.number]), *spans)
    return titled("Strokes and events, in degrees of crank angle", out)


def _windows(one: ChamberStrokes) -> list[Window]:
    return [*(stroke.window for stroke in one.strokes), one.exhaust, one.blow_down, one.intake]


def _span(window: Window, cycle: float) -> str:
    """A span of crank angle, its end counted within the cycle."""
    if window.length_deg <= 0:
        return "none"
    end = window.end_deg if window.end_deg <= cycle else window.end_deg - cycle
    return f"{number(window.start_deg, 720.0)}–{number(end, 720.0)}"


def _exhausts(found: WorkingCycle, groups: Sequence[ExhaustGroup]) -> RenderableType:
    """The order in which the exhausts of a group open, and the intervals between them."""
    out = table("exhaust", "cylinders", "intervals [deg]", "", left=("exhaust", "cylinders", "intervals [deg]", ""))
    for group in groups:
        steps = exhaust_intervals(found, group.chambers)
        intervals = "-".join(number(step.interval_deg, digits=4) for step in steps)
        even = "" if len(steps) == 1 else "even" if are_even(steps) else "uneven"
        out.add_row(Text(group.name), "-".join(str(step.first) for step in steps), intervals, even)
    return titled("Exhaust pulses", out)


def _disturbances(found: WorkingCycle, groups: Sequence[ExhaustGroup]) -> RenderableType:
    """Blow-downs that meet an open exhaust."""
    rows = [one for group in groups for one in disturbances(found, group.chambers)]
    if not rows:
        return Group(Text(), Text("No cylinder blows down into another's open exhaust."), Text())
    heads = ("cylinder", "blows down into", "its exhaust open [deg]", "its intake open too [deg]")
    out = table(*heads)
    for one in rows:
        out.add_row(str(one.blowing), str(one.disturbed), number(one.exhaust_open_deg), number(one.both_open_deg))
    return Group(titled("Blow-down into an open exhaust", out), Text())
