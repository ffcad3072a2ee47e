"""Engines that are built to the tolerances of their file: how far they scatter, and why.

| module, bottom to top | one line |
|---|---|
| `question` | what is asked |
| `pitch_errors` | errors of the distances between cylinders |
| `error_sources` | the independent errors behind the tolerances of a file, and what they move |
| `linear_law` | mean, rms and worst case of each order to first order in these errors |
| `unit_parts` | the parts of an engine at unit mass: masses and angles of many engines at once |
| `builds` | engines built at random to their tolerances, exact however large these are |
| `scatter` | the scatter of an engine built to its tolerances |
| `document` | how far engines scatter, and which tolerance matters, as tables and sentences |
| `charts` | the amplitudes of engines built to their tolerances, and what matters most |
| `answer` | what answers it, and what that rests on |
| `as_built` | what a verdict says of engines built to their tolerances |
"""

from __future__ import annotations

from typing import Any

from crankstar.analysis.record import Analysis, Later, Panel, Picture
from crankstar.language.messages import N_

_BUILT: Later[Any] = Later("crankstar.analyses.tolerance.as_built:as_built")

RECORD = Analysis(
    name="tolerance",
    about=N_("Scatter the masses, lengths and angles of an engine within their tolerances."),
    takes=N_("Name from the catalog, engine file, or - for standard input."),
    doing=N_("Building engines at random ..."),
    title=N_("Built to tolerances"),
    example="audi-25-tfsi --typical",
    question=Later("crankstar.analyses.tolerance.question:Question"),
    refuse=Later("crankstar.analyses.tolerance.question:refuse"),
    compute=Later("crankstar.analyses.tolerance.answer:compute"),
    answer=Later("crankstar.analyses.tolerance.answer:answer"),
    document=Later("crankstar.analyses.tolerance.document:document"),
    lacks=lambda file, speed: _BUILT.value(file, speed=speed) is None,
    views={"builds": 20_000},
    panel=Panel(
        N_("Tolerances"),
        N_(
            "The file of this engine has no tolerances; write them behind the values, as in "
            "650 g +- 2 g."
        ),
    ),
    subject=N_("as built"),
    facts=Later("crankstar.analyses.tolerance.as_built:facts"),
    picture=Picture(
        Later("crankstar.analyses.tolerance.answer:picture"),
        N_("{engine}: built to its tolerances"),
        "A chart (.svg, .png, .pdf, .html) or a table (.csv, .json, .xlsx, .parquet, .txt).",
        caption=N_(
            "Left, how many engines have which amplitude; right, the share of each tolerance in "
            "the variance."
        ),
    ),
    of_file=True,
    estimates=True,
    unranged=True,
    marks_speed=True,
    steps=True,
    by_result=True,
)
