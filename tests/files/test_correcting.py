"""`crankstar correct`: two planes from a balancing machine or from trial runs."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from tests.commands import Run

RUNS = """run, trial [g*mm], at [deg], bearing 1 [mm/s], phase 1, bearing 2 [mm/s], phase 2 [deg]
initial, , , 5.2, 40, 3.1, 210
plane 1, 400, 0, 4.1, 75, 3.6, 205
plane 2, 400, 90, 5.5, 52, 1.9, 240
check, , , 0.4, 100, 0.3, 20
"""
SHOWN = ("--unbalance", "850 g*mm at 20 deg, 400 g*mm at 110 deg")
PLANES = ("--measuring-planes", "0 mm, 400 mm", "--correction-planes", "60 mm, 340 mm")
Refused = Callable[..., str]


def polar(size: float, degrees: float) -> complex:
    """A vector."""
    return complex(size * np.exp(1j * np.radians(degrees)))


def test_the_corrections_of_trial_runs_bring_the_vibration_to_nought(
    run: Run, tmp_path: Path
) -> None:
    (tmp_path / "runs.csv").write_text(RUNS, encoding="utf-8")
    said = json.loads(run("correct", "runs.csv", "--positions", "12", "--json").out)
    matrix = np.array([[complex(*each) for each in row] for row in said["influence"]])
    added = np.zeros(2, complex)
    for row in said["added"]:
        assert row["at_deg"] % 30 == 0
        added[row["plane"] - 1] += polar(row["unbalance"], row["at_deg"])
    initial = np.array([polar(5.2, 40), polar(3.1, 210)])
    assert initial + matrix @ added == pytest.approx(0, abs=1e-9)
    first = initial + matrix @ np.array([400e-6, 0])
    assert first == pytest.approx([polar(4.1, 75), polar(3.6, 205)])
    assert [round(row["share_percent"], 1) for row in said["left"]] == [6.2, 7.6]


def test_unbalance_of_a_machine_is_drilled_in_the_correction_planes(run: Run) -> None:
    hole = ("--diameter", "12.7 mm", "--at-radius", "80 mm")
    said = json.loads(run("correct", *SHOWN, *PLANES, *hole, "--json").out)
    first, second = polar(850, 20), polar(400, 110)
    planes = [polar(1e6 * row["unbalance"], row["heavy_spot_deg"]) for row in said["planes"]]
    assert sum(planes) == pytest.approx(first + second, abs=2)
    assert 60 * planes[0] + 340 * planes[1] == pytest.approx(400 * second, abs=600)
    assert [row["unbalance"] for row in said["holes"]] == [
        row["unbalance"] for row in said["planes"]
    ]
    alone = json.loads(
        run("drill", "--unbalance", f"{said['planes'][0]['unbalance']} kg*m", *hole, "--json").out
    )
    assert said["holes"][0]["depth"] == pytest.approx(alone["holes"][0]["depth"])


def test_weights_have_masses_where_a_radius_is_given(run: Run) -> None:
    said = json.loads(run("correct", *SHOWN, *PLANES, "--at-radius", "50 mm", "--json").out)
    for row in said["added"]:
        assert row["mass"] * 1e-3 * 0.05 == pytest.approx(row["unbalance"])


def test_a_picture_has_the_heavy_spots_and_what_is_added(run: Run, tmp_path: Path) -> None:
    run("correct", *SHOWN, *PLANES, "-o", "planes.svg")
    drawn = (tmp_path / "planes.svg").read_text(encoding="utf-8")
    assert drawn.count("heavy spot") == drawn.count("add<") == 2
    assert "plane 2" in drawn


@pytest.mark.parametrize(
    ("line", "told"),
    [
        ((), "give either a list of runs"),
        (("runs.csv", *SHOWN), "give either a list of runs"),
        ((*SHOWN, "--measuring-planes", "0 mm, 1 mm"), "--correction-planes"),
        ((*SHOWN, *PLANES[:2], "--correction-planes", "1 mm, 1 mm"), "at one place"),
        ((*SHOWN, *PLANES[:2], "--correction-planes", "1, 2"), "with a unit"),
        (("--unbalance", "850 g*mm, 3 g*mm", *PLANES), "each with its direction"),
        ((*SHOWN, *PLANES, "--positions", "2"), "from 3 to 360"),
        ((*SHOWN, *PLANES, "--positions", "0, 10, 20 deg"), "half a turn apart"),
        (("none.csv",), "no such file"),
    ],
)
def test_a_request_that_cannot_be_met_is_one_sentence(
    refused: Refused, tmp_path: Path, line: tuple[str, ...], told: str
) -> None:
    (tmp_path / "runs.csv").write_text(RUNS, encoding="utf-8")
    assert told in " ".join(refused("correct", *line).split())


@pytest.mark.parametrize(
    ("old", "new", "told"),
    [
        ("plane 2, 400, 90", "plane 1, 400, 90", 'line 4, column "run": this run stands twice'),
        ("plane 2, 400, 90", "third, 400, 90", "name the runs initial, plane 1"),
        ("plane 2, 400, 90, 5.5, 52, 1.9, 240\n", "", 'has no run "plane 2"'),
        ("plane 1, 400", "plane 1, 0", "must be greater than 0"),
        ("5.2, 40", "fast, 40", '"fast" is no number'),
        ("[g*mm]", "[g]", "a mass without the radius"),
        ("phase 2 [deg]", "angle 2 [deg]", "is not known"),
    ],
)
def test_a_mistake_in_the_runs_is_told_with_its_place(
    refused: Refused, tmp_path: Path, old: str, new: str, told: str
) -> None:
    (tmp_path / "runs.csv").write_text(RUNS.replace(old, new), encoding="utf-8")
    said = " ".join(refused("correct", "runs.csv").split())
    assert told in said or (told.startswith("a mass") and "line 3" in said), said
