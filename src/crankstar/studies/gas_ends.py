"""Between which ends a value lies that is assumed of a cycle: none that nobody could believe.

What is usual of such engines, a charge with a charger and without one, a throttle that is closed;
and no end at which a file would be doubted (`mechanics.doubts`): the least charge is one in which
the fuel can burn, the charge of a two-stroke engine drives its exhaust out.
"""

from __future__ import annotations

from collections.abc import Mapping

from crankstar.analysis.changed_masses import Vary
from crankstar.engine.engine import Engine
from crankstar.engine.gas import Ignition
from crankstar.mechanics.charge_air import CHARGED, RICHEST, STOICHIOMETRIC
from crankstar.mechanics.doubts import GAMMAS, LEAST_AIR
from crankstar.mechanics.gas import Cycle, cycle
from crankstar.mechanics.operating_points import ASSUMED, GasError

GAS_ENDS: Mapping[str, tuple[float, float]] = {
    "compression_ratio": (0.85, 1.15),
    "gamma": (0.97, 1.03),
    "imep": (0.7, 1.3),
    "intake_pressure": (0.9, 1.2),
    "exhaust_pressure": (0.95, 1.3),
    "crankcase_pressure": (0.97, 1.03),
    "intake_temperature": (0.9, 1.1),
    "peak_pressure": (0.8, 1.25),
    "combustion_duration": (0.75, 1.3),
    "wiebe_a": (0.73, 1.38),
    "wiebe_m": (0.5, 1.5),
}
"""Ends of what is assumed of a cycle, as multiples of the assumed value.

Those of wiebe_a are 5 and 6.9 of one another; the others are wide enough for engines of one kind.
Source: J. B. Heywood, Internal Combustion Engine Fundamentals, chapters 5 and 9, for the order of
size; the ends themselves are our judgement.
"""
CHARGED_IMEP = 2.4
"""High end of the assumed load of an engine that ignites by compression, as a multiple.

Ship's and truck engines with a charger have 20 to 24 bar, those without one 7 to 9.
"""
NEAR = 1.1
"""Of the pressure around an engine: below, a load may be that of one without a charger."""
LEANEST = 1.5
"""Air-fuel ratio over the stoichiometric one from which a homogeneous mixture does not burn.

Our judgement: petrol engines run up to 1.3 to 1.6 before they misfire.
"""
GREATEST_STEPS, SETTLED = 40, 1e-6
"""Of the search for the least charge, and the share by which its air-fuel ratio may still miss."""


def gas_ends(
    engine: Engine, own: Cycle, name: str, value: float, *, vary: Vary | None
) -> tuple[float, float]:
    """The ends of an assumed value of a cycle, SI; `vary` changes the engine to one, as shown.

    At none of them a charge is doubted that the value itself leaves undoubted.

    >>> from crankstar.files.catalog import load
    >>> engine = load("honda-b18c")
    >>> low, high = gas_ends(engine, cycle(engine, imep=9e5), "gamma", 1.4, vary=None)
    >>> round(low, 3), round(high, 3)
    (1.358, 1.42)
    """
    low, high = usual_ends(name, value, own)
    ratio, scavenged = own.air_fuel_ratio, engine.cycle == "two-stroke"
    if name == "gamma":
        low, high = max(low, GAMMAS[0]), min(high, GAMMAS[1])
    elif name == "exhaust_pressure" and scavenged and "intake_pressure" not in own.assumed:
        high = min(high, (1 - SETTLED) * own.values["intake_pressure"])
    elif name == "intake_pressure":
        low, high = _charged_or_not(own, value, low, high)
        if scavenged and "exhaust_pressure" not in own.assumed:
            low = max(low, (1 + SETTLED) * own.values["exhaust_pressure"])
        closed, least = throttled(own) * value, LEAST_AIR
        if closed < value:
            low, least = min(low, closed), RICHEST
        if ratio is not None and vary is not None:
            low = _burning(engine, own, vary, low, (1 + 2 * SETTLED) * _least(own, least))
    return min(low, value), max(high, value)


def _least(own: Cycle, shares: Mapping[Ignition, float]) -> float:
    """The air-fuel ratio that is a share of the stoichiometric one, by the ignition."""
    fires: Ignition = own.values["ignition"]
    return shares[fires] * STOICHIOMETRIC[fires]


def _burning(engine: Engine, own: Cycle, vary: Vary, low: float, least: float) -> float:
    """The least charge pressure (Pa), `low` or more, whose air-fuel ratio is `least`.

        p = p least / ratio(p)    until the ratio is that one,

    as the exchange of the gas takes some work, and so some fuel, from a thin charge.
    """
    charge = low
    for _step in range(GREATEST_STEPS):
        try:
            again = cycle(vary(engine, charge / 1e5), point=own.name, speed=own.speed)
        except GasError:
            break
        rises = least / (again.air_fuel_ratio or least)
        if abs(rises - 1) < SETTLED or (charge == low and rises < 1):
            break
        charge *= rises
    return max(charge, low)


def usual_ends(name: str, value: float, own: Cycle) -> tuple[float, float]:
    """The usual ends of an assumed value of a cycle.

    >>> from crankstar.files.catalog import load
    >>> usual_ends("compression_ratio", 10.0, cycle(load("honda-b18c"), imep=9e5))
    (8.5, 11.5)
    """
    low, high = GAS_ENDS[name]
    if name == "imep" and own.values.get("ignition") == "compression":
        high = CHARGED_IMEP
    return low * value, high * value


def charged(own: Cycle) -> bool:
    """Whether a charger is assumed.

    >>> from crankstar.files.catalog import load
    >>> [charged(cycle(load("honda-b18c"), imep=load_)) for load_ in (9e5, 25e5)]
    [False, True]
    """
    return own.values["intake_pressure"] > ASSUMED[own.values["ignition"]]["intake_pressure"]


def _charged_or_not(own: Cycle, value: float, low: float, high: float) -> tuple[float, float]:
    """The ends of an assumed charge pressure, with a charger and without one.

    Where its air suffices but is less than a charger gives, there may be one; where it all but
    suffices, there may be none.
    """
    ratio, fires = own.air_fuel_ratio, own.values.get("ignition")
    if ratio is None or fires is None or RICHEST[fires] == CHARGED[fires]:
        return low, high
    least, usual = (share[fires] * STOICHIOMETRIC[fires] for share in (RICHEST, CHARGED))
    if not charged(own):
        return low, max(high, value * usual / ratio)
    enough = value * least / ratio
    near = enough < NEAR * ASSUMED[fires]["intake_pressure"]
    return (min(low, enough) if near else low), high


def throttled(own: Cycle) -> float:
    """Share of the assumed charge with which a spark-ignited load burns without a rest of air.

    1 where the mixture is no leaner than one that burns (LEANEST).

    >>> from crankstar.files.catalog import load
    >>> throttled(cycle(load("honda-b18c"), imep=11e5))
    1.0
    """
    ratio = own.air_fuel_ratio
    complete = STOICHIOMETRIC["spark"]
    if ratio is None or own.values.get("ignition") != "spark" or ratio <= LEANEST * complete:
        return 1.0
    return complete / ratio
