"""A best value beside values that have no result is no end of the range."""

from __future__ import annotations

from math import pi
from typing import Any

import numpy as np
import pytest

from crankstar import sweep, watched
from crankstar.studies.best_value import best
from crankstar.tables.machine import tree
from crankstar.tables.sweeps import answer, best_sentence

ENGINE: dict[str, Any] = {
    "name": "single",
    "cycle": "four-stroke",
    "speed": "5500 rpm",
    "cylinder": {"bore": "82 mm", "stroke": "90 mm", "rod_length": "145 mm"},
    "gas": {"compression_ratio": 12, "gamma": 1.3, "process": "otto", "intake_pressure": "1 bar"},
    "layout": {"type": "inline", "throws": ["0 deg"]},
}
ENGINE["cylinder"] |= {"reciprocating_mass": "480 g"}
COMPRESSED = 12**1.3
"""Bar: p r^gamma, less than which no peak can be."""


@pytest.mark.release
@pytest.mark.parametrize(("first", "last", "best_at"), [(10, 60, 30), (30, 60, 30)])
def test_beside_a_gap_is_no_end_of_the_range(first: float, last: float, best_at: float) -> None:
    values = np.arange(first, last + 1, 10.0)
    swept = sweep(ENGINE, f"gas.peak_pressure={first}..{last} bar/{values.size}")
    curve = watched(swept, "mean_torque")
    # otto: heat at constant volume, work = (peak - p r^gamma) Vc (1 - r^(1-gamma)) / (gamma - 1)
    clearance = pi / 4 * 0.082**2 * 0.09 / 11
    work = (values - COMPRESSED) * 1e5 * clearance * (1 - 12**-0.3) / 0.3
    expected = np.where(values > COMPRESSED, work / (4 * pi), np.nan)
    given = np.isfinite(expected)
    assert np.isfinite(curve.values).tolist() == given.tolist()
    assert np.diff(curve.values[given]) == pytest.approx(np.diff(expected[given]), rel=1e-3)
    found = best(swept, curve)
    assert (found.value, found.at_edge, found.at_gap) == (
        best_at,
        first == best_at,
        first != best_at,
    )
    row = tree(answer(swept, [curve], [found]))["best"][0]
    assert (row["at_edge"], row["at_gap"]) == (found.at_edge, found.at_gap)
    said = best_sentence(swept, curve, found)
    assert ("end of the range" in said) == (first == best_at)
    assert ("Beside it nothing could be computed." in said) == (first != best_at)
    highest = best(swept, curve, greatest=True)
    assert (highest.value, highest.at_edge, highest.at_gap) == (last, True, False)
