"""The figures by the names under which the command line and the documents know them."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from crankstar.charts.comparison import KINDS
from crankstar.charts.elevations import shaft_elevation
from crankstar.charts.hodographs import hodograph
from crankstar.charts.polygons import polygon
from crankstar.charts.pushes import force_arrows
from crankstar.charts.rings import firing_ring
from crankstar.charts.spectra import spectrum
from crankstar.charts.stars import crank_star, vector_star
from crankstar.charts.strokes import stroke_chart
from crankstar.charts.turns import over_turn


@dataclass(frozen=True)
class Figure:
    """A figure: the function that draws it, one line on what it shows, and the options it takes by keyword.

    `quantities` are the values of its option `quantity`; `compares` tells whether `side_by_side` can draw it.
    """

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
        Figure("crank-star", crank_star, "the throws of the crankshafts seen from the front", ("theta",)),
        Figure(
            "vector-star",
            vector_star,
            "the vectors of one order, one for each cylinder, throw and weight",
            ("order", "quantity", "speed", "reference", "theta"),
            VECTORS,
        ),
        Figure(
            "polygon",
            polygon,
            "the vectors of one order head to tail, closed or with their resultant",
            ("order", "quantity", "speed", "reference", "theta"),
            VECTORS,
        ),
        Figure(
            "hodograph",
            hodograph,
            "the path that force or couple runs through, of one order or of all",
            ("order", "quantity", "speed", "reference", "theta"),
            VECTORS,
        ),
        Figure(
            "over-turn",
            over_turn,
            "force, couple, roll or torque over the crank angle, by order and in all",
            ("orders", "quantity", "speed", "reference", "theta"),
            (*VECTORS, "roll", "torque"),
        ),
        Figure("spectrum", spectrum, "how great force, couple and roll of each order become", ("speed", "reference")),
        Figure("shaft", shaft_elevation, "every shaft from the side, with its weights and arms", ("reference", "theta")),
        Figure("stroke-chart", stroke_chart, "when the valves of each cylinder are open, and when it fires", ("theta",)),
        Figure("firing-ring", firing_ring, "the cylinders round a circle at their firing angles", ("theta",)),
        Figure("forces", force_arrows, "the forces on each cylinder at chosen crank angles", ("angles", "orders")),
    )
}
"""All figures of an engine, by name."""
