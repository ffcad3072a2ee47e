"""Weighed pistons, pins and rods of a batch, matched to the cylinders of one engine or several.

| module, bottom to top | one line |
|---|---|
| `question` | what is asked, and the list of weights |
| `batch` | the parts of a list, pins paired with pistons, what the file has of them |
| `law` | the unbalance of an engine as a linear law of the masses of its cylinders |
| `assignments` | the assignments whose vectors add up to least, with proof |
| `matching` | a batch matched to the cylinders of an engine, and what chance and classes leave |
| `sets` | a batch divided into sets for several engines, each matched |
| `document` | what goes where and what is left, as tables and sentences |
| `answer` | what answers it, and what that rests on |
"""

from __future__ import annotations

from crankstar.analysis.record import Analysis, Later, Writes
from crankstar.language.messages import N_

RECORD = Analysis(
    name="match",
    about=N_("Match weighed pistons, pins and rods to the cylinders."),
    takes=N_("Name from the catalog, engine file, or - for standard input."),
    doing=N_("Matching the parts to the cylinders ..."),
    title=N_("What goes where"),
    example="mine.toml weights.csv",
    question=Later("crankstar.analyses.match.question:Question"),
    refuse=Later("crankstar.analyses.match.question:refuse"),
    compute=Later("crankstar.analyses.match.answer:compute"),
    answer=Later("crankstar.analyses.match.answer:answer"),
    document=Later("crankstar.analyses.match.document:document"),
    writes=Writes(
        "--engine-file",
        Later("crankstar.analyses.match.answer:built"),
        of_result=True,
        count=Later("crankstar.analyses.match.question:count"),
    ),
    proved=Later("crankstar.analyses.match.answer:proved"),
    steps=True,
    by_result=True,
)
