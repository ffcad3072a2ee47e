"""Where main journals and crank pins are loaded most and least, as a table."""

from __future__ import annotations

from math import degrees

from crankstar.analysis.document import Column, Table, Value
from crankstar.dynamics.bearings import BearingLoads
from crankstar.dynamics.wear import Wear, wear
from crankstar.engine.engine import Engine
from crankstar.language.messages import _


def wear_table(engine: Engine, loads: BearingLoads) -> Table:
    """Of each main journal and crank pin the mean load, and where it is pressed most and least.

    Directions are bearings at theta = 0, and turn with the crankshaft.
    """
    columns = (
        Column(_("shaft"), kind="text", key="shaft", label=True, wraps=True),
        Column(_("journal"), kind="text", key="journal", label=True),
        Column(_("mean load"), loads.unit, key="mean"),
        Column(_("pressed most at"), "deg", key="most_deg"),
        Column(_("pressed least at"), "deg", key="least_deg"),
    )
    rows: list[tuple[Value, ...]] = []
    for index, bearing in enumerate(loads.bearings):
        ratio = float(engine.shaft(bearing.shaft).speed_ratio)
        name = _("main {number}", number=bearing.number)
        rows.append((bearing.shaft, name, *_cells(wear(loads.load[index], speed_ratio=ratio))))
    for index, pin in enumerate(loads.pins):
        ratio = float(engine.shaft(pin.shaft).speed_ratio)
        name = _("pin {number}", number=pin.throw)
        found = wear(loads.pin[index], speed_ratio=ratio, inward=True)
        rows.append((pin.shaft, name, *_cells(found)))
    note = _(
        "Bearings at θ = 0, turning with the crankshaft; a load presses 60° to both sides of where "
        "it acts. An oil hole belongs where the journal is pressed least."
    )
    title = _("Wear of journals and pins")
    return Table(title, columns, tuple(rows), notes=(note,), key="wear")


def _cells(found: Wear) -> tuple[Value, ...]:
    """The mean, and the directions in degrees."""
    return found.mean, _deg(found.most), _deg(found.least)


def _deg(angle: float | None) -> float | None:
    return None if angle is None else round(degrees(angle), 3) + 0.0
