"""Families of engines: the cylinders of one in rows of other numbers, as a project guide.

| module, bottom to top | one line |
|---|---|
| `published_orders` | the firing orders of the catalog that were read in a source |
| `family_torsion` | the chain of an engine with other numbers of throws, and its vector sums |
| `question` | what is asked |
| `engine_family` | the cylinders of an engine in rows of 5 to 12, each with the best order |
| `document` | a family as a table of firing orders and sentences |
| `answer` | what answers it, and what that rests on |
"""

from __future__ import annotations

from crankstar.analysis.record import Analysis, Later
from crankstar.language.messages import N_

RECORD = Analysis(
    name="guide",
    about=N_(
        "List engines with the cylinders of one in rows of 5 to 12, with the best firing orders."
    ),
    takes=N_("Name from the catalog, engine file, or - for standard input."),
    doing=N_("Searching firing orders ..."),
    title=N_("Family"),
    example="man-s90mc-c --numbers 6,7",
    question=Later("crankstar.analyses.guide.question:Question"),
    compute=Later("crankstar.analyses.guide.answer:compute"),
    answer=Later("crankstar.analyses.guide.answer:answer"),
    document=Later("crankstar.analyses.guide.document:document"),
)
