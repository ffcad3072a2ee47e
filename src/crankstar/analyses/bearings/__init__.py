"""Loads on main bearings, crankpins and cylinder walls; bending of the crankshaft.

| module, bottom to top | one line |
|---|---|
| `question` | what is asked |
| `wear_table` | where journals and pins are pressed most and least |
| `film_table` | specific pressures of main bearings and crank pins, and their least oil film |
| `answer` | what answers it, and what that rests on |
| `grids` | its arrays over part, order and crank angle |
| `document` | all of it as tables and sentences |
| `charts/` | what is plotted of it |
"""

from __future__ import annotations

from crankstar.analysis.record import Analysis, Chart, Later
from crankstar.language.messages import N_

RECORD = Analysis(
    name="bearings",
    about=N_(
        "Compute loads on main bearings and crank pins, guide forces, bending of the crankshaft."
    ),
    takes=N_("Name from the catalog, engine file, or - for standard input."),
    doing=N_("Computing the loads ..."),
    title=N_("Bearings"),
    example="audi-25-tfsi --gas",
    question=Later("crankstar.analyses.bearings.question:Question"),
    compute=Later("crankstar.analyses.bearings.answer:compute"),
    answer=Later("crankstar.analyses.bearings.answer:answer"),
    document=Later("crankstar.analyses.bearings.document:document"),
    grids=Later("crankstar.analyses.bearings.grids:grids"),
    charts=(
        Chart(
            "bearing-loads",
            "crankstar.analyses.bearings.charts.polar_diagrams:polar_loads",
            N_("the load on each main bearing or crank pin over a turn, as a polar diagram"),
            "Loaded",
        ),
        Chart(
            "bending",
            "crankstar.analyses.bearings.charts.bending:bending_chart",
            N_("the bending moment along the crankshaft, with counterweights and without"),
        ),
    ),
    estimates=True,
    marks_speed=True,
)
