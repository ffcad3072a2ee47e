"""Remedies: weights and balance shafts that make an engine shake less. A remedy gives an Engine.

| module, bottom to top | one line |
|---|---|
| `loads` | the rotating and reciprocating masses on each crank pin; bobweights |
| `kept` | the weights that crankshafts have: what they leave to new ones; taken away again |
| `counterweights` | weights from a balance factor: at the throws, on webs, in given planes |
| `rolling` | the roll of the block, and what a turning force adds to it from its place |
| `drilling` | holes to drill, slugs of heavy metal to fit, heavy spots of a crankshaft |
| `programme` | the second-order cone programme behind the best weights, and its lower bound |
| `aims` | force, couple, pitch, yaw, roll, bearing load to minimise; as numbers and as cones |
| `aim_names` | aims in words, and their units |
| `best` | the best weights in given planes, within limits, with a certificate |
| `clear_places` | the nearest place of a box outside of circles |
| `clearance` | what cranks and balance shafts sweep, and which are inside each other |
| `placing` | where balance shafts must lie so that the block rolls least |
| `shafts` | balance shafts that an engine needs, and the place of a pair without roll |
| `end_weights` | weights at the ends that share the first-order moment between its planes |
| `sizing` | a remedy sized for other masses, its weights and shafts where they are |
| `fitting` | an engine fitted with all of these; the cure that its verdict recommends |
"""

from crankstar.engine.arguments import of_engines
from crankstar.engine.main_bearings import end_planes, end_webs, main_bearings, webs
from crankstar.remedy.aim_names import aim_name, aim_text, aim_unit
from crankstar.remedy.aims import Aim, Plane, bearing_load
from crankstar.remedy.best import Best, Limit, best_weights, without_weights
from crankstar.remedy.clear_places import Box
from crankstar.remedy.clearance import Clash, balance_shafts, clashes, crank_sweep
from crankstar.remedy.counterweights import (
    RemedyError,
    with_counterweights,
    with_web_weights,
    without_counterweights,
)
from crankstar.remedy.kept import changes, without_added
from crankstar.remedy.loads import Load, bobweight, loads
from crankstar.remedy.placing import Placing, placed, roll_reference
from crankstar.remedy.shafts import (
    GREATEST_RATIO,
    Need,
    needs,
    with_balance_shaft,
    with_roll_cancelled,
    with_turning_cancelled,
)

__all__ = [
    "GREATEST_RATIO",
    "Aim",
    "Best",
    "Box",
    "Clash",
    "Limit",
    "Load",
    "Need",
    "Placing",
    "Plane",
    "RemedyError",
    "aim_name",
    "aim_text",
    "aim_unit",
    "balance_shafts",
    "bearing_load",
    "best_weights",
    "bobweight",
    "changes",
    "clashes",
    "crank_sweep",
    "end_planes",
    "end_webs",
    "loads",
    "main_bearings",
    "needs",
    "placed",
    "roll_reference",
    "webs",
    "with_balance_shaft",
    "with_counterweights",
    "with_roll_cancelled",
    "with_turning_cancelled",
    "with_web_weights",
    "without_added",
    "without_counterweights",
    "without_weights",
]

of_engines(globals(), __all__)
