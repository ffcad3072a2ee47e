"""Influence coefficients of a machine in a CSV list: written from trial runs, read for a rotor.

plane, unbalance [g*mm], bearing 1 [mm/s], phase 1 [deg], bearing 2 [mm/s], phase 2 [deg]
1, 1000, 7.467, 168.1, 1.447, 177.2
2, 1000, 2.894, 31.1, 4.343, 266.9

A line says what an unbalance at 0 deg in that plane adds to the vibration of the bearings.
"""

from __future__ import annotations

import cmath
from math import degrees, nan
from typing import NamedTuple

import numpy as np

from crankstar.analyses.correct.trial_runs import BEARINGS, Shown, shown_in, vibration
from crankstar.analyses.correct.two_planes import told_apart
from crankstar.engine.quantities import UNBALANCE
from crankstar.files.columns import Columns
from crankstar.files.lists import Listed, Row
from crankstar.language.messages import _
from crankstar.options.refusals import refusal
from crankstar.spectra import Complex

UNBALANCE_WRITTEN = 1e-3
"""kg m: the unbalance of each line that is written, 1000 g mm."""
HEADS = {
    "plane": "plane",
    "unbalance": "unbalance",
    "bearing 1": "bearing 1",
    "phase 1": "phase 1",
    "bearing 2": "bearing 2",
    "phase 2": "phase 2",
}


class Coefficients(NamedTuple):
    """H [bearing, plane] in the vibration of each bearing, as `shown` [bearing], per kg m.

    `name` is that of their list.
    """

    matrix: Complex
    shown: tuple[Shown, Shown]
    name: str = ""


def coefficients_text(own: Coefficients) -> str:
    """The list of coefficients as CSV, to 12 figures.

    >>> speed = Shown("mm/s", 1)
    >>> print(coefficients_text(Coefficients(np.array([[7e3, 2e3j], [1e3, 4e3]]), (speed, speed))))
    plane, unbalance [g*mm], bearing 1 [mm/s], phase 1 [deg], bearing 2 [mm/s], phase 2 [deg]
    1, 1000, 7, 0, 1, 0
    2, 1000, 2, 90, 4, 0
    <BLANKLINE>
    """
    heads = ["plane", "unbalance [g*mm]"]
    for name, shown in zip(BEARINGS, own.shown, strict=True):
        heads += [f"{name} [{shown.unit}]" if shown.unit else name, f"phase {name[-1]} [deg]"]
    lines = [", ".join(heads)]
    for plane, column in enumerate(own.matrix.T.tolist(), 1):
        cells = [f"{plane}", f"{1e6 * UNBALANCE_WRITTEN:g}"]
        for each in column:
            size, angle = cmath.polar(UNBALANCE_WRITTEN * each)
            cells += [f"{size:.12g}", f"{degrees(angle) % 360:.12g}"]
        lines.append(", ".join(cells))
    return "\n".join(lines) + "\n"


def coefficients_of(listed: Listed) -> Coefficients:
    """The coefficients of a list.

    Raises ListError with every mistake, RemedyError where they do not tell the planes apart.
    """
    columns = Columns(listed, HEADS, needed=tuple(HEADS))
    shown = shown_in(columns)
    found: dict[str, list[complex]] = {}
    for row in columns.rows:
        plane = columns.text(row, "plane")
        if plane not in ("1", "2") or plane in found:
            columns.refuse(row, "plane", _("give a line each for the planes 1 and 2"))
        per = _unbalance(columns, row)
        found.setdefault(plane, [each / per for each in vibration(columns, row, shown)])
    missing = [plane for plane in ("1", "2") if plane not in found]
    if missing and not columns.mistakes:
        columns.refuse_list(_("there is no line of plane {plane}", plane=", ".join(missing)))
    columns.check()
    return Coefficients(told_apart(np.array([found["1"], found["2"]]).T), shown, listed.name)


def _unbalance(columns: Columns, row: Row) -> float:
    size = columns.value(row, "unbalance", UNBALANCE)
    if size <= 0:
        columns.refuse(row, "unbalance", _("an unbalance must be greater than 0"))
        return nan
    return size


def in_units_of(own: Coefficients, shown: tuple[Shown, Shown], *, option: str) -> Complex:
    """H [bearing, plane] in the units of other lists.

    Raises RequestError where vibration of another kind was measured there.
    """
    factors: list[float] = []
    for name, here, there in zip(BEARINGS, own.shown, shown, strict=True):
        if here.rate != there.rate:
            raise refusal(
                option,
                own.name,
                '{name} is in "{here}" there and in "{there}" in the runs; measure the same '
                "quantity",
                name=name,
                here=here.unit or "-",
                there=there.unit or "-",
            )
        factors.append(here.factor / there.factor)
    return np.array(factors)[:, None] * own.matrix
