"""The page on the KR250 has the numbers of claims.json for each layout, factor and crank angle."""

from __future__ import annotations

import re
from math import pi
from pathlib import Path

import numpy as np
import pytest
from tests.claims import CLAIMS
from tests.scripts import script

DOCS = Path(__file__).parents[2] / "docs"
KR250 = CLAIMS["kr250"]
NAMES = {
    ("contra", 180): "kr250-racer",
    ("contra", 0): "kr250-racer-simultaneous",
    ("same", 180): "kr250-production",
}


page = script("kr250_page")


@pytest.mark.many(first=2)
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


@pytest.mark.release
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


gears = script("gears_page")


def test_crankshafts_that_fire_together_pass_on_half_the_mean_torque() -> None:
    """Of both cylinders, 9 bar times the swept volume of one over 2 pi, at any speed."""
    half = 9e5 * pi / 4 * 0.054**2 * 0.0544 / (2 * pi)
    for rpm in (None, 12_000):
        mesh = gears.mesh("kr250-racer-simultaneous", 0.5, rpm=rpm)
        assert np.abs(mesh.torque - half).max() < 1e-6 * half
        assert mesh.force == pytest.approx(half / 0.045)
    shown = re.search(r"together they carry (\d+) N", gears.page("kr250"))
    assert shown
    assert float(shown[1]) == pytest.approx(half / 0.045, rel=2e-3)


def test_the_gears_are_worn_by_firing_in_turn_if_the_flywheels_are_on_the_crankshafts() -> None:
    """The essay is right where they are, and not where all is with the load."""
    for rpm in (None, 12_000):
        apart, together = (
            gears.mesh(name, 0.5, rpm=rpm) for name in ("kr250-racer", "kr250-racer-simultaneous")
        )
        assert apart.force > 4 * together.force
        assert apart.work > 1.5 * together.work
        assert len(apart.reversals) >= 2
        assert together.reversals == ()
        alike = [
            np.abs(np.fft.rfft(gears.mesh(name, 0.0, rpm=rpm).torque))
            for name in ("kr250-racer", "kr250-racer-simultaneous")
        ]
        assert alike[0] == pytest.approx(alike[1], abs=1e-9 * alike[0].max())


@pytest.mark.parametrize(("rpm", "ratio"), [(1500, 3.2), (12_000, 2.0)])
def test_firing_together_needs_more_flywheel_most_of_all_at_low_speed(
    rpm: int, ratio: float
) -> None:
    """The fluctuation of energy by running sums of torque, as on a turning-moment diagram."""
    sums: list[float] = []
    for name in ("kr250-racer", "kr250-racer-simultaneous"):
        torque = gears.whole_torque(gears.complete(name), 9e5, rpm)
        areas = np.cumsum(torque - torque.mean()) * 2 * pi / torque.size
        sums.append(float(areas.max() - areas.min()))
        assert gears.fluctuation(name, 9e5, rpm).energy == pytest.approx(sums[-1], rel=1e-4)
    assert sums[1] / sums[0] == pytest.approx(ratio, abs=0.05)
    assert f"| {rpm} rpm |" in gears.page("low speed")
    assert f"| {ratio:.1f} |" in gears.page("low speed")
