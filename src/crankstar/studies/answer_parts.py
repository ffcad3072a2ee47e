"""Answers about fewer quantities, without a speed, and several as one."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import replace

from crankstar.analysis.assumptions import Answer, Assumption, Moved
from crankstar.analysis.changed_values import with_gas_choice
from crankstar.analysis.tried_values import Figure, Figures, Tuning
from crankstar.engine.copies import with_values
from crankstar.engine.engine import Engine
from crankstar.language.messages import N_
from crankstar.mechanics.balance import balance
from crankstar.mechanics.gas import Cycle, computable, cycle, cycle_or_reason
from crankstar.mechanics.gas_torque import brake_torque
from crankstar.mechanics.operating_points import GasError
from crankstar.studies.assumed_gas import CHOICES

Figured = Callable[[Engine], Figures]
TURNING = ("cylinder.rotating_mass", "cylinder.throw_mass", "crankshaft.weight")
"""What turns evenly: no pressure, torque or side thrust depends on it."""
IN_VIBRATION = N_("Not in the forced vibration: {paths}.")
IN_GUIDES = N_("Without guide-force moments: {paths}.")
"""What gas that is not known is missing in, by what an answer is about."""

IN_OWN_UNIT = N_(
    "compared in m r ω², without a speed, as its own file lacks masses, sizes or a speed"
)
IN_OTHER_UNIT = N_(
    "compared in m r ω², without a speed, as an engine beside it has no masses, sizes or speed"
)
"""Why rolling moments of a file with gas are without it where not all have them in N m."""


def in_whose_unit(engine: Engine, speed: float | None) -> str:
    """Why an engine among others is compared in m r omega^2 at a `speed` (rad/s): it, or another.

    >>> from crankstar.files.catalog import load
    >>> in_whose_unit(load("triumph-675"), 100.0) == IN_OWN_UNIT
    True
    """
    own = engine.speed if speed is None else speed
    known = balance(engine, speed=own).units != balance(engine).units
    return IN_OTHER_UNIT if known else IN_OWN_UNIT


def without_speed(engine: Engine) -> Engine:
    """The engine with no speed of its own."""
    return engine if engine.speed is None else with_values(engine, speed=None)


def in_own_unit(answer: Answer) -> Answer:
    """The answer of an engine without its speed: in m r omega^2, as without a speed in its file."""
    made = _with_figures(answer, lambda figures: lambda engine: figures(without_speed(engine)))
    return replace(
        made,
        choices=[each for each in made.choices if each.path != "gas"],  # it would be in N m
        gasless=next((each.sentence for each in made.choices if each.path == "gas"), made.gasless),
        unit=lambda quantity, engine: answer.unit(quantity, without_speed(engine)),
        least=lambda engine: answer.least(without_speed(engine)),
        without_gas=None,
        given={*answer.given, "speed"},
    )


def narrowed(
    answer: Answer,
    quantities: Collection[str],
    *,
    orders: Sequence[float] | None = None,
    given: Collection[str] = (),
) -> Answer:
    """The answer as far as it is about these quantities, of these orders, all without any named.

    A choice that is known to move another quantity is none of it. `given` are key paths that do
    not matter to them. Where nothing of them is left, nothing moves.
    """
    nothing: Figures = {(next(iter(quantities)), None): 0.0}

    def kept(figures: Figures) -> Figures:
        return {
            (name, order): size
            for (name, order), size in figures.items()
            if name in quantities and (orders is None or order in orders)
        }

    made = _with_figures(answer, lambda figures: lambda engine: kept(figures(engine)))
    return replace(
        made,
        figures=lambda engine: made.figures(engine) or nothing,
        given={*answer.given, *given},
        shown=(),
        choices=[
            each for each in made.choices if each.moved is None or each.moved.quantity in quantities
        ],
    )


def _with_figures(answer: Answer, made: Callable[[Figured], Figured]) -> Answer:
    """An answer with other figures made from its own, in its choices too."""
    choices = [
        each if each.figures is None else replace(each, figures=made(each.figures))
        for each in answer.choices
    ]
    return replace(answer, figures=made(answer.figures), choices=choices)


def joined(parts: Sequence[Answer]) -> Answer:
    """Several answers as one; what no part of it depends on is given."""
    first = parts[0]
    owners: dict[str, Answer] = {}

    def figures(engine: Engine) -> Figures:
        out: dict[Figure, float] = {}
        for part in reversed(parts):
            own = part.figures(engine)
            owners.update((quantity, part) for quantity, _order in own)
            out |= own
        return out

    def unit(quantity: str, engine: Engine) -> str:
        if quantity not in owners:
            figures(engine)
        return owners.get(quantity, first).unit(quantity, engine)

    choices: dict[str, Assumption] = {}
    for each in (each for part in parts for each in part.choices):
        choices.setdefault(each.path, each)  # that of what is said first

    def least(engine: Engine) -> Mapping[str, float]:
        return {name: size for part in parts for name, size in part.least(engine).items()}

    return Answer(
        figures=figures,
        unit=unit,
        uses=[*dict.fromkeys(each for part in parts for each in part.uses)],
        gas=next((part.gas for part in parts if part.gas is not None), None),
        without_gas=first.without_gas,
        least=least,
        given=set.intersection(*({*part.given} for part in parts)),
        gasless=next((part.gasless for part in parts if part.gasless), ""),
        why_gasless=next((part.why_gasless for part in parts if part.why_gasless), ""),
        choices=[*choices.values()],
        tunings=[each for part in parts for each in part.tunings],
    )


def gas_of(
    engine: Engine,
    *,
    speed: float | None,
    point: str = "",
    weaker: Mapping[int, float] | None = None,
) -> tuple[Cycle | None, str]:
    """The cycle of an engine, or why there is none though its file has gas.

    Cylinders are `weaker` as in `cycle`.
    """
    if engine.gas is None:
        return None, ""
    return cycle_or_reason(engine, speed=speed, point=point, weaker=weaker)


NO_BORE = N_("its size needs cylinder.bore")
"""Why nothing is said of the gas of an engine whose file has none."""


NO_FIRING = N_("its torque needs firing_order")
"""The same of one without a firing order."""
NO_UNITS = N_("its share needs masses, sizes and a speed")
"""The same of one without masses or sizes, or of an answer without a speed."""


def usual_gas(engine: Engine, *, speed: float | None) -> tuple[Cycle | None, str]:
    """The usual cycle of an engine whose file has no gas, or why there is none.

    None and no reason where the file has gas.
    """
    if engine.gas is not None:
        return None, ""
    if {"mass", "radius"} & {*engine.relative} or (speed is None and engine.speed is None):
        return None, NO_UNITS
    if any(cylinder.bore is None for cylinder in engine.cylinders):
        return None, NO_BORE
    if not computable(engine):
        return None, "" if engine.firing_order else NO_FIRING
    try:
        return cycle(engine, speed=speed), ""
    except GasError:
        return None, ""


def gas_as_in(engine: Engine, changed: Engine) -> Engine:
    """A changed engine, without gas where the file has none: a usual cycle may have been varied."""
    return with_values(changed, gas=None) if engine.gas is None else changed


def friction_of_power(engine: Engine, found: Cycle | None) -> list[Assumption]:
    """The assumed friction of a cycle by the brake torque, where the power is said beside figures.

    No moment depends on it; the other of the two is tried. Nothing without a speed.
    """
    if found is None or found.speed is None or "friction" not in found.assumed:
        return []
    value, ignition = found.values["friction"], found.values["ignition"]
    if value not in CHOICES["friction"]:
        return []
    other = next(each for each in CHOICES["friction"] if each != value)
    changed = with_gas_choice("friction", other, ignition=ignition)(engine, 1.0)
    now, then = (
        brake_torque(each) or 0.0
        for each in (found, cycle(changed, point=found.name, speed=found.speed))
    )
    effect = abs(then - now) / max(abs(now), abs(then))
    moved = Moved("brake torque", None, "N*m", now, then, then, effect)
    reason = N_("usual for such engines")
    own = Assumption(
        "assumed", "gas.friction", reason, value, "", 1.0, 1.0, values=(("other", other),),
        named=True, moved=moved,
    )  # fmt: skip
    return [own]


def tuned_on_mounts(orders: Sequence[float], *, between: tuple[float, float]) -> Tuning:
    """The natural frequencies of an engine on its mounts and the orders of some speeds, rad/s."""
    from crankstar.dynamics.mount_modes import mount_modes
    from crankstar.dynamics.mounted_block import mounted_block

    def natural(each: Engine) -> list[float]:
        return [mode.speed for mode in mount_modes(mounted_block(each))]

    return Tuning(natural, orders, between)
