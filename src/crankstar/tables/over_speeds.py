"""Amplitudes over the speed: each force and moment of every order at a range of speeds.

Inertia forces grow with omega^2. Numbers are those of a sweep of the speed: in newtons, or, of an
engine without masses or sizes, in m r omega_0^2, omega_0 the highest speed.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from crankstar import spectra
from crankstar.analysis.document import ROW_UNIT, Column, Document, Table, Value, remarks
from crankstar.engine.engine import Engine
from crankstar.language.alike import of_any
from crankstar.language.messages import N_, _, passage
from crankstar.language.numbers import RPM, order_text
from crankstar.mechanics.balance import Balance, balance
from crankstar.mechanics.bounds import lengths, peaks
from crankstar.mechanics.excitation import Totals, rolling_moment
from crankstar.mechanics.labelled import columns
from crankstar.mechanics.remains import (
    NEGLIGIBLE,
    Sums,
    orders_pushed,
    orders_turning,
    sizes,
    summed,
)
from crankstar.spectra import Complex, Real
from crankstar.studies.study import rad_per_s
from crankstar.studies.sweep import Sweep, watched
from crankstar.tables import amplitudes, balance_orders
from crankstar.tables.conditions import (
    assumed_sentence,
    conditions,
    missing_sentence,
    unverified_sentence,
)
from crankstar.tables.sweep_notes import speed_note
from crankstar.tables.sweeps import facts


class Component(NamedTuple):
    """A component of force or couple, or the rolling moment: its names, and what is watched."""

    key: str
    title: str
    none: str
    what: str


COMPONENTS = (
    Component("vertical", N_("Vertical force"), N_("No vertical force."), "force.up"),
    Component("horizontal", N_("Horizontal force"), N_("No horizontal force."), "force.right"),
    Component("pitch", N_("Pitch M_V"), N_("No pitch."), "couple.pitch"),
    Component("yaw", N_("Yaw M_H"), N_("No yaw."), "couple.yaw"),
    Component("roll", N_("Rolling moment"), N_("No rolling moment."), "roll"),
)
"""As engineers name what an engine does to its block."""


def waves(component: Component, sums: Totals | Sums) -> Complex:
    """The complex amplitudes [..., order] of a component."""
    if component.key == "roll":
        roll = sums.roll if isinstance(sums, Sums) else rolling_moment(sums)
        return spectra.amplitude(roll)
    vector = sums.force if component.what.startswith("force") else sums.couple
    part = spectra.vertical if component.key in ("vertical", "pitch") else spectra.horizontal
    return part(vector)


def remaining(result: Balance, orders: Sequence[float] | None) -> dict[str, tuple[float, ...]]:
    """The orders of which something is left, by component; of these, else of the usual ones."""
    sums = summed(result)
    pushed, turning = (
        orders or each for each in (orders_pushed(result), orders_turning(result, sums))
    )
    out: dict[str, tuple[float, ...]] = {}
    for component in COMPONENTS:
        spectrum = sums.force if component.what.startswith("force") else sums.couple
        if component.key == "roll":
            spectrum = sums.roll
        size = np.abs(waves(component, sums))
        there = size > NEGLIGIBLE * float(sizes(spectrum).max(initial=0.0))
        left = of_any(("left", component.key), spectrum.orders[there].tolist())
        wanted = turning if component.key == "roll" else pushed
        out[component.key] = tuple(order for order in wanted if order in left)
    return out


def rpm(sweep: Sweep) -> Real:
    """The speeds of a sweep of the speed, rpm."""
    return np.array([float(f"{v:.12g}") for v in rad_per_s(sweep.values, sweep.unit) * RPM])


def document(
    engine: Engine, sweep: Sweep, *, orders: Sequence[float] | None = None, chart: str = ""
) -> Document:
    """A table for each component: its amplitude at every speed, by order and over a turn.

    `chart` is the command that draws them.
    """
    result = balance(engine, reference=sweep.reference)
    left = remaining(result, orders)
    tables = [
        _table(sweep, component, left[component.key])
        for component in COMPONENTS
        if left[component.key]
    ]
    absent = [each for each in COMPONENTS if not left[each.key]]
    none = passage(_(each.none) for each in absent)
    if orders and absent:
        none = _(
            "Nothing of orders {orders}: {parts}.",
            orders=", ".join(order_text(order) for order in orders),
            parts=", ".join(_(each.title) for each in absent),
        )
    missing = missing_sentence(engine)
    heads = (
        *remarks(passage((speed_note(sweep), missing))),
        *remarks(*conditions(engine, replace(result, speed=None))[1:], kind="note"),
        *remarks(assumed_sentence(engine), unverified_sentence(engine), kind="assumed"),
    )
    draw = _("As a chart: {command}", command=chart) if chart else ""
    return Document(engine.name, (*heads, *tables, *remarks(none), *remarks(draw, kind="note")))


def _table(sweep: Sweep, component: Component, orders: Sequence[float]) -> Table:
    unit = watched(sweep, component.what).unit
    there = sweep.sums
    own = waves(component, there)
    places = [int(np.argmin(np.abs(there.force.orders - order))) for order in orders]
    heads = [Column(_("speed"), "rpm", label=True)]
    heads += [Column(_("order {order}", order=order_text(order)), unit) for order in orders]
    heads.append(Column(_("peak"), unit))
    rows = tuple(
        (speed, *lengths(row), peak)
        for speed, row, peak in zip(
            rpm(sweep).tolist(), own[:, places], _peaks(sweep, component), strict=True
        )
    )
    return Table(_(component.title), tuple(heads), rows)


def _peaks(sweep: Sweep, component: Component) -> list[float]:
    """The greatest value of a component over a turn, of all orders together, at each speed."""
    own = waves(component, sweep.sums)
    signal = spectra.real_signal(sweep.sums.force.orders, own)
    return peaks(signal, watched(sweep, component.what).values)


def _peak_table(sweep: Sweep) -> Table:
    """The peaks over a turn for machines, at every speed."""
    heads = (
        Column("speed_rpm", "rpm", key="speed_rpm"),
        Column("quantity", kind="text", key="quantity"),
        Column("peak", ROW_UNIT, key="peak"),
        Column("unit", kind="unit", key="unit"),
    )
    units = {each.key: watched(sweep, each.what).unit for each in COMPONENTS}
    rows: list[tuple[Value, ...]] = [
        (speed, each.key, peak, units[each.key])
        for each in COMPONENTS
        for speed, peak in zip(rpm(sweep).tolist(), _peaks(sweep, each), strict=True)
    ]
    return Table("", heads, tuple(rows), key="peaks")


def _orders(engine: Engine, sweep: Sweep) -> tuple[float, ...]:
    """The orders at which a part pushes or the block rolls."""
    result = balance(engine, reference=sweep.reference)
    return orders_turning(result, summed(result))


def answer(engine: Engine, sweep: Sweep, *, orders: Sequence[float] | None = None) -> Document:
    """The amplitudes of each order at every speed for machines, as `analyze` gives them."""
    wanted = orders or _orders(engine, sweep)
    heads = (Column("speed_rpm", "rpm", key="speed_rpm"), *balance_orders.columns(sweep.units))
    sums = sweep.sums
    rows: list[tuple[Value, ...]] = []
    for index, speed in enumerate(rpm(sweep).tolist()):
        own = Totals(*(spectrum[index] for spectrum in sums))
        rows += [(speed, *row) for row in balance_orders.rows(engine, own, wanted)]
    point = sweep.reference._asdict()
    said = {**facts(sweep), "rotation": engine.rotation, "reference": point}
    tables = (Table("", heads, tuple(rows), key="orders"), _peak_table(sweep))
    return Document(engine.name, tables, said)


def tidy(engine: Engine, sweep: Sweep, *, orders: Sequence[float] | None = None) -> Document:
    """One row an amplitude, with the columns of `analyze --csv`; peaks have no order."""
    wanted = orders or _orders(engine, sweep)
    sums = Totals(*(spectra.selected(spectrum, wanted) for spectrum in sweep.sums))
    speeds = rpm(sweep).tolist()
    labels = {"speed_rpm": speeds, "part": [amplitudes.WHOLE] * len(speeds)}
    rows = columns(sums, sweep.units._asdict(), labels)
    for each in COMPONENTS:
        count = len(speeds)
        quantity, direction = TIDY[each.key]
        more = {
            **labels,
            "order": [None] * count,
            "quantity": [quantity] * count,
            "direction": [direction] * count,
            "amplitude": _peaks(sweep, each),
            "phase_deg": [None] * count,
            "unit": [watched(sweep, each.what).unit] * count,
        }
        rows = amplitudes.joined(rows, more)
    return amplitudes.document(engine.name, rows)


TIDY = {
    "vertical": ("force", "vertical"),
    "horizontal": ("force", "horizontal"),
    "pitch": ("pitch", "vertical"),
    "yaw": ("yaw", "horizontal"),
    "roll": ("roll", "axial"),
}
"""Quantity and direction of each component in a tidy table."""
