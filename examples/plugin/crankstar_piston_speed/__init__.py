"""How fast the pistons of an engine go: an analysis of crankstar from a package of its own."""

from __future__ import annotations

from crankstar.analysis.record import Analysis, Later, Panel

RECORD = Analysis(
    name="piston-speed",
    about="Compute the mean piston speed, and the acceleration of the pistons at top dead centre.",
    takes="Name from the catalog, engine file, or - for standard input.",
    doing="Computing the piston speed ...",
    title="Piston speed",
    example="audi-25-tfsi",
    question=Later("crankstar_piston_speed.question:Question"),
    compute=Later("crankstar_piston_speed.answer:compute"),
    answer=Later("crankstar_piston_speed.answer:answer"),
    document=Later("crankstar_piston_speed.answer:document"),
    needs=Later("crankstar_piston_speed.question:needs"),
    lacks=lambda engine, speed: "radius" in engine.relative or (speed or engine.speed) is None,
    panel=Panel("Piston speed", "This needs the stroke in mm and a speed in the engine file."),
)
