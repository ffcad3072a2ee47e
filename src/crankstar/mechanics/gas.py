"""The pressure in every chamber over a cycle, at an operating point of an engine.

What the engine file gives is used as it is; what it leaves out is assumed (`operating_points`), and
named in the answer. The heat of a cycle is sought so that the load comes out: for an indicated or
brake mean effective pressure the work of the samples themselves, W = sum p V' dtheta, so that mean
torque and mean effective pressure agree to rounding.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import lru_cache
from math import inf, pi
from typing import Any

import numpy as np

from crankstar.engine.engine import Engine
from crankstar.engine.gas import LOADS
from crankstar.engine.volumes import Volumes, volumes
from crankstar.language.messages import _
from crankstar.mechanics import heat_release, ideal_cycles, real_gas
from crankstar.mechanics.charge_air import GREATEST_STEPS, SETTLED, air_fuel_ratio, boosted, events
from crankstar.mechanics.friction import friction_pressure
from crankstar.mechanics.gas_traces import charges_of_trace, traced
from crankstar.mechanics.operating_points import (
    GasError,
    OperatingState,
    operating_state,
    own_speed,
    resolved,
)
from crankstar.mechanics.roots import root
from crankstar.spectra import Real

LEAST_STEP = 1e5
"""Pa: a heat per swept volume, up from which that of a load is sought."""
SAMPLES = 3600
"""Samples of a cycle: a fifth of a degree of a four-stroke one."""


@dataclass(frozen=True)
class Cycle:
    """The pressure in every chamber over a cycle, SI.

    >>> from crankstar import cycle
    >>> idle = cycle("audi-25-tfsi", speed="800 rpm", imep="2 bar")
    >>> idle.pressure.shape, "gamma" in idle.assumed, bool(idle.peak > 10e5)
    ((5, 3600), True, True)

    `pressure` [chamber, sample], absolute, at the equal steps of `volumes` from the dead centre at
    which the chamber fires; mean effective pressures over all chambers; `values` are all that went
    into it, `assumed` the names of those that the file does not give. Chambers that are `off` burn
    nothing; of those that are `weaker` the share is given that they lack. Between two operating
    points, whose `shares` they are by name, all of it is between theirs.
    """

    volumes: Volumes
    pressure: Real
    crankcase: float
    imep: float
    friction: float
    peak: float
    speed: float | None
    name: str
    values: Mapping[str, Any]
    assumed: tuple[str, ...]
    off: tuple[int, ...] = ()
    motored: bool = False
    weaker: Mapping[int, float] = field(default_factory=dict[int, float])
    air_fuel_ratio: float | None = None
    """Of the masses in a chamber that burns; None of a measured trace, and where none burns."""
    boosted: bool = False
    """Whether the charge pressure is estimated from the load: see `boosted`."""
    shares: tuple[tuple[str, float], ...] = ()

    @property
    def bmep(self) -> float:
        """The brake mean effective pressure, Pa."""
        return self.imep - self.friction


def cycle(
    engine: Engine,
    *,
    point: str = "",
    speed: float | None = None,
    motored: bool = False,
    off: Collection[int] = (),
    weaker: Mapping[int, float] | None = None,
    imep: float | None = None,
    bmep: float | None = None,
    peak_pressure: float | None = None,
) -> Cycle:
    """The cycle of an engine at an operating point and speed, as `operating_state` has them.

    `speed` (rad/s) and a load (one of imep, bmep, peak_pressure, Pa) stand before what the file
    gives. A `motored` engine burns nothing, and so do the chambers of the cylinders that are `off`;
    those that are `weaker` lack a share of their combustion, by cylinder: the others burn what they
    would. What does not burn is compressed from the charge pressure of the point, and with a
    measured pressure from the one that the trace has. Between two points the pressure at each
    angle, and what comes of it, is between theirs, each at its own speed. Raises GasError.

    >>> from crankstar.files.catalog import load
    >>> found = cycle(load("audi-25-tfsi"), imep=12e5)
    >>> round(found.imep / 1e5, 9), len(found.pressure)
    (12.0, 5)
    """
    check_gas(engine)
    lost = lost_shares(engine, off, weaker or {}, motored=motored)
    given = {"imep": imep, "bmep": bmep, "peak_pressure": peak_pressure}
    load = {name: value for name, value in given.items() if value is not None}
    state = operating_state(engine, point=point, speed=speed)
    silent = chambers_of(engine, off)
    if not motored:  # weak pistons of one chamber may together leave it nothing to burn
        silent |= {number for number, share in lost.items() if share >= 1}

    def found(**asked: float) -> Cycle:
        ends = [
            _at_point(
                engine,
                name,
                state.speed if len(state.shares) == 1 else own_speed(engine, name),
                {**load, **asked},
                lost,
                motored=motored,
            )
            for name, _share in state.shares
        ]
        one = ends[0] if len(ends) == 1 else _between(ends, state)
        return replace(one, off=tuple(sorted(silent)))

    one = found()
    if peak_pressure is None or motored:
        return one
    return _of_peak(one, peak_pressure, found)


def _at_point(
    engine: Engine,
    name: str,
    speed: float | None,
    load: Mapping[str, float],
    lost: Mapping[int, float],
    *,
    motored: bool,
) -> Cycle:
    """The cycle of one operating point, "" for the load of the table [gas]. Raises GasError."""
    values, assumed = resolved(engine, point=name, speed=speed, load=load)
    stroke = 2 * engine.throw(engine.first).radius
    values["stroke"] = stroke
    places = volumes_of(engine)
    burns = not motored and (engine.gas is None or engine.gas.trace is None)
    try:
        charged = {}
        if burns and "intake_pressure" in assumed:
            charged = _charged(engine, places, values, assumed)
            values |= charged
        charges = charges_of_trace(engine, places, lost, assumed)
        rows, heat = _pressures(engine, places, values, lost, charges, motored=motored)
    except ArithmeticError:
        raise GasError(
            "with these values the pressure has no end or falls to nothing: give more intake "
            "pressure, more speed, or a longer combustion nearer to the dead centre"
        ) from None
    work = (rows * places.rate[[*places.kind]]).sum(axis=-1) * places.cycle / SAMPLES
    turning = values.get("speed")
    friction = 0.0 if turning is None else _friction(values)
    return Cycle(
        volumes=places,
        pressure=rows,
        crankcase=values["crankcase_pressure"],
        imep=float(work.sum() / places.swept[[*places.kind]].sum()),
        friction=friction,
        peak=float(rows.max()),
        speed=turning,
        name=name,
        values={**values, **next(iter(charges.values()), {}), "charges": charges},
        assumed=tuple(each for each in assumed if each not in next(iter(charges.values()), {})),
        motored=motored,
        weaker={key: share for key, share in lost.items() if 0 < share < 1},
        air_fuel_ratio=air_fuel_ratio(engine, places, values, heat) if heat > 0 else None,
        boosted=bool(charged),
        shares=((name, 1.0),),
    )


def _between(ends: Sequence[Cycle], state: OperatingState) -> Cycle:
    """The cycle between two operating points: all of it straight from the one to the other.

    Its `values` have a load where both ends have the same one.
    """
    shares = [share for _name, share in state.shares]

    def mean(pair: tuple[float, float]) -> float:
        return pair[0] if pair[0] == pair[1] else float(np.dot(shares, pair))

    first, last = ends
    rows = shares[0] * first.pressure + shares[1] * last.pressure
    fuel = [
        share * own.values["intake_pressure"] / (own.air_fuel_ratio or inf)
        for own, share in zip(ends, shares, strict=True)
    ]
    values = _values_between(first.values, last.values, mean)
    for name in LOADS:
        if first.values.get(name) != last.values.get(name):
            values.pop(name, None)
    return replace(
        first,
        pressure=rows,
        imep=mean((first.imep, last.imep)),
        friction=mean((first.friction, last.friction)),
        peak=float(rows.max()),
        speed=state.speed,
        name="",
        values={**values, "speed": state.speed},
        assumed=tuple(dict.fromkeys((*first.assumed, *last.assumed))),
        air_fuel_ratio=values["intake_pressure"] / sum(fuel) if sum(fuel) else None,
        boosted=first.boosted or last.boosted,
        shares=state.shares,
    )


def _values_between(
    one: Mapping[Any, Any], other: Mapping[Any, Any], mean: Callable[[tuple[float, float]], float]
) -> dict[Any, Any]:
    """What both have, numbers between theirs."""
    out: dict[Any, Any] = {}
    for name in (each for each in one if each in other):
        first, last = one[name], other[name]
        if isinstance(first, Mapping):
            out[name] = _values_between(first, last, mean)
        else:
            out[name] = mean((first, last)) if isinstance(first, float) else first
    return out


def _of_peak(found: Cycle, peak: float, again: Callable[..., Cycle]) -> Cycle:
    """The cycle of a peak pressure (Pa) between two points, whose own peaks are at other angles."""
    asked = peak
    for _step in range(GREATEST_STEPS):
        if len(found.shares) == 1 or abs(found.peak - peak) <= SETTLED * peak:
            break
        asked *= peak / found.peak
        found = again(peak_pressure=asked)
    return found


def cycle_or_reason(
    engine: Engine,
    *,
    point: str = "",
    speed: float | None = None,
    off: Collection[int] = (),
    weaker: Mapping[int, float] | None = None,
) -> tuple[Cycle | None, str]:
    """The cycle at an operating point, or None and why there is none.

    Raises GasError for a point that is named, and for cylinders that are `off` or `weaker`.

    >>> from crankstar.files.catalog import load
    >>> cycle_or_reason(load("i4"))
    (None, 'the engine file has no table [gas]')
    """
    asked = bool(point or off or weaker)
    if engine.gas is None and not asked:
        return None, _("the engine file has no table [gas]")
    try:
        return cycle(engine, point=point, speed=speed, off=off, weaker=weaker), ""
    except GasError as error:
        if asked:
            raise
        return None, str(error)


def check_gas(engine: Engine) -> None:
    """Raises GasError for an engine whose gas cannot be computed, with what it needs."""
    if any(cylinder.bore is None for cylinder in engine.cylinders):
        raise GasError("gas forces need the bore: give cylinder.bore in the engine file")
    if "radius" in engine.relative:
        raise GasError("gas forces need sizes: give cylinder.stroke in the engine file")
    if len(engine.chambers) > 1 and not engine.firing_order:
        raise GasError("gas torque needs a firing order: give firing_order in the engine file")
    slow = {abs(float(engine.shaft(c.shaft).speed_ratio)) for c in engine.cylinders}
    if slow != {1.0}:
        raise GasError(
            "gas torque needs crankshafts that all turn equally fast: give each the speed_ratio "
            "1 or -1"
        )


def chambers_of(engine: Engine, cylinders: Collection[int]) -> set[int]:
    """The chambers of these cylinders, by number. Raises GasError for one that is not there."""
    known = {c.number: key for key, own in engine.chambers.items() for c in own}
    strange = sorted(set(cylinders) - set(known))
    if strange:
        raise GasError(
            "no cylinder has the number {number}; the engine has {numbers}",
            number=strange[0],
            numbers=", ".join(map(str, known)),
        )
    return {known[number] for number in cylinders}


def lost_shares(
    engine: Engine, off: Collection[int], weaker: Mapping[int, float], *, motored: bool = False
) -> dict[int, float]:
    """The share of its combustion that each chamber lacks, by number. Raises GasError.

    What cylinders of one chamber lack adds up, to all of it at most.

    >>> from crankstar.files.catalog import load
    >>> lost_shares(load("honda-b18c"), [2], {3: 0.25})
    {1: 0.0, 2: 1.0, 3: 0.25, 4: 0.0}
    """
    lost = dict.fromkeys(engine.chambers, 1.0 if motored else 0.0)
    for number, share in [*weaker.items(), *dict.fromkeys(off, 1.0).items()]:
        [chamber] = chambers_of(engine, [number])
        if not 0 <= share <= 1:
            raise GasError(
                "cylinder {number} cannot lack {share} of its combustion; give a share from 0 to 1",
                number=number,
                share=f"{share:g}",
            )
        lost[chamber] = min(lost[chamber] + float(share), 1.0)
    return lost


def computable(engine: Engine) -> bool:
    """Whether sizes and firing order are known, so that there can be cycles at all."""
    try:
        check_gas(engine)
    except GasError:
        return False
    return True


@lru_cache(maxsize=64)
def volumes_of(engine: Engine) -> Volumes:
    """The chambers of an engine at the samples of a cycle."""
    return volumes(engine, SAMPLES)


Law = Callable[[float], Real]
"""From a heat per swept volume (Pa) to the pressure, Pa [sample]."""


def _pressures(
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


def _charged(
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
        return max(float(law(heat).max()) for law in laws)

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
            "the load is {load} bar, and without any combustion it is {least} bar; give more, or "
            "use --motored",
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
        if "speed" not in values:
            raise GasError("a brake mean effective pressure needs the speed: give speed")
        return values["bmep"] + _friction(values)
    return values["peak_pressure"]


def _friction(values: Mapping[str, Any]) -> float:
    """The friction mean effective pressure, Pa: as given, or by a correlation."""
    given = values.get("friction_pressure")
    if given is not None:
        return given
    return friction_pressure(values["friction"], speed=values["speed"], stroke=values["stroke"])
