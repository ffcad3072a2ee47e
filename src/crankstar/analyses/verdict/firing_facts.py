"""Layout, firing and exhaust pulses of an engine as sentences of its verdict."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from crankstar.engine.engine import Engine
from crankstar.engine.main_bearings import main_bearings, pin_groups
from crankstar.engine.records import Shaft
from crankstar.firing.exhaust_orders import exhaust_orders
from crankstar.firing.intervals import firing
from crankstar.firing.strokes import exhaust_groups, exhaust_intervals, working_cycle
from crankstar.firing.succession import Follower, in_succession, neighbours, partners
from crankstar.language.faults import EngineError
from crankstar.language.messages import _, _n, passage
from crankstar.language.numbers import number, order_text
from crankstar.language.written import capitalised
from crankstar.tables.headings import firing_text

COMPARED = 4
"""Firings that are named one by one."""
FEW = 4
"""Cylinders: of fewer, the order in which they fire says nothing of neighbours."""
UNEVEN = 0.75
"""Exhausts that follow in less than this share of the even interval are uneven.

The shift by slave rods is smaller.
"""
AUDIBLE = 0.1
"""Share of all pulses of a group from which an order of its exhaust is named."""
BURBLE = (90.0, 180.0, 180.0, 270.0)
"""Degrees between the exhausts of a bank of a cross-plane V8, from the shortest."""


class Pulses(NamedTuple):
    """The exhausts of a bank or manifold in the order in which they open, with their intervals."""

    name: str
    steps: tuple[Follower, ...]

    @property
    def closest(self) -> Follower:
        """The two that follow each other soonest."""
        return min(self.steps, key=lambda step: round(step.interval_deg, 3))

    @property
    def even(self) -> float:
        """The interval if all were equal, degrees."""
        return sum(step.interval_deg for step in self.steps) / len(self.steps)


def layout_sentence(engine: Engine) -> str:
    """Firing, throws and main bearings."""
    cranks = [(shaft.name, _throws(engine, shaft)) for shaft in engine.shafts if shaft.throws]
    parts = [_("Fires {firing}.", firing=firing_text(engine))] if engine.firing_order else []
    if len({throws for _name, throws in cranks}) > 1:
        parts += [
            _("Crankshaft {name}: {throws}.", name=name, throws=text) for name, text in cranks
        ]
    elif len(cranks) > 1:
        parts.append(
            _("{count} crankshafts, each with {throws}.", count=len(cranks), throws=cranks[0][1])
        )
    else:
        throws = cranks[0][1]
        parts.append(_("{text}.", text=capitalised(throws)))
    return passage(parts)


def _throws(engine: Engine, shaft: Shaft) -> str:
    throws = pin_groups(engine, shaft)
    pins = sorted({len(group.throws) for group in throws})
    values = {
        "throws": _n("{count} throw", "{count} throws", len(throws), count=len(throws)),
        "pins": _(" or ").join(map(str, pins)),
        "bearings": len(main_bearings(engine, shaft)),
    }
    if pins[-1] > 1:
        return _("{throws} of {pins} split pins each, {bearings} main bearings", **values)
    return _("{throws}, {bearings} main bearings", **values)


def succession_lines(engine: Engine) -> list[str]:
    """Exhaust pulses, and neighbours and partners on a pin that fire in succession."""
    if len(engine.chambers) < FEW or not engine.firing_order:
        return []
    try:
        cycle = working_cycle(engine)
    except EngineError:  # crankshafts of different speed have no common strokes
        return []
    groups = [
        Pulses(group.name, exhaust_intervals(cycle, group.chambers))
        for group in exhaust_groups(engine)
        if len(group.chambers) > 1
    ]
    several = len({(cylinder.shaft, cylinder.throw) for cylinder in engine.cylinders}) > 1
    sides, pins = neighbours(engine), partners(engine)
    steps = [in_succession(cycle.firing, pairs) for pairs in (sides, pins)]
    lines = [_pulses(engine, groups)]
    if several:
        lines.append(_succession(bool(sides), bool(pins), steps[0], steps[1]))
    return [line for line in lines if line]


def _succession(
    any_sides: bool, any_pins: bool, sides: Sequence[Follower], pins: Sequence[Follower]
) -> str:
    values = {"sides": _steps_text(sides), "pins": _steps_text(pins)}
    if sides and pins:
        return _("Neighbours {sides} and partners on a pin {pins} fire in succession.", **values)
    if sides:
        return _("Neighbours {sides} fire in succession.", **values)
    if pins:
        return _("Partners on a pin {pins} fire in succession.", **values)
    if any_sides and any_pins:
        return _("No neighbours or partners on a pin fire in succession.")
    if any_sides:
        return _("No neighbours fire in succession.")
    return _("No partners on a pin fire in succession.") if any_pins else ""


def _steps_text(steps: Sequence[Follower]) -> str:
    shown = ", ".join(f"{step.first}-{step.then}" for step in steps[:COMPARED])
    more = len(steps) - COMPARED
    return _("{pairs} and {count} more", pairs=shown, count=more) if more > 0 else shown


def _pulses(engine: Engine, groups: Sequence[Pulses]) -> str:
    """How evenly the exhausts of each of several banks follow each other."""
    if len(groups) < 2:
        return ""  # all cylinders exhaust as they fire
    intervals = {round(step.interval_deg, 3) for group in groups for step in group.steps}
    bank = engine.valves is None or not engine.valves.manifolds
    if len(intervals) == 1:
        interval = number(intervals.pop())
        if bank:
            return _("Each bank exhausts evenly, every {interval} deg.", interval=interval)
        return _("Each manifold exhausts evenly, every {interval} deg.", interval=interval)
    uneven = [group for group in groups if group.closest.interval_deg < UNEVEN * group.even]
    if not uneven:
        return ""
    parts = "; ".join(_pulse(group) for group in uneven[:2])
    values = {"pulses": parts, "count": len(uneven) - 2}
    if _burbles(engine, groups):
        told = _("Uneven exhaust pulses, the burble of a cross-plane V8: {pulses}.", **values)
    elif len(uneven) > 2:
        told = _("Uneven exhaust pulses: {pulses}; and in {count} more.", **values)
    else:
        told = _("Uneven exhaust pulses: {pulses}.", **values)
    return passage(filter(None, [told, _orders(engine)]))


def _orders(engine: Engine) -> str:
    """The orders that every bank has below the one at which all its pulses fall together.

    Even exhausts have none. Where the banks differ, or there are many, nothing is said.
    """
    found = exhaust_orders(engine)
    sizes = np.array([len(group.chambers) for group in found.groups])
    shares = np.abs(found.sums) / sizes[:, None]
    full = np.flatnonzero((shares > 1 - 1e-6).all(axis=0))
    present = shares[:, : full[0] if full.size else 0] > AUDIBLE
    extra = np.flatnonzero(present[0])
    if not full.size or (present != present[0]).any() or not 0 < extra.size <= COMPARED:
        return ""
    values = {
        "orders": ", ".join(order_text(order) for order in found.orders[extra].tolist()),
        "own": order_text(float(found.orders[full[0]])),
    }
    if engine.valves is None or not engine.valves.manifolds:
        return _("Exhaust of each bank: orders {orders} beside {own}.", **values)
    return _("Exhaust of each manifold: orders {orders} beside {own}.", **values)


def _pulse(group: Pulses) -> str:
    values = {
        "group": group.name,
        "first": group.closest.first,
        "then": group.closest.then,
        "interval": number(group.closest.interval_deg),
        "intervals": "-".join(number(step.interval_deg, digits=4) for step in group.steps),
    }
    if len(group.steps) <= COMPARED:
        return _(
            "{group}, cylinders {first} and {then}, {interval} deg apart ({intervals})", **values
        )
    return _("{group}, cylinders {first} and {then}, {interval} deg apart", **values)


def _burbles(engine: Engine, groups: Sequence[Pulses]) -> bool:
    """Whether it is an even-firing V8 with bank exhausts 90, 180 and 270 deg apart."""
    counts = (len(engine.chambers), len(engine.banks), *(len(group.steps) for group in groups))
    if engine.cycle != "four-stroke" or counts != (8, 2, 4, 4):
        return False
    alike = all(
        np.allclose(sorted(step.interval_deg for step in group.steps), BURBLE, atol=1.0)
        for group in groups
    )
    return alike and firing(engine).even
