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

PLANES = ("plane 1", "plane 2")
RUNS = ("initial", *PLANES, "check")
BEARINGS = ("bearing 1", "bearing 2")
TRIAL = ("trial", "at")
"""Columns of a trial weight."""
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

    @property
    def factor(self) -> float:
        """What one of the unit is in SI; of a division, one."""
        if self.rate is None:
            return 1.0
        return units.si(f"1 {self.unit}", VIBRATIONS[self.rate])


class TrialRuns(NamedTuple):
    """Vibration at two bearings before, trial unbalances, runs [plane, bearing], and after.

    Vibration is in the units of the headings, `shown` [bearing].
    """

    initial: Complex
    trials: Complex
    runs: Complex
    check: Complex | None
    shown: tuple[Shown, Shown]


def trial_runs(listed: Listed, *, known: bool = False) -> TrialRuns:
    """The runs of a list. Raises ListError with every mistake.

    `known`: the influence coefficients are, so that there are no runs with trial weights.
    """
    names = [name for name in dict.fromkeys(HEADS.values()) if not known or name not in TRIAL]
    columns = Columns(listed, HEADS, needed=names)
    shown = shown_in(columns)
    found = _runs(columns, known=known)
    sizes = {name: vibration(columns, row, shown) for name, row in found.items()}
    trials: list[complex] = []
    for name, row in found.items():
        if name not in PLANES:
            _note_unused(columns, row)
        elif known:
            why = _("a run with a trial weight has no effect with coefficients; leave it out")
            columns.refuse(row, "run", why)
        else:
            trials.append(_trial(columns, row))
    columns.check()
    return TrialRuns(
        np.array(sizes["initial"]),
        np.array(trials),
        np.array([sizes[name] for name in PLANES if name in sizes]),
        np.array(sizes["check"]) if "check" in sizes else None,
        shown,
    )


def _runs(columns: Columns, *, known: bool) -> dict[str, Row]:
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
    for name in RUNS[:1] if known else RUNS[:3]:
        if name not in found:
            told = (
                _('there is no run "{name}"', name=name)
                if known
                else _(
                    'there is no run "{name}"; give initial, plane 1 and plane 2, or '
                    "--coefficients",
                    name=name,
                )
            )
            columns.refuse_list(told)
    return {name: found[name] for name in RUNS if name in found}


def shown_in(columns: Columns) -> tuple[Shown, Shown]:
    """How a list has the vibration of its bearings; what is wrong with a heading is noted."""
    return _shown(columns, BEARINGS[0]), _shown(columns, BEARINGS[1])


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


def vibration(columns: Columns, row: Row, shown: Sequence[Shown]) -> list[complex]:
    """The vibration at both bearings."""
    out: list[complex] = []
    for name, own in zip(BEARINGS, shown, strict=True):
        if own.rate is not None:
            size = columns.value(row, name, VIBRATIONS[own.rate]) / own.factor
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
    for name in TRIAL:
        text = columns.text(row, name)
        if text not in ("", "-") and not re.match(r"[-+]?0*\.?0*(\s|$)", text):
            why = _("this run is without a trial weight; leave the cell empty")
            columns.refuse(row, name, why)
