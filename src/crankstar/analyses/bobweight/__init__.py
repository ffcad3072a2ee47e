"""The bobweight card of a crankshaft, as a balancing shop writes it.

| module, bottom to top | one line |
|---|---|
| `question` | what is asked |
| `document` | parts of a cylinder, bobweight of each pin, overbalance, as tables |
| `answer` | what answers it, and what that rests on |
"""

from __future__ import annotations

from crankstar.analysis.record import Analysis, Later
from crankstar.language.messages import N_

RECORD = Analysis(
    name="bobweight",
    about=N_(
        "Print the bobweight card of a crankshaft: parts, bobweight of each pin, overbalance."
    ),
    takes=N_("Name from the catalog, engine file, or - for standard input."),
    doing=N_("Weighing ..."),
    title=N_("Bobweights"),
    example="v8-cross-plane",
    question=Later("crankstar.analyses.bobweight.question:Question"),
    compute=Later("crankstar.analyses.bobweight.answer:compute"),
    answer=Later("crankstar.analyses.bobweight.answer:answer"),
    document=Later("crankstar.analyses.bobweight.document:document"),
    of_file=True,
    estimates=True,
    by_result=True,
)
