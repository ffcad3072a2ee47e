"""Remedies: what is put on an engine so that it shakes less. A remedy is an Engine again.

| module | one line |
|---|---|
| `shafts` | balance shafts, each of which takes away the vector that turns at its speed |
| `counterweights` | weights on the crankshafts from a balance factor, at the throws or in chosen planes |
| `loads` | what each crank pin carries, rotating and reciprocating; bobweights |
"""

from crankstar.remedy.counterweights import RemedyError, with_counterweights
from crankstar.remedy.loads import Load, bobweight, loads
from crankstar.remedy.shafts import end_planes, with_balance_shaft

__all__ = ["Load", "RemedyError", "bobweight", "end_planes", "loads", "with_balance_shaft", "with_counterweights"]
