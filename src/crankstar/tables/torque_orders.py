"""Gas torque by order as tables: gas, inertia, together, and the roll of the block."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from crankstar import spectra
from crankstar.analysis.document import Column, Table, Value
from crankstar.dynamics.load_reaction import on_one_frame
from crankstar.engine.engine import Engine
from crankstar.language.alike import of_any
from crankstar.language.messages import _
from crankstar.language.shown_units import quantity_text
from crankstar.mechanics.balance import balance, total
from crankstar.mechanics.gas import Cycle, cycle
from crankstar.mechanics.gas_torque import GasTorque, added, gas_roll, gas_torque, roll_with_gas
from crankstar.mechanics.operating_points import GasError
from crankstar.spectra import Complex, Spectrum
from crankstar.tables.gas_words import at_points

NOTED = 0.01
"""Share of the greatest amplitude from which an order is shown to readers."""


class Orders(NamedTuple):
    """Amplitudes by order, N m, `Re(c exp(i k theta))`; inertia is None without known masses.

    `roll` is the alternating rolling moment on the block, wherever the load is; `framed` that on a
    frame of engine and driven machine, which differs where the load has a course.
    """

    orders: list[float]
    gas: Complex
    inertia: Complex | None
    total: Complex
    roll: Complex
    framed: Complex

    @property
    def reacting(self) -> bool:
        """Whether the course of the load has a part in it."""
        return self.framed is not self.roll


def by_order(engine: Engine, cycle: Cycle, found: GasTorque) -> Orders:
    """Gas torque, inertia torque, their sum and the rolling moment on the block, all orders."""
    gas = found.total
    result = balance(engine, speed=cycle.speed)
    if cycle.speed is None or result.speed is None:
        wave = spectra.amplitude(gas)
        alone = gas_roll(gas, engine.sense)
        framed = on_one_frame(alone, engine, cycle)
        roll = spectra.amplitude(alone)
        both = roll if framed is alone else spectra.amplitude(framed)
        return Orders(gas.orders.tolist(), wave, None, wave, roll, both)
    sums = total(result)
    whole = added(sums.torque, gas)
    roll = added(roll_with_gas(sums, gas), spectra.scaled(whole, 0.0))
    framed = on_one_frame(roll, engine, cycle)

    def at(spectrum: Spectrum) -> Complex:
        return spectra.amplitude(spectra.selected(spectrum, framed.orders))

    waves = at(gas), at(sums.torque), at(whole), at(roll)
    return Orders(framed.orders.tolist(), *waves, waves[-1] if framed is roll else at(framed))


class OrderTables(NamedTuple):
    """Torques by order and the rolling moment for readers, and both for machines."""

    readers: Table
    rolls: Table
    machines: Table


def orders_of_note(waves: Orders) -> tuple[float, ...]:
    """Those of note, and what is zero before the first."""
    size = np.maximum(np.abs(waves.total), np.abs(waves.gas))
    if waves.reacting:
        size = np.maximum(size, np.abs(waves.framed))
    noted = size > NOTED * size.max(initial=0.0)
    first = next((order for order, kept in zip(waves.orders, noted, strict=True) if kept), 0.0)
    return tuple(
        order for order, kept in zip(waves.orders, noted, strict=True) if kept or order < first
    )


def order_tables(engine: Engine, waves: Orders, asked: Sequence[float] = ()) -> OrderTables:
    """The torques of the orders that are `asked`, else for readers of those of note.

    All engines that are told of together have the same orders.
    """
    told = asked or sorted(of_any(("torque", engine.name), orders_of_note(waves)))
    every = asked or sorted(of_any(("every torque", engine.name), waves.orders))
    machines = replace(_order_table(waves, every, whole=True), audience="machines")
    readers = replace(_order_table(waves, told), audience="readers")
    return OrderTables(readers, roll_table(waves, told), machines)


def _order_table(waves: Orders, shown: Sequence[float], *, whole: bool = False) -> Table:
    """Gas, inertia and their sum, order by order; as a `whole` the roll of the block too."""
    kind = "signal" if whole else "wave"
    columns = [Column(_("order"), key="order", label=True)]
    series: list[tuple[str, str, Complex]] = [("gas", _("gas torque"), waves.gas)]
    if waves.inertia is not None:
        series.append(("inertia", _("inertia torque"), waves.inertia))
    if whole or waves.inertia is not None:  # else it is that of the gas
        series.append(("total", _("together"), waves.total))
    if whole:
        series += [("roll", "", waves.roll), ("roll_on_same_mounts", "", waves.framed)]
    columns += [Column(title, "N*m", kind=kind, key=key) for key, title, _wave in series]
    rows = _rows(waves, shown, [wave for _key, _title, wave in series])
    return Table(_("Torque by order"), tuple(columns), rows, key="orders")


def _rows(
    waves: Orders, shown: Sequence[float], series: Sequence[Complex]
) -> tuple[tuple[Value, ...], ...]:
    """An order and its amplitudes in each row, nought where an order is not there."""
    place = {order: index for index, order in enumerate(waves.orders)}
    return tuple(
        (float(order), *(complex(wave[place[order]]) if order in place else 0j for wave in series))
        for order in shown
    )


def roll_table(waves: Orders, shown: Sequence[float]) -> Table:
    """The rolling moment on the block, order by order."""
    columns = [Column(_("order"), label=True), Column(_("rolling moment"), "N*m", kind="wave")]
    series = [waves.roll]
    if waves.reacting:
        columns.append(Column(_("driven machine on the same frame"), "N*m", kind="wave"))
        series.append(waves.framed)
    return Table(_("Rolling moment on the block"), tuple(columns), _rows(waves, shown, series))


def gas_waves(engine: Engine, *, speed: float | None) -> Orders | None:
    """Torque and roll with gas by order of an engine whose file says what the gas does."""
    found = _gas(engine, speed)
    return None if found is None else found[1]


def _gas(engine: Engine, speed: float | None) -> tuple[Cycle, Orders] | None:
    """The cycle of an engine and its torques by order; None where there is none."""
    if engine.gas is None:
        return None
    try:
        found = cycle(engine, speed=speed)
    except GasError:
        return None
    return found, by_order(engine, found, gas_torque(found))


def gas_tables(
    engine: Engine, *, speed: float | None, orders: Sequence[float] = ()
) -> tuple[Table, ...]:
    """Torque and roll with gas of an engine whose file says what the gas does; else none."""
    own_gas = _gas(engine, speed)
    if own_gas is None:
        return ()
    found, waves = own_gas
    readers, rolls, machines = order_tables(engine, waves, orders)
    title = _("Torque by order, gas at {pressure}", pressure=quantity_text(found.imep, "Pa"))
    title = at_points(title, found)
    rolls = replace(rolls, title=_("Rolling moment on the block, gas included"))
    return replace(readers, title=title), rolls, replace(machines, key="gas_orders")
