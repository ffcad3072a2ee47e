"""Torsional vibration: how a crankshaft or a drive line twists.

| module, bottom to top | one line |
|---|---|
| `grids` | its arrays over speed, order and place |
| `measures` | what a sweep may watch of it |
| `fatigue_tables` | fatigue of the crankshaft |
| `facts` | what a verdict and a comparison say of it |
| `question` | what is asked |
| `response_tables` | the forced vibration: over the speeds, at one, heat, barred ranges |
| `chain_tables` | masses and shafts, modes with their shapes and nodes, Holzer's table |
| `figures` | what an answer rests on moves them |
| `answer` | what answers it, and what that rests on |
| `charts/` | what is plotted of it |
| `document` | all of an analysis as tables and sentences |
"""

from __future__ import annotations

from crankstar.analysis.record import Analysis, Chart, Figure, Later, Measure
from crankstar.language.messages import N_

RECORD = Analysis(
    name="torsion",
    about=N_(
        "Compute torsional vibration: modes, critical speeds, response and stress of a crankshaft."
    ),
    takes=N_(
        "Name from the catalog, engine file with a table [torsion], or file of a drive line with "
        "discs alone; - for standard input."
    ),
    doing=N_("Computing torsional vibration ..."),
    title=N_("Torsional vibration"),
    example="cadillac-ld8",
    question=Later("crankstar.analyses.torsion.question:Question"),
    refuse=Later("crankstar.analyses.torsion.question:refuse"),
    compute=Later("crankstar.analyses.torsion.answer:compute"),
    answer=Later("crankstar.analyses.torsion.answer:answer"),
    document=Later("crankstar.analyses.torsion.document:document"),
    grids=Later("crankstar.analyses.torsion.grids:grids"),
    lists=("speed", "modes", "holzer"),
    lacks=lambda engine, _speed: engine.torsion is None,
    charts=(
        Chart(
            "torsion-modes",
            "crankstar.analyses.torsion.charts.mode_shapes:mode_shapes",
            N_("how far each mass turns in the first torsional modes, with their nodes"),
        ),
        Chart(
            "campbell",
            "crankstar.analyses.torsion.charts.campbell_diagrams:campbell",
            N_("torsional frequencies and orders over the speed, and where they meet"),
        ),
        Chart(
            "torsion-response",
            "crankstar.analyses.torsion.charts.responses:torsion_response_chart",
            N_(
                "torsional vibration over the speed, by order and of all: free end, stress or "
                "torque"
            ),
            "TorsionView",
        ),
        Chart(
            "torsion-star",
            "crankstar.analyses.torsion.charts.stars:torsion_star",
            N_("the vectors of the cylinders of orders in a torsional mode, with their sum"),
            "TorsionMode",
        ),
    ),
    figures=(
        Figure(
            "torsion-modes",
            N_("The first torsional modes: turn of each mass, and nodes."),
            shows=lambda found: bool(found.modes),
        ),
        Figure(
            "campbell",
            N_("Natural frequencies and orders over the speed."),
            shows=lambda found: bool(found.modes and found.speeds.size),
        ),
        Figure(
            "torsion-response",
            N_("Vibration of the free end over the speed."),
            "amplitude",
            shows=lambda found: found.response is not None,
        ),
        Figure(
            "torsion-response",
            N_("Shear stress of the most strained shaft over the speed."),
            "stress",
            shows=lambda found: found.response is not None and found.chain.stressed,
        ),
        Figure(
            "torsion-star",
            N_("Vectors of the cylinders in the first mode, by order."),
            "mode-1",
            more=True,
            shows=lambda found: len(found.modes) > 0,
        ),
        Figure(
            "torsion-star",
            N_("Vectors of the cylinders in the second mode, by order."),
            "mode-2",
            more=True,
            shows=lambda found: len(found.modes) > 1,
        ),
    ),
    subject=N_("torsion"),
    facts=Later("crankstar.analyses.torsion.facts:sentences"),
    compared=Later("crankstar.analyses.torsion.facts:compared"),
    sizes=Later("crankstar.analyses.torsion.facts:sizes"),
    measures=(
        Measure("torsion_frequency", "Hz", ("natural frequency",), natural=True),
        Measure("torsion_stress", "MPa", ("torsional stress",), orders=True),
        Measure("torsion_amplitude", "deg", ("torsional amplitude",), orders=True),
    ),
    measured=Later("crankstar.analyses.torsion.measures:measured"),
    natural=Later("crankstar.analyses.torsion.figures:twisting_modes"),
    chains=("speeds", "orders", "modes", "holzer"),
    estimates=True,
)
