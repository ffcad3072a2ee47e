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
from itertools import permutations
from math import degrees
from typing import Literal, NamedTuple

from crankstar.engine.dead_centres import DeadCentre, bottom_dead_centres, dead_centres
from crankstar.engine.engine import Engine
from crankstar.engine.quantities import Cycle
from crankstar.engine.valves import Timing, timing
from crankstar.firing.intervals import Firing, firing
from crankstar.firing.succession import Follower, once_round
from crankstar.language.faults import EngineError, Fault

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
        return next(one for one in self.chambers if one.number == number)


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
    fired = firing(engine)
    tops, bottoms = dead_centres(engine), bottom_dead_centres(engine)
    turns = 2 if engine.cycle == "four-stroke" else 1
    _checked(tops, fired.cycle_deg / turns, engine.cycle)
    found = timing(engine.valves, cycle=engine.cycle)
    angles = dict(zip(fired.order, fired.angles_deg, strict=True))
    chambers = []
    for number in engine.chambers:
        down = (bottoms[number].angle_deg - tops[number].angle_deg) % tops[number].period_deg
        work = _four_strokes if engine.cycle == "four-stroke" else _two_strokes
        chambers.append(
            work(
                number, angles[number], down_deg=down, turn_deg=tops[number].period_deg, found=found
            )
        )
    return WorkingCycle(fired, found, tuple(chambers))


def _checked(tops: dict[int, DeadCentre], turn_deg: float, cycle: Cycle) -> None:
    """Refuse chambers that do not come to top dead centre once for every two strokes."""
    astray = [number for number, top in tops.items() if abs(top.period_deg - turn_deg) > EVEN]
    if astray:
        values = {
            "numbers": astray,
            "period": tops[astray[0]].period_deg,
            "cycle_name": cycle,
            "turn": turn_deg,
        }
        raise EngineError([Fault(("cylinders",), "strokes.different-periods", values)])


def _four_strokes(
    number: int, fires: float, *, down_deg: float, turn_deg: float, found: Timing
) -> ChamberStrokes:
    bottom, top, cycle = fires + down_deg, fires + turn_deg, 2 * turn_deg
    ends = (fires, bottom, top, top + down_deg, fires + cycle)
    names: tuple[StrokeName, ...] = ("power", "exhaust", "intake", "compression")
    opens = bottom - degrees(found.exhaust_opens)
    return ChamberStrokes(
        number,
        _window(fires, fires, cycle).start_deg,
        tuple(
            Stroke(name, _window(a, b, cycle))
            for name, a, b in zip(names, ends, ends[1:], strict=False)
        ),
        _window(
            top - degrees(found.intake_opens), top + down_deg + degrees(found.intake_closes), cycle
        ),
        _window(opens, top + degrees(found.exhaust_closes), cycle),
        _window(opens, bottom, cycle),
    )


def _two_strokes(
    number: int, fires: float, *, down_deg: float, turn_deg: float, found: Timing
) -> ChamberStrokes:
    bottom, cycle = fires + down_deg, turn_deg
    opens, closes = bottom - degrees(found.exhaust_opens), bottom + degrees(found.exhaust_closes)
    scavenged = bottom - degrees(found.intake_opens)
    return ChamberStrokes(
        number,
        _window(fires, fires, cycle).start_deg,
        (
            Stroke("power", _window(fires, bottom, cycle)),
            Stroke("compression", _window(bottom, fires + cycle, cycle)),
        ),
        _window(scavenged, bottom + degrees(found.intake_closes), cycle),
        _window(opens, closes, cycle),
        _window(opens, min(scavenged, closes), cycle),
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
            ExhaustGroup(f"manifold {', '.join(map(str, one))}", one)
            for one in engine.valves.manifolds
        )
    first = {pistons[0].number: number for number, pistons in engine.chambers.items()}
    groups = [
        ExhaustGroup(name if name.startswith(("bank", "row")) else f"bank {name}", chambers)
        for name, numbers in engine.banks.items()
        if (chambers := tuple(first[number] for number in numbers if number in first))
    ]
    return (
        tuple(groups) if len(groups) > 1 else (ExhaustGroup("all cylinders", groups[0].chambers),)
    )


def exhaust_intervals(found: WorkingCycle, group: Sequence[int]) -> tuple[Follower, ...]:
    """Each exhaust opening in a group and the next one, once round the cycle.

    They are the intervals between the firings, but where bottom dead centre comes later after one
    top than after another.

    >>> from crankstar.files.catalog import load
    >>> [step.interval_deg for step in exhaust_intervals(working_cycle(load("v8-cross-plane")), (1, 3, 5, 7))]
    [270.0, 180.0, 90.0, 180.0]
    """
    events = []
    for number, angle in zip(found.firing.order, found.firing.angles_deg, strict=True):
        if number in group:
            one = found.chamber(number)
            events.append(
                (number, angle + (one.exhaust.start_deg - one.fires_deg) % found.cycle_deg)
            )
    return once_round(sorted(events, key=lambda event: event[1]), cycle_deg=found.cycle_deg)


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


def common(one: Sequence[Window], other: Sequence[Window]) -> tuple[Window, ...]:
    """What two sets of windows within the cycle have in common."""
    both = (
        Window(max(a.start_deg, b.start_deg), min(a.end_deg, b.end_deg)) for a in one for b in other
    )
    return tuple(window for window in both if window.length_deg > 0)


def length_deg(windows: Sequence[Window]) -> float:
    """How long windows are together, degrees."""
    return round(sum((window.length_deg for window in windows), 0.0), 9)


def disturbances(found: WorkingCycle, group: Sequence[int]) -> tuple[Disturbance, ...]:
    """Blow-down into the open exhaust of another chamber of the group, in firing order.

    >>> from crankstar.files.catalog import load
    >>> cycle = working_cycle(load("v8-cross-plane"))

    Chamber 7 blows down into the exhaust of 5, which opened 90 deg before:

    >>> [one for one in disturbances(cycle, (1, 3, 5, 7)) if one.blowing == 7]
    [Disturbance(blowing=7, disturbed=5, exhaust_open_deg=50.0, both_open_deg=0.0)]
    """
    cycle = found.cycle_deg
    members = [found.chamber(number) for number in found.firing.order if number in group]
    blows = {one.number: pieces(one.blow_down, cycle_deg=cycle) for one in members}
    flows = {
        one.number: pieces(
            _window(one.blow_down.end_deg, one.exhaust.end_deg, cycle), cycle_deg=cycle
        )
        for one in members
    }
    both = {
        one.number: common(flows[one.number], pieces(one.intake, cycle_deg=cycle))
        for one in members
    }
    out = []
    for one, other in permutations([member.number for member in members], 2):
        open_deg = length_deg(common(blows[one], flows[other]))
        if open_deg > EVEN:
            out.append(
                Disturbance(one, other, open_deg, length_deg(common(blows[one], both[other])))
            )
    return tuple(out)
