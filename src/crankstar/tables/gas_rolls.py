"""The rolling moment on the block with gas, at the operating point and speed that are meant.

M(t) = axis moment - s (T_inertia + T_gas), s the sense of rotation: what turns the crankshaft one
way turns the block the other way, inertia and gas alike. A remedy changes the part of inertia and
leaves that of gas as it is, so that it is judged by the sum of both.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from crankstar import spectra
from crankstar.engine.engine import Engine
from crankstar.language.alike import as_given, of_any
from crankstar.language.messages import N_, _
from crankstar.language.numbers import RPM, number, order_text
from crankstar.language.shown_units import quantity_text
from crankstar.mechanics.lacking import lacking_keys
from crankstar.mechanics.operating_points import operating_state
from crankstar.mechanics.remains import OPTIMISED
from crankstar.spectra import Spectrum

CHANGES = {
    "grows": N_(
        "With gas at {rpm} rpm the rolling moment of order {order} grows from {before} to {now}: "
        "no remedy for it at this load."
    ),
    "falls": N_(
        "With gas at {rpm} rpm the rolling moment of order {order} falls from {before} to {now}."
    ),
    "stays": N_("With gas at {rpm} rpm the rolling moment of order {order} stays at {now}."),
}
"""What a remedy makes of an order of the rolling moment with gas."""


class GasRoll(NamedTuple):
    """The rolling moment on the block with gas, N m, and that of gas alone, at a speed in rad/s."""

    whole: Spectrum
    gas: Spectrum
    speed: float

    def at(self, order: float) -> complex:
        """The complex amplitude of an order, N m."""
        return _at(self.whole, order)

    def gas_at(self, order: float) -> complex:
        """The complex amplitude of an order of gas alone, N m."""
        return _at(self.gas, order)

    @property
    def largest(self) -> float:
        """The order that is largest."""
        sizes = np.abs(spectra.amplitude(self.whole))
        return float(self.whole.orders[int(np.argmax(sizes))])


def gas_roll_of(engine: Engine, *, speed: float | None) -> GasRoll | None:
    """The rolling moment with gas; None where the file has no gas, or masses or speed are unknown.

    >>> from crankstar.files.catalog import load
    >>> gas_roll_of(load("i4"), speed=100.0) is None
    True
    """
    return None if engine.gas is None else _gas_roll(engine, speed)


def gasless_reason(engine: Engine, *, speed: float | None) -> str:
    """Why the rolling moment with gas is not known, as a sentence; empty where it is.

    >>> from crankstar.files.catalog import load
    >>> gasless_reason(load("i4"), speed=None).partition(": ")[2]
    'the engine file lacks [gas], speed, cylinder.stroke, cylinder.reciprocating_mass, \
cylinder.bore.'
    """
    from crankstar.mechanics.gas import cycle_or_reason

    if gas_roll_of(engine, speed=speed) is not None:
        return ""
    found, why = cycle_or_reason(engine, speed=speed)
    turning = operating_state(engine, speed=speed).speed if found is None else found.speed
    keys = ["[gas]"] if engine.gas is None else []
    keys += lacking_keys(engine, turning)
    keys += ["cylinder.bore"] if any(each.bore is None for each in engine.cylinders) else []
    if not keys:
        return _(
            "The rolling moment that gas makes is not in these numbers: {reason}.",
            reason=why.rstrip("."),
        )
    return _(
        "The rolling moment that gas makes is not in these numbers: the engine file lacks {keys}.",
        keys=", ".join(keys),
    )


def _gas_roll(engine: Engine, speed: float | None) -> GasRoll | None:
    from crankstar.mechanics.balance import balance, total  # with gas alone
    from crankstar.mechanics.gas import cycle_or_reason
    from crankstar.mechanics.gas_torque import gas_roll, gas_torque, roll_with_gas

    found, _why = cycle_or_reason(engine, speed=speed)
    if found is None or found.speed is None:
        return None
    result = balance(engine, speed=found.speed)
    if result.speed is None:
        return None
    torque = gas_torque(found).total
    whole = roll_with_gas(total(result), torque)
    return GasRoll(whole, gas_roll(torque, engine.sense), found.speed)


def largest_sentence(engine: Engine, *, speed: float | None) -> str:
    """The largest order of the rolling moment with gas; empty where it is not known."""
    found = gas_roll_of(engine, speed=speed)
    if found is None:
        return ""
    order = as_given("largest roll with gas", found.largest)
    return _(
        "Rolling moment with gas at {rpm} rpm: largest at order {order}, {size}.",
        rpm=number(found.speed * RPM),
        order=order_text(order),
        size=quantity_text(found.at(order), "N*m"),
    )


def grown_orders(before: GasRoll, now: GasRoll) -> tuple[float, ...]:
    """The orders that a remedy makes larger with gas."""
    floor = OPTIMISED * float(np.abs(spectra.amplitude(now.whole)).max(initial=0.0))
    orders = [
        float(order)
        for order in now.whole.orders
        if abs(now.at(order)) > abs(before.at(order)) * (1 + OPTIMISED) + floor
    ]
    return of_any("grown rolls", orders)


def change_sentence(before: GasRoll, now: GasRoll, order: float) -> str:
    """An order of the rolling moment with gas before and after a remedy, and that it is none."""
    sizes = abs(before.at(order)), abs(now.at(order))
    course = "stays"
    if abs(sizes[1] - sizes[0]) > OPTIMISED * max(sizes):
        course = "grows" if sizes[1] > sizes[0] else "falls"
    return _(
        CHANGES[as_given(("roll changes", order), course)],
        rpm=number(before.speed * RPM),
        order=order_text(order),
        before=quantity_text(before.at(order), "N*m"),
        now=quantity_text(now.at(order), "N*m"),
    )


def _at(spectrum: Spectrum, order: float) -> complex:
    return complex(spectra.amplitude(spectra.selected(spectrum, [order]))[0])
