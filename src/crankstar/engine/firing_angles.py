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
from crankstar.engine.copies import with_banks_mirrored, with_rotation_reversed, with_values
from crankstar.engine.dead_centres import SAME_ANGLE, DeadCentre, dead_centres
from crankstar.language.faults import Fault

ANGLE_TOLERANCE = 1.0
"""Degrees by which a firing angle written in a file may miss the dead centre it names."""
FAR_UNEVEN = 2.0
"""Greatest interval over the even one from which a firing is doubted where it could be even."""


def firing_angles(engine: Assembly) -> list[float]:
    """The crank angle (degrees) of each firing, in the order of `firing_order`; or none.

    The order must fit, as that of every Engine does.
    """
    return _angles(engine)[1]


def other_angles(engine: Assembly) -> list[float] | None:
    """The most even angles (degrees) of firings that fit the order at other intervals.

    None where there are none, and where the file gives its own. Once a chamber has fired in the
    second turn all later ones do, so that the sets are no more than the chambers.

    >>> from crankstar.files.catalog import load
    >>> [other_angles(load(name)) for name in ("ducati-90", "i4")]
    [[0.0, 630.0], None]
    """
    if not engine.firing_order or engine.firing_angles:
        return None
    centres, own = dead_centres(engine), _steps(firing_angles(engine), engine)
    sets = [[centres[engine.firing_order[0]].angle_deg]]
    for number in engine.firing_order[1:]:
        places = _places(centres[number], sets[0][0], engine.cycle_angle)
        sets = [[*each, at] for each in sets for at in places if at - each[-1] > SAME_ANGLE]
    turns = [[*own[index:], *own[:index]] for index in range(len(own))]
    others = [
        each
        for each in sets
        if not any(np.allclose(_steps(each, engine), turned, atol=SAME_ANGLE) for turned in turns)
    ]
    return min(others, key=lambda each: sum(np.square(_steps(each, engine))), default=None)


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

    def fired(other: Assembly) -> list[float] | None:
        return _evenest(engine.firing_order, dead_centres(other), engine.cycle_angle)

    found: dict[str, list[float] | None] = {}
    if len({round(c.bearing, 9) for c in engine.cylinders}) > 1:
        found["banks"] = fired(with_banks_mirrored(plain))
        bearings = {cylinder.number: cylinder.bearing for cylinder in engine.cylinders}
        values["banks"] = {
            ", ".join(map(str, numbers)): f"{-degrees(bearings[numbers[0]]):+.4g}"
            for numbers in engine.banks.values()
        }
    reversed_ = with_rotation_reversed(plain, firing_order=engine.firing_order)
    found["rotation"] = fired(reversed_)
    values["rotation"] = reversed_.rotation
    pins = with_pins_reordered(plain)
    if pins is not None and "banks" in found:
        found["pins"] = fired(pins)
        values["throws"] = [round(degrees(angle) % 360, 6) for angle in _first_angles(pins)]
    fit = {name: angles for name, angles in found.items() if angles is not None}
    even = [name for name, angles in fit.items() if _spread(angles, engine) < SAME_ANGLE]
    turned = [name for name in even if name != "pins"]
    if turned:
        return Fault(("firing_order",), f"firing_order.unfit-other-{'-or-'.join(turned)}", values)
    if even:
        return Fault(("firing_order",), "firing_order.unfit-other-pins", values)
    for name in ("banks", "rotation"):
        if name in fit:
            values["intervals"] = _intervals_text(fit[name], engine)
            return Fault(("firing_order",), f"firing_order.unfit-uneven-{name}", values)
    together = _simultaneous(centres, engine.cycle_angle)
    if together:
        values["together"] = together
        return Fault(("firing_order",), "firing_order.unfit-together", values)
    return Fault(("firing_order",), "firing_order.unfit", values)


def with_pins_reordered(engine: Assembly) -> Assembly | None:
    """The banks on the other sides and the pins in the opposite order, each split as it was.

    None unless every cylinder has a throw of its own, those of a pin after each other.
    """
    count = len(engine.banks)
    shafts = engine.shafts
    if len(shafts) != 1 or len(shafts[0].throws) != len(engine.cylinders) or count < 2:
        return None
    throws = shafts[0].throws
    moved = [
        with_values(throw, angle=throw.angle - 2 * throws[index - index % count].angle)
        for index, throw in enumerate(throws)
    ]
    shaft = with_values(shafts[0], throws=tuple(moved))
    return with_banks_mirrored(with_values(engine, shafts=(shaft,)))


def split_doubts(engine: Assembly) -> list[Fault]:
    """A split of the pins with which the engine fires less evenly than without it."""
    count, shafts = len(engine.banks), engine.shafts
    own = firing_angles(engine)
    if len(shafts) != 1 or len(shafts[0].throws) != len(engine.cylinders) or count < 2 or not own:
        return []
    throws = shafts[0].throws
    whole = [
        with_values(throw, angle=throws[index - index % count].angle)
        for index, throw in enumerate(throws)
    ]
    plain = Assembly.model_validate(
        {name: getattr(engine, name) for name in Assembly.model_fields}, by_name=True
    )
    common = with_values(plain, shafts=(with_values(shafts[0], throws=tuple(whole)),))
    without = _evenest(engine.firing_order, dead_centres(common), engine.cycle_angle)
    if without is None or _spread(without, engine) > _spread(own, engine) - SAME_ANGLE:
        return []
    values = {
        "intervals": _intervals_text(own, engine),
        "without": _intervals_text(without, engine),
    }
    return [Fault(("layout", "pin_split"), "doubt.pin-split", values)]


def firing_doubts(engine: Assembly) -> list[Fault]:
    """What is hardly right in how an engine fires: a split that does harm, a crank mirrored."""
    return [*split_doubts(engine), *mirrored_doubts(engine)]


def mirrored_doubts(engine: Assembly) -> list[Fault]:
    """A far uneven firing of banks on a crankshaft that mirrored, or split mirrored, fires evenly.

    Pins at p_k from the first, and those of the second bank s further: tried are p_k with -s, -p_k
    with s, and -p_k with -s.
    """
    own = firing_angles(engine)
    if not own or engine.firing_angles or len(engine.shafts) != 1 or len(engine.banks) < 2:
        return []
    even = engine.cycle_angle / len(own)
    throws = engine.shafts[0].throws
    split = len(throws) == len(engine.cylinders)
    count = len(engine.banks) if split else 1
    if max(_steps(own, engine)) < FAR_UNEVEN * even or count > 2:
        return []
    plain = Assembly.model_validate(
        {name: getattr(engine, name) for name in Assembly.model_fields}, by_name=True
    )
    first, offset = throws[0].angle, throws[count - 1].angle - throws[0].angle
    for pins, halves in ((1, -1), (-1, 1), (-1, -1)) if split else ((-1, 1),):
        moved = [
            with_values(throw, angle=first + pins * (pin.angle - first) + halves * more)
            for index, throw in enumerate(throws)
            for pin in [throws[index - index % count]]
            for more in [throw.angle - pin.angle]
        ]
        other = with_values(plain, shafts=(with_values(engine.shafts[0], throws=tuple(moved)),))
        fired = _evenest(engine.firing_order, dead_centres(other), engine.cycle_angle)
        if fired is not None and _spread(fired, engine) < SAME_ANGLE:
            angles = [round(degrees(each.angle - first) % 360, 6) for each in moved[::count]]
            values = {
                "intervals": _intervals_text(own, engine),
                "even": f"{even:.4g}",
                "throws": ", ".join(f"{angle:g}" for angle in angles),
                **({"split": f"{degrees(halves * offset):.4g}"} if split else {}),
            }
            code = "doubt.firing-split" if split else "doubt.firing-throws"
            return [Fault(("firing_order",), code, values)]
    return []


def _steps(angles: list[float], engine: Assembly) -> list[float]:
    """The intervals between firings, degrees."""
    return [float(step) for step in np.diff([*angles, angles[0] + engine.cycle_angle])]


def _spread(angles: list[float], engine: Assembly) -> float:
    """The greatest interval less the least, degrees."""
    return float(np.ptp(_steps(angles, engine)))


def _intervals_text(angles: list[float], engine: Assembly) -> str:
    return "-".join(f"{step:.4g}" for step in _steps(angles, engine))


def _first_angles(engine: Assembly) -> list[float]:
    """The angles of the pins, of the cylinders of the first bank, from that of the first pin."""
    angles = [throw.angle for throw in engine.shafts[0].throws][:: len(engine.banks)]
    return [angle - angles[0] for angle in angles]


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
        choices = np.array(_places(centres[number], first, cycle))
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


def _places(centre: DeadCentre, first: float, cycle: float) -> list[float]:
    """The angles of a dead centre within the cycle that begins at `first`, degrees."""
    start = centre.angle_deg + centre.period_deg * np.ceil(
        (first - centre.angle_deg) / centre.period_deg - 1e-12
    )
    return np.arange(start, first + cycle - SAME_ANGLE, centre.period_deg).tolist()


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
