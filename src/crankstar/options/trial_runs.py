"""The runs of a rotor with trial weights, from a CSV list.

run, trial [g*mm], at [deg], bearing 1 [mm/s], phase 1 [deg], bearing 2 [mm/s], phase 2 [deg]
initial, , , 5.2, 40, 3.1, 210
plane 1, 400, 0, 4.1, 75, 3.6, 205
plane 2, 400, 90, 5.5, 52, 1.9, 240
check, , , 0.4, 100, 0.3, 20
"""

from __future__ import annotations

import cmath
import re
from collections.abc import Sequence
from math import nan
from typing import NamedTuple

import numpy as np

from crankstar.engine.quantities import ANGLE, UNBALANCE
from crankstar.files import units
from crankstar.files.columns import Columns
from crankstar.files.lists import Listed, Row
from crankstar.files.vibrations import VIBRATIONS, not_negative
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


class Shown(NamedTuple):
    """How the vibration of a bearing is written: unit of its heading, which of VIBRATIONS it is.

    Without a unit it is in divisions of the instrument.
    """

    unit: str = ""
    rate: int | None = None


class TrialRuns(NamedTuple):
    """Vibration at two bearings before, trial unbalances, runs [plane, bearing], and after.

    Vibration is in the units of the headings, `shown` [bearing].
    """

    initial: Complex
    trials: Complex
    runs: Complex
    check: Complex | None
    shown: tuple[Shown, Shown]


def trial_runs(listed: Listed) -> TrialRuns:
    """The runs of a list. Raises ListError with every mistake."""
    columns = Columns(listed, HEADS, needed=tuple(dict.fromkeys(HEADS.values())))
    shown = (_shown(columns, "bearing 1"), _shown(columns, "bearing 2"))
    found = _runs(columns)
    sizes = {name: _vibration(columns, row, shown) for name, row in found.items()}
    trials: list[complex] = []
    for name, row in found.items():
        if name in RUNS[1:3]:
            trials.append(_trial(columns, row))
        else:
            _note_unused(columns, row)
    columns.check()
    return TrialRuns(
        np.array(sizes["initial"]),
        np.array(trials),
        np.array([sizes[name] for name in RUNS[1:3]]),
        np.array(sizes["check"]) if "check" in sizes else None,
        shown,
    )


def _runs(columns: Columns) -> dict[str, Row]:
    """The lines by the names of their runs, in the order of RUNS."""
    found: dict[str, Row] = {}
    if "run" not in columns:
        return found
    for row in columns.rows:
        name = columns.text(row, "run").lower()
        name = {"0": "initial", "1": "plane 1", "2": "plane 2"}.get(name, name)
        if name in found:
            columns.refuse(row, "run", _("this run stands twice"))
        elif name not in RUNS:
            columns.refuse(row, "run", _("name the runs {names}", names=", ".join(RUNS)))
        found.setdefault(name, row)
    for name in RUNS[:3]:
        if name not in found:
            columns.refuse_list(
                _('there is no run "{name}"; give initial, plane 1 and plane 2', name=name)
            )
    return {name: found[name] for name in RUNS if name in found}


def _shown(columns: Columns, name: str) -> Shown:
    """How the vibration of a bearing is written."""
    unit = columns.unit(name)
    if not unit:
        return Shown()
    rate = units.which(unit, VIBRATIONS)
    if rate is None:
        why = _(
            "its unit is none of a displacement, a velocity or an acceleration; name one, or "
            "leave it out where the instrument shows divisions"
        )
        columns.refuse_head(name, why)
    return Shown(unit, rate)


def _vibration(columns: Columns, row: Row, shown: Sequence[Shown]) -> list[complex]:
    """The vibration at both bearings."""
    out: list[complex] = []
    for name, own in zip(("bearing 1", "bearing 2"), shown, strict=True):
        if own.rate is not None:
            quantity = VIBRATIONS[own.rate]
            size = columns.value(row, name, quantity) / units.si(f"1 {own.unit}", quantity)
        else:
            size = nan if own.unit else columns.number(row, name)
        phase = columns.value(row, f"phase {name[-1]}", ANGLE, usual="deg")
        out.append(not_negative(columns, row, name, size) * cmath.exp(1j * phase))
    return out


def _trial(columns: Columns, row: Row) -> complex:
    """The trial unbalance of a run, kg m."""
    size = columns.value(row, "trial", UNBALANCE)
    if size <= 0:
        columns.refuse(row, "trial", _("a trial weight must be greater than 0"))
    return size * cmath.exp(1j * columns.value(row, "at", ANGLE, usual="deg"))


def _note_unused(columns: Columns, row: Row) -> None:
    """Note a trial weight in a run that has none."""
    for name in ("trial", "at"):
        text = columns.text(row, name)
        if text not in ("", "-") and not re.match(r"[-+]?0*\.?0*(\s|$)", text):
            why = _("this run is without a trial weight; leave the cell empty")
            columns.refuse(row, name, why)
