"""The figures by name, as in `crankstar plot`."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from crankstar.analysis.record import Chart
from crankstar.analysis.registry import added, analyses
from crankstar.charts.drawing import ChartError
from crankstar.charts.grammar import Chart as Drawn
from crankstar.engine.engine import Engine
from crankstar.language.messages import N_, _
from crankstar.mechanics.operating_points import common_speed


def _chart(name: str, path: str, about: str, kind: str = "") -> Chart:
    """One of a module of this room."""
    return Chart(name, f"crankstar.charts.{path}", about, kind)


_FIGURES = (
    _chart(
        "crank-star",
        "crank_stars:crank_star",
        N_("the throws of the crankshafts, seen from the front"),
    ),
    _chart(
        "vector-star",
        "vector_stars:vector_star",
        N_("the vectors of one order of every cylinder, throw and weight"),
        "Quantity",
    ),
    _chart(
        "polygon",
        "vector_stars:polygon",
        N_("the vectors of one order head to tail, with their resultant"),
        "Quantity",
    ),
    _chart(
        "hodograph",
        "hodographs:hodograph",
        N_("the path of force or couple, of one order or of all"),
        "Quantity",
    ),
    _chart(
        "over-turn",
        "curves:over_turn",
        N_(
            "force, couple, rolling moment or inertia torque over the crank angle, by "
            "order and in total"
        ),
        "Signal",
    ),
    _chart(
        "amplitudes",
        "amplitude_curves:amplitudes",
        N_("force, pitch, yaw and rolling moment over the speed, by order and in total"),
    ),
    _chart(
        "spectrum", "spectra:spectrum", N_("peak force, couple and rolling moment of each order")
    ),
    _chart(
        "shaft",
        "elevations:shaft_elevation",
        N_("every shaft from the side, with its weights and arms"),
    ),
    _chart(
        "torque",
        "torque:torque_chart",
        N_("gas and inertia torque over a cycle: together, by cylinder, by load or by order"),
        "TorqueView",
    ),
    _chart(
        "pressure",
        "pressures:pressure_chart",
        N_("the pressure in the cylinders over their volume or over the crank angle"),
        "PressureView",
    ),
    _chart(
        "side-thrust",
        "side_thrusts:side_thrust_chart",
        N_("how hard the pistons press on their cylinder walls over a cycle"),
    ),
    _chart(
        "forces",
        "cylinder_forces:force_arrows",
        N_("the forces of each cylinder at chosen crank angles"),
    ),
    _chart(
        "balance-shafts",
        "balance_shafts:balance_shaft_chart",
        N_("the balance shafts in their places, with ratio, sense and unbalance"),
    ),
)
CHARTS = {figure.name: figure for figure in _FIGURES} | {
    chart.name: chart for record in analyses() for chart in record.charts
}
"""All figures of an engine, by name."""
_ANALYSES = {chart.name: record.name for record in analyses() for chart in record.charts}


def draw(name: str, engine: Engine | Sequence[Engine], **options: Any) -> Drawn:
    """The figure of a name. Raises ChartError, and PackageError where another package's fails.

    >>> from crankstar.files.catalog import load
    >>> type(draw("hodograph", load("single"))).__name__
    'Chart'
    """
    with added().running(_ANALYSES.get(name, "")):
        return CHARTS[name].draw(engine, **options)


def side_by_side(engines: Sequence[Engine], kind: str, **options: Any) -> Drawn:
    """Several engines in one figure on common axes, two in a row, each under its name.

    `kind` is one of hodograph, over-turn, spectrum, vector-star and polygon; `options` are those of
    this figure. Without a `speed` they are at `common_speed`. Raises ChartError, also where the
    engines are not counted in the same unit.
    """
    kinds = {name: figure for name, figure in CHARTS.items() if figure.compares}
    if kind not in kinds:
        raise ChartError(
            _(
                "{chart} cannot be drawn side by side; give one of {charts}",
                chart=repr(kind),
                charts=", ".join(kinds),
            )
        )
    if "speed" in kinds[kind].options and options.get("speed") is None:
        options["speed"] = common_speed(engines)
    return draw(kind, engines, **options)
