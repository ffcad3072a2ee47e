"""The maximum load of each bearing, pin and cylinder wall, and that of order 1."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Collection, Sequence
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING, Any

from crankstar import spectra
from crankstar.analysis.assumptions import FIRST_LOAD, MAIN_OF, PIN_OF, WALL_OF, Answer, Assumption
from crankstar.analysis.tried_values import Figure, Figures
from crankstar.engine.engine import Engine
from crankstar.language.messages import N_
from crankstar.mechanics.balance import scales
from crankstar.mechanics.gas import Cycle, computable, cycle
from crankstar.studies.answer_parts import gas_of, joined, usual_gas
from crankstar.studies.answers import amplitudes
from crankstar.studies.assumed_gas import usual_load
from crankstar.studies.gas_alone import lacking_gas

if TYPE_CHECKING:
    from crankstar.dynamics.bearings import BearingLoads

MakeCycle = Callable[[Engine], Cycle | None]
GAS_OPTION = N_("--gas adds it")
USUAL_OPTION = N_("--gas adds that of a usual cycle")
USUAL_CYCLE = N_("no table [gas] in the file; --gas adds that of a usual cycle")
"""Why loads are without gas, of a file with gas, of one without, and where it can be computed."""
IN_LOADS = N_("Not in the loads: {paths}.")
KINDS = (MAIN_OF, PIN_OF, WALL_OF)
"""What bears loads, as quantities: before its number."""
MODELS = ("determinate", "continuous")
"""How a crankshaft stands on its main bearings: as is usual, and the other way."""


def bearing_peaks(
    engine: Engine,
    make: MakeCycle,
    *,
    speed: float | None = None,
    model: Any = "determinate",
    kinds: Sequence[str] = KINDS,
) -> Answer:
    """The maximum load of each main bearing, crankpin and cylinder wall, or of some of the KINDS.

    >>> from crankstar.files.catalog import load
    >>> twin = load("v2-90")
    >>> figures = bearing_peaks(twin, lambda _: None).figures(twin)
    >>> [name for name, _order in figures]
    ['main bearing 1', 'main bearing 2', 'crank pin 1', 'cylinder wall 1', 'cylinder wall 2']
    """

    def found(each: Engine, again: Cycle | None, model: Any) -> Any:
        from crankstar.dynamics.bearings import bearing_loads

        own = each.speed if speed is None else speed
        turning = own if again is None else again.speed
        return bearing_loads(each, speed=turning, model=model, cycle=again)

    def of_cycle(each: Engine, again: Cycle | None, model: Any) -> Figures:
        return _peaks(found(each, again, model), kinds)

    def figures(each: Engine, *, model: Any = model) -> Figures:
        return of_cycle(each, make(each), model)

    def with_gas(each: Engine) -> Figures:
        return of_cycle(each, cycle(each, speed=speed), model)

    first = make(engine)
    choices = _other_model(engine, partial(figures, model=MODELS[1])) if model == MODELS[0] else []
    left = None if first is not None else _unburnt(engine, speed, with_gas)
    return Answer(
        figures=figures,
        unit=lambda _quantity, each: found(each, make(each), model).unit,
        uses=("inertia", "bearings", *(("gas",) if first is not None else ())),
        gas=first,
        gasless="" if left is not None else IN_LOADS,
        why_gasless=_why_gasless(engine, speed),
        choices=choices if left is None else [*choices, left],
    )


def _other_model(engine: Engine, figures: Callable[[Engine], Figures]) -> list[Assumption]:
    """The usual model of a crankshaft, of which these are the figures with the other one."""
    reason = N_("a crankshaft hinged at each main bearing")
    if any(shaft.bending_stiffness for shaft in engine.shafts):
        reason = N_("the bending stiffness of the file is not used")
    shared = Assumption(
        "assumed", "--model", reason, MODELS[0], low=1.0, high=1.0, values=(("other", MODELS[1]),),
        named=True, vary=lambda each, _value: each, figures=figures,
    )  # fmt: skip
    return [shared]


def first_load(engine: Engine, *, speed: float | None = None, model: Any = "determinate") -> Answer:
    """The greatest load of order 1 on a main bearing, of inertia and weights, in N at a speed.

    >>> from crankstar.files.catalog import load
    >>> first_load(load("i4")).figures(load("i4"))
    {('main bearing', 1.0): 1.0}
    """

    def figures(each: Engine, *, model: Any = model) -> Figures:
        from crankstar.remedy.aims import bearing_load

        forces = [scales(each, own)[0].force for own in (_turning(each), None)]
        return {(FIRST_LOAD, 1.0): bearing_load(each, model=model) * forces[0] / forces[1]}

    def _turning(each: Engine) -> float | None:
        return each.speed if speed is None else speed

    other = partial(figures, model=MODELS[1])
    return Answer(
        figures=figures,
        unit=lambda _quantity, each: scales(each, _turning(each))[1].force,
        uses=("inertia", "bearings"),
        choices=_other_model(engine, other) if model == MODELS[0] else [],
    )


def balanced(
    engine: Engine, *, fitted: bool, gas_orders: Collection[float], model: Any = "determinate"
) -> Answer:
    """What a balancing sheet prints of an engine: what remains by order, and the load of order 1.

    Weights that were `fitted` balance nothing that the file lacks. The rolling moment stands with
    gas in `gas_orders`.
    """
    remaining = amplitudes(engine, both=bool(gas_orders))

    def printed(each: Engine) -> Figures:
        return {
            (name, order): size
            for (name, order), size in remaining.figures(each).items()
            if name != "roll with gas" or order in gas_orders
        }

    whole = joined([replace(remaining, figures=printed), first_load(engine, model=model)])
    return replace(whole, uses=[*whole.uses, "fitted"]) if fitted else whole


def _peaks(loads: BearingLoads, kinds: Sequence[str]) -> Figures:
    """The maximum load of each part; a number that two crankshafts have goes with the shaft."""
    mains = [(own.shaft, own.number) for own in loads.bearings]
    pins = [(own.shaft, own.throw) for own in loads.pins]
    walls = [("", number) for number in loads.cylinders]
    signals = (loads.load, loads.pin, loads.guide)
    out: dict[Figure, float] = {}
    for kind, parts, signal in zip(KINDS, (mains, pins, walls), signals, strict=True):
        if kind not in kinds:
            continue
        shared = Counter(number for _shaft, number in parts)
        for (shaft, number), size in zip(parts, spectra.peaks(signal).tolist(), strict=True):
            name = f"{number} ({shaft})" if shared[number] > 1 else str(number)
            out[f"{kind}{name}", None] = size
    return out


def _unburnt(
    engine: Engine, speed: float | None, with_gas: Callable[[Engine], Figures]
) -> Assumption | None:
    """The gas that loads leave out, and what it would change; None where it is not known."""
    usual = usual_gas(engine, speed=speed)[0]
    if usual is not None:
        return replace(usual_load(usual, with_gas, IN_LOADS), reason=USUAL_CYCLE)
    if gas_of(engine, speed=speed)[0] is None:
        return lacking_gas(engine, with_gas, IN_LOADS, speed=speed)
    if {"mass", "radius"} & {*engine.relative}:
        return None
    return Assumption(
        "left out", "gas", GAS_OPTION, low=1.0, high=1.0, explained=True, sentence=IN_LOADS,
        vary=lambda each, _value: each, figures=with_gas,
    )  # fmt: skip


def _why_gasless(engine: Engine, speed: float | None) -> str:
    """Why loads are without gas, or how they have it."""
    if engine.gas is not None:
        return gas_of(engine, speed=speed)[1] or GAS_OPTION
    known = computable(engine) and not {"mass", "radius"} & {*engine.relative}
    return USUAL_OPTION if known else usual_gas(engine, speed=speed)[1]
