"""The figures by name, as in `crankstar plot`."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, get_args

from crankstar.charts.amplitudes import amplitudes
from crankstar.charts.balance_shafts import balance_shaft_chart
from crankstar.charts.bending import bending_chart
from crankstar.charts.campbell import campbell
from crankstar.charts.crank_stars import crank_star
from crankstar.charts.curves import over_turn
from crankstar.charts.cylinder_forces import force_arrows
from crankstar.charts.drawing import ChartError
from crankstar.charts.elevations import shaft_elevation
from crankstar.charts.exhaust_orders import exhaust_order_chart
from crankstar.charts.firing_rings import firing_ring
from crankstar.charts.grammar import Chart
from crankstar.charts.hodographs import hodograph
from crankstar.charts.mode_shapes import mode_shapes
from crankstar.charts.polar_loads import Loaded, polar_loads
from crankstar.charts.pressures import PressureView, pressure_chart
from crankstar.charts.side_thrusts import side_thrust_chart
from crankstar.charts.spectra import spectrum
from crankstar.charts.strokes import stroke_chart
from crankstar.charts.sums import Quantity, Signal
from crankstar.charts.torque import TorqueView, torque_chart
from crankstar.charts.torsion_responses import TorsionView, torsion_response_chart
from crankstar.charts.torsion_stars import TorsionMode, torsion_star
from crankstar.charts.vector_stars import polygon, vector_star
from crankstar.engine.engine import Engine
from crankstar.language.messages import N_, _


@dataclass(frozen=True)
class Figure:
    """A figure: its function, a line about it, and the values of `quantity`."""

    name: str
    draw: Callable[..., Chart]
    about: str
    quantities: tuple[str, ...] = ()

    @property
    def options(self) -> tuple[str, ...]:
        """The options of its function."""
        return tuple(self.draw.__kwdefaults__ or ())

    @property
    def compares(self) -> bool:
        """Whether several engines can be drawn side by side."""
        return self.draw.__annotations__.get("engine") == "Engines"

    @property
    def of_chains(self) -> bool:
        """Whether it also draws a drive line without cylinders."""
        return "source" in self.draw.__annotations__


_FIGURES = (
    Figure("crank-star", crank_star, N_("the throws of the crankshafts, seen from the front")),
    Figure(
        "vector-star",
        vector_star,
        N_("the vectors of one order of every cylinder, throw and weight"),
        get_args(Quantity),
    ),
    Figure(
        "polygon",
        polygon,
        N_("the vectors of one order head to tail, with their resultant"),
        get_args(Quantity),
    ),
    Figure(
        "hodograph",
        hodograph,
        N_("the path of force or couple, of one order or of all"),
        get_args(Quantity),
    ),
    Figure(
        "over-turn",
        over_turn,
        N_(
            "force, couple, rolling moment or inertia torque over the crank angle, by "
            "order and in total"
        ),
        get_args(Signal),
    ),
    Figure(
        "amplitudes",
        amplitudes,
        N_("force, pitch, yaw and rolling moment over the speed, by order and in total"),
    ),
    Figure("spectrum", spectrum, N_("peak force, couple and rolling moment of each order")),
    Figure("shaft", shaft_elevation, N_("every shaft from the side, with its weights and arms")),
    Figure(
        "stroke-chart", stroke_chart, N_("open valves and ignition of each cylinder over one cycle")
    ),
    Figure("firing-ring", firing_ring, N_("the cylinders around a circle at their firing angles")),
    Figure(
        "exhaust-orders",
        exhaust_order_chart,
        N_("the orders of the exhaust pulses of each bank or manifold"),
    ),
    Figure(
        "torque",
        torque_chart,
        N_("gas and inertia torque over a cycle: together, by cylinder, by load or by order"),
        get_args(TorqueView),
    ),
    Figure(
        "pressure",
        pressure_chart,
        N_("the pressure in the cylinders over their volume or over the crank angle"),
        get_args(PressureView),
    ),
    Figure(
        "side-thrust",
        side_thrust_chart,
        N_("how hard the pistons press on their cylinder walls over a cycle"),
    ),
    Figure("forces", force_arrows, N_("the forces of each cylinder at chosen crank angles")),
    Figure(
        "bearing-loads",
        polar_loads,
        N_("the load on each main bearing or crank pin over a turn, as a polar diagram"),
        get_args(Loaded),
    ),
    Figure(
        "bending",
        bending_chart,
        N_("the bending moment along the crankshaft, with counterweights and without"),
    ),
    Figure(
        "balance-shafts",
        balance_shaft_chart,
        N_("the balance shafts in their places, with ratio, sense and unbalance"),
    ),
    Figure(
        "torsion-modes",
        mode_shapes,
        N_("how far each mass turns in the first torsional modes, with their nodes"),
    ),
    Figure(
        "campbell",
        campbell,
        N_("torsional frequencies and orders over the speed, and where they meet"),
    ),
    Figure(
        "torsion-response",
        torsion_response_chart,
        N_("torsional vibration over the speed, by order and of all: free end, stress or torque"),
        get_args(TorsionView),
    ),
    Figure(
        "torsion-star",
        torsion_star,
        N_("the vectors of the cylinders of orders in a torsional mode, with their sum"),
        get_args(TorsionMode),
    ),
)
CHARTS = {figure.name: figure for figure in _FIGURES}
"""All figures of an engine, by name."""


def side_by_side(engines: Sequence[Engine], kind: str, **options: Any) -> Chart:
    """Several engines in one figure on common axes, two in a row, each under its name.

    `kind` is one of hodograph, over-turn, spectrum, vector-star and polygon; `options` are those of
    this figure. Raises ChartError, also where the engines are not counted in the same unit.
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
    return kinds[kind].draw(engines, **options)
