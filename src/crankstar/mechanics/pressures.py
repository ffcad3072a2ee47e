"""The pressure in every chamber at one operating point, with the heat that gives its load.

The heat is sought so that the work of the samples themselves is that of the load, W = sum p V'
dtheta.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping
from functools import lru_cache
from math import inf, pi
from typing import Any

import numpy as np

from crankstar.engine.engine import Engine
from crankstar.engine.volumes import Volumes, volumes
from crankstar.mechanics import heat_release, ideal_cycles, real_gas
from crankstar.mechanics.charge_air import boosted, events
from crankstar.mechanics.friction import friction_of
from crankstar.mechanics.gas_traces import traced
from crankstar.mechanics.maxima import highest
from crankstar.mechanics.operating_points import GasError
from crankstar.mechanics.roots import root
from crankstar.spectra import Real

LEAST_STEP = 1e5
"""Pa: a heat per swept volume, up from which that of a load is sought."""
SAMPLES = 3600
"""Samples of a cycle: a fifth of a degree of a four-stroke one."""


@lru_cache(maxsize=64)
def volumes_of(engine: Engine) -> Volumes:
    """The chambers of an engine at the samples of a cycle."""
    return volumes(engine, SAMPLES)


Law = Callable[[float], Real]
"""From a heat per swept volume (Pa) to the pressure, Pa [sample]."""


def pressures(
    engine: Engine,
    places: Volumes,
    values: Mapping[str, Any],
    lost: Mapping[int, float],
    charges: Mapping[int, Mapping[str, float]],
    *,
    motored: bool,
) -> tuple[Real, float]:
    """The pressure [chamber, sample] with the heat (Pa) that gives the load. Raises GasError."""
    shares = np.array([lost[number] for number in places.numbers])[:, None]
    kinds = np.array(places.kind)
    if engine.gas is not None and engine.gas.trace is not None:
        burning = traced(engine, places)
        still = burning.copy()
        for row, charge in charges.items():
            still[row] = _law(engine, places, places.kind[row], {**values, **charge})(0.0)
        return (1 - shares) * burning + shares * still, 0.0
    laws = [_law(engine, places, row, values) for row in range(len(places.swept))]
    heat = 0.0 if motored else _heat(laws, places, values)
    burning = np.array([law(heat) for law in laws])[kinds]
    still = np.array([law(0.0) for law in laws])[kinds] if shares.any() else burning
    return (1 - shares) * burning + shares * still, heat


def charged(
    engine: Engine, places: Volumes, values: Mapping[str, Any], assumed: Collection[str]
) -> dict[str, Any]:
    """What the load changes in an assumed charge; a peak pressure says itself how much that is."""
    if "imep" not in values and "bmep" not in values:
        return {}

    def heat(now: Mapping[str, Any]) -> float:
        laws = [_law(engine, places, row, now) for row in range(len(places.swept))]
        return _heat(laws, places, now)

    return boosted(engine, places, values, assumed, load=_target(values), heat=heat)


def _law(engine: Engine, places: Volumes, row: int, values: Mapping[str, Any]) -> Law:
    """The pressure of the chambers of one kind as a function of their heat."""
    swept, above, rate = float(places.swept[row]), places.above[row], places.rate[row]
    bottom, step = float(places.bottom[row]), places.cycle / SAMPLES
    four_stroke = engine.cycle == "four-stroke"
    ratio, process = values["compression_ratio"], values["process"]
    if process != "heat-release":
        ideal = ideal_cycle(values)
        return lambda heat: ideal_cycles.pressure(
            ideal, heat, above / swept, bottom=int(bottom / step + 1e-6), four_stroke=four_stroke
        )
    release = heat_release.Release(
        values["combustion_start"],
        values["combustion_duration"],
        values["wiebe_a"],
        values["wiebe_m"],
    )
    charge = (values["intake_pressure"], values["exhaust_pressure"])
    if not values.get("variable_gamma") and values.get("wall_temperature") is None:
        parts = _curves(engine, row, ratio, release, values["gamma"])
        still = charge[0] * parts.intake + charge[1] * parts.exhaust
        return lambda heat: still + heat * swept * parts.heat
    if values.get("wall_temperature") is not None and "speed" not in values:
        raise GasError("heat to the walls needs the speed: give speed")
    grid = heat_release.Grid(above + swept / (ratio - 1), rate, step)
    happens = events(engine, bottom)
    own = engine.chambers[places.numbers[places.kind.index(row)]][0]
    stroke = 2 * engine.throw(own).radius
    real = real_gas.Charge(
        *charge,
        temperature=values["intake_temperature"],
        bore=own.bore or 0.0,
        stroke=stroke,
        piston_speed=values.get("speed", 0.0) * stroke / pi,
        wall=values.get("wall_temperature"),
        gamma=None if values.get("variable_gamma") else values["gamma"],
    )
    return lambda heat: real_gas.real_pressure(grid, happens, release, real, heat=heat * swept)


@lru_cache(maxsize=64)
def _curves(
    engine: Engine, row: int, ratio: float, release: heat_release.Release, gamma: float
) -> heat_release.Curves:
    """The curves of chambers of one kind, kept: loads of an engine differ in factors alone."""
    places = volumes_of(engine)
    above = places.above[row]
    least = float(places.swept[row]) / (ratio - 1)
    grid = heat_release.Grid(above + least, places.rate[row], places.cycle / SAMPLES)
    happens = events(engine, float(places.bottom[row]))
    return heat_release.curves(grid, happens, release, gamma=gamma)


def ideal_cycle(values: Mapping[str, Any]) -> ideal_cycles.Ideal:
    """The ideal cycle of these values."""
    cycle = ideal_cycles.Ideal(
        values["compression_ratio"],
        values["gamma"],
        values["intake_pressure"],
        values["exhaust_pressure"],
    )
    if values["process"] == "diesel":
        return cycle._replace(limit=ideal_cycles.compressed(cycle))
    if values["process"] == "limited-pressure":
        least = ideal_cycles.compressed(cycle)
        if values["peak_pressure"] < least:
            raise GasError(
                "peak_pressure is {limit} bar, less than compression alone, {least} bar: give "
                "more, or a smaller compression_ratio",
                limit=f"{values['peak_pressure'] / 1e5:.4g}",
                least=f"{least / 1e5:.4g}",
            )
        return cycle._replace(limit=values["peak_pressure"])
    return cycle


def _heat(laws: list[Law], places: Volumes, values: Mapping[str, Any]) -> float:
    """The heat per swept volume (Pa) that gives the load. Raises GasError."""
    kinds = np.bincount(places.kind)
    swept = float((places.swept * kinds).sum())
    step = places.cycle / SAMPLES

    def mean(heat: float) -> float:
        work = [(law(heat) * rate).sum() for law, rate in zip(laws, places.rate, strict=True)]
        return float(np.dot(work, kinds)) * step / swept

    def peak(heat: float) -> float:
        return max(highest(law(heat)) for law in laws)

    wanted, found = _target(values), mean
    if "imep" not in values and "bmep" not in values:
        found = peak
    greatest = inf
    if values["process"] != "heat-release":
        greatest = ideal_cycles.greatest_heat(ideal_cycle(values))
    least = max(wanted, LEAST_STEP)
    low, high = 0.0, min(4 * least, greatest)
    if found(low) >= wanted:
        raise GasError(
            "the load is {load} bar, and without any combustion it is {least} bar; give more "
            "(`crankstar torque --motored` turns the engine without any)",
            load=f"{wanted / 1e5:.4g}",
            least=f"{found(low) / 1e5:.4g}",
        )
    while found(high) < wanted:
        if high >= greatest or high > 1e4 * least:
            raise GasError(
                "the load is {load} bar, and this cycle reaches {most} bar at most; give less, or "
                "a greater gas.compression_ratio than {ratio}",
                load=f"{wanted / 1e5:.4g}",
                most=f"{found(high) / 1e5:.4g}",
                ratio=f"{values['compression_ratio']:.8g}",
            )
        high = min(2 * high, greatest)
    return root(lambda heat: found(heat) - wanted, low=low, high=high)


def _target(values: Mapping[str, Any]) -> float:
    """What the load asks of the cycle, Pa."""
    if "imep" in values:
        return values["imep"]
    if "bmep" in values:
        friction = friction_of(values)
        if friction is None:
            raise GasError(
                "a brake mean effective pressure needs the friction, which goes with the speed: "
                'give the speed, as in --speed "3000 rpm", or gas.friction_pressure'
            )
        return values["bmep"] + friction
    return values["peak_pressure"]
