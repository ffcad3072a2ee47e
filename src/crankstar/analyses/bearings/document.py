"""Loads on main bearings, crank pins and cylinder walls as tables."""

from __future__ import annotations

from collections.abc import Sequence
from math import degrees

import numpy as np

from crankstar import spectra
from crankstar.analyses.bearings.answer import Loads
from crankstar.analyses.bearings.film_table import film_table
from crankstar.analyses.bearings.question import Question
from crankstar.analyses.bearings.wear_table import wear_table
from crankstar.analysis.document import Column, Document, Table, Value, for_each, remarks
from crankstar.dynamics.bearings import BearingLoads, Model, bending_moment
from crankstar.engine.engine import Engine
from crankstar.language.alike import of_any
from crankstar.language.messages import N_, _
from crankstar.language.numbers import NEGLIGIBLE, RPM, number, numbers_text, rpm_of
from crankstar.language.shown_units import quantity_text
from crankstar.mechanics.balance import balance
from crankstar.mechanics.bounds import greatest, highest, length, tops
from crankstar.mechanics.gas import Cycle
from crankstar.mechanics.gas_pins import HIGHEST
from crankstar.options import values
from crankstar.spectra import Spectrum
from crankstar.tables.conditions import unit_sentence, unit_sizes
from crankstar.tables.gas_words import cycle_state, points_text, state_facts
from crankstar.tables.headings import heading
from crankstar.tables.paths import shape
from crankstar.tables.scales import scales

NOTED = 0.02
"""Share of the greatest load of one order from which an order is printed."""
NOTED_WITH_GAS = 0.2
"""The same with gas, which has many orders."""
MODELS = {
    "determinate": N_(
        "Crankshaft hinged at each main bearing: a force is carried by the two beside it."
    ),
    "continuous": N_("Crankshaft as one uniform beam on all main bearings."),
}


def document(engine: Engine, computed: Loads, question: Question) -> Document:
    """Peaks of all bearings, pins and walls over a revolution, and the bearings by order.

    Orders are those asked for, or else the significant ones, for machines all.
    """
    cycle, turning, model = computed.cycle, computed.speed, question.model
    loads = computed.of_parts
    noted = NOTED if cycle is None else NOTED_WITH_GAS
    orders = values.orders(question.orders, main_orders(loads, share=0.0))
    shown, every = (
        by_order(
            loads, sorted(of_any(("orders", share), orders or main_orders(loads, share=share)))
        )
        for share in (noted, 0.0)
    )
    result = balance(engine, speed=turning)
    notes = (
        *(() if cycle is None else gas_sentences(cycle)),
        _("By order those with a fifth of the greatest are listed; --orders all has them all.")
        if cycle is not None
        else "",
        _(MODELS[model]),
        unit_sentence(engine, result),
        unit_sizes(engine, result),
    )
    films = film_table(engine, loads)
    facts = {
        "engine": engine.name,
        "model": model,
        "speed_rpm": rpm_of(loads.speed),
        "unit": loads.unit,
        **(
            {}
            if cycle is None
            else {**state_facts(cycle_state(cycle)), "imep": cycle.imep, "off": list(cycle.off)}
        ),
    }
    return Document(
        engine.name,
        (
            heading(engine),
            *remarks(*notes, kind="note"),
            peaks(engine, loads, gas=cycle is not None),
            *for_each(shown, every),
            pins(loads),
            walls(loads),
            wear_table(engine, loads),
            *(() if films is None else (films,)),
            bending(engine, speed=turning, model=model, cycle=cycle),
        ),
        facts,
    )


def main_orders(loads: BearingLoads, *, share: float) -> list[float]:
    """The orders with at least this share of the greatest on any bearing."""
    size = (np.abs(loads.load.forward) + np.abs(loads.load.backward)).max(axis=0, initial=0.0)
    return loads.load.orders[size > share * size.max(initial=0.0)].tolist()


def _place(value: complex, largest: float) -> Value:
    """The bearing of a vector in degrees, none of one that is nothing."""
    if abs(value) <= NEGLIGIBLE * largest:
        return None
    return 180.0 - (180.0 - round(degrees(float(np.angle(value))), 6)) % 360.0


def _steady(spectrum: Spectrum) -> np.ndarray:
    """The mean over a turn of each part."""
    still = spectra.selected(spectrum, 0.0)
    return (still.forward + still.backward)[:, 0]


def _peak_cells(loads: Spectrum, largest: float | None = None) -> list[tuple[Value, ...]]:
    """Of each load its greatest, at which crank angle, where it points.

    `largest` is what they are small beside, by default the greatest of them.
    """
    found = tops(loads)
    largest = max((float(top.value) for top in found), default=0.0) if largest is None else largest
    return [
        (
            top.value,
            round(degrees(top.theta), 6) + 0.0 if top.value > NEGLIGIBLE * largest else None,
            _place(top.vector, largest),
        )
        for top in found
    ]


def _peak_columns(unit: str) -> tuple[Column, ...]:
    return (
        Column(_("greatest"), unit, key="peak/value"),
        Column("θ", "deg", key="peak/theta_deg"),
        Column(_("bearing"), "deg", key="peak/bearing_deg"),
    )


def gas_sentences(cycle: Cycle) -> tuple[str, ...]:
    """Which gas is in the loads, and how fast the engine turns."""
    values = {
        "point": points_text(cycle.shares),
        "rpm": number((cycle.speed or 0.0) * RPM),
        "pressure": quantity_text(cycle.imep, "Pa"),
    }
    lines = [_("With gas at {rpm} rpm, {pressure} indicated mean effective pressure.", **values)]
    if cycle.name:
        lines = [
            _(
                "With gas at the operating point {point}, {rpm} rpm, {pressure} indicated mean "
                "effective pressure.",
                **values,
            )
        ]
    if len(cycle.shares) > 1:
        lines = [
            _(
                "With gas between the operating points {point}, {rpm} rpm, {pressure} indicated "
                "mean effective pressure.",
                **values,
            )
        ]
    if cycle.off:
        lines.append(_("Without combustion: cylinders {numbers}.", numbers=numbers_text(cycle.off)))
    lines.append(_("Orders of the gas up to {highest} are in it.", highest=number(HIGHEST)))
    return tuple(lines)


def peaks(engine: Engine, loads: BearingLoads, *, gas: bool = False) -> Table:
    """The greatest load of each main bearing over a turn, where it points, and the mean vector.

    The length of the mean of the vector, which is that of order 0; the mean of its length, by which
    a bearing wears, is the mean load of the table of wear.
    """
    along = scales(engine).along
    columns = (
        Column(_("shaft"), kind="text", key="shaft", label=True, wraps=True),
        Column(_("main bearing"), key="bearing", label=True),
        Column("z", along.unit, key="z"),
        Column(_("place"), kind="text", key="place", optional=1),
        *_peak_columns(loads.unit),
        Column(_("mean vector"), loads.unit, key="mean_vector"),
    )
    steady = _steady(loads.load).tolist()
    tops = _peak_cells(loads.load)
    rows: list[tuple[Value, ...]] = []
    for bearing, top, mean in zip(loads.bearings, tops, steady, strict=True):
        place = _("assumed") if bearing.assumed else _("from the file")
        cells = (bearing.shaft, bearing.number, along.of(bearing.z), place)
        rows.append((*cells, *top, length(mean)))
    doubtful = frozenset(i for i, bearing in enumerate(loads.bearings) if bearing.assumed)
    title = _("Loads on main bearings from inertia and weights, over a turn")
    if gas:
        title = _("Loads on main bearings from gas, inertia and weights, over a cycle")
    return Table(title, columns, tuple(rows), key="bearings", doubtful=doubtful)


def by_order(loads: BearingLoads, orders: Sequence[float]) -> Table:
    """The load of each main bearing, order by order; order 0 is steady."""
    columns = (
        Column(_("shaft"), kind="text", key="shaft", label=True, wraps=True),
        Column(_("main bearing"), key="bearing", label=True),
        Column(_("order"), key="order", label=True),
        Column(_("vertical"), loads.unit, kind="wave", key="vertical"),
        Column(_("horizontal"), loads.unit, kind="wave", key="horizontal"),
        Column(_("path"), kind="text", wraps=True, optional=2),
        Column(_("forward"), loads.unit, kind="vector", key="forward", machine=True),
        Column(_("backward"), loads.unit, kind="vector", key="backward", machine=True),
        Column(_("greatest"), loads.unit, key="greatest"),
    )
    chosen = spectra.selected(loads.load, list(orders))
    up, right = spectra.vertical(chosen), spectra.horizontal(chosen)
    largest = float(spectra.peaks(loads.load).max(initial=0.0))
    rows: list[tuple[Value, ...]] = []
    for index, bearing in enumerate(loads.bearings):
        for place, order in enumerate(orders):
            forward, backward = (
                complex(side[index, place]) for side in (chosen.forward, chosen.backward)
            )
            path = spectra.ellipse(forward, backward)
            own = (bearing.shaft, bearing.number, order)
            if not of_any(own, [True] * (path.semi_major > NEGLIGIBLE * largest)):
                continue
            waves = [
                wave if abs(wave) > NEGLIGIBLE * path.semi_major else 0j
                for wave in (complex(up[index, place]), complex(right[index, place]))
            ]
            if order == 0:
                waves = [complex((forward + backward).real), complex((forward + backward).imag)]
            words = _("steady") if order == 0 else shape(path, largest)
            ends = (words, forward, backward, greatest(forward, backward))
            rows.append((bearing.shaft, bearing.number, float(order), *waves, *ends))
    return Table(_("Main bearings by order"), columns, tuple(rows), key="orders")


def pins(loads: BearingLoads) -> Table:
    """The greatest load that the rods put on each crank pin."""
    columns = (
        Column(_("shaft"), kind="text", key="shaft", label=True, wraps=True),
        Column(_("throw"), key="throw", label=True),
        Column(_("cylinders"), kind="list", key="cylinders"),
        *_peak_columns(loads.unit),
    )
    rows = tuple(
        (pin.shaft, pin.throw, pin.cylinders, *top)
        for pin, top in zip(loads.pins, _peak_cells(loads.pin), strict=True)
    )
    return Table(_("Loads of the rods on crank pins"), columns, rows, key="pins")


def walls(loads: BearingLoads) -> Table:
    """The greatest guide force of each piston on its cylinder."""
    columns = (Column(_("cylinder"), key="cylinder", label=True), *_peak_columns(loads.unit))
    largest = float(spectra.peaks(loads.pin).max(initial=0.0))
    tops = _peak_cells(loads.guide, largest)
    rows = tuple((own, *top) for own, top in zip(loads.cylinders, tops, strict=True))
    return Table(_("Guide forces of the pistons on their cylinders"), columns, rows, key="guides")


def bending(
    engine: Engine, *, speed: float | None, model: Model, cycle: Cycle | None = None
) -> Table:
    """The greatest bending moment of each crankshaft, in its end bearings alone and in all."""
    along = scales(engine).along
    cranks = [shaft.name for shaft in engine.shafts if shaft.throws]
    unit = bending_moment(engine, shaft=cranks[0], speed=speed).unit
    columns = (
        Column(_("shaft"), kind="text", key="shaft", label=True, wraps=True),
        Column(_("crankshaft"), kind="text", key="held", label=True),
        Column(_("greatest"), unit, key="moment"),
        Column("z", along.unit, key="z"),
    )
    rows: list[tuple[Value, ...]] = []
    for name in cranks:
        states: tuple[tuple[str, Model | None], ...]
        states = ((_("in its end bearings"), None), (_("in all its bearings"), model))
        for words, held in states:
            bend = bending_moment(engine, shaft=name, speed=speed, model=held, cycle=cycle)
            sizes = spectra.peaks(bend.moment)
            worst = int(np.argmax(sizes >= sizes.max() * (1 - 1e-9)))
            rows.append((name, words, highest(bend.moment), along.of(bend.z[worst])))
    title = _("Bending moment of the crankshaft")
    return Table(title, columns, tuple(rows), key="bending")
