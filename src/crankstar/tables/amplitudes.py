"""Amplitudes of a Balance as one tidy table for CSV and Parquet: one row an amplitude.

The same rows as `Balance.to_frame`, with engine and speed in each, so that files of several engines
can be put one below the other.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from crankstar import spectra
from crankstar.analysis.document import ROW_UNIT, Column, Document, Kind, Table
from crankstar.engine.engine import Engine
from crankstar.language.numbers import rpm_of
from crankstar.mechanics.balance import Balance, Grouping, grouped, total
from crankstar.mechanics.bounds import are_kept, lengths
from crankstar.mechanics.excitation import Totals
from crankstar.mechanics.labelled import AXIAL, columns
from crankstar.mechanics.remains import orders_turning, summed

WHOLE = "engine"
"""Name of the part that is all of them; `no bank` are parts that belong to none."""
TEXTS = ("engine", "part", "quantity", "direction")


def amplitudes(
    engine: Engine,
    result: Balance,
    *,
    orders: Sequence[float] | None = None,
    by: Grouping | None = None,
) -> Document:
    """The amplitudes of the whole engine, and its shares `by` a label, as a tidy table.

    `orders`, else those up to 6 at which a part pushes or the block rolls.
    """
    wanted = tuple(orders) if orders else orders_turning(result, summed(result))
    shares: dict[object, Totals] = {WHOLE: total(result)}
    if by is not None:
        shares |= {
            f"no {by}" if label is None else f"{by} {label}": sums
            for label, sums in grouped(result, by).items()
        }
    picked = [
        Totals(*(spectra.selected(spectrum, wanted) for spectrum in sums))
        for sums in shares.values()
    ]
    rows = columns(
        Totals(*map(spectra.stacked, zip(*picked, strict=True))),
        result.units._asdict(),
        {"part": [*shares]},
    )
    rows = _with_gas(rows, engine, result, orders or ())
    rpm = rpm_of(result.speed)
    return document(engine.name, {"speed_rpm": [rpm] * len(rows["order"]), **rows})


def _with_gas(
    rows: dict[str, Any], engine: Engine, result: Balance, orders: Sequence[float]
) -> dict[str, Any]:
    """The rows with torque and roll of gas and inertia, where the file says what the gas does.

    They are `gas_torque`, `inertia_torque`, `torque_with_gas` and `roll_with_gas`, of all orders
    unless some are named.
    """
    if engine.gas is None:
        return rows
    from crankstar.tables.torque_orders import gas_waves

    waves = gas_waves(engine, speed=result.speed)
    if waves is None:
        return rows
    wanted = [at for at, order in enumerate(waves.orders) if not orders or order in orders]
    named = {"gas_torque": waves.gas, "torque_with_gas": waves.total, "roll_with_gas": waves.roll}
    if waves.inertia is not None:
        named["inertia_torque"] = waves.inertia
    count = len(named) * len(wanted)
    amplitude = np.concatenate([wave[wanted] for wave in named.values()])
    more: dict[str, Any] = {
        "part": [WHOLE] * count,
        "order": [waves.orders[at] for at in wanted] * len(named),
        "quantity": [name for name in named for _at in wanted],
        "direction": [AXIAL] * count,
        "amplitude": np.abs(amplitude),
        "phase_deg": np.where(amplitude == 0, 0.0, np.degrees(np.angle(amplitude)) + 0.0),
        "unit": ["N*m"] * count,
    }
    return joined(rows, more)


def joined(rows: Mapping[str, Any], more: Mapping[str, Any]) -> dict[str, Any]:
    """The columns of two tables of the same names under one another."""
    return {
        name: [item for part in (values, more[name]) for item in np.asarray(part, object).tolist()]
        for name, values in rows.items()
    }


def document(name: str, rows: Mapping[str, Any]) -> Document:
    """Columns as a tidy table of an engine, its name before them."""
    count = len(rows["order"])
    lists = [np.asarray(values, object).tolist() for values in ([name] * count, *rows.values())]
    if are_kept():
        phases = np.radians([phase or 0.0 for phase in rows["phase_deg"]])  # of a peak none
        waves = np.array(rows["amplitude"], float) * np.exp(1j * phases)
        lists[1 + [*rows].index("amplitude")] = lengths(waves)
    heads = tuple(map(_column, ("engine", *rows)))
    table = Table("", heads, tuple(zip(*lists, strict=True)), key="amplitudes")
    return Document(name, (table,), {"engine": name})


def _column(name: str) -> Column:
    kinds: dict[str, Kind] = {"unit": "unit", "phase_deg": "phase", **dict.fromkeys(TEXTS, "text")}
    kind = kinds.get(name, "number")
    unit = ROW_UNIT if name == "amplitude" else ""
    return Column(name, unit, kind=kind, key=name, label=name in (*TEXTS, "order"))
