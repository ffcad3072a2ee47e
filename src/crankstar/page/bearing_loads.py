"""Loads on main bearings and crank pins, as the page is sent them: vectors, peaks and tables."""

from __future__ import annotations

from collections.abc import Iterator
from math import degrees

import numpy as np

from crankstar import spectra
from crankstar.dynamics.bearings import BearingLoads, bearing_loads
from crankstar.engine.engine import Engine
from crankstar.language.messages import _
from crankstar.language.numbers import number, unit_text
from crankstar.language.shown_units import shown
from crankstar.page.orders import vectors
from crankstar.page.printed import printed
from crankstar.page.records import Bearings, LoadShown
from crankstar.spectra import Spectrum
from crankstar.tables.bearings import MODELS, peaks, pins

SMALL = 1e-4
"""Share of the greatest order below which an order is not sent."""


def bearings_shown(engine: Engine) -> Bearings:
    """The loads of an engine at the speed of its file, order by order, with their tables.

    >>> from crankstar.files.catalog import load
    >>> shown = bearings_shown(load("i4"))
    >>> [load.name for load in shown.loads][:2], len(shown.tables)
    (['bearing 1', 'bearing 2'], 2)
    """
    loads = bearing_loads(engine, speed=engine.speed)
    orders = _orders(loads)
    every = [spectra.peak(part).value for part in (*_each(loads.load), *_each(loads.pin))]
    said = shown(loads.unit, max(every))
    return Bearings(
        orders=orders,
        unit=unit_text(said.unit),
        model=_(MODELS[loads.model]),
        loads=tuple(_loads(engine, loads, orders, said.factor)),
        tables=printed((peaks(engine, loads), pins(loads))),
    )


def _orders(loads: BearingLoads) -> tuple[float, ...]:
    """The orders that move a drawn vector."""
    size = np.zeros(loads.load.orders.size)
    for spectrum in (loads.load, loads.pin):
        size = np.maximum(size, (np.abs(spectrum.forward) + np.abs(spectrum.backward)).max(axis=0))
    kept: list[float] = loads.load.orders[size > SMALL * size.max(initial=0.0)].tolist()
    return tuple(kept)


def _each(spectrum: Spectrum) -> list[Spectrum]:
    return [spectrum[index] for index in range(len(spectrum.forward))]


def _loads(
    engine: Engine, loads: BearingLoads, orders: tuple[float, ...], factor: float
) -> Iterator[LoadShown]:
    """The main bearings, then the crank pins."""
    several = len({bearing.shaft for bearing in loads.bearings}) > 1
    for index, bearing in enumerate(loads.bearings):
        words = _("bearing {number}", number=bearing.number)
        name = f"{bearing.shaft}: {words}" if several else words
        yield _load(engine, "bearing", bearing.shaft, name, loads.load[index], orders, factor)
    for index, pin in enumerate(loads.pins):
        words = _("pin {number}", number=pin.throw)
        name = f"{pin.shaft}: {words}" if several else words
        yield _load(engine, "pin", pin.shaft, name, loads.pin[index], orders, factor)


def _load(
    engine: Engine,
    on: str,
    shaft: str,
    name: str,
    load: Spectrum,
    orders: tuple[float, ...],
    factor: float,
) -> LoadShown:
    scaled = spectra.scaled(load, factor)
    top = spectra.peak(scaled)
    return LoadShown(
        on="bearing" if on == "bearing" else "pin",
        name=name,
        speed_ratio=float(engine.shaft(shaft).speed_ratio),
        load=vectors(scaled, orders),
        peak=top.value,
        peak_theta=top.theta,
        greatest=_(
            "{size} at {angle}°",
            size=number(float(f"{top.value:.4g}")),
            angle=number(float(f"{degrees(top.theta):.4g}")),
        ),
    )
