"""V engines that fire evenly: bank angle, pin split, throws and balance.

| module, bottom to top | one line |
|---|---|
| `question` | what is asked |
| `document` | the engines, best balanced first, as a table |
| `finding` | what finds them, and the engine of one of them |
"""

from __future__ import annotations

from crankstar.analysis.record import Analysis, Later, Writes
from crankstar.language.messages import N_

RECORD = Analysis(
    name="vees",
    about=N_("List V engines that fire evenly: bank angle, pin split, throws and balance."),
    takes="",
    doing=N_("Trying cranks and bank angles ..."),
    title=N_("V engines that fire evenly"),
    example="6 --bank 90",
    question=Later("crankstar.analyses.vees.question:Question"),
    refuse=Later("crankstar.analyses.vees.question:refuse"),
    compute=Later("crankstar.analyses.vees.finding:compute"),
    document=Later("crankstar.analyses.vees.document:document"),
    writes=Writes(
        "--output",
        Later("crankstar.analyses.vees.finding:engine"),
        more=".txt, .csv, .json, .xlsx or .parquet; with --row .toml, .json or .xlsx.",
        instead=Later("crankstar.analyses.vees.question:writes"),
        chosen=("row", "star"),
    ),
    lists=("top",),
    engine="none",
)
