"""Moments of a marine engine: external and guide-force moments, compensators, end weights.

| module, bottom to top | one line |
|---|---|
| `compensators` | contra-rotating masses that cancel a vertical moment |
| `marine_analysis` | external and guide-force moments of an engine with weights and compensators |
| `question` | what is asked |
| `doubts` | what is missing, and what hardly any engine has |
| `document` | all of an analysis as tables and sentences |
| `large_engines` | what views show of large engines: guide-force moments, those of a ship |
| `charts/` | what is plotted of it |
| `answer` | what answers it, and what that rests on |
"""

from __future__ import annotations

from typing import Any

from crankstar.analysis.record import Analysis, Chart, Figure, Later, Panel, Writes
from crankstar.language.messages import N_

_SHIP: Later[Any] = Later("crankstar.analyses.marine.large_engines:ship_engine")

RECORD = Analysis(
    name="marine",
    about=N_(
        "Compute external and guide-force moments as project guides have them, and compensators."
    ),
    takes=N_("Name from the catalog, engine file, or - for standard input."),
    doing=N_("Computing the moments ..."),
    title=N_("In the ship"),
    example="man-s90mc-c",
    question=Later("crankstar.analyses.marine.question:Question"),
    refuse=Later("crankstar.analyses.marine.question:refuse"),
    compute=Later("crankstar.analyses.marine.answer:compute"),
    answer=Later("crankstar.analyses.marine.answer:answer"),
    document=Later("crankstar.analyses.marine.document:document"),
    lacks=lambda engine, speed: _SHIP.value(engine, speed) is None,
    panel=Panel(
        N_("Ship"),
        N_(
            "This is of large two-stroke engines in line, with masses, sizes, speed and gas in "
            "their file."
        ),
    ),
    charts=(
        Chart(
            "guide-moments",
            "crankstar.analyses.marine.charts.guide_moments:guide_moment_chart",
            N_("guide-force moments of each order: H, which sways all heads, and X, which twists"),
        ),
    ),
    figures=(
        Figure(
            "guide-moments",
            N_("Guide-force moments by order: H sways all heads together, X twists the frame."),
            at_speed=True,
        ),
    ),
    writes=Writes(
        "--save",
        engine=Later("crankstar.analyses.marine.answer:changed"),
        refuse=Later("crankstar.analyses.marine.question:refuse_unchanged"),
    ),
    estimates=True,
)
