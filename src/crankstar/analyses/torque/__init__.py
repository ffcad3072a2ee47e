"""Torque of gas and inertia by order, and how evenly the engine runs.

| module, bottom to top | one line |
|---|---|
| `question` | what is asked |
| `answer` | what answers it, and what that rests on |
| `grids` | its arrays over chamber, order and crank angle |
"""

from __future__ import annotations

from crankstar.analysis.record import Analysis, Later
from crankstar.language.messages import N_

RECORD = Analysis(
    name="torque",
    about=N_(
        "Compute gas and inertia torque, half orders included, and how evenly the engine runs."
    ),
    takes=N_("Name from the catalog, engine file, or - for standard input."),
    doing=N_("Computing the cycle ..."),
    title=N_("Torque"),
    example="audi-25-tfsi",
    question=Later("crankstar.analyses.torque.question:Question"),
    refuse=Later("crankstar.analyses.torque.question:refuse"),
    compute=Later("crankstar.analyses.torque.answer:compute"),
    answer=Later("crankstar.analyses.torque.answer:answer"),
    document=Later("crankstar.analyses.torque.answer:document"),
    grids=Later("crankstar.analyses.torque.grids:grids"),
    estimates=True,
)
