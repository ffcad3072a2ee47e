"""Loads on main bearings and crank pins, as the page is sent them: vectors, peaks and tables."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import lru_cache
from typing import Literal

import numpy as np

from crankstar import spectra
from crankstar.analyses.bearings.document import MODELS, gas_sentences, peaks, pins
from crankstar.analyses.bearings.wear_table import wear_table
from crankstar.analysis.document import Document, Ranged, Table, Value
from crankstar.dynamics.bearings import BearingError, BearingLoads, bearing_loads
from crankstar.engine.engine import Engine
from crankstar.files.box import Spread
from crankstar.language.alike import alike
from crankstar.language.messages import _
from crankstar.language.numbers import number, unit_text
from crankstar.mechanics.gas import Cycle, cycle
from crankstar.mechanics.operating_points import GasError
from crankstar.page.orders import vectors
from crankstar.page.printed import printed
from crankstar.page.records import BearingNumbers, Bearings, LoadShown
from crankstar.spectra import Spectrum
from crankstar.tables.cells import ranged_text
from crankstar.tables.conversion import in_units
from crankstar.tables.laid import merged

SMALL = 1e-4
"""Share of the greatest order below which an order is not sent."""
SMALL_WITH_GAS = 1e-3
"""The same with gas, whose orders are many."""


@lru_cache(maxsize=16)
def loads_with_gas(engine: Engine) -> tuple[Cycle, BearingLoads] | None:
    """The cycle of an engine at its first operating point, and its loads with it.

    None where the file does not say what the gas does, or speed or masses are not known.

    >>> from crankstar.files.catalog import load
    >>> loads_with_gas(load("i4")) is None, loads_with_gas(load("audi-25-tfsi"))[0].name
    (True, 'full')
    """
    if engine.gas is None:
        return None
    try:
        found = cycle(engine)
        return found, bearing_loads(engine, cycle=found)
    except (GasError, BearingError):
        return None


def gas_bearings_shown(engine: Engine) -> Bearings | None:
    """The loads of an engine with the gas of its first operating point, order by order."""
    known = loads_with_gas(engine)
    return None if known is None else bearings_shown(engine, known[1], small=SMALL_WITH_GAS)


def gas_bearing_numbers(engine: Engine) -> BearingNumbers | None:
    """Their greatest values and tables, wear with them, in the units of the context."""
    known = loads_with_gas(engine)
    if known is None:
        return None
    found, loads = known
    tables = (peaks(engine, loads, gas=True), pins(loads), wear_table(engine, loads))
    return _numbers(Document("", tables), about=gas_sentences(found))


def bearings_shown(
    engine: Engine, known: BearingLoads | None = None, *, small: float = SMALL
) -> Bearings:
    """The loads of an engine at the speed of its file, order by order; `known` if they are there.

    >>> from crankstar.files.catalog import load
    >>> [load.name for load in bearings_shown(load("i4")).loads][:2]
    ['bearing 1', 'bearing 2']
    """
    loads = known or bearing_loads(engine, speed=engine.speed)
    return Bearings(
        orders=(orders := _orders(loads, small)),
        model=_(MODELS[loads.model]),
        loads=tuple(_loads(engine, loads, orders)),
    )


def bearing_numbers(
    engine: Engine, over: Spread | None = None, known: BearingLoads | None = None
) -> BearingNumbers:
    """Their greatest values and tables, in the units of the context; with ranges over a Spread.

    >>> from crankstar.files.catalog import load
    >>> bearing_numbers(load("kr250-racer")).greatest[0]
    '0.375 at 0°'
    """

    def sheet(each: Engine) -> Document:
        loads = known if known and each is engine else bearing_loads(each, speed=each.speed)
        return Document("", (peaks(each, loads), pins(loads)))

    return _numbers(sheet(engine) if over is None else merged(alike(sheet, over.engines)))


def _numbers(document: Document, *, about: tuple[str, ...] = ()) -> BearingNumbers:
    """The numbers of a document whose first tables are those of bearings and pins."""
    on_bearings, on_pins, *_more = (in_units(table.readable) for table in document.tables)
    cells = [cell for table in (on_bearings, on_pins) for cell in _greatest(table)]
    return BearingNumbers(
        bearing_unit=_unit(on_bearings),
        pin_unit=_unit(on_pins),
        greatest=tuple(_phrase(size, angle) for size, angle in cells),
        estimated=any(isinstance(size, Ranged) for size, _angle in cells),
        tables=printed(document.tables),
        about=about,
    )


def _column(table: Table, key: str) -> int:
    return next(index for index, column in enumerate(table.columns) if column.key == key)


def _unit(table: Table) -> str:
    return unit_text(table.columns[_column(table, "peak/value")].unit)


def _greatest(table: Table) -> list[tuple[Value, Value]]:
    """The greatest value of each row, and the crank angle of it; None where there is no load."""
    size, angle = (_column(table, key) for key in ("peak/value", "peak/theta_deg"))
    return [(row[size], row[angle]) for row in table.rows]


def _phrase(size: Value, angle: Value) -> str:
    if angle is None:
        return _("no load")
    return _("{size} at {angle}°", size=_figure(size), angle=_figure(angle))


def _figure(value: Value) -> str:
    """A number in four figures, or with its range."""
    if isinstance(value, Ranged):
        return ranged_text(value)
    return number(value, digits=4) if isinstance(value, float | int) else ""


def _orders(loads: BearingLoads, small: float) -> tuple[float, ...]:
    """The orders that move a drawn vector."""
    size = np.zeros(loads.load.orders.size)
    for spectrum in (loads.load, loads.pin):
        size = np.maximum(size, (np.abs(spectrum.forward) + np.abs(spectrum.backward)).max(axis=0))
    kept: list[float] = loads.load.orders[size > small * size.max(initial=0.0)].tolist()
    return tuple(kept)


def _loads(engine: Engine, loads: BearingLoads, orders: tuple[float, ...]) -> Iterator[LoadShown]:
    """The main bearings, then the crank pins."""
    several = len({bearing.shaft for bearing in loads.bearings}) > 1
    bearings = [(own.shaft, _("bearing {number}", number=own.number)) for own in loads.bearings]
    pins = [(pin.shaft, _("pin {number}", number=pin.throw)) for pin in loads.pins]
    kinds: tuple[tuple[Literal["bearing", "pin"], Sequence[tuple[str, str]], Spectrum], ...]
    kinds = (("bearing", bearings, loads.load), ("pin", pins, loads.pin))
    for on, places, load in kinds:
        tops = spectra.tops(load)
        for index, ((shaft, words), top) in enumerate(zip(places, tops, strict=True)):
            yield LoadShown(
                on=on,
                name=f"{shaft}: {words}" if several else words,
                speed_ratio=float(engine.shaft(shaft).speed_ratio),
                load=vectors(load[index], orders),
                peak=top.value,
                peak_theta=top.theta,
            )
