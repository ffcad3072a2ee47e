"""Gas torque of several engines side by side, each at the operating point that its speed gives."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from crankstar import spectra
from crankstar.analysis.document import Column, Table, Value
from crankstar.engine.engine import Engine
from crankstar.language.alike import of_any
from crankstar.language.messages import _
from crankstar.language.numbers import rpm_of
from crankstar.mechanics.gas import Cycle, cycle
from crankstar.mechanics.operating_points import GasError
from crankstar.studies.gas_results import torque_of
from crankstar.tables.gas_words import cycle_state, cycle_words, state_facts

NOTED = 0.01
"""Share of the greatest amplitude of any engine from which an order is shown."""


def gas_cycles(engines: Sequence[Engine], speeds: Sequence[float | None]) -> list[Cycle]:
    """The cycle of each engine at its speed; none where one of them has none."""
    if any(engine.gas is None for engine in engines):
        return []
    try:
        return [cycle(engine, speed=speed) for engine, speed in zip(engines, speeds, strict=True)]
    except GasError:
        return []


def gas_sizes(
    engines: Sequence[Engine],
    names: Sequence[str],
    cycles: Sequence[Cycle],
    asked: Sequence[float] = (),
) -> list[tuple[float, list[float]]]:
    """The amplitude of gas and inertia torque by order, engine by engine, N m; empty of none.

    Of the orders that are `asked` for, else of those that are more than next to nothing.
    """
    found = [torque_of(engine, own) for engine, own in zip(engines, cycles, strict=False)]
    occurring = {order for spectrum in found for order in spectrum.orders.tolist()}
    if not occurring:
        return []
    orders = sorted({*asked} or occurring)
    sizes = np.array(
        [np.abs(spectra.amplitude(spectra.selected(spectrum, orders))) for spectrum in found]
    )
    noted = sizes.max(axis=0) > NOTED * sizes.max(initial=0.0)
    if asked:
        noted[:] = True
    shown = of_any(("gas", *names), [o for o, kept in zip(orders, noted, strict=True) if kept])
    return [
        (order, sizes[:, index].tolist()) for index, order in enumerate(orders) if order in shown
    ]


def gas_state_facts(names: Sequence[str], cycles: Sequence[Cycle]) -> list[dict[str, Any]]:
    """The speed and operating points of the gas of each engine, for machines."""
    return [
        {"engine": name, "speed_rpm": rpm_of(own.speed), **state_facts(cycle_state(own))}
        for name, own in zip(names, cycles, strict=False)
    ]


def gas_comparison(
    engines: Sequence[Engine],
    names: Sequence[str],
    speeds: Sequence[float | None],
    *,
    orders: Sequence[float] = (),
) -> tuple[Table, ...]:
    """The torque of gas and inertia by order, engine by engine; none where one has no cycle.

    Of these orders if any are asked for.
    """
    cycles = gas_cycles(engines, speeds)
    found = gas_sizes(engines, names, cycles, orders)
    if not found:
        return ()
    shares = [
        Column(
            _("{engine}, of the first", engine=name) if len(names) > 2 else _("share"),
            "%",
            digits=4,
            optional=1,
            key=_("{engine}, of the first", engine=name),
        )
        for name in names[1:]
    ]
    heads = (
        Column(_("order"), kind="text", key="order", label=True),
        *(Column(name, "N*m", key=name) for name in names),
        *shares,
    )
    rows: list[tuple[Value, ...]] = [
        (order, *own, *(100 * each / own[0] if own[0] else None for each in own[1:]))
        for order, own in found
    ]
    notes = [
        _("{engine}: {state}", engine=name, state=cycle_words(engine, own))
        for engine, name, own in zip(engines, names, cycles, strict=True)
    ]
    title = _("Torque of gas and inertia")
    return (Table(title, heads, tuple(rows), notes=tuple(notes), key="torque_with_gas"),)
