"""Errors in published sources: each printed formula beside the correct one.

| module, bottom to top | one line |
|---|---|
| `question` | what is asked |
| `answer` | what derives and compares them |
| `document` | the formulas, source by source, as tables |
"""

from __future__ import annotations

from crankstar.analysis.record import Analysis, Later
from crankstar.language.messages import N_

RECORD = Analysis(
    name="errata",
    about=N_("List errors in published sources: each printed formula beside the correct one."),
    takes="",
    doing=N_("Deriving ..."),
    title=N_("Errors in published sources"),
    example="--source yamamoto2012",
    question=Later("crankstar.analyses.errata.question:Question"),
    compute=Later("crankstar.analyses.errata.answer:compute"),
    document=Later("crankstar.analyses.errata.document:document"),
    engine="none",
)
