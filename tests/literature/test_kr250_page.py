"""The page on the KR250 has the numbers of claims.json for each layout, factor and crank angle."""

from __future__ import annotations

import importlib.util
import re
import sys
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest
from tests.claims import CLAIMS

DOCS = Path(__file__).parents[2] / "docs"
KR250 = CLAIMS["kr250"]
NAMES = {
    ("contra", 180): "kr250-racer",
    ("contra", 0): "kr250-racer-simultaneous",
    ("same", 180): "kr250-production",
}


def script() -> ModuleType:
    spec = importlib.util.spec_from_file_location("docs_kr250_page", DOCS / "kr250_page.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules["docs_kr250_page"] = module
    spec.loader.exec_module(module)
    return module


page = script()


@pytest.mark.parametrize(
    "row", KR250["rows"], ids=lambda row: f"{row['rotation']}-{row['phase_deg']}-{row['factor']}"
)
def test_forces_and_couples_are_those_of_the_claims(row: dict[str, object]) -> None:
    layout = page.Layout("", NAMES[row["rotation"], row["phase_deg"]], row["factor"])  # pyright: ignore[reportArgumentType]
    found = page.forces(layout.engine, essay=True)
    for place, angle in enumerate(("0", "90", "180")):
        assert found[place].real == pytest.approx(row["up"][angle], abs=1e-12)  # pyright: ignore[reportIndexIssue]
        assert abs(found[place].imag) == pytest.approx(row["right_magnitude"][angle], abs=1e-12)  # pyright: ignore[reportIndexIssue]
    wanted = row.get("couple_about_middle_PL")
    if wanted is not None:
        assert abs(page.couple(layout.engine, middle=True)) == pytest.approx(wanted["0"], abs=1e-12)  # pyright: ignore[reportIndexIssue]


def test_every_row_of_the_claims_is_on_the_page_and_the_parallel_twin() -> None:
    shown = {(layout.name, layout.factor) for layout in page.LAYOUTS}
    assert shown == {
        (NAMES[row["rotation"], row["phase_deg"]], row["factor"]) for row in KR250["rows"]
    } | {("parallel-twin-180", 0.5)}


def test_the_couple_of_the_essay_is_that_about_one_cylinder() -> None:
    racer = page.LAYOUTS[1].engine
    assert abs(page.couple(racer, middle=False)) == pytest.approx(0.25)
    assert abs(page.couple(racer, middle=True)) == pytest.approx(0.5)


def test_exact_forces_are_near_those_of_the_essay_and_not_the_same() -> None:
    for layout in page.LAYOUTS:
        essay, exact = (page.forces(layout.engine, essay=which) for which in (True, False))
        assert np.abs(essay - exact).max() < 0.02
        assert np.abs(essay - exact).max() > 0.01


def test_the_factors_on_the_page_are_those_of_the_arrangements() -> None:
    rows = [
        re.split(r" \| ", row.strip("| "))
        for row in page.page("factors").splitlines()
        if row.startswith("| r") or "| p" in row[:4]
    ]
    found = {row[0]: (row[2], row[4]) for row in rows}
    assert found["racer, counter-rotating, 180°"] == ("0", "1")
    assert found["racer, counter-rotating, simultaneous"] == ("1", "any")
    assert found["production, same sense, 180°"] == ("any", "1")
    assert found["parallel twin, one shaft, 180°"] == ("any", "0.5")


def test_words_for_a_force_say_where_it_points() -> None:
    assert page._vector(complex(-0.5, 1.0)) == "0.5 P down and 1 P sideways (1.12 P in total)"
    assert page._vector(0j) == "0"
