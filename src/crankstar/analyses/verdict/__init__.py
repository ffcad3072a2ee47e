"""The verdict on an engine: which orders balance, which remain, and what would cure them.

| module, bottom to top | one line |
|---|---|
| `firing_facts` | layout, firing and exhaust pulses as sentences |
| `relatives` | engines of the catalog with the same balance |
| `facts` | the sentences of a verdict, each with its subject |
| `ranges` | the same of an estimated engine |
| `question` | what is asked |
| `answer` | what answers it, also as built, and what that rests on |
| `document` | the sentences beside their subjects |
"""

from __future__ import annotations

from crankstar.analysis.record import Analysis, Later
from crankstar.language.messages import N_

RECORD = Analysis(
    name="verdict",
    about=N_(
        "State in short sentences which orders balance, which remain, and what would cure them."
    ),
    takes=N_("Name from the catalog, engine file, or - for standard input."),
    doing=N_("Looking for what remains ..."),
    title=N_("The verdict"),
    example="audi-25-tfsi",
    question=Later("crankstar.analyses.verdict.question:Question"),
    compute=Later("crankstar.analyses.verdict.answer:compute"),
    answer=Later("crankstar.analyses.verdict.answer:answer"),
    document=Later("crankstar.analyses.verdict.document:document"),
    onward=Later("crankstar.analyses.verdict.answer:onward"),
    of_file=True,
    estimates=True,
    ranges_itself=True,
    marks_speed=True,
)
