"""When valves or ports are open: what a file says, what is assumed where it says nothing, and what cannot be.

Angles are those of the crank of a chamber's own piston, measured from its dead centres. In a four-stroke engine the intake
opens before top and closes after bottom dead centre, the exhaust opens before bottom and closes after top dead centre. In a
two-stroke engine all four are about bottom dead centre, and the intake is the ports through which the fresh charge comes.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Iterator
from dataclasses import dataclass
from math import degrees, pi, radians

from crankstar.fault import Fault, cylinders, listed
from crankstar.quantity import Cycle
from crankstar.records import Valves

EVENTS = ("intake_opens", "intake_closes", "exhaust_opens", "exhaust_closes")
"""The angles of a `[valves]` table."""
ASSUMED: dict[Cycle, dict[str, float]] = {
    "four-stroke": {name: radians(angle) for name, angle in zip(EVENTS, (15.0, 50.0, 50.0, 15.0), strict=True)},
    "two-stroke": {name: radians(angle) for name, angle in zip(EVENTS, (60.0, 60.0, 85.0, 85.0), strict=True)},
}
"""What is assumed where a file gives no angle, radians: common in four-stroke engines with valves, two-stroke ones with ports."""
SHORTEST, LONGEST = radians(10.0), 2 * pi
"""Radians: no valve or port is open for less, nor for more."""
GREATEST_BOTH_OPEN = pi
"""Radians through which both valves of a four-stroke engine can be open; the hottest racing engines have less than 2."""
_SLACK = 1e-9


@dataclass(frozen=True)
class Timing:
    """When intake and exhaust open and close, radians as in an engine file, and the names of the angles that are assumed."""

    intake_opens: float
    intake_closes: float
    exhaust_opens: float
    exhaust_closes: float
    assumed: tuple[str, ...] = ()


def timing(valves: Valves | None, *, cycle: Cycle) -> Timing:
    """The angles of a file, and typical ones where it gives none.

    >>> found = timing(Valves(exhaust_opens=1.0), cycle="four-stroke")
    >>> found.exhaust_opens, round(degrees(found.intake_closes)), found.assumed
    (1.0, 50, ('intake_opens', 'intake_closes', 'exhaust_closes'))
    """
    given = {name: angle for name in EVENTS if (angle := getattr(valves, name, None)) is not None}
    return Timing(**(ASSUMED[cycle] | given), assumed=tuple(name for name in EVENTS if name not in given))


def faults(valves: Valves | None, *, cycle: Cycle, chambers: Collection[int]) -> Iterator[Fault]:
    """What is wrong with the valves or the manifolds of an engine with these chambers."""
    if valves is None:
        return
    wild = [name for name in EVENTS if abs(getattr(valves, name) or 0.0) > pi + _SLACK]
    for name in wild:
        angle = degrees(getattr(valves, name))
        told = f'is {angle:.6g} deg; it must lie between -180 and 180 deg, such as "{degrees(ASSUMED[cycle][name]):.0f} deg"'
        yield Fault(("valves", name), told)
    if not wild:
        yield from _open_faults(valves, cycle)
    yield from _manifold_faults(valves.manifolds, set(chambers))


def _open_faults(valves: Valves, cycle: Cycle) -> Iterator[Fault]:
    """Valves that never open, never close, or are open both at once for most of a turn."""
    found = timing(valves, cycle=cycle)
    stroke = pi if cycle == "four-stroke" else 0.0
    for side in ("intake", "exhaust"):
        opens, closes = f"{side}_opens", f"{side}_closes"
        length = getattr(found, opens) + stroke + getattr(found, closes)
        if not SHORTEST - _SLACK <= length <= LONGEST + _SLACK:
            other = f" ({_assumed(found, opens, closes)})" if {opens, closes} & set(found.assumed) else ""
            yield Fault(
                ("valves", closes if closes not in found.assumed else opens),
                f"makes the {side} open for {degrees(length):.6g} deg{other}; it must be from 10 to 360 deg, "
                f"such as {opens} = {_text(cycle, opens)}, {closes} = {_text(cycle, closes)}",
            )
    both = found.intake_opens + found.exhaust_closes
    if cycle == "four-stroke" and both > GREATEST_BOTH_OPEN + _SLACK:
        place = "intake_opens" if "intake_opens" not in found.assumed else "exhaust_closes"
        told = f"makes intake and exhaust open together for {degrees(both):.6g} deg; it must be at most 180 deg, 30 deg are usual"
        yield Fault(("valves", place), told)


def _assumed(found: Timing, *names: str) -> str:
    return ", ".join(f"{name} assumed to be {degrees(getattr(found, name)):.0f} deg" for name in names if name in found.assumed)


def _text(cycle: Cycle, name: str) -> str:
    return f'"{degrees(ASSUMED[cycle][name]):.0f} deg"'


def _manifold_faults(manifolds: tuple[tuple[int, ...], ...], chambers: set[int]) -> Iterator[Fault]:
    counts = Counter(number for manifold in manifolds for number in manifold)
    for index, manifold in enumerate(manifolds):
        here = ("valves", "manifolds", index)
        if not manifold:
            yield Fault(here, "has no cylinders; name those whose exhausts meet in it, or leave it out")
        foreign = sorted(set(manifold) - chambers)
        if foreign:
            there = "are" if len(chambers) > 1 else "is"
            yield Fault(here, f"has {cylinders(foreign)}, and there is no such cylinder; there {there}: {listed(sorted(chambers))}")
    twice = sorted(number for number, count in counts.items() if count > 1)
    if twice:
        yield Fault(("valves", "manifolds"), f"has {cylinders(twice)} more than once; each leads into one manifold")
    missing = sorted(chambers - set(counts))
    if manifolds and missing:
        example = f"[{missing[0]}]"
        yield Fault(
            ("valves", "manifolds"), f"misses {cylinders(missing)}; each leads into one manifold, a pipe of its own is {example}"
        )
