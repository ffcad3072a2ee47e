"""Generating sets: how evenly one runs, and what several do to one foundation.

| module, bottom to top | one line |
|---|---|
| `question` | what is asked |
| `generating_set` | the set at its speed, and sums over several engines |
| `document` | all of a set as tables and sentences |
| `answer` | what answers it, and what that rests on |
"""

from __future__ import annotations

from crankstar.analysis.record import Analysis, Later
from crankstar.language.messages import N_

RECORD = Analysis(
    name="genset",
    about=N_("Compute how evenly a generating set runs, and what several do to one foundation."),
    takes=N_("Name from the catalog, engine file, or - for standard input."),
    doing=N_("Computing the cycle ..."),
    title=N_("Generating set"),
    example="audi-25-tfsi",
    question=Later("crankstar.analyses.genset.question:Question"),
    refuse=Later("crankstar.analyses.genset.question:refuse"),
    compute=Later("crankstar.analyses.genset.answer:compute"),
    answer=Later("crankstar.analyses.genset.answer:answer"),
    document=Later("crankstar.analyses.genset.document:document"),
    estimates=True,
)
