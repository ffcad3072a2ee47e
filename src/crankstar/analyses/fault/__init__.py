"""What a fault of an engine changes in what shakes its block.

| module, bottom to top | one line |
|---|---|
| `question` | what is asked |
| `document` | what is felt with faults and without, as tables and sentences |
| `answer` | what answers it, and what that rests on |
"""

from __future__ import annotations

from crankstar.analysis.record import Analysis, Later
from crankstar.language.messages import N_

RECORD = Analysis(
    name="fault",
    about=N_("Tell what would be felt of a fault."),
    takes=N_("Name from the catalog, engine file, or - for standard input."),
    doing=N_("Computing what changes ..."),
    title=N_("What changes"),
    example="audi-25-tfsi --cut 3",
    question=Later("crankstar.analyses.fault.question:Question"),
    needs=Later("crankstar.studies.single_faults:known"),
    refuse=Later("crankstar.analyses.fault.question:refuse"),
    compute=Later("crankstar.analyses.fault.answer:compute"),
    answer=Later("crankstar.analyses.fault.answer:answer"),
    document=Later("crankstar.analyses.fault.document:document"),
    by_audience=True,
)
