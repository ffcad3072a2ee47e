"""The operating point and speed that are meant, and the values of a cycle there.

One rule for every command and function (`operating_state`):

* a **point** that is named is that of the file, at the **speed** that is asked for, else its own:
  that of the point, of the table [gas], of the engine;
* a speed alone, that of the file (of its table [gas], or of the engine) where none is asked for, is
  that of the point of the file that has it. Between two of them the gas is that
  between them, by the speed: the pressure at every crank angle, and with it torque and mean
  effective pressure, go straight from one to the next; friction by a correlation is that of the
  speed. Beyond the first and the last it is that of the nearest;
* without any speed, and where the points of the file do not have two, the point is
  `default_point`.

So a command at a point is the same command at the speed and load of that point, and along a range
of speeds (`gas_loads.gas_over_speeds`) each is what it is alone. The values are those of the engine
file, and assumed ones without.
"""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Mapping, Sequence
from math import radians
from typing import Any, NamedTuple

from crankstar.engine.engine import Engine
from crankstar.engine.gas import LOADS, Gas, Ignition, Load, Process, said_ignition
from crankstar.engine.proportions import SPARK, inferred, look_of
from crankstar.language.messages import MessageError
from crankstar.language.numbers import RPM

CRANKCASE = 101_325.0
"""Pa: the standard atmosphere behind the pistons."""
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
"""Pa: the assumed limit of pressure of a limited-pressure cycle that draws in free air."""
AIR = 1e5
"""Pa: free air; a higher charge pressure raises the assumed limit alike."""
USUAL_SPEED = 1000 / RPM
"""rad/s, at which engines are compared where no file has a speed."""
SPEEDS_BETWEEN = 2
"""Speeds that points must have for there to be a load between them."""
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

    Of a point by its name, "" for the load of the table [gas], as it is at a speed (rad/s).
    """
    gas = engine.gas or Gas()
    layers: list[dict[str, Any]] = [_given(gas)]
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
    if speed is not None:
        given["speed"] = speed
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
    chosen = {"process": process, "ignition": fires}
    return {**assumed, **given, **chosen}, names


class OperatingState(NamedTuple):
    """A speed (rad/s), and the operating points of which the gas is there with their shares.

    One point has all of it; of two the gas is between. The load of the table [gas] has the name "".
    """

    speed: float | None
    shares: tuple[tuple[str, float], ...]

    @property
    def point(self) -> str:
        """The name of the one point; "" between two, and for the load of the table [gas]."""
        return self.shares[0][0] if len(self.shares) == 1 else ""


def operating_state(
    engine: Engine, *, point: str = "", speed: float | None = None
) -> OperatingState:
    """The operating point and speed that are meant: the rule of every command.

    Raises GasError for a point that the engine has not.

    >>> from crankstar.files.catalog import load
    >>> five = load("audi-25-tfsi")  # full at 6500 rpm, most torque at 5300, idle at 750
    >>> [operating_state(five, point=point).point for point in ("", "idle")]
    ['full', 'idle']
    >>> operating_state(five, speed=operating_state(five, point="idle").speed).shares
    (('idle', 1.0),)
    >>> between = operating_state(five, speed=radians(3025 * 6)).shares
    >>> [(name, round(share, 9)) for name, share in between]
    [('idle', 0.5), ('most torque', 0.5)]
    >>> operating_state(five, speed=900.0).shares, operating_state(five, speed=9.0).point
    ((('full', 1.0),), 'idle')
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
    if not point:
        speed = next((each for each in (speed, gas.speed, engine.speed) if each is not None), None)
    if not point and speed is not None:
        return OperatingState(speed, shares_at(_by_speed(engine), speed, default_point(gas)))
    point = point or default_point(gas)
    return OperatingState(own_speed(engine, point) if speed is None else speed, ((point, 1.0),))


def own_speed(engine: Engine, point: str) -> float | None:
    """The speed of an operating point, rad/s: its own, else that of the file; None without any."""
    gas = engine.gas or Gas()
    own = next((each.speed for each in gas.points if each.name == point), None)
    return next((each for each in (own, gas.speed, engine.speed) if each is not None), None)


def common_speed(engines: Sequence[Engine]) -> float | None:
    """The one speed (rad/s) at which engines are compared in N: the least that their files give.

    At USUAL_SPEED where none has one: the ratio of inertia forces is that of any speed. None where
    a mass or a stroke is not known, so that each is in its own m r w^2.

    >>> from crankstar.files.catalog import load
    >>> common_speed([load("i4"), load("i6")]) is None
    True
    """
    if any({"mass", "radius"} & {*engine.relative} for engine in engines):
        return None
    known = [engine.speed for engine in engines if engine.speed is not None]
    return min(known, default=USUAL_SPEED)


def speed_beside(engines: Sequence[Engine], speed: float | None) -> float | None:
    """The speed (rad/s) at which engines are compared: that asked for, None for that of each file.

    Where a file has none it is `common_speed`.
    """
    if speed is not None or all(engine.speed is not None for engine in engines):
        return speed
    return common_speed(engines)


def points_by_speed(engine: Engine) -> dict[float, str]:
    """The operating points between which gas is interpolated, by ascending speed (rad/s).

    None where they do not have two speeds. The load of the table [gas] itself is one, by the name
    "", where it has one; of points of one speed the first is.

    >>> from crankstar.files.catalog import load
    >>> points_by_speed(load("honda-b18c"))
    {}
    >>> [*points_by_speed(load("audi-25-tfsi")).values()]
    ['idle', 'most torque', 'full']
    """
    known = _by_speed(engine)
    return known if len(known) >= SPEEDS_BETWEEN else {}


def _by_speed(engine: Engine) -> dict[float, str]:
    """The first operating point of each speed that some have, by ascending speed."""
    if engine.gas is None:
        return {}
    known: dict[float, str] = {}
    for name in (default_point(engine.gas), *(each.name for each in engine.gas.points)):
        speed = own_speed(engine, name)
        if speed is not None and not any(_same(other, speed) for other in known):
            known[speed] = name
    return dict(sorted(known.items()))


def shares_at(
    known: Mapping[float, str], speed: float, default: str
) -> tuple[tuple[str, float], ...]:
    """The points by ascending speed that a speed is between, with their shares.

    Where they do not have two speeds, that of the one speed, or else the `default`.

    >>> shares_at({100.0: "idle", 500.0: "full"}, 200.0, "full")
    (('idle', 0.75), ('full', 0.25))
    """
    at = [*known]
    after = bisect_left(at, speed)
    for near in at[max(after - 1, 0) : after + 1]:
        if _same(near, speed):
            return ((known[near], 1.0),)
    if len(known) < SPEEDS_BETWEEN:
        return ((default, 1.0),)
    if after in (0, len(at)):
        return ((known[at[min(after, len(at) - 1)]], 1.0),)
    low, high = at[after - 1], at[after]
    share = (speed - low) / (high - low)
    return ((known[low], 1 - share), (known[high], share))


def _same(one: float, other: float) -> bool:
    """Whether a speed is one that was asked for, as text in rpm is read."""
    return abs(one - other) <= 1e-9 * abs(other)


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

    Where it does not say so, as its type of engine does (`proportions.inferred`).

    >>> from crankstar.files.catalog import load
    >>> ignition(load("audi-25-tfsi"), Gas()), ignition(load("man-s90mc-c"), Gas())
    (('spark', False), ('compression', False))
    """
    said, told = said_ignition(gas)
    if said is not None:
        return said, told
    look = look_of(engine, gas)
    if look is not None:
        return ("spark" if inferred(look)[0] in SPARK else "compression"), False
    facing = len(engine.chambers) < len(engine.cylinders)  # pistons that face each other
    return ("compression" if facing else "spark"), False


def _assumed(
    engine: Engine, process: Process, fires: Ignition, given: Mapping[str, Any]
) -> dict[str, Any]:
    """All that may have to be assumed of a cycle."""
    values = dict(ASSUMED[fires])
    if process != "heat-release":
        values["gamma"] = AIR_STANDARD
    if process == "limited-pressure":
        values["peak_pressure"] = LIMIT * max(1.0, given.get("intake_pressure", AIR) / AIR)
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
