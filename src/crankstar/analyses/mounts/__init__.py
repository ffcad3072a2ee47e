"""An engine on its mounts: natural modes, vibration, what the mounts pass on.

| module, bottom to top | one line |
|---|---|
| `question` | what is asked |
| `answer` | what answers it, and what that rests on |
| `speed_tables` | vibration and forces speed by speed |
| `document` | all of an analysis as tables and sentences |
"""

from __future__ import annotations

from crankstar.analysis.record import Analysis, Figure, Later
from crankstar.language.messages import N_


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
    question=Later("crankstar.analyses.mounts.question:Question"),
    compute=Later("crankstar.analyses.mounts.answer:compute"),
    answer=Later("crankstar.analyses.mounts.answer:answer"),
    document=Later("crankstar.analyses.mounts.document:document"),
    lacks=lambda engine: not engine.mounts,
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
)
