"""The figures by name, as in `crankstar plot`."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from crankstar.charts.comparison import KINDS
from crankstar.charts.curves import over_turn
from crankstar.charts.cylinder_forces import force_arrows
from crankstar.charts.elevations import shaft_elevation
from crankstar.charts.firing_rings import firing_ring
from crankstar.charts.hodographs import hodograph
from crankstar.charts.polygons import polygon
from crankstar.charts.spectra import spectrum
from crankstar.charts.stars import crank_star, vector_star
from crankstar.charts.strokes import stroke_chart
from crankstar.language.messages import N_


@dataclass(frozen=True)
class Figure:
    """A figure: its function, a line about it, its options, and the values of `quantity`."""

    name: str
    draw: Callable[..., Any]
    about: str
    options: tuple[str, ...]
    quantities: tuple[str, ...] = ()

    @property
    def compares(self) -> bool:
        """Whether several engines can be drawn side by side."""
        return self.name in KINDS


VECTORS = ("force", "couple")
CHARTS: dict[str, Figure] = {
    figure.name: figure
    for figure in (
        Figure(
            "crank-star",
            crank_star,
            N_("the throws of the crankshafts, seen from the front"),
            ("theta",),
        ),
        Figure(
            "vector-star",
            vector_star,
            N_("the vectors of one order of every cylinder, throw and weight"),
            ("order", "quantity", "speed", "reference", "theta"),
            VECTORS,
        ),
        Figure(
            "polygon",
            polygon,
            N_("the vectors of one order head to tail, with their resultant"),
            ("order", "quantity", "speed", "reference", "theta"),
            VECTORS,
        ),
        Figure(
            "hodograph",
            hodograph,
            N_("the path of force or couple, of one order or of all"),
            ("order", "quantity", "speed", "reference", "theta"),
            VECTORS,
        ),
        Figure(
            "over-turn",
            over_turn,
            N_("force, couple, roll or torque over the crank angle, by order and in total"),
            ("orders", "quantity", "speed", "reference", "theta"),
            (*VECTORS, "roll", "torque"),
        ),
        Figure(
            "spectrum",
            spectrum,
            N_("peak force, couple and roll of each order"),
            ("speed", "reference"),
        ),
        Figure(
            "shaft",
            shaft_elevation,
            N_("every shaft from the side, with its weights and arms"),
            ("reference", "theta"),
        ),
        Figure(
            "stroke-chart",
            stroke_chart,
            N_("open valves and ignition of each cylinder over one cycle"),
            ("theta",),
        ),
        Figure(
            "firing-ring",
            firing_ring,
            N_("the cylinders round a circle at their firing angles"),
            ("theta",),
        ),
        Figure(
            "forces",
            force_arrows,
            N_("the forces of each cylinder at chosen crank angles"),
            ("angles", "orders"),
        ),
    )
}
"""All figures of an engine, by name."""
