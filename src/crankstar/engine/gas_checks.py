"""What must hold of the gas of an engine: one load, possible angles, a trace of a whole cycle."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from itertools import pairwise
from math import degrees, pi, radians
from typing import Any

from crankstar.engine.drive import Drive, mean_share
from crankstar.engine.gas import LOADS, Gas, Load, Trace
from crankstar.engine.quantities import Cycle
from crankstar.language.faults import Fault

Path = tuple[str | int, ...]
LEAST_SAMPLES = 36
"""Of a trace: every 10 or 20 degrees; fewer say nothing of combustion."""
GREATEST_STEP = radians(30.0)
"""Between samples of a trace."""
LEAST_PEAK, GREATEST_PEAK = 2e5, 5e7
"""Pa: the peak of a trace, and of any cycle, is within."""
GREATEST_MEAN = 6e6
"""Pa: no engine has a greater mean effective pressure."""
GREATEST_JUMP = 0.25
"""Of the range of a trace, from its last sample to its first."""
LEAST_RISE = 2.0
"""Greatest over least pressure of a trace: compression alone is more."""
FARTHEST_PEAK = pi / 2
"""Radians from the dead centre of firing to the peak of a trace."""
SAME_ANGLE = radians(1e-4)
"""Radians: of a sample that repeats the first, as angles are written."""
LATEST_START = pi / 2
LONGEST_COMBUSTION = pi
_SLACK = 1e-9
UNEVEN = 1.5
"""Of the other gaps of a load course in the mean, from which one is a part that is left out."""
END = radians(1.0)
"""Up to which the ends of a course are those of the cycle."""
LISTED = 8
"""Angles that a sentence lists."""


def faults(gas: Gas | None, *, cycle: Cycle, chambers: Collection[int]) -> Iterator[Fault]:
    """What is wrong with the gas of an engine with these chambers."""
    if gas is None:
        return
    yield from _load_faults(gas, gas, ("gas",))
    yield from _idle_faults(gas, gas, ("gas",))
    yield from _friction_faults(gas)
    for index, point in enumerate(gas.points):
        yield from _load_faults(point, gas, ("gas", "point", index))
        yield from _idle_faults(point, gas, ("gas", "point", index))
        if any(other.name == point.name for other in gas.points[:index]):
            yield Fault(("gas", "point", index, "name"), "gas.same-name", {"name": point.name})
    if gas.trace is None:
        return
    if gas.process is not None:
        yield Fault(("gas", "process"), "gas.trace-and-process")
    places: list[tuple[Path, Load]] = [(("gas",), gas)]
    places += [(("gas", "point", index), point) for index, point in enumerate(gas.points)]
    for path, load in places:
        for name in LOADS:
            if getattr(load, name) is not None:
                yield Fault((*path, name), "gas.trace-and-load")
    yield from _trace_faults(gas.trace, cycle, chambers)


_OF_COMBUSTION = ("combustion_start", "combustion_duration", "wiebe_a", "wiebe_m")
_OF_RELEASE = (*_OF_COMBUSTION, "variable_gamma", "wall_temperature")
"""Keys of a heat release, which an ideal cycle does not have."""


def _idle_faults(load: Load, gas: Gas, path: Path) -> Iterator[Fault]:
    """Keys that nothing would come of."""
    values = {name: getattr(load, name, None) for name in _OF_RELEASE}
    given = [name for name, value in values.items() if value is not None and value is not False]
    if gas.process not in (None, "heat-release"):
        for name in given:
            yield Fault((*path, name), "gas.not-of-process", {"process": gas.process})
        return
    if gas.trace is not None:
        for name in given:
            if name in _OF_COMBUSTION:
                yield Fault((*path, name), "gas.not-of-trace")
        heated = gas.variable_gamma or gas.wall_temperature is not None
        if isinstance(load, Gas) and load.intake_temperature is not None and not heated:
            yield Fault((*path, "intake_temperature"), "gas.warm-beside-trace")
        return
    if isinstance(load, Gas) and load.gamma is not None and load.variable_gamma:
        yield Fault((*path, "gamma"), "gas.gamma-twice")


def _friction_faults(gas: Gas) -> Iterator[Fault]:
    if gas.friction is not None and gas.friction_pressure is not None:
        yield Fault(("gas", "friction"), "gas.friction-twice")


def drive_faults(
    drive: Drive | None, *, cycle: Cycle, crankshafts: Sequence[str]
) -> Iterator[Fault]:
    """What is wrong with load and gears of an engine with crankshafts of these names."""
    if drive is None:
        return
    yield from _gear_faults(drive, crankshafts)
    yield from _course_faults(drive, cycle)


def _gear_faults(drive: Drive, crankshafts: Sequence[str]) -> Iterator[Fault]:
    """An output that is no crankshaft, or is none and one; shares of more than there is."""
    if drive.output is not None and drive.gearing == "output":
        yield Fault(("drive", "output"), "drive.output-and-gears")
    elif drive.output is not None and drive.output not in crankshafts:
        values = {"name": drive.output, "names": ", ".join(crankshafts)}
        yield Fault(("drive", "output"), "drive.no-such-crankshaft", values)
    shares = drive.inertia_shares
    if shares and len(shares) != len(crankshafts):
        values = {"count": len(shares), "crankshafts": len(crankshafts)}
        yield Fault(("drive", "inertia_shares"), "drive.shares", values)
    elif sum(shares) > 1 + _SLACK:
        yield Fault(("drive", "inertia_shares"), "drive.too-great-shares", {"sum": sum(shares)})


def _course_faults(drive: Drive, cycle: Cycle) -> Iterator[Fault]:
    """A load that does not go over the cycle, or takes nothing."""
    if not (drive.load_angle or drive.load_torque):
        return
    angle, whole = drive.load_angle, 2 * pi if cycle == "two-stroke" else 4 * pi
    if len(angle) != len(drive.load_torque):
        values = {"count": len(drive.load_torque), "angles": len(angle)}
        yield Fault(("drive", "load_torque"), "drive.lengths", values)
    elif any(b <= a for a, b in pairwise(angle)) or angle[-1] - angle[0] > whole + _SLACK:
        yield Fault(("drive", "load_angle"), "drive.angles", {"cycle": degrees(whole)})
    elif (mean := mean_share(drive, whole)) <= _SLACK:
        share = {"mean": float(f"{100 * mean:.3g}") + 0.0}
        yield Fault(("drive", "load_torque"), "drive.no-load", share)
    elif angle[-1] - angle[0] > whole - _SLACK and drive.load_torque[0] != drive.load_torque[-1]:
        values = {
            "first": drive.load_torque[0],
            "last": drive.load_torque[-1],
            "start": degrees(angle[0]),
            "end": degrees(angle[-1]),
        }
        yield Fault(("drive", "load_torque"), "drive.open-course", values)
    else:
        yield from _gap_faults(angle, drive.load_torque, whole)


def _gap_faults(angle: Sequence[float], load: Sequence[float], whole: float) -> Iterator[Fault]:
    """A course of a part of the cycle, over the rest of which nobody meant a straight line.

    A gap of more than half a turn, and by `UNEVEN` more than the others are in the mean: few values
    that are spread over the cycle are a course of few values. What is given up to both ends of the
    cycle, or without a load at both ends of the gap, is meant so.
    """
    steps = [b - a for a, b in pairwise([*angle, angle[0] + whole])]
    gap, turn, once = max(steps), 2 * pi, angle[-1] - angle[0]
    others = (whole - gap) / max(len(steps) - 1, 1)
    if len(steps) < 2 or gap <= max(pi, UNEVEN * others) + _SLACK or whole - once < END:
        return
    place = steps.index(gap)
    start = angle[place]
    if not (load[place] or load[(place + 1) % len(load)]):
        return
    values: dict[str, Any] = {"gap": _shown(gap), "start": _shown(start)}
    values["end"] = _shown(start + gap)
    if whole <= turn or once > turn + _SLACK:
        yield Fault(("drive", "load_angle"), "drive.gap", values)
        return
    again = [_shown(each + turn) for each in angle if each - angle[0] < turn - _SLACK]
    listed = [*again[: LISTED - 1], "...", again[-1]] if len(again) > LISTED else again
    values |= {"cycle": degrees(whole), "again": ", ".join(f"{each}" for each in listed)}
    yield Fault(("drive", "load_angle"), "drive.gap-of-a-turn", values)


def _shown(angle: float) -> float | int:
    size = float(f"{degrees(angle):.6g}")
    return int(size) if size.is_integer() else size


def _load_faults(load: Load, gas: Gas, path: Path) -> Iterator[Fault]:
    """More than one load, and values that no engine has."""
    kinds = LOADS[:2] if gas.process == "limited-pressure" else LOADS
    given = [name for name in kinds if getattr(load, name) is not None]
    if len(given) > 1:
        yield Fault((*path, given[1]), "gas.two-loads", {"one": given[0], "other": given[1]})
    if gas.process == "diesel" and load.peak_pressure is not None:
        yield Fault((*path, "peak_pressure"), "gas.diesel-peak")
    for name, greatest in (("imep", GREATEST_MEAN), ("bmep", GREATEST_MEAN)):
        value = getattr(load, name)
        if value is not None and value > greatest:
            values = {"value": value / 1e5, "greatest": greatest / 1e5}
            yield Fault((*path, name), "gas.too-high", values)
    for name, greatest in (
        ("peak_pressure", GREATEST_PEAK),
        ("intake_pressure", 1.5e6),
        ("exhaust_pressure", 1.5e6),
    ):
        value = getattr(load, name)
        if value is not None and value > greatest:
            values = {"value": value / 1e5, "greatest": greatest / 1e5}
            yield Fault((*path, name), "gas.too-high", values)
    start, duration = load.combustion_start, load.combustion_duration
    if start is not None and abs(start) > LATEST_START + _SLACK:
        yield Fault((*path, "combustion_start"), "gas.start", {"value": degrees(start)})
    if duration is not None and not 0 < duration <= LONGEST_COMBUSTION + _SLACK:
        yield Fault((*path, "combustion_duration"), "gas.duration", {"value": degrees(duration)})


def repeats(trace: Trace, whole: float) -> bool:
    """Whether the last sample of a trace is the first of the next cycle, `whole` radians later.

    >>> angle = (0.0, 3.1, 6.2, 9.3)
    >>> [repeats(Trace(angle=angle, pressure=((1e5,) * 4,)), whole) for whole in (9.3, 12.6)]
    [True, False]
    """
    return abs(trace.angle[-1] - trace.angle[0] - whole) <= SAME_ANGLE


def _trace_faults(trace: Trace, cycle: Cycle, chambers: Collection[int]) -> Iterator[Fault]:
    """A trace that is not a whole cycle, goes back, has other lengths, units or ends."""
    path: Path = ("gas", "trace")
    whole = 2 * pi if cycle == "two-stroke" else 4 * pi
    angle, count = trace.angle, len(trace.angle)
    if count < LEAST_SAMPLES:
        values = {"count": count, "least": LEAST_SAMPLES}
        yield Fault((*path, "angle"), "trace.too-few", values)
        return
    back = next((i for i, (a, b) in enumerate(pairwise(angle)) if b <= a), None)
    if back is not None:
        values = {"before": degrees(angle[back]), "after": degrees(angle[back + 1])}
        yield Fault((*path, "angle", back + 1), "trace.not-ascending", values)
        return
    length = angle[-1] - angle[0]
    steps = [b - a for a, b in pairwise(angle)]
    if length >= whole - _SLACK and not repeats(trace, whole):
        values = {"length": degrees(length), "cycle": degrees(whole)}
        yield Fault((*path, "angle", count - 1), "trace.more-than-a-cycle", values)
    elif max(*steps, whole - length) > GREATEST_STEP + _SLACK:
        values = {
            "step": degrees(max(*steps, whole - length)),
            "greatest": degrees(GREATEST_STEP),
            "cycle": degrees(whole),
        }
        yield Fault((*path, "angle"), "trace.gap", values)
    yield from _pressure_faults(trace, path, whole, chambers)


def _pressure_faults(
    trace: Trace, path: Path, whole: float, chambers: Collection[int]
) -> Iterator[Fault]:
    lists, named = len(trace.pressure), sorted(trace.chambers)
    if lists != 1 and lists != len(chambers):
        values = {"count": lists, "chambers": len(chambers)}
        yield Fault((*path, "pressure"), "trace.lists", values)
    if named and named != sorted(chambers):
        values = {"numbers": named, "chambers": sorted(chambers)}
        yield Fault((*path, "chambers"), "trace.chambers", values)
    for index, pressure in enumerate(trace.pressure):
        here = (*path, "pressure", index)
        if len(pressure) != len(trace.angle):
            values = {"count": len(pressure), "angles": len(trace.angle)}
            yield Fault(here, "trace.lengths", values)
            continue
        peak, least = max(pressure), min(pressure)
        place = trace.angle[pressure.index(peak)]
        off = place - round(place / whole) * whole
        if not LEAST_PEAK <= peak <= GREATEST_PEAK:
            yield Fault(here, "trace.unit", {"peak": peak / 1e5})
        elif peak < LEAST_RISE * least:
            yield Fault(here, "trace.constant", {"peak": peak / 1e5, "least": least / 1e5})
        elif abs(off) > FARTHEST_PEAK + _SLACK:
            shift = -round(degrees(off) / 180) * 180
            yield Fault(here, "trace.peak", {"place": degrees(place), "shift": f"{shift:+d}"})
        elif abs(pressure[-1] - pressure[0]) > GREATEST_JUMP * (peak - least):
            values = {"first": pressure[0] / 1e5, "last": pressure[-1] / 1e5}
            yield Fault(here, "trace.jump", values)
