"""The pressure in the cylinders: over the crank angle, and over the volume (indicator diagram)."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from typing import Literal

import numpy as np

from crankstar.charts.canvas import curve_height, panel_width
from crankstar.charts.drawing import LINES, PALETTE, Panel, figure, layered
from crankstar.charts.gas_curves import (
    MOST_POINTS,
    ROOM,
    Line,
    about,
    over_angle,
    said_pressure,
    without,
)
from crankstar.charts.grammar import Chart, field, of_rows, span
from crankstar.charts.resting import of_gas
from crankstar.charts.sums import checked_quantity
from crankstar.engine.engine import Engine
from crankstar.language.messages import N_, _
from crankstar.language.shown_units import shown
from crankstar.mechanics.gas import SAMPLES, Cycle, check_gas, cycle
from crankstar.mechanics.operating_points import GasError

PressureView = Literal["volume", "angle"]
TITLES = {"volume": N_("Indicator diagram"), "angle": N_("Pressure over the crank angle")}
MOST_LINES = 5
"""Lines of one figure: chambers that are alike have one."""


def pressure_chart(
    engine: Engine,
    *,
    quantity: PressureView | None = None,
    point: str | None = None,
    speed: float | None = None,
    off: Sequence[int] = (),
) -> Chart:
    """The pressure of a cylinder over its volume, or over its crank angle from firing.

    At an operating point, or at the load of the file; a line for each cylinder that differs from
    the others. At `speed` (rad/s), with cylinders that are `off`. Raises ChartError.
    """
    wanted: PressureView = (
        "volume" if quantity is None else checked_quantity(quantity, PressureView)
    )
    title = _(TITLES[wanted])
    try:
        check_gas(engine)
    except GasError as error:
        return without(engine, title=title, reason=str(error))
    make = partial(cycle, point=point or "", speed=speed, off=off)
    found = make(engine)
    panel = _over_volume(found) if wanted == "volume" else _over_angle(found)
    subtitle = [*about(engine, found), *_words(found, wanted)]
    rests = of_gas(engine, make, ("peak pressure", "mean torque"), "torque")
    return figure([[panel]], title=title, subtitle=subtitle, rests=rests)


def _words(found: Cycle, view: PressureView) -> list[str]:
    lines = [_("peak {pressure}", pressure=said_pressure(found.peak))]
    if view == "angle":
        lines.append(_("from the dead centre at which the cylinder fires"))
    return lines


def _different(found: Cycle) -> list[tuple[str, int]]:
    """Chambers of which no other is alike, with their names: the first of each kind."""
    kinds: dict[bytes, list[int]] = {}
    for row, pressure in enumerate(found.pressure):
        kinds.setdefault(np.round(pressure, 1).tobytes(), []).append(row)
    out: list[tuple[str, int]] = []
    for rows in kinds.values():
        numbers = [found.volumes.numbers[row] for row in rows]
        if len(kinds) == 1:
            name = _("every cylinder") if len(numbers) > 1 else _("the cylinder")
        elif len(numbers) > 4:
            name = _("{count} cylinders", count=len(numbers))
        else:
            name = _("cylinder {number}", number=", ".join(map(str, numbers)))
        out.append((name, rows[0]))
    return out[:MOST_LINES]


def _over_angle(found: Cycle) -> Panel:
    theta = np.arange(SAMPLES) * (found.volumes.cycle / SAMPLES)
    chambers = _different(found)
    lines = [
        Line(name, PALETTE[index % len(PALETTE)], 2.0, found.pressure[row])
        for index, (name, row) in enumerate(chambers)
    ]
    return over_angle(
        theta, lines, title=N_("pressure ({unit})"), unit="Pa", height=200, legend=len(lines) > 1
    )


def _over_volume(found: Cycle) -> Panel:
    places = found.volumes
    chambers = _different(found)
    said = shown("Pa", found.peak)
    ratio = found.values["compression_ratio"]
    step = max(1, SAMPLES // (2 * MOST_POINTS))
    rows = []
    for name, row in chambers:
        kind = places.kind[row]
        volume = places.above[kind] + places.swept[kind] / (ratio - 1)
        curve = [*range(0, SAMPLES, step), 0]
        rows += [
            {
                "x": float(f"{volume[at] * 1e6:.6g}"),
                "y": float(f"{found.pressure[row][at] * said.factor:.6g}"),
                "what": name,
                "at": index,
            }
            for index, at in enumerate(curve)
        ]
    colours = {"domain": [c[0] for c in chambers], "range": list(PALETTE[: len(chambers)])}
    legend = {**LINES, "columns": 2} if len(chambers) > 1 else None
    lines = of_rows(rows).mark("line", strokeJoin="round", strokeWidth=1.8)
    drawn = lines.encode(
        x=field(
            "x:Q",
            scale=span(0, ROOM * max(row["x"] for row in rows)),
            title=_("volume (cm³)"),
            axis={"tickCount": 5},
        ),
        y=field(
            "y:Q",
            scale=span(0, ROOM * max(row["y"] for row in rows)),
            title=_("pressure ({unit})", unit=said.unit),
            axis={"tickCount": 5},
        ),
        color=field("what:N", scale=colours, legend=legend),
        order=field("at:Q"),
    )
    return layered([drawn], width=panel_width(), height=curve_height(220))
