"""What is felt of a fault, by figures."""

from __future__ import annotations

from collections.abc import Sequence
from functools import reduce
from typing import TYPE_CHECKING

from crankstar.analysis.assumptions import Answer
from crankstar.analysis.tried_values import Figures
from crankstar.engine.engine import Engine
from crankstar.studies.answer_parts import IN_VIBRATION, gas_of, tuned_on_mounts, usual_gas
from crankstar.studies.assumed_gas import usual_load
from crankstar.studies.assumed_loads import of_load
from crankstar.studies.gas_alone import lacking_gas

if TYPE_CHECKING:
    from crankstar.studies.fault_kinds import Fault


def felt(
    engine: Engine,
    faults: Sequence[Fault],
    *,
    point: str = "",
    speed: float | None = None,
    orders: Sequence[float] = (),
    at: Sequence[float] | None = None,
) -> Answer:
    """What shakes the block and the velocity of a point of it, of an engine with faults, by order.

    Of the `orders` that are named, at the point `at` (up, right, z; m) or the centre of mass,
    wherever that is: the numbers of `Shaken.sizes`.
    """
    from crankstar.studies.single_faults import fired, lost_combustion, shaken, with_fault

    units = {"force": "N", "couple": "N*m", "roll": "N*m", "torque": "N*m", "velocity": "mm/s"}

    def figures(each: Engine) -> Figures:
        found = shaken(fired(each, faults), faults, point=point, speed=speed, orders=orders)
        return {
            (name, order): size
            for order, row in zip(found.orders.tolist(), found.sizes(at).tolist(), strict=True)
            for name, size in zip(units, row, strict=True)
        }

    built = reduce(with_fault, faults, engine)
    burning = fired(engine, faults)
    gas, why = gas_of(burning, point=point, speed=speed, weaker=lost_combustion(faults))
    usual, short = usual_gas(burning, speed=speed)
    left = None if usual is None else usual_load(usual, figures, IN_VIBRATION)
    if left is None:
        left = lacking_gas(burning, figures, IN_VIBRATION, speed=speed, point=point)
    tunings = []
    if engine.mounts:
        now = shaken(burning, faults, point=point, speed=speed, orders=orders)
        tunings = [tuned_on_mounts(now.orders.tolist(), between=(now.speed, now.speed))]
    return Answer(
        figures=figures,
        unit=lambda quantity, _engine: units[quantity],
        uses=("inertia", "mounts", *(("gas",) if gas is not None else ())),
        gas=gas,
        gasless="" if left else IN_VIBRATION,
        why_gasless=why or short,
        choices=[*([left] if left else []), *of_load(built, gas)],
        tunings=tunings,
    )
