"""Which fault of an engine explains measured vibration.

| module, bottom to top | one line |
|---|---|
| `readings` | readings of vibration from a list, by order, position and direction |
| `question` | what is asked |
| `diagnosis` | the likeliest fault by measured vibration |
| `figures` | what an answer rests on moves them |
| `document` | all of a diagnosis as tables and sentences |
| `charts` | the candidate faults, measured and explained vectors |
| `answer` | what answers it, and what that rests on |
"""

from __future__ import annotations

from crankstar.analysis.record import Analysis, Later, Picture
from crankstar.language.messages import N_

RECORD = Analysis(
    name="diagnose",
    about=N_("Find the likeliest fault by measured vibration."),
    takes=N_("Name from the catalog, engine file, or - for standard input."),
    doing=N_("Trying every fault ..."),
    title=N_("Suspects"),
    example="mine.toml measured.csv",
    question=Later("crankstar.analyses.diagnose.question:Question"),
    needs=Later("crankstar.studies.single_faults:known"),
    refuse=Later("crankstar.analyses.diagnose.question:refuse"),
    compute=Later("crankstar.analyses.diagnose.answer:compute"),
    answer=Later("crankstar.analyses.diagnose.answer:answer"),
    document=Later("crankstar.analyses.diagnose.document:document"),
    picture=Picture(
        Later("crankstar.analyses.diagnose.charts:picture"),
        N_("{engine}: diagnosis"),
        "A picture (.svg) has the suspects and vectors.",
    ),
)
