"""Gas torque of several engines side by side, each at the load of its file."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from crankstar import spectra
from crankstar.engine.engine import Engine
from crankstar.language.kept import of_any
from crankstar.language.messages import _
from crankstar.mechanics.balance import balance, total
from crankstar.mechanics.gas import cycle
from crankstar.mechanics.gas_torque import added, gas_torque
from crankstar.mechanics.operating_points import GasError
from crankstar.spectra import Spectrum
from crankstar.tables.table import Column, Table, Value

NOTED = 0.01
"""Share of the greatest amplitude of any engine from which an order is shown."""


def gas_sizes(
    engines: Sequence[Engine], names: Sequence[str], speeds: Sequence[float | None]
) -> list[tuple[float, list[float]]]:
    """The amplitude of gas and inertia torque by order, engine by engine, N m.

    Empty where one of the engines has no cycle.
    """
    if any(engine.gas is None for engine in engines):
        return []
    try:
        found = [_torque(engine, speed) for engine, speed in zip(engines, speeds, strict=True)]
    except GasError:
        return []
    orders = sorted({order for spectrum in found for order in spectrum.orders.tolist()})
    sizes = np.array(
        [np.abs(spectra.amplitude(spectra.selected(spectrum, orders))) for spectrum in found]
    )
    noted = sizes.max(axis=0) > NOTED * sizes.max(initial=0.0)
    shown = of_any(("gas", *names), [o for o, kept in zip(orders, noted, strict=True) if kept])
    return [
        (order, sizes[:, place].tolist()) for place, order in enumerate(orders) if order in shown
    ]


def gas_comparison(
    engines: Sequence[Engine], names: Sequence[str], speeds: Sequence[float | None]
) -> tuple[Table, ...]:
    """The torque of gas and inertia by order, engine by engine; none where one has no cycle."""
    found = gas_sizes(engines, names, speeds)
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
    return (Table(_("Torque of gas and inertia"), heads, tuple(rows), key="torque_with_gas"),)


def _torque(engine: Engine, speed: float | None) -> Spectrum:
    """The torque of gas, and of inertia where it is known."""
    result = balance(engine, speed=speed)
    gas = gas_torque(cycle(engine, speed=result.speed)).total
    return gas if result.speed is None else added(total(result).torque, gas)
