"""The operating point and speed that are meant, and the values of a cycle there.

One rule for every command and function (`operating_state`):

* the **point** is the one that is named; else that of the file whose speed is the one that is
  asked for; else `default_point`;
* the **speed** is the one that is asked for; else that of the point, of the table [gas], of the
  engine.

So a command at a point is the same command at the speed and load of that point, and without one
gas and speed are those of one point, never of two. Along a range of speeds the load goes from point
to point (`gas_loads.gas_over_speeds`). The values are those of the engine file, and assumed ones
without.
"""

from __future__ import annotations

from collections.abc import Mapping
from math import radians
from typing import Any, NamedTuple

from crankstar.engine.engine import Engine
from crankstar.engine.gas import LOADS, Gas, Ignition, Load, Process
from crankstar.language.messages import MessageError

CRANKCASE = 101_325.0
"""Pa: the standard atmosphere behind the pistons."""
SPARK_RATIO = 14.0
"""Greatest compression ratio of an engine that is taken for one with spark ignition."""
SPARK_BORE = 0.18
"""Greatest bore, m, of an engine that is taken for one with spark ignition."""
SCAVENGING = 1.1
"""Intake over exhaust pressure of a two-stroke chamber where one of them is assumed."""
_COMMON: dict[str, Any] = {
    "gamma": 1.30,
    "imep": 9e5,
    "intake_pressure": 1.0e5,
    "exhaust_pressure": 1.05e5,
    "intake_temperature": 340.0,
    "crankcase_pressure": CRANKCASE,
}
ASSUMED: Mapping[Ignition, Mapping[str, Any]] = {
    "spark": {
        "compression_ratio": 10.0,
        **_COMMON,
        "combustion_start": radians(-20.0),
        "combustion_duration": radians(55.0),
        "wiebe_a": 5.0,
        "wiebe_m": 2.0,
        "friction": "spark-ignition",
    },
    "compression": {
        "compression_ratio": 17.0,
        **_COMMON,
        "combustion_start": radians(-6.0),
        "combustion_duration": radians(65.0),
        "wiebe_a": 6.9,
        "wiebe_m": 1.0,
        "friction": "diesel",
    },
}
"""What is assumed where a file says nothing, SI: a naturally aspirated engine near full load.

Wiebe's a = 5 and m = 2 are those of spark ignition; a = 6.9 burns 99.9 %, and a smaller m burns
most of it early, as injected fuel does.
Source: J. B. Heywood, Internal Combustion Engine Fundamentals, chapters 5 and 9; I. Wiebe (1962).
"""
LIMIT = 80e5
"""Pa: the assumed limit of pressure of a limited-pressure cycle."""
AIR_STANDARD = 1.4
"""The ratio of specific heats of ideal cycles."""


class GasError(MessageError):
    """A cycle that cannot be computed, and why."""


def resolved(
    engine: Engine,
    *,
    point: str = "",
    speed: float | None = None,
    load: Mapping[str, float] | None = None,
) -> tuple[dict[str, Any], tuple[str, ...]]:
    """All values of a cycle in SI units, and the names of the assumed ones. Raises GasError.

    Point and speed are those of `operating_state`; `values["point"]` is the name of the point.
    """
    gas = engine.gas or Gas()
    layers: list[dict[str, Any]] = [_given(gas)]
    point, turning = operating_state(engine, point=point, speed=speed)
    layers += [_given(each) for each in gas.points if each.name == point]
    layers.append({name: value for name, value in (load or {}).items() if value is not None})
    if gas.trace is not None and any(name in layer for layer in layers for name in LOADS):
        raise GasError("a measured pressure has a load of its own: ask for no other")
    process = gas.process or "heat-release"
    fires, told = ignition(engine, gas)
    given: dict[str, Any] = {}
    for layer in layers:
        fixed = LOADS if process != "limited-pressure" else LOADS[:2]
        if any(name in layer for name in fixed):
            given = {name: value for name, value in given.items() if name not in fixed}
        given |= layer
    if turning is not None:
        given["speed"] = turning
    assumed = _assumed(engine, process, fires, given)
    if gas.trace is not None or any(name in given for name in LOADS[:2]):
        assumed.pop("imep", None)
    if process in ("heat-release", "otto") and "peak_pressure" in given:
        assumed.pop("imep", None)
    if "friction_pressure" in given:
        assumed.pop("friction", None)
    if not told:
        assumed["ignition"] = fires
    names = tuple(name for name in assumed if name not in given and _used(name, process, given))
    chosen = {"process": process, "ignition": fires, "point": point}
    return {**assumed, **given, **chosen}, names


class OperatingState(NamedTuple):
    """An operating point by its name, "" for the load of the table [gas], and its speed, rad/s."""

    point: str
    speed: float | None


def operating_state(
    engine: Engine, *, point: str = "", speed: float | None = None
) -> OperatingState:
    """The operating point and speed that are meant: the rule of every command.

    Raises GasError for a point that the engine has not.

    >>> from crankstar.files.catalog import load
    >>> five = load("audi-25-tfsi")
    >>> [operating_state(five, point=point).point for point in ("", "idle")]
    ['full', 'idle']
    >>> idle = operating_state(five, point="idle").speed
    >>> operating_state(five, speed=idle).point, operating_state(five, speed=300.0)
    ('idle', OperatingState(point='full', speed=300.0))
    """
    gas = engine.gas or Gas()
    known = {each.name: each for each in gas.points}
    if point and not known:
        raise GasError(
            "the engine has no operating point {point}: its file has no [[gas.point]]; leave it "
            "out",
            point=point,
        )
    if point and point not in known:
        raise GasError(
            "the engine has no operating point {point}; it has: {points}",
            point=point,
            points=", ".join(known),
        )
    if not point and speed is not None:
        of_speed = [name for name, own in known.items() if _same(own.speed, speed)]
        own_load = not default_point(gas) and _same(gas.speed or engine.speed, speed)
        point = of_speed[0] if of_speed and not own_load else ""
    point = point or default_point(gas)
    own = known[point].speed if point else None
    chain = (speed, own, gas.speed, engine.speed)
    return OperatingState(point, next((each for each in chain if each is not None), None))


def _same(one: float | None, other: float) -> bool:
    """Whether a speed is one that was asked for, as text in rpm is read."""
    return one is not None and abs(one - other) <= 1e-9 * abs(other)


def default_point(gas: Gas) -> str:
    """The operating point that is meant where none is named: the load of the table [gas], "".

    The first of its points where the table has no load of its own.

    >>> default_point(Gas(points=({"name": "full", "imep": 12e5}, {"name": "idle"})))
    'full'
    >>> default_point(Gas(imep=9e5, points=({"name": "idle"},)))
    ''
    """
    own = gas.trace is not None or any(getattr(gas, name) is not None for name in LOADS)
    return "" if own or not gas.points else gas.points[0].name


def ignition(engine: Engine, gas: Gas) -> tuple[Ignition, bool]:
    """How an engine ignites, and whether its file says so or only its sizes do.

    >>> from crankstar.files.catalog import load
    >>> ignition(load("audi-25-tfsi"), Gas()), ignition(load("man-s90mc-c"), Gas())
    (('spark', False), ('compression', False))
    """
    if gas.ignition is not None:
        return gas.ignition, True
    if gas.process in ("diesel", "limited-pressure") or gas.friction == "diesel":
        return "compression", True
    if gas.process == "otto" or gas.friction == "spark-ignition":
        return "spark", True
    if gas.compression_ratio is not None:
        return ("compression" if gas.compression_ratio > SPARK_RATIO else "spark"), False
    large = (engine.first.bore or 0.0) > SPARK_BORE and "radius" not in engine.relative
    return ("compression" if large else "spark"), False


def _assumed(
    engine: Engine, process: Process, fires: Ignition, given: Mapping[str, Any]
) -> dict[str, Any]:
    """All that may have to be assumed of a cycle."""
    values = dict(ASSUMED[fires])
    if process != "heat-release":
        values["gamma"] = AIR_STANDARD
    if process == "limited-pressure":
        values["peak_pressure"] = LIMIT
    if engine.cycle == "two-stroke":  # the charge drives the exhaust out
        if "intake_pressure" in given:
            values["exhaust_pressure"] = given["intake_pressure"] / SCAVENGING
        else:
            exhaust = given.get("exhaust_pressure", values["exhaust_pressure"])
            values["intake_pressure"] = exhaust * SCAVENGING
    return values


def _used(name: str, process: Process, given: Mapping[str, Any]) -> bool:
    """Whether a value goes into a cycle."""
    if name in ("combustion_start", "combustion_duration", "wiebe_a", "wiebe_m"):
        return process == "heat-release"
    if name == "intake_temperature":
        return bool(given.get("variable_gamma") or given.get("wall_temperature"))
    if name == "gamma":
        return not given.get("variable_gamma")
    return True


def _given(record: Load) -> dict[str, Any]:
    """What a record gives, by name."""
    skipped = ("name", "points", "trace", "process", "ignition")
    return {name: value for name, value in record if value is not None and name not in skipped}
