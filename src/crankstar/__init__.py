"""crankstar tells how a piston engine shakes, why, and what to do about it.

    Engine -> Motion -> Spectrum -> Balance -> Remedy / Views

An `Engine` is a frozen description in SI units. Pure functions turn it into the motion of its parts, the motion into one
spectrum of force, couple, roll and torque per part, and the sum of the parts into a `Balance`. Views only read. A thing is
a record, a way of looking at it is a function, an engine type is data, and imports point downward. Top to bottom:

| module | one line |
|---|---|
| `cli/` | verbs only; no logic |
| `server/` | the local server: engines analysed as they are edited, over HTTP |
| `request` | what the words of a command line ask for |
| `chart_request` | which figure, with which options, written as what |
| `search_request`, `star_request` | which search, of which crank stars, judged by what |
| `search_job` | a search as the command line runs it: estimated, on so many workers, its progress told |
| `output` | where results go: terminal, pipe, or a file that appears whole or not at all |
| `notebook` | the page as a widget in a notebook |
| `page` | the page as one file that needs no network |
| `report/` | the report as one HTML file without a script, and as a PDF |
| `views` | an engine from the front, the side and above as still drawings |
| `exhibit/` | what the page shows of an engine, as records that are sent to it |
| `tables`, `description` | a Balance, an Engine as tables for the terminal and the notebook |
| `charts/` | figures as Altair charts, one function each, and as SVG without a browser |
| `verdict` | the facts a Balance shows, as short sentences with their numbers |
| `stroke_table` | strokes, valve events, exhaust intervals and disturbances as tables for the terminal |
| `search_table` | what a search found as a table, in sentences, as CSV, JSON and Parquet |
| `uneven_table` | uneven angles of a star: what they bring in couples and cost in free forces |
| `sweep_table` | a sweep as a table, its curves in a line, its best value in words |
| `order_tables`, `vee_tables` | firing orders and V engines that were found, as tables, CSV and JSON |
| `misprints` | the errata of the sources as tables for the terminal |
| `workshop` | the bobweight card, counterweights, balance shafts and what they leave, as tables |
| `wording` | numbers, amplitudes, paths and firing orders as an engineer writes them |
| `fitting` | an engine fitted with weights and balance shafts, in the order in which it is done |
| `errata/` | what the sources got wrong: printed, true, and momentum as the judge |
| `sweep` | what becomes of a force when a number of the engine file is varied; the best value |
| `fields` | numbers of an engine file by their key path, and the engine as a function of one |
| `variants` | many variants of an engine at once, as arrays |
| `search/` | the inverse problem: crank stars and firing orders searched to the end, with proof |
| `derive/` | exact closed forms and their derivation step by step, zeros proved; families, the six signs of balance |
| `answer` | the machine-readable answer: the public JSON object, CSV |
| `catalog/` | engines as TOML, one file each, each number with its source |
| `files/` | Engine <-> TOML/JSON, JSON Schema, a sentence for every mistake, starter files |
| `units` | text <-> SI; the only user of pint |
| `remedy/` | what is put on an engine so that it shakes less: counterweights, balance shafts; gives Engines back |
| `whirl` | how the rigid engine moves if nothing holds it |
| `balance` | Engine -> Balance: what every part does to the block, by cylinder, bank, shaft, in all; units |
| `mechanism` | an engine, or a batch, as arrays; the laws of force, couple, roll and torque, and their spectra |
| `strokes` | the strokes of each cylinder, valve and port events, exhausts that meet and disturb each other |
| `succession` | who fires after whom: intervals in a group, neighbours, partners on a pin |
| `firing` | top and bottom dead centres, firing angles and intervals; orders that do not fit |
| `layouts` | inline, vee, boxer, tandem, opposed, radial: functions that write Engines |
| `arrangement` | cylinders put on pins, and what a short file says of all of them, to an Engine |
| `motion` | exact motion of pins, rods and pistons, its harmonics; the series in lambda beside them |
| `engine` | the Engine: shafts and cylinders together, and what they must be to make one |
| `valves` | when valves or ports open and close: given, assumed, impossible |
| `records` | frozen records: Shaft, Throw, Weight, Cylinder, Rod, Valves, Provenance |
| `interrupts` | interrupts from the keyboard, kept from processes that are started |
| `fault` | what is wrong with an engine: each fault with its place, and the words to say it in |
| `quantity` | what a number or text in a record is: dimension, unit of example, limits |
| `phasor` | spectra over crank order: add, shift, scale, evaluate, ellipse, peak |

>>> import crankstar
>>> engine = crankstar.load("v8-flat-plane")
>>> crankstar.total(crankstar.balance(engine)).force.orders[:2].tolist()
[1.0, 2.0]
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

from crankstar.balance import Balance, balance, grouped, of_parts, total
from crankstar.engine import Engine
from crankstar.fault import EngineError
from crankstar.mechanism import Mechanism, Reference, Totals
from crankstar.records import Cylinder, Rod, Shaft, Throw, Weight

if TYPE_CHECKING:
    from crankstar.catalog import load, names
    from crankstar.derive import derivation, family, signs
    from crankstar.files import EngineFileError
    from crankstar.notebook import widget

__version__ = "0.1.0"

__all__ = [
    "Balance",
    "Cylinder",
    "Engine",
    "EngineError",
    "EngineFileError",
    "Mechanism",
    "Reference",
    "Rod",
    "Shaft",
    "Throw",
    "Totals",
    "Weight",
    "balance",
    "derivation",
    "family",
    "grouped",
    "load",
    "names",
    "of_parts",
    "signs",
    "total",
    "widget",
]


_LATE = {
    "load": "crankstar.catalog",
    "names": "crankstar.catalog",
    "EngineFileError": "crankstar.files",
    "derivation": "crankstar.derive",
    "family": "crankstar.derive",
    "signs": "crankstar.derive",
    "widget": "crankstar.notebook",
}


def __getattr__(name: str) -> Any:
    """What reads files is loaded when it is first asked for, so that `import crankstar` is numpy and pydantic only."""
    if name not in _LATE:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(_LATE[name]), name)
