"""The public names of the room, each loaded on first use: a figure needs few of them."""

import typing

from .amplitude_curves import amplitudes as amplitudes
from .balance_shafts import balance_shaft_chart as balance_shaft_chart
from .canvas import Canvas as Canvas, drawn_on as drawn_on
from .crank_stars import crank_star as crank_star
from .curve_names import names_of as names_of
from .curves import over_turn as over_turn
from .cylinder_forces import force_arrows as force_arrows
from .drawing import GREY as GREY, ChartError as ChartError, svg as svg
from .elevations import shaft_elevation as shaft_elevation
from .errata import judged as judged, over_rods as over_rods
from .estimates import over_ranges as over_ranges
from .fronts import pareto_front as pareto_front, sequence_chart as sequence_chart
from .hodographs import hodograph as hodograph
from .pair_sweeps import contours as contours
from .paper import Paper as Paper, Print as Print, printed as printed
from .pressures import pressure_chart as pressure_chart
from .registry import CHARTS as CHARTS, draw as draw, side_by_side as side_by_side
from .saving import SUFFIXES as SUFFIXES, saved as saved, saved_print as saved_print
from .search_stars import best_stars as best_stars
from .side_thrusts import side_thrust_chart as side_thrust_chart
from .spectra import spectrum as spectrum
from .sweeps import swept as swept
from .torque import torque_chart as torque_chart
from .torsion_fronts import sequence_stars as sequence_stars
from .vector_diagrams import Diagram as Diagram, Named as Named, polar_vectors as polar_vectors
from .vector_stars import polygon as polygon, vector_star as vector_star

def __getattr__(name: str) -> typing.Any:  # charts of analyses
    ...
