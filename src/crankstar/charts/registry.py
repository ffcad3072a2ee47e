"""The figures by name, as in `crankstar plot`."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property
from importlib import import_module
from math import pi
from types import ModuleType
from typing import Any, get_args

from crankstar.charts.drawing import ChartError
from crankstar.charts.grammar import Chart
from crankstar.engine.engine import Engine
from crankstar.language.messages import N_, _

USUAL_SPEED = 1000 * pi / 30
"""rad/s: of engines that are compared, where no file gives a speed."""


@dataclass(frozen=True)
class Figure:
    """A figure: the module and name of its function, a line about it, the type of `quantity`."""

    name: str
    place: str
    about: str
    kind: str = ""

    @cached_property
    def _module(self) -> ModuleType:
        return import_module(f"crankstar.charts.{self.place.partition(':')[0]}")

    @property
    def draw(self) -> Callable[..., Chart]:
        """Its function, loaded on first use."""
        return getattr(self._module, self.place.partition(":")[2])

    @property
    def quantities(self) -> tuple[str, ...]:
        """The values of `quantity`."""
        return get_args(getattr(self._module, self.kind)) if self.kind else ()

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
    Figure(
        "crank-star",
        "crank_stars:crank_star",
        N_("the throws of the crankshafts, seen from the front"),
    ),
    Figure(
        "vector-star",
        "vector_stars:vector_star",
        N_("the vectors of one order of every cylinder, throw and weight"),
        "Quantity",
    ),
    Figure(
        "polygon",
        "vector_stars:polygon",
        N_("the vectors of one order head to tail, with their resultant"),
        "Quantity",
    ),
    Figure(
        "hodograph",
        "hodographs:hodograph",
        N_("the path of force or couple, of one order or of all"),
        "Quantity",
    ),
    Figure(
        "over-turn",
        "curves:over_turn",
        N_(
            "force, couple, rolling moment or inertia torque over the crank angle, by "
            "order and in total"
        ),
        "Signal",
    ),
    Figure(
        "amplitudes",
        "amplitude_curves:amplitudes",
        N_("force, pitch, yaw and rolling moment over the speed, by order and in total"),
    ),
    Figure(
        "spectrum", "spectra:spectrum", N_("peak force, couple and rolling moment of each order")
    ),
    Figure(
        "shaft",
        "elevations:shaft_elevation",
        N_("every shaft from the side, with its weights and arms"),
    ),
    Figure(
        "stroke-chart",
        "strokes:stroke_chart",
        N_("open valves and ignition of each cylinder over one cycle"),
    ),
    Figure(
        "firing-ring",
        "firing_rings:firing_ring",
        N_("the cylinders around a circle at their firing angles"),
    ),
    Figure(
        "exhaust-orders",
        "exhaust_orders:exhaust_order_chart",
        N_("the orders of the exhaust pulses of each bank or manifold"),
    ),
    Figure(
        "torque",
        "torque:torque_chart",
        N_("gas and inertia torque over a cycle: together, by cylinder, by load or by order"),
        "TorqueView",
    ),
    Figure(
        "pressure",
        "pressures:pressure_chart",
        N_("the pressure in the cylinders over their volume or over the crank angle"),
        "PressureView",
    ),
    Figure(
        "side-thrust",
        "side_thrusts:side_thrust_chart",
        N_("how hard the pistons press on their cylinder walls over a cycle"),
    ),
    Figure(
        "guide-moments",
        "guide_moment_bars:guide_moment_chart",
        N_("guide-force moments of each order: H, which sways all heads, and X, which twists"),
    ),
    Figure(
        "forces",
        "cylinder_forces:force_arrows",
        N_("the forces of each cylinder at chosen crank angles"),
    ),
    Figure(
        "bearing-loads",
        "polar_diagrams:polar_loads",
        N_("the load on each main bearing or crank pin over a turn, as a polar diagram"),
        "Loaded",
    ),
    Figure(
        "bending",
        "bending:bending_chart",
        N_("the bending moment along the crankshaft, with counterweights and without"),
    ),
    Figure(
        "balance-shafts",
        "balance_shafts:balance_shaft_chart",
        N_("the balance shafts in their places, with ratio, sense and unbalance"),
    ),
    Figure(
        "torsion-modes",
        "modes:mode_shapes",
        N_("how far each mass turns in the first torsional modes, with their nodes"),
    ),
    Figure(
        "campbell",
        "campbell_diagrams:campbell",
        N_("torsional frequencies and orders over the speed, and where they meet"),
    ),
    Figure(
        "torsion-response",
        "torsion_responses:torsion_response_chart",
        N_("torsional vibration over the speed, by order and of all: free end, stress or torque"),
        "TorsionView",
    ),
    Figure(
        "torsion-star",
        "torsion_stars:torsion_star",
        N_("the vectors of the cylinders of orders in a torsional mode, with their sum"),
        "TorsionMode",
    ),
    Figure(
        "mount-layout",
        "mount_layouts:mount_layout_chart",
        N_("the mounts from the front, from above and from the side, with centre of mass and axes"),
    ),
    Figure(
        "mount-modes",
        "mount_modes:mount_mode_chart",
        N_("the natural modes on the mounts, with the share of each freedom in their energy"),
    ),
    Figure(
        "mount-response",
        "mount_responses:mount_response_chart",
        N_("vibration on the mounts over the speed, by order and of all: a point, or the forces"),
        "MountView",
    ),
    Figure(
        "transmissibility",
        "mount_responses:transmissibility_chart",
        N_("how much of what shakes the engine goes through each mount, over the speed"),
    ),
)
CHARTS = {figure.name: figure for figure in _FIGURES}
"""All figures of an engine, by name."""


def side_by_side(engines: Sequence[Engine], kind: str, **options: Any) -> Chart:
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
    return kinds[kind].draw(engines, **options)


def common_speed(engines: Sequence[Engine]) -> float | None:
    """The one speed (rad/s) at which engines are compared in N: the least that their files give.

    At USUAL_SPEED where none has one: the ratio of inertia forces is that of any speed. None where
    a mass or length is not known, so that each is in its own m r w^2.

    >>> from crankstar.files.catalog import load
    >>> common_speed([load("i4"), load("i6")]) is None
    True
    """
    if any(engine.relative for engine in engines):
        return None
    known = [engine.speed for engine in engines if engine.speed is not None]
    return min(known, default=USUAL_SPEED)
