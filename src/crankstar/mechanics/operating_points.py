"""The values of an operating point: those of the engine file, and assumed ones without."""

from __future__ import annotations

from collections.abc import Mapping
from math import radians
from typing import Any

from crankstar.engine.engine import Engine
from crankstar.engine.gas import LOADS, Gas, Load, Process
from crankstar.language.messages import MessageError

CRANKCASE = 101_325.0
"""Pa: the standard atmosphere behind the pistons."""
_SPARK: dict[str, Any] = {
    "compression_ratio": 10.0,
    "gamma": 1.30,
    "imep": 9e5,
    "intake_pressure": 1.0e5,
    "exhaust_pressure": 1.05e5,
    "intake_temperature": 340.0,
    "combustion_start": radians(-20.0),
    "combustion_duration": radians(55.0),
    "wiebe_a": 5.0,
    "wiebe_m": 2.0,
    "crankcase_pressure": CRANKCASE,
    "friction": "spark-ignition",
}
ASSUMED: Mapping[Process, Mapping[str, Any]] = {
    "heat-release": _SPARK,
    "otto": {**_SPARK, "gamma": 1.4},
    "diesel": {**_SPARK, "compression_ratio": 17.0, "gamma": 1.4, "friction": "diesel"},
    "limited-pressure": {
        **_SPARK,
        "compression_ratio": 17.0,
        "gamma": 1.4,
        "peak_pressure": 80e5,
        "friction": "diesel",
    },
}
"""What is assumed where a file says nothing, SI: a naturally aspirated engine near full load.

The air-standard gamma of ideal cycles is 1.4. Wiebe's a = 5 and m = 2 are those of spark ignition.
Source: J. B. Heywood, Internal Combustion Engine Fundamentals, chapters 5 and 9.
"""


class GasError(MessageError):
    """A cycle that cannot be computed, and why."""


def resolved(
    engine: Engine,
    *,
    point: str = "",
    speed: float | None = None,
    load: Mapping[str, float] | None = None,
) -> tuple[dict[str, Any], tuple[str, ...]]:
    """All values of a cycle in SI units, and the names of the assumed ones. Raises GasError."""
    gas = engine.gas or Gas()
    layers: list[dict[str, Any]] = [_given(gas)]
    if point:
        known = {each.name: each for each in gas.points}
        if point not in known:
            raise GasError(
                "the engine has no operating point {point}; it has: {points}",
                point=point,
                points=", ".join(known) or "-",
            )
        layers.append(_given(known[point]))
    layers.append({name: value for name, value in (load or {}).items() if value is not None})
    if gas.trace is not None and any(name in layer for layer in layers for name in LOADS):
        raise GasError("a measured pressure has a load of its own: ask for no other")
    process = gas.process or "heat-release"
    given: dict[str, Any] = {}
    for layer in layers:
        fixed = LOADS if process != "limited-pressure" else LOADS[:2]
        if any(name in layer for name in fixed):
            given = {name: value for name, value in given.items() if name not in fixed}
        given |= layer
    if speed is not None:
        given["speed"] = speed
    elif "speed" not in given and engine.speed is not None:
        given["speed"] = engine.speed
    assumed = dict(ASSUMED[process])
    if gas.trace is not None or any(name in given for name in LOADS[:2]):
        assumed.pop("imep", None)
    if process in ("heat-release", "otto") and "peak_pressure" in given:
        assumed.pop("imep", None)
    names = tuple(name for name in assumed if name not in given and _used(name, process, given))
    return {**assumed, **given, "process": process}, names


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
    skipped = ("name", "points", "trace", "process")
    return {name: value for name, value in record if value is not None and name not in skipped}
