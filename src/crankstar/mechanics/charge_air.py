"""The air of a charge: when it is shut in, how much fuel burns in it, what a load needs.

Where a file gives no charge pressure, that of an engine without a charger is assumed, and a greater
one where the fuel of the load would have too little air.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping
from math import pi, radians
from typing import Any

from crankstar.engine.engine import Engine
from crankstar.engine.gas import Ignition
from crankstar.engine.valves import timing
from crankstar.engine.volumes import Volumes
from crankstar.mechanics import heat_release

GAS_CONSTANT = 287.05
"""Of air, J/(kg K)."""
HEATING_VALUE: Mapping[Ignition, float] = {"spark": 43.0e6, "compression": 42.7e6}
"""Lower heating values of petrol and of Diesel fuel, J/kg."""
STOICHIOMETRIC: Mapping[Ignition, float] = {"spark": 14.7, "compression": 14.5}
"""Air-fuel ratios of complete combustion without a rest of air."""
RICHEST: Mapping[Ignition, float] = {"spark": 0.8, "compression": 1.2}
"""Air-fuel ratio at full load over the stoichiometric one down to which no charger is assumed.

Our judgement, from ranges that readers of the field give without one origin: spark ignition goes to
0.8 for its greatest power and cool exhaust, a Diesel smokes below 1.2 to 1.4. The lower end is
taken, since below it the fuel of the load plainly lacks air; above it the file may be right.
"""
CHARGED: Mapping[Ignition, float] = {"spark": 0.8, "compression": 2.0}
"""The same of an engine with a charger, from which its charge pressure is estimated.

Our judgement: charged Diesels have 1.6 to 2.5 at full load, large ones more, for the sake of smoke
and heat; 2.0 is the middle of what is built. Pressures that are estimated from it are marked.
"""
LEAST_EFFICIENCY = 0.25
"""Indicated, of a cycle near full load: with less heat than this takes no charge is sought."""
GREATEST_STEPS, SETTLED = 40, 1e-9
"""Of the search for the charge pressure, and the change of it that is none."""
LEAST_BLOW_DOWN = radians(20.0)
LEAST_EXCHANGE = radians(20.0)
"""Radians: the pressure takes so long at least from that of the cylinder to the exhaust's, and on
to that of the intake."""


def events(engine: Engine, bottom: float) -> heat_release.Events:
    """When compression begins and the exhaust opens, by the valves of the file or assumed ones.

    `bottom` is the bottom dead centre of the chamber, radians after the top.
    """
    times = timing(engine.valves, cycle=engine.cycle)
    turn = 2 * pi
    opened = bottom - times.exhaust_opens
    if engine.cycle == "four-stroke":
        emptied = max(bottom, opened + LEAST_BLOW_DOWN)
        middle = turn + (times.exhaust_closes - times.intake_opens) / 2
        half = max(times.exhaust_closes + times.intake_opens, LEAST_EXCHANGE) / 2
        return heat_release.Events(
            closed=bottom + times.intake_closes - turn,
            opened=opened,
            emptied=emptied,
            exchange=(middle - half, middle + half),
        )
    closed = bottom + max(times.exhaust_closes, times.intake_closes)
    emptied = max(bottom, opened + LEAST_BLOW_DOWN)
    return heat_release.Events(
        closed=closed - turn,
        opened=opened,
        emptied=emptied,
        exchange=(emptied, max(closed, emptied + LEAST_EXCHANGE)),
    )


def boosted(
    engine: Engine,
    places: Volumes,
    values: Mapping[str, Any],
    assumed: Collection[str],
    *,
    load: float,
    heat: Callable[[Mapping[str, Any]], float],
) -> dict[str, Any]:
    """The charge pressure with which the load burns at the usual air-fuel ratio, where it needs it.

    The assumed pressure of an engine without a charger stays where its air suffices (RICHEST);
    a greater load shows that there is a charger, and then

        p = p_assumed usual / ratio    until the ratio is the usual one,

    and an assumed exhaust pressure, that of a turbine, and an assumed limit rise with it. The heat
    of the load depends on the charge a little, so that the ratio is sought in steps: `heat` gives
    it (per swept volume, Pa) for values, and `load` is the indicated mean effective pressure, Pa.
    """
    out: dict[str, Any] = {}
    complete = STOICHIOMETRIC[values["ignition"]]
    least, usual = (share[values["ignition"]] * complete for share in (RICHEST, CHARGED))
    if air_fuel_ratio(engine, places, values, load / LEAST_EFFICIENCY) >= least:
        return out
    for _step in range(GREATEST_STEPS):
        now = {**values, **out}
        ratio = air_fuel_ratio(engine, places, now, heat(now))
        rises = usual / ratio
        if (not out and ratio >= least) or abs(rises - 1) < SETTLED:
            break
        raised = max(now["intake_pressure"] * rises, values["intake_pressure"])
        out["intake_pressure"] = raised
        for name in {"exhaust_pressure", "peak_pressure"}.intersection(assumed):
            out[name] = values[name] * raised / values["intake_pressure"]
    return out


def air_fuel_ratio(
    engine: Engine, places: Volumes, values: Mapping[str, Any], heat: float
) -> float:
    """Mass of air over mass of fuel of a heat per swept volume (Pa).

        air = p V/(R T) when compression begins,    fuel = heat V_swept/H

    with the lower heating value H: residual gas counts as air.
    """
    above, swept = places.above[0], float(places.swept[0])
    closed = events(engine, float(places.bottom[0])).closed
    at = round(closed / (places.cycle / above.size)) % above.size
    volume = float(above[at]) + swept / (values["compression_ratio"] - 1)
    air = values["intake_pressure"] * volume / (GAS_CONSTANT * values["intake_temperature"])
    return air / (heat * swept / HEATING_VALUE[values["ignition"]])
