"""The crank angles at which the chambers of a firing order fire, and why an order cannot be.

A chamber fires at a top dead centre. In one cycle (one turn of a two-stroke engine, two of a
four-stroke one) each fires once. A firing order fits when such dead centres can be found one after
the other within one cycle; where there is a choice, the most even intervals are taken.
"""

from __future__ import annotations

from itertools import pairwise
from math import degrees, inf
from typing import Any

import numpy as np

from crankstar.engine.assembly import Assembly
from crankstar.engine.copies import with_banks_mirrored, with_rotation_reversed
from crankstar.engine.dead_centres import SAME_ANGLE, DeadCentre, dead_centres
from crankstar.language.faults import Fault

ANGLE_TOLERANCE = 1.0
"""Degrees by which a firing angle written in a file may miss the dead centre it names."""


def firing_angles(engine: Assembly) -> list[float]:
    """The crank angle (degrees) of each firing, in the order of `firing_order`; or none.

    The order must fit, as that of every Engine does.
    """
    return _angles(engine)[1]


def unfit(engine: Assembly) -> list[Fault]:
    """Why the firing order cannot be: empty if it can (or if there is none)."""
    return _angles(engine)[0]


def _angles(engine: Assembly) -> tuple[list[Fault], list[float]]:
    """Why the firing order cannot be, and if it can the angles at which it fires."""
    if not engine.firing_order:
        return [], []
    centres = dead_centres(engine)
    if engine.firing_angles:
        faults = _wrong_angles(engine, centres)
        return faults, [] if faults else _given_angles(engine)
    angles = _evenest(engine.firing_order, centres, engine.cycle_angle)
    return ([], angles) if angles is not None else ([_unfit(engine, centres)], [])


def _unfit(engine: Assembly, centres: dict[int, DeadCentre]) -> Fault:
    """The fault of an impossible firing order: its dead centres, and a change that makes it fit.

    The change is the banks on the other sides, the other rotation, or firing together.
    """
    values: dict[str, Any] = {
        "order": "-".join(map(str, engine.firing_order)),
        "cycle": engine.cycle_angle,
        "centres": {
            number: round(centre.angle_deg, 3) for number, centre in sorted(centres.items())
        },
    }
    plain = Assembly.model_validate(
        {name: getattr(engine, name) for name in Assembly.model_fields}, by_name=True
    )

    def fits(other: Assembly) -> bool:
        return _evenest(engine.firing_order, dead_centres(other), engine.cycle_angle) is not None

    hints: list[str] = []
    if len({round(c.bearing, 9) for c in engine.cylinders}) > 1 and fits(
        with_banks_mirrored(plain)
    ):
        hints.append("banks")
        bearings = {cylinder.number: cylinder.bearing for cylinder in engine.cylinders}
        values["banks"] = {
            ", ".join(map(str, numbers)): f"{-degrees(bearings[numbers[0]]):+.4g}"
            for numbers in engine.banks.values()
        }
    reversed_ = with_rotation_reversed(plain, firing_order=engine.firing_order)
    if fits(reversed_):
        hints.append("rotation")
        values["rotation"] = reversed_.rotation
    if hints:
        return Fault(("firing_order",), f"firing_order.unfit-other-{'-or-'.join(hints)}", values)
    together = _simultaneous(centres, engine.cycle_angle)
    if together:
        values["together"] = together
        return Fault(("firing_order",), "firing_order.unfit-together", values)
    return Fault(("firing_order",), "firing_order.unfit", values)


def _simultaneous(centres: dict[int, DeadCentre], cycle: float) -> str:
    """Chambers that share a dead centre more often than the cycle has turns to part them."""
    by_angle: dict[int, list[int]] = {}
    for number, centre in centres.items():
        by_angle.setdefault(round(centre.angle_deg * 1000), []).append(number)
    crowded = [
        numbers
        for numbers in by_angle.values()
        if len(numbers) > cycle / centres[numbers[0]].period_deg + 1e-9
    ]
    return "; ".join(" and ".join(map(str, sorted(numbers))) for numbers in crowded)


def _evenest(
    order: tuple[int, ...], centres: dict[int, DeadCentre], cycle: float
) -> list[float] | None:
    """Firing angles with the least sum of squared intervals, ascending within a cycle; or None.

    Dynamic programming over which of its dead centres in the cycle each chamber fires at.
    """
    if not order:
        return []
    first = centres[order[0]].angle_deg
    reached, cost = np.array([first]), np.zeros(1)
    steps: list[tuple[np.ndarray, np.ndarray]] = []
    for number in order[1:]:
        centre = centres[number]
        start = centre.angle_deg + centre.period_deg * np.ceil(
            (first - centre.angle_deg) / centre.period_deg - 1e-12
        )
        choices = np.arange(start, first + cycle - SAME_ANGLE, centre.period_deg)
        interval = choices[:, None] - reached
        costs = np.where(interval > SAME_ANGLE, cost + interval**2, inf)
        possible = np.isfinite(costs).any(axis=1)
        if not possible.any():
            return None
        steps.append((reached, costs[possible].argmin(axis=1)))
        reached, cost = choices[possible], costs[possible].min(axis=1)
    at = int(np.argmin(cost + (first + cycle - reached) ** 2))
    angles = [float(reached[at])]
    for before, came_from in reversed(steps):
        at = int(came_from[at])
        angles.insert(0, float(before[at]))
    return angles


def _given_angles(engine: Assembly) -> list[float]:
    """The firing angles of the file, moved onto the dead centres they name."""
    centres = dead_centres(engine)
    angles: list[float] = []
    for number, given in zip(
        engine.firing_order, np.degrees(engine.firing_angles or ()), strict=True
    ):
        centre = centres[number]
        turns = round((float(given) - centre.angle_deg) / centre.period_deg)
        angles.append(centre.angle_deg + turns * centre.period_deg)
    return angles


def _wrong_angles(engine: Assembly, centres: dict[int, DeadCentre]) -> list[Fault]:
    faults: list[Fault] = []
    given = [float(angle) for angle in np.degrees(engine.firing_angles or ())]
    for index, (number, written, exact) in enumerate(
        zip(engine.firing_order, given, _given_angles(engine), strict=True)
    ):
        if abs(written - exact) > ANGLE_TOLERANCE:
            centre = centres[number]
            values = {
                "value": written,
                "number": number,
                "angle": centre.angle_deg,
                "period": centre.period_deg,
                "nearest": exact,
            }
            faults.append(Fault(("firing_angles", index), "firing_angles.off-dead-centre", values))
    exact = _given_angles(engine)
    falling = any(later < earlier - SAME_ANGLE for earlier, later in pairwise(exact))
    if not faults and (falling or exact[-1] - exact[0] >= engine.cycle_angle - SAME_ANGLE):
        values = {"cycle": engine.cycle_angle}
        faults.append(Fault(("firing_angles",), "firing_angles.not-ascending", values))
    return faults
