"""Specific pressures of main bearings and crank pins, and their least oil film, as a table."""

from __future__ import annotations

from collections.abc import Iterator
from math import degrees
from typing import NamedTuple

import numpy as np

from crankstar import spectra
from crankstar.analysis.document import Column, Table, Value
from crankstar.dynamics.bearings import BearingLoads
from crankstar.dynamics.oil_film import SAMPLES, OilFilmError, Orbit, orbit
from crankstar.engine.engine import Engine
from crankstar.engine.oil import PlainBearing
from crankstar.language.messages import _
from crankstar.mechanics.side_thrust import rod_speeds
from crankstar.spectra import Real, Spectrum


class _Loaded(NamedTuple):
    """A bearing: its shaft, its name, its sizes, the load in it (N), the cylinder of its rod.

    Whether its journal pushes it or is pushed: the film is the same half a turn further.
    """

    shaft: str
    name: str
    bearing: PlainBearing
    load: Spectrum
    cylinder: int | None = None


def film_table(engine: Engine, loads: BearingLoads) -> Table | None:
    """Of each bearing whose size the file gives the greatest and mean pressure, and its least film.

    None without sizes, or where loads are not in newtons.
    """
    if engine.oil is None or loads.unit != "N":
        return None
    columns = (
        Column(_("shaft"), kind="text", key="shaft", label=True, wraps=True),
        Column(_("journal"), kind="text", key="journal", label=True),
        Column(_("greatest pressure"), "Pa", key="pressure"),
        Column(_("mean pressure"), "Pa", key="mean_pressure"),
        Column(_("least film"), "µm", key="film", fixed=True),
        Column("θ", "deg", key="film_theta_deg"),
        Column(_("eccentricity"), key="eccentricity", digits=4),
    )
    rows: list[tuple[Value, ...]] = []
    notes: list[str] = []
    for each in _loaded(engine, loads):
        turns = spectra.period(each.load)
        theta = np.linspace(0.0, 2 * np.pi * turns, 720 * turns, endpoint=False)
        sizes = np.abs(spectra.value(each.load, theta)) / each.bearing.area
        film: tuple[Value, ...] = (None, None, None)
        try:
            found = _orbit(engine, loads, each)
            if found is not None:
                at = found.least_theta
                film = (found.least * 1e6, degrees(at), float(np.abs(found.epsilon).max()))
        except OilFilmError as error:
            notes.append(f"{each.name}: {error}")
        rows.append((each.shaft, each.name, float(sizes.max()), float(sizes.mean()), *film))
    notes.append(
        _(
            "Pressure: load over diameter times length. Least film: rigid round short bearing, "
            "mobility method; for one design beside another, not for its last micrometre."
        )
    )
    if engine.oil.pin is not None and len(loads.big_ends) > len(loads.pins):
        notes.append(_("Where several rods share a pin, each has a bearing of its own on it."))
    if any(row[4] is None for row in rows):
        notes.append(
            _("For the film give clearance and oil.viscosity: {keys}.", keys="oil.main, oil.pin")
        )
    title = _("Specific pressures and oil films")
    return Table(title, columns, tuple(rows), notes=tuple(dict.fromkeys(notes)), key="films")


def _loaded(engine: Engine, loads: BearingLoads) -> Iterator[_Loaded]:
    oil = engine.oil
    assert oil is not None  # noqa: S101  # asked before
    if oil.main is not None:
        for index, bearing in enumerate(loads.bearings):
            name = _("main {number}", number=bearing.number)
            yield _Loaded(bearing.shaft, name, oil.main, loads.load[index])
    if oil.pin is not None:
        on_pins = [(each.shaft, each.throw) for each in loads.big_ends]
        for index, (each, place) in enumerate(zip(loads.big_ends, on_pins, strict=True)):
            name = _("pin {number}", number=each.throw)
            if on_pins.count(place) > 1:
                name = _(
                    "pin {number}, cylinder {cylinder}", number=each.throw, cylinder=each.cylinder
                )
            yield _Loaded(each.shaft, name, oil.pin, loads.big_end[index], each.cylinder)


def _orbit(engine: Engine, loads: BearingLoads, each: _Loaded) -> Orbit | None:
    """The orbit in a bearing; None where clearance or viscosity are not known."""
    oil, bearing = engine.oil, each.bearing
    if oil is None or oil.viscosity is None or bearing.clearance is None or loads.speed is None:
        return None
    turning: float | Real = float(engine.shaft(each.shaft).speed_ratio) * engine.sense
    if each.cylinder is not None:
        row = [one.number for one in engine.cylinders].index(each.cylinder)
        turns = spectra.period(each.load)
        steps = np.linspace(0.0, 2 * np.pi * turns, SAMPLES * turns, endpoint=False)
        turning = turning + rod_speeds(engine, steps)[row]
    return orbit(
        each.load,
        speed=loads.speed,
        mean_speed=loads.speed * turning / 2,
        diameter=bearing.diameter,
        length=bearing.length,
        clearance=bearing.clearance,
        viscosity=oil.viscosity,
    )
