"""Valve and port timing: the values of the file, assumed values, impossible ones.

Angles are those of the crank of a chamber's own piston, measured from its dead centres. In a
four-stroke engine the intake opens before top and closes after bottom dead centre, the exhaust
opens before bottom and closes after top dead centre. In a two-stroke engine all four are about
bottom dead centre, and the intake is the ports through which the fresh charge comes.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Iterator
from dataclasses import dataclass
from math import degrees, pi, radians
from typing import Any

from crankstar.engine.quantities import Cycle
from crankstar.engine.records import Valves
from crankstar.language.faults import Fault

EVENTS = ("intake_opens", "intake_closes", "exhaust_opens", "exhaust_closes")
"""The angles of a `[valves]` table."""
ASSUMED: dict[Cycle, dict[str, float]] = {
    "four-stroke": {
        name: radians(angle) for name, angle in zip(EVENTS, (15.0, 50.0, 50.0, 15.0), strict=True)
    },
    "two-stroke": {
        name: radians(angle) for name, angle in zip(EVENTS, (60.0, 60.0, 85.0, 85.0), strict=True)
    },
}
"""Assumed angles where a file gives none, radians: four-stroke valves, two-stroke ports."""
SHORTEST, LONGEST = radians(10.0), 2 * pi
"""Radians: no valve or port is open for less, nor for more."""
GREATEST_BOTH_OPEN = pi
"""Radians through which both valves of a four-stroke engine can be open; racing engines < 2."""
_SLACK = 1e-9


@dataclass(frozen=True)
class Timing:
    """Opening and closing of intake and exhaust, radians; the names of the assumed angles."""

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
    return Timing(
        **(ASSUMED[cycle] | given), assumed=tuple(name for name in EVENTS if name not in given)
    )


def faults(valves: Valves | None, *, cycle: Cycle, chambers: Collection[int]) -> Iterator[Fault]:
    """What is wrong with the valves or the manifolds of an engine with these chambers."""
    if valves is None:
        return
    wild = [name for name in EVENTS if abs(getattr(valves, name) or 0.0) > pi + _SLACK]
    for name in wild:
        usual = round(degrees(ASSUMED[cycle][name]))
        values = {"value": degrees(getattr(valves, name)), "example": usual}
        yield Fault(("valves", name), "valves.angle", values)
    if not wild:
        yield from _open_faults(valves, cycle)
    yield from _manifold_faults(valves.manifolds, set(chambers))


def _open_faults(valves: Valves, cycle: Cycle) -> Iterator[Fault]:
    """Valves that never open, never close, or are open both at once for most of a turn."""
    angles = timing(valves, cycle=cycle)
    stroke = pi if cycle == "four-stroke" else 0.0
    for side in ("intake", "exhaust"):
        opens, closes = f"{side}_opens", f"{side}_closes"
        length = getattr(angles, opens) + stroke + getattr(angles, closes)
        if SHORTEST - _SLACK <= length <= LONGEST + _SLACK:
            continue
        values: dict[str, Any] = {"side": side, "length": degrees(length)}
        values |= {"opens": opens, "closes": closes}
        values |= {
            f"usual_{event}": round(degrees(ASSUMED[cycle][f"{side}_{event}"]))
            for event in ("opens", "closes")
        }
        assumed = next((name for name in (opens, closes) if name in angles.assumed), None)
        if assumed is None:
            yield Fault(("valves", closes), "valves.open-too-long", values)
            continue
        values |= {"assumed": assumed, "assumed_angle": round(degrees(getattr(angles, assumed)))}
        place = opens if assumed == closes else closes
        yield Fault(("valves", place), "valves.open-too-long-assumed", values)
    both = angles.intake_opens + angles.exhaust_closes
    if cycle == "four-stroke" and both > GREATEST_BOTH_OPEN + _SLACK:
        place = "intake_opens" if "intake_opens" not in angles.assumed else "exhaust_closes"
        yield Fault(("valves", place), "valves.overlap", {"overlap": degrees(both)})


def _manifold_faults(manifolds: tuple[tuple[int, ...], ...], chambers: set[int]) -> Iterator[Fault]:
    counts = Counter(number for manifold in manifolds for number in manifold)
    known = {"chambers": sorted(chambers)}
    for index, manifold in enumerate(manifolds):
        here = ("valves", "manifolds", index)
        if not manifold:
            yield Fault(here, "manifold.empty")
        foreign = sorted(set(manifold) - chambers)
        if foreign:
            values = {"numbers": foreign, "count": len(foreign), **known}
            yield Fault(here, "manifold.no-such-cylinder", values)
    twice = sorted(number for number, count in counts.items() if count > 1)
    if twice:
        values = {"numbers": twice, "count": len(twice)}
        yield Fault(("valves", "manifolds"), "manifold.repeated", values)
    missing = sorted(chambers - set(counts))
    if manifolds and missing:
        values = {"numbers": missing, "count": len(missing), "first": missing[0]}
        yield Fault(("valves", "manifolds"), "manifold.incomplete", values)
