"""Remedies: what is put on an engine so that it shakes less. A remedy is an Engine again.

| module | one line |
|---|---|
| `shafts` | balance shafts: which an engine needs, what each takes away, where it must lie so that nothing rolls |
| `best` | the best weights in chosen planes, within limits, with a certificate |
| `programme` | the second-order cone programme behind them, and its lower bound |
| `aims` | what good weights make small: force, couple, pitch, yaw, bearing load; as numbers and as cones |
| `counterweights` | weights on the crankshafts from a balance factor: at the throws, on webs, in chosen planes |
| `planes` | where webs and main bearings are |
| `loads` | what each crank pin carries, rotating and reciprocating; bobweights |
"""

from crankstar.remedy.aims import Aim, Plane, unit_unbalance
from crankstar.remedy.best import Best, Limit, bearing_load, best_weights, said, without_weights
from crankstar.remedy.counterweights import RemedyError, with_counterweights, with_web_weights, without_counterweights
from crankstar.remedy.loads import Load, bobweight, loads
from crankstar.remedy.planes import end_planes, end_webs, main_bearings, webs
from crankstar.remedy.shafts import (
    GREATEST_RATIO,
    Need,
    needs,
    with_balance_shaft,
    with_balance_shafts,
    with_roll_cancelled,
    with_turning_cancelled,
)

__all__ = [
    "GREATEST_RATIO",
    "Aim",
    "Best",
    "Limit",
    "Load",
    "Need",
    "Plane",
    "RemedyError",
    "bearing_load",
    "best_weights",
    "bobweight",
    "end_planes",
    "end_webs",
    "loads",
    "main_bearings",
    "needs",
    "said",
    "unit_unbalance",
    "webs",
    "with_balance_shaft",
    "with_balance_shafts",
    "with_counterweights",
    "with_roll_cancelled",
    "with_turning_cancelled",
    "with_web_weights",
    "without_counterweights",
    "without_weights",
]
