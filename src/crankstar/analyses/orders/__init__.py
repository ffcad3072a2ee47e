"""The firing orders that a crank can fire, and the best of them.

| module, bottom to top | one line |
|---|---|
| `question` | what is asked |
| `listing` | the orders that can be fired, found and sorted |
| `document` | the orders with exhaust intervals and neighbours, as a table |
| `answer` | what the list rests on, and the engine that fires one of them |
"""

from __future__ import annotations

from crankstar.analysis.record import Analysis, Later, Writes
from crankstar.language.messages import N_

RECORD = Analysis(
    name="orders",
    about=N_(
        "List the firing orders that a crank can fire, with exhaust intervals and neighbours."
    ),
    takes=N_("Name from the catalog, engine file, or - for standard input."),
    doing=N_("Trying firing orders ..."),
    title=N_("Firing orders"),
    example="v8-cross-plane --minimise torque",
    question=Later("crankstar.analyses.orders.question:Question"),
    refuse=Later("crankstar.analyses.orders.question:refuse"),
    compute=Later("crankstar.analyses.orders.listing:compute"),
    answer=Later("crankstar.analyses.orders.answer:answer"),
    document=Later("crankstar.analyses.orders.document:document"),
    writes=Writes(
        "--output",
        Later("crankstar.analyses.orders.answer:fired"),
        more=".txt, .csv, .json, .xlsx or .parquet; with --row .toml, .json or .xlsx.",
        instead=Later("crankstar.analyses.orders.question:writes"),
        chosen=("row",),
    ),
    lists=("top",),
    by_result=True,
)
