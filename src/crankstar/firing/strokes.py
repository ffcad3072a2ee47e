"""Strokes of each cylinder, opening and closing of valves or ports, common exhausts.

A chamber fires at the crank angle f that `firing` finds, has its dead centres every period P (one
turn of its crankshaft), and its bottom dead centre d after its top one; d is 180 deg only where no
cylinder axis is offset and no rod articulated. With the angles of `valves` (i.o., i.c., e.o.,
e.c.), in degrees of crank angle:

    four-stroke   power f to f+d, exhaust to f+P, intake to f+P+d, compression to f+2P
                  exhaust open   f+d - e.o.   to  f+P + e.c.
                  intake open    f+P - i.o.   to  f+P+d + i.c.
    two-stroke    power f to f+d, compression to f+P
                  exhaust open   f+d - e.o.   to  f+d + e.c.
                  intake open    f+d - i.o.   to  f+d + i.c.

The *blow-down* is what the exhaust does by the pressure of the gas alone: from the opening of the
exhaust to bottom dead centre in a four-stroke engine, to the opening of the intake in a two-stroke
one. It disturbs another cylinder of the same manifold whose exhaust is open and past its own
blow-down, most of all where that one's intake is open as well.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from itertools import pairwise, permutations
from math import degrees
from typing import Literal, NamedTuple

from crankstar.engine.dead_centres import DeadCentre, bottom_dead_centres, dead_centres
from crankstar.engine.engine import Engine
from crankstar.engine.quantities import Cycle
from crankstar.engine.valves import Timing, timing
from crankstar.firing.intervals import Firing, firing
from crankstar.firing.succession import Follower, once_round
from crankstar.language.faults import EngineError, Fault
from crankstar.language.messages import _

StrokeName = Literal["power", "exhaust", "intake", "compression"]
EVEN = 1e-3
"""Degrees: intervals that differ by less are equal."""


class Window(NamedTuple):
    """A span of crank angle (degrees) that begins within the cycle and may end in the next."""

    start_deg: float
    end_deg: float

    @property
    def length_deg(self) -> float:
        """How long it is."""
        return self.end_deg - self.start_deg


class Stroke(NamedTuple):
    """One way of a piston from dead centre to dead centre, and what it is for."""

    name: StrokeName
    window: Window


@dataclass(frozen=True)
class ChamberStrokes:
    """What one combustion chamber does in a cycle, from the top dead centre at which it fires."""

    number: int
    fires_deg: float
    strokes: tuple[Stroke, ...]
    intake: Window
    exhaust: Window
    blow_down: Window


@dataclass(frozen=True)
class WorkingCycle:
    """The strokes of all chambers in the engine's order, and their valve timing."""

    firing: Firing
    timing: Timing
    chambers: tuple[ChamberStrokes, ...]

    @property
    def cycle_deg(self) -> float:
        """Degrees of the reference crankshaft in one cycle: 360 or 720."""
        return self.firing.cycle_deg

    def chamber(self, number: int) -> ChamberStrokes:
        """What the chamber of that number does."""
        return next(chamber for chamber in self.chambers if chamber.number == number)


class ExhaustGroup(NamedTuple):
    """Chambers with a common exhaust: those of a bank, or of a manifold in the file."""

    name: str
    chambers: tuple[int, ...]


class Disturbance(NamedTuple):
    """One chamber blows down into the open exhaust of another, for some degrees.

    The other is past its own blow-down.

    `both_open_deg` of them fall into the valve overlap of the disturbed one, when its intake is
    open as well.
    """

    blowing: int
    disturbed: int
    exhaust_open_deg: float
    both_open_deg: float


@lru_cache(maxsize=64)
def working_cycle(engine: Engine) -> WorkingCycle:
    """The strokes and valve events of every chamber.

    Raises EngineError without a firing order, or where there are no strokes.

    >>> from crankstar.files.catalog import load
    >>> third = working_cycle(load("i4")).chamber(3)
    >>> [(stroke.name, stroke.window.start_deg) for stroke in third.strokes]
    [('power', 180.0), ('exhaust', 360.0), ('intake', 540.0), ('compression', 0.0)]
    >>> third.exhaust
    Window(start_deg=310.0, end_deg=555.0)
    """
    if not engine.firing_order:
        raise EngineError([Fault(("firing_order",), "strokes.no-firing-order")])
    if astray := without_common_cycle(engine):
        raise EngineError([astray])
    fired = firing(engine)
    tops, bottoms = dead_centres(engine), bottom_dead_centres(engine)
    events = timing(engine.valves, cycle=engine.cycle)
    angles = dict(zip(fired.order, fired.angles_deg, strict=True))
    chambers = tuple(
        _strokes(number, angles[number], tops[number], bottoms[number], events, engine.cycle)
        for number in engine.chambers
    )
    return WorkingCycle(fired, events, chambers)


def without_common_cycle(engine: Engine) -> Fault | None:
    """Why the chambers have no cycle in common: some come to top dead centre more or less often.

    >>> from crankstar.files.catalog import load
    >>> without_common_cycle(load("kr250-racer"))
    """
    turn = engine.cycle_angle / (2 if engine.cycle == "four-stroke" else 1)
    periods = {number: top.period_deg for number, top in dead_centres(engine).items()}
    astray = [number for number, period in periods.items() if abs(period - turn) > EVEN]
    if not astray:
        return None
    values = {
        "count": len(astray),
        "numbers": astray,
        "period": periods[astray[0]],
        "cycle_name": engine.cycle,
        "turn": turn,
    }
    return Fault(("cylinders",), "strokes.different-periods", values)


def _strokes(
    number: int, fires: float, top: DeadCentre, bottom: DeadCentre, events: Timing, kind: Cycle
) -> ChamberStrokes:
    turn = top.period_deg
    down = (bottom.angle_deg - top.angle_deg) % turn
    names: tuple[StrokeName, ...] = ("power", "compression")
    # at these dead centres intake and exhaust open and close
    intake_opens = intake_closes = exhaust_opens = exhaust_closes = fires + down
    if kind == "four-stroke":
        names = ("power", "exhaust", "intake", "compression")
        intake_opens = exhaust_closes = fires + turn
        intake_closes = fires + turn + down
    intake_opens -= degrees(events.intake_opens)
    intake_closes += degrees(events.intake_closes)
    exhaust_opens -= degrees(events.exhaust_opens)
    exhaust_closes += degrees(events.exhaust_closes)
    blown = fires + down if kind == "four-stroke" else min(intake_opens, exhaust_closes)
    cycle = turn * len(names) / 2
    ends = [fires + turn * (j // 2) + down * (j % 2) for j in range(len(names) + 1)]
    return ChamberStrokes(
        number,
        _window(fires, fires, cycle).start_deg,
        tuple(
            Stroke(name, _window(a, b, cycle))
            for name, (a, b) in zip(names, pairwise(ends), strict=True)
        ),
        _window(intake_opens, intake_closes, cycle),
        _window(exhaust_opens, exhaust_closes, cycle),
        _window(exhaust_opens, blown, cycle),
    )


def _window(start: float, end: float, cycle: float) -> Window:
    """From `start` to `end`, beginning within the cycle; empty if it would end before it begins."""
    begins = round(start, 9) % cycle
    return Window(begins, round(begins + max(end - start, 0.0), 9))


def exhaust_groups(engine: Engine) -> tuple[ExhaustGroup, ...]:
    """Chambers with a common exhaust: the manifolds of the file, else the banks.

    A single bank is all cylinders.

    Where two pistons share a chamber it belongs to the bank of the one that is listed first.

    >>> from crankstar.files.catalog import load
    >>> exhaust_groups(load("v8-cross-plane"))[0]
    ExhaustGroup(name='bank odd', chambers=(1, 3, 5, 7))
    """
    if engine.valves is not None and engine.valves.manifolds:
        return tuple(
            ExhaustGroup(
                _("manifold {cylinders}", cylinders=", ".join(map(str, manifold))), manifold
            )
            for manifold in engine.valves.manifolds
        )
    first = {pistons[0].number: number for number, pistons in engine.chambers.items()}
    groups = [
        ExhaustGroup(_bank(name), chambers)
        for name, numbers in engine.banks.items()
        if (chambers := tuple(first[number] for number in numbers if number in first))
    ]
    return (
        tuple(groups)
        if len(groups) > 1
        else (ExhaustGroup(_("all cylinders"), groups[0].chambers),)
    )


def _bank(name: str) -> str:
    """What a bank is called: "bank left", "bank 1", "row 2"."""
    kind, _space, rest = name.partition(" ")
    if kind == "row" and rest:
        return _("row {name}", name=rest)
    return _("bank {name}", name=rest if kind == "bank" and rest else name)


def exhaust_intervals(strokes: WorkingCycle, group: Sequence[int]) -> tuple[Follower, ...]:
    """Each exhaust opening in a group and the next one, once round the cycle.

    They are the intervals between the firings, but where bottom dead centre comes later after one
    top than after another.

    >>> from crankstar.files.catalog import load
    >>> cycle = working_cycle(load("v8-cross-plane"))
    >>> [step.interval_deg for step in exhaust_intervals(cycle, (1, 3, 5, 7))]
    [270.0, 180.0, 90.0, 180.0]
    """
    events = []
    for number, angle in zip(strokes.firing.order, strokes.firing.angles_deg, strict=True):
        if number in group:
            chamber = strokes.chamber(number)
            events.append(
                (
                    number,
                    angle + (chamber.exhaust.start_deg - chamber.fires_deg) % strokes.cycle_deg,
                )
            )
    return once_round(sorted(events, key=lambda event: event[1]), cycle_deg=strokes.cycle_deg)


def are_even(steps: Sequence[Follower]) -> bool:
    """Whether all intervals are equal, to a thousandth of a degree."""
    intervals = [step.interval_deg for step in steps]
    return not intervals or max(intervals) - min(intervals) < EVEN


def pieces(window: Window, *, cycle_deg: float) -> tuple[Window, ...]:
    """A window as parts that each lie within the cycle: one, or two where it runs over the end.

    >>> pieces(Window(700.0, 730.0), cycle_deg=720.0)
    (Window(start_deg=700.0, end_deg=720.0), Window(start_deg=0.0, end_deg=10.0))
    """
    if window.end_deg <= cycle_deg:
        return (window,) if window.length_deg > 0 else ()
    return (Window(window.start_deg, cycle_deg), Window(0.0, round(window.end_deg - cycle_deg, 9)))


def common(windows: Sequence[Window], others: Sequence[Window]) -> tuple[Window, ...]:
    """What two sets of windows within the cycle have in common."""
    both = (
        Window(max(a.start_deg, b.start_deg), min(a.end_deg, b.end_deg))
        for a in windows
        for b in others
    )
    return tuple(window for window in both if window.length_deg > 0)


def length_deg(windows: Sequence[Window]) -> float:
    """How long windows are together, degrees."""
    return round(sum((window.length_deg for window in windows), 0.0), 9)


def disturbances(strokes: WorkingCycle, group: Sequence[int]) -> tuple[Disturbance, ...]:
    """Blow-down into the open exhaust of another chamber of the group, in firing order.

    >>> from crankstar.files.catalog import load
    >>> cycle = working_cycle(load("v8-cross-plane"))

    Chamber 7 blows down into the exhaust of 5, which opened 90 deg before:

    >>> [each for each in disturbances(cycle, (1, 3, 5, 7)) if each.blowing == 7]
    [Disturbance(blowing=7, disturbed=5, exhaust_open_deg=50.0, both_open_deg=0.0)]
    """
    cycle = strokes.cycle_deg
    members = [strokes.chamber(number) for number in strokes.firing.order if number in group]
    blows = {chamber.number: pieces(chamber.blow_down, cycle_deg=cycle) for chamber in members}
    flows = {
        chamber.number: pieces(
            _window(chamber.blow_down.end_deg, chamber.exhaust.end_deg, cycle), cycle_deg=cycle
        )
        for chamber in members
    }
    both = {
        chamber.number: common(flows[chamber.number], pieces(chamber.intake, cycle_deg=cycle))
        for chamber in members
    }
    out = []
    for blowing, disturbed in permutations([member.number for member in members], 2):
        open_deg = length_deg(common(blows[blowing], flows[disturbed]))
        if open_deg > EVEN:
            out.append(
                Disturbance(
                    blowing,
                    disturbed,
                    open_deg,
                    length_deg(common(blows[blowing], both[disturbed])),
                )
            )
    return tuple(out)
