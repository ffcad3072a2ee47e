"""The runs of a rotor with trial weights, from a CSV list.

run, trial [g*mm], at [deg], bearing 1 [mm/s], phase 1 [deg], bearing 2 [mm/s], phase 2 [deg]
initial, , , 5.2, 40, 3.1, 210
plane 1, 400, 0, 4.1, 75, 3.6, 205
plane 2, 400, 90, 5.5, 52, 1.9, 240
check, , , 0.4, 100, 0.3, 20
"""

from __future__ import annotations

from cmath import rect
from typing import NamedTuple

import numpy as np

from crankstar.engine.quantities import ANGLE, UNBALANCE
from crankstar.files.lists import (
    Listed,
    ListError,
    Row,
    columns_of,
    number_of,
    refused_cell,
    value_of,
)
from crankstar.language.messages import _
from crankstar.spectra import Complex

RUNS = ("initial", "plane 1", "plane 2", "check")
HEADS = {
    "run": "run",
    "trial": "trial",
    "trial weight": "trial",
    "trial unbalance": "trial",
    "at": "at",
    "angle": "at",
    "bearing 1": "bearing 1",
    "phase 1": "phase 1",
    "bearing 2": "bearing 2",
    "phase 2": "phase 2",
}


class TrialRuns(NamedTuple):
    """Vibration at two bearings before, trial unbalances, runs [plane, bearing], and after."""

    initial: Complex
    trials: Complex
    runs: Complex
    check: Complex | None


def trial_runs(listed: Listed) -> TrialRuns:
    """The runs of a list. Raises ListError."""
    columns = columns_of(listed, HEADS, needed=tuple(dict.fromkeys(HEADS.values())))
    found: dict[str, Row] = {}
    for row in listed.rows:
        name = row.cells[columns["run"]].lower()
        name = {"0": "initial", "1": "plane 1", "2": "plane 2"}.get(name, name)
        if name not in RUNS or name in found:
            why = (
                _("this run stands twice")
                if name in found
                else _("name the runs {names}", names=", ".join(RUNS))
            )
            raise refused_cell(listed, row, columns["run"], why)
        found[name] = row
    for name in RUNS[:3]:
        if name not in found:
            raise ListError(
                '{file} has no run "{name}"; give initial, plane 1 and plane 2',
                file=listed.name,
                name=name,
            )

    def vibration(row: Row) -> list[complex]:
        return [
            rect(
                number_of(listed, row, columns[f"bearing {k}"]),
                value_of(listed, row, columns[f"phase {k}"], ANGLE, usual="deg"),
            )
            for k in (1, 2)
        ]

    trials: list[complex] = []
    for name in RUNS[1:3]:
        row = found[name]
        size = value_of(listed, row, columns["trial"], UNBALANCE)
        if not size > 0:
            raise refused_cell(
                listed, row, columns["trial"], _("a trial weight must be greater than 0")
            )
        trials.append(rect(size, value_of(listed, row, columns["at"], ANGLE, usual="deg")))
    return TrialRuns(
        np.array(vibration(found["initial"])),
        np.array(trials),
        np.array([vibration(found[name]) for name in RUNS[1:3]]),
        np.array(vibration(found["check"])) if "check" in found else None,
    )
