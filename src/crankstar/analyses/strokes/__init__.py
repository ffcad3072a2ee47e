"""Strokes, valve events, exhaust intervals, and cylinders that disturb each other.

| module, bottom to top | one line |
|---|---|
| `question` | what is asked |
| `answer` | what answers it, and what that rests on |
| `document` | the working cycle as tables and sentences |
| `charts/` | what is plotted of it |
"""

from __future__ import annotations

from crankstar.analysis.record import Analysis, Chart, Later
from crankstar.language.messages import N_

RECORD = Analysis(
    name="strokes",
    about=N_(
        "Print strokes, valve events and exhaust intervals of each cylinder; find exhaust overlaps."
    ),
    takes=N_("Name from the catalog, engine file, or - for standard input."),
    doing=N_("Looking for cylinders that disturb each other ..."),
    title=N_("Strokes and exhaust"),
    example="v8-cross-plane",
    question=Later("crankstar.analyses.strokes.question:Question"),
    compute=Later("crankstar.analyses.strokes.answer:compute"),
    answer=Later("crankstar.analyses.strokes.answer:answer"),
    document=Later("crankstar.analyses.strokes.document:document"),
    charts=(
        Chart(
            "stroke-chart",
            "crankstar.analyses.strokes.charts.timing_diagram:stroke_chart",
            N_("open valves and ignition of each cylinder over one cycle"),
        ),
        Chart(
            "firing-ring",
            "crankstar.analyses.strokes.charts.firing_rings:firing_ring",
            N_("the cylinders around a circle at their firing angles"),
        ),
        Chart(
            "exhaust-orders",
            "crankstar.analyses.strokes.charts.exhaust_orders:exhaust_order_chart",
            N_("the orders of the exhaust pulses of each bank or manifold"),
        ),
    ),
)
