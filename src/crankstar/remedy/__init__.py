"""Remedies: what is put on an engine so that it shakes less. A remedy is an Engine again.

| module | one line |
|---|---|
| `counterweights` | weights on the crankshafts from a balance factor, at the throws or in chosen planes |
| `loads` | what each crank pin carries, rotating and reciprocating; bobweights |
"""

from crankstar.remedy.counterweights import RemedyError, with_counterweights
from crankstar.remedy.loads import Load, bobweight, loads

__all__ = ["Load", "RemedyError", "bobweight", "loads", "with_counterweights"]
