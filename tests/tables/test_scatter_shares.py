"""The shares of tolerances: of every order that is shown, with every tolerance of weight to it."""

from __future__ import annotations

import json
from functools import cache
from io import StringIO
from math import cos, pi, radians, sin
from typing import Any

import numpy as np
import pytest
from rich.console import Console

from crankstar.analyses.tolerance.charts import scatter_chart
from crankstar.analyses.tolerance.document import scatter_document
from crankstar.analyses.tolerance.scatter import scatter_of
from crankstar.analysis.document import Document, Table
from crankstar.spectra import Complex, Real
from crankstar.studies.fields import Source
from crankstar.tables.terminal import rendered

RADIUS, ROD, STEPS = 0.04, 0.13, 512
FOUR: dict[str, Any] = {
    "name": "four",
    "firing_order": [1, 3, 4, 2],
    "speed": "6000 rpm",
    "cylinder": {
        "stroke": "80 mm",
        "rod_length": "130 mm",
        "offset": "3 mm +- 0.3 mm",
        "reciprocating_mass": "450 g",
        "rotating_mass": "400 g",
    },
    "layout": {
        "type": "vee",
        "banks": [
            {"bearing": "35 deg +- 0.2 deg", "cylinders": [1, 3]},
            {"bearing": "-35 deg", "cylinders": [2, 4], "offset": "-2 mm +- 0.5 mm"},
        ],
        "throws": ["0 deg", "180 deg +- 0.1 deg"],
        "bore_pitch": "90 mm",
        "bank_offset": "20 mm +- 0.4 mm",
    },
}


def couple(
    *,
    offsets: tuple[float, ...] = (3e-3, 3e-3, -2e-3, -2e-3),
    bearing: float = 35.0,
    throw: float = 180.0,
    apart: float = 0.02,
) -> Complex:
    """The second order of z times the acceleration of each piston, up and right: own kinematics.

    Cylinders 1, 3 and 2, 4; both of a bank on throws 1 and 2, the banks `apart` along the shaft.
    """
    out = np.zeros(2, complex)
    theta = np.arange(STEPS) * (2 * pi / STEPS)
    for place, offset in enumerate(offsets):
        bank, pin = divmod(place, 2)
        tilt = radians(bearing if bank == 0 else -35.0)
        z = (0.045, -0.045)[pin] + (0.5, -0.5)[bank] * apart
        turned: Real = theta + radians((0.0, throw)[pin]) - tilt
        path = RADIUS * np.cos(turned) + np.sqrt(ROD**2 - (RADIUS * np.sin(turned) - offset) ** 2)
        second = np.fft.fft(path)[2]
        out += z * second * np.array([cos(tilt), sin(tilt)])
    return out


def shares_of_couple() -> dict[str, float]:
    """Of each tolerance the part of the variance of the vector, its errors independent."""
    now, step = couple(), 1e-4

    def variance(bound: float, moved: Complex) -> float:
        return float((np.abs((moved - now) * bound / step) ** 2).sum())

    first = (3e-3 + step, 3e-3, -2e-3, -2e-3), (3e-3, 3e-3 + step, -2e-3, -2e-3)
    bank = 3e-3, 3e-3, -2e-3 + step, -2e-3 + step
    parts = {
        "cylinder.offset": sum(variance(0.3e-3, couple(offsets=each)) for each in first),
        "layout.banks[1].bearing": variance(0.2, couple(bearing=35.0 + step)),
        "layout.banks[2].offset": variance(0.5e-3, couple(offsets=bank)),
        "layout.throws[2]": variance(0.1, couple(throw=180.0 + step)),
        "layout.bank_offset": variance(0.4e-3, couple(apart=0.02 + step)),
    }
    return {path: part / sum(parts.values()) for path, part in parts.items()}


@cache
def share_table() -> Table:
    """The table of shares that readers are shown."""
    found = scatter_of(Source("four", FOUR), count=1000, orders=[1.0, 2.0])
    parts = scatter_document(found, signals=["force", "couple", "roll"]).parts
    tables = [each for each in parts if isinstance(each, Table)]
    return next(each for each in tables if each.title == "Which tolerance matters")


def test_each_order_that_is_shown_has_a_column_of_shares() -> None:
    heads = [column.heading for column in share_table().columns[1:]]
    kinds = ("force", "couple", "rolling moment")
    assert heads == [f"{kind}, order {order}" for kind in kinds for order in (1, 2)]


def test_no_tolerance_that_matters_to_a_shown_order_is_missing() -> None:
    right, table = shares_of_couple(), share_table()
    assert right["layout.bank_offset"] == pytest.approx(0.86318, abs=1e-4)
    place = [column.heading for column in table.columns].index("couple, order 2")
    shown = {row[0]: row[place] for row in table.rows}
    for path, share in right.items():
        assert shown[path] == pytest.approx(100 * share, abs=0.06), path


def test_what_does_not_fit_a_terminal_goes_on_below_and_is_not_left_out() -> None:
    out = StringIO()
    console = Console(file=out, width=60)
    console.print(rendered(Document("", (share_table(),)), width=60))
    said = out.getvalue()
    assert said.count("layout.bank_offset") > 1
    assert "86.3" in said


def test_a_chart_says_how_much_it_leaves_out() -> None:
    """Of eight amplitudes of two orders six are drawn."""
    found = scatter_of(Source("four", FOUR), count=1000, orders=[1.0, 2.0])
    asked = ("force.up", "force.right", "couple.pitch", "couple.yaw")
    for names, left in ((asked, "2 further amplitudes are not drawn"), (asked[:3], "")):
        chart = scatter_chart(found, quantities=names, orders=[1.0, 2.0])
        text = json.dumps(chart.spec)
        assert ("not drawn" in text, left in text) == (bool(left), True)
