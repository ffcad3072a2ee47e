"""An engine on its mounts: natural modes, vibration, what the mounts pass on.

| module, bottom to top | one line |
|---|---|
| `facts` | what a verdict and a comparison say of it |
| `grids` | its arrays over speed, order and mount |
| `measures` | what a sweep may watch of it |
| `question` | what is asked |
| `speed_tables` | vibration and forces speed by speed |
| `figures` | what an answer rests on moves them |
| `answer` | what answers it, and what that rests on |
| `charts/` | what is plotted of it |
| `document` | all of an analysis as tables and sentences |
"""

from __future__ import annotations

from crankstar.analysis.record import Analysis, Chart, Figure, Later, Measure
from crankstar.language.messages import N_

EVERY_MODE = tuple(f"mode {number}" for number in range(1, 13))


def _turns(found: object) -> bool:
    """Whether a speed is known."""
    return getattr(found, "over", None) is not None


RECORD = Analysis(
    name="mounts",
    about=N_(
        "Compute how an engine shakes on its mounts: modes, motion of a point, forces passed on."
    ),
    takes=N_("Name from the catalog, or engine file with [[mounts]]; - for standard input."),
    doing=N_("Computing the vibration on the mounts ..."),
    title=N_("On its mounts"),
    example="mine.toml",
    question=Later("crankstar.analyses.mounts.question:Question"),
    compute=Later("crankstar.analyses.mounts.answer:compute"),
    answer=Later("crankstar.analyses.mounts.answer:answer"),
    document=Later("crankstar.analyses.mounts.document:document"),
    grids=Later("crankstar.analyses.mounts.grids:grids"),
    lists=("speed", "orders"),
    lacks=lambda engine, _speed: not engine.mounts,
    charts=(
        Chart(
            "mount-layout",
            "crankstar.analyses.mounts.charts.layouts:mount_layout_chart",
            N_(
                "the mounts from the front, from above and from the side, with centre of mass "
                "and axes"
            ),
        ),
        Chart(
            "mount-modes",
            "crankstar.analyses.mounts.charts.modes:mount_mode_chart",
            N_("the natural modes on the mounts, with the share of each freedom in their energy"),
        ),
        Chart(
            "mount-response",
            "crankstar.analyses.mounts.charts.responses:mount_response_chart",
            N_(
                "vibration on the mounts over the speed, by order and of all: a point, or the "
                "forces"
            ),
            "MountView",
        ),
        Chart(
            "transmissibility",
            "crankstar.analyses.mounts.charts.responses:transmissibility_chart",
            N_("how much of what shakes the engine goes through each mount, over the speed"),
        ),
    ),
    figures=(
        Figure("mount-layout", N_("The mounts from the front, from above and from the side.")),
        Figure("mount-modes", N_("Natural modes: share of each freedom in the kinetic energy.")),
        Figure(
            "mount-response", N_("Velocity of the point over the speed."), "velocity", shows=_turns
        ),
        Figure("mount-response", N_("Force on the ground over the speed."), "force", shows=_turns),
        Figure(
            "mount-response",
            N_("Force in each mount over the speed."),
            "mounts",
            more=True,
            shows=_turns,
        ),
        Figure(
            "transmissibility",
            N_("Transmissibility of the mounts over the speed."),
            more=True,
            shows=_turns,
        ),
    ),
    subject=N_("mounts"),
    facts=Later("crankstar.analyses.mounts.facts:sentences"),
    compared=Later("crankstar.analyses.mounts.facts:compared"),
    sizes=Later("crankstar.analyses.mounts.facts:sizes"),
    measures=(
        *(
            Measure(f"mount_mode_{number}", "Hz", (f"mode {number}",), natural=True)
            for number in range(1, 7)
        ),
        Measure("mount_roll_mode", "Hz", EVERY_MODE, natural=True),
        Measure("mount_roll_share", "", EVERY_MODE, natural=True),
        Measure("mount_force", "N", ("mount force",), orders=True),
        Measure("mount_velocity", "mm/s", ("velocity at the point",), orders=True),
    ),
    measured=Later("crankstar.analyses.mounts.measures:measured"),
    natural=Later("crankstar.analyses.mounts.figures:mounted_modes"),
)
