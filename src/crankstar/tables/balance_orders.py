"""The orders of a Balance for machines: one table, the same in JSON, CSV and data frames."""

from __future__ import annotations

from collections.abc import Sequence
from math import degrees
from typing import Any

from crankstar import spectra
from crankstar.analysis.document import ROW_UNIT, Column, Document, Table, Value
from crankstar.engine.engine import Engine
from crankstar.engine.motion import first_harmonic
from crankstar.language.messages import _
from crankstar.language.numbers import RPM, number, rpm_of
from crankstar.mechanics.balance import Balance, Units, total
from crankstar.mechanics.bounds import greatest
from crankstar.mechanics.excitation import Totals, rolling_moment
from crankstar.mechanics.remains import orders_pushed, orders_turning, summed
from crankstar.tables.paths import shape
from crankstar.tables.peaks import part_peaks

PARTS = (spectra.vertical, spectra.horizontal)
"""Of the couple: pitch, M_V, and yaw, M_H."""


def answer(engine: Engine, result: Balance, *, orders: Sequence[float] | None = None) -> Document:
    """The public answer of `analyze`: force, couple and moments of each order, nothing divided out.

    Without a speed, or for an engine without masses or sizes, `speed_rpm` is null and the units are
    those of m r w^2. `orders`, else those up to 6 at which a part pushes or
    the block rolls.
    """
    point = result.reference
    facts = {
        "engine": engine.name,
        "rotation": engine.rotation,
        "speed_rpm": rpm_of(result.speed),
        "reference": {"z": point.z, "up": point.up, "right": point.right},
        "units": result.units._asdict(),
        **_points(engine, result),
    }
    wanted = tuple(orders) if orders else orders_turning(result, summed(result))
    table = Table("", columns(result.units), rows(engine, total(result), wanted), key="orders")
    return Document(engine.name, (table, _peaks(result), *_with_gas(engine, result)), facts)


def _points(engine: Engine, result: Balance) -> dict[str, Any]:
    """The operating points of the gas; nothing where the file does not say what it does."""
    if engine.gas is None:
        return {}
    from crankstar.mechanics.operating_points import operating_state
    from crankstar.tables.gas_words import state_facts

    return state_facts(operating_state(engine, speed=result.speed))


def _with_gas(engine: Engine, result: Balance) -> tuple[Table, ...]:
    """Torque and roll with gas, where the file says what the gas does: `gas_orders`."""
    if engine.gas is None:
        return ()
    from crankstar.tables.torque_orders import gas_tables

    *_readers, machines = gas_tables(engine, speed=result.speed) or [None]
    return () if machines is None else (machines,)


def _peaks(result: Balance) -> Table:
    """The greatest value over a turn of all orders together, part by part, and where it is."""
    heads = (
        Column("quantity", kind="text", key="quantity"),
        Column("peak", ROW_UNIT, key="peak"),
        Column("theta_deg", "deg", key="theta_deg"),
        Column("unit", kind="unit", key="unit"),
    )
    rows = tuple(
        (name, size, degrees(angle), unit)
        for name, (size, angle, unit) in part_peaks(result, summed(result)).items()
    )
    return Table("", heads, rows, key="peaks")


def columns(units: Units) -> tuple[Column, ...]:
    """Order, the first cylinder's A_k, then each quantity."""
    out = [Column("order", key="order"), Column("Aₖ", kind="signal", key="harmonic")]
    for name in ("force", "couple"):
        unit = getattr(units, name)
        out += [
            Column(way, unit, kind="vector", key=f"{name}/{way}") for way in ("forward", "backward")
        ]
        out += [
            Column(way, unit, kind="wave", key=f"{name}/{way}")
            for way in ("vertical", "horizontal")
        ]
        out.append(Column("greatest", unit, key=f"{name}/greatest"))
    out += [Column(name, units.couple, kind="wave", key=name) for name in ("pitch", "yaw")]
    out += [
        Column(name, units.moment, kind="signal", key=name)
        for name in ("roll", "torque", "axis_moment")
    ]
    return tuple(out)


def rows(engine: Engine, sums: Totals, orders: Sequence[float]) -> tuple[tuple[Value, ...], ...]:
    """The cells of `columns` for each of these orders."""
    vectors = [spectra.selected(spectrum, orders) for spectrum in (sums.force, sums.couple)]
    signals = [
        spectra.amplitude(spectra.selected(signal, orders))
        for signal in (rolling_moment(sums), sums.torque, sums.axis_moment)
    ]
    out: list[tuple[Value, ...]] = []
    for row, order in enumerate(orders):
        cells: list[Value] = [float(order), first_harmonic(engine, order)]
        for vector in vectors:
            parts = (vector.forward, vector.backward)
            waves = (spectra.vertical(vector), spectra.horizontal(vector))
            cells += [complex(part[row]) for part in (*parts, *waves)]
            cells.append(greatest(*(complex(part[row]) for part in parts)))
        external = [complex(part(vectors[1])[row]) for part in PARTS]
        out.append((*cells, *external, *(complex(signal[row]) for signal in signals)))
    return tuple(out)


def notebook_table(result: Balance) -> Document:
    """The orders of a Balance as a notebook shows them: paths and greatest values."""
    wanted = orders_pushed(result)
    sums = total(result)
    vectors = [spectra.selected(spectrum, wanted) for spectrum in (sums.force, sums.couple)]
    roll = spectra.amplitude(spectra.selected(rolling_moment(sums), wanted))
    heads = [Column(_("order"), label=True)]
    for name, unit in ((_("force"), result.units.force), (_("couple"), result.units.couple)):
        heads += [Column(name, unit), Column(_("path"), kind="text")]
    heads.append(Column(_("rolling moment"), result.units.moment, kind="wave"))
    rows: list[tuple[Value, ...]] = []
    for row, order in enumerate(wanted):
        cells: list[Value] = [float(order)]
        for vector in vectors:
            path = spectra.ellipse(complex(vector.forward[row]), complex(vector.backward[row]))
            cells += [path.semi_major, shape(path)]
        rows.append((*cells, complex(roll[row])))
    speed = "" if result.speed is None else _("At {rpm} rpm", rpm=number(result.speed * RPM))
    return Document("", (Table(speed, tuple(heads), tuple(rows)),))
