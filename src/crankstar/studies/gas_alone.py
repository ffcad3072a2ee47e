"""What a file lacks for its gas, or for the inertia beside it: a bore, masses, a speed.

Each is tried over what `estimate` fills in.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator
from dataclasses import replace

from crankstar.analysis.assumptions import Assumption
from crankstar.analysis.tried_values import Figures
from crankstar.engine.copies import with_values
from crankstar.engine.engine import Engine
from crankstar.engine.gas import Gas
from crankstar.engine.proportions import (
    bores_in,
    inferred,
    look_of,
    piston_speed,
    proportion,
    row_pitch,
)
from crankstar.files import engine_of, explicit
from crankstar.files.references import absolute
from crankstar.language.messages import N_
from crankstar.language.numbers import RPM
from crankstar.mechanics.gas import Cycle, cycle_or_reason
from crankstar.mechanics.operating_points import ignition

ALTERNATING = ("roll", "torque", "roll with gas", "H moment", "X moment")
"""Quantities to which gas and inertia both belong."""


def gas_alone(
    engine: Engine,
    found: Cycle,
    figures: Callable[[Engine], Figures],
    quantities: Collection[str] = ALTERNATING,
) -> Iterator[Assumption]:
    """What a file lacks for the inertia in its torques and rolling moments.

    `figures` are those of the answer, of which only `quantities` move with the speed.

    >>> from crankstar.files.catalog import load
    >>> from crankstar.mechanics.gas import cycle
    >>> engine = load("audi-25-tfsi", changes={"speed": None, "gas.speed": None})
    >>> [one.path for one in gas_alone(engine, cycle(engine, point="full"), lambda _engine: {})]
    []
    """

    def alternating(each: Engine) -> Figures:
        return {key: size for key, size in figures(each).items() if key[0] in quantities}

    if {"mass", "radius"} & {*engine.relative}:
        usual = None if found.speed is None else usual_masses(engine)
        lacking = Assumption(
            "left out", "cylinder.reciprocating_mass", N_("the torque of inertia needs it"),
            explained=True,
        )  # fmt: skip
        if usual is not None:
            ends = {"unit": "kg", "low": usual[0], "high": usual[1]}
            lacking = replace(lacking, **ends, vary=with_masses, figures=alternating)
        yield lacking
    elif found.speed is None:
        usual = usual_speeds(engine)
        if usual is None:
            return
        low, high = usual
        yield Assumption(
            "missing", "speed", N_("no speed in the file, so that no inertia is beside the gas"),
            None, "rpm", low, high, vary=with_speed, figures=alternating,
        )  # fmt: skip


def lacking_gas(
    engine: Engine,
    figures: Callable[[Engine], Figures],
    sentence: str,
    *,
    speed: float | None,
    point: str = "",
) -> Assumption | None:
    """The gas of a file that lacks a bore or a speed for it, over the usual ones.

    `figures` are those with gas, `sentence` as of an `Assumption`. None where the gas is computed,
    the file has none, or nothing is known that would be usual.

    >>> from crankstar.files.catalog import load
    >>> engine = load("audi-25-tfsi", changes={"cylinder.bore": None})
    >>> found = lacking_gas(engine, lambda _engine: {}, "", speed=None)
    >>> [round(end, 1) for end in (found.low, found.high)], found.unit
    ([65.2, 83.8], 'mm')
    """
    if engine.gas is None or {"mass", "radius"} & {*engine.relative}:
        return None
    found, why = cycle_or_reason(engine, point=point, speed=speed)
    if found is not None:
        return None
    lacks, unit, vary = "cylinder.bore", "mm", with_bore
    if any(cylinder.bore is None for cylinder in engine.cylinders):
        ends = usual_bores(engine)
    else:
        known = speed is not None or engine.speed is not None
        ends, (lacks, unit, vary) = usual_speeds(engine), ("speed", "rpm", with_speed)
        ends = None if known else ends
    if ends is None:
        return None
    return Assumption(
        "left out", "gas", why, unit=unit, low=ends[0], high=ends[1],
        values=(("lacks", lacks), ("kind", kind_of(engine))),
        explained=True, sentence=sentence, vary=vary, figures=figures,
    )  # fmt: skip


def kind_of(engine: Engine) -> str:
    """The type of engine, as `crankstar estimate` names it; empty without a size."""
    look = look_of(engine, engine.gas)
    return "" if look is None else inferred(look)[0]


def usual_bores(engine: Engine) -> tuple[float, float] | None:
    """The least and the greatest bore (mm) with room at the bore pitch; None without a size."""
    look = look_of(engine, engine.gas)
    if look is None:
        return None
    kind = inferred(look)[0]
    least, usual, most = proportion("stroke", kind).sizes
    by_stroke = look.stroke / most, look.stroke / usual, look.stroke / least
    low, _typical, high = bores_in(by_stroke, row_pitch(engine), kind)
    return 1e3 * low, 1e3 * high


def with_bore(engine: Engine, bore: float) -> Engine:
    """The engine with a bore (mm) of all cylinders, ignited as before."""
    cylinders = [with_values(own, bore=bore / 1e3) for own in engine.cylinders]
    return with_values(engine, cylinders=tuple(cylinders), gas=_ignited(engine))


def _ignited(engine: Engine) -> Gas | None:
    """The gas of an engine, which ignites as it does whatever its size and speed."""
    gas = engine.gas
    return None if gas is None else with_values(gas, ignition=ignition(engine, gas)[0])


def usual_masses(engine: Engine) -> tuple[float, float] | None:
    """The least and the greatest reciprocating mass (kg) of such engines: m = (p + s r) D^3.

    p of the piston group, r of the rod, s the share of its small end; None where it is not known.
    """
    look, bore = look_of(engine, engine.gas), engine.first.bore
    if look is None or bore is None:
        return None
    kind = inferred(look)[0]
    try:
        groups, rods, shares = (
            proportion(part, kind) for part in ("piston group", "rod", "small end")
        )
    except KeyError:
        return None
    low, high = groups.low + shares.low * rods.low, groups.high + shares.high * rods.high
    return low * bore**3, high * bore**3


def with_masses(engine: Engine, mass: float) -> Engine:
    """The engine whose masses count in that of its first piston, with this (kg) for it."""
    tree = explicit(engine)
    absolute(tree, {"mass": mass})
    return engine_of(tree, name=engine.name)


def usual_speeds(engine: Engine) -> tuple[float, float] | None:
    """The least and the greatest rated speed (rpm) of such engines; None where no size is known."""
    look = look_of(engine, engine.gas)
    if look is None:
        return None
    slow, _usual, fast = piston_speed(inferred(look)[0])
    return 30 * slow / look.stroke, 30 * fast / look.stroke  # the mean speed is 2 S n


def with_speed(engine: Engine, rpm: float) -> Engine:
    """The engine with a speed of its own, ignited as before."""
    return with_values(engine, speed=rpm / RPM, gas=_ignited(engine))
