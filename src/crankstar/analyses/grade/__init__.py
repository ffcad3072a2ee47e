"""The unbalance that may remain in a rotor by ISO 21940-11, and the grade that one meets.

| module, bottom to top | one line |
|---|---|
| `grades` | permissible residual unbalance by grade, mass and speed |
| `question` | what is asked |
| `document` | grades, and what was measured beside them, as tables |
| `answer` | the rotor that is asked about, and what its figures rest on |
"""

from __future__ import annotations

from crankstar.analysis.record import Analysis, Later
from crankstar.language.messages import N_

RECORD = Analysis(
    name="grade",
    about=N_(
        "Print the unbalance that may remain by ISO 21940-11, or the grade that a measured one "
        "meets."
    ),
    takes=N_(
        "Name from the catalog, engine file, or - for standard input: its speed is taken where "
        "--speed is not given."
    ),
    doing=N_("Computing the permissible unbalance ..."),
    title=N_("Balance quality of a rotor"),
    example='--mass "28 kg" --speed "6000 rpm"',
    question=Later("crankstar.analyses.grade.question:Question"),
    refuse=Later("crankstar.analyses.grade.question:refuse"),
    compute=Later("crankstar.analyses.grade.answer:compute"),
    answer=Later("crankstar.analyses.grade.answer:answer"),
    document=Later("crankstar.analyses.grade.document:document"),
    engine="optional",
    estimates=True,
    unranged=True,
    by_result=True,
)
