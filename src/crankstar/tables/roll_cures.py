"""The rolling moment that weights and shafts leave, and what would remove it."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import NamedTuple

import numpy as np

from crankstar import spectra
from crankstar.engine.engine import Engine
from crankstar.engine.records import Shaft
from crankstar.language.alike import as_given, of_any
from crankstar.language.messages import N_, _, passage
from crankstar.language.numbers import RPM, number, order_text
from crankstar.language.shown_units import quantity_text
from crankstar.mechanics.balance import Balance, balance
from crankstar.mechanics.remains import OPTIMISED, Sums, remains, summed
from crankstar.remedy import Box, Placing, placed
from crankstar.remedy.clearance import balance_shafts, is_clear_of_cranks
from crankstar.remedy.fitting import recommended
from crankstar.remedy.placing import MOST_SHAFTS
from crankstar.remedy.rolling import push
from crankstar.tables.gas_rolls import change_sentence, gas_roll_of, grown_orders
from crankstar.tables.scales import scales

LEFT = {
    "moved": N_(
        "Rolling moment without gas of order {order}: {size} is left; none would be with {shafts} "
        "at {place}."
    ),
    "middle": N_(
        "Rolling moment without gas of order {order}: {size} is left; none would be with the "
        "middle of {shafts} at {place}."
    ),
    "halved": N_(
        "Rolling moment without gas of order {order}: {size} is left; none would be with two "
        "shafts in place of {shafts}, each with half of its unbalance, on opposite sides of "
        "{place} and equally far from it."
    ),
    "pair": N_(
        "Rolling moment without gas of order {order}: {size} is left; none would be with the two "
        "shafts at {order} and -{order} times crank speed in other places, as `crankstar balance "
        "--level` finds them."
    ),
    "other": N_(
        "Rolling moment without gas of order {order}: {size} is left, which weights on the "
        "crankshaft do not change; two balance shafts at {order} times crank speed, apart from "
        "each other and with opposite unbalances, would remove it."
    ),
}
"""What is left, and what removes it: other places of the shafts, or shafts of its own."""
WITH_GAS = {
    "no remedy": N_(
        "Rolling moment with gas of order {order} at {rpm} rpm: {size}, without gas {inertia}. "
        "Shafts that remove the moment without gas would leave {left}: no remedy at this load."
    ),
    "remedy": N_(
        "Rolling moment with gas of order {order} at {rpm} rpm: {size}. {left} would remain if "
        "that without gas, {inertia}, were removed."
    ),
}
"""The part of gas, which shafts for the moment of inertia leave as it is."""
FITTED = {
    "no remedy": N_(
        "Shafts that remove its part without gas, {inertia}, would leave {left}: no remedy at this "
        "load."
    ),
    "remedy": N_("{left} would remain if its part without gas, {inertia}, were removed."),
}
"""The same of an engine with its remedies, once what these change has been stated."""
CHANGES = {
    "grows": N_(
        "Without gas the rolling moment of order {order} grows from {before} to {now} with them."
    ),
    "falls": N_(
        "Without gas the rolling moment of order {order} falls from {before} to {now} with them."
    ),
}
WORTH = 0.1
"""Share of a rolling moment with gas from which what removes it is a remedy: our judgement.

The load of an engine changes its gas torque by more than that from one minute to the next.
"""


class Roll(NamedTuple):
    """An order of the rolling moment and its complex amplitude."""

    order: float
    wave: complex


def largest_roll(sums: Sums) -> Roll | None:
    """The largest order of the rolling moment from inertia, if there is one."""
    waves = spectra.amplitude(sums.roll)
    there = remains(sums.torque) or remains(sums.axis_moment)
    if not waves.size or not of_any("rolls", [True] * there):
        return None
    place = as_given("roll", int(np.argmax(np.abs(waves))))
    return Roll(float(sums.roll.orders[place]), complex(waves[place]))


def roll_left(engine: Engine, *, speed: float | None, before: Engine | None = None) -> str:
    """The largest order of the rolling moment on an engine with its remedies, and what removes it.

    With gas where the file has it: what removes the moment of inertia is a remedy only if less
    remains of both together. Empty where there is none. `before` is the engine without its
    remedies, whose rolling moment is stated beside that with them.

    >>> from crankstar.files.catalog import load
    >>> roll_left(load("i4"), speed=None).partition(", which")[0]
    'Rolling moment without gas of order 2: 2.0005 m r² ω² is left'
    """
    result = balance(engine, speed=speed)
    largest = largest_roll(summed(result))
    now = gas_roll_of(engine, speed=speed)
    if now is None:
        changed = "" if before is None else _inertia_changed(before, result, largest)
        return passage(filter(None, (changed, _inertia_left(engine, result, largest))))
    order = as_given("largest roll left", now.largest)
    left, whole = now.gas_at(order), now.at(order)
    less = as_given("less with gas", abs(left) < (1 - WORTH) * abs(whole))
    case = "remedy" if less else "no remedy"
    was = None if before is None else gas_roll_of(before, speed=speed)
    sentences: list[str] = []
    if was is not None:
        others = [each for each in grown_orders(was, now) if each != order]
        sentences = [change_sentence(was, now, each) for each in (*others, order)]
    sentence = _(
        (WITH_GAS if was is None else FITTED)[case],
        order=order_text(order),
        rpm=number(now.speed * RPM),
        size=quantity_text(whole, "N*m"),
        inertia=quantity_text(whole - left, "N*m"),
        left=quantity_text(left, "N*m"),
    )
    rest = _inertia_left(engine, result, largest) if less else ""
    return passage((*sentences, sentence, rest))


def grown_with_gas(engine: Engine, *, speed: float | None) -> list[str]:
    """The orders of the rolling moment with gas that the recommended weights and shafts enlarge.

    Before and after; none where gas is not known. They are those of `crankstar balance
    --recommended`.
    """
    was = gas_roll_of(engine, speed=speed)
    fitted = None if was is None else recommended(engine)
    now = None if fitted is None else gas_roll_of(fitted.after, speed=speed)
    if was is None or fitted is None or now is None:
        return []
    lines = [change_sentence(was, now, order) for order in grown_orders(was, now)]
    return [passage((fitted.description, *lines))] if lines else []


def _inertia_changed(before: Engine, result: Balance, largest: Roll | None) -> str:
    """The largest order of the rolling moment of inertia before and after the remedies."""
    if largest is None:
        return ""
    sums = summed(balance(before, speed=result.speed))
    wave = complex(spectra.amplitude(spectra.selected(sums.roll, [largest.order]))[0])
    was, now = abs(wave), abs(largest.wave)
    course = "grows" if now > was else "falls"
    if as_given("roll stays", abs(now - was) <= OPTIMISED * max(was, now)):
        return ""
    return _(
        CHANGES[as_given("inertia roll changes", course)],
        order=order_text(largest.order),
        before=quantity_text(wave, result.units.moment),
        now=quantity_text(largest.wave, result.units.moment),
    )


def _inertia_left(engine: Engine, result: Balance, largest: Roll | None) -> str:
    """The largest order of the rolling moment of inertia, and what removes it."""
    if largest is None:
        return ""
    order = Fraction(largest.order).limit_denominator(1000)
    pushing = [s for s in balance_shafts(engine) if abs(s.speed_ratio) == order and push(s)]
    placing = _placing(engine, pushing)
    free = None if placing is None else placing.without_roll
    case = as_given("roll cure", _case(engine, pushing, order, free))
    across, values = scales(engine).across, {"shafts": "", "place": ""}
    if free is not None:
        values["shafts"] = ", ".join(shaft.name for shaft in pushing)
        up, right = across.text(free.real), across.text(free.imag)
        values["place"] = _("{up} up, {right} right", up=up, right=right)
    size = quantity_text(largest.wave, result.units.moment)
    return _(LEFT[case], order=order_text(largest.order), size=size, **values)


def _placing(engine: Engine, shafts: Sequence[Shaft]) -> Placing | None:
    """Shafts of one order where they are, and where they would leave no roll."""
    if not 0 < len(shafts) <= MOST_SHAFTS:
        return None
    boxes = [Box((shaft.up, shaft.up), (shaft.right, shaft.right)) for shaft in shafts]
    return placed(engine, shafts=[shaft.name for shaft in shafts], boxes=boxes)[1][0]


def _case(engine: Engine, shafts: Sequence[Shaft], order: Fraction, free: complex | None) -> str:
    """Which of the remedies there is."""
    if free is not None and len(shafts) > 1:
        return "middle"
    if free is not None:
        return "moved" if is_clear_of_cranks(engine, free) else "halved"
    ratios = sorted(shaft.speed_ratio for shaft in shafts)
    return "pair" if ratios == [-order, order] else "other"
