"""crankstar computes how a piston engine shakes, why, and what to do about it.

    Engine -> Motion -> Excitation -> Response -> Verdict

An `Engine` is a frozen description in SI units, always valid. Pure functions give the motion of its
parts, the force, couple, moment and torque of each part as a spectrum over crank order, their sum
as a `Balance`, and a verdict on what remains and what would cure it. A remedy returns an Engine;
views only read. A thing is a record, a way of looking at it is a function, an engine type is data.
Rooms, top to bottom; a room imports only from rooms below it, and lists its modules itself:

| room | contents |
|---|---|
| `cli/` | the commands of the command line and their options; no logic |
| `server/` | that page live on this machine, over HTTP |
| `site/` | the whole catalog as pages for any web host |
| `report/` | one document with tables and figures, for print |
| `exports/` | an engine for other tools: EXUDYN, glTF, STL |
| `pictures/` | the engine itself, drawn at a crank angle or as a film |
| `page/` | the page on which the engine turns: its data, one file, the notebook widget |
| `python/` | a function for each analysis, and results that are frames and figures |
| `analyses/` | a folder each: what is asked, what computes it, its tables, figures, sentences |
| `options/` | what is typed in a command line or a dialog, read as checked values |
| `charts/` | figures of any engine, one function each; those of one analysis are in its folder |
| `tables/` | how tables are printed: terminal, HTML, CSV, JSON; those of forces, sweeps, searches |
| `studies/` | the same analysis over many values or engines: sweeps, batches, tolerances |
| `stars/` | crank stars, and nothing else, searched to the end with proof; executors |
| `derive/` | exact closed forms step by step; their `algebra/`; `errata/` of published formulas |
| `analysis/` | the record of an analysis, its document, what it rests on, all of them by name |
| `remedy/` | what is sized so that it shakes less: weights, shafts, mounts; gives an Engine |
| `files/` | outside data to Engine and back: TOML, JSON, text with units; starters, the catalog |
| `dynamics/` | what the excitation does: block, mounts, uneven running, bearings and oil, twist |
| `mechanics/` | excitation by cause: inertia, gas; what counts as zero; values that are doubtful |
| `firing/` | firing orders and intervals, given or found; strokes, exhaust; V engines |
| `engine/` | records, what makes them valid, quantities, layouts, motion, changed copies |
| `spectra/` | sums over crank order: add, shift, scale, evaluate, ellipse, peak |
| `language/` | wording: numbers as text, units and their factors, messages, sentences of faults |

>>> import crankstar
>>> engine = crankstar.load("v8-flat-plane")
>>> crankstar.total(crankstar.balance(engine)).force.orders[:2].tolist()
[1.0, 2.0]
"""

import sys

# nothing is read from a file here that Python has not read itself: until the command line runs, an
# interrupt would be a traceback
TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from crankstar.dynamics.bearings import BearingLoads, Bending
    from crankstar.dynamics.uneven import Running
    from crankstar.engine.engine import Engine
    from crankstar.engine.records import Cylinder, Rod, Shaft, Throw, Weight
    from crankstar.files import EngineFileError
    from crankstar.language.faults import EngineError
    from crankstar.language.messages import MessageError
    from crankstar.mechanics.balance import Balance
    from crankstar.mechanics.excitation import Reference, Totals
    from crankstar.mechanics.gas import Cycle
    from crankstar.mechanics.gas_torque import GasTorque
    from crankstar.mechanics.mechanism import Mechanism
    from crankstar.mechanics.side_thrust import SideThrust
    from crankstar.python import records as records
    from crankstar.python.analyses import (
        bearings,
        bobweight,
        correct,
        diagnose,
        drill,
        errata,
        fault,
        genset,
        grade,
        guide,
        isolate,
        marine,
        match,
        mounts,
        orders,
        strokes,
        tolerance,
        torque,
        torsion,
        vees,
        verdict,
    )
    from crankstar.python.public import (
        balance,
        bearing_loads,
        bending_moment,
        compare,
        cycle,
        derivation,
        driven,
        family,
        flywheel_for,
        gas_torque,
        grouped,
        load,
        names,
        of_parts,
        search,
        side_thrust,
        signs,
        sweep,
        total,
        watched,
        whirl,
        widget,
        with_balance_shaft,
        with_counterweights,
    )
    from crankstar.python.results import Result
    from crankstar.python.searches import Found

__version__ = "0.1.0"

_HOMES = {
    "dynamics.bearings": ("BearingLoads", "Bending"),
    "dynamics.uneven": ("Running",),
    "engine.engine": ("Engine",),
    "engine.records": ("Cylinder", "Rod", "Shaft", "Throw", "Weight"),
    "files": ("EngineFileError",),
    "language.faults": ("EngineError",),
    "language.messages": ("MessageError",),
    "mechanics.balance": ("Balance",),
    "mechanics.excitation": ("Reference", "Totals"),
    "mechanics.gas": ("Cycle",),
    "mechanics.gas_torque": ("GasTorque",),
    "mechanics.mechanism": ("Mechanism",),
    "mechanics.side_thrust": ("SideThrust",),
    "python.results": ("Result",),
    "python.searches": ("Found",),
}
"""The module of each public name. All are loaded on first use: a command line that is interrupted
while numpy is being loaded ends quietly, since it is running before."""

_MODULES = {"charts": "charts", "records": "python.records", "spectra": "spectra"}
"""Modules that are public under a name of their own, loaded on first use."""

__all__ = [
    "Balance",
    "BearingLoads",
    "Bending",
    "Cycle",
    "Cylinder",
    "Engine",
    "EngineError",
    "EngineFileError",
    "Found",
    "GasTorque",
    "Mechanism",
    "MessageError",
    "Reference",
    "Result",
    "Rod",
    "Running",
    "Shaft",
    "SideThrust",
    "Throw",
    "Totals",
    "Weight",
    "balance",
    "bearing_loads",
    "bearings",
    "bending_moment",
    "bobweight",
    "compare",
    "correct",
    "cycle",
    "derivation",
    "diagnose",
    "drill",
    "driven",
    "errata",
    "family",
    "fault",
    "flywheel_for",
    "gas_torque",
    "genset",
    "grade",
    "grouped",
    "guide",
    "isolate",
    "load",
    "marine",
    "match",
    "mounts",
    "names",
    "of_parts",
    "orders",
    "search",
    "side_thrust",
    "signs",
    "strokes",
    "sweep",
    "tolerance",
    "torque",
    "torsion",
    "total",
    "vees",
    "verdict",
    "watched",
    "whirl",
    "widget",
    "with_balance_shaft",
    "with_counterweights",
]


def __getattr__(name: str) -> "Any":
    """Load a public name on first use; an analysis of any package is a function of its name."""
    from importlib import import_module

    for module, classes in _HOMES.items():
        if name in classes:
            globals()[name] = value = getattr(import_module(f"crankstar.{module}"), name)
            return value
    if name in _MODULES:
        return import_module(f"crankstar.{_MODULES[name]}")
    if name in __all__:
        public = import_module("crankstar.python.public")
        if name in public.NAMES:
            globals()[name] = value = getattr(public, name)
            return value
    if not name.startswith("_"):
        from crankstar.engine.packages import PackageError
        from crankstar.python.functions import function

        try:
            globals()[name] = value = function(name)
        except KeyError:
            pass
        except PackageError as error:
            raise AttributeError(str(error)) from None
        else:
            return value
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def __dir__() -> list[str]:
    """Names for completion, those not yet loaded included."""
    return sorted({*globals(), *__all__, *_MODULES})


def _registered_in_notebook() -> None:
    """Have a running IPython show engines and balances as tables."""
    shell = sys.modules["IPython"].get_ipython() if "IPython" in sys.modules else None
    if shell is not None:
        from crankstar.tables.notebook import register

        register(shell)


_registered_in_notebook()
