"""What to drill, or which slugs to fit: for a measured unbalance, or for that of an engine.

| module, bottom to top | one line |
|---|---|
| `question` | what is asked |
| `answer` | the unbalances and the holes for them, and what these rest on |
| `document` | the holes plane by plane, as a table |
"""

from __future__ import annotations

from crankstar.analysis.record import Analysis, Later
from crankstar.language.messages import N_

RECORD = Analysis(
    name="drill",
    about=N_(
        "Say what to drill, or which slugs to fit: for a measured unbalance, or for an engine's."
    ),
    takes=N_("Name from the catalog, engine file, or - for standard input."),
    doing=N_("Computing holes ..."),
    title=N_("What to drill"),
    example=('--unbalance "850 g*mm at 20 deg" --diameter "12.7 mm" --at-radius "80 mm"'),
    question=Later("crankstar.analyses.drill.question:Question"),
    refuse=Later("crankstar.analyses.drill.question:refuse"),
    compute=Later("crankstar.analyses.drill.answer:compute"),
    answer=Later("crankstar.analyses.drill.answer:answer"),
    document=Later("crankstar.analyses.drill.document:document"),
    engine="optional",
    of_file=True,
    estimates=True,
    by_result=True,
)
