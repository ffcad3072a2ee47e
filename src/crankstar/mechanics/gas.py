"""The pressure in every chamber over a cycle, at an operating point of an engine.

What the engine file gives is used as it is; what it leaves out is assumed (`operating_points`), and
named in the answer. The heat of a cycle is sought so that the load comes out: for an indicated or
brake mean effective pressure the work of the samples themselves, W = sum p V' dtheta, so that mean
torque and mean effective pressure agree to rounding.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass, field, replace
from math import inf
from typing import Any

import numpy as np

from crankstar.engine.engine import Engine
from crankstar.engine.gas import LOADS
from crankstar.engine.volumes import Volumes
from crankstar.language.messages import _, _n
from crankstar.mechanics.charge_air import GREATEST_STEPS, SETTLED, air_fuel_ratio
from crankstar.mechanics.friction import friction_of
from crankstar.mechanics.gas_traces import charges_of_trace
from crankstar.mechanics.maxima import highest
from crankstar.mechanics.operating_points import (
    GasError,
    OperatingState,
    operating_state,
    own_speed,
    resolved,
)
from crankstar.mechanics.pressures import SAMPLES, charged, pressures, volumes_of
from crankstar.spectra import Real


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
    points, whose `shares` they are by name, all of it is between theirs but for a friction by
    correlation, which is that of the speed.
    """

    volumes: Volumes
    pressure: Real
    crankcase: float
    imep: float
    friction: float | None
    """Mean effective pressure; None where its correlation needs a speed that is not known."""
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
    friction_said: bool = False
    """Whether the file or who asks says what friction takes: itself, its correlation, or a bmep."""

    @property
    def bmep(self) -> float | None:
        """The brake mean effective pressure, Pa; None where the friction is not known."""
        return None if self.friction is None else self.imep - self.friction


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
    angle, and what comes of it, is between theirs, each at its own speed; a friction by correlation
    is that of the speed, and a load that is asked for comes out. Raises GasError.

    >>> from crankstar.files.catalog import load
    >>> found = cycle(load("audi-25-tfsi"), imep=12e5)
    >>> round(found.imep / 1e5, 9), len(found.pressure)
    (12.0, 5)
    """
    given = {"imep": imep, "bmep": bmep, "peak_pressure": peak_pressure}
    load = {name: value for name, value in given.items() if value is not None}
    check_together(load, motored=motored, off=off, weaker=weaker or ())
    check_gas(engine)
    lost = lost_shares(engine, off, weaker or {}, motored=motored)
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
    if motored or len(state.shares) == 1:
        return one
    if peak_pressure is not None:
        return _of_peak(one, peak_pressure, found)
    if bmep is not None and one.bmep not in (None, bmep):  # friction at the points is another
        one = found(bmep=2 * bmep - (one.bmep or 0.0))
        return replace(one, values={**one.values, "bmep": bmep})
    return one


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
        charge = {}
        if burns and "intake_pressure" in assumed:
            charge = charged(engine, places, values, assumed)
            values |= charge
        charges = charges_of_trace(engine, places, lost, assumed)
        rows, heat = pressures(engine, places, values, lost, charges, motored=motored)
    except ArithmeticError:
        raise GasError(
            "with these values the pressure has no end or falls to nothing: give more intake "
            "pressure, more speed, or a longer combustion nearer to the dead centre"
        ) from None
    work = (rows * places.rate[[*places.kind]]).sum(axis=-1) * places.cycle / SAMPLES
    return Cycle(
        volumes=places,
        pressure=rows,
        crankcase=values["crankcase_pressure"],
        imep=float(work.sum() / places.swept[[*places.kind]].sum()),
        friction=friction_of(values),
        peak=highest(rows),
        speed=values.get("speed"),
        name=name,
        values={**values, **next(iter(charges.values()), {}), "charges": charges},
        assumed=tuple(each for each in assumed if each not in next(iter(charges.values()), {})),
        motored=motored,
        weaker={key: share for key, share in lost.items() if 0 < share < 1},
        air_fuel_ratio=air_fuel_ratio(engine, places, values, heat) if heat > 0 else None,
        boosted=bool(charge),
        shares=((name, 1.0),),
        friction_said="bmep" in values or "friction" not in assumed,
    )


def _between(ends: Sequence[Cycle], state: OperatingState) -> Cycle:
    """The cycle between two operating points: all of it straight from the one to the other.

    A friction by correlation is that of the speed; where one point gives its own, it goes from that
    to the correlation. The `values` have a load where both ends have the same one.
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
    correlated = [own.values["friction"] for own in ends if "friction_pressure" not in own.values]
    if correlated:
        values["friction"] = correlated[0]
    rubs = [friction_of({**own.values, "speed": state.speed}) or 0.0 for own in ends]
    return replace(
        first,
        pressure=rows,
        imep=mean((first.imep, last.imep)),
        friction=mean((rubs[0], rubs[1])),
        peak=highest(rows),
        speed=state.speed,
        name="",
        values={**values, "speed": state.speed},
        assumed=tuple(dict.fromkeys((*first.assumed, *last.assumed))),
        air_fuel_ratio=values["intake_pressure"] / sum(fuel) if sum(fuel) else None,
        boosted=first.boosted or last.boosted,
        shares=state.shares,
        friction_said=first.friction_said and last.friction_said,
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
        if abs(found.peak - peak) <= SETTLED * peak:
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


def check_together(
    load: Collection[str] = (),
    *,
    motored: bool = False,
    off: Collection[int] = (),
    weaker: Collection[int] = (),
    named: Callable[[str], str] = str,
) -> None:
    """Refuse loads (their names) and cylinders that say contrary things. Raises GasError.

    A cycle has one load; a motored engine burns nothing, so that it has neither that nor cylinders
    that burn less; what is off is not weaker. `named` is what messages call an argument.

    >>> check_together(["imep"], off=[1, 2], weaker=[3])
    """
    loads = [named(name) for name in load]
    if motored:
        others = {"off": off, "weaker": weaker}
        if unused := [*loads, *(named(name) for name, own in others.items() if len(own))]:
            raise GasError(
                _n(
                    "{options} has no effect {when}; leave it out",
                    "{options} have no effect {when}; leave them out",
                    len(unused),
                    options=", ".join(unused),
                    when=_("with {option}", option=named("motored")),
                )
            )
    if len(loads) > 1:
        raise GasError(
            "{one} and {other} both say how much a cycle does; give one",
            one=loads[0],
            other=loads[1],
        )
    if both := sorted({*off} & {*weaker}):
        raise GasError(
            "cylinder {number} is {off} and cannot be {weaker} besides; leave one out",
            number=both[0],
            off=named("off"),
            weaker=named("weaker"),
        )


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
