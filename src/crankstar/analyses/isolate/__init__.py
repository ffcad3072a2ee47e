"""The best mounts of an engine within limits.

| module, bottom to top | one line |
|---|---|
| `question` | what is asked, and the limits of stiffness, position, sag, frequency |
| `aims` | what is to be small, as a number |
| `free_values` | the values that may be chosen, and the engine with chosen ones |
| `isolation` | the best mounts within limits |
| `answer` | what answers it, and what that rests on |
| `document` | the best mounts, next to those of the file |
"""

from __future__ import annotations

from crankstar.analysis.record import Analysis, Later, Writes
from crankstar.language.messages import N_

RECORD = Analysis(
    name="isolate",
    about=N_("Find the stiffness and place of mounts, within limits, that pass on or shake least."),
    takes=N_("Name from the catalog, or engine file with [[mounts]]; - for standard input."),
    doing=N_("Looking for the best mounts"),
    title=N_("Best mounts"),
    example="mine.toml",
    question=Later("crankstar.analyses.isolate.question:Question"),
    needs=Later("crankstar.dynamics.mounted_block:mounted_block"),
    refuse=Later("crankstar.analyses.isolate.question:refuse"),
    compute=Later("crankstar.analyses.isolate.answer:compute"),
    answer=Later("crankstar.analyses.isolate.answer:answer"),
    document=Later("crankstar.analyses.isolate.document:document"),
    writes=Writes(
        "--output",
        Later("crankstar.analyses.isolate.answer:best_engine"),
        more="The engine on the best mounts.",
        of_result=True,
    ),
    steps=True,
)
