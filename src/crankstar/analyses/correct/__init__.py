"""What to add or to drill in two planes of a rotor, of trial runs or of a measured unbalance.

| module, bottom to top | one line |
|---|---|
| `two_planes` | influence coefficients, unbalance in other planes, weights at allowed places |
| `trial_runs` | the list of runs with trial weights |
| `coefficients` | influence coefficients as a list: written, and read for another rotor |
| `question` | what is asked |
| `solving` | the unbalance in the correction planes, and what is added there |
| `document` | all of it as tables |
| `charts` | the vectors plane by plane |
"""

from __future__ import annotations

from crankstar.analysis.record import Analysis, Later, Picture, Saves
from crankstar.language.messages import N_

RECORD = Analysis(
    name="correct",
    about=N_("Say what to add or to drill in two planes of a rotor."),
    takes="",
    doing=N_("Computing corrections ..."),
    title=N_("Correction in two planes"),
    example=(
        '--unbalance "850 g*mm at 20 deg, 400 g*mm at 200 deg" --measuring-planes "0 mm, 400 mm" '
        '--correction-planes "50 mm, 350 mm"'
    ),
    question=Later("crankstar.analyses.correct.question:Question"),
    refuse=Later("crankstar.analyses.correct.question:refuse"),
    compute=Later("crankstar.analyses.correct.solving:compute"),
    document=Later("crankstar.analyses.correct.document:document"),
    picture=Picture(
        Later("crankstar.analyses.correct.charts:vectors"),
        N_("Correction in two planes"),
        N_("A picture (.svg) has the vectors."),
        unshown=("diameter", "greatest_depth", "tip", "density", "slug", "axial"),
    ),
    saves=Saves(
        "--save-coefficients",
        "csv",
        Later("crankstar.analyses.correct.solving:saved"),
        Later("crankstar.analyses.correct.question:refuse_saving"),
    ),
    engine="none",
)
