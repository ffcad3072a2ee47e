"""The figures of what charts alone show: vectors of parts, side thrust."""

from __future__ import annotations

from collections.abc import Callable, Collection

import numpy as np

from crankstar.analysis.assumptions import Answer, Uses
from crankstar.analysis.tried_values import Figures
from crankstar.engine.engine import Engine
from crankstar.mechanics.balance import balance
from crankstar.mechanics.excitation import Reference
from crankstar.mechanics.gas import Cycle
from crankstar.mechanics.remains import pushed
from crankstar.studies.answer_parts import TURNING

FIRING = ("layout", "firing", "cylinders", "shaft", "rotation")
"""How key paths begin from which the crank angles come at which cylinders fire."""
NO_ANGLES = (
    *(".bank_offset", ".bore_pitch", ".crank_distance", ".rows", ".bore", ".z", ".right", ".up"),
    *("_mass", ".radius", ".rod_length"),
)
"""How those of them end that are no angles."""


def of_no_force(*, given: Collection[str] = (), uses: Collection[Uses] = ()) -> Answer:
    """What no force is in, but for the key paths `given` all that the file says of the engine."""
    return Answer(
        figures=lambda _engine: {("shape", None): 0.0},
        unit=lambda _quantity, _engine: "",
        uses=uses,
        given=given,
    )


def firing(engine: Engine, *, valves: bool = False) -> Answer:
    """When the cylinders fire: of the angles in the file, and of no length along the shaft.

    With `valves` also the timing that the file does not give.

    >>> from crankstar import load
    >>> five = load("audi-25-tfsi")
    >>> sorted({*five.provenance} - {*firing(five).given})
    ['firing_order']
    """
    others = [
        path
        for path in engine.provenance
        if not path.startswith(FIRING) or path.endswith(NO_ANGLES)
    ]
    return of_no_force(given=others, uses=("firing", "valves") if valves else ("firing",))


def vectors(
    quantity: str, *, speed: float | None = None, reference: Reference | None = None
) -> Answer:
    """The vectors of every part by order, added by their lengths: what a star of them shows."""

    def figures(each: Engine) -> Figures:
        own = each.speed if speed is None else speed
        parts = getattr(balance(each, speed=own, reference=reference), quantity)
        lengths = pushed(parts).tolist()
        return {
            ("vectors", order): size
            for order, size in zip(parts.orders.tolist(), lengths, strict=True)
        }

    def unit(_name: str, each: Engine) -> str:
        own = each.speed if speed is None else speed
        return getattr(balance(each, speed=own).units, quantity)

    return Answer(figures=figures, unit=unit)


def pressed(engine: Engine, make: Callable[[Engine], Cycle]) -> Answer:
    """The greatest side thrust of a piston, of gas and, where masses are known, inertia."""
    from crankstar.mechanics.side_thrust import side_thrust

    def figures(each: Engine) -> Figures:
        thrust = side_thrust(each, make(each)).total
        return {("cylinder wall", None): float(np.abs(thrust).max(initial=0.0))}

    return Answer(
        figures=figures,
        unit=lambda _quantity, _engine: "N",
        uses=("inertia", "gas"),
        gas=make(engine),
        given=TURNING,
    )
