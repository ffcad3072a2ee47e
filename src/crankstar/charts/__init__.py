"""Figures, one function each, as Vega-Lite.

Engines in, a chart out, and a chart as an SVG that needs no browser.

`CHARTS` has the figures of engines by name.

| module, bottom to top | one line |
|---|---|
| `letters` | how wide letters are, texts in lines |
| `canvas` | the room for a figure |
| `converter` | vl-convert, here or in a process beside this one |
| `estimates` | the ranges of estimated engines, and the line that marks their figures |
| `labels` | where labels stand, and their leaders |
| `fonts` | free fonts for Japanese and Cyrillic letters |
| `grammar` | Vega-Lite as plain data |
| `resting` | what the numbers of a figure rest on, in a line below it |
| `drawing` | colours, panels, the crank angle as a parameter |
| `crank_angle` | the axis of the crank angle, and the rule at `theta` |
| `comparison` | one engine, or several side by side on common axes |
| `sums` | what remains of force, couple, rolling moment and torque |
| `choices` | the quantity and the order of a figure where none is named |
| `plane` | the clock plane as a picture with equal scales |
| `vector_panels` | the vectors of cylinders and their sum as a panel |
| `themes` | the colours of light and dark screens and of paper |
| `paper` | a chart at a stated size, with letters of a stated size |
| `saving` | a chart as SVG, PNG, PDF, HTML or JSON |
| `vectors` | the vectors of one order, as numbers |
| `crank_stars` | the throws of the crankshafts from the front |
| `vector_stars` | the vectors of one order as a star and as a polygon |
| `hodographs` | the path of force or couple |
| `curves` | force, couple, rolling moment and torque over the crank angle |
| `spectra` | the size of each order |
| `gas_curves` | curves over a working cycle, and what a figure of gas says |
| `pressures` | the pressure over volume or crank angle |
| `torque` | gas and inertia torque over a cycle, by cylinder, load and order |
| `side_thrusts` | the side thrust of the pistons |
| `elevations` | the crankshaft from the side |
| `cylinder_forces` | the forces on each cylinder at chosen crank angles |
| `polar_grid` | the circles of a polar diagram, with their values |
| `vector_diagrams` | vectors of several kinds in polar diagrams to one scale |
| `balance_shafts` | the balance shafts from the front and from the side |
| `curve_names` | the results of a sweep in the words of the field |
| `sweeps` | a result over a number of the engine |
| `contour_lines` | lines along which a result has one value, with their labels |
| `pair_sweeps` | results over two numbers of the engine, and the front of two results |
| `amplitude_curves` | amplitudes over the speed |
| `errata` | a printed formula beside the true one |
| `front_axes` | the axes of a front, straight or logarithmic |
| `search_values` | the values and firing orders of found stars as text |
| `front_numbers` | the numbers of the points of a front |
| `front_keys` | the key of a front as a table |
| `fronts` | the Pareto front of a search: the trade between two objectives |
| `search_stars` | the best stars of a search side by side |
| `torsion_fronts` | points of a front over stars and firing orders, with stars of torsion |
| `registry` | the figures by the names under which the command line knows them |

What depends on the crank angle has one parameter, `theta`, in degrees: a slider in HTML and in a
notebook. Altair, which shows a chart in a notebook, and vl-convert, which draws it, are loaded when
they are needed; they come with `pip install "crankstar[charts]"`.
"""

from importlib import import_module
from typing import Any

from crankstar.engine.arguments import late

_own, _, __all__ = late(__name__, __file__)


def __getattr__(name: str) -> Any:
    """A name of the room, or the function of a chart that an analysis has, on first use."""
    for path in () if name in __all__ else _of_analyses():
        module, _colon, function = path.partition(":")
        if function == name:
            globals()[name] = getattr(import_module(module), name)
            import_module("crankstar.engine.arguments").of_engines(globals(), [name])
            return globals()[name]
    return _own(name)


def __dir__() -> list[str]:
    """Names for completion, those not yet loaded included."""
    return sorted({*globals(), *__all__, *(path.partition(":")[2] for path in _of_analyses())})


def _of_analyses() -> list[str]:
    """The functions of the charts that analyses have: module and name."""
    from crankstar.analysis.registry import analyses

    return [chart.path for record in analyses() for chart in record.charts]
