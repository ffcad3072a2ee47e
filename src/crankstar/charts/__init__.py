"""Figures, one function each, made with Altair: engines in, a chart out, and a chart as an SVG that needs no browser.

Figures of engines, by the names in `CHARTS`:

| module | one line |
|---|---|
| `registry` | the figures by the names under which the command line knows them |
| `winners` | the best stars of a search side by side |
| `fronts` | the Pareto front of a search: what one objective costs in the other |
| `sweeps` | what becomes of a force when a number of the engine is varied |
| `comparison` | several engines side by side on common axes |
| `pushes` | the forces on each cylinder at chosen crank angles |
| `elevations` | the crankshaft from the side |
| `rings` | the cylinders round a circle at their firing angles |
| `strokes` | when valves are open, and when each cylinder fires |
| `spectra` | how great each order becomes |
| `turns` | force, couple, roll and torque over the crank angle |
| `hodographs` | the path of force or couple |
| `polygons` | force and moment polygons |
| `stars` | the crank star, and the star of the vectors of an order |
| `vectors` | the vectors of one order, as numbers |
| `plane` | the clock plane as a picture with equal scales |
| `labels` | where labels stand |
| `saving` | a chart as SVG, PNG, PDF, HTML or JSON |
| `compared` | a printed formula beside the true one |
| `drawing` | colours, text, the crank angle as a parameter |

What depends on the crank angle has one parameter, `theta`, in degrees: a slider in HTML and in a notebook. Altair and
vl-convert are loaded when a figure is asked for; they come with `pip install "crankstar[charts]"`.
"""

from crankstar.charts.compared import judged, over_rods
from crankstar.charts.comparison import side_by_side
from crankstar.charts.drawing import GREY, ChartError, svg, swiftly
from crankstar.charts.elevations import shaft_elevation
from crankstar.charts.fronts import pareto_front
from crankstar.charts.hodographs import hodograph
from crankstar.charts.polygons import polygon
from crankstar.charts.pushes import force_arrows
from crankstar.charts.registry import CHARTS, Figure
from crankstar.charts.rings import firing_ring
from crankstar.charts.saving import SUFFIXES, saved
from crankstar.charts.spectra import spectrum
from crankstar.charts.stars import crank_star, vector_star
from crankstar.charts.strokes import stroke_chart
from crankstar.charts.sweeps import swept
from crankstar.charts.turns import over_turn
from crankstar.charts.winners import best_stars

__all__ = [
    "CHARTS",
    "GREY",
    "SUFFIXES",
    "ChartError",
    "Figure",
    "best_stars",
    "crank_star",
    "firing_ring",
    "force_arrows",
    "hodograph",
    "judged",
    "over_rods",
    "over_turn",
    "pareto_front",
    "polygon",
    "saved",
    "shaft_elevation",
    "side_by_side",
    "spectrum",
    "stroke_chart",
    "svg",
    "swept",
    "swiftly",
    "vector_star",
]
