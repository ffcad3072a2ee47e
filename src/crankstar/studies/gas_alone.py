"""What a file lacks for the inertia beside its gas: masses, a speed."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator
from math import pi

from crankstar.analysis.assumptions import Assumption
from crankstar.analysis.tried_values import Figures
from crankstar.engine.copies import with_values
from crankstar.engine.engine import Engine
from crankstar.engine.proportions import inferred, look_of, piston_speed
from crankstar.language.messages import N_
from crankstar.mechanics.gas import Cycle

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
        yield Assumption(
            "left out", "cylinder.reciprocating_mass", N_("the torque of inertia needs it"),
            explained=True,
        )  # fmt: skip
    elif found.speed is None:
        usual = usual_speeds(engine)
        if usual is None:
            return
        low, high = usual
        yield Assumption(
            "missing", "speed", N_("no speed in the file, so that no inertia is beside the gas"),
            None, "rpm", low, high, vary=with_speed, figures=alternating,
        )  # fmt: skip


def usual_speeds(engine: Engine) -> tuple[float, float] | None:
    """The least and the greatest rated speed (rpm) of such engines; None where no size is known."""
    look = look_of(engine, engine.gas)
    if look is None:
        return None
    slow, _usual, fast = piston_speed(inferred(look)[0])
    return 30 * slow / look.stroke, 30 * fast / look.stroke  # the mean speed is 2 S n


def with_speed(engine: Engine, rpm: float) -> Engine:
    """The engine with a speed of its own."""
    return with_values(engine, speed=rpm * pi / 30)
